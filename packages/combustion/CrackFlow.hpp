#pragma once
/// Where the cells of a flow along a crack are.

#include "combustion/Channel.hpp"
#include "transfer/FacePoints.hpp"

namespace Rhegma::combustion
{

/// The channel between the faces of one crack in 2D: a cell at each of its face points, in their order along
/// the crack. All ranks have all of it and do the same.
template <int D>
class CrackFlow
{
public:
  CrackFlow() = default;
  CrackFlow(const GasLaw& law, const WallFriction& friction, double thickness)
      : channel_(law, friction, thickness), thickness_(thickness)
  {
  }

  /// Updates the cells from the crack. \param cavity volume in addition to that between the faces, spread
  /// evenly over the crack of the start [m3] \param gap roughness of the faces [m] \param density of the
  /// solid [kg/m3]
  void updateCells(const FacePoints<D>& points, int crack, double cavity, double gap, double density);

  Channel& channel() { return channel_; }
  const Channel& channel() const { return channel_; }
  int first() const { return first_; } ///< face point of its first cell

  void serialize(Archive& archive);

private:
  double arcAt(const FacePoints<D>& points, const Vector<D>& point) const;

  Channel channel_;
  double thickness_ = 1.0;
  int first_ = 0;
  std::vector<double> length_; ///< of the cells [m]
  Vector<D> begin_{}, end_{};  ///< middles of the first and the last cell [m]
};

} // namespace Rhegma::combustion
