#include "combustion/Combustion.hpp"

#include "checkpoint/Archive.hpp"
#include "combustion/Burning.hpp"
#include "combustion/FaceHeat.hpp"
#include "combustion/FlowSteps.hpp"
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

template <int D>
struct Work
{
  std::vector<Burning<D>> cracks;
  FacePoints<D> points;
  Fire<D> fire;
  Regression<D> regression;
  FaceHeat<D> heat;
  FaceHeating heating;    ///< at each face point
  View<double*> depth;    ///< density times the depth that burns in a step, at each face point [kg/m2]
  View<double*> taken;    ///< heat that the faces take there [J]
  View<double*> pressure; ///< that the faces feel there, where gas flows [Pa]
  View<double*> swept;    ///< volume that opens there in a step, where gas flows [m3]
  double startMass = 0.0; ///< of the particles [kg]

  /// Follows the faces; fields at points get the size that they must have.
  void follow(const State<D>& state)
  {
    const bool anew = points.update(state);
    fire.follow(points, anew);
    const std::size_t count = points.count();
    if (depth.extent(0) == count)
      return;
    for (View<double*>* field :
         {&depth, &taken, &pressure, &swept, &heating.given, &heating.conductance, &heating.gasTemperature})
      *field = View<double*>("rhegma::combustion::atFacePoints", count);
  }
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
void push(State<D>& state, const Work<D>& work, Burning<D>& b)
{
  const FacePoints<D>& points = work.points;
  const Cavity room = measureCavity(state, points, b.crack, work.fire.lit());
  const std::string& name = state.cracks.cracks[b.crack].name;
  b.faces = 2.0 * room.felt;
  b.felt = b.felt || room.felt > 0.0;
  if (!b.felt)
    state.trouble = "Combustion > " + name + ": no face of this crack lies in a body, so nothing can burn";
  if (b.flows)
  {
    if (state.trouble.empty())
      pushByFlow(state, points, b, work.pressure);
    return;
  }
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
void bookWork(State<D>& state, const Work<D>& all, Burning<D>& b)
{
  const FacePoints<D>& points = all.points;
  if (b.flows)
    return bookFlow(state, points, b, all.pressure, all.swept);
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

/// The highest temperature of the faces of a crack [K].
template <int D>
double hottest(const FacePoints<D>& points, int crack, const View<double* [2]>& temperature)
{
  const View<int*> of = points.crack;
  double highest = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::hottest", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k, double& most) {
        for (int side = 0; side < 2 && of(k) == crack; ++side)
          most = temperature(k, side) > most ? temperature(k, side) : most;
      },
      Kokkos::Max<double>(highest));
  return highest;
}

/// What each face is to lose in this step, and how the gas warms it. \param most that may burn [kg/m2]
template <int D>
void prepareFaces(const State<D>& state, const Work<D>& work, const Burning<D>& b, double most)
{
  if (b.flows)
    return prepareFlow(state, work.points, b, work.fire.lit(), most, work.depth, work.heating);
  const double middle = std::max(b.pressure + 0.5 * state.dt * b.slope, 0.0);
  const double depth = std::min(b.density * b.rate(middle) * state.dt, most);
  const FacePoints<D> p = work.points;
  const View<int*> lit = work.fire.lit();
  const View<double*> depths = work.depth;
  const FaceHeating heating = work.heating;
  const int crack = b.crack;
  const bool burns = !b.spent;
  // Gas that is left alone with its walls comes to their temperature as exp(-h A t / (m c_v)).
  const double capacity = b.gas.mass() * b.gas.law().heatCapacity();
  const double exchange = state.dt * b.transfer * b.faces / capacity;
  const double conductance = exchange > 0.0 ? -std::expm1(-exchange) * capacity / b.faces : 0.0;
  const double temperature = b.gas.temperature();
  Kokkos::parallel_for(
      "rhegma::combustion::prepareFaces", Kokkos::RangePolicy<ExecSpace>(0, p.count()),
      KOKKOS_LAMBDA(const int k) {
        if (p.crack(k) != crack)
          return;
        depths(k) = burns && lit(k) != 0 ? depth : 0.0;
        heating.given(k) = 0.0;
        heating.conductance(k) = conductance;
        heating.gasTemperature(k) = temperature;
      });
}

/// Mass that the faces of a crack are to lose in this step [kg].
template <int D>
double massAsked(const State<D>& state, const Work<D>& work, int crack)
{
  const FacePoints<D> p = work.points;
  const View<double*> depths = work.depth;
  const double thickness = state.thickness;
  double mass = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::massAsked", Kokkos::RangePolicy<ExecSpace>(0, p.count()),
      KOKKOS_LAMBDA(const int k, double& sum) {
        if (p.crack(k) == crack && p.acts(k) != 0)
          sum += 2.0 * depths(k) * p.currentSize(k) * thickness;
      },
      mass);
  return mass;
}

