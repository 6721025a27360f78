#include "cracks/JudgeLigaments.hpp"

#include "base/Numbers.hpp"
#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "geometry/Cross.hpp"
#include "geometry/NearestPoint.hpp"
#include "plausibility/Judges.hpp"
#include "surface/Returns.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::cracks
{

namespace
{

using surface::CrackMesh;

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr double fewestCells = 2.0;   ///< of material next to a crack
constexpr double fewestBetween = 3.0; ///< cells between parts of one crack, as between two cracks
constexpr double justBelow = 1e-6;
/// Of the distance from where the crack meets the surface: nearer than that it runs along it.
constexpr double steepest = 0.25;
/// By how many cells a crack may go away from a point and be as near again.
constexpr double slack = 1.5;

/// The worst of a crack: where, how near, and the cells there.
template <int D>
struct Closest
{
  Vector<D> at{};
  double distance = infinity, cell = 1.0;

  void include(const Vector<D>& x, double d, double c)
  {
    if (d / c < distance / cell)
      *this = {x, d, c};
  }
  std::string text(const std::string& to) const
  {
    return readableLength(distance) + to + formatPoint(at) + ", " + formatShort(distance / cell) +
           " cells of " + readableLength(cell);
  }
};

template <int D>
Vector<D> normalOf(const CrackMesh<D>& mesh, int s)
{
  const auto x = [&](int i) { return mesh.vertices[mesh.simplices[s][i]]; };
  Vector<D> normal;
  if constexpr (D == 2)
    normal = {x(0)[1] - x(1)[1], x(1)[0] - x(0)[0]};
  else
    normal = cross(x(1) - x(0), x(2) - x(0));
  return (1.0 / norm(normal)) * normal;
}

/// Points inside a simplex, no further apart than about a cell.
template <int D>
std::vector<Vector<D>> pointsIn(const CrackMesh<D>& mesh, int s, double cell)
{
  const auto x = [&](int i) { return mesh.vertices[mesh.simplices[s][i]]; };
  if constexpr (D == 3) // triangles have about the size of a cell
    return {(1.0 / 3.0) * (x(0) + x(1) + x(2))};
  std::vector<Vector<D>> points;
  const int pieces = std::max(1, static_cast<int>(std::ceil(norm(x(1) - x(0)) / cell)));
  points.reserve(pieces);
  for (int k = 0; k < pieces; ++k)
    points.push_back(x(0) + ((k + 0.5) / pieces) * (x(1) - x(0)));
  return points;
}

/// The material next to one crack.
template <int D>
class Ligaments
{
public:
  Ligaments(const SceneBodies<D>& bodies, const MirroredSides& mirrored, const CrackMesh<D>& mesh,
            const State<D>& state)
      : bodies_(bodies),
        mirrored_(mirrored),
        mesh_(mesh),
        state_(state),
        breaking_(breakingOf(mesh)),
        nearestBreaking_(breaking_, fewestCells / steepest * state.mesh.grid.spacing)
  {
    for (std::size_t s = 0; s < mesh.simplices.size(); ++s)
      measure(static_cast<int>(s));
  }

  const Closest<D>& closest() const { return closest_; }

private:
  /// Points of the crack at the surface.
  static std::vector<Vector<D>> breakingOf(const CrackMesh<D>& mesh)
  {
    std::vector<Vector<D>> points;
    for (std::size_t s = 0; s < mesh.simplices.size(); ++s)
      for (int i = 0; i < D; ++i)
        for (int k = 1; k < D && mesh.beyond[s][i] == facet::surfaceBreaking; ++k)
          points.push_back(mesh.vertices[mesh.simplices[s][(i + k) % D]]);
    return points;
  }

  void measure(int s)
  {
    const Vector<D> normal = normalOf(mesh_, s), from = mesh_.vertices[mesh_.simplices[s][0]];
    const double cell = spacingAt(state_, from);
    for (const Vector<D>& x : pointsIn(mesh_, s, cell))
      look(x, {normal, -1.0 * normal}, spacingAt(state_, x));
    for (int i = 0; i < D; ++i)
      if (mesh_.beyond[s][i] == facet::front)
        measureFront(s, i, normal);
  }

  /// Ahead of a front and obliquely.
  void measureFront(int s, int opposite, const Vector<D>& normal)
  {
    const auto x = [&](int i) { return mesh_.vertices[mesh_.simplices[s][i % D]]; };
    const Vector<D> middle = 0.5 * (x(opposite + 1) + x(opposite + D - 1));
    Vector<D> ahead = middle - x(opposite);
    if constexpr (D == 3)
    {
      const Vector<D> along = x(opposite + 2) - x(opposite + 1);
      ahead = ahead - (dot(ahead, along) / dot(along, along)) * along;
    }
    ahead = (1.0 / norm(ahead)) * ahead;
    const double half = std::sqrt(0.5);
    look(middle, {ahead, normal, -1.0 * normal, half * (ahead + normal), half * (ahead - normal)},
         spacingAt(state_, middle));
  }

  void look(const Vector<D>& x, const std::vector<Vector<D>>& directions, double cell)
  {
    const double most = fewestCells * cell;
    if (bodies_.isDeep(x, most))
      return;
    const int k = nearestBreaking_.find(x);
    const double along = k < 0 ? most : std::min(most, steepest * norm(x - breaking_[k]));
    for (const Vector<D>& direction : directions)
      if (const double found = bodies_.reach(x, direction, along);
          found < along * (1.0 - justBelow) && !isMirror(x + found * direction))
        closest_.include(x, found, cell);
  }

  /// Whether a point of the surface lies on a mirrored side.
  bool isMirror(const Vector<D>& x) const
  {
    const double aside = 1e-3 * state_.mesh.grid.spacing;
    bool found = false;
    for (const Geometry::Bounds<D>& bounds : bodies_.boundsNear(x, aside))
      for (int d = 0; d < D; ++d)
        for (const bool upper : {false, true})
          found = found || (std::abs(x[d] - (upper ? bounds.upper : bounds.lower)[d]) < aside &&
                            mirrored_.has(bounds, d, upper, aside));
    return found;
  }

  const SceneBodies<D>& bodies_;
  const MirroredSides& mirrored_;
  const CrackMesh<D>& mesh_;
  const State<D>& state_;
  std::vector<Vector<D>> breaking_;
  NearestPoint<D> nearestBreaking_;
  Closest<D> closest_;
};

/// Where a crack comes back to itself.
template <int D>
Closest<D> closestToItself(const CrackMesh<D>& mesh, const State<D>& state)
{
  Closest<D> closest;
  if (mesh.simplices.size() < 2)
    return closest;
  const surface::Returns<D> returns(mesh);
  std::vector<std::vector<int>> star(mesh.vertices.size());
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s)
    for (const int v : mesh.simplices[s])
      star[v].push_back(static_cast<int>(s));
  for (std::size_t v = 0; v < star.size(); ++v)
  {
    const double cell = spacingAt(state, mesh.vertices[v]), most = fewestBetween * cell;
    if (const double found = returns.find(star[v], {mesh.vertices[v]}, most, slack * cell);
        found < most * (1.0 - justBelow))
      closest.include(mesh.vertices[v], found, cell);
  }
  return closest;
}

} // namespace

