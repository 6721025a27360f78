/// Active set, return mapping and stiffness of contact in equilibrium, by hand-made displacements.

#include "JointScene.hpp"

#include "contact/ContactInEquilibrium.hpp"

#include <random>

using namespace Rhegma;
using namespace Rhegma::contact;
using namespace Rhegma::contact::test;

namespace
{

using Values = View<double*>;

constexpr double alpha = 1.0, friction = 0.3;
constexpr double overlap = 2e-8;                                                                  ///< [m]
const double stiff = 1000.0 * alpha * modulus / cell, stiffAlong = 1000.0 * alpha * shear / cell; ///< [Pa/m]

/// A joint at rest with the contact of one law; rows are nodes.
struct Joint
{
  std::unique_ptr<Run<2>> run = barAtRest();
  FaceContact<2> contact;
  ContactInEquilibrium<2> faces{contact};
  View<int*> rowOf;
  StepForce<2>::Groups groups;

  explicit Joint(Law law) : contact(law, friction, alpha)
  {
    contact.prepare(state());
    const int nodes = static_cast<int>(state().mesh.nodes.sums.extent(0));
    rowOf = View<int*>("rows", nodes);
    for (int n = 0; n < nodes; ++n)
      rowOf(n) = n;
    begin();
  }
  State<2>& state() const { return run->state(); }
  void begin() { groups = faces.begin(state(), rowOf); }

  /// Displacement of both sides, of nodes at a distance x from the bar's left edge.
  template <class Upper>
  Values displaced(const Upper& upper) const
  {
    const Values u("displacement", 2 * rowOf.extent(0));
    const auto& nodes = state().mesh.nodes;
    for (int n = 0; n < nodes.numLattice; ++n)
    {
      const Vector<2> x = state().mesh.grid.nodePosition(n);
      const int side = state().cracks.nodeSide(n), second = state().cracks.enrichedField(n);
      const bool above = side != 0 ? side > 0 : x[1] >= height;
      const int own = above ? n : second; // field of side +1
      for (int d = 0; d < 2 && own >= 0; ++d)
        u(2 * own + d) = upper(x[0])[d];
    }
    return u;
  }
  Values displaced(double along, double across) const
  {
    return displaced([=](double) { return Vector<2>{{along, across}}; });
  }

  /// Sum of the forces on both sides, upper first [N].
  std::array<Vector<2>, 2> forces(const Values& displacement)
  {
    const Values force("force", displacement.extent(0));
    faces.add(displacement, force);
    clearForces(state());
    const auto sums = onHost(state().mesh.nodes.sums);
    for (std::size_t n = 0; n < sums.extent(0); ++n)
      for (int d = 0; d < 2; ++d)
        sums(n, Nodes<2>::forceAt + d) = force(2 * n + d);
    const std::vector<Vector<2>> sides = forcesOnSides(state());
    return {sides[1], sides[0]};
  }
  double area() const
  {
    double sum = 0.0;
    for (int k = 0; k < faces.patches(); ++k)
      sum += faces.sizeOf(k);
    return sum;
  }
};

} // namespace

TEST(ContactInEquilibrium, PressesAndKeepsThePressureAsAMultiplier)
{
  Joint joint(Law::Frictionless);
  const double expected = stiff * overlap * joint.area(), roundOff = 1e-13 * expected;
  const auto pressed = joint.forces(joint.displaced(0.0, -overlap));
  EXPECT_NEAR(pressed[0][1], expected, roundOff);
  EXPECT_NEAR(pressed[1][1], -expected, roundOff);
  EXPECT_TRUE(joint.faces.update());
  // The faces are back where they were, and still press.
  EXPECT_NEAR(joint.forces(joint.displaced(0.0, 0.0))[0][1], expected, roundOff);
  EXPECT_NEAR(joint.forces(joint.displaced(0.0, -overlap))[0][1], 2.0 * expected, roundOff);
  // More than the pressure takes to open them.
  joint.forces(joint.displaced(0.0, 1.01 * overlap));
  joint.faces.update();
  EXPECT_EQ(joint.forces(joint.displaced(0.0, 1.01 * overlap))[0][1], 0.0);
}

/// An overlap that was found while a patch was open says nothing of the pressure that closes it.
TEST(ContactInEquilibrium, WhatOpenedClosesWithoutAMultiplier)
{
  Joint joint(Law::Frictionless);
  const double expected = stiff * overlap * joint.area();
  joint.forces(joint.displaced(0.0, overlap));
  joint.faces.update();
  ASSERT_EQ(joint.faces.touchOf(0), Touch::Open);
  EXPECT_EQ(joint.forces(joint.displaced(0.0, -overlap))[0][1], 0.0);
  joint.faces.update();
  EXPECT_NEAR(joint.forces(joint.displaced(0.0, 0.0))[0][1], 0.0, 1e-13 * expected);
  EXPECT_NEAR(joint.forces(joint.displaced(0.0, -overlap))[0][1], expected, 1e-13 * expected);
}

