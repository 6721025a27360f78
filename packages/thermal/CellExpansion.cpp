#include "thermal/CellExpansion.hpp"

#include "state/Subdomain.hpp"
#include "thermal/Insulators.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::thermal
{

namespace
{

/// Corrects the deformation gradient of a particle for a gradient of temperature.
template <int D, class Connect>
struct Correction
{
  Connect connect;
  ThermoTables tables;
  BorrowedView<int*> material;
  BorrowedView<double*> temperature;
  BorrowedView<double* [D]> position;
  BorrowedView<double * [gradientSize<D>]> deformation;
  Nodes<D> nodes;
  NodePositions<D> positions;
  bool undeformed; ///< whether the cells are: slopes are along axes of the undeformed body

  Correction(const State<D>& state, const Connect& with)
      : connect(with),
        tables(state.materials.thermo),
        material(state.particles.integer(fields::material)),
        temperature(state.particles.scalar(fields::temperature)),
        position(state.particles.template real<D>(fields::position)),
        deformation(state.particles.template real<gradientSize<D>>(fields::deformation)),
        nodes(state.mesh.nodes),
        positions(nodePositions(state)),
        undeformed(state.method.totalLagrangian)
  {
  }

  KOKKOS_INLINE_FUNCTION double expansion(int p) const
  {
    return freeExpansion(ThermoPoint(tables, material(p), temperature(p)));
  }

  /// \param g gradient of temperature, or of its change [K/m]
  KOKKOS_INLINE_FUNCTION void operator()(int p, const double (&g)[D]) const
  {
    double missed[D][D] = {}; // M_ij [K]
    connect.visitStraining(p,
                           [&](int node, double, const typename Connect::Slopes& slopes)
                           {
                             const Vector<D> x = positions(latticeNode(nodes, node));
                             double r[D], along = 0.0, square = 0.0;
                             for (int d = 0; d < D; ++d)
                             {
                               r[d] = x[d] - position(p, d);
                               along += g[d] * r[d];
                               square += r[d] * r[d];
                             }
                             for (int i = 0; i < D; ++i)
                               for (int j = 0; j < D; ++j)
                                 missed[i][j] += slopes(i, j) * (r[i] * along - 0.5 * g[i] * square);
                           });
    const double half = 0.5 * expansion(p);
    double F[D * D];
    for (int k = 0; k < D * D; ++k)
      F[k] = deformation(p, k);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        for (int k = 0; k < D; ++k)
          deformation(p, i * D + j) -= half * (undeformed ? F[i * D + k] * (missed[k][j] + missed[j][k])
                                                          : (missed[i][k] + missed[k][i]) * F[k * D + j]);
  }

  /// Whether F of a particle is 1, but for the thickness in plane stress.
  KOKKOS_INLINE_FUNCTION bool isUnstrained(int p) const
  {
    bool unstrained = true;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        unstrained = unstrained && deformation(p, i * D + j) == (i == j ? 1.0 : 0.0);
    return unstrained;
  }
};

template <int D, class Connect>
struct ChangeOfNodesBlock
{
  Correction<D, Connect> correct;
  HeatNodes<D> heat;
  ParticleFlux<D> conducts;
  BorrowedView<double* [D]> gradient;
  View<double* [D]> before;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      if (correct.expansion(p) == 0.0 || isLeftOut(correct.connect, heat, conducts, p))
        continue;
      double g[D], size = 0.0;
      for (int d = 0; d < D; ++d)
      {
        g[d] = gradient(p, d) - before(p, d);
        size += std::fabs(g[d]);
      }
      if (size > 0.0)
        correct(p, g);
    }
  }
};

template <int D, class Connect>
struct StartBlock
{
  Correction<D, Connect> correct;
  View<double* [D]> gradient;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      double g[D];
      for (int d = 0; d < D; ++d)
        g[d] = gradient(p, d);
      if (correct.isUnstrained(p))
        correct(p, g);
    }
  }
};

} // namespace

bool anyExpands(const ThermoTables& tables)
{
  const auto knots = onHost(tables.knot);
  bool any = false;
  for (std::size_t k = 0; k < knots.extent(0); ++k)
    any = any || knots(k).expansion != 0.0;
  return any;
}

template <int D>
void correctExpansion(State<D>& state, const HeatNodes<D>& nodes, const View<double* [D]>& before)
{
  withStraining(state,
                [&](const auto& connect)
                {
                  using Connect = std::decay_t<decltype(connect)>;
                  const ChangeOfNodesBlock<D, Connect> block{
                      Correction<D, Connect>(state, connect), nodes, particleFlux(state),
                      state.particles.template real<D>(fields::temperatureGradient), before};
                  forEachBlock("rhegma::thermal::correctExpansion", state.mesh.blocks, block);
                });
}

template <int D>
void correctExpansion(State<D>& state, const View<double* [D]>& gradient)
{
  withStraining(state,
                [&](const auto& connect)
                {
                  using Connect = std::decay_t<decltype(connect)>;
                  const StartBlock<D, Connect> block{Correction<D, Connect>(state, connect), gradient};
                  forEachBlock("rhegma::thermal::expansionAtStart", state.mesh.blocks, block);
                });
}

template void correctExpansion(State<2>&, const HeatNodes<2>&, const View<double* [2]>&);
template void correctExpansion(State<3>&, const HeatNodes<3>&, const View<double* [3]>&);
template void correctExpansion(State<2>&, const View<double* [2]>&);
template void correctExpansion(State<3>&, const View<double* [3]>&);

} // namespace Rhegma::thermal
