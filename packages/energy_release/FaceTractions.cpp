#include "energy_release/FaceTractions.hpp"

#include "energy_release/ForceOfPressure.hpp"
#include "energy_release/NodalDisplacement.hpp"
#include "state/NodalValues.hpp"
#include "state/Subdomain.hpp"
#include "transfer/FaceRotation.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::energy_release
{

namespace
{

const double pi = std::acos(-1.0);

/// Pieces into which a cell's length of crack is cut.
constexpr int piecesOfCell = 8;

/// A particle's functions reach nodes at most this many cells away along each axis, and q of a node two cells
/// beyond the disk is zero.
constexpr double reachOfFunctions = 2.5;

/// Jump of the singular field of unit intensity, from side -1 to side +1, at a place behind the tip in the
/// frame of the front.
TipField faceField(int mode, double along, double across, int side, const CrackCompliance& material)
{
  const double r = std::hypot(along, across);
  double theta = std::atan2(across, along);
  if (side > 0 && theta < -0.5 * pi)
    theta += 2.0 * pi;
  if (side < 0 && theta > 0.5 * pi)
    theta -= 2.0 * pi;
  return TipPosition(r, theta, material).field(mode);
}

/// Jump of displacement along a front's crack, by distance behind the front.
class JumpBehind
{
public:
  JumpBehind(const CrackSet<2>& cracks, const CrackFront<2>& front)
  {
    const Crack<2>& crack = cracks.cracks[front.crack];
    const bool first = front.vertex == crack.firstVertex;
    const auto vertex = onHost(cracks.vertex);
    const auto face = onHost(cracks.face);
    Vector<2> last{};
    for (int k = 0; k < crack.numVertices; ++k)
    {
      const int v = crack.firstVertex + (first ? k : crack.numVertices - 1 - k);
      const Vector<2> at{vertex(v, 0), vertex(v, 1)};
      behind_.push_back(k == 0 ? 0.0 : behind_.back() + norm(at - last));
      jump_.push_back({face(v, 1, 0) - face(v, 0, 0), face(v, 1, 1) - face(v, 0, 1)});
      last = at;
    }
  }

  Vector<2> operator()(double distance) const
  {
    const auto at = std::upper_bound(behind_.begin() + 1, behind_.end() - 1, distance);
    const std::size_t k = at - behind_.begin();
    const double part = (distance - behind_[k - 1]) / (behind_[k] - behind_[k - 1]);
    return jump_[k - 1] + part * (jump_[k] - jump_[k - 1]);
  }

private:
  std::vector<double> behind_;
  std::vector<Vector<2>> jump_;
};

} // namespace

std::vector<LoadedPiece> pressedPieces(const State<2>& state, const CrackFront<2>& front)
{
  std::vector<LoadedPiece> pieces;
  if (!isPressed(state))
    return pieces;
  const CrackSet<2>& set = state.cracks;
  const Crack<2>& crack = set.cracks[front.crack];
  const auto vertex = onHost(set.vertex);
  const auto pressure = onHost(set.pressure);
  const bool first = front.vertex == crack.firstVertex;
  const auto at = [&](int k)
  {
    const int v = crack.firstVertex + (first ? k : crack.numVertices - 1 - k);
    return Vector<2>{{vertex(v, 0), vertex(v, 1)}};
  };
  for (int k = 0; k < crack.numSimplices; ++k)
  {
    const Vector<2> along = at(k + 1) - at(k);
    // Left of the crack's own direction is side +1.
    const double p = (first ? 1.0 : -1.0) / norm(along) *
                     pressure(crack.firstSimplex + (first ? k : crack.numSimplices - 1 - k));
    pieces.push_back({at(k), at(k + 1), {{-p * along[1], p * along[0]}}});
  }
  return pieces;
}

std::vector<LoadedPiece> touchingPieces(const State<2>& state, const CrackFront<2>& front)
{
  std::vector<LoadedPiece> pieces;
  if (!state.cracks.tractions || !haveNodalValues(state))
    return pieces;
  const bool first = front.vertex == state.cracks.cracks[front.crack].firstVertex;
  std::vector<FaceTraction<2>> points = state.cracks.tractions(front.crack);
  if (!first)
    std::reverse(points.begin(), points.end());
  for (const FaceTraction<2>& point : points)
  {
    const Vector<2> half = (first ? 0.5 : -0.5) * point.size * point.edge;
    pieces.push_back({point.position - half, point.position + half, point.traction});
  }
  return pieces;
}

FaceTractions::FaceTractions(const State<2>& state, const CrackFront<2>& front, const NodalWeight<2>& weight,
                             const std::vector<LoadedPiece>& pieces, OpeningBy openingBy)
    : front_(front)
{
  if (std::all_of(pieces.begin(), pieces.end(),
                  [](const LoadedPiece& piece) { return norm(piece.traction) == 0.0; }))
    return;
  const double reach = weight.radii.outer + reachOfFunctions * state.mesh.grid.spacing;
  cut(pieces, spacingAt(state, front.position) / piecesOfCell, reach);
  findWeights(state, weight);
  if (openingBy == OpeningBy::Nodes)
  {
    const Disk disk{front.position, reach + reachOfFunctions * state.mesh.grid.spacing};
    jumps_ = openingAt(state, displacementOfNodes(state, disk), front.crack, points_);
    // Tractions are normal to the crack as it lies in the cells.
    if (const auto turns = rotationsOfFaces(state.cracks); !turns.empty())
      for (Vector<2>& jump : jumps_)
        jump = turns[front.vertex].back(jump);
    return;
  }
  const JumpBehind jump(state.cracks, front);
  double behind = 0.0;
  for (std::size_t k = 0; k < points_.size(); ++k)
  {
    behind += k > 0 ? norm(points_[k] - points_[k - 1]) : 0.0;
    jumps_.push_back(jump(behind));
  }
}

/// Cuts the pieces within reach of the front into short ones.
void FaceTractions::cut(const std::vector<LoadedPiece>& pieces, double longest, double reach)
{
  points_.push_back(pieces.front().near);
  for (const LoadedPiece& piece : pieces)
  {
    const Vector<2> along = piece.far - piece.near;
    const int count = std::max(1, static_cast<int>(std::ceil(norm(along) / longest)));
    for (int i = 1; i <= count; ++i)
    {
      if (!(norm(points_.back() - front_.position) < reach))
        return;
      points_.push_back(piece.near + (double(i) / count) * along);
      traction_.push_back(piece.traction);
    }
  }
}

/// q at the points, interpolated like the motion, as it is in the body: its kinks then have the same weight
/// in both.
void FaceTractions::findWeights(const State<2>& state, const NodalWeight<2>& weight)
{
  const int half = static_cast<int>(points_.size());
  const StencilTable<2> table = stencilsOnFaces(state, front_.crack, points_);
  const View<double*> q("rhegma::weightOnFaces", 2 * half);
  const View<int*> parent = state.mesh.nodes.parent;
  const int numFirst = state.mesh.nodes.numLattice;
  Kokkos::parallel_for(
      "rhegma::weightOnFaces", Kokkos::RangePolicy<ExecSpace>(0, 2 * half), KOKKOS_LAMBDA(const int k) {
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
  {
    weights_[k] = 0.5 * (both[k] + both[half + k]);
    if (state.method.axisymmetric) // rings behind the front are longer or shorter than the front
      weights_[k] *= points_[k][0] / front_.position[0];
  }
}

double FaceTractions::weighedLength(std::size_t k) const
{
  return 0.5 * (weights_[k] + weights_[k + 1]) * norm(points_[k + 1] - points_[k]);
}

bool FaceTractions::closed() const
{
  for (std::size_t k = 0; k < traction_.size(); ++k)
    if (weighedLength(k) > 0.0 && !(dot(traction_[k], front_.normal) > 0.0))
      return false;
  return !traction_.empty();
}

void FaceTractions::takeMean()
{
  Vector<2> force{};
  double length = 0.0;
  for (std::size_t k = 0; k < traction_.size(); ++k)
  {
    force = force + weighedLength(k) * traction_[k];
    length += weighedLength(k);
  }
  std::fill(traction_.begin(), traction_.end(), (1.0 / length) * force);
}

double FaceTractions::release() const
{
  double sum = 0.0;
  for (std::size_t k = 0; k < traction_.size(); ++k)
  {
    sum += 0.5 * dot(traction_[k], jumps_[k] + jumps_[k + 1]) * (weights_[k] - weights_[k + 1]);
    if (k > 0)
      sum += dot(traction_[k - 1] - traction_[k], jumps_[k]) * weights_[k];
  }
  return sum;
}

FaceTractions::Interaction FaceTractions::interaction(double offset, const CrackCompliance& material) const
{
  Interaction sum;
  const Vector<2> tip = front_.position + offset * front_.direction;
  for (int mode = 0; mode < 2 && !traction_.empty(); ++mode)
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
        const TipField above = faceField(mode, along, across, 1, material),
                       below = faceField(mode, along, across, -1, material);
        for (int d = 0; d < 2; ++d)
          jump[d] = (above.displacement[0] - below.displacement[0]) * front_.direction[d] +
                    (above.displacement[1] - below.displacement[1]) * front_.normal[d];
      }
      const Vector<2> traction = traction_[k > 0 ? k - 1 : 0];
      const double q = k > 0 ? 0.5 * (weights_[k - 1] + weights_[k]) : weights_[0];
      const double length = k > 0 ? norm(points_[k] - points_[k - 1]) : std::max(offset, 0.0);
      sum.M[mode] += q * dot(traction, jump - before);
      sum.R[mode] -= 0.5 * q * length * dot(traction, jump + before);
      before = jump;
    }
  }
  return sum;
}

double FaceTractions::halfInteractionOfOpening(double offset) const
{
  double product = 0.0, square = 0.0;
  for (std::size_t k = 0; k < traction_.size(); ++k)
  {
    const Vector<2> middle = 0.5 * (points_[k] + points_[k + 1]);
    const double behind = std::max(norm(middle - front_.position) + offset, 0.0);
    const double opening = 0.5 * dot(jumps_[k] + jumps_[k + 1], front_.normal);
    product += weighedLength(k) * std::sqrt(behind) * opening;
    square += weighedLength(k) * behind;
  }
  return square > 0.0 ? std::sqrt(2.0 * pi) / 8.0 * product / square : 0.0;
}

} // namespace Rhegma::energy_release
