/// What the history has of a front, of one node and of several.

#include "energy_release/FrontSample.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::energy_release;

namespace
{

/// A straight front in 3D of three nodes, 1 and 3 mm apart.
CrackFront<3> straightFront()
{
  CrackFront<3> front;
  const double at[] = {0.0, 1e-3, 4e-3}, tributary[] = {0.5e-3, 2e-3, 1.5e-3};
  for (int k = 0; k < 3; ++k)
  {
    FrontNode<3> node;
    node.name = k;
    node.facet = k < 2 ? k : -1;
    node.position = {0.0, at[k], 0.0};
    node.tributaryLength = tributary[k];
    front.nodes.push_back(node);
  }
  return front;
}

double valueOf(const HistoryRow& row, const std::string& name)
{
  for (const auto& [column, value] : row)
    if (column == name)
      return value;
  ADD_FAILURE() << "no column " << name;
  return 0.0;
}

} // namespace

/// One node: its values, without extremes.
TEST(FrontSample, HasTheValuesOfOneNode)
{
  FrontSample<2> sample(CrackFront<2>(), 0.0);
  sample.J = {12.5};
  sample.modeI = {3e6};
  HistoryRow row;
  sample.addTo(row, "Notch.0", {});
  std::vector<std::string> names;
  for (const auto& column : row)
    names.push_back(column.first);
  EXPECT_EQ(names, (std::vector<std::string>{"Notch.0.G_J", "Notch.0.K_I", "Notch.0.K_II", "Notch.0.length",
                                             "Notch.0.speed", "Notch.0.x", "Notch.0.y"}));
  EXPECT_EQ(valueOf(row, "Notch.0.G_J"), 12.5);
  EXPECT_EQ(valueOf(row, "Notch.0.K_I"), 3e6);
}

/// Several: their mean by length of front, which is that of the lines between them, and extremes.
TEST(FrontSample, HasMeanAndExtremesAlongAFront)
{
  FrontSample<3> sample(straightFront(), 0.0);
  sample.J = {10.0, 20.0, 40.0};
  HistoryRow row;
  sample.addTo(row, "Disk.0", {});
  EXPECT_NEAR(valueOf(row, "Disk.0.G_J"), (15.0 * 1.0 + 30.0 * 3.0) / 4.0, 1e-12);
  EXPECT_EQ(valueOf(row, "Disk.0.G_J_min"), 10.0);
  EXPECT_EQ(valueOf(row, "Disk.0.G_J_max"), 40.0);
  EXPECT_EQ(valueOf(row, "Disk.0.K_III_max"), 0.0);
}

/// A front in 3D that has ended has no nodes left, and nothing drives it.
TEST(FrontSample, IsZeroWhereNoNodeIsLeft)
{
  CrackFront<3> front;
  front.ended = true;
  HistoryRow row;
  FrontSample<3>(front, 0.0).addTo(row, "Disk.0", {});
  for (const char* name : {"Disk.0.G_J", "Disk.0.G_J_min", "Disk.0.G_J_max", "Disk.0.speed"})
    EXPECT_EQ(valueOf(row, name), 0.0) << name;
}
