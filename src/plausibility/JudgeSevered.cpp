#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/Judges.hpp"
#include "plausibility/Pieces.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

namespace Rhegma
{

namespace
{

/// Bodies of which particles lie next to a crack.
template <int D>
std::vector<char> crackedOnes(const State<D>& state)
{
  const auto body = onHost(state.particles.integer(fields::body));
  const auto side = onHost(state.particles.integer(fields::side));
  std::vector<char> cracked(state.bodies.info.size(), 0);
  for (int p = 0; p < state.particles.size(); ++p)
    if (side(p) != 0)
      cracked[body(p)] = 1;
  return cracked;
}

/// Names of the cracks whose two sides belong to different pieces: "Cracks > A, B".
template <int D>
std::string cuttersOf(const State<D>& state, const Grains<D>& grains, const Pieces<D>& pieces)
{
  std::map<int, std::set<int>> piecesOf; // by side
  for (std::size_t p = 0; p < grains.side.size(); ++p)
    if (grains.side[p] != 0)
      piecesOf[grains.side[p]].insert(pieces.of(p));
  std::string names;
  for (const auto& [side, touching] : piecesOf)
    if (side > 0 && piecesOf.count(-side) > 0 && piecesOf.at(-side) != touching)
      names += (names.empty() ? "Cracks > " : ", ") + state.cracks.cracks[side - 1].name;
  return names;
}

} // namespace

template <int D>
Messages judgeSevered(const JudgedScene<D>& judged)
{
  const State<D>& state = judged.state;
  // Faces that touch hold pieces together.
  if (!state.method.mechanics || state.method.equilibrium() || state.cracks.empty() ||
      state.cracks.contactEnergy || !state.particles.has(fields::side))
    return {};
  Messages messages;
  const std::vector<BoundaryRegion> supports = supportRegions(judged.scene);
  const std::vector<Grains<D>> grains = grainsOf(state, crackedOnes(state), true);
  for (std::size_t b = 0; b < grains.size(); ++b)
  {
    if (grains[b].position.empty())
      continue;
    const BodyInfo<D>& body = state.bodies.info[b];
    const Pieces<D> pieces(grains[b], body, 1);
    const std::string cracks = cuttersOf(state, grains[b], pieces);
    if (pieces.all().size() < 2 || cracks.empty() ||
        !anyUnsupported(supports, pieces.all(), state.mesh.grid.spacing))
      continue;
    const Piece<D>& smallest = pieces.smallest();
    messages.push_back(cracks + ": at the start the body is cut in " + std::to_string(pieces.all().size()) +
                       " pieces by it (Bodies > " + judged.bodies[b].name + "), the smallest of " +
                       formatShort(smallest.mass) + " kg of " + formatShort(judged.bodies[b].mass) +
                       " kg, such as at " + formatPoint(smallest.at) +
                       "; no support holds one of them, so it moves freely and without strain: end the "
                       "crack inside the body, hold each piece (Velocity, Symmetry), or add Contact if its "
                       "faces press on each other");
  }
  return messages;
}

template Messages judgeSevered(const JudgedScene<2>&);
template Messages judgeSevered(const JudgedScene<3>&);

} // namespace Rhegma
