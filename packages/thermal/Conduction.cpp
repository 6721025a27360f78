#include "thermal/Conduction.hpp"

#include "base/Numbers.hpp"
#include "state/Subdomain.hpp"
#include "thermal/CellExpansion.hpp"
#include "thermal/MeetingMaterials.hpp"
#include "thermal/SteadyExtremes.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::thermal
{

namespace
{

/// Conduction waits while the pending time is below this fraction of its own step.
constexpr double waitingFraction = 0.25;

/// pi^2 (MeetingMaterials.hpp).
constexpr double joining = 9.8696044010893586;

/// Length of a steady step, in times in which heat crosses the domain.
constexpr double crossings = 1e8;

/// Passes of a steady step where conductivities depend on temperature, and the change of temperatures, as a
/// fraction of their range, that ends them.
constexpr int mostPasses = 100;
constexpr double passTolerance = 1e-9;

/// Range of temperatures that no body has [K].
constexpr double widestRange = 1e6;

} // namespace

template <int D>
void Conduction<D>::measure(const State<D>& state)
{
  const auto materials = onHost(state.materials.thermo.material);
  const auto knots = onHost(state.materials.thermo.knot);
  diffusivity = 0.0;
  leastCapacity = leastDiffusivity = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < materials.extent(0); ++m)
  {
    double ratio = 0.0, least = 1e300;
    for (int d = 0; d < D; ++d)
    {
      ratio = std::max(ratio, materials(m).ratio[d]);
      least = std::min(least, materials(m).ratio[d]);
    }
    for (int k = materials(m).first; k < materials(m).first + materials(m).count; ++k)
    {
      diffusivity = std::max(diffusivity, ratio * knots(k).conductivity / knots(k).capacity);
      // Of the conductors only: insulators do not contribute to their nodes.
      if (knots(k).conductivity > 0.0 || materials.extent(0) == 1)
        leastDiffusivity = std::min(leastDiffusivity, least * knots(k).conductivity / knots(k).capacity);
      leastCapacity = std::min(leastCapacity, knots(k).capacity);
    }
  }
  several = materials.extent(0) > 1 && diffusivity > 0.0;
  expands = state.method.mechanics && anyExpands(state.materials.thermo);
  if (!std::isfinite(leastDiffusivity))
    leastDiffusivity = 0.0;
}

template <int D>
double Conduction<D>::stepLimit(const State<D>& state) const
{
  if (integrator.method == Method::Steady)
    return std::numeric_limits<double>::infinity();
  const double ratio = integrator.method == Method::Explicit ? 1.0 : integrator.stepRatio;
  return ratio * explicitLimit(state);
}

template <int D>
double Conduction<D>::explicitLimit(const State<D>& state) const
{
  const double h = state.mesh.smallestSpacing();
  double limit = boundaries.stepLimit(leastCapacity, h);
  if (diffusivity > 0.0)
    limit = std::min(limit, diffusionNumber * h * h / diffusivity);
  return limit;
}

template <int D>
double Conduction<D>::sourceLimit(const State<D>& state) const
{
  double limit = std::numeric_limits<double>::infinity();
  for (const Source<D>& source : sources)
    if (const double speed = std::sqrt(dot(source.velocity, source.velocity)); source.ball && speed > 0.0)
      limit = std::min(limit, 0.5 * state.mesh.smallestSpacing() / speed);
  return limit;
}

template <int D>
double Conduction<D>::substeps(const State<D>& state, double dt) const
{
  return std::max(1.0, std::ceil(dt / stepLimit(state) * (1.0 - 1e-12)));
}

template <int D>
std::string Conduction<D>::tooMany(const State<D>& state, double count) const
{
  return "explicit conduction would need " + formatReal(count) + " steps of " + formatReal(stepLimit(state)) +
         " s in one step of the run; check Conductivity and Specific Heat, or " +
         (state.method.equilibrium()
              ? "write Thermal > Conduction = Implicit, a larger Step Ratio or more Time > Load Steps"
              : "switch the motion off (Thermal > Mechanics = false)");
}

/// \param time begin of the step \return the power of the sources that this rank records
template <int D>
double Conduction<D>::supplyAll(State<D>& state, double dt, double time)
{
  const bool heated = frontFraction > 0.0 && !state.cracks.fronts.empty();
  if (sources.empty() && !heated)
    return 0.0;
  if (static_cast<int>(supply.extent(0)) < state.particles.size())
    supply = View<double*>("rhegma::thermal::supply", state.particles.size());
  Kokkos::deep_copy(supply, 0.0);
  const bool records = state.ranks.rank() == 0;
  double power = 0.0;
  for (const Source<D>& source : sources)
  {
    const double added = addSource(state, source, time, dt, supply);
    power += records ? added : 0.0;
  }
  if (heated)
  {
    const double ofFronts = heatOfFronts(state, dt) / dt;
    power += records ? ofFronts : 0.0;
  }
  return power;
}

