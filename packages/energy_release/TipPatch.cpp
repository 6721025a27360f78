#include "energy_release/TipPatch.hpp"

#include "energy_release/CrackLine.hpp"
#include "parallel/Subdomain.hpp"
#include "transfer/TreeStencil.hpp"

#include <Teuchos_SerialDenseMatrix.hpp>
#include <Teuchos_SerialSpdDenseSolver.hpp>
#include <Teuchos_SerialSymDenseMatrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace Rhegma::energy_release
{

namespace
{

/// Numbers of one particle that the host needs: place, displacement, mass, volume, four stresses.
constexpr int rowWidth = 10;

View<int*> listParticles(const State<2>& state, const Vector<2>& centre, double radius)
{
  const int n = state.particles.size();
  const auto position = state.particles.real<2>(fields::position);
  const View<int*> all("rhegma::patchParticles", n);
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::listPatchParticles", Kokkos::RangePolicy<ExecSpace>(0, n),
      KOKKOS_LAMBDA(const int p, int& at, const bool final) {
        const double x = position(p, 0) - centre[0], y = position(p, 1) - centre[1];
        if (x * x + y * y > radius * radius)
          return;
        if (final)
          all(at) = p;
        ++at;
      },
      count);
  View<int*> list("rhegma::patchList", count);
  Kokkos::deep_copy(list, Kokkos::subview(all, std::make_pair(0, count)));
  return list;
}

View<double* [rowWidth]> gatherRows(const State<2>& state, const View<int*>& list)
{
  const int n = static_cast<int>(list.extent(0));
  const auto position = state.particles.real<2>(fields::position);
  const auto reference = state.particles.real<2>(fields::reference);
  const auto mass = state.particles.scalar(fields::mass);
  const auto volume = state.particles.scalar(fields::volume);
  const auto stress = state.particles.real<symmetricSize<2>>(fields::stress);
  View<double* [rowWidth]> row("rhegma::patchRows", n);
  Kokkos::parallel_for(
      "rhegma::gatherPatch", Kokkos::RangePolicy<ExecSpace>(0, n), KOKKOS_LAMBDA(const int i) {
        const int p = list(i);
        for (int d = 0; d < 2; ++d)
        {
          row(i, d) = position(p, d);
          row(i, 2 + d) = position(p, d) - reference(p, d);
        }
        row(i, 4) = mass(p);
        row(i, 5) = volume(p);
        for (int k = 0; k < symmetricSize<2>; ++k)
          row(i, 6 + k) = stress(p, k);
      });
  return row;
}

template <ShapeKind S>
StencilTable<2> patchStencils(const State<2>& state, const View<int*>& list)
{
  const int n = static_cast<int>(list.extent(0));
  StencilTable<2> table;
  table.reserve(n);
  const TreeStencils<2, S> stencils(state.grid, state.tree, table);
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
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, some);
  for (int i = 0; i < n; ++i)
    named[i] = host(i);
  return named;
}

/// Numbers of a particle as ranks tell them to each other.
constexpr int toldWidth = 13 + 4 * PatchParticle::capacity;

void tell(const PatchParticle& p, std::vector<double>& numbers)
{
  numbers.insert(numbers.end(), {p.place[0], p.place[1], p.displacement[0], p.displacement[1], p.mass,
                                 p.density, p.fromFront, p.force[0][0], p.force[0][1], p.force[1][0],
                                 p.force[1][1], double(p.side), double(p.count)});
  for (int k = 0; k < PatchParticle::capacity; ++k)
  {
    const bool has = k < p.count;
    numbers.insert(numbers.end(), {has ? double(p.node[k]) : 0.0, has ? p.weight[k] : 0.0,
                                   has ? p.slope[k][0] : 0.0, has ? p.slope[k][1] : 0.0});
  }
}

PatchParticle hear(const double* at)
{
  PatchParticle p;
  p.place = {{at[0], at[1]}};
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
    const double* const of = at + 13 + 4 * k;
    p.node[k] = static_cast<int>(of[0]);
    p.weight[k] = of[1];
    p.slope[k] = {{of[2], of[3]}};
  }
  return p;
}

