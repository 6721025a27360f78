#pragma once
/// A block of 3D material with a flat crack, written as a list.

#include "src/step/ElasticBox.hpp"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace Rhegma::cracks::test
{

using Numbers = Teuchos::Array<double>;

inline Numbers numbers(const std::vector<double>& values) { return Numbers(values.begin(), values.end()); }

constexpr double cell = 1e-3, young = 3e9, poisson = 0.3, density = 1200.0;
const Test::ElasticSolid solid{density, young, poisson};

/// \param upper corner of a box whose lower corner is the origin; its dimension is the scene's
inline Teuchos::ParameterList blockScene(const std::vector<double>& upper, double margin = 4.0)
{
  if (upper.size() == 2)
    return Test::elasticBox<2>({}, {upper[0], upper[1]}, cell, margin, solid, "Block");
  return Test::elasticBox<3>({}, {upper[0], upper[1], upper[2]}, cell, margin, solid, "Block");
}

inline void setCrack(Teuchos::ParameterList& scene, const std::vector<double>& points)
{
  scene.sublist("Cracks").sublist("Cut").set("Points", numbers(points));
}

/// Points of a regular polygon in the plane z = centre[2], anticlockwise seen from above.
inline std::vector<double> regularPolygon(const Vector<3>& centre, double radius, int corners)
{
  std::vector<double> points;
  for (int k = 0; k < corners; ++k)
  {
    const double angle = 2.0 * std::acos(-1.0) * (k + 0.5) / corners;
    points.push_back(centre[0] + radius * std::cos(angle));
    points.push_back(centre[1] + radius * std::sin(angle));
    points.push_back(centre[2]);
  }
  return points;
}

/// Numbers from RHEGMA_SEED of the environment, or from a seed that is printed.
class Draws
{
public:
  Draws()
  {
    const char* const given = std::getenv("RHEGMA_SEED");
    const unsigned long seed = given != nullptr ? std::strtoul(given, nullptr, 10) : std::random_device{}();
    std::cout << "RHEGMA_SEED=" << seed << "\n";
    random_.seed(seed);
  }
  double operator()(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

private:
  std::mt19937_64 random_;
};

template <int D>
std::unique_ptr<Run<D>> start(Teuchos::ParameterList scene)
{
  auto run = std::make_unique<Run<D>>(Test::validated(scene));
  run->initialize();
  return run;
}

/// Gives every particle the velocity of its position.
template <int D, class Velocity>
void setVelocity(State<D>& state, const Velocity& velocity)
{
  const auto x = onHost(state.particles.template real<D>(fields::position));
  const auto v = state.particles.template real<D>(fields::velocity);
  const auto host = onHost(v);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    Vector<D> at;
    for (int d = 0; d < D; ++d)
      at[d] = x(p, d);
    const Vector<D> of = velocity(at);
    for (int d = 0; d < D; ++d)
      host(p, d) = of[d];
  }
  Kokkos::deep_copy(v, host);
}

} // namespace Rhegma::cracks::test
