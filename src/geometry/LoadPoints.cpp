#include "geometry/LoadPoints.hpp"

#include "geometry/Cross.hpp"
#include "geometry/NearestPoint.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{
namespace
{

template <int D>
struct WeightedPoint
{
  Vector<D> x;   ///< [m]
  double weight; ///< in any unit
  Vector<D> side[D - 1] = {};
  Vector<D> normal{};
};

template <int D>
double smallestEdge(const Seeds<D>& body)
{
  double edge = body.edge[0];
  for (int d = 1; d < D; ++d)
    edge = std::min(edge, body.edge[d]);
  return edge;
}

/// Equal pieces of a length, none longer than half the edge.
double pieces(double length, double edge)
{
  const double slack = 1.0e-9; // a length of exactly n half edges has n pieces
  return std::max(1.0, std::ceil(2.0 * length / edge - slack));
}

/// More points than any body has come from a wrong unit or exponent.
void refuseMany(double count, const std::string& section)
{
  if (count <= 1e7)
    return;
  std::ostringstream message;
  message << section << ": the load would need " << count
          << " points, which is too many; check that the ends of the loaded surface are in metres.";
  throw std::invalid_argument(message.str());
}

/// Scales the weights so that, added in order, they give exactly 1.
template <int D>
void normalise(std::vector<LoadPoint<D>>& points)
{
  double total = 0.0;
  for (const auto& p : points)
    total += p.fraction;
  double others = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    points[i].fraction /= total;
    others += points[i].fraction;
  }
  points.back().fraction = 1.0 - others; // exact, as the others are at least a half
}

template <int D>
std::vector<LoadPoint<D>> attach(const Seeds<D>& body, const std::vector<WeightedPoint<D>>& load,
                                 const std::string& section)
{
  const double reach = norm(body.edge);
  const NearestPoint<D> particles(body.position, reach);
  std::vector<LoadPoint<D>> points;
  const WeightedPoint<D>* missing = nullptr;
  for (const auto& point : load)
  {
    const int particle = particles.find(point.x);
    if (particle >= 0)
    {
      points.push_back({particle, point.x - body.position[particle], point.weight});
      std::copy(std::begin(point.side), std::end(point.side), points.back().side);
      points.back().normal = point.normal;
    }
    else if (!missing)
      missing = &point;
  }
  if (missing)
  {
    std::ostringstream message;
    message << section << ": ";
    if (load.size() == 1)
      message << "the load misses the body: the point ";
    else if (points.empty())
      message << "the load misses the body: none of its " << load.size()
              << " points is on the body; the first, ";
    else
      message << load.size() - points.size() << " of the load's " << load.size()
              << " points miss the body; the first of them, ";
    for (int d = 0; d < D; ++d)
      message << (d == 0 ? "(" : ", ") << missing->x[d];
    message << ") m, is farther than a particle's diagonal (" << reach
            << " m) from every particle; move the load onto the body's surface"
            << (D == 3 && load.size() > 1 && !points.empty()
                    ? ": a whole parallelogram must lie on it; on a round face write Surface = Body and what "
                      "chooses the face, such as Facing."
                    : ".");
    throw std::invalid_argument(message.str());
  }
  normalise(points);
  return points;
}

} // namespace

template <int D>
std::vector<LoadPoint<D>> pointLoad(const Seeds<D>& body, const Vector<D>& at, const std::string& section)
{
  return attach<D>(body, {{at, 1.0, {}, {}}}, section);
}

template <int D>
std::vector<LoadPoint<D>> lineLoad(const Seeds<D>& body, const Vector<D>& from, const Vector<D>& to,
                                   Profile profile, const std::string& section, bool around)
{
  const double length = norm(to - from);
  if (!(length > 0.0))
    throw std::invalid_argument(section + ": the line of the load has no length; From and To must differ.");
  const double needed = pieces(length, smallestEdge(body));
  refuseMany(needed, section);
  const int n = static_cast<int>(needed);
  std::vector<WeightedPoint<D>> load;
  for (int i = 0; i < n; ++i)
  {
    const double s = (i + 0.5) / n;
    const double weight = profile == Profile::Parabolic ? 6.0 * s * (1.0 - s) : 1.0;
    load.push_back({from + s * (to - from), weight, {}, {}});
    load.back().weight *= around ? load.back().x[0] : 1.0;
    load.back().side[0] = (1.0 / n) * (to - from); // of 2D; in 3D the line has no second
  }
  return attach(body, load, section);
}

std::vector<LoadPoint<3>> faceLoad(const Seeds<3>& body, const Vector<3>& corner, const Vector<3>& sideA,
                                   const Vector<3>& sideB, const std::string& section)
{
  const Vector<3> normal = cross(sideA, sideB);
  // Sides whose directions differ by less than 1e-9 enclose no area.
  if (!(norm(normal) > 1.0e-9 * norm(sideA) * norm(sideB)))
    throw std::invalid_argument(section +
                                ": the face of the load has no area; its two sides must not be parallel.");
  const double alongA = pieces(norm(sideA), smallestEdge(body));
  const double alongB = pieces(norm(sideB), smallestEdge(body));
  refuseMany(alongA * alongB, section);
  const int along = static_cast<int>(alongA), across = static_cast<int>(alongB);
  std::vector<WeightedPoint<3>> load;
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < along; ++i)
      load.push_back({corner + ((i + 0.5) / along) * sideA + ((j + 0.5) / across) * sideB,
                      1.0,
                      {(1.0 / along) * sideA, (1.0 / across) * sideB},
                      {}});
  return attach(body, load, section);
}

template <int D>
std::vector<LoadPoint<D>> surfaceLoad(const Seeds<D>& body,
                                      const std::vector<Geometry::SurfacePoint<D>>& surface,
                                      const std::string& section, bool around)
{
  refuseMany(static_cast<double>(surface.size()), section);
  std::vector<WeightedPoint<D>> load;
  for (const Geometry::SurfacePoint<D>& point : surface)
  {
    load.push_back({point.x, point.size * (around ? point.x[0] : 1.0), {}, point.normal});
    if constexpr (D == 2)
      load.back().side[0] = point.size * Vector<2>{-point.normal[1], point.normal[0]};
    else
    {
      // A square of the piece's area.
      Vector<3> aside{};
      aside[std::abs(point.normal[0]) < 0.6 ? 0 : 1] = 1.0;
      const Vector<3> along = cross(point.normal, aside);
      const Vector<3> edge = (std::sqrt(point.size) / norm(along)) * along;
      load.back().side[0] = edge;
      load.back().side[1] = cross(point.normal, edge);
    }
  }
  return attach(body, load, section);
}

template std::vector<LoadPoint<2>> surfaceLoad(const Seeds<2>&, const std::vector<Geometry::SurfacePoint<2>>&,
                                               const std::string&, bool);
template std::vector<LoadPoint<3>> surfaceLoad(const Seeds<3>&, const std::vector<Geometry::SurfacePoint<3>>&,
                                               const std::string&, bool);
template std::vector<LoadPoint<2>> pointLoad(const Seeds<2>&, const Vector<2>&, const std::string&);
template std::vector<LoadPoint<3>> pointLoad(const Seeds<3>&, const Vector<3>&, const std::string&);
template std::vector<LoadPoint<2>> lineLoad(const Seeds<2>&, const Vector<2>&, const Vector<2>&, Profile,
                                            const std::string&, bool);
template std::vector<LoadPoint<3>> lineLoad(const Seeds<3>&, const Vector<3>&, const Vector<3>&, Profile,
                                            const std::string&, bool);

} // namespace Rhegma
