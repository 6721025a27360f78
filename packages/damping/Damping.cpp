#include "damping/Damping.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "damping/JudgeDamping.hpp"
#include "damping/Settling.hpp"
#include "scene/RoundBodies.hpp"
#include "transfer/LaneHeat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace Rhegma::damping
{

template <int D>
double addViscousStress(State<D>& state, double shearViscosity, double bulkViscosity)
{
  const auto rate = state.particles.table(fields::rate);
  const auto stress = state.particles.template real<symmetricSize<D>>(fields::stress);
  const auto volume = state.particles.scalar(fields::volume);
  const double dt = state.clock.strainPass.fraction * state.clock.dt;
  double loss = 0.0;
  // With heat, viscous work is no loss. The stress at the start of a step acts on half of its motion, the
  // stress at its end on the other half (LaneHeat.hpp). In the first half, with the viscous stress of the
  // step before, the law includes the work of the first substep: all of it without substeps. The impulse of a
  // viscous stress is that of the step even so, and the remaining work is recorded here with the new stress,
  // off by a quarter of the change of its work in a step at most, which does not add up.
  const bool heats = state.particles.has(fields::internalEnergy);
  const bool subcycled = heats && state.particles.has(fields::firstFraction);
  BorrowedView<double*> internal, firstFraction;
  if (heats)
    internal = state.particles.scalar(fields::internalEnergy);
  if (subcycled)
    firstFraction = state.particles.scalar(fields::firstFraction);
  Kokkos::parallel_reduce(
      "rhegma::viscousStress", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum) {
        double trace = 0.0;
        for (int i = 0; i < D; ++i)
          trace += rate(p, i * D + i);
        double power = 0.0;
        for (int i = 0; i < D; ++i)
          for (int j = i; j < D; ++j)
          {
            const double strainRate = 0.5 * (rate(p, i * D + j) + rate(p, j * D + i));
            const double viscous = 2.0 * shearViscosity * strainRate + (i == j ? bulkViscosity * trace : 0.0);
            stress(p, symmetricIndex<D>(i, j)) += viscous;
            power += (i == j ? 1.0 : 2.0) * viscous * strainRate;
          }
        if (heats)
          internal(p) += (1.0 - 0.5 * (subcycled ? firstFraction(p) : 1.0)) * dt * power;
        else
          sum += dt * volume(p) * power;
      },
      loss);
  return loss;
}

