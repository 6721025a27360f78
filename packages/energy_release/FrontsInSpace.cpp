#include "energy_release/FrontsInSpace.hpp"

#include "archive/Archive.hpp"
#include "base/Attempts.hpp"
#include "base/Numbers.hpp"
#include "energy_release/DrivingCalls.hpp"
#include "energy_release/FrontDriving.hpp"
#include "energy_release/FrontIntegral.hpp"
#include "energy_release/FrontOpening.hpp"
#include "energy_release/FrontSet.hpp"
#include "energy_release/ReadOptions.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>

namespace Rhegma::energy_release
{

namespace
{

constexpr double notYet = std::numeric_limits<double>::quiet_NaN(); ///< null in the summary

/// A quantity at the front nodes of a front.
using Along = std::vector<double>;

/// The last sample of a front.
struct Sample
{
  CrackFront<3> front;
  FrontLine line;
  FrontTube tube{{0.0, 0.0}, 0.0};
  Along J, modeI, modeII, modeIII;
};

struct Samples
{
  std::vector<Sample> last;
  FrontSet warned; ///< fronts whose tube has left the body during the run
};

/// The names of what is found along a front.
template <class S>
std::vector<std::pair<const char*, decltype(&std::declval<S&>().J)>> quantitiesOf(S& s)
{
  return {{"G_J", &s.J}, {"K_I", &s.modeI}, {"K_II", &s.modeII}, {"K_III", &s.modeIII}};
}

std::string frontName(const State<3>& state, const CrackFront<3>& front)
{
  return state.cracks.cracks[front.crack].name + "." + std::to_string(front.number);
}

/// Its name in messages, such as "crack Notch, front 0".
std::string messageName(const State<3>& state, const CrackFront<3>& front)
{
  return "crack " + state.cracks.cracks[front.crack].name + ", front " + std::to_string(front.number);
}

/// Mean along the front: of the straight lines between front nodes.
double meanOf(const FrontLine& line, const Along& values)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k)
    sum += line.nodes[k].tributaryLength * values[k];
  return line.length > 0.0 ? sum / line.length : 0.0;
}

