/// What heat that crosses a beam takes from its vibration.

#include "Pi.hpp"
#include "src/step/Bodies.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace Rhegma
{
namespace Test
{

namespace
{

using Rhegma::Test::pi;
constexpr double start = 300.0;

/// Loss of amplitude in a period of a free beam of 64 x 8 m in its first mode of bending, over pi: the
/// inverse quality. \param expansion of its material [1/K] \param conductivity [W/(m K)] \param frequency
/// out: angular, as it was [1/s]
double inverseQuality(double expansion, double conductivity, double& frequency)
{
  const double beam = 64.0, depth = 8.0, k = 4.730041 / beam, sigma = 0.982502;
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-4.0, -8.0}}, Vector<2>{{68.0, 16.0}}, 1.0, "MUSL", "GIMP", "Stress");
  addMaterial(scene, "Linear Elastic", 0.0);
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  material.set("Specific Heat", 0.85);
  material.set("Conductivity", conductivity);
  material.set("Thermal Expansion", expansion);
  addBox<2>(scene, "Beam", Vector<2>{{0.0, 0.0}}, Vector<2>{{beam, depth}});
  scene.sublist("Thermal").set("Initial Temperature", start);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  const auto mode = [&](double x)
  { return std::cosh(k * x) + std::cos(k * x) - sigma * (std::sinh(k * x) + std::sin(k * x)); };
  const HostParticles<2> particles(run.state());
  for (int p = 0; p < particles.size; ++p)
    particles.velocity(p, 1) = 1e-4 * mode(particles.position(p, 0));
  particles.store(run.state());
  // Largest amplitude around the beginning of the second and the third period.
  std::vector<double> peaks, crossings;
  double last = 0.0, largest = 0.0, before = 0.0;
  while (crossings.size() < 6)
  {
    run.step(1e30, false);
    const HostParticles<2> now(run.state());
    double amplitude = 0.0;
    for (int p = 0; p < now.size; ++p)
      amplitude += now.velocity(p, 1) * mode(now.position(p, 0));
    const double time = run.state().clock.time;
    if (last * amplitude < 0.0)
    {
      crossings.push_back(before + (time - before) * last / (last - amplitude));
      peaks.push_back(largest);
      largest = 0.0;
    }
    largest = std::max(largest, std::fabs(amplitude));
    last = amplitude;
    before = time;
  }
  frequency = 2.0 * pi / (crossings[5] - crossings[3]);
  // Peaks 1 and 5 are two periods apart.
  return std::log(peaks[1] / peaks[5]) / (2.0 * pi);
}

} // namespace

/// A bent beam warms where it is compressed, and heat that crosses it takes energy: Zener's 1/Q = Delta w tau
/// / (1 + (w tau)^2), Delta = E alpha^2 T / (rho c_p), tau = depth^2 rho c_p / (pi^2 k) (Phys. Rev. 52 (1937)
/// 230); here close to its largest, Delta / 2.
TEST(BentBeam, IsDampedAsZenerSays)
{
  const double delta = 0.05, capacity = 1.0; // at constant stress: 0.85 + 3 E alpha^2 T for nu = 0
  const double expansion = std::sqrt(delta / start), conductivity = 0.08;
  double frequency = 0.0, without = 0.0;
  const double own = inverseQuality(0.0, conductivity, without);
  const double damped = inverseQuality(expansion, conductivity, frequency) - own;
  const double tau = 64.0 * capacity / (pi * pi * conductivity), product = frequency * tau;
  const double zener = delta * product / (1.0 + product * product);
  std::printf("1/Q %.5f, of it own %.5f; Zener %.5f at w tau = %.3f\n", damped, own, zener, product);
  EXPECT_LT(std::fabs(own), 0.1 * zener);
  EXPECT_NEAR(damped, zener, 0.1 * zener);
}

} // namespace Test
} // namespace Rhegma
