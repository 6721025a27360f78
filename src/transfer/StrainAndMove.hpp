#pragma once
/// Strain and move of particles, with and without heat: templates for Gather.cpp and HeatedGather.cpp, two
/// files so that what one does can't change how the other is compiled.

#include "transfer/Box.hpp"
#include "transfer/Gather.hpp"
#include "transfer/LaneHeat.hpp"
#include "transfer/ParticleViews.hpp"

#include <limits>

namespace Rhegma
{

namespace detail
{

/// Where nobody carries heat.
struct NoHeat
{
  static constexpr bool on = false;
};

/// Where particles carry heat: their internal energy, and the temperature that follows from it.
struct ParticleHeat
{
  static constexpr bool on = true;
  ThermoTables tables;
  BorrowedView<double*> temperature, internal;
  BorrowedView<double*> firstFraction; ///< of the step that the force of its start acts; empty: all of it
};

/// Strain and move of the particles of one bundle, both by one nodal velocity.
template <int D, class Connect, int Width, class Heat>
struct StrainAndMove
{
  static constexpr int width = D == 2 ? 2 : 4;
  using Lanes = StrainLanes<D>;

  Connect connect;
  View<double* [Width]> nodal;
  View<Properties*> materials;
  View<double* [D][D]> axes;
  BorrowedView<int*> material, body;
  BorrowedView<double*[D]> position, velocity, edge, box;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<double * [symmetricSize<D>]> stress;
  BorrowedView<double**> history;
  BorrowedView<double**> rate; ///< velocity gradient, where somebody asked for it
  BorrowedView<int*> level;    ///< how often each particle was split; empty where none is
  Grid<D> grid;
  Blocks<D> blocks;
  Heat heat;
  double dt, strainTime, largestBox;
  bool strain, move, boxes;

  KOKKOS_INLINE_FUNCTION void operator()(int bundle, double& fastest) const
  {
    const int begin = blocks.bundleFirst(bundle), end = blocks.bundleFirst(bundle + 1);
    Lanes at;
    fromNodes(begin, end, at);
    if (move)
      moveLanes(begin, end, blocks.bundleBlock(bundle), at);
    loadDeformation(begin, end, at);
    if (strain)
      strainLanes(begin, end, at, fastest);
    // Where the step goes on after the strain (USF) its mass, force and velocity need one and the same box.
    if (boxes && move)
      updateBoxes(begin, end, at);
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
                            });
  }

  KOKKOS_INLINE_FUNCTION void moveLanes(int begin, int end, int block, const Lanes& at) const
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

  KOKKOS_INLINE_FUNCTION void loadDeformation(int begin, int end, Lanes& at) const
  {
    for (int k = 0; k < gradientSize<D>; ++k)
      for (int p = begin; p < end; ++p)
        at.F[k][p - begin] = deformation(p, k);
  }

  KOKKOS_INLINE_FUNCTION void strainLanes(int begin, int end, Lanes& at, double& fastest) const
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
      at.speed[p - begin] = std::sqrt(square);
    }
    if constexpr (Heat::on)
      heatByLaw(begin, end, at);
    else
      stressByLaw(begin, end, at);
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
    // Mostly all are of one material.
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
        own.share[p - begin] = heat.firstFraction.extent(0) > 0 ? heat.firstFraction(p) : 1.0;
      }
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
      // The box is of where the particle is now, of which USAVG has strained half.
      if (strainTime < dt)
        strained<D>(at, p - begin, dt - strainTime, F);
      const double largest = level.extent(0) > 0 ? largestBox / (1 << level(p)) : largestBox;
      updateBox<D>(axes, body(p), &edge(p, 0), F, largest, &box(p, 0));
    }
  }
};

template <class Heat, int D, int Width, class Connect>
double strainAndMoveWith(State<D>& state, const Connect& connect, const View<double* [Width]>& nodal,
                         bool strain, bool move)
{
  StrainAndMove<D, Connect, Width, Heat> work;
  if constexpr (Heat::on)
  {
    work.heat.tables = state.materials.thermo;
    work.heat.temperature = state.particles.scalar(fields::temperature);
    work.heat.internal = state.particles.scalar(fields::internalEnergy);
    if (state.particles.has(fields::firstFraction))
      work.heat.firstFraction = state.particles.scalar(fields::firstFraction);
  }
  work.connect = connect;
  work.nodal = nodal;
  work.materials = state.materials.device;
  work.axes = state.bodies.axes;
  work.material = state.particles.integer(fields::material);
  work.body = state.particles.integer(fields::body);
  work.position = state.particles.template real<D>(fields::position);
  work.velocity = state.particles.template real<D>(fields::velocity);
  work.edge = state.particles.template real<D>(fields::edge);
  work.boxes = state.method.shape == ShapeKind::Gimp;
  if (work.boxes)
    work.box = state.particles.template real<D>(fields::box);
  work.deformation = state.particles.template real<gradientSize<D>>(fields::deformation);
  work.stress = state.particles.template real<symmetricSize<D>>(fields::stress);
  if (state.particles.has(fields::history))
    work.history = state.particles.table(fields::history);
  if (state.particles.has(fields::rate))
    work.rate = state.particles.table(fields::rate);
  if (state.particles.has(fields::level))
    work.level = state.particles.integer(fields::level);
  work.grid = state.mesh.grid;
  work.blocks = state.mesh.blocks;
  work.dt = state.clock.dt;
  work.strainTime = state.clock.strainPass.share * state.clock.dt;
  work.largestBox = 0.5 * state.mesh.grid.spacing;
  work.strain = strain;
  work.move = move;
  double fastest = 0.0;
  Kokkos::parallel_reduce(strain ? "rhegma::strainAndMove" : "rhegma::move",
                          Kokkos::RangePolicy<ExecSpace>(0, state.mesh.blocks.numBundles), work,
                          Kokkos::Max<double>(fastest));
  const auto strays = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.mesh.blocks.strays);
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
  withConnectivity(
      state,
      [&](const auto& connect)
      {
        fastest = velocity == StrainVelocity::Projection
                      ? strainAndMoveWith<Heat, D>(state, connect, state.mesh.nodes.projection, strain, move)
                      : strainAndMoveWith<Heat, D>(state, connect, state.mesh.nodes.motion, strain, move);
      });
  return fastest;
}

/// The same where particles carry heat.
template <int D>
double strainAndMoveHeated(State<D>& state, StrainVelocity velocity, bool strain, bool move);

} // namespace detail

} // namespace Rhegma