/// A rotation closes one edge of the joint and opens the other.
TEST(ContactInEquilibrium, ClosesWhereFacesOverlap)
{
  Joint joint(Law::Stick);
  ASSERT_GE(joint.faces.patches(), 2);
  joint.forces(joint.displaced(
      [](double x) {
        return Vector<2>{{0.0, overlap * (x / (0.5 * width) - 1.0)}};
      }));
  const int last = joint.faces.patches() - 1;
  EXPECT_EQ(joint.faces.touchOf(last), Touch::Sticking) << "the first guess is that all is closed";
  joint.faces.update();
  EXPECT_EQ(joint.faces.touchOf(0), Touch::Sticking);
  EXPECT_EQ(joint.faces.touchOf(last), Touch::Open);
  joint.forces(joint.displaced(0.0, 0.0));
  EXPECT_GT(joint.faces.pressureOf(0), 0.0);
  EXPECT_EQ(joint.faces.pressureOf(last), 0.0);
}

TEST(ContactInEquilibrium, SticksBelowCoulombsLimitAndSlidesAtIt)
{
  Joint joint(Law::Coulomb);
  const double limit = friction * stiff * overlap;
  const double sticks = 0.9 * limit / stiffAlong, slides = 3.0 * limit / stiffAlong;
  const double roundOff = 1e-13 * limit * joint.area();
  EXPECT_NEAR(joint.forces(joint.displaced(sticks, -overlap))[0][0], -0.9 * limit * joint.area(), roundOff);
  EXPECT_EQ(joint.faces.touchOf(0), Touch::Sticking);
  EXPECT_TRUE(joint.faces.reason().empty());
  joint.forces(joint.displaced(-slides, -overlap));
  joint.faces.update();
  EXPECT_NEAR(joint.forces(joint.displaced(-slides, 0.0))[0][0], limit * joint.area(), roundOff);
  EXPECT_EQ(joint.faces.touchOf(0), Touch::Sliding);
  EXPECT_EQ(joint.faces.reason(), "all closed faces of crack Joint slide");
}

/// A patch that slides one way and would be drawn back sticks, and slides back only if it cannot stick.
TEST(ContactInEquilibrium, SticksBeforeItSlidesBack)
{
  Joint joint(Law::Coulomb);
  const double limit = friction * stiff * overlap, way = 10.0 * limit / stiffAlong;
  joint.forces(joint.displaced(way, -overlap));
  joint.faces.update();
  ASSERT_EQ(joint.faces.touchOf(0), Touch::Sliding);
  joint.forces(joint.displaced(-way, 0.0));
  joint.faces.update();
  EXPECT_EQ(joint.faces.touchOf(0), Touch::Sticking);
  joint.forces(joint.displaced(-way, 0.0));
  joint.faces.update();
  EXPECT_EQ(joint.faces.touchOf(0), Touch::Sliding);
  EXPECT_NEAR(joint.forces(joint.displaced(-way, 0.0))[0][0], limit * joint.area(),
              1e-13 * limit * joint.area());
}

/// Slip over two steps, there and back: the work of friction is its traction times the way, but for the
/// first step, in which the traction grows with the slip from zero.
TEST(ContactInEquilibrium, DissipatesFrictionTimesSlip)
{
  Joint joint(Law::Coulomb);
  const double pressure = stiff * overlap, limit = friction * pressure, slip = 1e-6;
  double lost = 0.0;
  for (const double way : {slip, slip, -2.0 * slip})
  {
    joint.begin();
    // In equilibrium the overlap is left to the multiplier.
    joint.forces(joint.displaced(way, lost == 0.0 ? -overlap : 0.0));
    joint.faces.update();
    joint.forces(joint.displaced(way, 0.0));
    joint.faces.update();
    joint.forces(joint.displaced(way, 0.0));
    joint.faces.accept(joint.state());
    const double before = lost == 0.0 ? 0.0 : limit;
    // On the way back the traction changes its sign within the step.
    lost += way > 0.0 ? 0.5 * (before + limit) * slip : 0.0;
    EXPECT_NEAR(joint.contact.dissipated(), lost * joint.area(), 1e-12 * limit * slip * joint.area());
    EXPECT_NEAR(joint.contact.stored(), 0.0, 1e-9 * limit * slip * joint.area());
  }
  EXPECT_NEAR(joint.contact.cracks()[0].largestPressure, pressure, 1e-12 * pressure);
}