/// The particles of all ranks, on every rank.
std::vector<PatchParticle> ofAllRanks(const Ranks& ranks, const std::vector<PatchParticle>& own)
{
  std::vector<double> numbers;
  numbers.reserve(own.size() * toldWidth);
  for (const PatchParticle& p : own)
    tell(p, numbers);
  numbers = ranks.gatherOnAll(numbers);
  std::vector<PatchParticle> all;
  for (std::size_t at = 0; at < numbers.size(); at += toldWidth)
    all.push_back(hear(&numbers[at]));
  return all;
}

} // namespace

std::vector<PatchParticle> particlesAround(const State<2>& state, const CrackFront<2>& front, double radius)
{
  const View<int*> list = listParticles(state, front.position, radius);
  const auto row = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, gatherRows(state, list));
  const StencilTable<2> table = state.shape == ShapeKind::Linear
                                    ? patchStencils<ShapeKind::Linear>(state, list)
                                    : patchStencils<ShapeKind::Gimp>(state, list);
  const auto count = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, table.count);
  const auto node = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, table.node);
  const auto weight = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, table.weight);
  const auto slope = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, table.slope);
  const std::vector<int> named = namedSides(state, list);
  const CrackLine line(state.cracks, front);
  const WholeNodes whole(state);

  std::vector<PatchParticle> particles(list.extent(0));
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    PatchParticle& p = particles[i];
    for (int d = 0; d < 2; ++d)
    {
      p.place[d] = row(i, d);
      p.displacement[d] = row(i, 2 + d);
      for (int e = 0; e < 2; ++e)
        p.force[d][e] = -row(i, 5) * row(i, 6 + symmetricIndex<2>(d, e));
    }
    p.mass = row(i, 4);
    p.density = row(i, 4) / row(i, 5);
    p.fromFront = std::numeric_limits<double>::infinity();
    for (const CrackFront<2>& other : state.cracks.fronts)
      p.fromFront = std::min(p.fromFront, norm(p.place - other.position));
    if (named[i] == front.crack + 1)
      p.side = 1;
    else if (named[i] == -front.crack - 1)
      p.side = -1;
    else
      p.side = line.side(p.place);
    p.count = 0;
    for (int k = 0; k < count(i); ++k)
      if (weight(i, k) > 0.0)
      {
        p.node[p.count] = whole(node(i, k));
        p.weight[p.count] = weight(i, k);
        p.slope[p.count++] = {{slope(i, k, 0), slope(i, k, 1)}};
      }
  }
  return state.subdomain ? ofAllRanks(state.ranks, particles) : particles;
}

std::vector<int> ownNodesAround(const State<2>& state, const Vector<2>& centre, double radius)
{
  const Grid<2>& grid = state.grid;
  const auto foreign = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.nodes.foreign);
  int first[2], last[2];
  for (int d = 0; d < 2; ++d)
  {
    first[d] = std::max(0, static_cast<int>(std::floor(grid.inCells(centre[d] - radius, d))));
    last[d] = std::min(grid.cells[d], static_cast<int>(std::ceil(grid.inCells(centre[d] + radius, d))));
  }
  std::vector<int> nodes;
  for (int i = first[0]; i <= last[0]; ++i)
    for (int j = first[1]; j <= last[1]; ++j)
    {
      const int at[2] = {i, j}, n = grid.nodeIndex(at);
      if (foreign(n) == 0)
        nodes.push_back(n);
    }
  const auto place = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.tree.finePlace);
  for (int k = 0; k < state.tree.numFine; ++k)
    if (foreign(grid.numNodes + k) == 0 && std::fabs(place(k, 0) - centre[0]) <= radius &&
        std::fabs(place(k, 1) - centre[1]) <= radius)
      nodes.push_back(grid.numNodes + k);
  return nodes;
}

