#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/Judges.hpp"
#include "plausibility/NodesAround.hpp"
#include "plausibility/Pieces.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace Rhegma
{

namespace
{

/// Whether particles of two pieces reach one node of the lattice.
template <int D>
bool haveCommonNodes(const Grid<D>& grid, const Grains<D>& grains, const Pieces<D>& pieces)
{
  std::unordered_map<int, int> owner;
  bool common = false;
  for (std::size_t p = 0; p < grains.position.size() && !common; ++p)
  {
    const double edge = *std::max_element(grains.box[p].c, grains.box[p].c + D);
    forEachNode(grid, grains.position[p], reachOfParticle(grid, edge),
                [&](int node, const Vector<D>&)
                { common = common || owner.emplace(node, pieces.of(p)).first->second != pieces.of(p); });
  }
  return common;
}

} // namespace

template <int D>
Messages judgePieces(const JudgedScene<D>& judged)
{
  Messages messages;
  const Teuchos::ParameterList& section = judged.scene.sublist("Bodies");
  std::vector<char> wanted;
  for (const BodyMeasure<D>& body : judged.bodies)
  {
    const Teuchos::ParameterList& list = section.sublist(body.name);
    wanted.push_back(list.isSublist("Operations") && list.sublist("Operations").numParams() > 0 ? 1 : 0);
  }
  if (std::count(wanted.begin(), wanted.end(), 1) == 0)
    return messages;
  const std::vector<BoundaryRegion> supports = supportRegions(judged.scene);
  const std::vector<Grains<D>> grains = grainsOf(judged.state, wanted);
  const double cell = judged.state.mesh.grid.spacing;
  for (std::size_t b = 0; b < grains.size(); ++b)
  {
    if (grains[b].position.empty())
      continue;
    // Most are one piece by cells that touch; a particle that has joined another reaches over one cell more.
    const BodyInfo<D>& body = judged.state.bodies.info[b];
    if (Pieces<D>(grains[b], body, 1).all().size() < 2)
      continue;
    const Pieces<D> pieces(grains[b], body, 2);
    if (pieces.all().size() < 2)
      continue;
    const Piece<D>& smallest = pieces.smallest();
    const bool unsupported = anyUnsupported(supports, pieces.all(), cell);
    const bool near = haveCommonNodes(judged.state.mesh.grid, grains[b], pieces);
    if (!unsupported && !near)
      continue;
    messages.push_back(
        "Bodies > " + judged.bodies[b].name + " > Operations: they leave " +
        std::to_string(pieces.all().size()) + " pieces that do not touch, the smallest of " +
        formatShort(smallest.mass) + " kg of " + formatShort(judged.bodies[b].mass) + " kg, such as at " +
        formatPoint(smallest.at) +
        (near ? "; pieces less than two cells apart move as one"
              : "; no support holds one of them, so it moves on its own") +
        ": check positions and sizes of the operations (metres), or write a body for each piece");
  }
  return messages;
}

template Messages judgePieces(const JudgedScene<2>&);
template Messages judgePieces(const JudgedScene<3>&);

} // namespace Rhegma
