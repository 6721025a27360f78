#include "energy_release/ParticlesAroundTip.hpp"

#include "energy_release/CrackSide.hpp"
#include "energy_release/WholeNodes.hpp"
#include "state/BodyGroup.hpp"
#include "state/CellFrame.hpp"
#include "state/ParticlePlace.hpp"
#include "state/Subdomain.hpp"
#include "transfer/BlocksInReach.hpp"
#include "transfer/TreeStencil.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma::energy_release
{

namespace
{

/// Weight up to which a particle does not touch a node: a box whose edge lies on a node, as boxes of
/// undeformed cells do, reaches it by the rounding e of positions in cells, with a weight of order e^2.
/// Rounding differs between ranks, and a node without mass has no displacement.
constexpr double noWeight = 1e-20;

/// Numbers of one particle that the host needs: position, displacement, mass, volume, four stresses.
constexpr int rowWidth = 10;

/// The particles that a crack may cut within a radius of a position, in their order.
View<int*> listParticles(const State<2>& state, int crack, const Vector<2>& centre, double radius)
{
  const ParticlesOfGroup own = particlesOfCrack(state, crack);
  const auto position = state.particles.real<2>(fields::position);
  BlocksInReach<2> blocks;
  blocks.find(state, {boxAround(centre, radius)});
  const View<int* [2]> range = blocks.ranges();
  const auto isIn = KOKKOS_LAMBDA(const int p)
  {
    const double x = position(p, 0) - centre[0], y = position(p, 1) - centre[1];
    return x * x + y * y <= radius * radius && own.hold(p);
  };
  const View<int*> first("rhegma::patchParticlesOfBlocks", blocks.count() + 1);
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::countPatchParticles", Kokkos::RangePolicy<ExecSpace>(0, blocks.count()),
      KOKKOS_LAMBDA(const int b, int& at, const bool final) {
        if (final)
          first(b) = at;
        for (int p = range(b, 0); p < range(b, 1); ++p)
          at += isIn(p) ? 1 : 0;
      },
      count);
  const View<int*> list("rhegma::patchList", count);
  Kokkos::parallel_for(
      "rhegma::listPatchParticles", Kokkos::RangePolicy<ExecSpace>(0, blocks.count()),
      KOKKOS_LAMBDA(const int b) {
        int at = first(b);
        for (int p = range(b, 0); p < range(b, 1); ++p)
          if (isIn(p))
            list(at++) = p;
      });
  return list;
}

View<double* [rowWidth]> gatherRows(const State<2>& state, const View<int*>& list)
{
  const int n = static_cast<int>(list.extent(0));
  const ParticlePlace<2> place(state.particles);
  const CellFrame<2> frame(state);
  const auto mass = state.particles.scalar(fields::mass);
  const auto volume = state.particles.scalar(fields::volume);
  const auto stress = state.particles.real<symmetricSize<2>>(fields::stress);
  View<double* [rowWidth]> row("rhegma::patchRows", n);
  Kokkos::parallel_for(
      "rhegma::gatherPatch", Kokkos::RangePolicy<ExecSpace>(0, n), KOKKOS_LAMBDA(const int i) {
        const int p = list(i);
        for (int d = 0; d < 2; ++d)
        {
          row(i, d) = place.position(p, d);
          row(i, 2 + d) = place.moved(p, d);
        }
        row(i, 4) = mass(p);
        row(i, 5) = volume(p);
        double T[4];
        frame.stress(p, &stress(p, 0), T);
        for (int k = 0; k < 4; ++k)
          row(i, 6 + k) = T[k];
      });
  return row;
}

template <ShapeKind S>
StencilTable<2> patchStencils(const State<2>& state, const View<int*>& list)
{
  const int n = static_cast<int>(list.extent(0));
  StencilTable<2> table;
  table.reserve(n, state.method.shear == ShearStrain::AtCellCentres);
  const TreeStencils<2, S> stencils(state.mesh.grid, state.mesh.tree, table);
  const auto position = state.particles.real<2>(fields::position);
  BorrowedView<double* [2]> box;
  if (S == ShapeKind::Gimp)
    box = state.particles.real<2>(fields::box);
  Kokkos::parallel_for(
      "rhegma::patchStencils", Kokkos::RangePolicy<ExecSpace>(0, n), KOKKOS_LAMBDA(const int i) {
        Vector<2> x, half;
        for (int d = 0; d < 2; ++d)
        {
          x[d] = position(list(i), d);
          half[d] = S == ShapeKind::Gimp ? box(list(i), d) : 0.0;
        }
        stencils.write(i, x, half);
      });
  return table;
}

std::vector<int> namedSides(const State<2>& state, const View<int*>& list)
{
  const int n = static_cast<int>(list.extent(0));
  std::vector<int> named(n, 0);
  if (!state.particles.has(fields::side))
    return named;
  const auto side = state.particles.integer(fields::side);
  const View<int*> some("rhegma::patchSides", n);
  Kokkos::parallel_for(
      "rhegma::gatherPatchSides", Kokkos::RangePolicy<ExecSpace>(0, n),
      KOKKOS_LAMBDA(const int i) { some(i) = side(list(i)); });
  const auto host = onHost(some);
  for (int i = 0; i < n; ++i)
    named[i] = host(i);
  return named;
}

/// Numbers of a particle that ranks exchange.
constexpr int reportedWidth = 13 + 6 * ParticleAroundTip::capacity;

void report(const ParticleAroundTip& p, std::vector<double>& numbers)
{
  numbers.insert(numbers.end(), {p.position[0], p.position[1], p.displacement[0], p.displacement[1], p.mass,
                                 p.density, p.fromFront, p.force[0][0], p.force[0][1], p.force[1][0],
                                 p.force[1][1], double(p.side), double(p.count)});
  for (int k = 0; k < ParticleAroundTip::capacity; ++k)
  {
    const bool has = k < p.count;
    numbers.insert(numbers.end(), {has ? double(p.node[k]) : 0.0, has ? p.weight[k] : 0.0});
    for (int c = 0; c < 4; ++c)
      numbers.push_back(has ? p.slope[k][c / 2][c % 2] : 0.0);
  }
}

ParticleAroundTip hear(const double* at)
{
  ParticleAroundTip p;
  p.position = {{at[0], at[1]}};
  p.displacement = {{at[2], at[3]}};
  p.mass = at[4];
  p.density = at[5];
  p.fromFront = at[6];
  for (int k = 0; k < 4; ++k)
    p.force[k / 2][k % 2] = at[7 + k];
  p.side = static_cast<int>(at[11]);
  p.count = static_cast<int>(at[12]);
  for (int k = 0; k < p.count; ++k)
  {
    const double* const of = at + 13 + 6 * k;
    p.node[k] = static_cast<int>(of[0]);
    p.weight[k] = of[1];
    for (int c = 0; c < 4; ++c)
      p.slope[k][c / 2][c % 2] = of[2 + c];
  }
  return p;
}

/// The particles of all ranks, on every rank.
std::vector<ParticleAroundTip> ofAllRanks(const Ranks& ranks, const std::vector<ParticleAroundTip>& own)
{
  std::vector<double> numbers;
  numbers.reserve(own.size() * reportedWidth);
  for (const ParticleAroundTip& p : own)
    report(p, numbers);
  numbers = ranks.gatherOnAll(numbers);
  std::vector<ParticleAroundTip> all;
  for (std::size_t at = 0; at < numbers.size(); at += reportedWidth)
    all.push_back(hear(&numbers[at]));
  return all;
}

} // namespace