/// Gives the faces their share of the heat of the mass that has burnt there, and what passes by the
/// difference of temperatures. \param share of what was asked for that has burnt
template <int D>
void heatFaces(State<D>& state, Work<D>& work, Burning<D>& b, double share)
{
  const FacePoints<D> p = work.points;
  const View<double*> depths = work.depth, given = work.heating.given, taken = work.taken;
  const double heat = b.wallFraction * share * b.gas.law().heatCapacity() * b.gas.law().flameTemperature;
  const int crack = b.crack;
  Kokkos::parallel_for(
      "rhegma::combustion::givenHeat", Kokkos::RangePolicy<ExecSpace>(0, p.count()),
      KOKKOS_LAMBDA(const int k) {
        if (p.crack(k) == crack)
          given(k) = depths(k) * heat;
      });
  work.heat.give(state, p, crack, work.heating, taken);
  double all = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::heatTaken", Kokkos::RangePolicy<ExecSpace>(0, p.count()),
      KOKKOS_LAMBDA(const int k, double& sum) { sum += taken(k); }, all);
  b.gas.heatWalls(all);
}

/// The solid beside the faces turns into gas, gas heats the faces and flows out.
template <int D>
void burn(State<D>& state, Work<D>& work, Burning<D>& b)
{
  const double gasBefore = b.gas.mass();
  const bool heated = b.looksAtFaces();
  if (heated)
    work.heat.measure(state, work.points);
  if (heated)
    b.hottestFace = hottest(work.points, b.crack, work.heat.temperature());
  work.fire.spread(state, work.points, b.crack, b.ignition, work.heat.temperature());
  const Cavity room = measureCavity(state, work.points, b.crack, work.fire.lit());
  b.burningArea = b.spent ? 0.0 : room.burning;
  // A first step, or a flame that comes upon many faces, was not foreseen by the limit of the step.
  const double most = 2.0 * largestChange * b.gas.mass() / std::max(b.burningArea, 1e-300);
  prepareFaces(state, work, b, most);
  const double asked = b.burningArea > 0.0 ? massAsked(state, work, b.crack) : 0.0;
  double mass = 0.0, solidHeat = 0.0;
  if (b.burningArea > 0.0)
  {
    mass = work.regression.take(state, work.points, b.crack, work.depth);
    sumParts(state, &mass, 1);
  }
  if (b.heatsFaces())
    heatFaces(state, work, b, asked > 0.0 ? mass / asked : 0.0);
  if (b.burningArea > 0.0)
  {
    const auto lost = work.regression.apply(state, b.solidTemperature);
    state.energy.combustion -= lost.energy;
    double gained[] = {lost.mass, lost.heat};
    sumParts(state, gained, 2);
    b.gas.burn(gained[0], gained[1]);
    mass = gained[0];
    solidHeat = gained[1];
    if (mass < leastFuel * asked)
    {
      b.spent = true;
      state.warnings.push_back("Combustion > " + state.cracks.cracks[b.crack].name +
                               ": the solid beside the faces had burnt away at time " +
                               formatReal(state.time + state.dt) + " s");
    }
  }
  const double come = b.gas.mass() - gasBefore;
  double gone = 0.0;
  if (b.flows)
  {
    gone = -b.gas.vented();
    moveFlow(state, work.points, b, work.depth, mass, solidHeat, work.taken);
    gone += b.gas.vented();
  }
  else if (b.discharge > 0.0)
  {
    gone = state.dt * b.gas.outflow(b.discharge * mouthArea(state, b.crack, b.mirrors), b.volume, b.outside);
    gone = std::min(gone, 0.5 * b.gas.mass());
    b.gas.vent(gone, b.volume);
  }
  b.gas.settle();
  const double last = state.dt > 0.0 ? (come + gone) / state.dt : 0.0;
  // All faces may catch fire in the next step.
  const bool lit = !b.spent && state.time + 3.0 * state.dt >= b.ignition.time;
  const double next =
      lit ? b.density * b.rate(b.pressure) * (b.ignition.everywhere ? b.faces : b.burningArea) : 0.0;
  b.massRate = std::max(last, next);
}

