/// The largest and the smallest value of a field, and where they are.

#include "measure/Extremes.hpp"
#include "src/step/Bodies.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr int edge = 4; ///< of a body [m]

/// Two bodies next to each other.
template <int D>
Teuchos::ParameterList twoBodies()
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-2.0), all<D>(2.0 * edge + 4.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<D>(scene, "Left", all<D>(0.0), all<D>(double(edge)));
  Vector<D> lower = all<D>(0.0), upper = all<D>(double(edge));
  lower[0] += edge + 2.0;
  upper[0] += edge + 2.0;
  addBox<D>(scene, "Right", lower, upper);
  return scene;
}

/// Bars of random tension along x; the largest of each body is where the test looks for it.
template <int D>
void testAgainstSearch()
{
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  Rhegma::Run<D> run(validated(twoBodies<D>()));
  run.initialize();
  State<D>& state = run.state();
  const HostParticles<D> particles(state);
  const auto body = onHost(state.particles.integer(fields::body));
  double most[3] = {-2.0, -2.0, -2.0}, fastest = 0.0;
  Vector<D> where[3] = {}, there{};
  for (int p = 0; p < particles.size; ++p)
  {
    for (int k = 0; k < symmetricSize<D>; ++k)
      particles.stress(p, k) = 0.0;
    // Pressed along y: along z, and without tension along x, there is no stress.
    particles.stress(p, 0) = between(random);
    particles.stress(p, 1) = -2.0;
    particles.velocity(p, 1) = between(random);
    const double value = std::max(particles.stress(p, 0), 0.0);
    for (const int group : {body(p), 2})
      if (value > most[group])
      {
        most[group] = value;
        where[group] = particles.at(p);
      }
    if (std::fabs(particles.velocity(p, 1)) > fastest)
    {
      fastest = std::fabs(particles.velocity(p, 1));
      there = particles.at(p);
    }
  }
  particles.store(state);
  for (const int group : {0, 1, 2})
  {
    const auto found = measure::extremesOf(state, "Principal Stress", group == 2 ? -1 : group);
    EXPECT_DOUBLE_EQ(found.largest.value, most[group]);
    EXPECT_EQ(found.smallest.value, 0.0);
    for (int d = 0; d < D; ++d)
      EXPECT_EQ(found.largest.where[d], where[group][d]);
  }
  const auto speed = measure::extremesOf(state, "Speed", -1);
  EXPECT_DOUBLE_EQ(speed.largest.value, fastest);
  EXPECT_GE(speed.smallest.value, 0.0);
  for (int d = 0; d < D; ++d)
    EXPECT_EQ(speed.largest.where[d], there[d]);
  EXPECT_EQ(measure::extremesOf(state, "Displacement", -1).largest.value, 0.0);
  EXPECT_EQ(measure::extremesOf(state, "Energy Density", -1).largest.value, 0.0); // undeformed
}

} // namespace

TEST(Extremes, AreThoseOfASearch) { testAgainstSearch<2>(); }
TEST(Extremes, AreThoseOfASearch3D) { testAgainstSearch<3>(); }

TEST(Extremes, HaveNoValueWithoutParticles)
{
  Rhegma::Run<2> run(validated(twoBodies<2>()));
  run.initialize();
  EXPECT_TRUE(std::isnan(measure::extremesOf(run.state(), "Speed", 7).largest.value));
}

TEST(Extremes, OfAnUnknownFieldAreRefused)
{
  Rhegma::Run<2> run(validated(twoBodies<2>()));
  run.initialize();
  EXPECT_THROW(measure::extremesOf(run.state(), "Colour", -1), std::invalid_argument);
}

/// Columns of the history and entries of the summary on request.
TEST(Extremes, AreInTheHistoryAndTheSummary)
{
  Teuchos::ParameterList scene = twoBodies<2>();
  Teuchos::ParameterList& asked = scene.sublist("Measure").sublist("Extremes").sublist("Peak");
  asked.set("Field", std::string("Von Mises Stress"));
  asked.set("Body", std::string("Right"));
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  run.step(1e30, true);
  const HistoryRow& row = run.state().sample.row;
  for (const char* column : {"Peak.largest", "Peak.largest_x", "Peak.largest_y", "Peak.smallest",
                             "Peak.smallest_x", "Peak.smallest_y"})
    EXPECT_EQ(std::count_if(row.begin(), row.end(), [&](const auto& c) { return c.first == column; }), 1)
        << column;
  nlohmann::json summary;
  for (const Effect<2>& effect : run.plan().effects)
    if (effect.name == "Measure")
      effect.report(run.state(), summary);
  const nlohmann::json& entry = summary["extremes"]["Peak"];
  EXPECT_EQ(entry["field"], "Von Mises Stress");
  EXPECT_GT(entry["largest_position"][0].get<double>(), edge + 2.0);
}

TEST(Extremes, OfABodyThatDoesNotExistAreRefused)
{
  Teuchos::ParameterList scene = twoBodies<2>();
  Teuchos::ParameterList& asked = scene.sublist("Measure").sublist("Extremes").sublist("Peak");
  asked.set("Field", std::string("Speed"));
  asked.set("Body", std::string("Rihgt"));
  Rhegma::Run<2> run(validated(scene));
  EXPECT_THROW(run.initialize(), std::invalid_argument);
}

} // namespace Test
} // namespace Rhegma