template <int D>
void judgeLigaments(const CrackedBodies<D>& bodies, const MirroredSides& mirrored,
                    const std::vector<CrackMesh<D>>& meshes, State<D>& state)
{
  constexpr char advice[] = ": use smaller cells (Domain > Cell Size), or move the crack";
  std::vector<std::string> messages;
  for (std::size_t c = 0; c < meshes.size(); ++c)
  {
    const std::string where = "Cracks > " + state.cracks.cracks[c].name;
    const SceneBodies<D>& shapes = bodies.of(state.cracks.cracks[c].bodyGroup);
    const Closest<D> toSurface = Ligaments<D>(shapes, mirrored, meshes[c], state).closest();
    constexpr double inSurface = 1e-3; // of a cell
    if (toSurface.distance < inSurface * toSurface.cell)
      messages.push_back(
          where + ": a part of it lies in a surface of the body, as at " + formatPoint(toSurface.at) +
          ", with no material on one side; its opening and G are wrong there: move it by two cells "
          "of material, or let it end where the body does");
    else if (toSurface.distance < infinity)
      messages.push_back(
          where + ": a surface of the body is " + toSurface.text(" away from it at ") +
          "; fewer than two cells of material neither bend nor strain, so its opening and G can be "
          "wrong there" +
          advice);
    const Closest<D> toItself = closestToItself(meshes[c], state);
    if (toItself.distance < infinity)
      messages.push_back(where + ": it comes back to " + toItself.text(" from itself at ") +
                         "; cells can't separate faces closer than three cells" + advice);
  }
  const std::vector<std::string> said = firstTen(std::move(messages));
  state.warnings.insert(state.warnings.end(), said.begin(), said.end());
}

template void judgeLigaments(const CrackedBodies<2>&, const MirroredSides&, const std::vector<CrackMesh<2>>&,
                             State<2>&);
template void judgeLigaments(const CrackedBodies<3>&, const MirroredSides&, const std::vector<CrackMesh<3>>&,
                             State<3>&);

} // namespace Rhegma::cracks
