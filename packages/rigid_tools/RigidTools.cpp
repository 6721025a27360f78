#include "rigid_tools/RigidTools.hpp"

#include "archive/Archive.hpp"
#include "base/Attempts.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "rigid_tools/ContactParts.hpp"
#include "rigid_tools/Outline.hpp"
#include "rigid_tools/StartOverlap.hpp"
#include "rigid_tools/ToolHeat.hpp"
#include "rigid_tools/ToolRecord.hpp"
#include "rigid_tools/ToolSection.hpp"
#include "transfer/PressedNodes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace Rhegma::rigid_tools
{

namespace
{

/// Most sweeps over tools that touch the same fields.
constexpr int mostSweeps = 1000;

/// Sweeps end when no impulse changes by more than this fraction of the largest one, and no velocity by more
/// than this fraction of the largest change of the first sweep.
constexpr double settledChange = 1e-9;

/// A tool and what it touches.
template <int D>
struct ToolInRun
{
  Tool<D> tool;
  std::vector<char> touches; ///< of each body: not 0 where the tool touches it
  CellsNearTool<D> near;
  ParticleGaps<D> gaps;
  ToolContacts<D> contacts;
  ToolRecord<D> record;
  ToolOutline<D> outline;    ///< where the scene has the tool
  double heatFraction = 0.0; ///< of friction, that heats bodies
};

/// What the calls of the effect have in common.
template <int D>
struct Tools
{
  Teuchos::ParameterList section, bodies; ///< of the scene
  std::vector<ToolInRun<D>> all;
  View<double* [2]> heatOfRows; ///< of heatByFriction
  int unsettled = 0;       ///< steps in which impulses of tools that touch the same fields did not settle
  double lastChange = 0.0; ///< largest change of an impulse in the last sweep of these steps, as a fraction
};

template <int D>
double kineticEnergyOf(const Tools<D>& tools)
{
  double sum = 0.0;
  for (const ToolInRun<D>& one : tools.all)
    sum += one.tool.kineticEnergy();
  return sum;
}

/// Moves the outlines to where the tools are.
template <int D>
void placeOutlines(const Tools<D>& tools, State<D>& state)
{
  state.tools.resize(tools.all.size());
  for (std::size_t k = 0; k < tools.all.size(); ++k)
  {
    ToolOutline<D>& outline = state.tools[k];
    outline.cells = tools.all[k].outline.cells;
    outline.points.clear();
    for (const Vector<D>& point : tools.all[k].outline.points)
      outline.points.push_back(tools.all[k].tool.placement().toSpace(point));
  }
}

template <int D>
void start(Tools<D>& tools, State<D>& state)
{
  Attempts attempts;
  tools.all.clear();
  for (const std::string& name : sublistNames(tools.section))
  {
    tools.all.push_back({Tool<D>(tools.section.sublist(name), name), {}, {}, {}, {}, {}, {}});
    ToolInRun<D>& one = tools.all.back();
    const std::vector<std::string>& named = one.tool.bodies();
    for (const BodyInfo<D>& body : state.bodies.info)
      one.touches.push_back(
          named.empty() || std::find(named.begin(), named.end(), body.name) != named.end() ? 1 : 0);
    one.outline = outlineOf(one.tool.shape());
    const auto* const fraction = valueIf<double>(tools.section.sublist(name), "Friction Heat Fraction");
    if (state.particles.has(fields::temperature))
      one.heatFraction = fraction != nullptr ? *fraction : 1.0;
    attempts.attempt([&] { refuseOverlap(state, one.tool, one.touches, tools.bodies); });
  }
  attempts.throwIfAny();
  state.energy.tools = kineticEnergyOf(tools);
  placeOutlines(tools, state);
}

/// How far a tool is from the cells, by the ball around it; zero where it may reach into them [m].
template <int D>
double distanceFromCells(const Tool<D>& tool, const Grid<D>& grid)
{
  double distance = 0.0;
  for (int d = 0; d < D; ++d)
    distance = std::max({distance, grid.lower[d] - tool.middle()[d] - tool.radius(),
                         tool.middle()[d] - tool.radius() - grid.upper[d]});
  return distance;
}

/// A tool moves by a quarter of a cell in a step at most, and to the cells if it is not there yet.
template <int D>
double stepLimit(const Tools<D>& tools, const State<D>& state)
{
  constexpr double part = 0.25;
  // Steps are no longer than a wave takes through a cell.
  double longest = state.clock.fastestSpeed > 0.0 ? state.mesh.smallestSpacing() / state.clock.fastestSpeed
                                                  : state.clock.finalTime;
  const double most = longest;
  for (const ToolInRun<D>& one : tools.all)
  {
    const double away = distanceFromCells(one.tool, state.mesh.grid);
    longest = std::min(
        longest, one.tool.longestStep(state.clock.time, part * state.mesh.smallestSpacing() + away, most));
  }
  return longest < most ? longest : std::numeric_limits<double>::infinity();
}

template <int D>
void press(Tools<D>& tools, State<D>& state)
{
  int touching = 0;
  for (ToolInRun<D>& one : tools.all)
  {
    state.energy.externalWork += one.tool.beginStep(state.clock.time, state.clock.dt);
    listParticlesNear(state, one.tool, one.near);
    measureGaps(state, one.tool, one.touches, one.near, one.gaps);
    listContacts(state, one.tool, one.gaps, one.contacts);
    touching += one.contacts.count > 0 ? 1 : 0;
  }
  if (touching > 1)
  {
    std::vector<ToolContacts<D>*> contacts;
    for (ToolInRun<D>& one : tools.all)
      if (one.contacts.count > 0)
        contacts.push_back(&one.contacts);
    separateTools(state, contacts);
  }
  for (const ToolInRun<D>& one : tools.all)
    if (one.contacts.count > 0)
      holdContacts(state, one.contacts);
  const int sweeps = touching > 1 ? mostSweeps : std::min(touching, 1);
  double changed = 0.0;
  for (int k = 0; k < sweeps && (k == 0 || changed > settledChange); ++k)
  {
    changed = 0.0;
    for (ToolInRun<D>& one : tools.all)
      changed = std::max(changed, exchangeImpulses(state, one.tool, one.contacts));
  }
  if (touching < 2 || !(changed > settledChange))
    return;
  ++tools.unsettled;
  tools.lastChange = std::max(tools.lastChange, changed);
}

/// Finds the energy of all impulses, then joins the projection in sweeps over the tools that touch something.
template <int D>
void join(const Tools<D>& tools, const State<D>& state)
{
  int touching = 0;
  for (const ToolInRun<D>& one : tools.all)
  {
    countImpulses(state, one.tool, one.contacts);
    touching += one.contacts.count > 0 ? 1 : 0;
  }
  const int sweeps = touching > 1 ? mostSweeps : touching;
  double first = 0.0; // the largest change of the first sweep
  for (int k = 0; k < sweeps; ++k)
  {
    double changed = 0.0;
    for (const ToolInRun<D>& one : tools.all)
      changed = std::max(changed, joinProjection(state, one.tool, one.contacts));
    first = k == 0 ? changed : first;
    if (!(changed > settledChange * first))
      return;
  }
}

template <int D>
void move(Tools<D>& tools, State<D>& state)
{
  join(tools, state);
  for (ToolInRun<D>& one : tools.all)
  {
    const ToolSums<D> sums = sumContacts(one.contacts);
    one.record.add(state, sums);
    const double heat = one.heatFraction > 0.0 ? heatByFriction(state, one.contacts, one.near,
                                                                one.heatFraction, tools.heatOfRows)
                                               : 0.0;
    one.record.addHeat(heat);
    state.energy.contact += sums.dissipated - heat;
    if (!one.tool.hasMass())
      state.energy.externalWork += sums.work;
    state.energy.externalWork += one.tool.endStep(state.clock.dt);
    keepPressedNodes(state, one.tool.name(), one.contacts.count, one.contacts.node, one.contacts.impulse);
  }
  state.energy.tools = kineticEnergyOf(tools);
}

template <int D>
void serialize(Tools<D>& tools, Archive& archive)
{
  for (std::size_t k = 0; k < tools.all.size(); ++k)
  {
    ToolInRun<D>& one = tools.all[k];
    const Archive::Group group(archive, std::to_string(k));
    one.tool.serialize(archive);
    one.record.serialize(archive);
    one.near = CellsNearTool<D>();
  }
  archive("unsettled", tools.unsettled);
  archive("last_change", tools.lastChange);
}

template <int D>
void report(const Tools<D>& tools, nlohmann::json& summary)
{
  nlohmann::json& friction = summary["energy"]["friction"]; // of faces of cracks and of bodies, too
  double all = friction.is_number() ? friction.get<double>() : 0.0;
  summary["rigid_tools"] = nlohmann::json::array();
  for (const ToolInRun<D>& one : tools.all)
  {
    all += one.record.friction();
    summary["rigid_tools"].push_back(one.record.report(one.tool));
    const std::string warning = one.record.warning(one.tool);
    if (!warning.empty())
      summary["warnings"].push_back(warning);
  }
  friction = all;
  if (tools.unsettled > 0)
    summary["warnings"].push_back(
        "Rigid Tools: in " + std::to_string(tools.unsettled) + " step" + (tools.unsettled == 1 ? "" : "s") +
        " the impulses of tools that press on the same nodes still changed by up to " +
        formatShort(100.0 * tools.lastChange) + " % after " + std::to_string(mostSweeps) +
        " sweeps over the tools; use smaller cells, so that each has nodes of its own");
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const auto tools = std::make_shared<Tools<D>>();
  tools->section = scene.sublist("Rigid Tools");
  tools->bodies = scene.sublist("Bodies");
  Effect<D> effect;
  effect.name = "Rigid Tools";
  effect.balance = {"contact", "tools"};
  for (const std::string& name : sublistNames(tools->section))
    effect.addsNodal.push_back(pressedNodesField(name));
  effect.atStart = [tools](State<D>& state) { start(*tools, state); };
  effect.timeStepLimit = [tools](const State<D>& state) { return stepLimit(*tools, state); };
  // Reads what it adds to: after other calls that add, such as that of bodies in contact.
  effect.call(Stage::Solve, "impulses of rigid tools",
              {quantity::nodalMotion, quantity::stencils, ifWritten(quantity::prescribedMotion)}, {},
              {quantity::nodalMotion}, [tools](State<D>& s) { press(*tools, s); });
  effect.call(Stage::AfterProjection, "strain velocity at rigid tools", {quantity::nodalMotion}, {},
              {quantity::projection}, [tools](State<D>& s) { move(*tools, s); });
  effect.call(Stage::Observe, "forces of rigid tools", {quantity::energyBalance}, {}, {},
              [tools](State<D>& s)
              {
                for (ToolInRun<D>& one : tools->all)
                  one.record.sample(s, one.tool);
                placeOutlines(*tools, s);
              });
  effect.memory = [tools](State<D>& s, Archive& archive)
  {
    serialize(*tools, archive);
    placeOutlines(*tools, s);
  };
  effect.report = [tools](const State<D>&, nlohmann::json& summary) { report(*tools, summary); };
  return effect;
}

} // namespace

EffectEntry rigidToolsEntry()
{
  EffectEntry entry{toolSection(), checkTools, make<2>, make<3>, false};
  entry.declare = [](const Teuchos::ParameterList&, RunOptions& options) { options.toolsPress = true; };
  return entry;
}

} // namespace Rhegma::rigid_tools