template <int D>
void Conduction<D>::keepGradients(const State<D>& state)
{
  const int count = state.particles.size();
  if (static_cast<int>(gradientBefore.extent(0)) < count)
    gradientBefore = View<double* [D]>("rhegma::thermal::gradientBefore", count + count / 8);
  const auto gradient = state.particles.template real<D>(fields::temperatureGradient);
  const View<double* [D]> before = gradientBefore;
  Kokkos::parallel_for(
      "rhegma::thermal::keepGradients", Kokkos::RangePolicy<ExecSpace>(0, count), KOKKOS_LAMBDA(const int p) {
        for (int d = 0; d < D; ++d)
          before(p, d) = gradient(p, d);
      });
}

/// \param dt length of the step \param begin of the time over which functions of time act \param end of it,
/// at which temperatures are held
template <int D>
void Conduction<D>::once(State<D>& state, double dt, double begin, double end, const View<double*>& supplied)
{
  const double h = state.mesh.smallestSpacing();
  // Differences that nodes do not resolve decay in the time of diffusion through a cell, ten times slower
  // than modes of that wavelength. With the smallest diffusivity, as particles of all materials have the same
  // decay.
  const double fading =
      std::min(-std::expm1(-leastDiffusivity * dt / (h * h)), 1.0 / largestPositiveSum(state));
  // Where materials meet, the temperatures of their particles approach each other faster. The decay is part
  // of that: both in full would pass the temperature of the node.
  const double join = -std::expm1(-joining * diffusivity * dt / (h * h)) - fading;
  nodes.clear(state, several);
  if (several)
    markMaterials(state, nodes, join);
  heatToNodes(state, nodes);
  sumOverRanks(state, nodes.sums.data(), HeatNodes<D>::sumWidth, 0, HeatNodes<D>::momentAt + D);
  if (!state.cracks.cracks.empty())
    sumOverRanks(state, nodes.rate.data(), 2, HeatNodes<D>::leftOutAt, 1);
  findTemperature(state, nodes);
  if (!facesKnown)
    faces.update(state, nodes);
  facesKnown = true;
  faces.merge(state, nodes, join);
  if (several)
    joinMaterials(state, nodes);
  boundaries.hold(state, nodes, end);
  double heat = dt * boundaries.addFlux(state, nodes, begin, end - begin);
  if (expands)
    keepGradients(state);
  fluxToNodes(state, nodes, supplied);
  sumOverRanks(state, nodes.rate.data(), 2, 0, 1);
  if (integrator.method != Method::Explicit)
    heat += integrator.findRate(state, nodes, boundaries, faces, dt, explicitLimit(state));
  if (integrator.method == Method::Steady)
    heat = integrator.takeSteadyChange(state, nodes);
  else
    heat += changeTemperature(state, nodes, dt);
  if (integrator.method == Method::Explicit)
    heat += faces.exchange(state, nodes, dt);
  ++stepsTaken;
  changeToParticles(state, nodes, fading, supplied, dt);
  if (expands)
    correctExpansion(state, nodes, gradientBefore);
  state.energy.heat += heat;
}

namespace
{

/// What a pass of a steady step finds, of all ranks.
struct SteadyPass
{
  double range = 0.0;                                       ///< of the temperatures of particles [K]
  double changed = std::numeric_limits<double>::infinity(); ///< largest change since the last pass [K]
  bool failed = false;                                      ///< whether the run cannot go on

