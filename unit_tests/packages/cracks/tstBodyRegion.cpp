/// Where there is material, against shapes that are computed here.

#include "CubeScene.hpp"

#include "cracks/BodyRegion.hpp"

#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>

using namespace Rhegma;
using namespace Rhegma::cracks;
using namespace Rhegma::cracks::test;

namespace
{

/// Random numbers; the seed is printed.
class Chance
{
public:
  Chance()
  {
    const char* const given = std::getenv("RHEGMA_SEED");
    const unsigned seed = given != nullptr ? std::strtoul(given, nullptr, 10) : std::random_device{}();
    std::cout << "seed " << seed << '\n';
    engine_.seed(seed);
  }
  double operator()(double from, double to)
  {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  template <int D>
  Vector<D> point(double from, double to)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = (*this)(from, to);
    return x;
  }
  template <int D>
  Vector<D> direction()
  {
    for (;;)
      if (const Vector<D> x = point<D>(-1.0, 1.0); norm(x) > 0.1 && norm(x) < 1.0)
        return (1.0 / norm(x)) * x;
  }

private:
  std::mt19937 engine_;
};

template <int D>
using Inside = std::function<bool(const Vector<D>&)>;

template <int D>
Numbers listOf(const Vector<D>& x)
{
  return Numbers(x.c, x.c + D);
}

/// A box turned in the plane of x and y about its middle.
template <int D>
Inside<D> turnedBox(Chance& chance, Teuchos::ParameterList& list, double from, double to)
{
  Vector<D> lower, upper;
  for (int d = 0; d < D; ++d)
  {
    lower[d] = chance(from, 0.5 * (from + to));
    upper[d] = lower[d] + chance(3.0, 5.0) * cell;
  }
  const double degrees = chance(0.0, 90.0), angle = degrees * std::acos(-1.0) / 180.0;
  list.set<std::string>("Shape", "Box");
  list.set("Lower Corner", listOf(lower));
  list.set("Upper Corner", listOf(upper));
  list.set("Rotation", degrees);
  const Vector<D> middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
  return [=](const Vector<D>& x)
  {
    Vector<D> own = x - middle;
    const double a = own[0], b = own[1];
    own[0] = a * std::cos(angle) + b * std::sin(angle);
    own[1] = b * std::cos(angle) - a * std::sin(angle);
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && std::abs(own[d]) <= half[d];
    return in;
  };
}

template <int D>
Inside<D> ball(Chance& chance, Teuchos::ParameterList& list, double from, double to)
{
  const Vector<D> centre = chance.point<D>(from, to);
  const double radius = chance(1.5, 3.0) * cell;
  list.set<std::string>("Shape", "Ball");
  list.set("Centre", listOf(centre));
  list.set("Radius", radius);
  return [=](const Vector<D>& x) { return norm(x - centre) <= radius; };
}

/// A star of random corners, one of which is a thin spike; by the turns round a point.
Inside<2> star(Chance& chance, Teuchos::ParameterList& list, double from, double to)
{
  const Vector<2> middle = chance.point<2>(from, to);
  std::vector<Vector<2>> corners;
  constexpr int count = 7;
  for (int k = 0; k < count; ++k)
  {
    const double angle = 2.0 * std::acos(-1.0) * k / count;
    const double radius = (k == 0 ? 8.0 : chance(2.0, 4.0)) * cell;
    corners.push_back(middle + radius * Vector<2>{std::cos(angle), std::sin(angle)});
  }
  corners[1] = middle + 2.0 * cell * Vector<2>{1.0, 0.1};
  corners[count - 1] = middle + 2.0 * cell * Vector<2>{1.0, -0.1};
  Numbers points;
  for (const Vector<2>& x : corners)
    points.insert(points.end(), x.c, x.c + 2);
  list.set<std::string>("Shape", "Polygon");
  list.set("Points", points);
  return [=](const Vector<2>& x)
  {
    double turns = 0.0;
    for (int k = 0; k < count; ++k)
    {
      const Vector<2> a = corners[k] - x, b = corners[(k + 1) % count] - x;
      turns += std::atan2(a[0] * b[1] - a[1] * b[0], dot(a, b));
    }
    return std::abs(turns) > std::acos(-1.0);
  };
}

template <int D>
Inside<D> shapeOf(Chance& chance, Teuchos::ParameterList& list, double from, double to)
{
  const double which = chance(0.0, 3.0);
  if constexpr (D == 2)
    if (which < 1.0)
      return star(chance, list, from, to);
  return which < 2.0 ? turnedBox<D>(chance, list, from, to) : ball<D>(chance, list, from, to);
}

/// A body of two shapes, and what they are.
template <int D>
Inside<D> body(Chance& chance, Teuchos::ParameterList& list, double from, double to)
{
  const Inside<D> base = shapeOf<D>(chance, list, from, to);
  Teuchos::ParameterList& second = list.sublist("Operations").sublist("Second");
  const Inside<D> more = shapeOf<D>(chance, second, from, to);
  const bool adds = chance(0.0, 1.0) < 0.5;
  second.set<std::string>("Operation", adds ? "Add" : "Cut");
  return [=](const Vector<D>& x) { return more(x) ? adds : base(x); };
}

/// A point as near to the surface as doubles can tell, between one inside and one outside.
template <int D>
Vector<D> onSurface(const Inside<D>& inside, Vector<D> in, Vector<D> out)
{
  for (int halving = 0; halving < 60; ++halving)
  {
    const Vector<D> middle = 0.5 * (in + out);
    (inside(middle) ? in : out) = middle;
  }
  return in;
}

/// Whether some point within a distance is inside: by directions all round.
template <int D>
bool isWithin(Chance& chance, const Inside<D>& inside, const Vector<D>& x, double distance)
{
  for (int k = 0; k < 200000; ++k) // a corner may be thin
    if (inside(x + chance(0.0, distance) * chance.direction<D>()))
      return true;
  return false;
}

template <int D>
void compareWithShapes(int trials)
{
  Chance chance;
  const double wide = 24.0 * cell;
  const double reach =
      0.5 * (std::sqrt(double(D)) - 1.0) * 0.75 * cell; // of particles of up to 3/4 of a cell
  int in = 0;
  for (int trial = 0; trial < trials; ++trial)
  {
    Teuchos::ParameterList scene = blockScene(std::vector<double>(D, wide));
    Teuchos::ParameterList& list = scene.sublist("Bodies").sublist("Block");
    for (const char* const name : {"Lower Corner", "Upper Corner"})
      list.remove(name);
    const Inside<D> inside = body<D>(chance, list, 8.0 * cell, 16.0 * cell);
    std::unique_ptr<Run<D>> run;
    try
    {
      run = start<D>(scene);
    }
    catch (const std::invalid_argument&) // the second shape has cut away all of the first
    {
      continue;
    }
    const SceneBodies<D> shapes(Test::validated(scene));
    const BodyRegion<D> region(shapes, run->state());
    Vector<D> known{}; // inside
    while (!inside(known))
      known = chance.point<D>(0.0, wide);
    for (int k = 0; k < 400; ++k)
    {
      // Bodies fill little of the domain: half of the points are next to their surface.
      Vector<D> x = chance.point<D>(0.0, wide), other = k % 2 == 0 ? known : chance.point<D>(0.0, wide);
      if (inside(x) != inside(other)) // then one next to the surface
        x = onSurface<D>(inside, inside(x) ? x : other, inside(x) ? other : x) +
            chance(1e-6, 0.5) * cell * chance.direction<D>();
      in += inside(x) ? 1 : 0;
      EXPECT_EQ(region.contains(x), inside(x)) << trial << " " << x[0] << " " << x[1];
      EXPECT_TRUE(region.isNear(x) || !inside(x)) << trial << " " << x[0] << " " << x[1];
      // At corners of boxes, where Shape::depth is the largest of the distances along the axes.
      if (region.isNear(x) && !inside(x))
      {
        EXPECT_TRUE(isWithin<D>(chance, inside, x, 1.05 * std::sqrt(double(D)) * reach))
            << trial << " " << x[0] << " " << x[1];
      }
    }
  }
  EXPECT_GT(in, 10 * trials);
}

/// Fronts of a crack from the left side of a block into it, with something else in the scene.
template <class Change>
std::size_t frontsWith(double height, const Change& change)
{
  Teuchos::ParameterList scene = blockScene({20.0 * cell, 40.0 * cell}, 12.0);
  setCrack(scene, {0.0, height, 6.3 * cell, height});
  change(scene.sublist("Bodies"));
  return start<2>(scene)->state().cracks.fronts.size();
}

} // namespace

