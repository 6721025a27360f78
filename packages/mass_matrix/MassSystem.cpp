#include "mass_matrix/MassSystem.hpp"

#include "base/SmallLoops.hpp"
#include "mass_matrix/MassRows.hpp"
#include "mass_matrix/ParticleMass.hpp"
#include "mass_matrix/RowLists.hpp"
#include "state/Subdomain.hpp"

namespace Rhegma::mass_matrix
{

namespace
{

template <int D, ShapeKind S, bool Stored>
void addParticles(const State<D>& state, const Unlumping& unlumping, const MassSystem<D>& system)
{
  AssembleBlock<D, S, Stored> add;
  add.connect = connectivity<D, S, Stored>(state);
  add.system = system;
  add.parent = state.mesh.nodes.parent;
  add.first = state.mesh.blocks.first;
  add.corner = state.mesh.blocks.corner;
  add.mass = state.particles.scalar(fields::mass);
  add.volume = state.particles.scalar(fields::volume);
  add.fractionAt = consistentFraction(unlumping, system);
  add.nodeFraction = state.mesh.tree.nodeVolume;
  add.numLattice = state.mesh.nodes.numLattice;
  double cell = D == 2 ? state.method.thickness : 1.0;
  for (int d = 0; d < D; ++d)
    cell *= state.mesh.grid.spacing;
  add.smallest = unlumping.smallestNode * cell;
  add.consistentFraction = 1.0 - unlumping.lumpedFraction;
  // Blocks of one colour share no node.
  for (int colour = 0; colour < Blocks<D>::colours; ++colour)
    Kokkos::parallel_for("rhegma::mass::assemble",
                         Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>(
                             state.mesh.blocks.colourStart[colour], state.mesh.blocks.colourStart[colour + 1],
                             Kokkos::ChunkSize(1)),
                         add);
}

} // namespace

template <int D>
void assemble(const State<D>& state, const Unlumping& unlumping, MassSystem<D>& system)
{
  const bool stored = state.stored.count > 0;
  do
  {
    beginRows(state, unlumping, system);
    if (state.method.shape == ShapeKind::Linear)
      stored ? addParticles<D, ShapeKind::Linear, true>(state, unlumping, system)
             : addParticles<D, ShapeKind::Linear, false>(state, unlumping, system);
    else
      stored ? addParticles<D, ShapeKind::Gimp, true>(state, unlumping, system)
             : addParticles<D, ShapeKind::Gimp, false>(state, unlumping, system);
  } while (growLists(system));
  finishRows(state, system);
}

template <int D>
void multiply(const MassSystem<D>& system, const double* x, double* y, const double* weight)
{
  withReach(system,
            [&](auto reach)
            {
              constexpr int W = MassSystem<D>::width;
              const MassSystem<D> s = system;
              parallelForSmall(
                  "rhegma::mass::multiply", 0, s.rowCapacity, KOKKOS_LAMBDA(const int row) {
                    const bool inside = row >= s.first && row < s.last;
                    const Pack<W> sum =
                        inside ? rowTimes<D, decltype(reach)::value>(s, row, x) : Pack<W>::zero();
                    double* const to = y + W * row;
                    sum.store(to);
                    if (weight != nullptr)
                      for (int d = 0; d < W; ++d)
                        to[d] = weight[W * row + d] == 0.0 ? 0.0 : to[d];
                  });
            });
}

template <int D>
void multiplyWhole(const State<D>& state, const MassSystem<D>& system, const double* x, double* y,
                   const double* weight)
{
  if (!state.mesh.subdomain)
    return multiply(system, x, y, weight);
  constexpr int W = MassSystem<D>::width;
  multiply(system, x, y);
  sumOverRanks(state, y, W, 0, D, system.rowOf);
  if (weight == nullptr)
    return;
  parallelForSmall(
      "rhegma::mass::mask", system.first * W, system.last * W, KOKKOS_LAMBDA(const int i) {
        if (weight[i] == 0.0)
          y[i] = 0.0;
      });
}

template <int D>
double bytesPerRow(ShapeKind shape, bool list, bool refined)
{
  const int span = shape == ShapeKind::Linear ? 3 : 5;
  const int lines = D == 2 ? span : span * span, slots = lines * span;
  // The band and its lines; the lumped mass and marks; and vectors: nine of the solves, seven of Belos.
  return slots * sizeof(double) + lines * sizeof(int) + sizeof(double) + 3 * sizeof(int) +
         16.0 * MassSystem<D>::width * sizeof(double) +
         (list ? listCapacityOf<D>(slots, refined) * double(sizeof(double) + sizeof(int)) : 0.0);
}

template void assemble(const State<2>&, const Unlumping&, MassSystem<2>&);
template void assemble(const State<3>&, const Unlumping&, MassSystem<3>&);
template void multiply(const MassSystem<2>&, const double*, double*, const double*);
template void multiply(const MassSystem<3>&, const double*, double*, const double*);
template void multiplyWhole(const State<2>&, const MassSystem<2>&, const double*, double*, const double*);
template void multiplyWhole(const State<3>&, const MassSystem<3>&, const double*, double*, const double*);
template double bytesPerRow<2>(ShapeKind, bool, bool);
template double bytesPerRow<3>(ShapeKind, bool, bool);

} // namespace Rhegma::mass_matrix
