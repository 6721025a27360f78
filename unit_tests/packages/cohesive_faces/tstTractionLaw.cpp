/// The traction-separation laws: area, strength, mixed mode, unloading, energy and derivative, at random.

#include "cohesive_faces/LawsOfCracks.hpp"

#include "Seed.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

using namespace Rhegma;
using namespace Rhegma::cohesive_faces;

namespace
{

/// Parameters as a scene has them.
struct Draw
{
  std::string name;
  double energy[2], strength[2], exponent;
  TractionLaw law;
};

/// Laws of all names with random parameters.
std::vector<Draw> draws(std::mt19937& random)
{
  const auto between = [&random](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(random); };
  std::vector<Draw> all;
  for (const char* const name : {"Linear", "Bilinear", "Trapezoidal", "Exponential"})
    for (int k = 0; k < 5; ++k)
    {
      Draw draw{name,
                {between(50.0, 500.0), between(50.0, 2000.0)},
                {between(1e6, 5e7), between(1e6, 8e7)},
                between(1.0, 3.0),
                {}};
      Teuchos::ParameterList list;
      list.set("Law", draw.name);
      list.set("Toughness", draw.energy[0]).set("Toughness II", draw.energy[1]);
      list.set("Strength", draw.strength[0]).set("Shear Strength", draw.strength[1]);
      list.set("Exponent", draw.exponent);
      if (draw.name == "Trapezoidal")
        list.set("Plateau", between(0.0, 0.9));
      draw.law = readLaw(list, between(1e9, 2e11), between(1e-4, 1e-2), k % 2 == 0);
      all.push_back(draw);
    }
  return all;
}

/// The jump of a proportional path: `size` lambda at a mixity, slip along a direction of the face.
struct Jump
{
  double gap;
  Vector<2> slip;
};

Jump jumpAt(const TractionLaw& law, double size, double mixity, double angle)
{
  const double along = size * std::sqrt(mixity * law.normal / law.shear);
  return {size * std::sqrt(1.0 - mixity), {along * std::cos(angle), along * std::sin(angle)}};
}

/// Work of the tractions from one jump to another along the straight line, by Simpson's rule in pieces.
struct Walk
{
  TractionLaw law;
  double gap = 0.0, secant = 1.0, spent = 0.0;
  Vector<2> slip{};
  double work = 0.0, ofOpening = 0.0;

  double power(const Jump& at, const Jump& by, double& opening) const
  {
    const Cohesion<3> now = cohesionAt<3>(law, at.gap, at.slip, secant, spent);
    opening = now.tension * by.gap;
    return opening + dot(now.shear, by.slip);
  }
  void to(const Jump& end, int pieces)
  {
    const Jump step{(end.gap - gap) / pieces, (1.0 / pieces) * (end.slip - slip)};
    for (int k = 0; k < pieces; ++k)
    {
      for (const auto& [at, weight] : {std::array{0.0, 1.0}, std::array{0.5, 4.0}, std::array{1.0, 1.0}})
      {
        double opening = 0.0;
        const Jump here{gap + at * step.gap, slip + at * step.slip};
        work += weight / 6.0 * power(here, step, opening);
        ofOpening += weight / 6.0 * opening;
      }
      gap += step.gap;
      slip = slip + step.slip;
      const Cohesion<3> now = cohesionAt<3>(law, gap, slip, secant, spent);
      secant = now.secant;
      spent = now.spent;
    }
  }
};

/// Simpson's rule is exact for the straight parts; an exponential law takes 4000 pieces for 1e-12: its error
/// is (h^4 / 2880) f'''' of the path, 40 long in units of d, (0.01)^4 / 2880 40 10 = 1.4e-12 at most, and a
/// tenth of that as f'''' alternates.
double workTo(Walk& walk, const LawOfMode& mode, double mixity, double angle)
{
  if (walk.law.shape == Shape::Exponential)
    walk.to(jumpAt(walk.law, 40.0 * mode.onset, mixity, angle), 8000);
  else
    for (const double size : {mode.onset, mode.plateau, mode.end, 1.5 * mode.end})
      walk.to(jumpAt(walk.law, size, mixity, angle), 1);
  return walk.work;
}

double benzeggaghKenane(const Draw& draw, double mixity)
{
  return draw.energy[0] + (draw.energy[1] - draw.energy[0]) * std::pow(mixity, draw.exponent);
}

} // namespace

