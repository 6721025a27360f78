#pragma once
/// Strain and move of particles, with and without heat: templates for Gather.cpp and HeatedGather.cpp, two
/// files so that each is optimised independently of the other.

#include "state/CellFrame.hpp"
#include "transfer/Box.hpp"
#include "transfer/Gather.hpp"
#include "transfer/LaneHeat.hpp"
#include "transfer/ParticleViews.hpp"

#include <limits>

namespace Rhegma
{

namespace detail
{

/// Particles without heat.
struct NoHeat
{
  static constexpr bool on = false;
};

/// Particles with heat: their internal energy, and the temperature that follows from it.
struct ParticleHeat
{
  static constexpr bool on = true;
  ThermoTables tables;
  BorrowedView<double*> temperature, internal;
  BorrowedView<double*>
      firstFraction;       ///< fraction of the step in which the force at its start acts; empty: all of it
  View<double*> supplied;  ///< out: heat that holds the temperature [J/m3]; empty where none is held
  bool isothermal = false; ///< whether strain is at the temperature of the start of the step
};

/// Factor of the speed of waves along undeformed axes from which on a particle counts as collapsed:
/// compressed to a fiftieth. The stable step goes with its inverse, so that the run would not end.
constexpr double mostCompressed = 50.0;

/// What happens to the particles of one bundle once the nodes have given them a velocity and its gradient:
/// the same for all shape functions and stencils, so that it is compiled once for each of them.
template <int D, class Heat>
struct BundleMotion
{
  using Lanes = StrainLanes<D>;

  View<Properties*> materials;
  View<double* [D][D]> axes;
  BorrowedView<int*> material, body;
  BorrowedView<double*[D]> position, velocity, edge, box;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<double * [symmetricSize<D>]> stress;
  CellFrame<D> frame;
  BorrowedView<double* [D]> displacement; ///< where the cells lie in the undeformed body
  BorrowedView<double**> history;
  BorrowedView<double**> rate; ///< velocity gradient, where an effect needs it
  BorrowedView<int*> level;    ///< how often each particle was split; empty where none is
  Grid<D> grid;
  Blocks<D> blocks;
  Heat heat;
  double dt, strainTime, largestBox;
  bool strain, move, boxes;

  /// \param at with the particles' velocity and its gradient; of the caller, so no field of particles
  /// overlaps it
  KOKKOS_FUNCTION void run(int bundle, int begin, int end, Lanes& KOKKOS_RESTRICT at, double& fastest) const
  {
    if (move && frame.undeformed)
      displaceLanes(begin, end, at);
    else if (move)
      moveLanes(begin, end, blocks.bundleBlock(bundle), at);
    loadDeformation(begin, end, at);
    if (strain && frame.undeformed)
      pushGradients(begin, end, at);
    if (strain)
      strainLanes(begin, end, at, fastest);
    // If the step continues after the strain (USF), mass, force and velocity must use the same box.
    if (boxes && move)
      updateBoxes(begin, end, at);
  }

  /// Moves the particles of undeformed cells, in which they stay.
  KOKKOS_INLINE_FUNCTION void displaceLanes(int begin, int end, const Lanes& KOKKOS_RESTRICT at) const
  {
    for (int d = 0; d < D; ++d)
      for (int p = begin; p < end; ++p)
        displacement(p, d) += dt * at.shift[d][p - begin];
  }

  /// Gradients with respect to undeformed positions become those with respect to present ones.
  KOKKOS_INLINE_FUNCTION void pushGradients(int begin, int end, Lanes& KOKKOS_RESTRICT at) const
  {
    for (int p = begin; p < end; ++p)
    {
      double L[D * D];
      for (int k = 0; k < D * D; ++k)
        L[k] = at.gradient[k][p - begin];
      frame.pushForward(p, L);
      for (int k = 0; k < D * D; ++k)
        at.gradient[k][p - begin] = L[k];
      if constexpr (D == 2)
        at.gradient[4][p - begin] *= frame.hoopFactor(p);
    }
  }

  /// The speed of waves through undeformed cells.
  KOKKOS_INLINE_FUNCTION void pullSpeeds(int count, Lanes& KOKKOS_RESTRICT at) const
  {
    for (int l = 0; l < count; ++l)
    {
      double F[gradientSize<D>];
      for (int k = 0; k < gradientSize<D>; ++k)
        F[k] = at.F[k][l];
      const double slowest = slowestStretch<D>(F);
      if (std::isfinite(at.speed[l]))
        at.speed[l] =
            slowest < mostCompressed ? at.speed[l] * slowest : std::numeric_limits<double>::infinity();
    }
  }

