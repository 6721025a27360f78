#include "throughput/Cases.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>

namespace Rhegma::benchmarks
{

namespace
{

using Numbers = Teuchos::Array<double>;

constexpr double cell = 1e-3;                     // [m]
constexpr double step = 0.4 * cell / 1924.6;      // of the material below, in plane strain [s]
constexpr double speed = 0.5, angularSpeed = 1.0; // [m/s], [1/s]

/// Cells along each axis: 5 : 4 in 2D with four particles each, 10 : 6 : 5 in 3D with eight.
std::vector<int> cellsOfBody(int dimension, int particles)
{
  const std::vector<double> sides =
      dimension == 2 ? std::vector<double>{5, 4} : std::vector<double>{10, 6, 5};
  double volume = dimension == 2 ? 4.0 : 8.0;
  for (const double side : sides)
    volume *= side;
  const double scale = std::pow(particles / volume, 1.0 / dimension);
  std::vector<int> cells;
  for (const double side : sides)
    cells.push_back(std::max(4, static_cast<int>(std::lround(scale * side))));
  return cells;
}

} // namespace

const std::vector<Case>& allCases()
{
  static const std::vector<Case> cases = {
      {"2d-linear", 2, false, false, 288.0, 5.0, ""},
      {"2d-linear-shear-at-centres", 2, false, false, 288.0, 5.0, "2d-linear", true},
      {"2d-gimp", 2, true, false, 288.0, 7.5, ""},
      {"2d-gimp-crack-elsewhere", 2, true, true, 288.0, 7.5, "2d-gimp"},
      {"2d-gimp-shear-at-centres", 2, true, false, 288.0, 7.5, "2d-gimp", true},
      {"3d-linear", 3, false, false, 472.0, 5.0, ""},
      {"3d-linear-shear-at-centres", 3, false, false, 472.0, 5.0, "3d-linear", true},
      {"3d-gimp", 3, true, false, 472.0, 10.0, ""},
      {"3d-gimp-shear-at-centres", 3, true, false, 472.0, 10.0, "3d-gimp", true},
  };
  return cases;
}

Teuchos::RCP<Teuchos::ParameterList> makeScene(const Case& which, int particles, int flow)
{
  const int dimension = which.dimension;
  const std::vector<int> cells = cellsOfBody(dimension, particles);
  const Numbers origin(dimension, 0.0);
  Numbers corner, domainLower, domainUpper, velocity(dimension, 0.0);
  const double factor = flow > 0 ? 100.0 : 1.0;
  double size = 0.0;
  for (const int n : cells)
    size += n * cell;
  const double turned = flow * step * factor * angularSpeed * size, flown = flow * step * factor * speed;
  for (const int n : cells)
  {
    corner.push_back(n * cell);
    domainLower.push_back(-4 * cell - std::ceil(turned / cell) * cell);
    domainUpper.push_back((n + 4) * cell + std::ceil(turned / cell) * cell);
  }
  velocity[0] = factor * speed;
  domainUpper[0] += std::ceil(flown / cell) * cell;

  const auto scene = Teuchos::rcp(new Teuchos::ParameterList("Rhegma"));
  Teuchos::ParameterList& domain = scene->sublist("Domain");
  domain.set("Dimension", dimension);
  domain.set("Lower Corner", domainLower);
  domain.set("Upper Corner", domainUpper);
  domain.set("Cell Size", cell);
  domain.set("Shape Functions", std::string(which.gimp ? "GIMP" : "Linear"));
  domain.set("Shear Strain", std::string(which.centres ? "At Cell Centres" : "At Particles"));
  scene->sublist("Time").set("Final Time", 1.0);
  Teuchos::ParameterList& material = scene->sublist("Materials").sublist("Polymer");
  material.set("Model", std::string("Linear Elastic"));
  material.set("Density", 1200.0);
  material.set("Young Modulus", 3e9);
  material.set("Poisson Ratio", 0.33);
  Teuchos::ParameterList& body = scene->sublist("Bodies").sublist("Block");
  body.set("Material", std::string("Polymer"));
  body.set("Shape", std::string("Box"));
  body.set("Lower Corner", origin);
  body.set("Upper Corner", corner);
  body.set("Velocity", velocity);
  body.set("Angular Velocity", Numbers(dimension == 2 ? 1 : 3, factor * angularSpeed));
  if (which.crack)
  {
    // At a quarter of the body from its corner, four cells long.
    const double x = std::floor(0.25 * cells[0]) * cell, y = std::floor(0.25 * cells[1]) * cell;
    scene->sublist("Cracks").sublist("Far").set("Points", Numbers({x, y, x + 4 * cell, y}));
  }
  return scene;
}

} // namespace Rhegma::benchmarks
