#include "face_pressure/FacePressure.hpp"

#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"
#include "step/Run.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace Rhegma;
using namespace Rhegma::face_pressure;

namespace
{

SceneResult scene(const std::vector<std::string>& overrides)
{
  return readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/verification/sudden_pressure.xml", overrides,
                   effectSchema());
}

constexpr double cell = 5e-4;

} // namespace

/// Both faces get p times the length of the crack: the nodes at the front, and those that are ahead of it by
/// less than the lag, have two fields.
TEST(FacePressure, PushesFacesApartInBalance)
{
  Rhegma::Run<2> run(*scene({"Domain:Cell Size=5e-4"}).list);
  run.initialize();
  run.step(1e-9, false);
  State<2>& state = run.state();
  FacePoints<2> points;
  points.update(state);
  const auto sums = onHost(state.mesh.nodes.sums);
  for (std::size_t n = 0; n < sums.extent(0); ++n)
    for (int d = 0; d < 2; ++d)
      sums(n, Nodes<2>::forceAt + d) = 0.0;
  Kokkos::deep_copy(state.mesh.nodes.sums, sums);
  FacePressure pressure(0, TimeFunction::parse("2e6"));
  pressure.apply(state, points);
  Kokkos::deep_copy(sums, state.mesh.nodes.sums);
  const auto side = onHost(state.cracks.nodeSide);
  const auto second = onHost(state.cracks.enrichedField);
  double above = 0.0, all = 0.0, along = 0.0;
  for (int n = 0; n < state.mesh.nodes.numLattice; ++n)
  {
    const auto add = [&](int row, bool isAbove)
    {
      all += sums(row, Nodes<2>::forceAt + 1);
      along += std::abs(sums(row, Nodes<2>::forceAt));
      above += isAbove ? sums(row, Nodes<2>::forceAt + 1) : 0.0;
    };
    add(n, side(n) > 0);
    if (second(n) >= 0)
      add(second(n), side(n) < 0);
  }
  const auto length = onHost(points.size);
  double crack = 0.0;
  for (int k = 0; k < points.count(); ++k)
    crack += length(k);
  const double expected = 2e6 * crack;
  EXPECT_NEAR(above, expected, 1e-12 * expected);
  EXPECT_NEAR(all, 0.0, 1e-12 * expected);
  EXPECT_NEAR(along, 0.0, 1e-12 * expected);
}

TEST(FacePressure, NamesCracksThatAreThere)
{
  const SceneResult wrong = scene({"Face Pressure:Edge:Pressure=1e6 +"});
  ASSERT_EQ(wrong.errors.size(), 1u);
  EXPECT_EQ(wrong.errors[0].where, "Face Pressure > Edge > Pressure");
  Teuchos::ParameterList list;
  list.sublist("Face Pressure").sublist("Ege");
  std::vector<SceneError> errors;
  checkRules(list, effectSchema(), errors);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].where, "Face Pressure");
  list.sublist("Cracks").sublist("Edge");
  errors.clear();
  checkRules(list, effectSchema(), errors);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].where, "Face Pressure > Ege");
  EXPECT_NE(errors[0].message.find("Edge"), std::string::npos);
}

/// K_I(t) = 2 p sqrt(cd t (1 - 2 nu) / pi) / (1 - nu) (Freund, Dynamic Fracture Mechanics, Cambridge 1990,
/// section 2.5), within 5 % from when waves have gone round the contour (1.5 us) until they come back from
/// the boundaries (10 us); the work of the pressure is what the energies gain.
TEST(FacePressure, GivesFreundsSquareRootLaw)
{
  Rhegma::Run<2> run(*scene({}).list);
  run.initialize();
  State<2>& state = run.state();
  const double young = 3e9, poisson = 0.3, density = 1200.0, pressure = 1e6;
  const double speed =
      std::sqrt(young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson)) / density);
  int samples = 0;
  for (double until = 1.5e-6; until < 1.0e-5; until += 0.5e-6)
  {
    while (state.clock.time < until)
      run.step(until, state.clock.time + run.stableTimeStep() >= until);
    const double expected = 2.0 * pressure *
                            std::sqrt(speed * state.clock.time * (1.0 - 2.0 * poisson) / std::acos(-1.0)) /
                            (1.0 - poisson);
    for (const auto& [name, value] : state.sample.row)
      if (name == "Edge.0.K_I")
      {
        ++samples;
        EXPECT_NEAR(value, expected, 0.05 * expected) << "at " << state.clock.time << " s";
      }
  }
  EXPECT_GE(samples, 15);
}
