#include "energy_release/FacePressureTerm.hpp"

#include "parallel/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Rhegma::energy_release
{

namespace
{

/// Cells behind the front in which faces may share nodes, and pieces into which each is cut.
constexpr int cells = 3, pieces = 16;

/// A place on the crack at a distance behind the front.
struct Place
{
  Vector<2> at;
  double pressure;
};

class WayBack
{
public:
  WayBack(const CrackSet<2>& cracks, const CrackFront<2>& front)
  {
    const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.vertex);
    const auto pressure = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.pressure);
    const Crack<2>& crack = cracks.cracks[front.crack];
    const bool first = front.vertex == crack.firstVertex;
    for (int k = 0; k < crack.numVertices; ++k)
    {
      const int v = first ? crack.firstVertex + k : crack.firstVertex + crack.numVertices - 1 - k;
      vertices_.push_back({vertex(v, 0), vertex(v, 1)});
    }
    for (int k = 0; k < crack.numSimplices; ++k)
      pressures_.push_back(pressure(crack.firstSimplex + (first ? k : crack.numSimplices - 1 - k)));
  }

  /// \param back length of crack from the front [m] \return false beyond the crack's other end
  bool find(double back, Place& place) const
  {
    for (std::size_t s = 0; s + 1 < vertices_.size(); ++s)
    {
      const Vector<2> along = vertices_[s + 1] - vertices_[s];
      const double length = norm(along);
      if (back <= length)
      {
        place = {vertices_[s] + (back / length) * along, pressures_[s]};
        return true;
      }
      back -= length;
    }
    return false;
  }

private:
  std::vector<Vector<2>> vertices_;
  std::vector<double> pressures_;
};

} // namespace

double intensityLostAtFront(const State<2>& state, const CrackFront<2>& front, double tipOffset)
{
  const CrackSet<2>& cracks = state.cracks;
  if (cracks.pressure.extent(0) != cracks.simplex.extent(0) || state.step == 0)
    return 0.0;
  const WayBack way(cracks, front);
  const double piece = spacingAt(state, front.position) / pieces;
  std::vector<Place> places;
  Place place;
  while (static_cast<int>(places.size()) < cells * pieces && way.find((places.size() + 0.5) * piece, place))
    places.push_back(place);

  ObservedPoints<2> points;
  points.onAllRanks = true;
  points.count = static_cast<int>(places.size());
  points.position = View<double* [2]>("rhegma::nearFrontPosition", points.count);
  points.half = View<double* [2]>("rhegma::nearFrontHalf", points.count);
  points.side = View<int*>("rhegma::nearFrontSide", points.count);
  const auto position = Kokkos::create_mirror_view(points.position);
  for (int k = 0; k < points.count; ++k)
    for (int d = 0; d < 2; ++d)
      position(k, d) = places[k].at[d];
  Kokkos::deep_copy(points.position, position);
  Kokkos::deep_copy(points.side, front.crack + 1);
  StencilTable<2> stencils;
  pointStencils(state, points, stencils, true);
  const auto count = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, stencils.count);
  const auto node = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, stencils.node);
  const auto weight = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, stencils.weight);
  const auto nodeSide = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.nodeSide);

  // int s^-1/2 ds over a piece of the way back, s the distance from the tip that the cells have.
  const auto weighed = [tipOffset](double from, double to)
  { return 2.0 * (std::sqrt(std::max(to + tipOffset, 0.0)) - std::sqrt(std::max(from + tipOffset, 0.0))); };
  std::vector<double> shared(points.count, 0.0); // share of each point's nodes that the faces share
  for (int k = 0; k < points.count; ++k)
    for (int e = 0; e < count(k); ++e)
      if (node(k, e) < state.nodes.numLattice && nodeSide(node(k, e)) == 0)
        shared[k] += weight(k, e);
  sumParts(state, shared.data(), points.count);
  double intensity = places.empty() ? 0.0 : places[0].pressure * weighed(-std::fabs(tipOffset), 0.0);
  for (int k = 0; k < points.count; ++k)
    intensity += shared[k] * places[k].pressure * weighed(k * piece, (k + 1) * piece);
  return intensity * std::sqrt(2.0 / std::acos(-1.0));
}

} // namespace Rhegma::energy_release
