#include "energy_release/FacePressureNearTip.hpp"

#include "energy_release/SharedNodes.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Rhegma::energy_release
{

namespace
{

/// Cells behind the front in which faces may have nodes in common, and pieces into which each is cut.
constexpr int cells = 3, pieces = 16;

/// A position on the crack at a distance behind the front.
struct CrackPoint
{
  Vector<2> at;
  double pressure;
};

class PathBehind
{
public:
  PathBehind(const CrackSet<2>& cracks, const CrackFront<2>& front)
  {
    const auto vertex = onHost(cracks.vertex);
    const auto pressure = onHost(cracks.pressure);
    const Crack<2>& crack = cracks.cracks[front.crack];
    const bool first = front.vertex == crack.firstVertex;
    for (int k = 0; k < crack.numVertices; ++k)
    {
      const int v = first ? crack.firstVertex + k : crack.firstVertex + crack.numVertices - 1 - k;
      vertices_.push_back({vertex(v, 0), vertex(v, 1)});
    }
    for (int k = 0; k < crack.numSimplices; ++k)
      pressures_.push_back(pressure(crack.firstSimplex + (first ? k : crack.numSimplices - 1 - k)));
  }

  /// \param back length of crack from the front [m] \return false beyond the crack's other end
  bool find(double back, CrackPoint& point) const
  {
    for (std::size_t s = 0; s + 1 < vertices_.size(); ++s)
    {
      const Vector<2> along = vertices_[s + 1] - vertices_[s];
      const double length = norm(along);
      if (back <= length)
      {
        point = {vertices_[s] + (back / length) * along, pressures_[s]};
        return true;
      }
      back -= length;
    }
    return false;
  }

private:
  std::vector<Vector<2>> vertices_;
  std::vector<double> pressures_;
};

} // namespace

double intensityLostAtFront(const State<2>& state, const CrackFront<2>& front, double tipOffset)
{
  const CrackSet<2>& cracks = state.cracks;
  if (cracks.pressure.extent(0) != cracks.simplex.extent(0) || state.clock.step == 0)
    return 0.0;
  const PathBehind path(cracks, front);
  const double piece = spacingAt(state, front.position) / pieces;
  std::vector<CrackPoint> positions;
  CrackPoint point;
  while (static_cast<int>(positions.size()) < cells * pieces &&
         path.find((positions.size() + 0.5) * piece, point))
    positions.push_back(point);

  std::vector<Vector<2>> at;
  at.reserve(positions.size());
  for (const CrackPoint& on : positions)
    at.push_back(on.at);
  const std::vector<double> shared = fractionOfNodes(state, front.crack, at);

  // int s^-1/2 ds over a piece of the path behind, s the distance from the tip of the crack in the cells.
  const auto weighed = [tipOffset](double from, double to)
  { return 2.0 * (std::sqrt(std::max(to + tipOffset, 0.0)) - std::sqrt(std::max(from + tipOffset, 0.0))); };
  double intensity = positions.empty() ? 0.0 : positions[0].pressure * weighed(-std::fabs(tipOffset), 0.0);
  for (std::size_t k = 0; k < positions.size(); ++k)
    intensity += shared[k] * positions[k].pressure * weighed(double(k) * piece, double(k + 1) * piece);
  return intensity * std::sqrt(2.0 / std::acos(-1.0));
}

} // namespace Rhegma::energy_release
