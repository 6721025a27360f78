#pragma once
/// Laws of shared libraries (unit_tests/laws) and random paths of strain.

#include "Cases.hpp"

#include <cstdlib>
#include <iostream>
#include <vector>

namespace Rhegma
{
namespace Test
{

/// Of metals, with a modulus of order one.
struct Metal
{
  double young = 2.6, poisson = 0.3, yield = 0.01, hardening = 0.05;
};

inline Teuchos::ParameterList sharedLaw(const std::string& library, const std::string& interface,
                                        const std::string& behaviour, const Metal& metal)
{
  Teuchos::ParameterList list;
  list.set("Model", "Shared Library");
  list.set("Density", 2.0);
  list.set("Young Modulus", metal.young);
  list.set("Poisson Ratio", metal.poisson);
  list.set("Library File", std::string(RHEGMA_LAWS) + "/" + library + ".so");
  list.set("Interface", interface);
  list.set("Behaviour", behaviour);
  list.set("Constants", Teuchos::Array<double>(
                            std::vector<double>{metal.young, metal.poisson, metal.yield, metal.hardening}));
  return list;
}

/// History of any law.
using LawHistory = std::array<double, historyCapacity>;

/// A particle that a law strains step by step.
template <int D>
struct Strained
{
  Properties law;
  Gradient<D> F = identity<D>();
  LawHistory history{};
  Symmetric<D> tau{};
  bool good = true;

  explicit Strained(const Properties& of) : law(of) {}

  /// Goes on to a deformation gradient; in plane stress its zz is ignored.
  void strain(Gradient<D> to, double dt = 1e-3)
  {
    const Gradient<D> before = F;
    if (D == 2 && law.plane == Plane::Stress)
      to[gradientSize<D> - 1] = before[gradientSize<D> - 1];
    F = to;
    good = updateStress<D>({before.data(), dt, 293.15}, law, F.data(), tau.data(), history.data()) && good;
  }
  double stored() const { return storedEnergy<D>(law, F.data(), history.data()); }
  double dissipated() const { return dissipatedEnergy<D>(law, history.data()); }
};

/// A smooth path between random stretches, with random turns: `legs` legs of `steps` steps. zz is one.
template <int D>
std::vector<Gradient<D>> randomPath(unsigned seed, double size, int legs, int steps)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  std::vector<Gradient<D>> path;
  Gradient<D> F = identity<D>();
  for (int leg = 0; leg < legs; ++leg)
  {
    Gradient<D> step = identity<D>();
    for (int k = 0; k < D * D; ++k)
      step[k] += size / steps * draw(engine);
    const double spin = draw(engine) / steps;
    step[1] -= spin;
    step[D] += spin;
    for (int s = 0; s < steps; ++s)
      path.push_back(F = multiply<D>(step, F));
  }
  return path;
}

/// A seed, printed; RHEGMA_SEED in the environment repeats one.
inline unsigned seedOf(const char* test)
{
  const char* const given = std::getenv("RHEGMA_SEED");
  const unsigned seed = given != nullptr ? std::atoi(given) : std::random_device{}() % 1000000;
  std::cout << test << ": RHEGMA_SEED=" << seed << "\n";
  return seed;
}

} // namespace Test
} // namespace Rhegma