TEST(BodyRegion, IsThatOfTheShapesIn2D) { compareWithShapes<2>(12); }
TEST(BodyRegion, IsThatOfTheShapesIn3D) { compareWithShapes<3>(4); }

/// Where a crack meets the surface there is no front, however thin something else is in the scene.
TEST(BodyRegion, AMouthIsNoFrontWhateverElseIsInTheScene)
{
  Chance chance;
  for (int trial = 0; trial < 6; ++trial)
  {
    const double height = chance(8.0, 14.0) * cell, thin = chance(0.02, 0.3) * cell, at = 25.0 * cell;
    const auto fin = [&](Teuchos::ParameterList& list, const std::vector<double>& points)
    {
      list.set<std::string>("Shape", "Polygon");
      list.set("Points", numbers(points));
    };
    const std::vector<double> needle{20.0 * cell, at, 28.0 * cell, at + 0.5 * thin, 20.0 * cell, at + thin};
    EXPECT_EQ(frontsWith(height,
                         [&](Teuchos::ParameterList& bodies)
                         {
                           Teuchos::ParameterList& list =
                               bodies.sublist("Block").sublist("Operations").sublist("Spike");
                           list.set<std::string>("Operation", "Add");
                           fin(list, needle);
                         }),
              1u)
        << "spike of " << thin;
    EXPECT_EQ(frontsWith(height,
                         [&](Teuchos::ParameterList& bodies)
                         {
                           Teuchos::ParameterList& foil = bodies.sublist("Foil");
                           foil = bodies.sublist("Block");
                           foil.set("Lower Corner", numbers({26.0 * cell, 0.0}));
                           foil.set("Upper Corner", numbers({26.0 * cell + thin, 30.0 * cell}));
                         }),
              1u)
        << "foil of " << thin;
  }
}
