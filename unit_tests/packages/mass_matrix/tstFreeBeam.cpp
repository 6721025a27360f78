/// The period of a double cantilever beam of 4 cells an arm that is bent and let go, with each mass matrix.
///
/// The loads of xml_inputs/verification/dcb_h4.xml grow over about a period, so that they bend the beam
/// nearly as they would at rest, and are then removed; nothing damps it. The velocity's fraction of the shape
/// in which it was let go is zero twice a period. The periods that it is held to are those of prototypes
/// written before this program, with linear functions on the same mesh and no springs at the front.

#include "../../src/step/Bodies.hpp"

#include <cmath>
#include <cstdio>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double loading = 1.24e-3; ///< [s]
constexpr int periods = 3;

double periodWith(const std::string& type, const std::string& shape)
{
  const std::string history = "Boundaries:%s:History=0:0, 1.24e-3:1, 1.2400001e-3:0";
  const auto of = [&history](const std::string& arm) { return std::string(history).replace(11, 2, arm); };
  SceneResult scene =
      readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/verification/dcb_h4.xml",
                {"Cracks:Front Springs=false", "Domain:Shape Functions=" + shape, "Mass Matrix:Type=" + type,
                 "Time:CFL=0.4", "Time:Final Time=0.1", of("Upper Arm"), of("Lower Arm")},
                effectSchema());
  for (const SceneError& error : scene.errors)
    ADD_FAILURE() << toString(error);
  scene.list->remove("Damping");
  scene.list->remove("Energy Release");
  scene.list->remove("Reference");
  Rhegma::Run<2> run(validated(*scene.list));
  run.initialize();
  State<2>& state = run.state();
  const auto id = [&state] { return onHost(state.particles.integer(fields::id)); };
  const int size = state.particles.size();
  std::vector<Vector<2>> from(size), bent(size);
  const auto each = [&](const auto& work)
  {
    const HostParticles<2> particles(state);
    const auto number = id();
    for (int p = 0; p < size; ++p)
      work(particles, p, number(p));
  };
  each([&](const auto& particles, int p, int k) { from[k] = particles.at(p); });
  while (state.clock.time < loading)
    run.step(loading, false);
  each(
      [&](const auto& particles, int p, int k)
      {
        for (int d = 0; d < 2; ++d)
          bent[k][d] = particles.mass(p) * (particles.position(p, d) - from[k][d]);
      });

  std::vector<double> crossings;
  double before = 0.0, timeBefore = state.clock.time;
  // The first crossing is that of the moment at which it is let go.
  while (crossings.size() < 2 * periods + 1 && state.clock.time < (periods + 2) * 1.3e-3 + loading)
  {
    // A 400th of a period: the straight line between two samples is off by less than 1e-5 of a period.
    for (int k = 0; k < 7; ++k)
      run.step(1.0, false);
    double modal = 0.0;
    each(
        [&](const auto& particles, int p, int k)
        {
          for (int d = 0; d < 2; ++d)
            modal += bent[k][d] * particles.velocity(p, d);
        });
    if (modal * before < 0.0 && state.clock.time > loading + 0.3e-3)
      crossings.push_back(timeBefore + (state.clock.time - timeBefore) * before / (before - modal));
    before = modal;
    timeBefore = state.clock.time;
  }
  EXPECT_EQ(crossings.size(), 2u * periods + 1u) << type;
  return crossings.size() > 1 ? 2.0 * (crossings.back() - crossings.front()) / double(crossings.size() - 1)
                              : 0.0;
}

} // namespace

TEST(FreeBeam, HasThePeriodOfItsMatrix)
{
  struct Case
  {
    const char* type;
    double period; ///< [ms]
  };
  for (const Case& c : {Case{"Lumped", 1.2405}, Case{"Full", 1.2359}, Case{"FMPM", 1.2363}})
    for (const char* shape : {"Linear", "GIMP"})
    {
      const double period = 1e3 * periodWith(c.type, shape);
      std::printf("%s, %s: period %.4f ms, prototype %.4f ms\n", c.type, shape, period, c.period);
      EXPECT_NEAR(period, c.period, 0.003 * c.period) << c.type << " " << shape;
    }
}

} // namespace Test
} // namespace Rhegma
