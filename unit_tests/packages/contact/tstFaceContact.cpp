#include "JointScene.hpp"

#include "contact/FaceContact.hpp"

using namespace Rhegma;
using namespace Rhegma::contact;
using namespace Rhegma::contact::test;

namespace
{

/// Closes the joint by `overlap` [m] in one step of 1e-7 s, then slides it by `slide` in another.
void press(State<2>& state, FaceContact<2>& contact, double overlap, double slide)
{
  state.clock.dt = 1e-7;
  contact.prepare(state);
  moveSides(state, {0.0, -overlap / state.clock.dt}, {0.0, 0.0});
  contact.advance(state, state.mesh.nodes.projection);
  moveSides(state, {slide / state.clock.dt, 0.0}, {0.0, 0.0});
  contact.advance(state, state.mesh.nodes.projection);
}

/// Area of the joint that has face points [m2].
double area(const FaceContact<2>& contact)
{
  const auto length = onHost(contact.points().size);
  double sum = 0.0;
  for (int k = 0; k < contact.points().count(); ++k)
    sum += length(k);
  return sum;
}

constexpr double overlap = 2e-8, slide = 3e-8; ///< [m]

} // namespace

TEST(FaceContact, PressesWithThePenaltyAndKeepsMomentum)
{
  const auto run = barAtRest();
  State<2>& state = run->state();
  FaceContact<2> contact(Law::Frictionless, 0.0, 2.0);
  press(state, contact, overlap, slide);
  clearForces(state);
  contact.addForces(state);
  const auto force = forcesOnSides(state);
  const double expected = 2.0 * modulus / cell * overlap * area(contact);
  // Sums of about ten numbers.
  const double roundOff = 1e-14 * expected;
  EXPECT_NEAR(force[1][1], expected, roundOff);
  EXPECT_NEAR(force[0][1], -expected, roundOff);
  EXPECT_NEAR(force[1][1] + force[0][1], 0.0, roundOff);
  EXPECT_NEAR(force[1][0], 0.0, roundOff);
  EXPECT_NEAR(contact.stored(), 0.5 * expected * overlap, 1e-14 * expected * overlap);
  EXPECT_EQ(contact.dissipated(), 0.0);
  EXPECT_EQ(contact.cracks()[0].touches, 1);
}

TEST(FaceContact, OpenFacesAreFree)
{
  const auto run = barAtRest();
  State<2>& state = run->state();
  for (const Law law : {Law::Stick, Law::Frictionless, Law::Coulomb})
  {
    FaceContact<2> contact(law, 0.3, 1.0);
    press(state, contact, -overlap, slide);
    clearForces(state);
    contact.addForces(state);
    for (const Vector<2>& force : forcesOnSides(state))
      EXPECT_EQ(norm(force), 0.0);
    EXPECT_EQ(contact.stored(), 0.0);
    EXPECT_EQ(contact.cracks()[0].touches, 0);
  }
}

TEST(FaceContact, SticksElastically)
{
  const auto run = barAtRest();
  State<2>& state = run->state();
  FaceContact<2> contact(Law::Stick, 0.0, 1.0);
  press(state, contact, overlap, slide);
  clearForces(state);
  contact.addForces(state);
  const double expected = shear / cell * slide * area(contact);
  EXPECT_NEAR(forcesOnSides(state)[1][0], -expected, 1e-14 * expected) << "side +1 is held back";
  EXPECT_EQ(contact.dissipated(), 0.0);
  const double pressed = 0.5 * modulus / cell * overlap * overlap * area(contact);
  EXPECT_NEAR(contact.stored(), pressed + 0.5 * expected * slide, 1e-14 * pressed);
}

/// T = min(kt s, mu p), and what is dissipated is T times the plastic slip, plus the energy of the layer that
/// the sudden step overshoots: the mean of the traction before (0) and after.
TEST(FaceContact, SlipsBeyondCoulombsLimit)
{
  const auto run = barAtRest();
  State<2>& state = run->state();
  const double friction = 0.1;
  FaceContact<2> contact(Law::Coulomb, friction, 1.0);
  press(state, contact, overlap, slide);
  const double limit = friction * modulus / cell * overlap;
  const double elastic = limit / (shear / cell);
  ASSERT_LT(elastic, slide);
  clearForces(state);
  contact.addForces(state);
  EXPECT_NEAR(forcesOnSides(state)[1][0], -limit * area(contact), 1e-14 * limit * area(contact));
  EXPECT_NEAR(contact.dissipated(), 0.5 * limit * (slide - elastic) * area(contact),
              1e-13 * limit * slide * area(contact));
  // From now on the traction is constant, so that a further step dissipates it times the whole slip.
  const double before = contact.dissipated();
  contact.advance(state, state.mesh.nodes.projection);
  EXPECT_NEAR(contact.dissipated() - before, limit * slide * area(contact),
              1e-13 * limit * slide * area(contact));
}

