#include "cracks/CrackReport.hpp"

#include "base/Numbers.hpp"
#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "cracks/AvailableLength.hpp"
#include "cracks/Opening.hpp"
#include "cracks/Overlap.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

/// An event of a front in its entry of the summary.
template <int D>
nlohmann::json entryOf(const FrontEvent<D>& event)
{
  nlohmann::json entry = {{"what", event.what},
                          {"time", event.time},
                          {"position", std::vector<double>(event.position.c, event.position.c + D)}};
  if (event.toughness > 0.0)
  {
    entry["G"] = event.release;
    entry["G_known"] = !event.lost;
    entry["toughness"] = event.toughness;
  }
  return entry;
}

/// The first stop of a front, and which of its nodes are stopped now.
template <int D>
nlohmann::json entryOfStop(const CrackFront<D>& front)
{
  nlohmann::json entry = entryOf(front.stop);
  entry["nodes"] = front.numStopped();
  entry["of_nodes"] = front.nodes.size();
  entry["node_positions"] = nlohmann::json::array();
  for (const FrontNode<D>& node : front.nodes)
    if (node.stopped && !node.landed)
      entry["node_positions"].push_back(std::vector<double>(node.position.c, node.position.c + D));
  return entry;
}

/// Fewest cells of material ahead of a front: fewer neither bend nor strain as the material does.
constexpr double fewestAhead = 3.0;

/// Where the material ahead of a front is shortest.
template <int D>
struct ShortestAhead
{
  double length = 0.0, cell = 0.0; ///< 0: nowhere less than `fewestAhead` cells [m]
  Vector<D> at{};
};

/// Ahead of the front nodes that have not reached a surface; in 3D not of those at a surface, along which
/// they point. Collective.
template <int D>
ShortestAhead<D> shortestAhead(const State<D>& state, const CrackFront<D>& front)
{
  std::vector<Path<D>> paths;
  for (std::size_t k = 0; k < front.nodes.size() && !front.ended; ++k)
  {
    const FrontNode<D>& node = front.nodes[k];
    const FrontNode<D>& last = front.nodes[k > 0 ? k - 1 : front.nodes.size() - 1];
    if (node.landed || (D == 3 && (node.facet < 0 || last.facet < 0)))
      continue;
    const double cell = spacingAt(state, node.position);
    Path<D> path{node.position, node.direction, (fewestAhead - leastLigament) * cell, cell};
    if constexpr (D == 2)
      path.gap = std::max(leastLigament * cell, measureOpening(state.cracks, front.crack).largest);
    paths.push_back(path);
  }
  ShortestAhead<D> shortest;
  if (paths.empty())
    return shortest;
  const std::vector<Ligament> ligaments = ligamentsAhead(state, paths);
  for (std::size_t k = 0; k < paths.size(); ++k)
    if (ligaments[k].ends && (shortest.cell == 0.0 || ligaments[k].length < shortest.length))
      shortest = {ligaments[k].length, paths[k].cell, paths[k].from};
  return shortest;
}

/// Warns of a front that has grown and does not run at the end, with less material ahead of it than cells
/// resolve.
/// Collective.
template <int D>
void reportLigament(const State<D>& state, const CrackFront<D>& front, nlohmann::json& entry,
                    nlohmann::json& summary)
{
  entry["ligament"] = nullptr;
  if (!(front.extension.largest > 0.0) || front.ended || state.clock.step == 0)
    return;
  const ShortestAhead<D> ahead = shortestAhead(state, front);
  if (!(ahead.cell > 0.0))
    return;
  entry["ligament"] = ahead.length;
  if (front.speed() > 0.0)
    return;
  summary["warnings"].push_back(frontName(state.cracks, front) + ": only " + readableLength(ahead.length) +
                                " of material are left ahead of it, at " + formatPoint(ahead.at) + ", " +
                                formatShort(ahead.length / ahead.cell) + " cells of " +
                                readableLength(ahead.cell) +
                                "; fewer than three cells neither bend nor strain as the material does, so "
                                "G, and whether the crack stops "
                                "there, can be wrong: use smaller cells (Domain > Cell Size)");
}

} // namespace

template <int D>
void addCrackColumns(State<D>& state, bool grows)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size() && grows; ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    state.sample.row.emplace_back(
        state.cracks.cracks[front.crack].name + "." + std::to_string(front.number) + ".stopped",
        front.numStopped() > 0 ? double(front.numStopped()) / double(front.nodes.size()) : 0.0);
  }
  for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
  {
    const Opening opening = measureOpening(state.cracks, static_cast<int>(c));
    const std::string& name = state.cracks.cracks[c].name;
    state.sample.row.emplace_back(name + ".opening", opening.largest);
    if constexpr (D == 3)
      state.sample.row.emplace_back(name + ".area", opening.size);
  }
}

template <int D>
void reportCracks(const State<D>& state, bool grows, bool touching, bool startsInEquilibrium,
                  nlohmann::json& summary)
{
  for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
  {
    nlohmann::json& entry = summary["cracks"][c];
    entry["name"] = state.cracks.cracks[c].name;
    if (!entry.contains("fronts"))
      entry["fronts"] = nlohmann::json::array();
    const Opening opening = measureOpening(state.cracks, static_cast<int>(c));
    const std::string warning =
        touching ? "" : warningOfOverlap(state, static_cast<int>(c), startsInEquilibrium);
    if (!warning.empty())
      summary["warnings"].push_back(warning);
    entry["opening"] = opening.largest;
    entry[D == 2 ? "opening_area" : "opening_volume"] = opening.volume;
    entry[D == 2 ? "length" : "area"] = opening.size;
  }
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
    entry["position"] = std::vector<double>(front.position.c, front.position.c + D);
    entry["length"] = front.length;
    entry["speed"] = front.speed();
    if (front.numStopped() > 0)
      entry["stop"] = entryOfStop(front);
    if (front.arrival.happened())
      entry["arrival"] = entryOf(front.arrival);
    else if (grows && state.clock.step == 0) // what may be there later is known from the start
      entry["arrival"] = {
          {"what", nullptr}, {"time", nullptr}, {"position", std::vector<nlohmann::json>(D, nullptr)}};
    if (grows)
      reportLigament(state, front, entry, summary);
    if (D == 3 && grows)
    {
      entry["largest_advance"] = front.extension.largest;
      entry["mean_advance"] = front.extension.mean;
      entry["new_area"] = front.extension.area;
    }
  }
}

template void addCrackColumns(State<2>&, bool);
template void addCrackColumns(State<3>&, bool);
template void reportCracks(const State<2>&, bool, bool, bool, nlohmann::json&);
template void reportCracks(const State<3>&, bool, bool, bool, nlohmann::json&);

} // namespace Rhegma::cracks
