#include "contact/FaceNodes.hpp"

#include "transfer/ParticleViews.hpp"

#include <cmath>

namespace Rhegma::contact
{

namespace
{

/// Part of the face of a cell by which the areas of a node's fields may differ inside of a body, where boxes
/// of particles do not tile it.
constexpr double unbalanced = 0.05;

} // namespace

template <int D>
std::vector<FaceNode<D>> findFaceNodes(const State<D>& state)
{
  const Nodes<D>& nodes = state.mesh.nodes;
  std::vector<int> fieldOf(nodes.sums.extent(0), -1); // 2 i of the primary, 2 i + 1 of the enriched field
  for (int i = 0; i < nodes.numEnriched; ++i)
  {
    fieldOf[nodes.parent(i)] = 2 * i;
    fieldOf[nodes.numLattice + i] = 2 * i + 1;
  }
  std::vector<Vector<D>> sums(2 * nodes.numEnriched, Vector<D>{});
  const auto volume = state.particles.scalar(fields::volume);
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     for (int p = 0; p < state.particles.size(); ++p)
                       connect.visit(p,
                                     [&](int node, double, const double* slope)
                                     {
                                       if (const int field = fieldOf[node]; field >= 0)
                                         for (int d = 0; d < D; ++d)
                                           sums[field][d] += volume(p) * slope[d];
                                     });
                   });
  std::vector<FaceNode<D>> found(nodes.numEnriched);
  const double whole =
      std::pow(state.mesh.smallestSpacing(), D - 1) * (D == 2 ? state.method.thickness : 1.0);
  for (int i = 0; i < nodes.numEnriched; ++i)
  {
    const bool primaryIsPlus = state.cracks.nodeSide(nodes.parent(i)) > 0;
    const int plus = 2 * i + (primaryIsPlus ? 0 : 1), minus = 2 * i + (primaryIsPlus ? 1 : 0);
    const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
    found[i].plus = primaryIsPlus ? primary : enriched;
    found[i].minus = primaryIsPlus ? enriched : primary;
    found[i].area = 0.5 * (sums[minus] - sums[plus]);
    found[i].isInside = norm(sums[minus] + sums[plus]) <= unbalanced * whole;
  }
  return found;
}

template std::vector<FaceNode<2>> findFaceNodes(const State<2>&);
template std::vector<FaceNode<3>> findFaceNodes(const State<3>&);

} // namespace Rhegma::contact
