#include "combustion/Combustion.hpp"

#include "archive/Archive.hpp"
#include "base/ReadList.hpp"
#include "combustion/BurnStep.hpp"
#include "combustion/GasReport.hpp"
#include "combustion/GasStep.hpp"
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
double timeStepLimit(const Work<D>& work)
{
  double limit = std::numeric_limits<double>::max();
  for (const Burning<D>& b : work.cracks)
  {
    if (b.massRate > 0.0)
      limit = std::min(limit, largestChange * b.gas.mass() / b.massRate);
    if (b.volumeRate != 0.0)
      limit = std::min(limit, largestChange * b.volume / std::fabs(b.volumeRate));
  }
  return limit;
}

template <int D>
void keep(Work<D>& work, Archive& archive)
{
  archive("start_mass", work.startMass);
  keepMeetings(work.meetings, archive);
  for (Burning<D>& b : work.cracks)
  {
    const Archive::Group group(archive, std::to_string(b.crack));
    b.keep(archive);
  }
  {
    const Archive::Group group(archive, "points");
    work.points.keep(archive);
  }
  work.fire.keep(archive);
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene, const RunOptions& options)
{
  const auto work = std::make_shared<Work<D>>();
  Effect<D> effect;
  effect.name = "Combustion";
  effect.balance = {"combustion"};
  effect.needs = {fields::side};
  effect.adds = {{burntOverLeft, 1, "", "mass of a particle lost to gas over its remaining mass"}};
  effect.atStart = [work, all = Teuchos::ParameterList(scene), options](State<D>& state)
  {
    const Teuchos::ParameterList& list = all.sublist("Combustion");
    for (const std::string& name : sublistNames(list))
    {
      work->cracks.push_back(readBurning(state, all, options, name));
      warnOfRunaway(state, name, list.sublist(name));
    }
    work->startMass = massOfParticles(state);
  };
  effect.call({Stage::BeforeSolve,
               "push of gas",
               {quantity::nodalMass, quantity::crackGeometry},
               {},
               {quantity::nodalForce, quantity::facePressure},
               [work](State<D>& s)
               {
                 work->follow(s);
                 updateMeetings(s, *work);
                 for (Burning<D>& b : work->cracks)
                   pushByGas(s, *work, b);
               }});
  effect.call({stageOfFaceVelocity(scene),
               "work of gas and burning of crack faces",
               {projectsLast(scene) ? quantity::projection : quantity::particleVelocity},
               {},
               {},
               [work](State<D>& s)
               {
                 for (Burning<D>& b : work->cracks)
                   recordGasWork(s, *work, b);
                 for (Burning<D>& b : work->cracks)
                   burnStep(s, *work, b);
                 letGasesPass(s, *work);
               }});
  effect.call({Stage::Observe, "gas in cracks", {quantity::facePressure}, {}, {}, [work](State<D>& s) {
                 sampleGas(s, *work);
               }});
  effect.timeStepLimit = [work](const State<D>&) { return timeStepLimit(*work); };
  effect.memory = [work](State<D>&, Archive& archive) { keep(*work, archive); };
  effect.report = [work](const State<D>& state, nlohmann::json& summary)
  { reportGas(state, *work, summary); };
  return effect;
}

} // namespace

EffectEntry combustionEntry() { return {combustionSection(), checkCombustion, make<2>, make<3>, true}; }

} // namespace Rhegma::combustion
