#include "energy_release/PressedPath.hpp"

#include "energy_release/NodalDisplacement.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::energy_release
{

namespace
{

/// Pieces into which a cell's length of crack is cut.
constexpr int piecesOfCell = 8;

/// A particle's functions reach nodes at most this many cells away along each axis, and q of a node two cells
/// beyond the disk is zero.
constexpr double reachOfFunctions = 2.5;

/// Jump of Williams' field of unit intensity, from side -1 to side +1, at a place behind the tip in the frame
/// of the front.
TipField faceField(int mode, double along, double across, int side, const TipModuli& moduli)
{
  const double pi = std::acos(-1.0), r = std::hypot(along, across);
  double theta = std::atan2(across, along);
  if (side > 0 && theta < -0.5 * pi)
    theta += 2.0 * pi;
  if (side < 0 && theta > 0.5 * pi)
    theta -= 2.0 * pi;
  return williamsField(mode, r, theta, moduli);
}

} // namespace

PressedPath::PressedPath(const State<2>& state, const CrackFront<2>& front, const NodalWeight<2>& weight)
    : front_(front), weight_(weight)
{
  if (!isPressed(state))
    return;
  cut(state, weight.radii.outer + reachOfFunctions * state.mesh.grid.spacing);
  const bool loaded =
      std::any_of(load_.begin(), load_.end(), [](const Vector<2>& p) { return norm(p) > 0.0; });
  if (loaded)
    findWeights(state);
  else
    points_.clear();
}

/// Cuts the crack behind the front into pieces.
void PressedPath::cut(const State<2>& state, double reach)
{
  const CrackSet<2>& set = state.cracks;
  const Crack<2>& crack = set.cracks[front_.crack];
  const auto vertex = onHost(set.vertex);
  const auto pressure = onHost(set.pressure);
  const bool first = front_.vertex == crack.firstVertex;
  const double piece = spacingAt(state, front_.position) / piecesOfCell;
  const auto at = [&](int k)
  {
    const int v = first ? crack.firstVertex + k : crack.firstVertex + crack.numVertices - 1 - k;
    return Vector<2>{{vertex(v, 0), vertex(v, 1)}};
  };
  if (crack.numSimplices > 0)
    points_.push_back(at(0));
  for (int k = 0; k < crack.numSimplices; ++k)
  {
    const Vector<2> from = at(k), along = at(k + 1) - from;
    const double length = norm(along);
    const double p = pressure(crack.firstSimplex + (first ? k : crack.numSimplices - 1 - k));
    // Left of the crack's own direction is side +1.
    const double sign = first ? 1.0 : -1.0;
    const Vector<2> load{{-sign * p * along[1] / length, sign * p * along[0] / length}};
    const int count = std::max(1, static_cast<int>(std::ceil(length / piece)));
    for (int i = 1; i <= count && norm(points_.back() - front_.position) < reach; ++i)
    {
      points_.push_back(from + (double(i) / count) * along);
      load_.push_back(load);
    }
    if (!(norm(points_.back() - front_.position) < reach))
      return;
  }
}

/// q at the points, interpolated like the motion, as it is in the body: its kinks then have the same weight
/// in both.
void PressedPath::findWeights(const State<2>& state)
{
  const int half = static_cast<int>(points_.size());
  const StencilTable<2> table = stencilsOnFaces(state, front_.crack, points_);
  const View<double*> q("rhegma::pressedWeight", 2 * half);
  const View<int*> parent = state.mesh.nodes.parent;
  const int numFirst = state.mesh.nodes.numLattice;
  const NodalWeight<2> weight = weight_;
  Kokkos::parallel_for(
      "rhegma::pressedWeight", Kokkos::RangePolicy<ExecSpace>(0, 2 * half), KOKKOS_LAMBDA(const int k) {
        for (int e = 0; e < table.count(k); ++e)
        {
          const int node = table.node(k, e);
          q(k) += table.weight(k, e) * weight(node < numFirst ? node : parent(node - numFirst));
        }
      });
  const auto host = onHost(q);
  std::vector<double> both(host.data(), host.data() + 2 * half);
  sumParts(state, both.data(), 2 * half);
  weights_.resize(half);
  for (int k = 0; k < half; ++k)
    weights_[k] = 0.5 * (both[k] + both[half + k]);
}

double PressedPath::release(const State<2>& state) const
{
  if (empty())
    return 0.0;
  const double reach = weight_.radii.outer + 2.0 * reachOfFunctions * state.mesh.grid.spacing;
  const std::vector<Vector<2>> opened =
      openingAt(state, displacementOfNodes(state, Disk{front_.position, reach}), front_.crack, points_);
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < points_.size(); ++k)
  {
    sum += 0.5 * dot(load_[k], opened[k] + opened[k + 1]) * (weights_[k] - weights_[k + 1]);
    if (k > 0)
      sum += dot(load_[k - 1] - load_[k], opened[k]) * weights_[k];
  }
  return sum;
}

void PressedPath::addInteraction(double offset, const TipModuli& moduli, double (&interaction)[2],
                                 double (&reciprocal)[2]) const
{
  if (empty())
    return;
  const Vector<2> tip = front_.position + offset * front_.direction;
  for (int mode = 0; mode < 2; ++mode)
  {
    // From the tip of the crack in the cells to the front, and on along the crack.
    Vector<2> before{{0.0, 0.0}};
    for (std::size_t k = 0; k < points_.size(); ++k)
    {
      const Vector<2> from = points_[k] - tip;
      const double along = dot(from, front_.direction), across = dot(from, front_.normal);
      Vector<2> jump{{0.0, 0.0}};
      if (along < 0.0)
      {
        const TipField above = faceField(mode, along, across, 1, moduli),
                       below = faceField(mode, along, across, -1, moduli);
        for (int d = 0; d < 2; ++d)
          jump[d] = (above.displacement[0] - below.displacement[0]) * front_.direction[d] +
                    (above.displacement[1] - below.displacement[1]) * front_.normal[d];
      }
      const Vector<2> load = load_[k > 0 ? k - 1 : 0];
      const double q = k > 0 ? 0.5 * (weights_[k - 1] + weights_[k]) : weights_[0];
      const double length = k > 0 ? norm(points_[k] - points_[k - 1]) : std::max(offset, 0.0);
      interaction[mode] += q * dot(load, jump - before);
      reciprocal[mode] -= 0.5 * q * length * dot(load, jump + before);
      before = jump;
    }
  }
}

} // namespace Rhegma::energy_release
