#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/CutBodies.hpp"
#include "plausibility/Judges.hpp"
#include "state/ContactAdvice.hpp"

#include <algorithm>
#include <set>

namespace Rhegma
{

namespace
{

/// The axis nearest to the mean normal of some cracks, along which pieces part.
template <int D>
char axisAcross(const std::set<int>& cracks, const State<D>& state)
{
  const auto normal = onHost(state.cracks.normal);
  const auto crackOf = onHost(state.cracks.crackOf);
  Vector<D> sizes{};
  for (std::size_t s = 0; s < crackOf.extent(0); ++s)
    for (int d = 0; d < D && cracks.count(crackOf(s)) > 0; ++d)
      sizes[d] += normal(s, d) * normal(s, d);
  return static_cast<char>('x' + (std::max_element(sizes.c, sizes.c + D) - sizes.c));
}

/// Bodies next to one, which hold its pieces as supports do: bodies that touch have one motion.
template <int D>
std::vector<BoundaryRegion> neighboursOf(std::size_t body, const std::vector<BodyMeasure<D>>& bodies,
                                         char axis)
{
  std::vector<BoundaryRegion> regions;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    BoundaryRegion region;
    region.kind = BoundaryRegion::Kind::Held;
    region.axes = std::string(1, axis);
    for (int d = 0; d < D; ++d)
    {
      region.from[d] = bodies[b].lower[d];
      region.to[d] = bodies[b].upper[d];
    }
    if (b != body)
      regions.push_back(region);
  }
  return regions;
}

/// The supports that hold an axis.
std::vector<BoundaryRegion> holding(char axis, std::vector<BoundaryRegion> supports)
{
  supports.erase(std::remove_if(supports.begin(), supports.end(),
                                [axis](const BoundaryRegion& support)
                                { return support.axes.find(axis) == std::string::npos; }),
                 supports.end());
  return supports;
}

} // namespace

template <int D>
Messages judgeSevered(const JudgedScene<D>& judged)
{
  const State<D>& state = judged.state;
  // Faces that touch hold pieces together; gas and pressure part them on purpose.
  if (judged.driven || !state.method.mechanics || state.method.equilibrium() || state.cracks.empty() ||
      state.cracks.contactEnergy)
    return {};
  Messages messages;
  const bool startsInEquilibrium =
      judged.scene.sublist("Time").template get<std::string>("Initial State") == "Equilibrium";
  const std::vector<BoundaryRegion> supports = supportRegions(judged.scene);
  for (const auto& [b, pieces, cutters] : cutBodies(judged.bodies, state))
  {
    const char axis = axisAcross(cutters, state);
    std::vector<BoundaryRegion> holders = holding(axis, supports);
    for (const BoundaryRegion& neighbour : neighboursOf(b, judged.bodies, axis))
      holders.push_back(neighbour);
    if (!anyUnsupported(holders, pieces.all(), state.mesh.grid.spacing))
      continue;
    const Piece<D>& smallest = pieces.smallest();
    messages.push_back(pathsOfCracks(cutters, state) + ": at the start Bodies > " + judged.bodies[b].name +
                       " is cut in " + std::to_string(pieces.all().size()) + " pieces, the smallest of " +
                       formatShort(smallest.mass) + " kg of " + formatShort(judged.bodies[b].mass) +
                       " kg, such as at " + formatPoint(smallest.at) +
                       "; no support holds one of them along " + std::string(1, axis) +
                       ", so it moves freely and is not strained: end the "
                       "crack inside the body, hold each piece (Velocity, Symmetry), or, if its faces press "
                       "on each other, " +
                       contactAdvice(state, true, startsInEquilibrium));
  }
  return messages;
}

template Messages judgeSevered(const JudgedScene<2>&);
template Messages judgeSevered(const JudgedScene<3>&);

} // namespace Rhegma
