#include "transfer/Gather.hpp"

#include "material/Materials.hpp"
#include "transfer/Box.hpp"
#include "transfer/ParticleViews.hpp"

#include <limits>

namespace Rhegma
{

namespace
{

template <int D, class Connect>
struct GatherVelocity
{
  Connect connect;
  View<double * [Nodes<D>::motionWidth]> motion;
  BorrowedView<double* [D]> velocity;
  double dt, pic;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const
  {
    double sum[Nodes<D>::motionWidth] = {};
    connect.visit(p,
                  [&](int node, double weight, const double*)
                  {
                    for (int k = 0; k < Nodes<D>::motionWidth; ++k)
                      sum[k] += weight * motion(node, k);
                  });
    for (int d = 0; d < D; ++d)
      velocity(p, d) = (1.0 - pic) * (velocity(p, d) + dt * sum[Nodes<D>::accelerationAt + d]) + pic * sum[d];
  }
};

/// Strain and move of one particle, both by one nodal velocity.
template <int D, class Connect, int Width>
struct StrainAndMove
{
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
  Grid<D> grid;
  Blocks<D> blocks;
  View<int[2]> strays;
  double dt, largestBox;
  bool strain, move, boxes;

  KOKKOS_INLINE_FUNCTION void operator()(int p, double& fastest) const
  {
    double gradient[D][D] = {};
    double shift[D] = {};
    connect.visit(p,
                  [&](int node, double weight, const double* slope)
                  {
                    for (int i = 0; i < D; ++i)
                    {
                      const double v = nodal(node, i);
                      shift[i] += weight * v;
                      for (int j = 0; j < D; ++j)
                        gradient[i][j] += slope[j] * v;
                    }
                  });
    if (move)
      moveBy(p, shift);
    if (!strain)
    {
      if (boxes)
        updateBox<D>(axes, body(p), &edge(p, 0), &deformation(p, 0), largestBox, &box(p, 0));
      return;
    }
    if (rate.extent(1) > 0)
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
          rate(p, i * D + j) = gradient[i][j];

    double increment[gradientSize<D>];
    double F[gradientSize<D>];
    bool good = true;
    if constexpr (D == 2)
      increment[4] = 1.0;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        increment[i * D + j] = dt * gradient[i][j] + (i == j ? 1.0 : 0.0);
        good = good && std::isfinite(gradient[i][j]);
      }
    if constexpr (D == 2)
      F[4] = deformation(p, 4);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        double sum = 0.0;
        for (int k = 0; k < D; ++k)
          sum += increment[i * D + k] * deformation(p, k * D + j);
        F[i * D + j] = sum;
      }
    const Properties& law = materials(material(p));
    double* own = history.extent(1) > 0 ? &history(p, 0) : nullptr;
    good = updateStress<D>(law, F, &stress(p, 0), own) && good;
    for (int k = 0; k < gradientSize<D>; ++k)
      deformation(p, k) = F[k];
    // Where the step goes on after the strain (USF) its mass, force and velocity need one and the same box.
    if (boxes && move)
      updateBox<D>(axes, body(p), &edge(p, 0), F, largestBox, &box(p, 0));
    double speed = 0.0;
    for (int d = 0; d < D; ++d)
      speed += velocity(p, d) * velocity(p, d);
    speed = std::sqrt(speed) + waveSpeed<D>(law, F, own);
    if (!good || !std::isfinite(speed))
      speed = std::numeric_limits<double>::infinity();
    fastest = speed > fastest ? speed : fastest;
  }

  KOKKOS_INLINE_FUNCTION void moveBy(int p, const double* shift) const
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
    {
      x[d] = position(p, d) + dt * shift[d];
      position(p, d) = x[d];
    }
    // Every thread that finds one writes the same value.
    if (!grid.inside(x))
      Kokkos::atomic_exchange(&strays(1), 1);
    else if (hasStrayed(grid, blocks, p, &position(p, 0)))
      Kokkos::atomic_exchange(&strays(0), 1);
  }
};

template <int D, int Width, class Connect>
double strainAndMoveWith(State<D>& state, const Connect& connect, const View<double* [Width]>& nodal,
                         bool strain, bool move)
{
  StrainAndMove<D, Connect, Width> work;
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
  work.grid = state.grid;
  work.blocks = state.blocks;
  work.strays = View<int[2]>("rhegma::strays");
  work.dt = state.dt;
  work.largestBox = 0.5 * state.grid.spacing;
  work.strain = strain;
  work.move = move;
  double fastest = 0.0;
  Kokkos::parallel_reduce(strain ? "rhegma::strainAndMove" : "rhegma::move",
                          Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()), work,
                          Kokkos::Max<double>(fastest));
  const auto strays = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, work.strays);
  if (strays(0) != 0)
    state.sorted = false;
  if (strays(1) != 0 && state.trouble.empty())
    state.trouble =
        "a particle left the domain; make the Domain larger or stop the run before (Domain > Lower Corner, "
        "Upper Corner)";
  return fastest;
}

} // namespace

template <int D>
void gatherVelocity(State<D>& state)
{
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const GatherVelocity<D, Connect> work{connect, state.nodes.motion,
                                                           state.particles.template real<D>(fields::velocity),
                                                           state.dt, state.picFraction};
                     Kokkos::parallel_for("rhegma::gatherVelocity",
                                          Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()), work);
                   });
}

template <int D>
void clearProjection(State<D>& state)
{
  const Nodes<D> nodes = state.nodes;
  Kokkos::parallel_for(
      "rhegma::clearProjection", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        for (int d = 0; d < D; ++d)
          nodes.projection(n, d) = 0.0;
      });
}

template <int D>
void finishProjection(State<D>& state)
{
  const Nodes<D> nodes = state.nodes;
  Kokkos::parallel_for(
      "rhegma::finishProjection", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        const double mass = nodes.sums(n, Nodes<D>::massAt);
        for (int d = 0; d < D; ++d)
          nodes.projection(n, d) = mass > 0.0 ? nodes.projection(n, d) / mass : 0.0;
      });
}

template <int D>
double strainAndMove(State<D>& state, StrainVelocity velocity, bool strain, bool move)
{
  double fastest = 0.0;
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     fastest =
                         velocity == StrainVelocity::Projection
                             ? strainAndMoveWith<D>(state, connect, state.nodes.projection, strain, move)
                             : strainAndMoveWith<D>(state, connect, state.nodes.motion, strain, move);
                   });
  return fastest;
}

template void gatherVelocity(State<2>&);
template void gatherVelocity(State<3>&);
template void clearProjection(State<2>&);
template void clearProjection(State<3>&);
template void finishProjection(State<2>&);
template void finishProjection(State<3>&);
template double strainAndMove(State<2>&, StrainVelocity, bool, bool);
template double strainAndMove(State<3>&, StrainVelocity, bool, bool);

} // namespace Rhegma
