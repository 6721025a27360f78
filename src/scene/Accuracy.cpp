#include "scene/Accuracy.hpp"

#include "geometry/Shape.hpp"
#include "scene/Numbers.hpp"
#include "scene/ReadList.hpp"
#include "scene/Validation.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <string>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Lengths that cells must be small beside [m].
struct Lengths
{
  double ligament = infinity; ///< from a front to a surface, or a crack's (half) length
  double crack = infinity;    ///< (half) length of the shortest crack
  double source = infinity;   ///< radius of the smallest source that moves
  bool front = false;         ///< whether there is a front at all
};

template <int D>
class Bodies
{
public:
  explicit Bodies(const ParameterList& list)
  {
    for (const std::string& name : sublistNames(list))
      shapes_.push_back(makeShape<D>(list.sublist(name)));
  }

  bool hold(const Vector<D>& x) const
  {
    return std::any_of(shapes_.begin(), shapes_.end(), [&](const Shape<D>& s) { return s.contains(x); });
  }

  /// Distance to the nearest surface along the axes and the diagonals between them [m]; 0 outside, and where
  /// it is below a hundredth of the bodies' extent, as at the mouth of a crack.
  double depth(const Vector<D>& x) const
  {
    if (!hold(x))
      return 0.0;
    double least = infinity;
    int count = 1;
    for (int d = 0; d < D; ++d)
      count *= 3;
    for (int k = 0; k < count; ++k)
    {
      Vector<D> way{};
      double square = 0.0;
      for (int d = 0, rest = k; d < D; ++d, rest /= 3)
      {
        way[d] = rest % 3 - 1;
        square += way[d] * way[d];
      }
      if (square > 0.0)
        least = std::min(least, reach(x, (1.0 / std::sqrt(square)) * way, least));
    }
    return least < 0.01 * extent() ? 0.0 : least;
  }

  /// The largest edge up to `most` of which a grid from `corner` has all faces of the bodies' bounds on its
  /// lines, unless that would take cells smaller by more than a third: particles of cells that a face cuts
  /// are not where those of whole cells are, and displacements given on it are off by up to half a cell.
  double fit(double most, const Teuchos::Array<double>& corner) const
  {
    std::vector<double> lengths;
    for (const Shape<D>& shape : shapes_)
      for (int d = 0; d < D; ++d)
        for (const double face : {shape.bounds().lower[d], shape.bounds().upper[d]})
          lengths.push_back(std::fabs(face - corner[d]));
    const double longest = *std::max_element(lengths.begin(), lengths.end());
    const int first = static_cast<int>(std::ceil(longest / most * (1.0 - 1e-9)));
    for (int count = first; count <= first * 3 / 2 + 1; ++count)
    {
      const double cell = longest / count;
      if (std::all_of(lengths.begin(), lengths.end(),
                      [&](double length)
                      { return std::fabs(length - cell * std::round(length / cell)) < 1e-6 * cell; }))
        return cell;
    }
    return most;
  }

private:
  /// How far along a direction all places are inside, looked for up to `most`.
  double reach(const Vector<D>& x, const Vector<D>& way, double most) const
  {
    const double longest = std::min(most, extent());
    constexpr int looks = 400;
    for (int k = 1; k <= looks; ++k)
      if (const double at = longest * k / looks; !hold(x + at * way))
        return at;
    return infinity;
  }

  double extent() const
  {
    double largest = 0.0;
    for (const Shape<D>& shape : shapes_)
      for (int d = 0; d < D; ++d)
        largest = std::max(largest, shape.bounds().upper[d] - shape.bounds().lower[d]);
    return largest;
  }

  std::vector<Shape<D>> shapes_;
};

/// A line with ends in a body: half its length where both are.
void measurePoints(const Teuchos::Array<double>& points, const Bodies<2>& bodies, Lengths& lengths)
{
  double length = 0.0;
  for (int k = 2; k + 1 < points.size(); k += 2)
    length += std::hypot(points[k] - points[k - 2], points[k + 1] - points[k - 1]);
  const int last = points.size() - 2;
  int fronts = 0;
  for (const int at : {0, last})
    if (const double depth = bodies.depth({{points[at], points[at + 1]}}); depth > 0.0)
    {
      ++fronts;
      lengths.ligament = std::min(lengths.ligament, depth);
    }
  if (fronts == 0)
    return;
  lengths.front = true;
  lengths.crack = std::min(lengths.crack, length / fronts);
}

/// A flat polygon: the smallest of the distances of its corners from their mean, as a radius.
void measurePoints(const Teuchos::Array<double>& points, const Bodies<3>& bodies, Lengths& lengths)
{
  const int count = static_cast<int>(points.size()) / 3;
  Vector<3> middle{};
  for (int k = 0; k < 3 * count; ++k)
    middle[k % 3] += points[k] / count;
  double radius = infinity;
  for (int k = 0; k < count; ++k)
  {
    const Vector<3> corner{{points[3 * k], points[3 * k + 1], points[3 * k + 2]}};
    radius = std::min(radius, norm(corner - middle));
    const double depth = bodies.depth(corner);
    if (depth == 0.0)
      continue;
    lengths.front = true;
    lengths.ligament = std::min(lengths.ligament, depth);
  }
  lengths.crack = std::min(lengths.crack, radius);
}

