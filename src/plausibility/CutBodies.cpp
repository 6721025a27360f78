#include "plausibility/CutBodies.hpp"

#include "base/FacetEnds.hpp"
#include "plausibility/CrackBounds.hpp"

#include <utility>

namespace Rhegma
{

namespace
{

/// Bodies whose bounds those of a crack meet.
template <int D>
std::vector<char> crackedOnes(const std::vector<BodyMeasure<D>>& bodies, const State<D>& state)
{
  std::vector<Geometry::Bounds<D>> bounds;
  for (const BodyMeasure<D>& body : bodies)
    bounds.push_back({body.lower, body.upper});
  const Geometry::NearBoxes<D> boxes(bounds);
  const auto vertex = onHost(state.cracks.vertex);
  std::vector<char> cracked(bodies.size(), 0);
  for (const Crack<D>& crack : state.cracks.cracks)
    for (const int body : boxes.near(boundsOfCrack(crack, vertex), 0.0))
      cracked[body] = 1;
  return cracked;
}

/// Whether some crack meets a surface: without that none cuts a piece off, unless cracks cross each other.
template <int D>
bool anyMeetsSurface(const State<D>& state)
{
  const auto neighbour = onHost(state.cracks.neighbour);
  for (std::size_t s = 0; s < neighbour.extent(0); ++s)
    for (int i = 0; i < D; ++i)
      if (neighbour(s, i) == facet::surfaceBreaking || neighbour(s, i) == facet::joined)
        return true;
  return false;
}

} // namespace

template <int D>
std::vector<CutBody<D>> cutBodies(const std::vector<BodyMeasure<D>>& bodies, const State<D>& state)
{
  std::vector<CutBody<D>> cut;
  if (state.cracks.empty() || !anyMeetsSurface(state))
    return cut;
  const CrackWalls<D> walls(state);
  const std::vector<Grains<D>> grains = grainsOf(state, crackedOnes(bodies, state));
  for (std::size_t b = 0; b < grains.size(); ++b)
  {
    if (grains[b].position.empty())
      continue;
    Pieces<D> pieces(grains[b], state.bodies.info[b], 1, &walls);
    if (pieces.gaveUp())
      continue;
    if (std::set<int> cutters = pieces.cutters(); !cutters.empty())
      cut.push_back({b, std::move(pieces), std::move(cutters)});
  }
  return cut;
}

template <int D>
std::string pathsOfCracks(const std::set<int>& cracks, const State<D>& state)
{
  std::string names;
  for (const int crack : cracks)
    names += (names.empty() ? "Cracks > " : ", ") + state.cracks.cracks[crack].name;
  return names;
}

template std::vector<CutBody<2>> cutBodies(const std::vector<BodyMeasure<2>>&, const State<2>&);
template std::vector<CutBody<3>> cutBodies(const std::vector<BodyMeasure<3>>&, const State<3>&);
template std::string pathsOfCracks(const std::set<int>&, const State<2>&);
template std::string pathsOfCracks(const std::set<int>&, const State<3>&);

} // namespace Rhegma
