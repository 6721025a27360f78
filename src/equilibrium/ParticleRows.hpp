#pragma once
/// The rows that a particle sees and its state at a trial displacement, for kernels over particles.

#include "equilibrium/Particles.hpp"
#include "equilibrium/TrialStress.hpp"
#include "state/CellFrame.hpp"

namespace Rhegma::equilibrium
{

/// Largest number of nodes that a particle sees.
template <int D>
constexpr int mostNodes = stencilCapacity<D> < 27 ? 27 : stencilCapacity<D>;

/// The rows of a particle's nodes, and the slopes of their functions [1/m].
template <int D, class Slopes>
struct RowsOfParticle
{
  int count = 0;
  int row[mostNodes<D>];
  double slope[mostNodes<D>][Slopes::size];
  double hoop[D == 2 ? mostNodes<D> : 1]; ///< of axisymmetric scenes, else zero (ComponentSlopes)

  /// Of node a.
  KOKKOS_FORCEINLINE_FUNCTION Slopes slopes(int a) const { return {slope[a], D == 2 ? hoop[a] : 0.0}; }

  /// Finds those of a particle. \param rowOf of nodes \param u D numbers a row \param spacing of the cells
  /// [m] \param G becomes the gradient of u
  template <class Connect>
  KOKKOS_INLINE_FUNCTION void see(const Connect& connect, int p, const View<int*>& rowOf,
                                  const View<double*>& u, double spacing, double (&G)[gradientSize<D>])
  {
    for (double& g : G)
      g = 0.0;
    count = 0;
    connect.visitStraining(p,
                           [&](int node, double weight, const Slopes& at)
                           {
                             const int r = rowOf(node);
                             if (r < 0 || !counts(weight, at.of, at.size, spacing))
                               return;
                             row[count] = r;
                             for (int k = 0; k < at.size; ++k)
                               slope[count][k] = at.of[k];
                             if constexpr (D == 2)
                             {
                               hoop[count] = at.hoop;
                               G[4] += u(D * r) * at.hoop;
                             }
                             for (int i = 0; i < D; ++i)
                               for (int j = 0; j < D; ++j)
                                 G[i * D + j] += u(D * r + i) * at(i, j);
                             ++count;
                           });
  }
};

/// What kernels over particles read for a trial displacement.
template <int D>
struct ParticleData
{
  View<int*> rowOf;
  Values displacement;
  View<Properties*> materials;
  BorrowedView<int*> material;
  BorrowedView<double*> volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  CellFrame<D> frame;
  BorrowedView<double**> history; ///< empty where no law has one
  ThermoTables heat;
  BorrowedView<double*> temperature; ///< empty without heat
  View<int> bad;                     ///< not 0 where a particle is inverted
  double dt;
  double spacing;    ///< of the cells [m]
  bool axisymmetric; ///< whether radial displacements strain the hoop

  ParticleData(const State<D>& state, const RowGraph& graph, const Values& u)
      : rowOf(graph.rowOf),
        displacement(u),
        materials(state.materials.device),
        material(state.particles.integer(fields::material)),
        volume(state.particles.scalar(fields::volume)),
        deformation(state.particles.template real<gradientSize<D>>(fields::deformation)),
        frame(state),
        heat(state.materials.thermo),
        bad("rhegma::invertedParticles"),
        dt(state.clock.dt),
        spacing(state.mesh.grid.spacing),
        axisymmetric(state.method.axisymmetric)
  {
    if (state.particles.has(fields::history))
      history = state.particles.table(fields::history);
    if (!heat.empty())
      temperature = state.particles.scalar(fields::temperature);
  }

  KOKKOS_INLINE_FUNCTION ParticleBefore<D> before(int p) const
  {
    const int width = static_cast<int>(history.extent(1));
    return {materials(material(p)),
            &deformation(p, 0),
            width > 0 ? &history(p, 0) : nullptr,
            width,
            dt,
            heat,
            material(p),
            heat.empty() ? 0.0 : temperature(p)};
  }

  /// \param G becomes the gradient of the displacement with respect to the positions before the step
  template <class Connect>
  KOKKOS_INLINE_FUNCTION void see(const Connect& connect, int p,
                                  RowsOfParticle<D, typename Connect::Slopes>& rows,
                                  double (&G)[gradientSize<D>]) const
  {
    rows.see(connect, p, rowOf, displacement, spacing, G);
    if (!frame.undeformed)
      return;
    frame.pushForward(p, G);
    if constexpr (D == 2)
      G[4] *= frame.hoopFactor(p);
  }

  /// Components of G that change with the displacement.
  KOKKOS_INLINE_FUNCTION int components() const { return axisymmetric ? gradientSize<D> : D * D; }

  /// A stress from that at the start of the step to that of the cells.
  KOKKOS_INLINE_FUNCTION void pullBack(int p, double (&P)[gradientSize<D>]) const
  {
    if (!frame.undeformed)
      return;
    frame.pullBack(p, P);
    if constexpr (D == 2)
      P[4] *= frame.hoopFactor(p);
  }

  /// Both slopes of a tangent from those at the start of the step to those of the cells.
  KOKKOS_INLINE_FUNCTION void pullBackBoth(int p, double (&A)[gradientSize<D>][gradientSize<D>]) const
  {
    if (!frame.undeformed)
      return;
    const int count = components();
    for (int r = 0; r < count; ++r)
      pullBack(p, A[r]);
    for (int c = 0; c < count; ++c)
    {
      double column[gradientSize<D>] = {};
      for (int r = 0; r < count; ++r)
        column[r] = A[r][c];
      pullBack(p, column);
      for (int r = 0; r < count; ++r)
        A[r][c] = column[r];
    }
  }
};

} // namespace Rhegma::equilibrium