  KOKKOS_INLINE_FUNCTION void moveLanes(int begin, int end, int block, const Lanes& KOKKOS_RESTRICT at) const
  {
    bool left = false;
    int cell[lanes] = {}; // of the particle now, by its lowest node
    for (int d = 0; d < D; ++d)
    {
      const double lower = grid.lower[d], upper = grid.upper[d];
      const double origin = grid.origin[d], inverse = grid.inverse;
      const int stride = grid.stride[d];
      for (int p = begin; p < end; ++p)
      {
        const double x = position(p, d) + dt * at.shift[d][p - begin];
        position(p, d) = x;
        left = left || !(x >= lower && x <= upper);
        cell[p - begin] += stride * static_cast<int>((x - origin) * inverse);
      }
    }
    // Every thread that finds one writes the same value.
    if (left)
      Kokkos::atomic_exchange(&blocks.strays(1), 1);
    else if (strayed(begin, end, block, cell))
      Kokkos::atomic_exchange(&blocks.strays(0), 1);
  }

  KOKKOS_INLINE_FUNCTION bool strayed(int begin, int end, int block, const int* cell) const
  {
    bool any = false;
    for (int l = 0; l < end - begin; ++l)
      any = any || blocks.nearby(cell[l]) == 0;
    for (int a = 0; a < Blocks<D>::axes; ++a)
    {
      const int axis = grid.axisOrder[a];
      const double low = blocks.corner(block, a) - 1.0, high = low + Blocks<D>::edge + 2.0;
      for (int p = begin; p < end; ++p)
      {
        const double cells = grid.inCells(position(p, axis), axis);
        any = any || cells < low || cells >= high;
      }
    }
    return any;
  }

  KOKKOS_INLINE_FUNCTION void loadDeformation(int begin, int end, Lanes& KOKKOS_RESTRICT at) const
  {
    for (int k = 0; k < gradientSize<D>; ++k)
      for (int p = begin; p < end; ++p)
        at.F[k][p - begin] = deformation(p, k);
  }

  KOKKOS_INLINE_FUNCTION void strainLanes(int begin, int end, Lanes& KOKKOS_RESTRICT at,
                                          double& fastest) const
  {
    if (rate.extent(1) > 0)
      for (int k = 0; k < D * D; ++k)
        for (int p = begin; p < end; ++p)
          rate(p, k) = at.gradient[k][p - begin];
    for (int p = begin; p < end; ++p)
    {
      double square = 0.0;
      for (int d = 0; d < D; ++d)
        square += velocity(p, d) * velocity(p, d);
      at.speed[p - begin] = frame.undeformed ? 0.0 : std::sqrt(square);
    }
    if constexpr (Heat::on)
      heatByLaw(begin, end, at);
    else
      stressByLaw(begin, end, at);
    if (frame.undeformed)
      pullSpeeds(end - begin, at);
    for (int k = 0; k < gradientSize<D>; ++k)
      for (int p = begin; p < end; ++p)
        deformation(p, k) = at.F[k][p - begin];
    for (int k = 0; k < symmetricSize<D>; ++k)
      for (int p = begin; p < end; ++p)
        stress(p, k) = at.tau[k][p - begin];
    for (int l = 0; l < end - begin; ++l)
      if (!(at.speed[l] <= fastest))
        fastest = std::isfinite(at.speed[l]) ? at.speed[l] : std::numeric_limits<double>::infinity();
  }

  KOKKOS_INLINE_FUNCTION void stressByLaw(int begin, int end, Lanes& at) const
  {
    const int historyWidth = static_cast<int>(history.extent(1));
    double* const memory = historyWidth > 0 ? &history(begin, 0) : nullptr;
    // Usually all are of one material.
    for (int p = begin; p < end;)
    {
      const int kind = material(p);
      int next = p + 1;
      while (next < end && material(next) == kind)
        ++next;
      const Properties& law = materials(kind);
      withLaw<D>(law.law, law.plane,
                 StressOfLanes<D>{law, at, memory, historyWidth, strainTime, p - begin, next - begin});
      p = next;
    }
  }