SplitNodes::SplitNodes(const State<2>& state, const CrackFront<2>& front, double radius)
    : side_(Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.nodeSide)),
      many_(static_cast<bool>(state.subdomain)),
      places_(state),
      front_(front)
{
  if (!many_ || side_.extent(0) == 0)
    return;
  std::vector<double> nodes;
  for (const int n : ownNodesAround(state, front.position, radius))
    if (std::abs(side_(n)) == front.crack + 1)
      nodes.push_back(places_(n));
  for (const double n : state.ranks.gatherOnAll(nodes))
    split_.insert(static_cast<int>(n));
}

bool SplitNodes::operator()(int node) const
{
  if (many_ && side_.extent(0) > 0)
    return split_.count(node) > 0;
  if (node < static_cast<int>(side_.extent(0)))
    return side_(node) == front_.crack + 1 || side_(node) == -front_.crack - 1;
  return dot(places_.placeOf(node) - front_.position, front_.direction) < 0.0;
}

RecoveryMatrix consistentMatrix() { return {1.0e-3, 0.0, std::numeric_limits<double>::infinity(), 0.0, 0}; }

RecoveryMatrix lumpedMatrix() { return {1.0, 0.0, std::numeric_limits<double>::infinity(), 0.0, 0}; }

namespace
{

/// Matrix and right side of the least squares.
struct Normal
{
  std::vector<std::pair<int, int>> nodes; ///< and their sides (0 where a node is not split), in order
  std::vector<std::array<int, PatchParticle::capacity>> at; ///< places of each particle's nodes among them
  Teuchos::SerialSymDenseMatrix<int, double> coupling;      ///< sum of theta m N N^T, lower triangle
  std::vector<double> own;                                  ///< sum of (1 - theta) m N
  std::vector<double> lumped;                               ///< row sums of both
  Teuchos::SerialDenseMatrix<int, double> right;

  Normal(const std::vector<PatchParticle>& particles, const SplitNodes& split);
  int size() const { return static_cast<int>(nodes.size()); }
  void listNodes(const std::vector<PatchParticle>& particles, const SplitNodes& split);
  void couple(const std::vector<PatchParticle>& particles, const RecoveryMatrix& choice, double fullCell);
};

Normal::Normal(const std::vector<PatchParticle>& particles, const SplitNodes& split)
{
  listNodes(particles, split);
  lumped.assign(size(), 0.0);
  right.shape(size(), 2);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const PatchParticle& p = particles[i];
    for (int k = 0; k < p.count; ++k)
    {
      lumped[at[i][k]] += p.mass * p.weight[k];
      for (int d = 0; d < 2; ++d)
        right(at[i][k], d) += p.mass * p.weight[k] * p.displacement[d];
    }
  }
}

/// Nodes of a patch are near each other in their numbering, so a table over it is smaller than a tree.
void Normal::listNodes(const std::vector<PatchParticle>& particles, const SplitNodes& split)
{
  int lowest = std::numeric_limits<int>::max(), highest = -1;
  for (const PatchParticle& p : particles)
    for (int k = 0; k < p.count; ++k)
    {
      lowest = std::min(lowest, p.node[k]);
      highest = std::max(highest, p.node[k]);
    }
  if (highest < 0)
    return;
  std::vector<std::array<int, 3>> slot(highest - lowest + 1, {-1, -1, -1}); // by side + 1
  std::vector<signed char> splits(slot.size(), -1);
  at.resize(particles.size());
  const auto slotOf = [&](const PatchParticle& p, int k) -> int&
  {
    const int n = p.node[k] - lowest;
    if (splits[n] < 0)
      splits[n] = split(p.node[k]) ? 1 : 0;
    return slot[n][splits[n] != 0 ? p.side + 1 : 1];
  };
  for (const PatchParticle& p : particles)
    for (int k = 0; k < p.count; ++k)
      slotOf(p, k) = 0;
  for (std::size_t n = 0; n < slot.size(); ++n)
    for (int side = -1; side <= 1; ++side)
      if (slot[n][side + 1] == 0)
      {
        slot[n][side + 1] = size();
        nodes.emplace_back(lowest + static_cast<int>(n), side);
      }
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (int k = 0; k < particles[i].count; ++k)
      at[i][k] = slotOf(particles[i], k);
}