/// Of each cell, from the first end of the crack to its last [Pa].
std::vector<double> pressuresAlong(const Channel& channel)
{
  std::vector<double> all;
  for (int k = 0; k < channel.size(); ++k)
    all.push_back(channel.pressure(k));
  return all;
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
    const double released = gas.burnt() * gas.law().heatCapacity() * gas.law().flameTemperature;
    const double given = gas.startEnergy() + released + gas.solidHeat();
    // What flows has its mass and energy in its cells: that they are the books' is no matter of course.
    const double mass = b.flows ? b.flow.channel().allMass() : gas.mass();
    const double energy = b.flows ? b.flow.channel().allEnergy() : gas.energy();
    const double taken = gas.workDone() + gas.ventedEnergy() + gas.wallHeat();
    entry["gas"] = {{"mass", mass},
                    {"vented_mass", gas.vented()},
                    {"temperature", gas.temperature()},
                    {"volume", b.volume},
                    {"energy", energy},
                    {"work", gas.workDone()},
                    {"vented_energy", gas.ventedEnergy()},
                    {"released", released},
                    {"wall_heat", gas.wallHeat()},
                    {"solid_heat", gas.solidHeat()},
                    {"burning_area", b.burningArea},
                    {"energy_kept", given > 0.0 ? (energy + taken) / given : 1.0}};
    if (b.flows)
      entry["gas"]["pressures"] = pressuresAlong(b.flow.channel());
    if (b.looksAtFaces())
      entry["gas"]["hottest_face"] = b.hottestFace;
    total += gas.startMass();
    now += mass + gas.vented();
  }
  summary["combustion"] = {{"solid_mass", solid}, {"mass_kept", now / total}};
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const auto work = std::make_shared<Work<D>>();
  Effect<D> effect;
  effect.name = "Combustion";
  effect.needs = {fields::side};
  effect.adds = {{burntShare, 1, "", "share of its mass that a particle has lost to gas"}};
  effect.atStart = [work, all = Teuchos::ParameterList(scene)](State<D>& state)
  {
    const Teuchos::ParameterList& list = all.sublist("Combustion");
    for (const std::string& name : sublistNames(list))
    {
      work->cracks.push_back(readBurning(state, all, name));
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
                 work->follow(s);
                 for (Burning<D>& b : work->cracks)
                   push(s, *work, b);
               }});
  effect.call({Stage::AfterSolve,
               "work of gas",
               {"constrained motion"},
               {},
               {},
               [work](State<D>& s)
               {
                 for (Burning<D>& b : work->cracks)
                   bookWork(s, *work, b);
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
                   if (b.flows)
                   {
                     const std::vector<double> along = pressuresAlong(b.flow.channel());
                     const auto ends = std::minmax_element(along.begin(), along.end());
                     s.row.emplace_back(name + ".pressure_lowest", along.empty() ? 0.0 : *ends.first);
                     s.row.emplace_back(name + ".pressure_highest", along.empty() ? 0.0 : *ends.second);
                   }
                   if (b.looksAtFaces())
                     s.row.emplace_back(name + ".face_temperature", b.hottestFace);
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
    {
      const Archive::Group group(archive, "points");
      work->points.keep(archive);
    }
    work->fire.keep(archive);
  };
  effect.report = [work](const State<D>& state, nlohmann::json& summary) { report(state, *work, summary); };
  return effect;
}

} // namespace

EffectEntry combustionEntry() { return {combustionSection(), checkCombustion, make<2>, make<3>, true}; }

} // namespace Rhegma::combustion
