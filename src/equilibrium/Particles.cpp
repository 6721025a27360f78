#include "equilibrium/Particles.hpp"

#include "equilibrium/ParticleRows.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::equilibrium
{

namespace
{

template <int D, class Connect>
struct ForceBlock
{
  Connect connect;
  ParticleData<D> data;
  Values force;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      RowsOfParticle<D, typename Connect::Slopes> rows;
      double G[gradientSize<D>], P[gradientSize<D>];
      data.see(connect, p, rows, G);
      if (!trialStress<D>(data.before(p), G, P))
      {
        Kokkos::atomic_exchange(&data.bad(), 1);
        continue;
      }
      data.pullBack(p, P);
      for (int a = 0; a < rows.count; ++a)
        for (int i = 0; i < D; ++i)
        {
          double f = 0.0;
          for (int j = 0; j < D; ++j)
            f += P[i * D + j] * rows.slopes(a)(i, j);
          if (D == 2 && i == 0)
            f += P[gradientSize<D> - 1] * rows.slopes(a).hoop;
          force(D * rows.row[a] + i) -= data.volume(p) * f;
        }
    }
  }
};

template <int D, class Connect>
struct StoredForceBlock
{
  Connect connect;
  ParticleData<D> data; ///< without a displacement
  BorrowedView<double * [symmetricSize<D>]> stress;
  Values force;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      RowsOfParticle<D, typename Connect::Slopes> rows;
      double G[gradientSize<D>], T[D * D];
      data.see(connect, p, rows, G);
      data.frame.stress(p, &stress(p, 0), T);
      const double hoop = stress(p, normalIndex<D>(2)) * data.frame.hoopFactor(p);
      for (int a = 0; a < rows.count; ++a)
        for (int i = 0; i < D; ++i)
        {
          double f = 0.0;
          for (int j = 0; j < D; ++j)
            f += T[i * D + j] * rows.slopes(a)(i, j);
          if (D == 2 && i == 0)
            f += hoop * rows.slopes(a).hoop;
          force(D * rows.row[a] + i) -= data.volume(p) * f;
        }
    }
  }
};

template <int D, class Connect>
struct StiffnessBlock
{
  Connect connect;
  ParticleData<D> data;
  RowGraph graph;
  StiffnessBlocks stiffness;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      RowsOfParticle<D, typename Connect::Slopes> rows;
      double G[gradientSize<D>], A[gradientSize<D>][gradientSize<D>];
      data.see(connect, p, rows, G);
      if (!trialTangent<D>(data.before(p), G, A, data.components()))
      {
        Kokkos::atomic_exchange(&data.bad(), 1);
        continue;
      }
      data.pullBackBoth(p, A);
      for (int b = 0; b < rows.count; ++b)
        addColumn(rows, b, data.volume(p), A);
    }
  }

  KOKKOS_INLINE_FUNCTION void addColumn(const RowsOfParticle<D, typename Connect::Slopes>& rows, int b,
                                        double volume,
                                        const double (&A)[gradientSize<D>][gradientSize<D>]) const
  {
    double M[gradientSize<D>][D]; // V0 A . slope of b, of (i, j) and k
    const int count = data.components();
    const bool around = D == 2 && count > D * D;
    for (int r = 0; r < count; ++r)
      for (int k = 0; k < D; ++k)
      {
        M[r][k] = 0.0;
        for (int l = 0; l < D; ++l)
          M[r][k] += volume * A[r][k * D + l] * rows.slopes(b)(k, l);
        if (around && k == 0)
          M[r][k] += volume * A[r][gradientSize<D> - 1] * rows.slopes(b).hoop;
      }
    for (int a = 0; a < rows.count; ++a)
    {
      double* const block =
          &stiffness(D * D * static_cast<std::size_t>(graph.find(rows.row[a], rows.row[b])));
      for (int i = 0; i < D; ++i)
        for (int k = 0; k < D; ++k)
        {
          double sum = 0.0;
          for (int j = 0; j < D; ++j)
            sum += rows.slopes(a)(i, j) * M[i * D + j][k];
          if (around && i == 0)
            sum += rows.slopes(a).hoop * M[gradientSize<D> - 1][k];
          block[i * D + k] += sum;
        }
    }
  }
};

} // namespace

template <int D>
bool subtractInternalForce(const State<D>& state, const RowGraph& graph, const Values& displacement,
                           const Values& force)
{
  const ParticleData<D> data(state, graph, displacement);
  withStraining(state,
                [&](const auto& connect)
                {
                  using Connect = std::decay_t<decltype(connect)>;
                  forEachBlock("rhegma::equilibrium::force", state.mesh.blocks,
                               ForceBlock<D, Connect>{connect, data, force});
                });
  return onHost(data.bad)() == 0;
}

template <int D>
bool addStiffness(const State<D>& state, const RowGraph& graph, const Values& displacement,
                  const ClippedBoxes<D>& boxes, const StiffnessBlocks& stiffness)
{
  const ParticleData<D> data(state, graph, displacement);
  withStraining(state,
                [&](const auto& ofParticles)
                {
                  const auto connect = boxes.in(ofParticles);
                  using Connect = std::decay_t<decltype(connect)>;
                  forEachBlock("rhegma::equilibrium::stiffness", state.mesh.blocks,
                               StiffnessBlock<D, Connect>{connect, data, graph, stiffness});
                });
  return onHost(data.bad)() == 0;
}

template <int D>
void subtractStoredForce(const State<D>& state, const RowGraph& graph, const Values& force)
{
  const ParticleData<D> data(state, graph, Values("rhegma::equilibrium::none", D * graph.rows));
  const auto stress = state.particles.template real<symmetricSize<D>>(fields::stress);
  withStraining(state,
                [&](const auto& connect)
                {
                  using Connect = std::decay_t<decltype(connect)>;
                  forEachBlock("rhegma::equilibrium::storedForce", state.mesh.blocks,
                               StoredForceBlock<D, Connect>{connect, data, stress, force});
                });
}

template void subtractStoredForce(const State<2>&, const RowGraph&, const Values&);
template void subtractStoredForce(const State<3>&, const RowGraph&, const Values&);
template bool subtractInternalForce(const State<2>&, const RowGraph&, const Values&, const Values&);
template bool subtractInternalForce(const State<3>&, const RowGraph&, const Values&, const Values&);
template bool addStiffness(const State<2>&, const RowGraph&, const Values&, const ClippedBoxes<2>&,
                           const StiffnessBlocks&);
template bool addStiffness(const State<3>&, const RowGraph&, const Values&, const ClippedBoxes<3>&,
                           const StiffnessBlocks&);

} // namespace Rhegma::equilibrium
