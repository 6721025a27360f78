/// The velocity of tools with a mass, and the impulses of their contacts.

#include "rigid_tools/FreeVelocity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <random>

namespace Rhegma::rigid_tools
{

namespace
{

constexpr unsigned seedOfContacts = 47;

/// Rounding of sums of up to a hundred contacts: the residual that the search accepts, and as much for sums
/// of the test.
constexpr double rounding = 2e-12;

template <int D>
struct Case
{
  MovingMass<D> tool;
  std::vector<FieldAtTool<D>> fields;
};

template <int D>
class Draw
{
public:
  explicit Draw(std::mt19937& random) : random_(random) {}

  Case<D> operator()(const FrictionLaw& law)
  {
    Case<D> drawn;
    const int count = 1 + static_cast<int>(random_() % 40);
    const double spread = uniform(0.0, 1.0);
    double masses = 0.0;
    for (int c = 0; c < count; ++c)
    {
      drawn.fields.push_back(field(spread));
      masses += drawn.fields.back().mass;
    }
    drawn.tool.mass = masses * std::pow(10.0, uniform(-3.0, 3.0));
    drawn.tool.alone = vector();
    drawn.tool.alone[D - 1] += 1.0;
    drawn.tool.law = law;
    for (int d = 0; d < D; ++d)
    {
      drawn.tool.moves[d] = d == D - 1 || uniform(0.0, 1.0) < 0.9;
      drawn.tool.alone[d] = drawn.tool.moves[d] ? drawn.tool.alone[d] : 0.0;
    }
    drawn.tool.guess = drawn.tool.alone;
    return drawn;
  }

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

private:
  Vector<D> vector()
  {
    std::normal_distribution<double> normal;
    Vector<D> v{};
    for (int d = 0; d < D; ++d)
      v[d] = normal(random_);
    return v;
  }

  /// Normals are about the last axis.
  FieldAtTool<D> field(double spread)
  {
    FieldAtTool<D> field;
    field.mass = std::pow(10.0, uniform(-2.0, 0.0));
    field.velocity = 0.5 * vector();
    field.velocity[D - 1] -= uniform(0.0, 1.0);
    field.normal = spread * vector();
    field.normal[D - 1] += 1.0;
    const int held = static_cast<int>(random_() % (10 * D));
    for (int d = 0; d < D; ++d)
    {
      field.free[d] = d != held;
      field.normal[d] = field.free[d] ? field.normal[d] : 0.0;
    }
    field.normal = (1.0 / norm(field.normal)) * field.normal;
    return field;
  }