TEST(TractionLaw, ProportionalPathsTakeTheToughnessOfTheirMode)
{
  std::mt19937 random(Rhegma::Test::seed());
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const Draw& draw : draws(random))
    for (const double mixity : {0.0, 1.0, unit(random), unit(random)})
    {
      Walk walk;
      walk.law = draw.law;
      const double Gc = benzeggaghKenane(draw, mixity);
      EXPECT_NEAR(workTo(walk, draw.law.atMixity(mixity), mixity, 7.0 * unit(random)), Gc, 1e-12 * Gc)
          << draw.name << " at " << mixity;
      EXPECT_NEAR(walk.ofOpening, (1.0 - mixity) * Gc, 2e-12 * Gc);
      // The exponential law has (1 + x + x^2 / 2) exp(-x) left at x = 40: 4e-15.
      EXPECT_NEAR(walk.spent, 1.0, 1e-14);
    }
}

TEST(TractionLaw, EachModeHasItsStrength)
{
  std::mt19937 random(Rhegma::Test::seed());
  for (const Draw& draw : draws(random))
  {
    const double open = draw.law.atMixity(0.0).onset;
    const double slid = draw.law.atMixity(1.0).onset * std::sqrt(draw.law.normal / draw.law.shear);
    const Vector<1> none{{0.0}}, slip{{slid}};
    EXPECT_NEAR(cohesionAt<2>(draw.law, open, none, 1.0, 0.0).tension, draw.strength[0],
                1e-13 * draw.strength[0])
        << draw.name;
    EXPECT_NEAR(cohesionAt<2>(draw.law, 0.0, slip, 1.0, 0.0).shear[0], draw.strength[1],
                1e-13 * draw.strength[1]);
    for (const double other : {0.7, 1.3}) // less before and after, but for a plateau
      EXPECT_LE(cohesionAt<2>(draw.law, other * open, none, 1.0, 0.0).tension,
                (1.0 + 1e-13) * draw.strength[0]);
  }
}

TEST(TractionLaw, UnloadsToTheOriginAndDoesNotHeal)
{
  std::mt19937 random(Rhegma::Test::seed());
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const Draw& draw : draws(random))
  {
    const double mixity = unit(random);
    const LawOfMode mode = draw.law.atMixity(mixity);
    const double size = draw.law.shape == Shape::Exponential
                            ? 2.0 * mode.onset
                            : mode.onset + unit(random) * (mode.end - mode.onset);
    const auto at = [&](double part)
    {
      const Jump jump = jumpAt(draw.law, part * size, mixity, 0.0);
      return std::pair<double, Vector<1>>{jump.gap, {{jump.slip[0]}}};
    };
    const Cohesion<2> peak = cohesionAt<2>(draw.law, at(1.0).first, at(1.0).second, 1.0, 0.0);
    for (const double part : {0.5, 0.0, 0.9, 1.0})
    {
      const Cohesion<2> now =
          cohesionAt<2>(draw.law, at(part).first, at(part).second, peak.secant, peak.spent);
      EXPECT_NEAR(now.tension, part * peak.tension, 1e-14 * draw.strength[0]);
      EXPECT_NEAR(now.shear[0], part * peak.shear[0], 1e-14 * draw.strength[1]);
      EXPECT_EQ(now.secant, peak.secant);
    }
    // Faces that press have their first stiffness, if contact is not there.
    EXPECT_EQ(cohesionAt<2>(draw.law, -1e-6, {{0.0}}, peak.secant, peak.spent).tension,
              -1e-6 * draw.law.normal);
    TractionLaw touching = draw.law;
    touching.resistsOverlap = false;
    EXPECT_EQ(cohesionAt<2>(touching, -1e-6, {{0.0}}, peak.secant, peak.spent).tension, 0.0);
  }
}

