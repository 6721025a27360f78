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
template <int D>
struct Place
{
  Vector<D> at;
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
  bool find(double back, Place<2>& place) const
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

/// For each place the share of its nodes that the faces share. Collective.
template <int D>
std::vector<double> sharesOfFaces(const State<D>& state, int crack, const std::vector<Place<D>>& places)
{
  ObservedPoints<D> points;
  points.onAllRanks = true;
  points.count = static_cast<int>(places.size());
  points.position = View<double* [D]>("rhegma::nearFrontPosition", points.count);
  points.half = View<double* [D]>("rhegma::nearFrontHalf", points.count);
  points.side = View<int*>("rhegma::nearFrontSide", points.count);
  const auto position = Kokkos::create_mirror_view(points.position);
  for (int k = 0; k < points.count; ++k)
    for (int d = 0; d < D; ++d)
      position(k, d) = places[k].at[d];
  Kokkos::deep_copy(points.position, position);
  Kokkos::deep_copy(points.side, crack + 1);
  StencilTable<D> stencils;
  pointStencils(state, points, stencils, true);
  const auto count = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, stencils.count);
  const auto node = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, stencils.node);
  const auto weight = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, stencils.weight);
  const auto nodeSide = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.nodeSide);
  std::vector<double> shared(points.count, 0.0);
  for (int k = 0; k < points.count; ++k)
    for (int e = 0; e < count(k); ++e)
      if (node(k, e) < state.nodes.numLattice && nodeSide(node(k, e)) == 0)
        shared[k] += weight(k, e);
  sumParts(state, shared.data(), points.count);
  return shared;
}

/// int lost p r^-1/2 dr sqrt(2 / pi) over places a piece apart, of which the first is half of one behind the
/// front. \param tipOffset how far ahead of the front the tip lies that the cells have [m]
template <int D>
double intensityOf(const Place<D>* places, const double* shared, int count, double piece, double tipOffset)
{
  // int s^-1/2 ds over a piece of the way back, s the distance from the tip that the cells have.
  const auto weighed = [tipOffset](double from, double to)
  { return 2.0 * (std::sqrt(std::max(to + tipOffset, 0.0)) - std::sqrt(std::max(from + tipOffset, 0.0))); };
  double intensity = count == 0 ? 0.0 : places[0].pressure * weighed(-std::fabs(tipOffset), 0.0);
  for (int k = 0; k < count; ++k)
    intensity += shared[k] * places[k].pressure * weighed(k * piece, (k + 1) * piece);
  return intensity * std::sqrt(2.0 / std::acos(-1.0));
}

/// Whether anything pushes the faces, and nodes are there to feel it.
template <int D>
bool isPushed(const State<D>& state)
{
  return state.cracks.pressure.extent(0) == state.cracks.simplex.extent(0) && state.step > 0;
}

} // namespace

double intensityLostAtFront(const State<2>& state, const CrackFront<2>& front, double tipOffset)
{
  if (!isPushed(state))
    return 0.0;
  const WayBack way(state.cracks, front);
  const double piece = spacingAt(state, front.position) / pieces;
  std::vector<Place<2>> places;
  Place<2> place;
  while (static_cast<int>(places.size()) < cells * pieces && way.find((places.size() + 0.5) * piece, place))
    places.push_back(place);
  const std::vector<double> shared = sharesOfFaces(state, front.crack, places);
  return intensityOf(places.data(), shared.data(), static_cast<int>(places.size()), piece, tipOffset);
}

std::vector<double> intensitiesLostAlongFront(const State<3>& state, const CrackFront<3>& front, double reach)
{
  if (!isPushed(state))
    return {};
  const auto pressure = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.pressure);
  const auto facet = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.frontFacet);
  const double cell = spacingAt(state, front.position), piece = cell / pieces;
  const int each = std::max(1, static_cast<int>(std::min(cells * cell, reach) / piece));
  std::vector<Place<3>> places;
  int triangle = 0;
  for (const FrontStation<3>& station : front.stations)
  {
    if (station.facet >= 0) // the last of an open line is at the end of the piece before
      triangle = facet(station.facet, 0);
    for (int k = 0; k < each; ++k)
      places.push_back({station.position - ((k + 0.5) * piece) * station.direction, pressure(triangle)});
  }
  const std::vector<double> shared = sharesOfFaces(state, front.crack, places);
  std::vector<double> lost;
  for (std::size_t s = 0; s < front.stations.size(); ++s)
    lost.push_back(intensityOf(&places[s * each], &shared[s * each], each, piece, 0.0));
  return lost;
}

} // namespace Rhegma::energy_release