/// Opening a sticking joint dissipates its shear energy: none of it can return.
TEST(FaceContact, ForgetsSlipWhenItOpens)
{
  const auto run = barAtRest();
  State<2>& state = run->state();
  FaceContact<2> contact(Law::Stick, 0.0, 1.0);
  press(state, contact, overlap, slide);
  const double sheared = 0.5 * shear / cell * slide * slide * area(contact);
  moveSides(state, {0.0, 2.0 * overlap / state.clock.dt}, {0.0, 0.0});
  contact.advance(state, state.mesh.nodes.projection);
  EXPECT_EQ(contact.stored(), 0.0);
  EXPECT_NEAR(contact.dissipated(), sheared, 1e-13 * sheared);
}

/// A rigid turn by 45 degrees of an open joint: its gap stays the same to round-off, because velocities that
/// differ by omega x separation differ along the face only.
TEST(FaceContact, KeepsItsGapWhileItTurns)
{
  const auto run = barAtRest();
  State<2>& state = run->state();
  const double opening = 0.3 * cell;
  FaceContact<2> contact(Law::Frictionless, 0.0, 1.0);
  press(state, contact, -opening, 0.0);
  const auto vertex = onHost(state.cracks.vertex);
  const auto face = onHost(state.cracks.face);
  const auto projection = Kokkos::create_mirror_view(state.mesh.nodes.projection);
  // Mass everywhere, so that no node is left out where the joint turns away from its particles.
  Kokkos::deep_copy(state.mesh.nodes.sums, 1.0);
  const int steps = 50;
  const double omega = std::atan(1.0) / (steps * state.clock.dt);
  const double middle[2] = {0.5 * width, height};
  for (int s = 0; s < steps; ++s)
  {
    const double angle = omega * s * state.clock.dt, c = std::cos(angle), d = std::sin(angle);
    for (std::size_t v = 0; v < vertex.extent(0); ++v)
    {
      // Kept within the cells in which nodes have two fields.
      const double along = (v == 0 ? -0.5 : 0.5) * cell;
      vertex(v, 0) = middle[0] + c * along;
      vertex(v, 1) = middle[1] + d * along;
      for (int side = 0; side < 2; ++side)
      {
        const double up = (side - 0.5) * opening;
        face(v, side, 0) = vertex(v, 0) - d * up;
        face(v, side, 1) = vertex(v, 1) + c * up;
      }
    }
    Kokkos::deep_copy(state.cracks.vertex, vertex);
    Kokkos::deep_copy(state.cracks.face, face);
    for (std::size_t n = 0; n < projection.extent(0); ++n)
    {
      const bool isSecond = static_cast<int>(n) >= state.mesh.nodes.numLattice;
      if (isSecond && static_cast<int>(n) >= state.mesh.nodes.numLattice + state.mesh.nodes.numEnriched)
        continue;
      int lattice = static_cast<int>(n);
      if (isSecond)
        Kokkos::deep_copy(lattice, Kokkos::subview(state.mesh.nodes.parent, n - state.mesh.nodes.numLattice));
      const Vector<2> x = state.mesh.grid.nodePosition(lattice);
      projection(n, 0) = -omega * (x[1] - middle[1]);
      projection(n, 1) = omega * (x[0] - middle[0]);
    }
    Kokkos::deep_copy(state.mesh.nodes.projection, projection);
    contact.prepare(state);
    contact.advance(state, state.mesh.nodes.projection);
  }
  const auto gap = onHost(contact.gap());
  // Nodal velocities of about omega times the bar's length are rounded, each step.
  const double roundOff = 2.2e-16 * omega * 2.0 * height * state.clock.dt * steps * 4.0;
  for (std::size_t k = 0; k < gap.extent(0); ++k)
    EXPECT_NEAR(gap(k), opening, roundOff);
}

/// Heat of friction, and the recorded change of the energy of the layer, when cells of another size need
/// points in other positions.
TEST(FaceContact, KeepsHeatWherePointsAreReplaced)
{
  const auto coarse = barAtRest(), fine = barAtRest({}, 2);
  FaceContact<2> contact(Law::Coulomb, 0.3, 1.0);
  press(coarse->state(), contact, overlap, 20.0 * slide);
  const double heat = contact.dissipated();
  EXPECT_GT(heat, 0.0);
  const auto everywhere = [&contact]
  {
    const View<int*> part("part", contact.points().count());
    Kokkos::deep_copy(part, 1);
    return part;
  };
  // Round-off of sums over some forty points.
  EXPECT_NEAR(contact.dissipatedIn(everywhere()), heat, 1e-14 * heat);
  for (State<2>* state : {&fine->state(), &coarse->state(), &fine->state()})
  {
    const double stored = contact.stored();
    const int points = contact.points().count();
    const double change = contact.prepare(*state);
    EXPECT_NE(contact.points().count(), points);
    EXPECT_NEAR(contact.dissipatedIn(everywhere()), heat, 1e-13 * heat);
    EXPECT_NEAR(contact.storedIn(everywhere()), stored + change, 1e-13 * stored);
    EXPECT_EQ(contact.stored(), stored + change);
  }
}
