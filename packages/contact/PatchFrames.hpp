#pragma once
/// Areas of patches of face points at the nodes around them.

#include "contact/FaceNodes.hpp"

#include <map>
#include <vector>

namespace Rhegma::contact
{

/// Sums over the points of a patch, each times its area and the weight of a node there [m2].
template <int D>
struct PatchFrame
{
  double area = 0.0;
  double axes[D][D] = {}; ///< of the normal and the tangents

  /// Adds a part of a point. \param part of its area [m2] \param axesThere its normal and tangents
  void add(double part, const Vector<D> (&axesThere)[D])
  {
    area += part;
    for (int c = 0; c < D; ++c)
      for (int d = 0; d < D; ++d)
        axes[c][d] += part * axesThere[c][d];
  }

  /// Adds another frame.
  void add(const PatchFrame& other)
  {
    area += other.area;
    for (int c = 0; c < D; ++c)
      for (int d = 0; d < D; ++d)
        axes[c][d] += other.axes[c][d];
  }
};

/// Of each patch: the frames by the index of a node with two fields.
template <int D>
using PatchFrames = std::vector<std::map<int, PatchFrame<D>>>;

/// Adds the frames that other ranks have found of the nodes of this rank's window: a point has its stencils
/// on the rank that owns its position. All ranks then have the same numbers at nodes that they share. Does
/// nothing on one rank. Collective. \param nodes with two fields \param frames of this rank's points
template <int D>
void addFramesOfRanks(const State<D>& state, const std::vector<FaceNode<D>>& nodes, PatchFrames<D>& frames);

} // namespace Rhegma::contact
