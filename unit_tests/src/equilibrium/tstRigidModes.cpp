/// What of the loads on a free piece does not balance.

#include "equilibrium/RigidModes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace Rhegma::equilibrium
{
namespace Test
{

namespace
{

/// Nodes at random positions with random masses, one piece, of which the first `held` are held fast.
template <int D>
struct Nodes
{
  std::vector<Vector<D>> position;
  std::vector<double> mass;
  std::vector<int> piece;
  Held held;
  View<double*> force;
  std::vector<RigidMode<D>> modes;

  Nodes(unsigned seed, int count, int fast) : force("force", D * count)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-3.0, 5.0), weight(0.5, 2.0);
    for (int k = 0; k < count; ++k)
    {
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = place(random);
      position.push_back(x);
      mass.push_back(weight(random));
      piece.push_back(0);
    }
    held.is.assign(D * count, 0);
    held.change.assign(D * count, 0.0);
    std::fill_n(held.is.begin(), D * fast, 1);
    modes = freeModes<D>(piece, 1, position, mass, held, {});
  }

  void push(int node, const Vector<D>& by)
  {
    for (int d = 0; d < D; ++d)
      force(D * node + d) += by[d];
  }

  Imbalance imbalance() const
  {
    const std::vector<Imbalance> all = findImbalances<D>(modes, piece, position, mass, {}, force);
    EXPECT_EQ(all.size(), 1U);
    return all.at(0);
  }
};

/// A couple: two opposite forces of 7 N, in the plane of the first two axes, at right angles to the line
/// between two nodes. \return its moment, force times projected distance [N m]
template <int D>
double addCouple(Nodes<D>& nodes)
{
  const Vector<D> arm = nodes.position[1] - nodes.position[0];
  const double length = std::hypot(arm[0], arm[1]);
  Vector<D> by{};
  by[0] = -7.0 * arm[1] / length;
  by[1] = 7.0 * arm[0] / length;
  nodes.push(1, by);
  nodes.push(0, -1.0 * by);
  // In 3D the force is at right angles to the arm too, so that the moment is force times the whole arm.
  return 7.0 * norm(arm);
}

template <int D>
void testCouple()
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    Nodes<D> nodes(seed, 12, 0);
    ASSERT_EQ(static_cast<int>(nodes.modes.size()), rigidMotions<D>);
    const double moment = addCouple(nodes);
    const Imbalance found = nodes.imbalance();
    EXPECT_NEAR(found.moment, moment, 1e-10 * moment) << "seed " << seed;
    EXPECT_NEAR(found.force, 0.0, 1e-10);
    EXPECT_LT(found.fractionOfForce, 1e-10);
    EXPECT_GT(found.fractionOfMoment, 0.01);
    EXPECT_LE(found.fractionOfMoment, 1.0);
    const std::string text = found.asText(0.01);
    EXPECT_EQ(text.find("a force"), std::string::npos) << text;
    EXPECT_NE(text.find("a moment of "), std::string::npos) << text;
    EXPECT_NE(text.find(" % of the forces on it)"), std::string::npos) << text;
  }
}

/// Weight: no moment about the centre of mass.
template <int D>
void testWeight()
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    Nodes<D> nodes(seed, 12, 0);
    double weight = 0.0;
    for (int k = 0; k < 12; ++k)
    {
      Vector<D> by{};
      by[1] = -9.81 * nodes.mass[k];
      nodes.push(k, by);
      weight += 9.81 * nodes.mass[k];
    }
    const Imbalance found = nodes.imbalance();
    EXPECT_NEAR(found.force, weight, 1e-10 * weight) << "seed " << seed;
    EXPECT_NEAR(found.fractionOfForce, 1.0, 2e-6); // less the motion that counts as rounding, 1e-6
    EXPECT_NEAR(found.moment, 0.0, 1e-9 * weight);
    const std::string text = found.asText(0.01);
    EXPECT_NE(text.find("a force of "), std::string::npos) << text;
    EXPECT_EQ(text.find("moment"), std::string::npos) << text;
  }
}

} // namespace

TEST(RigidModes, ACoupleIsAMoment) { testCouple<2>(); }
TEST(RigidModes, ACoupleIsAMomentIn3D) { testCouple<3>(); }
TEST(RigidModes, WeightIsAForce) { testWeight<2>(); }
TEST(RigidModes, WeightIsAForceIn3D) { testWeight<3>(); }

/// A body on a pin: the moment is that about the pin, whatever force the pin takes.
TEST(RigidModes, AForceOnAPinnedBodyIsAMomentAboutThePin)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    Nodes<2> nodes(seed, 12, 1);
    ASSERT_EQ(nodes.modes.size(), 1U);
    const Vector<2> by{2.0, -3.0}, arm = nodes.position[4] - nodes.position[0];
    nodes.push(4, by);
    const double moment = std::fabs(arm[0] * by[1] - arm[1] * by[0]);
    const Imbalance found = nodes.imbalance();
    EXPECT_NEAR(found.moment, moment, 1e-10 * moment) << "seed " << seed;
    EXPECT_EQ(found.force, 0.0);
  }
}

/// What is taken from forces leaves none of both.
TEST(RigidModes, BalancedForcesStayAsTheyAre)
{
  Nodes<3> nodes(7, 12, 0);
  addCouple(nodes);
  nodes.push(5, {1.0, 2.0, -4.0});
  removeResultants<3>(nodes.modes, nodes.piece, nodes.position, nodes.mass, {}, nodes.force);
  const Imbalance found = nodes.imbalance();
  EXPECT_LT(found.fraction(), 1e-12);
  EXPECT_EQ(found.asText(1e-3), "");
}

} // namespace Test
} // namespace Rhegma::equilibrium
