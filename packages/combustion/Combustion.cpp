#include "combustion/Combustion.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "combustion/BurnStep.hpp"
#include "combustion/GasReport.hpp"
#include "combustion/GasStep.hpp"
#include "combustion/JudgeBurning.hpp"
#include "combustion/Passages.hpp"
#include "plan/LastStage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace Rhegma::combustion
{

namespace
{

template <int D>
void warnOfRunaway(State<D>& state, const std::string& name, const Teuchos::ParameterList& list)
{
  if (list.get<std::string>("Burn Law") == "Vieille" && list.get<double>("Burn Exponent") > 1.0 &&
      !list.get<bool>("Venting"))
    state.warnings.push_back(
        "Combustion > " + name +
        ": without venting, burning with an exponent above 1 raises the pressure without "
        "bound in a finite time");
}

/// The longest step in which gas and volume of no crack change by more than largestChange [s].
template <int D>
double timeStepLimit(const BurnState<D>& burn)
{
  double limit = std::numeric_limits<double>::max();
  for (const Burning<D>& b : burn.cracks)
  {
    if (b.massRate > 0.0)
      limit = std::min(limit, largestChange * b.gas.mass() / b.massRate);
    if (b.volumeRate != 0.0)
      limit = std::min(limit, largestChange * b.volume / std::fabs(b.volumeRate));
  }
  return limit;
}

template <int D>
void serialize(BurnState<D>& burn, Archive& archive)
{
  archive("start_mass", burn.startMass);
  storeMeetings(burn.meetings, archive);
  for (Burning<D>& b : burn.cracks)
  {
    const Archive::Group group(archive, std::to_string(b.crack));
    b.serialize(archive);
  }
  {
    const Archive::Group group(archive, "points");
    burn.points.serialize(archive);
  }
  burn.fire.serialize(archive);
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene, const RunOptions& options)
{
  const auto burn = std::make_shared<BurnState<D>>();
  Effect<D> effect;
  effect.name = "Combustion";
  effect.balance = {"combustion"};
  effect.needs = {fields::side};
  effect.adds = {{burntOverLeft, 1, "", "mass of a particle lost to gas over its remaining mass"}};
  effect.atStart = [burn, all = Teuchos::ParameterList(scene), options](State<D>& state)
  {
    const Teuchos::ParameterList& list = all.sublist("Combustion");
    for (const std::string& name : sublistNames(list))
    {
      burn->cracks.push_back(readBurning(state, all, options, name));
      warnOfRunaway(state, name, list.sublist(name));
    }
    burn->startMass = massOfParticles(state);
  };
  effect.judge = [burn, all = Teuchos::ParameterList(scene)](State<D>& state)
  {
    const double end = all.sublist("Time").get<double>("Final Time");
    for (const Burning<D>& b : burn->cracks)
      judgeBurning(state, b, all.sublist("Combustion").sublist(state.cracks.cracks[b.crack].name), end,
                   state.warnings);
  };
  effect.call(Stage::BeforeSolve, "push of gas", {quantity::nodalMass, quantity::crackGeometry}, {},
              {quantity::nodalForce, quantity::facePressure},
              [burn](State<D>& s)
              {
                burn->update(s);
                updateMeetings(s, *burn);
                for (Burning<D>& b : burn->cracks)
                  pushByGas(s, *burn, b);
              });
  effect.call(stageOfFaceVelocity(scene), "work of gas and burning of crack faces",
              {projectsLast(scene) ? quantity::projection : quantity::particleVelocity}, {}, {},
              [burn](State<D>& s)
              {
                for (Burning<D>& b : burn->cracks)
                  recordGasWork(s, *burn, b);
                for (Burning<D>& b : burn->cracks)
                  burnStep(s, *burn, b);
                letGasesPass(s, *burn);
              });
  effect.call(Stage::Observe, "gas in cracks", {quantity::facePressure}, {}, {},
              [burn](State<D>& s) { sampleGas(s, *burn); });
  effect.timeStepLimit = [burn](const State<D>&) { return timeStepLimit(*burn); };
  effect.memory = [burn](State<D>&, Archive& archive) { serialize(*burn, archive); };
  effect.report = [burn](const State<D>& state, nlohmann::json& summary)
  { reportGas(state, *burn, summary); };
  return effect;
}

} // namespace

EffectEntry combustionEntry()
{
  EffectEntry entry{combustionSection(), checkCombustion, make<2>, make<3>, true};
  entry.declare = [](const Teuchos::ParameterList& list, RunOptions& options)
  {
    options.burning = true;
    for (const std::string& name : sublistNames(list))
      if (list.sublist(name).isType<double>("Ignition Time"))
        options.driving.push_back(
            {"Combustion > " + name + " > Ignition Time",
             "t < " + formatExactly(list.sublist(name).get<double>("Ignition Time")) + " ? 0 : 1"});
  };
  entry.cells.addNeeds = [](const auto&, CellNeeds& needs, auto&) { needs.facesLoaded = true; };
  return entry;
}

} // namespace Rhegma::combustion