namespace
{

Section section()
{
  Section s("Damping", "Damping, so that a suddenly loaded body settles to static equilibrium.");
  for (const char* const viscosity : {"Shear Viscosity", "Bulk Viscosity"})
    s.refuse({when::above("Damping", viscosity, 0.0), when::axisymmetric()},
             "the rate of the hoop strain has no viscous stress; use Mass Rate, or compute a part of the "
             "body in 3D");
  s.refuse({when::present("Damping"), when::equilibrium()},
           "an equilibrium analysis has no motion to damp; remove this section");
  s.real("Mass Rate")
      .unit("1/s")
      .notNegative()
      .byDefault(0.0)
      .meaning("Mass-proportional damping: force -rate m v. A mode of angular frequency w is critically "
               "damped at 2 w.");
  s.real("Shear Viscosity")
      .unit("Pa s")
      .notNegative()
      .byDefault(0.0)
      .meaning("Shear viscosity eta: adds the stress 2 eta D to every material, D being the strain rate.");
  s.real("Bulk Viscosity")
      .unit("Pa s")
      .notNegative()
      .byDefault(0.0)
      .meaning("Bulk viscosity zeta: adds the stress zeta tr(D) I.");
  s.real("End Time")
      .unit("s")
      .positive()
      .optional("never")
      .meaning("Damping is switched off at this time, for example after a static preload.");
  s.boolean("Stop When Settled")
      .mayChange()
      .byDefault(false)
      .meaning("If true, the run ends as soon as it has settled, but not before every load has reached its "
               "constant value; Time > Final Time is then the upper limit.");
  s.real("Settled Energy Ratio")
      .mayChange()
      .above(0.0)
      .byDefault(1e-4)
      .meaning("Settled criterion: kinetic over strain energy is below this in the last Settled Samples.");
  s.real("Settled Drift")
      .mayChange()
      .above(0.0)
      .byDefault(1e-4)
      .meaning("Settled criterion: relative change of every energy release rate, or of the strain energy if "
               "there is none, over the last Settled Samples.");
  s.integer("Settled Samples")
      .mayChange()
      .atLeast(2)
      .byDefault(5)
      .meaning("Number of history samples over which both criteria must hold.");
  return s;
}

/// \param rate of mass damping [1/s] \param end of damping [s] \param between whether the scheme is USAVG
template <int D>
void addMassDamping(Effect<D>& effect, double rate, double end, bool between)
{
  // Between its two strains, so that one velocity does the second of a step and the first of the next, and
  // moves the particles; before other forces than those of stresses.
  if (between)
    effect.call(Stage::BeforeSolve, "mass damping", {quantity::internalForce}, {quantity::nodalForce}, {},
                [=, held = std::make_shared<View<char**>>()](State<D>& s)
                {
                  if (s.clock.time >= end)
                    return;
                  s.energy.damped += dampVelocity(s, rate);
                  dampMomentum(s, rate);
                  s.energy.damped += lossToStresses(s, rate, *held);
                });
  if (between)
    return;
  effect.call(Stage::Scatter, "mass damping", {}, {quantity::particleVelocity}, {},
              [=](State<D>& s)
              {
                if (s.clock.time < end)
                  s.energy.damped += dampVelocity(s, rate);
              });
  effect.call(Stage::Scatter, "what mass damping takes from stresses",
              {quantity::nodalMomentum, ifWritten(quantity::prescribedMotion), ifWritten(quantity::substeps),
               ifWritten(quantity::massMatrix)},
              {}, {},
              [=, held = std::make_shared<View<char**>>()](State<D>& s)
              {
                if (s.clock.time < end && s.method.scheme == UpdateScheme::Musl)
                  s.energy.damped += lossToStresses(s, rate, *held);
              });
}

/// \param shear viscosity \param bulk viscosity [Pa s] \param end of damping [s]
template <int D>
void addViscosity(Effect<D>& effect, double shear, double bulk, double end)
{
  effect.adds.push_back({fields::rate, D * D, "1/s", "velocity gradient, by rows"});
  effect.call(
      Stage::OnParticles, "viscous stress", {quantity::particleStress}, {}, {},
      [=](State<D>& s)
      {
        if (s.clock.time < end)
          s.energy.damped += addViscousStress(s, shear, bulk);
      },
      true);
  // An explicit step resolves diffusion of momentum only below h^2 / (2 D nu); the largest viscosity is
  // that of dilatation.
  effect.timeStepLimit = [=](const State<D>& s)
  {
    double density = s.materials.properties.front().density;
    for (const Properties& p : s.materials.properties)
      density = std::min(density, p.density);
    return s.method.cfl * density * s.mesh.smallestSpacing() * s.mesh.smallestSpacing() /
           (2.0 * D * (2.0 * shear + bulk));
  };
}

/// \param time [s] \param change how far the answer may still move, as a fraction of itself
void reportSettled(double time, double change, nlohmann::json& summary)
{
  summary["may_still_change"] = change;
  if (std::isfinite(change))
    summary["answers"].push_back(
        "settled at t = " + readableTime(time) +
        ": energy release rates (without a crack, the strain energy) may still change by at most " +
        formatShort(100.0 * change) + " %");
}

/// Adds a warning of loads that still change after a run has settled, as one that never settles does.
void reportLoads(const Changes& changes, double time, nlohmann::json& summary)
{
  const Changes::Change change = changes.after(time);
  if (change.fraction > noticeableChange)
    summary["warnings"].push_back(
        "Damping > Stop When Settled: the run settled at t = " + readableTime(time) + ", but " +
        (change.ofRate ? "the displacement of " : "") + change.where + " still changes by " +
        formatShort(100.0 * change.fraction) +
        " % of its largest value up to Time > Final Time: results are those of the loads at that time");
}

/// \param slowest motion of its bodies \param changes of the loads, where the run ends at rest; or null
void reportRest(const Clock& clock, const Settling& settling, const SlowMotion& slowest,
                const Changes* changes, nlohmann::json& summary)
{
  if (std::isfinite(slowest.frequency) && slowest.frequency > 0.0)
    summary["slowest_motion"] = {{"name", slowest.name}, {"angular_frequency", slowest.frequency}};
  if (!clock.settled)
    return;
  reportSettled(clock.time, settling.mayStillChange(), summary);
  if (changes != nullptr)
    reportLoads(*changes, clock.time, summary);
}

/// \param damped up to the end \param run what is known of it
void reportUnsettled(const Settling& settling, bool damped, Unsettled run, nlohmann::json& summary)
{
  if (damped)
    run.measured = settling.frequencyOfCreep();
  if (settling.isSlow())
    run.change = settling.mayStillChange();
  summary["may_still_change"] = run.change;
  summary["warnings"].push_back(unsettledWarning(run));
}

/// Whether the equilibrium of a scene can be solved for as well: small strain of elastic bodies at rest.
template <int D>
bool isLinear(const State<D>& state, const RunOptions& options)
{
  const std::vector<BodyMeasure<D>> bodies = measureBodies(state);
  return !options.growth && !options.heat() && !options.burning && !options.contact && !options.adaptive &&
         std::all_of(bodies.begin(), bodies.end(), [](const auto& body) { return body.linear; });
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene, const RunOptions& options)
{
  const Teuchos::ParameterList& list = scene.sublist("Damping");
  const double rate = list.get<double>("Mass Rate");
  const double shear = list.get<double>("Shear Viscosity");
  const double bulk = list.get<double>("Bulk Viscosity");
  const double end =
      list.isParameter("End Time") ? list.get<double>("End Time") : std::numeric_limits<double>::infinity();
  Effect<D> effect;
  effect.name = "Damping";
  effect.balance = {"damped"};
  if (rate > 0.0)
    addMassDamping(effect, rate, end, scene.sublist("Time").get<std::string>("Update Scheme") == "USAVG");
  if (shear > 0.0 || bulk > 0.0)
    addViscosity(effect, shear, bulk, end);
  const auto settling =
      std::make_shared<Settling>(list.get<double>("Settled Energy Ratio"), list.get<double>("Settled Drift"),
                                 list.get<int>("Settled Samples"), rate);
  const bool stop = list.get<bool>("Stop When Settled");
  const double until = scene.sublist("Time").get<double>("Final Time");
  effect.atStart = [=](State<D>& s) { s.clock.stopWhenSettled = stop; };
  const double drift = list.get<double>("Settled Drift");
  const Teuchos::ParameterList& output = scene.sublist("Output");
  const double interval =
      output.isParameter("History Interval") ? output.get<double>("History Interval") : until / 200.0;
  const int samples = list.get<int>("Settled Samples");
  const auto changes = std::make_shared<const Changes>(options.driving, until);
  settling->waitForLoads(stop ? changes->last() : 0.0, 0.0);
  const auto known = std::make_shared<Unsettled>(); // of whole bodies, before ranks divide them
  known->rate = rate;
  effect.judge = [=, holding = holdingOf(scene)](State<D>& s)
  {
    if (const auto judged = judgedBody(s, holding))
    {
      if (judged->slowest.known)
        known->estimated = judged->slowest;
      if (stop && judged->slowest.frequency > 0.0) // half a period
        settling->waitForLoads(changes->last(), std::acos(-1.0) / judged->slowest.frequency);
      judgeDamping({rate, shear, bulk, std::min(end, until), stop ? drift : 1.0}, *judged, s);
    }
    known->linear = isLinear(s, options);
    if (stop && !s.method.equilibrium())
      judgeSamples(interval, until, samples, s.warnings);
  };
  effect.call(
      Stage::Observe, "settling", {quantity::energyBalance, ifWritten(quantity::energyRelease)}, {}, {},
      [settling](State<D>& s)
      { s.clock.settled = settling->sample(s.energy.kinetic, s.energy.strain, s.sample.row, s.clock.time); });
  effect.report = [=](const State<D>& s, nlohmann::json& summary)
  {
    reportRest(s.clock, *settling, known->estimated, stop ? changes.get() : nullptr, summary);
    const bool over = s.clock.time >= until || s.clock.step >= s.clock.maximumSteps;
    summary["ended_before_settled"] = stop && over && !s.clock.settled && s.failure.empty();
    if (!summary["ended_before_settled"])
      return;
    Unsettled run = *known;
    run.drift = drift;
    reportUnsettled(*settling, end >= until, run, summary);
  };
  effect.memory = [settling](State<D>&, Archive& archive) { settling->serialize(archive); };
  return effect;
}

} // namespace

EffectEntry dampingEntry()
{
  EffectEntry entry{section(), {}, make<2>, make<3>, true};
  entry.declare = [](const Teuchos::ParameterList& list, RunOptions& options)
  {
    if (list.get<bool>("Stop When Settled"))
      options.endAtRest = {list.get<double>("Settled Energy Ratio"), list.get<double>("Settled Drift"),
                           list.get<double>("Mass Rate")};
  };
  entry.cells.addNeeds = [](const Teuchos::ParameterList& scene, CellNeeds& needs, auto&)
  { needs.rests = scene.sublist("Damping").get<bool>("Stop When Settled"); };
  return entry;
}

template double addViscousStress(State<2>&, double, double);
template double addViscousStress(State<3>&, double, double);

} // namespace Rhegma::damping
