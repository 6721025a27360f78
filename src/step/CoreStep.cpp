#include "step/CoreStep.hpp"

#include "base/UnstableStep.hpp"
#include "grid/BlockCells.hpp"
#include "material/Materials.hpp"
#include "state/CellFrame.hpp"
#include "state/Subdomain.hpp"
#include "step/HeatFailure.hpp"
#include "step/OutsideDomain.hpp"
#include "transfer/Gather.hpp"
#include "transfer/Motion.hpp"
#include "transfer/Scatter.hpp"
#include "transfer/Stencils.hpp"
#include "transfer/Velocity.hpp"

#include <cmath>

namespace Rhegma
{

namespace
{

template <int D>
void strain(State<D>& state, StrainVelocity velocity, bool alsoMove)
{
  state.clock.fastestSpeed = strainAndMove(state, velocity, true, alsoMove);
  // No stable step moves a particle by two cells: a particle that left the domain so was unstable.
  const bool flung =
      !state.failure.empty() && state.clock.fastestSpeed * state.clock.dt > 2.0 * state.mesh.stepSpacing();
  if (std::isfinite(state.clock.fastestSpeed) && !flung)
  {
    if (!state.failure.empty())
      state.failure = failureOutsideDomain(state, state.failure);
    return;
  }
  // Laws fail at impossible temperatures.
  const std::string heat = heatFailure(state);
  state.failure =
      !heat.empty()
          ? heat
          : std::string(state.method.totalLagrangian ? "a particle is compressed to less than a fiftieth"
                                                     : "a particle has a negative volume") +
                " or its velocity is not finite (" + unstableStep(state.mesh.subcycledLevels) +
                ", smaller cells or a lower load rate)";
}

template <int D>
Call<D> sortCall()
{
  return {Stage::BetweenSteps,
          "sort particles",
          {ifWritten(quantity::cells), ifWritten(quantity::ownership)},
          {quantity::particleOrder},
          {},
          [](State<D>& s)
          {
            if (s.particles.sorted)
              return;
            migrateParticles(s);
            sortState(s);
          }};
}

template <int D>
void toNodes(State<D>& s, bool strainsFirst)
{
  storeStencils(s);
  clearNodes(s);
  scatter(s, strainsFirst ? ScatterWhat::MassAndMomentum : ScatterWhat::All);
  sumOverRanks(s, SharedSums::MassAndMomentum);
  if (!strainsFirst)
    return;
  particleVelocity(s, VelocityWhat::Project);
  sumOverRanks(s, SharedSums::Projection);
  finishProjection(s);
}

template <int D>
void toParticles(State<D>& s, UpdateScheme scheme)
{
  if (scheme == UpdateScheme::Usavg)
    clearProjection(s);
  particleVelocity(s, projectsLast(scheme) ? VelocityWhat::GatherAndProject : VelocityWhat::Gather);
  if (projectsLast(scheme))
  {
    sumOverRanks(s, SharedSums::Projection);
    finishProjection(s);
    slowRelativeMotion(s, RelativePart::Projection);
  }
  if (scheme == UpdateScheme::Usf)
    strainAndMove(s, StrainVelocity::Projection, false, true);
}

/// The core of a scene without motion.
template <int D>
Effect<D> pointsAtRest()
{
  Effect<D> core;
  core.name = "Material Points at Rest";
  core.provides = {quantity::energyBalance, quantity::nodalMass, quantity::nodalMotion,
                   quantity::projection}; // zero except for the energies: nothing moves
  core.call(sortCall<D>());
  core.call(Stage::Scatter, "stencils", {}, {quantity::stencils, quantity::enrichedFields}, {},
            [](State<D>& s) { storeStencils(s); });
  return core;
}

} // namespace

template <int D>
Effect<D> makeCore(const State<D>& state, const std::shared_ptr<equilibrium::LastStep>& last)
{
  if (state.method.equilibrium())
  {
    Effect<D> core = equilibrium::makeEquilibrium<D>(last);
    core.call(sortCall<D>());
    return core;
  }
  const UpdateScheme scheme = state.method.scheme;
  const bool strainsFirst = scheme == UpdateScheme::Usf || scheme == UpdateScheme::Usavg;
  if (!state.method.mechanics)
    return pointsAtRest<D>();
  Effect<D> core;
  core.name = "Material Point Method";
  core.provides = {quantity::energyBalance}; // written by Run before the stage Observe
  core.call(sortCall<D>());
  Quantities scattered = {quantity::stencils, quantity::enrichedFields, quantity::nodalMass,
                          quantity::nodalMomentum,
                          strainsFirst ? quantity::projection : quantity::internalForce};
  core.call(Stage::Scatter, strainsFirst ? "mass and momentum to nodes" : "mass, momentum and force to nodes",
            {quantity::particleVelocity}, scattered, {},
            [strainsFirst](State<D>& s) { toNodes(s, strainsFirst); });
  if (strainsFirst)
    core.call(Stage::BeforeSolve, "force to nodes", {quantity::nodalMass}, {quantity::internalForce}, {},
              [](State<D>& s) { scatter(s, ScatterWhat::Force); });
  core.call(Stage::Solve, "lumped solve", {quantity::internalForce, ifWritten(quantity::nodalForce)},
            {quantity::nodalMotion}, {},
            [](State<D>& s)
            {
              sumOverRanks(s, SharedSums::Force);
              slowRelativeMotion(s, RelativePart::Force);
              solveLumped(s);
            });
  Quantities gathered = {quantity::particleVelocity};
  if (projectsLast(scheme))
    gathered.push_back(quantity::projection);
  core.call(Stage::Gather, "velocity to particles", {quantity::nodalMotion}, gathered, {},
            [scheme](State<D>& s) { toParticles(s, scheme); });
  core.call(
      Stage::OnParticles, "strain, stress and position of particles",
      {quantity::nodalMotion, ifWritten(quantity::projection), ifWritten(quantity::temperature)},
      {quantity::particleStress}, {},
      [scheme](State<D>& s)
      {
        strain(s, scheme == UpdateScheme::Usl ? StrainVelocity::Motion : StrainVelocity::Projection,
               !s.clock.strainPass.before);
      },
      true);
  return core;
}

namespace
{

/// Ids have gaps where particles were split, merged or sent.
int largestId(const BorrowedView<int*>& id)
{
  int largest = -1;
  Kokkos::parallel_reduce(
      "rhegma::largestId", Kokkos::RangePolicy<ExecSpace>(0, id.extent(0)),
      KOKKOS_LAMBDA(const int p, int& most) { most = id(p) > most ? id(p) : most; },
      Kokkos::Max<int>(largest));
  return largest;
}

/// Adds the nodes of refined cells to those in use: their cells are few, and most contain particles.
template <int D>
void addFineNodes(State<D>& state)
{
  const int lattice = static_cast<int>(state.mesh.nodes.active.extent(0)), fine = state.mesh.tree.numFine;
  const View<int*> active("rhegma::activeNodes", lattice + fine);
  Kokkos::deep_copy(Kokkos::subview(active, std::make_pair(0, lattice)), state.mesh.nodes.active);
  const int first = state.mesh.grid.numNodes;
  Kokkos::parallel_for(
      "rhegma::addFineNodes", Kokkos::RangePolicy<ExecSpace>(0, fine),
      KOKKOS_LAMBDA(const int k) { active(lattice + k) = first + k; });
  state.mesh.nodes.active = active;
}

/// Finds the blocks whose particles may touch a refined cell or one next to it: they are no more than a cell
/// outside of their block, and their boxes reach no more than half a cell further.
template <int D>
void markBlocks(State<D>& state)
{
  constexpr int beyond = 2;
  Blocks<D>& blocks = state.mesh.blocks;
  blocks.refined = View<char*>("rhegma::refinedBlocks", blocks.numBlocks);
  const Grid<D> grid = state.mesh.grid;
  const View<char*> refined = blocks.refined, near = state.mesh.tree.nearRefined;
  const View<int * [Blocks<D>::axes]> corner = blocks.corner;
  Kokkos::parallel_for(
      "rhegma::markBlocks", Kokkos::RangePolicy<ExecSpace>(0, blocks.numBlocks),
      KOKKOS_LAMBDA(const int b) { refined(b) = anyCellMarked(grid, near, corner, b, beyond) ? 1 : 0; });
}

} // namespace

template <int D>
void sortState(State<D>& state)
{
  sortParticles(state.mesh.grid, state.particles, state.mesh.blocks, state.mesh.nodes.active);
  useSharedNodes(state);
  if (state.mesh.tree.refined())
  {
    addFineNodes(state);
    markBlocks(state);
  }
  const int n = state.particles.size();
  const auto id = state.particles.integer(fields::id);
  const bool gaps = state.particles.has(fields::level) || state.ranks.many();
  const int ids = gaps ? static_cast<int>(state.ranks.max(largestId(id))) + 1 : n;
  if (static_cast<int>(state.particles.indexOf.extent(0)) < ids)
    state.particles.indexOf = View<int*>("rhegma::indexOf", ids);
  if (state.ranks.many())
    Kokkos::deep_copy(state.particles.indexOf, -1);
  const View<int*> indexOf = state.particles.indexOf;
  Kokkos::parallel_for(
      "rhegma::indexParticles", Kokkos::RangePolicy<ExecSpace>(0, n),
      KOKKOS_LAMBDA(const int p) { indexOf(id(p)) = p; });
  state.particles.sorted = true;
  ++state.particles.sorts;
}

template <int D>
double fastestSpeed(const State<D>& state)
{
  const auto materials = state.materials.device;
  const auto material = state.particles.integer(fields::material);
  const auto velocity = state.particles.template real<D>(fields::velocity);
  const auto F = state.particles.template real<gradientSize<D>>(fields::deformation);
  BorrowedView<double**> history;
  if (state.particles.has(fields::history))
    history = state.particles.table(fields::history);
  const bool undeformed = state.method.totalLagrangian;
  double fastest = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::fastestSpeed", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& largest) {
        double speed = 0.0;
        for (int d = 0; d < D; ++d)
          speed += velocity(p, d) * velocity(p, d);
        const double wave =
            waveSpeed<D>(materials(material(p)), &F(p, 0), history.extent(1) > 0 ? &history(p, 0) : nullptr);
        speed = undeformed ? wave * slowestStretch<D>(&F(p, 0)) : std::sqrt(speed) + wave;
        largest = speed > largest ? speed : largest;
      },
      Kokkos::Max<double>(fastest));
  return fastest;
}

template Effect<2> makeCore(const State<2>&, const std::shared_ptr<equilibrium::LastStep>&);
template Effect<3> makeCore(const State<3>&, const std::shared_ptr<equilibrium::LastStep>&);
template void sortState(State<2>&);
template void sortState(State<3>&);
template double fastestSpeed(const State<2>&);
template double fastestSpeed(const State<3>&);

} // namespace Rhegma
