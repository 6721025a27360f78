#include "cracks/CrackReport.hpp"

#include "base/ShortNumber.hpp"
#include "cracks/Opening.hpp"
#include "cracks/Overlap.hpp"
#include "transfer/FaceRotation.hpp"

#include <algorithm>
#include <cmath>
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

} // namespace

template <int D>
void addCrackColumns(State<D>& state, const std::vector<Opening>& openings, bool grows)
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
    const Opening& opening = openings[c];
    const std::string& name = state.cracks.cracks[c].name;
    state.sample.row.emplace_back(name + ".opening", opening.largest);
    if constexpr (D == 3)
      state.sample.row.emplace_back(name + ".area", opening.size);
  }
}

namespace
{

/// Warns of closed faces that have turned further than this [rad]: contact compares their positions in the
/// cells, where they have not turned.
constexpr double turnedFar = 0.1;

template <int D>
std::string warningOfTurnedContact(const State<D>& state)
{
  double largest = 0.0;
  for (const Rotation<D>& rotation : rotationsOfFaces(state.cracks))
    largest = std::max(largest, rotation.angle());
  if (!(largest > turnedFar))
    return {};
  const double degrees = largest * 45.0 / std::atan(1.0);
  return "Contact: the faces of cracks have turned by up to " + formatShort(degrees) +
         " degrees, and with Domain > Formulation = Total Lagrangian contact acts as if they had not; write "
         "Updated Lagrangian";
}

} // namespace

template <int D>
void reportCracks(const State<D>& state, const std::vector<OverlapRecord>& overlaps, bool grows,
                  bool touching, bool startsInEquilibrium, nlohmann::json& summary)
{
  for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
  {
    nlohmann::json& entry = summary["cracks"][c];
    entry["name"] = state.cracks.cracks[c].name;
    if (!entry.contains("fronts"))
      entry["fronts"] = nlohmann::json::array();
    const int crack = static_cast<int>(c);
    const Opening opening = measureOpening(state.cracks, crack);
    const OverlapRecord past = c < overlaps.size() ? overlaps[c] : OverlapRecord();
    std::string warning = touching ? "" : warningOfOverlap(state, crack, startsInEquilibrium);
    if (warning.empty() && !touching)
      warning = warningOfRecord(state, crack, past, adviceAgainstOverlap(state, crack, startsInEquilibrium));
    entry["faces_overlap"] = !warning.empty();
    entry["largest_overlap"] = past.ever.overlap;
    entry["time_of_largest_overlap"] = past.ever.time;
    if (!warning.empty())
      summary["warnings"].push_back(warning);
    entry["opening"] = opening.largest;
    entry[D == 2 ? "opening_area" : "opening_volume"] = opening.volume;
    entry[D == 2 ? "length" : "area"] = opening.size;
  }
  if (const std::string warning = touching ? warningOfTurnedContact(state) : std::string(); !warning.empty())
    summary["warnings"].push_back(warning);
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
    if (D == 3 && grows)
    {
      entry["largest_advance"] = front.extension.largest;
      entry["mean_advance"] = front.extension.mean;
      entry["new_area"] = front.extension.area;
    }
  }
}

template void addCrackColumns(State<2>&, const std::vector<Opening>&, bool);
template void addCrackColumns(State<3>&, const std::vector<Opening>&, bool);
template void reportCracks(const State<2>&, const std::vector<OverlapRecord>&, bool, bool, bool,
                           nlohmann::json&);
template void reportCracks(const State<3>&, const std::vector<OverlapRecord>&, bool, bool, bool,
                           nlohmann::json&);

} // namespace Rhegma::cracks