  bool goesOn() const { return changed > passTolerance * range && !failed; }
};

/// Compares the temperatures of the particles with those of the last pass. Of particles: a node that has a
/// fraction e of a cell's heat takes 1 / sqrt(e) of the gradient next to it, so that its value is no
/// temperature of the body. Collective. \param before temperatures then, which become those now; empty before
/// the first pass
template <int D>
SteadyPass comparePasses(const State<D>& state, bool first, std::vector<double>& before)
{
  const auto temperature = onHost(state.particles.scalar(fields::temperature));
  std::vector<double> now(temperature.data(), temperature.data() + state.particles.size());
  constexpr double none = std::numeric_limits<double>::lowest();
  double most[] = {none, none, 0.0, state.failure.empty() ? 0.0 : 1.0}; // -lowest, highest, change, failed
  for (std::size_t i = 0; i < now.size(); ++i)
  {
    most[0] = std::max(most[0], -now[i]);
    most[1] = std::max(most[1], now[i]);
    most[2] = std::max(most[2], first ? 0.0 : std::fabs(now[i] - before[i]));
  }
  before = std::move(now);
  state.ranks.max(most, 4);
  return {most[1] > none ? most[0] + most[1] : 0.0, first ? std::numeric_limits<double>::infinity() : most[2],
          most[3] > 0.0};
}

} // namespace

template <int D>
void Conduction<D>::solveSteady(State<D>& state)
{
  const auto materials = onHost(state.materials.thermo.material);
  bool linear = true;
  for (std::size_t m = 0; m < materials.extent(0); ++m)
    linear = linear && materials(m).count == 1;
  double length = 0.0;
  for (int d = 0; d < D; ++d)
    length += wholeLattice(state).cells[d] * state.mesh.grid.spacing;
  const double dt = crossings * length * length / diffusivity;
  const double at = state.method.analysis == Analysis::Static ? finalTime : state.clock.time + state.clock.dt;
  facesKnown = false;
  SteadyPass pass;
  pass.failed = state.ranks.max(state.failure.empty() ? 0.0 : 1.0) > 0.0;
  std::vector<double> before;
  for (int k = 0; k < mostPasses && pass.goesOn(); ++k)
  {
    supplyAll(state, 0.0, at);
    once(state, dt, at, at, supply.extent(0) > 0 ? supply : View<double*>());
    pass = comparePasses(state, k == 0, before);
    if (pass.range > widestRange && state.failure.empty())
      state.failure = "steady conduction: the temperatures of bodies differ by " + formatReal(pass.range) +
                      " K; heat flows into a body, or into a part that insulating cracks cut off, that no "
                      "Temperature or Convection (Boundaries) lets out; check heat sources and fluxes, or "
                      "prescribe a temperature of this body or part";
    pass.failed = pass.failed || pass.range > widestRange;
    if (linear)
      pass.changed = 0.0;
  }
  if (pass.goesOn() && state.failure.empty())
    state.failure = "steady conduction with conductivities that depend on temperature did not converge";
  if (const std::string reason = failureOfSteady(state, *this); state.failure.empty())
    state.failure = reason;
  reportFronts(state);
  pending = 0.0;
  waited = 0;
}

template <int D>
void Conduction<D>::step(State<D>& state)
{
  pending += state.clock.dt;
  ++waited;
  const double limit = stepLimit(state);
  const bool last =
      state.clock.time + state.clock.dt >= finalTime * (1.0 - 1e-12); // so that no time remains pending
  if (!last && state.method.mechanics && !state.method.equilibrium() && waited < longestWait &&
      pending + state.clock.dt <= waitingFraction * limit)
    return;
  if (cellsSeen != state.mesh.tree.generation)
  {
    cellsSeen = state.mesh.tree.generation;
    const std::string wrong = boundaries.contradictions(state, finalTime);
    if (!wrong.empty())
    {
      state.failure = wrong;
      return;
    }
  }
  // Adaptive cells have been refined at the sources by then.
  if (!warned && state.clock.step >= 32)
  {
    warned = true;
    for (const Source<D>& source : sources)
      if (const std::string word = unresolved("Thermal > Sources > " + source.name + " > Radius",
                                              source.radius, state.mesh.smallestSpacing());
          source.ball && !word.empty())
        state.warnings.push_back(word);
  }
  if (integrator.method == Method::Steady)
    return solveSteady(state);
  const double steps = substeps(state, pending);
  if (!(steps <= mostSubsteps))
  {
    state.failure = tooMany(state, steps);
    return;
  }
  const int count = static_cast<int>(steps);
  const double dt = pending / count, begin = state.clock.time + state.clock.dt - pending;
  const View<double*> none;
  facesKnown = false;
  for (int k = 0; k < count; ++k)
  {
    const double time = begin + k * dt;
    const double power = supplyAll(state, dt, time);
    state.energy.heat += dt * power;
    once(state, dt, time, time + dt, supply.extent(0) > 0 ? supply : none);
  }
  reportFronts(state);
  pending = 0.0;
  waited = 0;
}

template struct Conduction<2>;
template struct Conduction<3>;

} // namespace Rhegma::thermal
