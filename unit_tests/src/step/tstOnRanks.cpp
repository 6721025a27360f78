/// Effects of an application that declare whether they support several ranks; run on one rank and on two.

#include "Simulation.hpp"
#include "plan/KnownEffects.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

using namespace Rhegma;

namespace
{

template <int D>
Effect<D> nothing(const Teuchos::ParameterList&)
{
  return {};
}

EffectEntry named(const std::string& name, bool onRanks)
{
  EffectEntry entry{Section(name, "Nothing at all."), {}, nothing<2>, nothing<3>};
  entry.onRanks = onRanks;
  return entry;
}

void addOnce()
{
  static bool added = false;
  if (!added)
    for (const EffectEntry& entry : {named("Alone", false), named("Apart", false), named("Anywhere", true)})
      addEffect(entry);
  added = true;
}

Teuchos::RCP<const Teuchos::Comm<int>> allRanks()
{
  return Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
}

/// The beam with sections of these effects; a run that has begun.
Simulation begun(const std::vector<std::string>& effects)
{
  addOnce();
  const auto scene = Teuchos::getParametersFromXmlFile(RHEGMA_SOURCE_DIR "/xml_inputs/examples/dcb.xml");
  for (const std::string& effect : effects)
    scene->sublist(effect);
  Simulation simulation(allRanks(), scene);
  simulation.initialize();
  return simulation;
}

bool has(const Simulation& simulation, const std::string& effect)
{
  const std::vector<std::string> names = simulation.effects();
  return std::find(names.begin(), names.end(), effect) != names.end();
}

/// Message that refuses these effects; empty where they are accepted.
std::string message(const std::vector<std::string>& effects)
{
  try
  {
    const Simulation simulation = begun(effects);
    for (const std::string& effect : effects)
      EXPECT_TRUE(has(simulation, effect)) << effect;
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

} // namespace

TEST(OnRanks, RefusesEffectsThatKnowOneRankOnly)
{
  const bool many = allRanks()->getSize() > 1;
  const std::string alone = message({"Alone", "Anywhere"}), both = message({"Alone", "Apart"});
  const std::string reason = ": such scenes run on one rank only; start the program without mpirun, or with "
                             "mpirun -np 1";
  EXPECT_EQ(alone, many ? "Alone" + reason : "");
  EXPECT_EQ(both, many ? "Alone, Apart" + reason : "");
}

TEST(OnRanks, TakesEffectsThatKnowAllAndScenesWithoutThose)
{
  EXPECT_EQ(message({"Anywhere"}), "");
  EXPECT_EQ(message({}), "");
}
