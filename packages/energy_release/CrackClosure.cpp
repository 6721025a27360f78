#include "energy_release/CrackClosure.hpp"

#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::energy_release
{

namespace
{

/// Radius of the patch in cells: the influence of a node in the consistent projection falls to a quarter from
/// node to node, so that the boundary of the patch has none at its centre.
constexpr double patchRadius = 8.0;

/// Reach of the stencil of a particle [cells].
constexpr double patchStencil = 3.0;

/// Force of each side on a node that both may touch.
struct SideForces
{
  Vector<2> of[2] = {{{0.0, 0.0}}, {{0.0, 0.0}}};
  bool touched[2] = {false, false};
  bool both() const { return touched[0] && touched[1]; }
};

std::map<int, SideForces> nodeForces(const std::vector<ParticleAroundTip>& particles)
{
  int lowest = std::numeric_limits<int>::max(), highest = -1;
  for (const ParticleAroundTip& p : particles)
    for (int k = 0; k < p.count; ++k)
    {
      lowest = std::min(lowest, p.node[k]);
      highest = std::max(highest, p.node[k]);
    }
  std::vector<SideForces> table(highest < 0 ? 0 : highest - lowest + 1);
  for (const ParticleAroundTip& p : particles)
    for (int k = 0; k < p.count; ++k)
    {
      SideForces& f = table[p.node[k] - lowest];
      const int s = p.side > 0 ? 1 : 0;
      f.touched[s] = true;
      for (int d = 0; d < 2; ++d)
        f.of[s][d] += p.force[d][0] * p.slope[k][d][0] + p.force[d][1] * p.slope[k][d][1];
    }
  std::map<int, SideForces> forces;
  for (std::size_t n = 0; n < table.size(); ++n)
    if (table[n].touched[0] || table[n].touched[1])
      forces.emplace_hint(forces.end(), lowest + static_cast<int>(n), table[n]);
  return forces;
}

/// Rows and columns of nodes as the front sees them, in cells of the size that they have at the front:
/// columns are counted in its direction.
class Columns
{
public:
  Columns(const State<2>& state, const CrackFront<2>& front, double cell,
          const std::map<int, SideForces>& forces)
      : positions_(state),
        origin_(state.mesh.grid.whole),
        cell_(cell),
        axis_(std::fabs(front.direction[0]) >= std::fabs(front.direction[1]) ? 0 : 1),
        sign_(front.direction[axis_] > 0.0 ? 1 : -1)
  {
    for (const auto& entry : forces)
      at_[{row(entry.first), column(entry.first)}] = entry.first;
  }
  int column(int node) const { return sign_ * count(node, axis_); }
  int row(int node) const { return count(node, 1 - axis_); }
  /// The node some columns behind another, or -1.
  int behind(int node, int columns) const
  {
    const auto found = at_.find({row(node), column(node) - columns});
    return found == at_.end() ? -1 : found->second;
  }

private:
  int count(int node, int axis) const
  {
    return static_cast<int>(std::lround((positions_.positionOf(node)[axis] - origin_[axis]) / cell_));
  }

  WholeNodes positions_;
  Vector<2> origin_;
  double cell_;
  int axis_, sign_;
  std::map<std::pair<int, int>, int> at_;
};

/// First closed column of each row.
std::map<int, int> firstClosed(const std::map<int, SideForces>& forces, const SplitNodes& split,
                               const Columns& columns)
{
  std::map<int, int> first;
  for (const auto& entry : forces)
    if (entry.second.both() && split(entry.first))
    {
      const int row = columns.row(entry.first), next = columns.column(entry.first) + 1;
      const auto found = first.emplace(row, next).first;
      found->second = std::max(found->second, next);
    }
  return first;
}

/// Forces with which springs behind the front pull each node's side +1 towards side -1 [N]; zero of nodes
/// without.
class SpringForces
{
public:
  /// Collective. \param radius around the front of the nodes that will be asked for [m]
  SpringForces(const State<2>& state, const CrackFront<2>& front, double radius)
      : known_(state.cracks.spring.extent(0) > 0), many_(static_cast<bool>(state.mesh.subdomain))
  {
    if (!known_)
      return;
    const auto host = [](const auto& view) { return onHost(view); };
    force_ = host(state.cracks.spring);
    side_ = host(state.cracks.nodeSide);
    second_ = host(state.cracks.enrichedField);
    if (many_)
      gather(state, front, radius);
  }
  Vector<2> operator()(int node) const
  {
    if (!many_)
      return forceHere(node);
    const auto found = all_.find(node);
    return found == all_.end() ? Vector<2>{{0.0, 0.0}} : found->second;
  }

private:
  Vector<2> forceHere(int node) const
  {
    if (!known_ || second_(node) < 0)
      return {{0.0, 0.0}};
    const double sign = side_(node) > 0 ? -1.0 : 1.0;
    return {{sign * force_(node, 0), sign * force_(node, 1)}};
  }

  void gather(const State<2>& state, const CrackFront<2>& front, double radius)
  {
    const WholeNodes whole(state);
    std::vector<double> own; // node, force; one after another
    for (const int n : ownNodesAround(state, front.position, radius))
    {
      const Vector<2> force = forceHere(n);
      if (force[0] != 0.0 || force[1] != 0.0)
        own.insert(own.end(), {double(whole(n)), force[0], force[1]});
    }
    const std::vector<double> all = state.ranks.gatherOnAll(own);
    for (std::size_t k = 0; k < all.size(); k += 3)
      all_[static_cast<int>(all[k])] = {{all[k + 1], all[k + 2]}};
  }

  bool known_, many_;
  std::map<int, Vector<2>> all_; ///< where there are several ranks
  View<double* [3]>::HostMirror force_;
  View<int*>::HostMirror side_, second_;
};

double work(const std::map<int, SideForces>& forces, const SpringForces& springs, const SplitNodes& split,
            const Columns& columns, const std::map<int, int>& first, const NodeDisplacement& displacement,
            int number)
{
  double sum = 0.0;
  bool found = false;
  for (const auto& entry : forces)
  {
    const int node = entry.first;
    if (!entry.second.both())
      continue;
    const auto row = first.find(columns.row(node));
    if (row == first.end())
      continue;
    const int ahead = columns.column(node) - row->second;
    const bool held = split(node) && ahead == -1;
    if (!held && (split(node) || ahead < 0 || ahead >= number))
      continue;
    const int open = columns.behind(node, number);
    const auto plus = displacement.find({open, 1}), minus = displacement.find({open, -1});
    if (plus == displacement.end() || minus == displacement.end())
      continue;
    const Vector<2> opening = plus->second - minus->second;
    if (held)
    {
      sum += dot(springs(node), opening);
      continue;
    }
    found = true;
    sum += 0.5 * dot(entry.second.of[1] - entry.second.of[0], opening);
  }
  return found ? sum : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

bool runsAlongGrid(const CrackFront<2>& front)
{
  constexpr double cosineOfFiveDegrees = 0.99619;
  return std::max(std::fabs(front.direction[0]), std::fabs(front.direction[1])) > cosineOfFiveDegrees;
}

CrackClosure closeCrack(const State<2>& state, const CrackFront<2>& front, int number,
                        const RecoveryMatrix& choice)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  if (!runsAlongGrid(front))
    return {none, none};
  const double cell = spacingAt(state, front.position);
  const double radius = patchRadius * cell, beyond = radius + patchStencil * state.mesh.grid.spacing;
  const std::vector<ParticleAroundTip> particles = particlesAround(state, front, radius);
  const SplitNodes split(state, front, beyond);
  const std::map<int, SideForces> forces = nodeForces(particles);
  const SpringForces springs(state, front, beyond);
  const Columns columns(state, front, cell, forces);
  const std::map<int, int> first = firstClosed(forces, split, columns);
  const auto release = [&](RecoveryMatrix matrix)
  {
    matrix.radius += matrix.radiusCells * cell;
    matrix.edge += matrix.edgeCells * cell;
    const NodeDisplacement displacement =
        recoverDisplacement(particles, split, matrix, cell * cell * state.method.thickness);
    return work(forces, springs, split, columns, first, displacement, number) /
           (2.0 * number * cell * state.method.thickness);
  };
  return {release(choice), release(lumpedMatrix())};
}

} // namespace Rhegma::energy_release
