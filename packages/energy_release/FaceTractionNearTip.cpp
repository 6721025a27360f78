#include "energy_release/FaceTractionNearTip.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::energy_release
{

namespace
{

/// Jump of displacement along a crack, by distance from one of its ends.
class JumpBehind
{
public:
  JumpBehind(const CrackSet<2>& cracks, const Crack<2>& crack, bool fromFirst)
  {
    const auto vertex = onHost(cracks.vertex);
    const auto face = onHost(cracks.face);
    for (int k = 0; k < crack.numVertices; ++k)
    {
      const int v = crack.firstVertex + (fromFirst ? k : crack.numVertices - 1 - k);
      const Vector<2> at{vertex(v, 0), vertex(v, 1)};
      behind_.push_back(k == 0 ? 0.0 : behind_.back() + norm(at - last_));
      jump_.push_back({face(v, 1, 0) - face(v, 0, 0), face(v, 1, 1) - face(v, 0, 1)});
      last_ = at;
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
  Vector<2> last_{};
};

} // namespace

FaceTractions::FaceTractions(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii)
{
  if (!state.cracks.tractions || state.clock.step == 0)
    return;
  std::vector<FaceTraction<2>> all = state.cracks.tractions(front.crack);
  const Crack<2>& crack = state.cracks.cracks[front.crack];
  const bool fromFirst = front.vertex == crack.firstVertex;
  if (!fromFirst)
    std::reverse(all.begin(), all.end());
  const JumpBehind jump(state.cracks, crack, fromFirst);
  double passed = 0.0;
  for (const FaceTraction<2>& point : all)
  {
    const double from = passed;
    passed += point.size;
    const double q = weightAt(norm(point.position - front.position), radii);
    if (q == 0.0)
      continue;
    const Vector<2> middle = jump(0.5 * (from + passed)), step = jump(passed) - jump(from);
    pieces_.push_back({from,
                       passed,
                       q,
                       {dot(point.traction, front.normal), dot(point.traction, front.direction)},
                       {dot(step, front.normal), dot(step, front.direction)},
                       dot(middle, front.normal)});
  }
  closed_ = !pieces_.empty() && std::all_of(pieces_.begin(), pieces_.end(),
                                            [](const Piece& piece) { return piece.traction[0] > 0.0; });
  if (closed_)
    smoothen();
}

void FaceTractions::smoothen()
{
  Vector<2> force{};
  double length = 0.0;
  for (const Piece& piece : pieces_)
  {
    const double part = piece.q * (piece.to - piece.from);
    force = force + part * piece.traction;
    length += part;
  }
  for (Piece& piece : pieces_)
    piece.traction = (1.0 / length) * force;
}

double FaceTractions::startOf(const Piece& piece, double tipOffset) const
{
  return piece.from == 0.0 ? 0.0 : piece.from + tipOffset;
}

double FaceTractions::release() const
{
  double sum = 0.0;
  for (const Piece& piece : pieces_) // the distance behind the front grows against the direction
    sum += piece.q * dot(piece.traction, piece.step);
  return sum;
}

Vector<2> FaceTractions::intensities(double tipOffset) const
{
  Vector<2> sum{};
  for (const Piece& piece : pieces_)
  {
    // int s^-1/2 ds
    const double from = startOf(piece, tipOffset);
    const double weighed =
        2.0 * (std::sqrt(std::max(piece.to + tipOffset, 0.0)) - std::sqrt(std::max(from, 0.0)));
    sum = sum + (piece.q * weighed) * piece.traction;
  }
  return std::sqrt(2.0 / std::acos(-1.0)) * sum;
}

double FaceTractions::intensityOfOpening(double tipOffset, double effectiveModulus) const
{
  double product = 0.0, square = 0.0;
  for (const Piece& piece : pieces_)
  {
    const double behind = std::max(0.5 * (piece.from + piece.to) + tipOffset, 0.0);
    product += piece.q * (piece.to - piece.from) * std::sqrt(behind) * piece.opening;
    square += piece.q * (piece.to - piece.from) * behind;
  }
  return square > 0.0 ? effectiveModulus * std::sqrt(2.0 * std::acos(-1.0)) / 8.0 * product / square : 0.0;
}

Vector<2> FaceTractions::reciprocals(double tipOffset, double effectiveModulus) const
{
  Vector<2> sum{};
  for (const Piece& piece : pieces_)
  {
    // int s^1/2 ds
    const double weighed = (std::pow(std::max(piece.to + tipOffset, 0.0), 1.5) -
                            std::pow(std::max(startOf(piece, tipOffset), 0.0), 1.5)) /
                           1.5;
    sum = sum - (piece.q * weighed) * piece.traction;
  }
  return 8.0 / (effectiveModulus * std::sqrt(2.0 * std::acos(-1.0))) * sum;
}

} // namespace Rhegma::energy_release
