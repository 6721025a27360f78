#pragma once
/// Strain and move of particles, with and without heat: templates for Gather.cpp and HeatedGather.cpp, two
/// files so that what one does can't change how the other is compiled.

#include "material/HistoryRoom.hpp"
#include "material/ThermoLaw.hpp"
#include "transfer/Box.hpp"
#include "transfer/Gather.hpp"
#include "transfer/ParticleViews.hpp"

#include <limits>

namespace Rhegma
{

namespace detail
{

/// What the lanes of a bundle hold; component by component, so that a loop over lanes reads and writes
/// neighbours.
template <int D>
struct StrainLanes
{
  double gradient[D * D][lanes];    ///< of the straining velocity, row by row [1/s]
  double shift[D][lanes];           ///< velocity of the particles' places [m/s]
  double F[gradientSize<D>][lanes]; ///< old, then new
  double tau[symmetricSize<D>][lanes];
  double speed[lanes]; ///< of the particle, then with the wave speed on top [m/s]
};

/// F <- (I + dt L) F, stress and wave speed of the lanes from .. to - 1, all of one material.
template <int D>
struct StressOfLanes
{
  const Properties& properties;
  StrainLanes<D>& at;
  double* history; ///< of the first lane; null for laws without one
  int historyWidth;
  double dt;
  int from, to;

  template <class Law, int, Plane P>
  KOKKOS_INLINE_FUNCTION void run() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (int l = from; l < to; ++l)
    {
      double F[gradientSize<D>], tau[symmetricSize<D>];
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
        {
          double change = 0.0;
          for (int k = 0; k < D; ++k)
            change += at.gradient[i * D + k][l] * at.F[k * D + j][l];
          F[i * D + j] = at.F[i * D + j][l] + dt * change;
        }
      if constexpr (D == 2)
        F[4] = at.F[4][l];
      // Finite only if every component is.
      const bool finite = determinant<D>(F) < infinity;
      double* const own = history == nullptr ? nullptr : history + l * historyWidth;
      const bool good = Law::template stress<D, P>(properties, F, tau, own);
      const double wave = Law::template waveSpeed<D, P>(properties, F, own);
      at.speed[l] = good && finite ? at.speed[l] + wave : infinity;
      for (int k = 0; k < gradientSize<D>; ++k)
        at.F[k][l] = F[k];
      for (int k = 0; k < symmetricSize<D>; ++k)
        at.tau[k][l] = tau[k];
    }
  }
};

/// What the lanes of a bundle hold of heat.
template <int D>
struct HeatLanes
{
  double temperature[lanes]; ///< [K]
  double internal[lanes];    ///< [J/m3]
};

/// F <- (I + dt L) F, stress, internal energy, temperature and wave speed of the lanes from .. to - 1, all of
/// one material none of whose properties is a table.
///
/// The internal energy takes up the work of the mean of old and new stress, which is what the nodes' forces
/// do, so that no energy is lost or made whatever the law; the temperature is what that energy leaves beside
/// the elastic one (ThermoLaw.hpp). A stress that lags behind its temperature would excite short waves; so
/// the stress is found at the temperature to which straining brings the material at small strain, and what
/// the energy says beyond that, of higher order in strain or of plastic work, waits for the next step.
template <int D>
struct HeatOfLanes
{
  const Properties& properties;
  const ThermoMaterial& material;
  const ThermoKnot& knot;
  StrainLanes<D>& at; ///< its stress is the old one on entry
  HeatLanes<D>& heat;
  double* history; ///< of the first lane; null for laws without one
  int historyWidth;
  double dt;
  int from, to;

  /// Work of a stress over the step [J/m3].
  KOKKOS_FORCEINLINE_FUNCTION double work(const double* tau, int l) const
  {
    double power = 0.0;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        power += tau[symmetricIndex<D>(i, j)] * at.gradient[i * D + j][l];
    return dt * power;
  }

