#include "scene/SceneBodies.hpp"

#include "base/ReadList.hpp"
#include "geometry/Seeds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace Rhegma
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

template <int D>
SceneBodies<D>::SceneBodies(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& list = scene.sublist("Bodies");
  for (const std::string& name : sublistNames(list))
    shapes_.push_back(makeShape<D>(list.sublist(name)));
  std::vector<Geometry::Bounds<D>> bounds;
  bounds.reserve(shapes_.size());
  for (const Shape<D>& shape : shapes_)
  {
    bounds.push_back(shape.bounds());
    for (int d = 0; d < D; ++d)
      extent_ = std::max(extent_, bounds.back().upper[d] - bounds.back().lower[d]);
  }
  boxes_ = Geometry::NearBoxes<D>(std::move(bounds));
}

template <int D>
template <class Condition>
bool SceneBodies<D>::any(const Vector<D>& x, double distance, const Condition& condition) const
{
  constexpr std::size_t few = 8; // that are checked faster than they are searched
  if (shapes_.size() <= few)
    return std::any_of(shapes_.begin(), shapes_.end(), condition);
  const double rounding = 1e-9 * extent_;
  const std::vector<int> near = boxes_.near({x, x}, distance + rounding);
  return std::any_of(near.begin(), near.end(), [&](int k) { return condition(shapes_[k]); });
}

template <int D>
bool SceneBodies<D>::contain(const Vector<D>& x) const
{
  return any(x, 0.0, [&](const Shape<D>& s) { return s.contains(x); });
}

template <int D>
bool SceneBodies<D>::contain(const Vector<D>& x, double outside) const
{
  return any(x, outside, [&](const Shape<D>& s) { return s.contains(x) || s.depth(x) >= -outside; });
}

template <int D>
bool SceneBodies<D>::isDeep(const Vector<D>& x, double depth) const
{
  return any(x, 0.0, [&](const Shape<D>& s) { return s.depth(x) >= depth; });
}

template <int D>
double SceneBodies<D>::depth(const Vector<D>& x) const
{
  if (!contain(x))
    return 0.0;
  constexpr double closer = 0.01;
  for (double span = extent_; span > 1e-9 * extent_; span *= closer)
    if (const double least = nearest(x, span); least >= closer * span)
      return least;
  return 0.0;
}

/// Distance to the nearest surface, of those nearer than a span where there is one.
template <int D>
double SceneBodies<D>::nearest(const Vector<D>& x, double span) const
{
  double least = infinity;
  int count = 1;
  for (int d = 0; d < D; ++d)
    count *= 3;
  for (int k = 0; k < count; ++k)
  {
    Vector<D> direction{};
    double square = 0.0;
    for (int d = 0, rest = k; d < D; ++d, rest /= 3)
    {
      direction[d] = rest % 3 - 1;
      square += direction[d] * direction[d];
    }
    if (square > 0.0)
      least = std::min(least, reach(x, (1.0 / std::sqrt(square)) * direction, std::min(least, span)));
  }
  return least;
}

template <int D>
double SceneBodies<D>::reach(const Vector<D>& x, const Vector<D>& direction, double most) const
{
  constexpr int samples = 400;
  for (int k = 1; k <= samples; ++k)
    if (!contain(x + (most * k / samples) * direction))
    {
      double inside = most * (k - 1) / samples, outside = most * k / samples;
      for (int halving = 0; halving < 20; ++halving)
      {
        const double middle = 0.5 * (inside + outside);
        (contain(x + middle * direction) ? inside : outside) = middle;
      }
      return outside;
    }
  return infinity;
}

template <int D>
std::vector<Geometry::Bounds<D>> SceneBodies<D>::boundsNear(const Vector<D>& x, double distance) const
{
  std::vector<Geometry::Bounds<D>> bounds;
  for (const int k : boxes_.near({x, x}, distance))
    bounds.push_back(shapes_[k].bounds());
  return bounds;
}

template <int D>
double SceneBodies<D>::fit(double most, const Teuchos::Array<double>& corner) const
{
  std::vector<double> lengths;
  for (const Shape<D>& shape : shapes_)
    for (int d = 0; d < D; ++d)
      for (const double face : {shape.bounds().lower[d], shape.bounds().upper[d]})
        lengths.push_back(std::fabs(face - corner[d]));
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  const int first = static_cast<int>(std::ceil(longest / most * (1.0 - 1e-9)));
  for (int count = first; count <= (D == 2 ? 2 * first : first * 3 / 2 + 1); ++count)
  {
    const double cell = longest / count;
    if (std::all_of(lengths.begin(), lengths.end(),
                    [&](double length)
                    { return std::fabs(length - cell * std::round(length / cell)) < 1e-6 * cell; }))
      return cell;
  }
  return most;
}

namespace
{

template <int D>
double estimateParticlesIn(const Teuchos::ParameterList& bodies, double cell)
{
  double sum = 0.0;
  for (const std::string& name : sublistNames(bodies))
  {
    const Teuchos::ParameterList& body = bodies.sublist(name);
    sum += estimateSeeds(makeShape<D>(body), cell, body.get<int>("Particles Per Cell"));
  }
  return sum;
}

} // namespace

double estimateParticles(const Teuchos::ParameterList& scene)
{
  const double cell = scene.sublist("Domain").get<double>("Cell Size");
  const Teuchos::ParameterList& bodies = scene.sublist("Bodies");
  return scene.sublist("Domain").get<int>("Dimension") == 3 ? estimateParticlesIn<3>(bodies, cell)
                                                            : estimateParticlesIn<2>(bodies, cell);
}

template class SceneBodies<2>;
template class SceneBodies<3>;

} // namespace Rhegma
