#include "archive/Archive.hpp"
#include "cracks/Chains.hpp"
#include "cracks/CrackFrames.hpp"
#include "cracks/Growth.hpp"

#include <string>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

template <int D>
void keepFronts(CrackSet<D>& set, Archive& archive)
{
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
  {
    CrackFront<D>& front = set.fronts[f];
    const Archive::Group group(archive, "front " + std::to_string(f));
    archive("vertex", front.vertex);
    archive("direction", front.direction); // those of a front that has ended are found no more
    archive("normal", front.normal);
    if constexpr (D == 2) // those of 3D are kept with their surface
    {
      FrontNode<D>& node = front.nodes[0];
      archive("speed", node.speed);
      archive("temperature", node.temperature);
      archive("release", node.driving.release);
      archive("K_I", node.driving.modeI);
      archive("K_II", node.driving.modeII);
      archive("K_III", node.driving.modeIII);
      archive("hoop_angle", node.driving.hoopAngle);
      archive("advances", node.advances);
      archive("stopped", node.stopped);
    }
    archive("grown", front.grown);
    archive("ended", front.ended);
    archive("required", front.budget.required);
    archive("pending", front.budget.pending);
    archive("released", front.budget.released);
    archive("carried_over", front.budget.carriedOver);
    archive("over_dissipated", front.budget.overDissipated);
    archive("advected", front.budget.advected);
    archive("toughness", front.budget.toughness);
  }
}

/// What a chain's end is as one number: a mouth 0, a front 1, joined to another crack 2.
int codeOf(const Chain& chain, int end) { return chain.front[end] ? 1 : chain.joined[end] ? 2 : 0; }

/// Saves or loads how many vertices each crack has and what its ends are.
void keepChains(State<2>& state, Archive& archive)
{
  std::vector<int> sizes;
  if (!archive.loads())
    for (const Chain& chain : readChains(state.cracks))
      sizes.insert(sizes.end(), {static_cast<int>(chain.links.size()), codeOf(chain, 0), codeOf(chain, 1)});
  archive("chains", sizes, 3);
  keepFronts(state.cracks, archive);
  if (!archive.loads())
    return;
  // The places of the vertices are in the views that are loaded next.
  std::vector<int> vertices;
  for (const CrackFront<2>& front : state.cracks.fronts)
    vertices.push_back(front.vertex);
  std::vector<Chain> chains;
  for (std::size_t c = 0; c + 2 < sizes.size(); c += 3)
  {
    Chain chain;
    for (int v = 0; v < sizes[c]; ++v)
      chain.links.push_back(closedLink({{double(v), double(c)}}));
    for (int end = 0; end < 2; ++end)
    {
      chain.front[end] = sizes[c + 1 + end] == 1;
      chain.joined[end] = sizes[c + 1 + end] == 2;
    }
    chains.push_back(chain);
  }
  writeChains(state.cracks, chains, state.mesh.grid.spacing);
  for (std::size_t f = 0; f < vertices.size(); ++f)
    state.cracks.fronts[f].vertex = vertices[f];
}

} // namespace

template <int D>
void keepCracks(State<D>& state, Archive& archive)
{
  if constexpr (D == 2)
    keepChains(state, archive);
  else
    keepFronts(state.cracks, archive);
  archive("vertex", state.cracks.vertex);
  archive("face", state.cracks.face);
  archive("near_front", state.cracks.nearFront);
  if (!archive.loads())
    return;
  updateNormals(state.cracks);
  updateFronts(state.cracks);
}

template void keepCracks(State<2>&, Archive&);
template void keepCracks(State<3>&, Archive&);

} // namespace Rhegma::cracks
