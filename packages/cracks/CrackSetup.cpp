#include "cracks/CrackSetup.hpp"

#include "geometry/NearestPoint.hpp"
#include "scene/Attempts.hpp"
#include "scene/Numbers.hpp"
#include "scene/ReadList.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

using Points = std::vector<Vector<2>>;

/// Whether there is material at a place: within half a particle's diagonal of a particle's centre, as every
/// place inside a body is.
class Material
{
public:
  explicit Material(const State<2>& state) : places_(readPlaces(state)), nearest_(places_, reachOf(state)) {}

  bool at(const Vector<2>& x) const { return nearest_.find(x) >= 0; }

private:
  static Points readPlaces(const State<2>& state)
  {
    const auto x =
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.real<2>(fields::position));
    Points places;
    for (int p = 0; p < state.particles.size(); ++p)
      places.push_back({x(p, 0), x(p, 1)});
    return places;
  }

  static double reachOf(const State<2>& state)
  {
    const auto edge =
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.real<2>(fields::edge));
    double reach = 0.0;
    for (int p = 0; p < state.particles.size(); ++p)
      reach = std::max(reach, 0.5 * std::hypot(edge(p, 0), edge(p, 1)));
    return reach * (1.0 + 1e-9); // a place midway between four centres is inside whatever the rounding
  }

  Points places_;
  NearestPoint<2> nearest_;
};

double distanceToSegment(const Vector<2>& x, const Vector<2>& a, const Vector<2>& b)
{
  const Vector<2> t = b - a;
  const double s = std::clamp(dot(x - a, t) / dot(t, t), 0.0, 1.0);
  return norm(x - a - s * t);
}

/// What lies outside of the bodies is cut off later, piece by piece; a unit or an exponent that is wrong
/// would make too many pieces.
void refuseLong(const Points& points, const std::string& where, double spacing)
{
  double cells = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k)
    cells += norm(points[k] - points[k - 1]) / spacing;
  if (!(cells <= 1e5))
    throw std::invalid_argument(where + ": the crack is " + formatReal(cells) +
                                " cells long; write its points in metres, not far outside of the body");
}

/// Whether the segments a-b and c-d have a point in common.
bool meet(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d, double tolerance)
{
  const auto turn = [](const Vector<2>& p, const Vector<2>& q, const Vector<2>& r)
  { return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]); };
  if (turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0)
    return true;
  return std::min({distanceToSegment(a, c, d), distanceToSegment(b, c, d), distanceToSegment(c, a, b),
                   distanceToSegment(d, a, b)}) < tolerance;
}

void refuseCrossing(const Points& points, const std::string& where, double spacing)
{
  const double tolerance = 1e-6 * spacing;
  const auto refuse = [&](std::size_t i, std::size_t j)
  {
    throw std::invalid_argument(where + ": the piece after point " + std::to_string(j) +
                                " meets the piece after point " + std::to_string(i) +
                                " (counted from 0); write a line that neither crosses itself nor turns back");
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    for (std::size_t j = i + 1; j + 1 < points.size(); ++j)
      // Neighbours share a point; they overlap if the end of one lies on the other.
      if (j == i + 1 ? distanceToSegment(points[j + 1], points[i], points[j]) < tolerance ||
                           distanceToSegment(points[i], points[j], points[j + 1]) < tolerance
                     : meet(points[i], points[i + 1], points[j], points[j + 1], tolerance))
        refuse(i, j);
}

Points readPoints(const Teuchos::ParameterList& list, const std::string& where, double spacing)
{
  const auto values = list.get<Teuchos::Array<double>>("Points");
  Points points;
  for (int k = 0; k + 1 < values.size(); k += 2)
    points.push_back({values[k], values[k + 1]});
  for (std::size_t k = 1; k < points.size(); ++k)
    if (norm(points[k] - points[k - 1]) < 1e-6 * spacing)
      throw std::invalid_argument(
          where + ": two points in a row are the same, so a piece of the crack has no length; leave "
                  "one of them out");
  refuseLong(points, where, spacing);
  refuseCrossing(points, where, spacing);
  return points;
}

/// Equal pieces no longer than `longest`.
Points refine(const Points& points, double longest)
{
  Points fine{points.front()};
  for (std::size_t k = 1; k < points.size(); ++k)
  {
    const Vector<2> along = points[k] - points[k - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(norm(along) / longest - 1e-9)));
    for (int i = 1; i <= pieces; ++i)
      fine.push_back(points[k - 1] + (double(i) / pieces) * along);
  }
  return fine;
}