/// theta: 1 up to the radius, a cubic with flat ends over the edge, 0 beyond.
double consistentShare(double fromFront, const RecoveryMatrix& choice)
{
  const double beyond = fromFront - choice.radius;
  if (beyond <= 0.0)
    return 1.0;
  if (!(beyond < choice.edge))
    return 0.0;
  const double s = beyond / choice.edge;
  return 1.0 - s * s * (3.0 - 2.0 * s);
}

void Normal::couple(const std::vector<PatchParticle>& particles, const RecoveryMatrix& choice,
                    double fullCell)
{
  coupling.shape(size());
  own.assign(size(), 0.0);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const PatchParticle& p = particles[i];
    double theta = consistentShare(p.fromFront, choice);
    for (int k = 0; k < p.count; ++k)
      if (lumped[at[i][k]] < choice.smallestNode * p.density * fullCell)
        theta = 0.0;
    for (int k = 0; k < p.count; ++k)
    {
      own[at[i][k]] += (1.0 - theta) * p.mass * p.weight[k];
      for (int l = 0; l < p.count; ++l)
        if (at[i][l] <= at[i][k])
          coupling(at[i][k], at[i][l]) += theta * p.mass * p.weight[k] * p.weight[l];
    }
  }
}

/// M_eps u = right, factored.
void solve(Normal& normal, double eps, Teuchos::SerialDenseMatrix<int, double>& solution)
{
  normal.coupling *= 1.0 - eps;
  for (int i = 0; i < normal.size(); ++i)
    normal.coupling(i, i) += (1.0 - eps) * normal.own[i] + eps * normal.lumped[i];
  Teuchos::SerialSpdDenseSolver<int, double> solver;
  solver.setMatrix(Teuchos::rcpFromRef(normal.coupling));
  solver.setVectors(Teuchos::rcpFromRef(solution), Teuchos::rcpFromRef(normal.right));
  solver.factorWithEquilibration(true);
  if (solver.factor() != 0 || solver.solve() != 0)
    throw std::runtime_error("the displacement of the nodes around a crack front can't be recovered: their "
                             "mass matrix is not positive definite");
}

/// The sum of (1 - L^-1 M)^k L^-1 right over k below `terms`, L the row sums.
void sumSeries(const Normal& normal, int terms, Teuchos::SerialDenseMatrix<int, double>& solution)
{
  const int n = normal.size();
  Teuchos::SerialDenseMatrix<int, double> term(n, 2), image(n, 2);
  for (int i = 0; i < n; ++i)
    for (int d = 0; d < 2; ++d)
      solution(i, d) = term(i, d) = normal.right(i, d) / normal.lumped[i];
  for (int k = 1; k < terms; ++k)
  {
    image.multiply(Teuchos::LEFT_SIDE, 1.0, normal.coupling, term, 0.0);
    for (int i = 0; i < n; ++i)
      for (int d = 0; d < 2; ++d)
      {
        term(i, d) -= (image(i, d) + normal.own[i] * term(i, d)) / normal.lumped[i];
        solution(i, d) += term(i, d);
      }
  }
}

} // namespace

NodeDisplacement recoverDisplacement(const std::vector<PatchParticle>& particles, const SplitNodes& split,
                                     const RecoveryMatrix& choice, double fullCell)
{
  Normal normal(particles, split);
  NodeDisplacement result;
  if (normal.size() == 0)
    return result;
  Teuchos::SerialDenseMatrix<int, double> solution(normal.size(), 2);
  const bool rowSums = choice.lumpedShare >= 1.0;
  if (!rowSums)
    normal.couple(particles, choice, fullCell);
  if (rowSums || choice.terms > 0)
    sumSeries(normal, rowSums ? 1 : choice.terms, solution);
  else
    solve(normal, choice.lumpedShare, solution);
  for (int i = 0; i < normal.size(); ++i)
    result.emplace_hint(result.end(), normal.nodes[i], Vector<2>{{solution(i, 0), solution(i, 1)}});
  return result;
}

} // namespace Rhegma::energy_release