  template <class Law, int, Plane P>
  KOKKOS_INLINE_FUNCTION void run() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double alpha = knot.expansion, T0 = material.reference, capacity = knot.capacity;
    // Change of the trace of stress with that of strain: 3 K, in plane stress E / (1 - nu).
    const double stiffness =
        P == Plane::Stress ? 2.0 * (properties.planeLambda + properties.mu) : 3.0 * properties.bulk;
    const double cooling = dt * alpha * stiffness / capacity, push = 3.0 * properties.bulk * alpha;
    const double adiabatic = push * push / (capacity * properties.density);
    for (int l = from; l < to; ++l)
    {
      double F[gradientSize<D>], own[gradientSize<D>], tau[symmetricSize<D>], stretching = 0.0;
      for (int k = 0; k < symmetricSize<D>; ++k)
        tau[k] = at.tau[k][l];
      const double before = work(tau, l);
      for (int i = 0; i < D; ++i)
      {
        stretching += at.gradient[i * D + i][l];
        for (int j = 0; j < D; ++j)
        {
          double change = 0.0;
          for (int k = 0; k < D; ++k)
            change += at.gradient[i * D + k][l] * at.F[k * D + j][l];
          F[i * D + j] = at.F[i * D + j][l] + dt * change;
        }
      }
      if constexpr (D == 2)
        F[4] = at.F[4][l];
      const bool finite = determinant<D>(F) < infinity;
      double T = heat.temperature[l] * (1.0 - cooling * stretching);
      const double theta = 1.0 + alpha * (T - T0), inverse = 1.0 / theta;
      for (int k = 0; k < gradientSize<D>; ++k)
        own[k] = inverse * F[k];
      double* const memory = history == nullptr ? nullptr : history + l * historyWidth;
      const bool good = Law::template stress<D, P>(properties, own, tau, memory);
      if constexpr (P == Plane::Stress)
        F[4] = theta * own[4];
      double has = Law::template energy<D, P>(properties, own, memory) + T * alpha * inverse * trace<D>(tau) +
                   (T - T0) * (capacity + 0.5 * material.coupling * (T + T0));
      if (historyWidth > 0)
        has += (1.0 - material.plasticHeat) * dissipatedEnergy<D>(properties, memory);
      const double energy = heat.internal[l] + 0.5 * (before + work(tau, l));
      const double wave = Law::template waveSpeed<D, P>(properties, own, memory);
      heat.internal[l] = energy;
      const double after = T + (energy - has) / capacity;
      heat.temperature[l] = after;
      at.speed[l] =
          good && finite && after > 0.0 ? at.speed[l] + std::sqrt(wave * wave + after * adiabatic) : infinity;
      for (int k = 0; k < gradientSize<D>; ++k)
        at.F[k][l] = F[k];
      for (int k = 0; k < symmetricSize<D>; ++k)
        at.tau[k][l] = tau[k];
    }
  }
};

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
  double dt, largestBox;
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
      withLaw<D>(law.kind, law.plane,
                 StressOfLanes<D>{law, at, memory, historyWidth, dt, p - begin, next - begin});
      p = next;
    }
  }

  /// Work of a stress over the step, per undeformed volume [J/m3].
  KOKKOS_INLINE_FUNCTION double work(const double* tau, int l, const Lanes& at) const
  {
    double power = 0.0;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        power += tau[symmetricIndex<D>(i, j)] * at.gradient[i * D + j][l];
    return dt * power;
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
          withLaw<D>(law.kind, law.plane,
                     HeatOfLanes<D>{law, thermal, heat.tables.knot(thermal.first), at, own, memory,
                                    historyWidth, dt, p - begin, next - begin});
        else
          for (int q = p; q < next; ++q)
            heatAndStress(q, q - begin, at, own);
        p = next;
      }
      for (int p = begin; p < end; ++p)
      {
        heat.temperature(p) = own.temperature[p - begin];
        heat.internal(p) = own.internal[p - begin];
      }
    }
  }

  /// The same as HeatOfLanes for a particle whose properties are tables: with two looks at its law, the
  /// stress that of the temperature in the end.
  KOKKOS_INLINE_FUNCTION void heatAndStress(int p, int l, Lanes& at, HeatLanes<D>& own) const
  {
    if constexpr (Heat::on)
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      double F[gradientSize<D>], tau[symmetricSize<D>], wave = 0.0, has = 0.0;
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
        {
          double change = 0.0;
          for (int k = 0; k < D; ++k)
            change += at.gradient[i * D + k][l] * at.F[k * D + j][l];
          F[i * D + j] = at.F[i * D + j][l] + dt * change;
        }
      if constexpr (D == 2)
        F[4] = at.F[4][l];
      const bool finite = determinant<D>(F) < infinity;
      const int number = material(p), room = static_cast<int>(history.extent(1));
      const Properties& law = materials(number);
      double& T = own.temperature[l];
      const double before = work(&stress(p, 0), l, at);
      double trial[historyRoom];
      for (int k = 0; k < room; ++k)
        trial[k] = history(p, k);
      const ThermoPoint start(heat.tables, number, T);
      bool good = withLaw<D>(law.kind, law.plane, ThermoStress{start, T, F, tau, trial, has, wave});
      const double energy = own.internal[l] + 0.5 * (before + work(tau, l, at));
      T += (energy - has) / start.capacity();
      if (start.material.coupled)
      {
        const ThermoPoint end(heat.tables, number, T);
        for (int k = 0; k < room; ++k)
          trial[k] = history(p, k);
        good = good && withLaw<D>(law.kind, law.plane, ThermoStress{end, T, F, tau, trial, has, wave});
      }
      own.internal[l] += 0.5 * (before + work(tau, l, at));
      for (int k = 0; k < room; ++k)
        history(p, k) = trial[k];
      at.speed[l] = good && finite && T > 0.0 ? at.speed[l] + wave : infinity;
      for (int k = 0; k < gradientSize<D>; ++k)
        at.F[k][l] = F[k];
      for (int k = 0; k < symmetricSize<D>; ++k)
        at.tau[k][l] = tau[k];
    }
  }

  KOKKOS_INLINE_FUNCTION void updateBoxes(int begin, int end, const Lanes& at) const
  {
    for (int p = begin; p < end; ++p)
    {
      double F[gradientSize<D>];
      for (int k = 0; k < gradientSize<D>; ++k)
        F[k] = at.F[k][p - begin];
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
    work.heat.tables = state.thermo;
    work.heat.temperature = state.particles.scalar(fields::temperature);
    work.heat.internal = state.particles.scalar(fields::internalEnergy);
  }
  work.connect = connect;
  work.nodal = nodal;
  work.materials = state.materials;
  work.axes = state.bodyAxes;
  work.material = state.particles.integer(fields::material);
  work.body = state.particles.integer(fields::body);
  work.position = state.particles.template real<D>(fields::position);
  work.velocity = state.particles.template real<D>(fields::velocity);
  work.edge = state.particles.template real<D>(fields::edge);
  work.boxes = state.shape == ShapeKind::Gimp;
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
  work.grid = state.grid;
  work.blocks = state.blocks;
  work.dt = state.dt;
  work.largestBox = 0.5 * state.grid.spacing;
  work.strain = strain;
  work.move = move;
  double fastest = 0.0;
  Kokkos::parallel_reduce(strain ? "rhegma::strainAndMove" : "rhegma::move",
                          Kokkos::RangePolicy<ExecSpace>(0, state.blocks.numBundles), work,
                          Kokkos::Max<double>(fastest));
  const auto strays = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.blocks.strays);
  if (strays(0) != 0)
    state.sorted = false;
  if (strays(1) != 0 && state.trouble.empty())
    state.trouble =
        "a particle left the domain; make the Domain larger or stop the run before (Domain > Lower Corner, "
        "Upper Corner)";
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
                      ? strainAndMoveWith<Heat, D>(state, connect, state.nodes.projection, strain, move)
                      : strainAndMoveWith<Heat, D>(state, connect, state.nodes.motion, strain, move);
      });
  return fastest;
}

/// The same where particles carry heat.
template <int D>
double strainAndMoveHeated(State<D>& state, StrainVelocity velocity, bool strain, bool move);

} // namespace detail

} // namespace Rhegma