/// Drops what lies outside of the bodies at both ends, to a hundredth of a cell.
Points clip(const Points& points, const Material& material, double spacing)
{
  const Points dense = refine(points, 0.01 * spacing);
  std::size_t first = 0, last = dense.size();
  while (first < dense.size() && !material.at(dense[first]))
    ++first;
  while (last > first && !material.at(dense[last - 1]))
    --last;
  if (last < first + 2)
    return {};
  // Keep the user's own points that are left, between the two ends.
  Points kept{dense[first]};
  double from = 0.0;
  for (std::size_t k = 0; k < first; ++k)
    from += norm(dense[k + 1] - dense[k]);
  double to = from;
  for (std::size_t k = first; k + 1 < last; ++k)
    to += norm(dense[k + 1] - dense[k]);
  double at = 0.0;
  for (std::size_t k = 1; k + 1 < points.size(); ++k)
  {
    at += norm(points[k] - points[k - 1]);
    if (at > from + 1e-9 * spacing && at < to - 1e-9 * spacing)
      kept.push_back(points[k]);
  }
  kept.push_back(dense[last - 1]);
  return kept;
}

Vector<2> unit(const Vector<2>& a) { return (1.0 / norm(a)) * a; }

/// An end is a front if the user's crack ends there and there is material one cell ahead of it.
bool isFront(const Vector<2>& end, const Vector<2>& before, const Material& material, double spacing)
{
  const Vector<2> ahead = unit(end - before);
  for (const double step : {0.25, 0.5, 0.75, 1.0})
    if (!material.at(end + (step * spacing) * ahead))
      return false;
  return true;
}

void refuseNeighbours(const std::vector<Points>& all, const std::vector<std::string>& names, double spacing)
{
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = 0; b < all.size(); ++b)
      if (a != b)
        for (const Vector<2>& x : refine(all[a], 0.5 * spacing))
          for (std::size_t k = 1; k < all[b].size(); ++k)
            if (distanceToSegment(x, all[b][k - 1], all[b][k]) < 3.0 * spacing)
              throw std::invalid_argument(
                  "Cracks > " + names[a] + ": it comes closer than three cells to Cracks > " + names[b] +
                  ", which this version can't tell apart; take smaller cells (Domain > Cell Size)");
}

/// \param given  as in the scene
/// \param points inside of the bodies, and more of them
void place(const Teuchos::ParameterList& list, const std::string& name, const Material& material,
           double spacing, Points& given, Points& points)
{
  const std::string where = "Cracks > " + name + " > Points";
  given = readPoints(list, where, spacing);
  const Points inside = clip(given, material, spacing);
  if (inside.empty())
    throw std::invalid_argument(where +
                                ": the crack lies outside of all bodies; give points inside one of them");
  points = refine(inside, 4.0 * spacing);
}

} // namespace

