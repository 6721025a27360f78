#include "contact/PatchFrames.hpp"

#include "grid/NodeIdentities.hpp"

#include <algorithm>

namespace Rhegma::contact
{

namespace
{

/// Numbers of a row: patch, identity of the node, area, axes.
template <int D>
constexpr int rowWidth = 2 + D + D* D;

template <int D>
void appendRow(int patch, const typename NodeIdentities<D>::Identity& identity, const PatchFrame<D>& frame,
               std::vector<double>& rows)
{
  rows.push_back(patch);
  rows.insert(rows.end(), identity.begin(), identity.end());
  rows.push_back(frame.area);
  for (const auto& axis : frame.axes)
    rows.insert(rows.end(), axis, axis + D);
}

} // namespace

template <int D>
void addFramesOfRanks(const State<D>& state, const std::vector<FaceNode<D>>& nodes, PatchFrames<D>& frames)
{
  if (!state.mesh.subdomain)
    return;
  const NodeIdentities<D> identities(state.mesh.grid, state.mesh.tree.finePosition);
  std::vector<int> indexOf(identities.size(), -1); // in `nodes`, of a primary field
  for (std::size_t i = 0; i < nodes.size(); ++i)
    indexOf[latticeNode(state.mesh.nodes, nodes[i].plus)] = static_cast<int>(i);
  std::vector<double> rows;
  for (std::size_t m = 0; m < frames.size(); ++m)
    for (const auto& [i, frame] : frames[m])
      appendRow<D>(static_cast<int>(m), identities.of(latticeNode(state.mesh.nodes, nodes[i].plus)), frame,
                   rows);
  rows = state.ranks.gatherOnAll(rows);
  frames.assign(frames.size(), {});
  for (const double* row = rows.data(); row != rows.data() + rows.size(); row += rowWidth<D>)
  {
    typename NodeIdentities<D>::Identity identity;
    std::transform(row + 1, row + 1 + D, identity.begin(), [](double n) { return static_cast<int>(n); });
    const int node = identities.find(identity);
    if (node < 0 || indexOf[node] < 0 || !nodes[indexOf[node]].isDouble)
      continue; // of another window
    PatchFrame<D> frame;
    frame.area = row[1 + D];
    for (int c = 0; c < D; ++c)
      std::copy_n(row + 2 + D + D * c, D, frame.axes[c]);
    frames[static_cast<int>(row[0])][indexOf[node]].add(frame);
  }
}

template void addFramesOfRanks(const State<2>&, const std::vector<FaceNode<2>>&, PatchFrames<2>&);
template void addFramesOfRanks(const State<3>&, const std::vector<FaceNode<3>>&, PatchFrames<3>&);

} // namespace Rhegma::contact