std::vector<ParticleAroundTip> particlesAround(const State<2>& state, const CrackFront<2>& front,
                                               double radius)
{
  const View<int*> list = listParticles(state, front.crack, front.position, radius);
  const auto row = onHost(gatherRows(state, list));
  const StencilTable<2> table = state.method.shape == ShapeKind::Linear
                                    ? patchStencils<ShapeKind::Linear>(state, list)
                                    : patchStencils<ShapeKind::Gimp>(state, list);
  const auto count = onHost(table.count);
  const auto node = onHost(table.node);
  const auto weight = onHost(table.weight);
  const auto slope = onHost(table.slope);
  const auto gradient = onHost(table.gradient); // empty where all components have the same slopes
  const std::vector<int> named = namedSides(state, list);
  const CrackSide line(state.cracks, front);
  const WholeNodes whole(state);

  std::vector<ParticleAroundTip> particles(list.extent(0));
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    ParticleAroundTip& p = particles[i];
    for (int d = 0; d < 2; ++d)
    {
      p.position[d] = row(i, d);
      p.displacement[d] = row(i, 2 + d);
      for (int e = 0; e < 2; ++e)
        p.force[d][e] = -row(i, 5) * row(i, 6 + 2 * d + e);
    }
    p.mass = row(i, 4);
    p.density = row(i, 4) / row(i, 5);
    p.fromFront = std::numeric_limits<double>::infinity();
    for (const CrackFront<2>& other : state.cracks.fronts)
      p.fromFront = std::min(p.fromFront, norm(p.position - other.position));
    if (named[i] == front.crack + 1)
      p.side = 1;
    else if (named[i] == -front.crack - 1)
      p.side = -1;
    else
      p.side = line.side(p.position);
    p.count = 0;
    for (int k = 0; k < count(i); ++k)
      if (weight(i, k) > noWeight)
      {
        p.node[p.count] = whole(node(i, k));
        p.weight[p.count] = weight(i, k);
        for (int d = 0; d < 2; ++d)
          for (int e = 0; e < 2; ++e)
            p.slope[p.count][d][e] = table.hasGradients() ? gradient(i, k, 2 * e + d) : slope(i, k, e);
        ++p.count;
      }
  }
  return state.mesh.subdomain ? ofAllRanks(state.ranks, particles) : particles;
}

} // namespace Rhegma::energy_release
