#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/CrackBounds.hpp"
#include "plausibility/Judges.hpp"
#include "plausibility/Pieces.hpp"

#include <set>

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

/// Names of cracks: "Cracks > A, B".
template <int D>
std::string namesOf(const std::set<int>& cracks, const State<D>& state)
{
  std::string names;
  for (const int crack : cracks)
    names += (names.empty() ? "Cracks > " : ", ") + state.cracks.cracks[crack].name;
  return names;
}

} // namespace

template <int D>
Messages judgeSevered(const JudgedScene<D>& judged)
{
  const State<D>& state = judged.state;
  // Faces that touch hold pieces together; gas and pressure part them on purpose.
  if (judged.driven || !state.method.mechanics || state.method.equilibrium() || state.cracks.empty() ||
      state.cracks.contactEnergy || state.cracks.simplex.extent(0) == 0)
    return {};
  Messages messages;
  const CrackWalls<D> walls(state);
  const std::vector<BoundaryRegion> supports = supportRegions(judged.scene);
  const std::vector<Grains<D>> grains = grainsOf(state, crackedOnes(judged.bodies, state));
  for (std::size_t b = 0; b < grains.size(); ++b)
  {
    if (grains[b].position.empty())
      continue;
    const BodyInfo<D>& body = state.bodies.info[b];
    const Pieces<D> pieces(grains[b], body, 1, &walls);
    const std::set<int> cutters = pieces.cutters();
    if (cutters.empty() || !anyUnsupported(supports, pieces.all(), state.mesh.grid.spacing))
      continue;
    const Piece<D>& smallest = pieces.smallest();
    messages.push_back(namesOf(cutters, state) + ": at the start Bodies > " + judged.bodies[b].name +
                       " is cut in " + std::to_string(pieces.all().size()) + " pieces, the smallest of " +
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
