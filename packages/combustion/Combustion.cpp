#include "combustion/Combustion.hpp"

#include "checkpoint/Archive.hpp"
#include "combustion/BurnRate.hpp"
#include "combustion/Gas.hpp"
#include "combustion/Regression.hpp"
#include "parallel/Subdomain.hpp"
#include "scene/Numbers.hpp"
#include "scene/ReadList.hpp"
#include "transfer/FacePush.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace Rhegma::combustion
{

namespace
{

/// Share of the gas that may come or go in a step, and of its room.
constexpr double largestChange = 0.1;

/// Of what a face should burn, what the particles must have for it to go on.
constexpr double leastFuel = 0.5;

/// One crack that burns. All ranks have the same gas in it: what their particles and nodes add to it is
/// summed.
template <int D>
struct Burning
{
  int crack = 0;
  BurnRate rate;
  Gas gas;
  double density = 0.0, gap = 0.0, cavity = 0.0;
  double startPressure = 0.0, startTemperature = 0.0, outside = 0.0;
  double ignition = 0.0, flameSpeed = 0.0;
  Vector<D> flameCentre{};
  bool allAtOnce = true;
  double discharge = 0.0; ///< 0: no venting

  bool filled = false, spent = false, felt = false;
  double swept = 0.0;                               ///< volume that the faces have opened [m3]
  double volume = 0.0, pressure = 0.0, slope = 0.0; ///< [m3], [Pa], [Pa/s]
  double burningArea = 0.0, faces = 0.0;            ///< of faces that burn, of all [m2]
  double massRate = 0.0;                            ///< in and out, as it was or may be next [kg/s]
  double volumeRate = 0.0;                          ///< that the faces sweep [m3/s]

  Flame<D> flame(double time) const
  {
    Flame<D> now;
    now.centre = flameCentre;
    const bool lit = time >= ignition && !spent;
    now.everywhere = lit && allAtOnce;
    now.radius = lit ? flameSpeed * (time - ignition) : -1.0;
    return now;
  }

  void keep(Archive& archive)
  {
    gas.keep(archive);
    archive("filled", filled);
    archive("spent", spent);
    archive("felt", felt);
    archive("swept", swept);
    archive("volume", volume);
    archive("pressure", pressure);
    archive("slope", slope);
    archive("burning_area", burningArea);
    archive("mass_rate", massRate);
    archive("volume_rate", volumeRate);
  }
};

template <int D>
struct Work
{
  std::vector<Burning<D>> cracks;
  FacePoints<D> points;
  Regression<D> regression;
  double startMass = 0.0; ///< of the particles [kg]
};

/// Of all ranks [kg]. Collective.
template <int D>
double massOfParticles(const State<D>& state)
{
  const auto mass = state.particles.scalar(fields::mass);
  double sum = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::massOfParticles", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& all) { all += mass(p); }, sum);
  sumParts(state, &sum, 1);
  return sum;
}

template <int D>
Burning<D> read(const State<D>& state, const std::string& name, const Teuchos::ParameterList& list)
{
  Burning<D> b;
  b.crack = findCrack(state.cracks, name);
  b.rate = list.get<std::string>("Burn Law") == "Table"
               ? BurnRate::table(list.get<std::string>("Burn Table"))
               : BurnRate::vieille(list.get<double>("Burn Coefficient"), list.get<double>("Burn Exponent"));
  GasLaw law;
  law.constant = list.get<double>("Gas Constant");
  law.heatRatio = list.get<double>("Heat Capacity Ratio");
  law.covolume = list.get<double>("Covolume");
  law.flameTemperature = list.get<double>("Flame Temperature");
  law.constantTemperature = list.get<std::string>("Gas Temperature") == "Constant";
  b.gas = Gas(law);
  b.density = list.isParameter("Solid Density") ? list.get<double>("Solid Density")
                                                : state.materialList.front().density;
  b.gap = list.get<double>("Initial Gap");
  b.cavity = list.get<double>("Cavity Volume");
  b.outside = list.get<double>("Outside Pressure");
  b.startPressure = list.isParameter("Initial Pressure") ? list.get<double>("Initial Pressure") : b.outside;
  b.startTemperature =
      law.constantTemperature ? law.flameTemperature : list.get<double>("Initial Temperature");
  b.ignition = list.get<double>("Ignition Time");
  if (list.isParameter("Flame Speed"))
  {
    b.allAtOnce = false;
    b.flameSpeed = list.get<double>("Flame Speed");
    b.flameCentre = readVector<D>(list, "Ignition Point");
  }
  if (list.get<bool>("Venting"))
  {
    b.discharge = list.get<double>("Discharge Coefficient");
    if (!hasMouth(state.cracks, b.crack))
      throw std::invalid_argument("Combustion > " + name +
                                  " > Venting: the crack does not reach the surface of its body, so nothing "
                                  "flows out; write false");
  }
  return b;
}

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

/// Pressure of the gas, and its force on the faces.
template <int D>
void push(State<D>& state, const FacePoints<D>& points, Burning<D>& b)
{
  const Cavity room = measureCavity(state, points, b.crack, b.flame(state.time));
  const std::string& name = state.cracks.cracks[b.crack].name;
  b.burningArea = room.burning;
  b.faces = 2.0 * room.felt;
  b.felt = b.felt || room.felt > 0.0;
  if (!b.felt)
    state.trouble = "Combustion > " + name + ": no face of this crack lies in a body, so nothing can burn";
  b.volume = b.cavity + b.gap * room.area + b.swept + b.gas.burnt() / b.density;
  const double before = b.pressure;
  if (!b.filled)
    b.gas.fill(b.startPressure, b.startTemperature, b.volume);
  if (!(b.volume > b.gas.leastVolume()))
    state.trouble = "Combustion > " + name +
                    ": there is no room left for the gas, as the faces have come too near to each other "
                    "(a larger Initial Gap or Cavity Volume, or a section Contact)";
  b.pressure = b.gas.pressure(b.volume);
  if (!std::isfinite(b.pressure))
    state.trouble = "Combustion > " + name + ": the pressure is no longer a number";
  if (!state.trouble.empty())
    return;
  b.slope = b.filled && state.dt > 0.0 ? (b.pressure - before) / state.dt : 0.0;
  b.filled = true;
  publishPressure("rhegma::combustion::publish", state.cracks, b.crack, b.pressure - b.outside);
  pushFaces("rhegma::combustion::push", state, points, b.crack, b.pressure - b.outside);
}

/// What the gas did on the faces; the atmosphere takes the part that it presses against. The room between the
/// faces is what they swept, so that the work is the pressure times the change of the volume.
template <int D>
void bookWork(State<D>& state, const FacePoints<D>& points, Burning<D>& b)
{
  double swept = workOnFaces("rhegma::combustion::work", state, points, b.crack,
                             1.0);                             // a pressure of 1 Pa: the volume [m3]
  state.energy.combustion += (b.pressure - b.outside) * swept; // each rank books its own part
  sumParts(state, &swept, 1);
  b.gas.work(b.pressure * swept);
  b.swept += swept;
  b.volumeRate = state.dt > 0.0 ? swept / state.dt : 0.0;
  if (!(b.gas.energy() > 0.0))
    state.trouble = "Combustion > " + state.cracks.cracks[b.crack].name +
                    ": the gas has done more work than it has energy (smaller Time > CFL)";
}

template <int D>
void burn(State<D>& state, Work<D>& work, Burning<D>& b)
{
  const double gasBefore = b.gas.mass();
  if (b.burningArea > 0.0)
  {
    const double middle = std::max(b.pressure + 0.5 * state.dt * b.slope, 0.0);
    // A first step, or a flame that comes upon many faces, was not foreseen by the limit of the step.
    const double most = 2.0 * largestChange * b.gas.mass() / b.burningArea;
    const double depth = std::min(b.density * b.rate(middle) * state.dt, most);
    work.regression.take(state, work.points, b.crack, b.flame(state.time), depth);
    const auto lost = work.regression.apply(state);
    state.energy.combustion -= lost.energy;
    double mass = lost.mass;
    sumParts(state, &mass, 1);
    b.gas.burn(mass);
    if (mass < leastFuel * depth * b.burningArea)
    {
      b.spent = true;
      state.warnings.push_back("Combustion > " + state.cracks.cracks[b.crack].name +
                               ": the solid beside the faces had burnt away at time " +
                               formatReal(state.time + state.dt) + " s");
    }
  }
  const double come = b.gas.mass() - gasBefore;
  double gone = 0.0;
  if (b.discharge > 0.0)
  {
    gone = state.dt * b.gas.outflow(b.discharge * mouthArea(state, b.crack), b.volume, b.outside);
    gone = std::min(gone, 0.5 * b.gas.mass());
    b.gas.vent(gone, b.volume);
  }
  b.gas.settle();
  const double last = state.dt > 0.0 ? (come + gone) / state.dt : 0.0;
  // All faces may catch fire in the next step.
  const bool lit = !b.spent && state.time + 3.0 * state.dt >= b.ignition;
  const double most = lit ? b.density * b.rate(b.pressure) * (b.allAtOnce ? b.faces : b.burningArea) : 0.0;
  b.massRate = std::max(last, most);
}

template <int D>
void report(const State<D>& state, const Work<D>& work, nlohmann::json& summary)
{
  double solid = massOfParticles(state), total = work.startMass, now = solid;
  for (const Burning<D>& b : work.cracks)
  {
    const Gas& gas = b.gas;
    nlohmann::json& entry = summary["cracks"][b.crack];
    entry["pressure"] = b.pressure;
    entry["burnt_mass"] = gas.burnt();
    const double given =
        gas.startEnergy() + gas.burnt() * gas.law().heatCapacity() * gas.law().flameTemperature;
    const double taken = gas.workDone() + gas.ventedEnergy() + gas.wallHeat();
    entry["gas"] = {{"mass", gas.mass()},
                    {"vented_mass", gas.vented()},
                    {"temperature", gas.temperature()},
                    {"volume", b.volume},
                    {"energy", gas.energy()},
                    {"work", gas.workDone()},
                    {"vented_energy", gas.ventedEnergy()},
                    {"wall_heat", gas.wallHeat()},
                    {"burning_area", b.burningArea},
                    {"energy_kept", given > 0.0 ? (gas.energy() + taken) / given : 1.0}};
    total += gas.startMass();
    now += gas.mass() + gas.vented();
  }
  summary["combustion"] = {{"solid_mass", solid}, {"mass_kept", now / total}};
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList list = scene.sublist("Combustion");
  const auto work = std::make_shared<Work<D>>();
  Effect<D> effect;
  effect.name = "Combustion";
  effect.needs = {fields::side};
  effect.adds = {{burntShare, 1, "", "share of its mass that a particle has lost to gas"}};
  effect.atStart = [work, list](State<D>& state)
  {
    for (const std::string& name : sublistNames(list))
    {
      work->cracks.push_back(read(state, name, list.sublist(name)));
      warnOfRunaway(state, name, list.sublist(name));
    }
    work->startMass = massOfParticles(state);
  };
  effect.call({Stage::BeforeSolve,
               "push of gas",
               {"nodal mass"},
               {},
               {"nodal force"},
               [work](State<D>& s)
               {
                 work->points.update(s);
                 for (Burning<D>& b : work->cracks)
                   push(s, work->points, b);
               }});
  effect.call({Stage::AfterSolve,
               "work of gas",
               {"constrained motion"},
               {},
               {},
               [work](State<D>& s)
               {
                 for (Burning<D>& b : work->cracks)
                   bookWork(s, work->points, b);
               }});
  effect.call({Stage::Gather,
               "burning of crack faces",
               {"particle velocity"},
               {},
               {},
               [work](State<D>& s)
               {
                 for (Burning<D>& b : work->cracks)
                   burn(s, *work, b);
               }});
  effect.call({Stage::Observe,
               "gas in cracks",
               {"energies"},
               {},
               {},
               [work](State<D>& s)
               {
                 for (const Burning<D>& b : work->cracks)
                 {
                   const std::string& name = s.cracks.cracks[b.crack].name;
                   s.row.emplace_back(name + ".pressure", b.pressure);
                   s.row.emplace_back(name + ".burnt_mass", b.gas.burnt());
                   s.row.emplace_back(name + ".gas_temperature", b.gas.temperature());
                 }
               }});
  effect.timeStepLimit = [work](const State<D>&)
  {
    double limit = std::numeric_limits<double>::max();
    for (const Burning<D>& b : work->cracks)
    {
      if (b.massRate > 0.0)
        limit = std::min(limit, largestChange * b.gas.mass() / b.massRate);
      if (b.volumeRate != 0.0)
        limit = std::min(limit, largestChange * b.volume / std::fabs(b.volumeRate));
    }
    return limit;
  };
  effect.memory = [work](State<D>&, Archive& archive)
  {
    archive("start_mass", work->startMass);
    for (Burning<D>& b : work->cracks)
    {
      const Archive::Group group(archive, std::to_string(b.crack));
      b.keep(archive);
    }
    const Archive::Group group(archive, "points");
    work->points.keep(archive);
  };
  effect.report = [work](const State<D>& state, nlohmann::json& summary) { report(state, *work, summary); };
  return effect;
}

} // namespace

EffectEntry combustionEntry() { return {combustionSection(), checkCombustion, make<2>, make<3>, true}; }

} // namespace Rhegma::combustion
