#include "energy_release/Recovery.hpp"

#include "energy_release/SkylineMatrix.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace Rhegma::energy_release
{

RecoveryMatrix consistentMatrix() { return {1.0e-3, 0.0, std::numeric_limits<double>::infinity(), 0.0, 0}; }

RecoveryMatrix lumpedMatrix() { return {1.0, 0.0, std::numeric_limits<double>::infinity(), 0.0, 0}; }

namespace
{

/// Matrix and right side of the least squares.
struct Normal
{
  std::vector<std::pair<int, int>> nodes; ///< and their sides (0 where a node is not split), in order
  std::vector<std::array<int, ParticleAroundTip::capacity>>
      at;                     ///< positions of each particle's nodes among them
  SkylineMatrix coupling;     ///< sum of theta m N N^T
  std::vector<double> own;    ///< sum of (1 - theta) m N
  std::vector<double> lumped; ///< row sums of both
  std::vector<SkylineMatrix::Pair> right;

  Normal(const std::vector<ParticleAroundTip>& particles, const SplitNodes& split);
  int size() const { return static_cast<int>(nodes.size()); }
  void listNodes(const std::vector<ParticleAroundTip>& particles, const SplitNodes& split);
  void couple(const std::vector<ParticleAroundTip>& particles, const RecoveryMatrix& choice, double fullCell);
};

Normal::Normal(const std::vector<ParticleAroundTip>& particles, const SplitNodes& split)
{
  listNodes(particles, split);
  lumped.assign(size(), 0.0);
  right.assign(size(), {0.0, 0.0});
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const ParticleAroundTip& p = particles[i];
    for (int k = 0; k < p.count; ++k)
    {
      lumped[at[i][k]] += p.mass * p.weight[k];
      for (int d = 0; d < 2; ++d)
        right[at[i][k]][d] += p.mass * p.weight[k] * p.displacement[d];
    }
  }
}

/// Nodes of a patch are near each other in their numbering, so a table over it is smaller than a tree.
void Normal::listNodes(const std::vector<ParticleAroundTip>& particles, const SplitNodes& split)
{
  int lowest = std::numeric_limits<int>::max(), highest = -1;
  for (const ParticleAroundTip& p : particles)
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
  const auto slotOf = [&](const ParticleAroundTip& p, int k) -> int&
  {
    const int n = p.node[k] - lowest;
    if (splits[n] < 0)
      splits[n] = split(p.node[k]) ? 1 : 0;
    return slot[n][splits[n] != 0 ? p.side + 1 : 1];
  };
  for (const ParticleAroundTip& p : particles)
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
double consistentFraction(double fromFront, const RecoveryMatrix& choice)
{
  const double beyond = fromFront - choice.radius;
  if (beyond <= 0.0)
    return 1.0;
  if (!(beyond < choice.edge))
    return 0.0;
  const double s = beyond / choice.edge;
  return 1.0 - s * s * (3.0 - 2.0 * s);
}

void Normal::couple(const std::vector<ParticleAroundTip>& particles, const RecoveryMatrix& choice,
                    double fullCell)
{
  std::vector<int> first(size());
  for (int k = 0; k < size(); ++k)
    first[k] = k;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    int lowest = size();
    for (int k = 0; k < particles[i].count; ++k)
      lowest = std::min(lowest, at[i][k]);
    for (int k = 0; k < particles[i].count; ++k)
      first[at[i][k]] = std::min(first[at[i][k]], lowest);
  }
  coupling = SkylineMatrix(first);
  own.assign(size(), 0.0);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const ParticleAroundTip& p = particles[i];
    double theta = consistentFraction(p.fromFront, choice);
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
std::vector<SkylineMatrix::Pair> solve(Normal& normal, double eps)
{
  normal.coupling.scale(1.0 - eps);
  for (int i = 0; i < normal.size(); ++i)
    normal.coupling(i, i) += (1.0 - eps) * normal.own[i] + eps * normal.lumped[i];
  if (!normal.coupling.factor())
    throw std::runtime_error("the displacement of the nodes around a crack front can't be recovered: their "
                             "mass matrix is not positive definite");
  std::vector<SkylineMatrix::Pair> solution = normal.right;
  normal.coupling.solve(solution);
  return solution;
}

/// The sum of (1 - L^-1 M)^k L^-1 right over k below `terms`, L the row sums.
std::vector<SkylineMatrix::Pair> sumSeries(const Normal& normal, int terms)
{
  std::vector<SkylineMatrix::Pair> term = normal.right;
  for (int i = 0; i < normal.size(); ++i)
    for (int d = 0; d < 2; ++d)
      term[i][d] /= normal.lumped[i];
  std::vector<SkylineMatrix::Pair> solution = term;
  for (int k = 1; k < terms; ++k)
  {
    const std::vector<SkylineMatrix::Pair> image = normal.coupling.times(term);
    for (int i = 0; i < normal.size(); ++i)
      for (int d = 0; d < 2; ++d)
      {
        term[i][d] -= (image[i][d] + normal.own[i] * term[i][d]) / normal.lumped[i];
        solution[i][d] += term[i][d];
      }
  }
  return solution;
}

} // namespace

NodeDisplacement recoverDisplacement(const std::vector<ParticleAroundTip>& particles, const SplitNodes& split,
                                     const RecoveryMatrix& choice, double fullCell)
{
  Normal normal(particles, split);
  NodeDisplacement result;
  if (normal.size() == 0)
    return result;
  const bool rowSums = choice.lumpedFraction >= 1.0;
  if (!rowSums)
    normal.couple(particles, choice, fullCell);
  const std::vector<SkylineMatrix::Pair> solution = rowSums || choice.terms > 0
                                                        ? sumSeries(normal, rowSums ? 1 : choice.terms)
                                                        : solve(normal, choice.lumpedFraction);
  for (int i = 0; i < normal.size(); ++i)
    result.emplace_hint(result.end(), normal.nodes[i], Vector<2>{{solution[i][0], solution[i][1]}});
  return result;
}

} // namespace Rhegma::energy_release
