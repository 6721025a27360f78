/// Nodal fields of an effect in a run whose cells change and whose ranks divide them anew; run on one rank
/// and on two.

#include "Simulation.hpp"
#include "plan/KnownEffects.hpp"
#include "state/Subdomain.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace Rhegma;

namespace
{

/// What the effect has seen.
struct Seen
{
  int remeshed = 0, divided = 0; ///< how often
  int zeros = 0;                 ///< new nodes of refined cells, of all ranks
  double error = 0.0;            ///< largest, of fields that are functions of the position
  std::shared_ptr<Subdomain<2>> subdomain;
};

Seen seen;

double valueAt(const Vector<2>& x) { return 1.0 + 3.0 * x[0] - 2.0 * x[1]; }

void check(State<2>& state)
{
  const NodalFieldTable<2>& fields = state.mesh.nodalFields;
  const auto kept = fields.scalar("kept"), interpolated = fields.scalar("interpolated");
  const NodePositions<2> positions = nodePositions(state);
  const auto& foreign = state.mesh.nodes.foreign;
  seen.remeshed += fields.lastRemesh() == state.clock.step ? 1 : 0;
  seen.divided += seen.subdomain && seen.subdomain != state.mesh.subdomain &&
                          seen.subdomain->refined == state.mesh.subdomain->refined
                      ? 1
                      : 0;
  seen.subdomain = state.mesh.subdomain;
  double zeros = 0.0;
  for (int n = 0; n < state.mesh.nodes.numLattice; ++n)
  {
    const double value = valueAt(positions(n));
    if (state.clock.step == 0)
      interpolated(n) = value;
    if (foreign.extent(0) == 0 || foreign(n) == 0)
    {
      seen.error = std::fmax(seen.error, std::fabs(interpolated(n) - value));
      if (state.clock.step > 0 && kept(n) == 0.0 && n >= state.mesh.grid.numNodes)
        zeros += 1.0;
      else if (state.clock.step > 0)
        seen.error = std::fmax(seen.error, std::fabs(kept(n) - value));
    }
    kept(n) = value;
  }
  seen.zeros += static_cast<int>(state.ranks.sum(zeros));
}

template <int D>
Effect<D> make(const Teuchos::ParameterList&)
{
  Effect<D> effect;
  effect.name = "Nodal Memory";
  effect.addsNodal = {{{"kept", 1, "", "a function of the position"}},
                      {{"interpolated", 1, "", "the same"}, OnRemesh::Interpolate}};
  if constexpr (D == 2)
    effect.call({Stage::Scatter, "check of nodal fields", {}, {}, {}, check});
  return effect;
}

} // namespace

TEST(OnRanks, NodalFieldsFollowTheirNodes)
{
  addEffect({Section("Nodal Memory", "Nothing at all."), {}, make<2>, make<3>, true});
  const auto scene =
      Teuchos::getParametersFromXmlFile(RHEGMA_SOURCE_DIR "/xml_inputs/examples/adaptive_wave.xml");
  scene->sublist("Nodal Memory");
  scene->sublist("Load Balance").set("Threshold", 1.0).set("Interval", 5);
  const auto comm = Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
  seen = {};
  Simulation simulation(comm, scene);
  simulation.initialize();
  simulation.advance(5e-5);
  EXPECT_GT(seen.remeshed, 5);
  EXPECT_GT(seen.zeros, 0);
  EXPECT_LT(seen.error, 1e-11);
  EXPECT_EQ(seen.divided > 0, comm->getSize() > 1);
  seen.subdomain.reset(); // before Kokkos ends
}