  KOKKOS_INLINE_FUNCTION void heatByLaw(int begin, int end, Lanes& at) const
  {
    if constexpr (Heat::on)
    {
      const int historyWidth = static_cast<int>(history.extent(1));
      double* const memory = historyWidth > 0 ? &history(begin, 0) : nullptr;
      HeatLanes<D> own;
      for (int p = begin; p < end; ++p)
      {
        own.temperature[p - begin] = heat.temperature(p);
        own.internal[p - begin] = heat.internal(p);
        own.firstFraction[p - begin] = heat.firstFraction.extent(0) > 0 ? heat.firstFraction(p) : 1.0;
      }
      const bool held = heat.supplied.extent(0) > 0;
      own.held = held ? 1.0 : 0.0;
      own.isothermal = heat.isothermal ? 1.0 : 0.0;
      for (int k = 0; k < symmetricSize<D>; ++k)
        for (int p = begin; p < end; ++p)
          at.tau[k][p - begin] = stress(p, k);
      for (int p = begin; p < end;)
      {
        const int kind = material(p);
        int next = p + 1;
        while (next < end && material(next) == kind)
          ++next;
        const Properties& law = materials(kind);
        const ThermoMaterial& thermal = heat.tables.material(kind);
        if (thermal.count == 1)
          withLaw<D>(law.law, law.plane,
                     HeatOfLanes<D>{law, thermal, heat.tables.knot(thermal.first), at, own, memory,
                                    historyWidth, strainTime, strainTime, p - begin, next - begin});
        else
          HeatByTables<D>{law,          heat.tables, kind,       at,        own,         memory,
                          historyWidth, strainTime,  strainTime, p - begin, next - begin}
              .run();
        p = next;
      }
      for (int p = begin; p < end; ++p)
      {
        heat.temperature(p) = own.temperature[p - begin];
        heat.internal(p) = own.internal[p - begin];
        if (held)
          heat.supplied(p) = own.supplied[p - begin];
      }
    }
  }

  KOKKOS_INLINE_FUNCTION void updateBoxes(int begin, int end, const Lanes& at) const
  {
    for (int p = begin; p < end; ++p)
    {
      double F[gradientSize<D>];
      for (int k = 0; k < gradientSize<D>; ++k)
        F[k] = at.F[k][p - begin];
      // Box at the present position, which USAVG has strained by half.
      if (strainTime < dt)
        strained<D>(at, p - begin, dt - strainTime, F);
      const double largest = level.extent(0) > 0 ? largestBox / (1 << level(p)) : largestBox;
      updateBox<D>(axes, body(p), &edge(p, 0), F, largest, &box(p, 0));
    }
  }
};

/// Strain and move of the particles of one bundle, both by one nodal velocity.
template <int D, class Connect, int Width, class Heat>
struct StrainAndMove
{
  static constexpr int width = D == 2 ? 2 : 4;
  using Lanes = StrainLanes<D>;

  Connect connect;
  View<double* [Width]> nodal;
  BundleMotion<D, Heat> particles;

  KOKKOS_INLINE_FUNCTION void operator()(int bundle, double& fastest) const
  {
    const int begin = particles.blocks.bundleFirst(bundle), end = particles.blocks.bundleFirst(bundle + 1);
    Lanes at;
    fromNodes(begin, end, at);
    particles.run(bundle, begin, end, at, fastest);
  }

  KOKKOS_INLINE_FUNCTION void fromNodes(int begin, int end, Lanes& at) const
  {
    const double* const rows = nodal.data();
    connect.forEachParticle(begin, end,
                            [&](int p, const auto& stencil)
                            {
                              const int l = p - begin;
                              Pack<width> slope[D];
                              const Pack<width> shift = stencil.template valueAndGradient<Width>(rows, slope);
                              for (int i = 0; i < D; ++i)
                              {
                                at.shift[i][l] = shift[i];
                                for (int j = 0; j < D; ++j)
                                  at.gradient[i * D + j][l] = slope[j][i];
                              }
                              if constexpr (D == 2)
                                strainAround(p, l, stencil, at);
                            });
  }

