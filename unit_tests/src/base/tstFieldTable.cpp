#include "base/FieldTable.hpp"
#include "state/EnergyBalance.hpp"
#include "state/NodeConstraint.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

using namespace Rhegma;

namespace
{

FieldTable threeParticles()
{
  FieldTable table;
  table.add({"position", 2, "m", ""});
  table.add({"number", 1, "", "", true});
  table.resize(3);
  for (int p = 0; p < 3; ++p)
  {
    table.integer("number")(p) = 10 + p;
    for (int d = 0; d < 2; ++d)
      table.real<2>("position")(p, d) = p + 0.5 * d;
  }
  return table;
}

} // namespace

TEST(FieldTable, KeepsRowsThatStay)
{
  FieldTable table = threeParticles();
  table.resize(5);
  EXPECT_EQ(table.size(), 5);
  EXPECT_EQ(table.real<2>("position")(2, 1), 2.5);
  EXPECT_EQ(table.real<2>("position")(4, 1), 0.0);
  EXPECT_EQ(table.integer("number")(3), 0);
  table.resize(1);
  EXPECT_EQ(table.real<2>("position").extent(0), 1u);
  EXPECT_EQ(table.integer("number")(0), 10);
}

/// Rows are appended with and without spare rows behind the last one, and rows made after that are zero.
TEST(FieldTable, AppendsCopiesOfRows)
{
  FieldTable table = threeParticles();
  const View<int*> rows("rhegma::rows", 3);
  const std::array<int, 3> from{2, 0, 2};
  for (int i = 0; i < 3; ++i)
    rows(i) = from[i];
  std::vector<int> expected{0, 1, 2};
  for (int round = 0; round < 6; ++round)
  {
    table.append(rows);
    for (const int row : from)
      expected.push_back(expected[row]);
    ASSERT_EQ(table.size(), static_cast<int>(expected.size()));
    for (int p = 0; p < table.size(); ++p)
    {
      EXPECT_EQ(table.integer("number")(p), 10 + expected[p]);
      EXPECT_EQ(table.real<2>("position")(p, 1), expected[p] + 0.5);
    }
  }
  const int before = table.size();
  table.append(rows);
  table.resize(before); // what was appended last lies behind the last row now
  table.resize(before + 3);
  for (int p = before; p < before + 3; ++p)
  {
    EXPECT_EQ(table.integer("number")(p), 0);
    EXPECT_EQ(table.real<2>("position")(p, 0), 0.0);
  }
}

/// Whatever the spare rows hold.
TEST(FieldTable, NewRowsAreZeroAfterRowsWereAppended)
{
  FieldTable table = threeParticles();
  const View<int*> many("rhegma::rows", 40), few("rhegma::order", 20);
  for (int i = 0; i < 40; ++i)
    many(i) = 1;
  table.append(many);
  table.reorder(few); // 20 copies of row 0, and spare rows
  table.append(few);
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(table.integer("number")(20 + i), 10);
  const int before = table.size();
  table.resize(before + 10);
  for (int p = before; p < before + 10; ++p)
    EXPECT_EQ(table.integer("number")(p), 0);
}

/// Rows may be left out and used twice.
TEST(FieldTable, ReordersAllFields)
{
  FieldTable table = threeParticles();
  const View<int*> order("rhegma::order", 4);
  const std::array<int, 4> from{2, 0, 2, 1};
  for (int i = 0; i < 4; ++i)
    order(i) = from[i];
  table.reorder(order);
  ASSERT_EQ(table.size(), 4);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(table.integer("number")(i), 10 + from[i]);
    EXPECT_EQ(table.real<2>("position")(i, 1), from[i] + 0.5);
  }
}

TEST(FieldTable, RefusesWhatItDoesNotHave)
{
  FieldTable table = threeParticles();
  EXPECT_THROW(table.add({"position", 2, "m", ""}), std::logic_error);
  EXPECT_THROW(table.real<3>("position"), std::logic_error);
  EXPECT_THROW(table.scalar("position"), std::logic_error);
  EXPECT_THROW(table.integer("position"), std::logic_error);
  EXPECT_THROW(table.scalar("number"), std::logic_error);
  EXPECT_THROW(table.table("plaice"), std::logic_error);
  EXPECT_FALSE(table.has("plaice"));
  EXPECT_TRUE(table.has("position"));
}

TEST(FieldTable, KnowsItsFieldsAndTheirMemory)
{
  const FieldTable table = threeParticles();
  ASSERT_EQ(table.fields().size(), 2u);
  EXPECT_EQ(table.fields()[0].unit, "m");
  EXPECT_TRUE(table.fields()[1].integer);
  EXPECT_EQ(table.table("position").extent(1), 2u);
  EXPECT_EQ(table.bytes(), 3.0 * (2 * sizeof(double) + sizeof(int)));
}

/// Of 10 J of work and 2 J that burning gives, 3 + 4 - 1 J are stored since the start, 2 + 1 + 0.5 + 0.25 +
/// 0.25 J went elsewhere: 2 J are unaccounted for.
TEST(EnergyBalance, LeavesWhatItCannotAccountFor)
{
  EnergyBalance energy;
  EXPECT_EQ(energy.residual(), 0.0);
  energy.kinetic = 3.0;
  energy.strain = 4.0;
  energy.start = 1.0;
  energy.externalWork = 10.0;
  energy.combustion = 2.0;
  energy.damped = 2.0;
  energy.plastic = 1.0;
  energy.contact = 0.5;
  energy.fracture = 0.25;
  energy.merged = 0.25;
  EXPECT_EQ(energy.residual(), -2.0);
}

TEST(NodeConstraint, HoldsItsBoxOrWhatIsBeyond)
{
  NodeConstraint<2> constraint;
  constraint.lower = {{0.0, 0.0}};
  constraint.upper = {{1.0, 2.0}};
  constraint.value = {{5.0, 6.0}};
  EXPECT_TRUE(constraint.appliesAt({{1.0, 2.0}}));
  EXPECT_FALSE(constraint.appliesAt({{1.1, 1.0}}));
  constraint.outside = true;
  EXPECT_FALSE(constraint.appliesAt({{0.5, 0.5}}));
  EXPECT_TRUE(constraint.appliesAt({{0.5, 2.1}}));
  EXPECT_EQ(constraint.at(3, 1), 6.0);
  constraint.field = View<double* [2]>("rhegma::prescribed", 4);
  constraint.field(3, 1) = 7.0;
  constraint.factor = -0.5;
  EXPECT_EQ(constraint.at(3, 1), -3.5);
}