  std::mt19937& random_;
};

/// Changes of momentum and energy, and what is left of velocities into the tool.
template <int D>
struct Outcome
{
  Vector<D> velocity{};  ///< of the tool, by its momentum
  double energy = 0.0;   ///< that the contacts gave
  double supplied = 0.0; ///< kinetic energy before, of motion relative to the tool
  double size = 0.0;     ///< of all impulses
};

template <int D>
Outcome<D> outcomeOf(const Case<D>& drawn, const FreeVelocity<D>& found)
{
  Outcome<D> out;
  Vector<D> sum{};
  for (const ContactImpulse<D>& contact : found.contacts)
  {
    sum = sum + contact.impulse;
    out.size += norm(contact.impulse);
  }
  out.velocity = drawn.tool.alone;
  for (int d = 0; d < D; ++d)
    if (drawn.tool.moves[d])
      out.velocity[d] -= sum[d] / drawn.tool.mass;
  const Vector<D> mean = 0.5 * (out.velocity + drawn.tool.alone);
  for (std::size_t c = 0; c < drawn.fields.size(); ++c)
  {
    const Vector<D>& impulse = found.contacts[c].impulse;
    const Vector<D> ofField = drawn.fields[c].velocity + (0.5 / drawn.fields[c].mass) * impulse;
    // Axes that do not move take work from what holds them.
    out.energy += dot(impulse, ofField - mean);
    out.supplied += norm(impulse) * norm(drawn.fields[c].velocity - drawn.tool.alone);
  }
  return out;
}

template <int D>
void expectLawful(const Case<D>& drawn, const FreeVelocity<D>& found)
{
  const FrictionLaw& law = drawn.tool.law;
  const Outcome<D> out = outcomeOf(drawn, found);
  const double scale = drawn.tool.mass * (norm(drawn.tool.alone) + norm(found.velocity)) + out.size;
  EXPECT_LE(drawn.tool.mass * norm(found.velocity - out.velocity), rounding * scale);
  EXPECT_LE(out.energy, rounding * (out.supplied + scale * norm(found.velocity)));
  for (std::size_t c = 0; c < drawn.fields.size(); ++c)
  {
    const FieldAtTool<D>& field = drawn.fields[c];
    const ContactImpulse<D>& contact = found.contacts[c];
    Vector<D> relative{};
    for (int d = 0; d < D; ++d)
    {
      relative[d] = field.free[d] ? found.velocity[d] - field.velocity[d] : 0.0;
      EXPECT_LE(field.free[d] ? 0.0 : std::fabs(contact.impulse[d]), 1e-15 * out.size);
    }
    const double pressing = dot(contact.impulse, field.normal);
    const double into = dot(relative, field.normal) - pressing / field.mass;
    EXPECT_LE(into, 1e-14 * (norm(relative) + norm(found.velocity)));
    const double along = norm(contact.impulse - pressing * field.normal);
    const double most = contact.sticks ? law.atRest : law.sliding;
    if (std::isfinite(most))
    {
      EXPECT_LE(along, most * pressing + 1e-14 * norm(contact.impulse));
    }
    if (found.cut > 0)
      continue;
    const ContactImpulse<D> exact = contactImpulse(law, field.normal, field.mass * relative);
    const bool either = law.atRest > law.sliding && contact.sticks != exact.sticks;
    if (!either)
    {
      EXPECT_LE(norm(contact.impulse - exact.impulse), 1e-9 * norm(field.mass * relative));
    }
  }
}

/// \return cases in which friction is cut
template <int D>
int tryLaw(std::mt19937& random, int cases, double largest, double atRest)
{
  Draw<D> draw(random);
  int cut = 0;
  for (int k = 0; k < cases; ++k)
  {
    const double sliding = std::isfinite(largest) ? draw.uniform(0.0, largest) : largest;
    const Case<D> drawn = draw({atRest * sliding, sliding});
    const FreeVelocity<D> found = findFreeVelocity(drawn.tool, drawn.fields);
    expectLawful(drawn, found);
    cut += found.cut > 0 ? 1 : 0;
    if (::testing::Test::HasFailure())
    {
      ADD_FAILURE() << "case " << k << ", " << drawn.fields.size() << " contacts, friction " << sliding;
      break;
    }
  }
  return cut;
}

template <int D>
void tryAll()
{
  std::mt19937 random(seedOfContacts);
  constexpr int cases = 4000;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const int cut = tryLaw<D>(random, cases, 0.8, 1.0);
  std::cout << D << "D, seed " << seedOfContacts << ": friction is cut in " << cut << " of " << cases
            << " cases\n";
  EXPECT_LE(cut, cases / 1000);
  EXPECT_EQ(tryLaw<D>(random, cases, 0.0, 1.0), 0);
  // These laws jump where a field starts to slide or to separate, and need not have a solution.
  const int cutAtRest = tryLaw<D>(random, cases, 0.8, 1.3),
            cutSticking = tryLaw<D>(random, cases, infinite, 1.0);
  std::cout << "with more friction at rest in " << cutAtRest << ", of faces that stick in " << cutSticking
            << "\n";
  EXPECT_LE(cutAtRest, cases / 100);
  EXPECT_LE(cutSticking, cases / 20);
}

} // namespace

TEST(FreeVelocity, KeepsTheLawsIn2D) { tryAll<2>(); }
TEST(FreeVelocity, KeepsTheLawsIn3D) { tryAll<3>(); }

/// A body between two faces that are inclined to the motion of a light tool: the closed form of two
/// contacts that stick.
TEST(FreeVelocity, OfATwoFieldsThatStick)
{
  const double infinite = std::numeric_limits<double>::infinity();
  MovingMass<2> tool{1e-3, {{1.0, 0.0}}, {{1.0, 0.0}}, {true, true}, {infinite, infinite}};
  std::vector<FieldAtTool<2>> fields(2);
  fields[0] = {2.0, {{0.8, 0.6}}, {{0.0, 0.0}}, {true, true}};
  fields[1] = {3.0, {{0.8, -0.6}}, {{0.0, 0.0}}, {true, true}};
  const FreeVelocity<2> found = findFreeVelocity(tool, fields);
  EXPECT_NEAR(found.velocity[0], 1e-3 / 5.001, 1e-15);
  EXPECT_NEAR(found.velocity[1], 0.0, 1e-15);
  EXPECT_NEAR(found.contacts[1].impulse[0], 3e-3 / 5.001, 1e-14);
  EXPECT_EQ(found.cut, 0);
}

} // namespace Rhegma::rigid_tools