  /// Hoop strain of axisymmetric scenes. The particle moves by the velocity of its centre, so that its hoop
  /// stretch is exactly the ratio of its radii.
  template <class Stencil>
  KOKKOS_FORCEINLINE_FUNCTION void strainAround(int p, int l, const Stencil& stencil, Lanes& at) const
  {
    at.gradient[4][l] = 0.0;
    if constexpr (Stencil::mayHaveHoop)
      if (stencil.hasHoop())
      {
        const Pack<width> rate = stencil.template hoopValue<Width, width>(nodal.data());
        const double radius = particles.position(p, 0);
        at.gradient[4][l] = rate[0];
        for (int i = 0; i < D; ++i)
          at.shift[i][l] = radius * rate[i];
      }
  }
};

template <class Heat, int D>
BundleMotion<D, Heat> bundleMotion(State<D>& state, bool strain, bool move)
{
  BundleMotion<D, Heat> kernel;
  if constexpr (Heat::on)
  {
    kernel.heat.tables = state.materials.thermo;
    kernel.heat.temperature = state.particles.scalar(fields::temperature);
    kernel.heat.internal = state.particles.scalar(fields::internalEnergy);
    if (state.particles.has(fields::firstFraction))
      kernel.heat.firstFraction = state.particles.scalar(fields::firstFraction);
    kernel.heat.isothermal = state.method.equilibrium();
    if (state.method.heldTemperatures && strain)
      kernel.heat.supplied = View<double*>("rhegma::heatThatHolds", state.particles.size());
  }
  kernel.materials = state.materials.device;
  kernel.axes = state.bodies.axes;
  kernel.material = state.particles.integer(fields::material);
  kernel.body = state.particles.integer(fields::body);
  kernel.position = state.particles.template real<D>(fields::position);
  kernel.velocity = state.particles.template real<D>(fields::velocity);
  kernel.edge = state.particles.template real<D>(fields::edge);
  kernel.frame = CellFrame<D>(state);
  if (kernel.frame.undeformed)
    kernel.displacement = state.particles.template real<D>(fields::displacement);
  kernel.boxes = state.method.shape == ShapeKind::Gimp && !kernel.frame.undeformed;
  if (kernel.boxes)
    kernel.box = state.particles.template real<D>(fields::box);
  kernel.deformation = state.particles.template real<gradientSize<D>>(fields::deformation);
  kernel.stress = state.particles.template real<symmetricSize<D>>(fields::stress);
  if (state.particles.has(fields::history))
    kernel.history = state.particles.table(fields::history);
  if (state.particles.has(fields::rate))
    kernel.rate = state.particles.table(fields::rate);
  if (state.particles.has(fields::level))
    kernel.level = state.particles.integer(fields::level);
  // Particles must be inside of their blocks, and of the domain, where these are in the next step.
  kernel.grid = state.mesh.grid;
  kernel.grid.translate(state.mesh.ahead);
  kernel.blocks = state.mesh.blocks;
  kernel.dt = state.clock.dt;
  kernel.strainTime = state.clock.strainPass.fraction * state.clock.dt;
  kernel.largestBox = 0.5 * state.mesh.grid.spacing;
  kernel.strain = strain;
  kernel.move = move;
  return kernel;
}

/// Records the heat that holds temperatures. \param supplied of the particles [J/m3]; may be empty
template <int D>
void recordSupply(State<D>& state, const View<double*>& supplied)
{
  if (supplied.extent(0) == 0)
    return;
  const auto volume = state.particles.scalar(fields::volume);
  double heat = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::heatThatHolds", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum) { sum += volume(p) * supplied(p); }, heat);
  state.energy.heat += heat;
}

template <class Heat, int D, int Width, class Connect>
double strainAndMoveWith(State<D>& state, const Connect& connect, const View<double* [Width]>& nodal,
                         bool strain, bool move)
{
  const StrainAndMove<D, Connect, Width, Heat> kernel{connect, nodal,
                                                      bundleMotion<Heat>(state, strain, move)};
  double fastest = 0.0;
  Kokkos::parallel_reduce(strain ? "rhegma::strainAndMove" : "rhegma::move",
                          Kokkos::RangePolicy<ExecSpace>(0, state.mesh.blocks.numBundles), kernel,
                          Kokkos::Max<double>(fastest));
  if constexpr (Heat::on)
    recordSupply(state, kernel.particles.heat.supplied);
  const auto strays = Rhegma::onHost(state.mesh.blocks.strays);
  if (strays(0) != 0)
    state.particles.sorted = false;
  if (strays(1) != 0 && state.failure.empty())
    state.failure = "a particle left the domain; enlarge the domain (Domain > Lower Corner, Upper Corner) or "
                    "end the run earlier";
  return fastest;
}

template <class Heat, int D>
double strainAndMoveAll(State<D>& state, StrainVelocity velocity, bool strain, bool move)
{
  double fastest = 0.0;
  withStraining(
      state,
      [&](const auto& connect)
      {
        fastest = velocity == StrainVelocity::Projection
                      ? strainAndMoveWith<Heat, D>(state, connect, state.mesh.nodes.projection, strain, move)
                      : strainAndMoveWith<Heat, D>(state, connect, state.mesh.nodes.motion, strain, move);
      });
  return fastest;
}

/// The same with heat.
template <int D>
double strainAndMoveHeated(State<D>& state, StrainVelocity velocity, bool strain, bool move);

} // namespace detail

} // namespace Rhegma