/// Work less what unloading returns is what `dissipated` says on proportional paths, and never falls on
/// others.
TEST(TractionLaw, DissipatesWhatItDoesNotStore)
{
  std::mt19937 random(Rhegma::Test::seed());
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const Draw& draw : draws(random))
  {
    const auto lost = [](const Walk& walk)
    {
      const Cohesion<3> now = cohesionAt<3>(walk.law, walk.gap, walk.slip, walk.secant, walk.spent);
      return walk.work - 0.5 * (now.tension * walk.gap + dot(now.shear, walk.slip));
    };
    const double mixity = unit(random), Gc = benzeggaghKenane(draw, mixity);
    const LawOfMode mode = draw.law.atMixity(mixity);
    Walk straight;
    straight.law = draw.law;
    if (draw.law.shape == Shape::Exponential)
      straight.to(jumpAt(draw.law, 3.0 * mode.onset, mixity, 1.0), 2000);
    else
      for (const double size : {mode.onset, mode.plateau, 0.5 * (mode.plateau + mode.end)})
        straight.to(jumpAt(draw.law, size, mixity, 1.0), 1);
    EXPECT_NEAR(lost(straight), straight.spent * Gc, 1e-11 * Gc) << draw.name;
    Walk bent;
    bent.law = draw.law;
    const double far = draw.law.shape == Shape::Exponential ? 5.0 * mode.onset : mode.end;
    double before = 0.0;
    for (int k = 0; k < 8; ++k)
    {
      bent.to(jumpAt(draw.law, far * unit(random), unit(random), 7.0 * unit(random)), 4000);
      // Simpson's rule errs by a kink in one piece of 4000: of the order of Gc / 4000^2 each, three of them.
      EXPECT_GE(lost(bent), before - 1e-6 * Gc) << draw.name;
      before = lost(bent);
    }
  }
}

TEST(TractionLaw, StiffnessIsTheDerivative)
{
  std::mt19937 random(Rhegma::Test::seed());
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const Draw& draw : draws(random))
    for (int k = 0; k < 6; ++k)
    {
      const double mixity = 0.05 + 0.9 * unit(random);
      const LawOfMode mode = draw.law.atMixity(mixity);
      const double size = draw.law.shape == Shape::Exponential ? mode.onset * (0.1 + 4.0 * unit(random))
                          : k == 0                             ? 0.5 * mode.onset
                          : k < 3 && draw.law.plateau > 0.05
                              ? mode.onset + (0.1 + 0.8 * unit(random)) * (mode.plateau - mode.onset)
                              : mode.plateau + (0.1 + 0.8 * unit(random)) * (mode.end - mode.plateau);
      Jump at = jumpAt(draw.law, size, mixity, 7.0 * unit(random));
      if (k == 5)
        at.gap = -at.gap; // pressed and sliding
      const Cohesion<3> now = cohesionAt<3>(draw.law, at.gap, at.slip, 1.0, 0.0);
      double C[3][3];
      stiffnessAt<3>(branchAt<3>(draw.law, at.gap, at.slip, 1.0), draw.law, at.gap, at.slip, now, C);
      // Central differences: truncation step^2 / 6 t''' and rounding eps t / step, each below 1e-7 of the
      // stiffest entry for a step of 1e-5 of the jump over lambda / onset of some hundred.
      const double step = 1e-5 * size;
      for (int j = 0; j < 3; ++j)
      {
        std::array<double, 3> change{};
        for (const double sign : {1.0, -1.0})
        {
          Jump moved = at;
          (j == 0 ? moved.gap : moved.slip[j - 1]) += sign * step;
          const Cohesion<3> there = cohesionAt<3>(draw.law, moved.gap, moved.slip, 1.0, 0.0);
          change[0] += sign * there.tension;
          for (int t = 0; t < 2; ++t)
            change[1 + t] += sign * there.shear[t];
        }
        for (int i = 0; i < 3; ++i)
          EXPECT_NEAR(C[i][j], change[i] / (2.0 * step),
                      1e-6 * draw.law.stiffest() * now.secant + 1e-9 * draw.law.stiffest())
              << draw.name << " " << i << j << " case " << k;
      }
    }
}
