/// The beam of verification/dcb_adaptive.xml on base cells twice as large: substeps of fine cells find the
/// energy release rate that substeps of all cells find, and leave the beam at rest.

#include "Simulation.hpp"

#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <iostream>

using namespace Rhegma;

namespace
{

/// What summary.json would hold once the beam of a scene is at rest.
nlohmann::json atRest(const std::string& name, bool substeps)
{
  const SceneResult scene =
      readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/verification/" + name + ".xml",
                {"Domain:Cell Size=2.5e-3", "Damping:Stop When Settled=false"}, effectSchema());
  for (const SceneError& error : scene.errors)
    ADD_FAILURE() << toString(error);
  if (!substeps)
    scene.list->remove("Sub-Cycling");
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), scene.list);
  simulation.initialize();
  simulation.sampleEvery(1e-4, {});
  simulation.advance(3e-3);
  return simulation.report();
}

} // namespace

class CrackedBeam : public testing::TestWithParam<const char*>
{
};

TEST_P(CrackedBeam, ReleasesTheSameWithAndWithoutSubsteps)
{
  const nlohmann::json some = atRest(GetParam(), true), all = atRest(GetParam(), false);
  for (const char* quantity : {"G_J", "G_closure"})
  {
    const double a = some["cracks"][0]["fronts"][0][quantity].get<double>(),
                 b = all["cracks"][0]["fronts"][0][quantity].get<double>();
    std::cout << quantity << ": " << a << ", in substeps of all cells " << b << " J/m2, "
              << 100.0 * (a / b - 1.0) << " %\n";
    EXPECT_NEAR(a, b, 5e-4 * b);
  }
  // Impulses of coarse cells that made the beam tremble left ten times as much motion as substeps of all.
  EXPECT_LT(some["energy"]["kinetic"].get<double>(), 2.0 * all["energy"]["kinetic"].get<double>());
}

INSTANTIATE_TEST_SUITE_P(SubCycling, CrackedBeam, testing::Values("dcb_adaptive", "dcb_adaptive_partial"));
