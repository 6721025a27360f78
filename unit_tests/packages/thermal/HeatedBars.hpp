#pragma once
/// Bars in which heat flows, and what tests measure in them.

#include "src/step/Bodies.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace Rhegma
{
namespace Test
{

constexpr double start = 300.0;

/// Heat alone in a box of 6 x 2 (x 2) m of capacity 2 J/(m3 K) and conductivity 2 W/(m K): a diffusivity of 1
/// m2/s.
template <int D>
Teuchos::ParameterList bar(double cell = 1.0, const std::string& shape = "GIMP", double length = 6.0,
                           double width = 2.0)
{
  Vector<D> upper = all<D>(width + 2.0), size = all<D>(width);
  upper[0] = length + 2.0;
  size[0] = length;
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-2.0), upper, cell, "MUSL", shape);
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  material.set("Model", "Rigid");
  material.set("Density", 1.0);
  material.set("Specific Heat", 2.0);
  material.set("Conductivity", 2.0);
  addBox<D>(scene, "Bar", all<D>(0.0), size);
  scene.sublist("Thermal").set("Initial Temperature", start);
  scene.sublist("Thermal").set("Mechanics", false);
  return scene;
}

template <int D>
void hold(Teuchos::ParameterList& scene, const std::string& name, double from, double to, double temperature)
{
  Vector<D> lower = all<D>(-9.0), upper = all<D>(9.0);
  lower[0] = from;
  upper[0] = to;
  Teuchos::ParameterList& list = scene.sublist("Boundaries").sublist(name);
  list.set("Type", "Temperature");
  list.set("Lower Corner", array(lower));
  list.set("Upper Corner", array(upper));
  list.set("Temperature", temperature);
}

inline Teuchos::Array<double> numbers(const std::vector<double>& values)
{
  return Teuchos::Array<double>(values);
}

/// Calls work(position, temperature) for every particle.
template <int D, class Work>
void forEach(const State<D>& state, const Work& work)
{
  const auto x = onHost(state.particles.template real<D>(fields::position));
  const auto T = onHost(state.particles.scalar(fields::temperature));
  for (int p = 0; p < state.particles.size(); ++p)
  {
    Vector<D> position;
    for (int d = 0; d < D; ++d)
      position[d] = x(p, d);
    work(position, T(p));
  }
}

/// Largest difference of particles with x from 1 to 5 m from exact(position) [K]; fails where these are few.
template <int D, class Exact>
double worstBetween(const State<D>& state, const Exact& exact)
{
  double worst = 0.0;
  int inside = 0;
  forEach<D>(state,
             [&](const Vector<D>& position, double T)
             {
               if (position[0] < 1.0 || position[0] > 5.0)
                 return;
               ++inside;
               worst = std::max(worst, std::fabs(T - exact(position)));
             });
  EXPECT_GT(inside, 20);
  return worst;
}

/// Gives all particles a temperature between 200 and 400 K at random, and their heat.
template <int D>
void randomTemperature(State<D>& state)
{
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> between(200.0, 400.0);
  const auto T = state.particles.scalar(fields::temperature),
             e = state.particles.scalar(fields::internalEnergy);
  const auto hostT = onHost(T), hostE = onHost(e);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    hostT(p) = between(engine);
    hostE(p) = ThermoPoint(state.materials.thermo, 0, hostT(p)).heat();
  }
  Kokkos::deep_copy(T, hostT);
  Kokkos::deep_copy(e, hostE);
}

/// Heat of all particles, and the sum of its sizes [J].
template <int D>
std::pair<double, double> heatOf(const State<D>& state)
{
  const auto V = onHost(state.particles.scalar(fields::volume));
  const auto e = onHost(state.particles.scalar(fields::internalEnergy));
  double sum = 0.0, size = 0.0;
  for (int p = 0; p < state.particles.size(); ++p)
  {
    sum += V(p) * e(p);
    size += std::fabs(V(p) * e(p));
  }
  return {sum, size};
}

template <int D>
void steps(Run<D>& run, int count)
{
  for (int s = 0; s < count; ++s)
    run.step(1e30, false);
}

template <int D>
void refineMiddle(Teuchos::ParameterList& scene, int level)
{
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", level);
  Vector<D> lower = all<D>(0.0), upper = all<D>(1.0);
  lower[0] = 2.0;
  upper[0] = 4.0;
  adaptivity.sublist("Middle").set("Lower Corner", array(lower));
  adaptivity.sublist("Middle").set("Upper Corner", array(upper));
  adaptivity.sublist("Middle").set("Level", level);
}

} // namespace Test
} // namespace Rhegma