template <int D>
void measureCracks(const ParameterList& cracks, const Bodies<D>& bodies, Lengths& lengths)
{
  for (const std::string& name : sublistNames(cracks))
  {
    const ParameterList& crack = cracks.sublist(name);
    if (crack.isType<double>("Radius"))
    {
      const double semi = crack.isType<double>("Second Radius") ? crack.get<double>("Second Radius")
                                                                : crack.get<double>("Radius");
      lengths.front = true;
      lengths.crack = std::min({lengths.crack, crack.get<double>("Radius"), semi});
    }
    else if (crack.isParameter("Surface File"))
      throw std::invalid_argument("does not know the size of a crack from a file; write Domain > Cell Size");
    else
      measurePoints(crack.get<Teuchos::Array<double>>("Points"), bodies, lengths);
  }
}

void measureSources(const ParameterList& sources, Lengths& lengths)
{
  for (const std::string& name : sublistNames(sources))
    if (sources.sublist(name).isType<double>("Radius"))
      lengths.source = std::min(lengths.source, sources.sublist(name).get<double>("Radius"));
}

template <int D>
Lengths measure(const ParameterList& scene)
{
  Lengths lengths;
  if (scene.isSublist("Cracks"))
    measureCracks<D>(scene.sublist("Cracks"), Bodies<D>(scene.sublist("Bodies")), lengths);
  if (scene.isSublist("Thermal") && scene.sublist("Thermal").isSublist("Sources"))
    measureSources(scene.sublist("Thermal").sublist("Sources"), lengths);
  return lengths;
}

/// Whether fronts may have smaller cells than the rest: what the scene has works with them.
bool mayRefine(const ParameterList& scene)
{
  if (scene.isSublist("Adaptivity") || scene.isSublist("Sub-Cycling") || scene.isSublist("Mass Matrix") ||
      scene.isSublist("Propagation"))
    return false;
  const ParameterList& cracks = scene.sublist("Cracks");
  if (cracks.isType<std::string>("Formulation") &&
      cracks.get<std::string>("Formulation") == "Corrected Broken Cell")
    return false;
  const ParameterList& time = scene.sublist("Time");
  return !time.isType<std::string>("Update Scheme") || time.get<std::string>("Update Scheme") == "MUSL";
}

template <int D>
double fitToBodies(const ParameterList& scene, double cell)
{
  return Bodies<D>(scene.sublist("Bodies"))
      .fit(cell, scene.sublist("Domain").get<Teuchos::Array<double>>("Lower Corner"));
}

/// Size of the cells, and levels below it at fronts.
void choose(ParameterList& scene, const ParameterList& read, const AccuracyRule& rule)
{
  const Lengths lengths = dimensionOf(read) == 3 ? measure<3>(read) : measure<2>(read);
  const auto fitted = [&](double cell)
  { return dimensionOf(read) == 3 ? fitToBodies<3>(read, cell) : fitToBodies<2>(read, cell); };
  double cell = lengths.source / rule.perSource;
  const bool runs = read.isSublist("Propagation");
  if (runs && !rule.running)
    throw std::invalid_argument(std::string("is ") + rule.name +
                                ", which cracks that run are not known to reach; write 3 %");
  if (lengths.front)
  {
    cell = std::min(cell, std::min(lengths.ligament, lengths.crack) / (runs ? 16.0 : rule.perLigament));
  }
  if (!std::isfinite(cell))
    throw std::invalid_argument("is known for cracks and for moving sources of heat, and the scene has "
                                "neither; write Domain > Cell Size");
  // Four fifths of the error are for the place of the front.
  const double atFront = 1.6 * rule.share * lengths.crack;
  const bool refine = lengths.front && mayRefine(read);
  if (lengths.front && !runs && !refine)
    cell = std::min(cell, atFront);
  ParameterList& domain = scene.sublist("Domain");
  if (domain.isType<double>("Cell Size"))
    cell = domain.get<double>("Cell Size");
  else
    domain.set("Cell Size", cell = fitted(cell));
  const int levels = static_cast<int>(std::ceil(std::log2(cell / atFront) - 1e-6));
  if (levels <= 0 || runs || !refine)
    return;
  scene.sublist("Adaptivity").set("Maximum Level", std::min(levels, 6));
  scene.sublist("Sub-Cycling");
}

} // namespace

const std::vector<AccuracyRule>& accuracyRules()
{
  static const std::vector<AccuracyRule> rules = {{"10 %", 0.1, 3.0, 1.0, true},
                                                  {"3 %", 0.03, 5.0, 2.0, true},
                                                  {"1 %", 0.01, 8.0, 3.0, false},
                                                  {"0.3 %", 0.003, 16.0, 6.0, false}};
  return rules;
}

void chooseCells(ParameterList& scene, const SceneSchema& schema, std::vector<SceneError>& errors)
{
  if (!scene.isSublist("Domain") || !scene.sublist("Domain").isType<std::string>("Accuracy"))
    return;
  const std::string wanted = scene.sublist("Domain").get<std::string>("Accuracy");
  const std::vector<AccuracyRule>& rules = accuracyRules();
  const auto rule =
      std::find_if(rules.begin(), rules.end(), [&](const AccuracyRule& r) { return r.name == wanted; });
  if (rule == rules.end())
    return; // validation names what may stand there
  ParameterList read(scene);
  std::vector<SceneError> ignored;
  Validation(dimensionOf(read), ignored).check(read, schema.root(), "");
  if (!ignored.empty())
    return; // which will be found again
  try
  {
    choose(scene, read, *rule);
  }
  catch (const std::exception& problem)
  {
    errors.push_back({"Domain > Accuracy", problem.what()});
  }
}

} // namespace Rhegma