double least(const Along& values)
{
  return values.empty() ? 0.0 : *std::min_element(values.begin(), values.end());
}
double most(const Along& values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

Sample unmeasured(const State<3>& state, const CrackFront<3>& front, const Options& options)
{
  Sample s;
  s.front = front;
  s.line = lineOf(front);
  if (!s.line.empty())
    s.tube = fittingTube(state, front, s.line, options.radii);
  s.J = s.modeI = s.modeII = s.modeIII = Along(s.line.nodes.size(), notYet);
  return s;
}

void measure(const State<3>& state, Sample& s)
{
  NodalAcceleration<3> acceleration;
  s.J = integrateAlongFront(state, s.front.crack, s.line, s.tube, acceleration);
  const Elasticity e = elasticity(state.materials.list[materialAt(state, s.front.position)]);
  const std::vector<Intensities> openings =
      openingsBehind(state.cracks, s.front, s.line, e, spacingAt(state, s.front.position), s.tube.halfWidth);
  for (std::size_t k = 0; k < s.J.size(); ++k)
  {
    const Intensities K = scaleTo(openings[k], s.J[k], e);
    s.modeI[k] = K.modeI;
    s.modeII[k] = K.modeII;
    s.modeIII[k] = K.modeIII;
  }
}

/// A node may come to lie this share of a cell inside of the tube as the body moves.
constexpr double slack = 1e-6;

/// Refuses an outer radius that the scene gives and for which there is no room.
void checkTube(const State<3>& state, const CrackFront<3>& front, const Options& options)
{
  const FrontLine line = lineOf(front);
  if (options.radii.outer == 0.0 || line.empty())
    return;
  const double room = roomAround(state, front, line, options.radii.outer);
  if (room < options.radii.outer - slack * spacingAt(state, front.position))
    throw std::invalid_argument(
        "Energy Release > Outer Radius: the integration tube of " + formatReal(options.radii.outer) +
        " m around " + messageName(state, front) +
        " leaves the body, reaches another front or crack, or exceeds the radius of curvature of the front; "
        "write at most " +
        formatReal(room) + ", or use smaller cells (Domain > Cell Size)");
}

void checkTubes(const State<3>& state, const Options& options)
{
  if (state.cracks.fronts.empty())
    throw std::invalid_argument(
        "Energy Release: no crack has a front inside a body; end a crack inside material, choose "
        "its front with Cracks > NAME > Front Edges, or remove this section");
  Attempts attempts;
  for (const CrackFront<3>& front : state.cracks.fronts)
    attempts.attempt([&] { checkTube(state, front, options); });
  attempts.complain();
}

/// Says once of each front that its surroundings have become too narrow for its tube.
void warnOfTube(State<3>& state, const Sample& s, const Options& options, Samples& samples)
{
  const double cell = spacingAt(state, s.front.position), outer = s.tube.radii.outer;
  if (samples.warned.count({s.front.crack, s.front.number}) != 0 ||
      (options.radii.outer == 0.0 && outer > smallestOuter(options.radii, cell)) ||
      roomAround(state, s.front, s.line, outer) > outer - cell)
    return;
  samples.warned.insert({s.front.crack, s.front.number});
  state.warnings.push_back("Energy Release: from t = " + readableTime(state.clock.time) +
                           " on, the integration tube around " + messageName(state, s.front) +
                           " leaves the body or reaches another front, so G_J and K are less accurate; use "
                           "smaller cells or radii");
}

void sample(State<3>& state, const Options& options, Samples& samples)
{
  samples.last.clear();
  for (const CrackFront<3>& front : state.cracks.fronts)
  {
    Sample s = unmeasured(state, front, options);
    if (!s.line.empty())
    {
      warnOfTube(state, s, options, samples);
      measure(state, s);
    }
    samples.last.push_back(s);
    const std::string name = frontName(state, front) + ".";
    for (const auto& [quantity, values] : quantitiesOf(s))
    {
      state.sample.row.emplace_back(name + quantity, meanOf(s.line, *values));
      state.sample.row.emplace_back(name + quantity + "_min", least(*values));
      state.sample.row.emplace_back(name + quantity + "_max", most(*values));
    }
    state.sample.row.emplace_back(name + "length", front.length);
    state.sample.row.emplace_back(name + "speed", front.speed());
    state.sample.row.emplace_back(name + "x", front.position[0]);
    state.sample.row.emplace_back(name + "y", front.position[1]);
    state.sample.row.emplace_back(name + "z", front.position[2]);
  }
}

nlohmann::json numbers(const Vector<3>& x) { return {x[0], x[1], x[2]}; }

void report(const State<3>& state, const Samples& samples, nlohmann::json& summary)
{
  for (const Sample& s : samples.last)
  {
    nlohmann::json& crack = summary["cracks"][s.front.crack];
    crack["name"] = state.cracks.cracks[s.front.crack].name;
    nlohmann::json& entry = crack["fronts"][s.front.number];
    nlohmann::json& frontNodes = entry["stations"];
    for (const auto& [quantity, values] : quantitiesOf(s))
    {
      entry[quantity] = meanOf(s.line, *values);
      entry[std::string(quantity) + "_min"] = least(*values);
      entry[std::string(quantity) + "_max"] = most(*values);
      frontNodes[quantity] = *values;
    }
    for (const char* name : {"position", "direction", "normal", "arc_length"})
      frontNodes[name] = nlohmann::json::array();
    for (const FrontNode<3>& frontNode : s.line.nodes)
    {
      frontNodes["position"].push_back(numbers(frontNode.position));
      frontNodes["direction"].push_back(numbers(frontNode.direction));
      frontNodes["normal"].push_back(numbers(frontNode.normal));
    }
    frontNodes["arc_length"] = s.line.arc;
    frontNodes["line"] = s.line.line;
    entry["inner_radius"] = s.tube.radii.inner;
    entry["outer_radius"] = s.tube.radii.outer;
    entry["half_width"] = s.tube.halfWidth;
  }
}

/// Saves or loads the last sample and which fronts were warned of.
void keep(Samples& samples, Archive& archive)
{
  int count = static_cast<int>(samples.last.size());
  archive("fronts", count);
  samples.last.resize(count);
  for (int k = 0; k < count; ++k)
  {
    const Archive::Group group(archive, "front " + std::to_string(k));
    Sample& s = samples.last[k];
    archive("crack", s.front.crack);
    archive("number", s.front.number);
    archive("inner_radius", s.tube.radii.inner);
    archive("outer_radius", s.tube.radii.outer);
    archive("half_width", s.tube.halfWidth);
    archive("length", s.line.length);
    archive("arc", s.line.arc);
    archive("line", s.line.line);
    for (const auto& [quantity, values] : quantitiesOf(s))
      archive(quantity, *values);
    std::vector<double> frames; // share, place, direction and normal of each front node
    for (const FrontNode<3>& frontNode : s.line.nodes)
    {
      frames.push_back(frontNode.tributaryLength);
      for (const Vector<3>* v : {&frontNode.position, &frontNode.direction, &frontNode.normal})
        frames.insert(frames.end(), v->c, v->c + 3);
    }
    archive("frames", frames, 10);
    s.line.nodes.resize(frames.size() / 10);
    for (std::size_t i = 0; i < s.line.nodes.size(); ++i)
    {
      FrontNode<3>& frontNode = s.line.nodes[i];
      const double* frame = &frames[10 * i];
      frontNode.tributaryLength = frame[0];
      for (int d = 0; d < 3; ++d)
      {
        frontNode.position[d] = frame[1 + d];
        frontNode.direction[d] = frame[4 + d];
        frontNode.normal[d] = frame[7 + d];
      }
    }
  }
  keepFronts(samples.warned, "warned", archive);
}

} // namespace

Effect<3> fronts3(const Teuchos::ParameterList& scene, const RunOptions& run)
{
  const Options options = readOptions(scene, run);
  const auto samples = std::make_shared<Samples>();
  const auto driving = std::make_shared<FrontDriving>();
  Effect<3> effect;
  effect.name = "Energy Release";
  effect.atStart = [=](State<3>& state)
  {
    checkTubes(state, options);
    for (const CrackFront<3>& front : state.cracks.fronts)
      samples->last.push_back(unmeasured(state, front, options));
  };
  effect.call({Stage::Observe,
               "energy release of crack fronts",
               {quantity::crackGeometry, quantity::particleStress, quantity::enrichedFields,
                ifWritten(quantity::springForce), ifWritten(quantity::facePressure)},
               {},
               {quantity::energyRelease},
               [=](State<3>& state)
               {
                 if (state.clock.observing)
                   sample(state, options, *samples);
               }});
  if (run.growth)
    addDrivingCalls(effect, scene, driving);
  effect.memory = [=](State<3>&, Archive& archive) { keepBoth(*samples, *driving, archive); };
  effect.report = [=](const State<3>& state, nlohmann::json& summary) { report(state, *samples, summary); };
  return effect;
}

} // namespace Rhegma::energy_release