void readCracks(const Teuchos::ParameterList& section, State<2>& state)
{
  const double spacing = state.grid.spacing;
  const Material material(state);
  std::vector<Points> all;
  std::vector<std::string> names;
  CrackSet<2>& set = state.cracks;
  Attempts attempts;
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    Points given, points;
    if (!attempts.attempt([&] { place(list, name, material, spacing, given, points); }))
      continue;
    Crack<2> crack;
    crack.name = name;
    crack.firstVertex = all.empty() ? 0 : set.cracks.back().firstVertex + set.cracks.back().numVertices;
    crack.numVertices = static_cast<int>(points.size());
    crack.firstSimplex = all.empty() ? 0 : set.cracks.back().firstSimplex + set.cracks.back().numSimplices;
    crack.numSimplices = crack.numVertices - 1;
    const int c = static_cast<int>(set.cracks.size());
    const std::string fronts = list.get<std::string>("Fronts");
    int number = 0;
    const bool firstGiven = norm(points.front() - given.front()) < 1e-9 * spacing;
    const bool lastGiven = norm(points.back() - given.back()) < 1e-9 * spacing;
    const bool first = fronts == "Automatic" ? firstGiven && isFront(points[0], points[1], material, spacing)
                                             : fronts == "First" || fronts == "Both";
    const bool last = fronts == "Automatic"
                          ? lastGiven && isFront(points.back(), points[points.size() - 2], material, spacing)
                          : fronts == "Last" || fronts == "Both";
    for (const int end : {0, 1})
      if (end == 0 ? first : last)
      {
        CrackFront<2> front;
        front.crack = c;
        front.number = number++;
        front.vertex = crack.firstVertex + (end == 0 ? 0 : crack.numVertices - 1);
        set.fronts.push_back(front);
      }
    set.cracks.push_back(crack);
    all.push_back(points);
    names.push_back(name);
  }
  attempts.complain();
  refuseNeighbours(all, names, spacing);

  const int vertices = set.cracks.empty() ? 0 : set.cracks.back().firstVertex + set.cracks.back().numVertices;
  const int simplices =
      set.cracks.empty() ? 0 : set.cracks.back().firstSimplex + set.cracks.back().numSimplices;
  set.vertex = View<double* [2]>("rhegma::crackVertex", vertices);
  set.face = View<double* [2][2]>("rhegma::crackFace", vertices);
  set.simplex = View<int* [2]>("rhegma::crackSimplex", simplices);
  set.crackOf = View<int*>("rhegma::crackOf", simplices);
  const auto vertex = Kokkos::create_mirror_view(set.vertex);
  const auto face = Kokkos::create_mirror_view(set.face);
  const auto simplex = Kokkos::create_mirror_view(set.simplex);
  const auto crackOf = Kokkos::create_mirror_view(set.crackOf);
  for (std::size_t c = 0; c < set.cracks.size(); ++c)
    for (int k = 0; k < set.cracks[c].numVertices; ++k)
    {
      const int v = set.cracks[c].firstVertex + k;
      for (int d = 0; d < 2; ++d)
        vertex(v, d) = face(v, 0, d) = face(v, 1, d) = all[c][k][d];
      if (k + 1 < set.cracks[c].numVertices)
      {
        const int s = set.cracks[c].firstSimplex + k;
        simplex(s, 0) = v;
        simplex(s, 1) = v + 1;
        crackOf(s) = static_cast<int>(c);
      }
    }
  Kokkos::deep_copy(set.vertex, vertex);
  Kokkos::deep_copy(set.face, face);
  Kokkos::deep_copy(set.simplex, simplex);
  Kokkos::deep_copy(set.crackOf, crackOf);
  set.nodeSide = View<int*>("rhegma::nodeSide", state.grid.numNodes);
  set.second = View<int*>("rhegma::secondField", state.grid.numNodes);
  Kokkos::deep_copy(set.second, -1);
  updateFronts(set);
}

void updateFronts(CrackSet<2>& cracks)
{
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.vertex);
  const auto at = [&](int v) { return Vector<2>{vertex(v, 0), vertex(v, 1)}; };
  for (CrackFront<2>& front : cracks.fronts)
  {
    const Crack<2>& crack = cracks.cracks[front.crack];
    const bool first = front.vertex == crack.firstVertex;
    const Vector<2> before = at(front.vertex + (first ? 1 : -1));
    front.position = at(front.vertex);
    front.direction = unit(front.position - before);
    // Side +1 lies to the left of the polyline as the scene gives it.
    front.normal = {-front.direction[1], front.direction[0]};
    if (first)
      front.normal = -1.0 * front.normal;
    front.length = 0.0;
    for (int k = 1; k < crack.numVertices; ++k)
      front.length += norm(at(crack.firstVertex + k) - at(crack.firstVertex + k - 1));
  }
}

} // namespace Rhegma::cracks