/// Faces that are open at the start of a step and meet within it have no shear traction.
TEST(ContactInEquilibrium, FacesThatMeetBeginWithoutShear)
{
  Joint joint(Law::Coulomb);
  joint.forces(joint.displaced(0.0, 5.0 * overlap));
  joint.faces.update();
  joint.forces(joint.displaced(0.0, 5.0 * overlap));
  joint.faces.accept(joint.state());
  joint.begin();
  joint.forces(joint.displaced(overlap, -6.0 * overlap));
  joint.faces.update();
  const auto forces = joint.forces(joint.displaced(overlap, -6.0 * overlap));
  EXPECT_NEAR(forces[0][1], stiff * overlap * joint.area(), 1e-12 * stiff * overlap * joint.area());
  EXPECT_NEAR(forces[0][0], 0.0, 1e-12 * stiff * overlap * joint.area());
}

/// Minus the derivative of the forces, by central differences, while faces stick, slide and open.
TEST(ContactInEquilibrium, StiffnessIsTheDerivative)
{
  const double limit = friction * stiff * overlap;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  for (const double along : {0.3 * limit / stiffAlong, 5.0 * limit / stiffAlong, -2.0 * limit / stiffAlong})
  {
    Joint joint(Law::Coulomb);
    const Values u = joint.displaced(along, -overlap), du("change", u.extent(0));
    for (std::size_t k = 0; k < u.extent(0); ++k)
    {
      u(k) += 0.02 * overlap * anywhere(random);
      du(k) = 1e-4 * overlap * anywhere(random);
    }
    const Values high("high", u.extent(0)), low("low", u.extent(0)), by("by", u.extent(0)),
        there("there", u.extent(0));
    joint.faces.add(u, there);
    joint.faces.update(); // chooses the branch
    const auto at = [&](double factor)
    {
      const Values moved("moved", u.extent(0));
      for (std::size_t k = 0; k < u.extent(0); ++k)
        moved(k) = u(k) + factor * du(k);
      return moved;
    };
    joint.faces.add(at(1.0), high);
    joint.faces.add(at(-1.0), low);
    joint.faces.add(u, there);
    double largest = 0.0, asymmetry = 0.0;
    const auto add = [&](int row, int other, const double(&block)[4])
    {
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          by(2 * row + i) -= block[2 * i + j] * du(2 * other + j);
    };
    const bool symmetric = joint.faces.addStiffness(false, add);
    EXPECT_EQ(symmetric, joint.faces.touchOf(0) == Touch::Sticking);
    for (std::size_t k = 0; k < u.extent(0); ++k)
      largest = std::max(largest, std::fabs(by(k)));
    ASSERT_GT(largest, 0.0);
    // Pieces of the law are linear in 2D: only rounding of forces some 1e4 times their change.
    for (std::size_t k = 0; k < u.extent(0); ++k)
      EXPECT_NEAR(0.5 * (high(k) - low(k)), by(k), 1e-9 * largest) << k;
    // What conjugate gradients take.
    const Values left("left", u.extent(0)), right("right", u.extent(0));
    EXPECT_TRUE(joint.faces.addStiffness(true,
                                         [&](int row, int other, const double(&block)[4])
                                         {
                                           for (int i = 0; i < 2; ++i)
                                             for (int j = 0; j < 2; ++j)
                                             {
                                               left(2 * row + i) += block[2 * i + j] * du(2 * other + j);
                                               right(2 * other + j) += block[2 * i + j] * du(2 * row + i);
                                             }
                                         }));
    for (std::size_t k = 0; k < u.extent(0); ++k)
      asymmetry = std::max(asymmetry, std::fabs(left(k) - right(k)));
    EXPECT_LT(asymmetry, 1e-12 * largest);
  }
}

/// The pieces on both sides can move along each other where they slide, and turn nowhere.
TEST(ContactInEquilibrium, HoldsWhatItPresses)
{
  Joint joint(Law::Coulomb);
  const auto directions = [&joint]
  {
    Vector<2> sum{};
    for (const HeldDirection<2>& held : joint.faces.heldDirections())
      for (int d = 0; d < 2; ++d)
        sum[d] += std::fabs(held.direction[d]);
    return sum;
  };
  joint.forces(joint.displaced(0.0, -overlap));
  EXPECT_GT(directions()[0], 0.0);
  EXPECT_EQ(directions()[0], directions()[1]);
  joint.forces(joint.displaced(1.0, -overlap));
  joint.faces.update();
  EXPECT_EQ(directions()[0], 0.0);
  EXPECT_GT(directions()[1], 0.0);
  joint.forces(joint.displaced(0.0, 10.0 * overlap));
  joint.faces.update();
  EXPECT_TRUE(joint.faces.heldDirections().empty());
}
