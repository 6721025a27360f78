/// Reports of bodies and supports in summary.json.

#include "Bodies.hpp"

#include "Simulation.hpp"
#include "output/BodyReport.hpp"
#include "transfer/Gather.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace Rhegma
{
namespace Test
{

/// A support that brings a body at rest to 2 m/s in one step gives it the impulse 2 m; the force is that over
/// the step.
TEST(Reports, ForceOfASupportIsItsImpulseOverTime)
{
  Teuchos::ParameterList scene = emptyScene<2>(all<2>(0.0), all<2>(8.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<2>(scene, "Block", all<2>(2.0), all<2>(5.0));
  Teuchos::ParameterList& push = scene.sublist("Boundaries").sublist("Push");
  push.set("Type", "Velocity");
  push.set("Lower Corner", array(all<2>(0.0)));
  push.set("Upper Corner", array(all<2>(8.0)));
  push.set("Components", "y");
  push.set("Value", array(Vector<2>{{0.0, 2.0}}));
  Simulation simulation(Teuchos::DefaultComm<int>::getComm(),
                        Teuchos::rcp(new Teuchos::ParameterList(validated(scene))));
  simulation.initialize();
  double column = 0.0;
  simulation.sampleEvery(1e-3,
                         [&](double, const Simulation::Row& row)
                         {
                           for (const auto& [name, value] : row)
                             if (name == "Push.force_y")
                               column = value;
                         });
  const double time = 0.5 * simulation.stableTimeStep();
  simulation.advance(time);
  const nlohmann::json report = simulation.report();
  const nlohmann::json& support = report["boundaries"][0];
  const nlohmann::json& body = report["bodies"][0];
  EXPECT_EQ(support["name"], "Push");
  EXPECT_NEAR(support["force"][0].get<double>(), 0.0, 1e-12);
  EXPECT_NEAR(support["force"][1].get<double>(), 9.0 * 2.0 / time, 1e-11 * 18.0 / time);
  EXPECT_EQ(column, support["force"][1].get<double>());
  EXPECT_EQ(body["name"], "Block");
  EXPECT_NEAR(body["mass"].get<double>(), 9.0, 1e-12);
  EXPECT_NEAR(body["velocity"][1].get<double>(), 2.0, 1e-12);
  EXPECT_NEAR(body["centre"][0].get<double>(), 3.5, 1e-12);
  EXPECT_NEAR(body["centre"][1].get<double>(), 3.5 + 2.0 * time, 1e-12);
}

/// A load of 3 N along y on a point and a traction of 2 Pa along x on an edge of 3 m, which grow as t: as
/// each step takes them at its middle, their mean between two samples is what they are half-way.
TEST(Reports, ForceOfALoadIsItsMeanSinceTheLastSample)
{
  Teuchos::ParameterList scene = emptyScene<2>(all<2>(0.0), all<2>(8.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<2>(scene, "Block", all<2>(2.0), all<2>(5.0));
  Teuchos::ParameterList& point = scene.sublist("Boundaries").sublist("Poke");
  point.set("Type", "Point Load");
  point.set("Body", "Block");
  point.set("Point", array(Vector<2>{{3.0, 5.0}}));
  point.set("Force", array(Vector<2>{{0.0, 3.0}}));
  point.set("History", "t");
  Teuchos::ParameterList& pull = scene.sublist("Boundaries").sublist("Pull");
  pull.set("Type", "Traction");
  pull.set("Body", "Block");
  pull.set("From", array(Vector<2>{{5.0, 2.0}}));
  pull.set("To", array(Vector<2>{{5.0, 5.0}}));
  pull.set("Stress", array(Vector<2>{{2.0, 0.0}}));
  pull.set("History", "t");
  Simulation simulation(Teuchos::DefaultComm<int>::getComm(),
                        Teuchos::rcp(new Teuchos::ParameterList(validated(scene))));
  simulation.initialize();
  const double time = 7.3 * simulation.stableTimeStep();
  std::map<std::string, double> row;
  double before = 0.0, last = 0.0; // times of the samples
  simulation.sampleEvery(0.5 * time,
                         [&](double now, const Simulation::Row& columns)
                         {
                           row = std::map<std::string, double>(columns.begin(), columns.end());
                           before = last;
                           last = now;
                         });
  simulation.advance(time);
  ASSERT_GT(last, before);
  const double middle = 0.5 * (before + last);
  EXPECT_NEAR(row.at("Poke.force_y"), 3.0 * middle, 1e-11 * time);
  EXPECT_NEAR(row.at("Poke.force_x"), 0.0, 1e-11 * time);
  EXPECT_NEAR(row.at("Pull.force_x"), 2.0 * 3.0 * middle, 1e-11 * time);
  const nlohmann::json report = simulation.report();
  ASSERT_EQ(report["boundaries"].size(), 2U);
  EXPECT_EQ(report["boundaries"][0]["name"], "Poke");
  EXPECT_EQ(report["boundaries"][0]["force"][1].get<double>(), row.at("Poke.force_y"));
  EXPECT_EQ(report["boundaries"][1]["force"][0].get<double>(), row.at("Pull.force_x"));
}

/// Stress is averaged over the volume now, the deformation gradient over the undeformed one: of two
/// particles, one is stretched to twice its volume.
TEST(Reports, MeansAreOverTheirOwnVolumes)
{
  Teuchos::ParameterList scene = emptyScene<3>(all<3>(0.0), all<3>(4.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Neo-Hookean", 0.3);
  Vector<3> end = all<3>(2.0);
  end[0] = 3.0;
  addBox<3>(scene, "Pair", all<3>(1.0), end).set("Particles Per Cell", 1);
  Teuchos::ParameterList complete = validated(scene);
  Rhegma::Run<3> run(complete);
  run.initialize();
  const HostParticles<3> particles(run.state());
  ASSERT_EQ(particles.size, 2);
  particles.deformation(1, 0) = 2.0;
  particles.deformation(1, 1) = 0.5;
  particles.stress(0, 0) = 3.0;
  particles.stress(1, 0) = 12.0;
  particles.stress(1, 5) = 6.0;
  particles.store(run.state());
  nlohmann::json report;
  bodyReport(run.state(), report);
  const nlohmann::json& body = report["bodies"][0];
  EXPECT_NEAR(body["deformation"]["xx"].get<double>(), 1.5, 1e-14);
  EXPECT_NEAR(body["deformation"]["xy"].get<double>(), 0.25, 1e-14);
  EXPECT_NEAR(body["deformation"]["zz"].get<double>(), 1.0, 1e-14);
  // (1 * 3 + 2 * 12/2) / (1 + 2)
  EXPECT_NEAR(body["stress"]["xx"].get<double>(), 5.0, 1e-14);
  EXPECT_NEAR(body["stress"]["xz"].get<double>(), 2.0, 1e-14);
}

} // namespace Test
} // namespace Rhegma
