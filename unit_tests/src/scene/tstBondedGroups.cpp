/// Groups of bonded bodies.

#include "scene/BondedGroups.hpp"

#include <gtest/gtest.h>

namespace Rhegma
{

namespace
{

TEST(BondedGroups, HoldBodiesThatAreBondedByOthers)
{
  Teuchos::ParameterList bodies;
  for (const char* name : {"a", "b", "c", "d", "e"})
    bodies.sublist(name);
  bodies.sublist("d").set<std::string>("Bonded To", "b, e");
  bodies.sublist("a").set<std::string>("Bonded To", " e ");
  const BondedGroups groups = bondedGroups(bodies, {"a", "b", "c", "d", "e"});
  EXPECT_EQ(groups.of, (std::vector<int>{0, 0, 1, 0, 0}));
  EXPECT_EQ(groups.names, (std::vector<std::string>{"a + b + d + e", "c"}));
}

TEST(BondedGroups, AreSingleBodiesWithoutBonds)
{
  Teuchos::ParameterList bodies;
  bodies.sublist("a");
  bodies.sublist("b");
  const BondedGroups groups = bondedGroups(bodies, {"a", "b"});
  EXPECT_EQ(groups.of, (std::vector<int>{0, 1}));
  EXPECT_EQ(groups.count(), 2);
}

} // namespace

} // namespace Rhegma
