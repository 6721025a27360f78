/// Stress intensities of inclined cracks at random places in their cells, against the closed form.

#include "Simulation.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>

using namespace Rhegma;

namespace
{

using Reals = Teuchos::Array<double>;

const double pi = std::acos(-1.0);
constexpr double young = 3e9, poisson = 0.33, density = 1200.0, halfLength = 5e-3, load = 1e6;

/// A crack in an infinite plate in plane stress, and the stress far away in its frame: opening, sliding,
/// along.
struct Case
{
  double angle, x, y;
  double opening, sliding, along;
  double modeI() const { return opening * std::sqrt(pi * halfLength); }
  double modeII() const { return sliding * std::sqrt(pi * halfLength); }
};

/// A crack at `angle`, pulled by `load` in a direction `turn` away from its normal.
Case pulled(double angle, double turn, double x, double y)
{
  const double c = std::cos(turn), s = std::sin(turn);
  return {angle, x, y, load * c * c, -load * s * c, load * s * s};
}

/// The displacement by Westergaard's functions (Westergaard, J. Appl. Mech. 6 (1939) A49; Sih, Int. J. Fract.
/// Mech. 2 (1966) 628) over the time of loading, as the scene takes it.
std::string displacement(const Case& crack, double loading)
{
  const double shear = young / (2.0 * (1.0 + poisson)), k = (3.0 - poisson) / (1.0 + poisson);
  const double c = std::cos(crack.angle), s = std::sin(crack.angle);
  const double even = crack.along - crack.opening;
  std::ostringstream text;
  text << std::setprecision(15);
  text << "c = " << c << "; s = " << s << "; a = " << halfLength << "; X = x - (" << crack.x << "); Y = y - ("
       << crack.y << "); p = c*X + s*Y; q = c*Y - s*X;"
       << "r = sqrt(sqrt(((p-a)^2 + q^2) * ((p+a)^2 + q^2))); h = (atan2(q, p-a) + atan2(q, p+a)) / 2;"
       << "f = r*cos(h); g = r*sin(h); m = (p*cos(h) + q*sin(h)) / r; n = (q*cos(h) - p*sin(h)) / r;"
       << "P = (" << crack.opening << "); T = (" << crack.sliding << "); N = (" << even << ");"
       << "u = (P*(" << 0.5 * (k - 1.0) << "*f - q*n) + T*(" << 0.5 * (k + 1.0) << "*g + q*m) + N*"
       << 0.25 * (k + 1.0) << "*p) / " << 2.0 * shear << ";"
       << "v = (P*(" << 0.5 * (k + 1.0) << "*g - q*m) - T*(" << 0.5 * (k - 1.0) << "*f + q*n) + N*("
       << 0.25 * (k - 3.0) << ")*q) / " << 2.0 * shear << ";"
       << "(c*u - s*v) / " << loading << ", (s*u + c*v) / " << loading;
  return text.str();
}

/// A square of 6 half lengths whose rim carries that displacement; 8 cells a half length.
Teuchos::RCP<Teuchos::ParameterList> plate(const Case& crack)
{
  const double cell = halfLength / 8.0, half = 3.0 * halfLength, loading = 2e-5;
  const auto scene = Teuchos::rcp(new Teuchos::ParameterList("Rhegma"));
  Teuchos::ParameterList& domain = scene->sublist("Domain");
  domain.set("Dimension", 2);
  domain.set<std::string>("Plane", "Stress");
  domain.set("Lower Corner", Reals(2, -half - 2.0 * cell));
  domain.set("Upper Corner", Reals(2, half + 2.0 * cell));
  domain.set("Cell Size", cell);
  scene->sublist("Time").set("Final Time", 1e-3);
  scene->sublist("Time").set("CFL", 0.8);
  Teuchos::ParameterList& resin = scene->sublist("Materials").sublist("Resin");
  resin.set<std::string>("Model", "Linear Elastic");
  resin.set("Density", density);
  resin.set("Young Modulus", young);
  resin.set("Poisson Ratio", poisson);
  Teuchos::ParameterList& body = scene->sublist("Bodies").sublist("Plate");
  body.set<std::string>("Material", "Resin");
  body.set<std::string>("Shape", "Box");
  body.set("Lower Corner", Reals(2, -half));
  body.set("Upper Corner", Reals(2, half));
  Teuchos::ParameterList& rim = scene->sublist("Boundaries").sublist("Rim");
  rim.set<std::string>("Type", "Velocity");
  rim.set<std::string>("Nodes", "Outside");
  rim.set("Lower Corner", Reals(2, -half));
  rim.set("Upper Corner", Reals(2, half));
  rim.set<std::string>("Field", displacement(crack, loading));
  // Its sum over steps is 1 to the third order of the step.
  rim.set<std::string>("History", "t < 2e-5 ? 1 - cos(2*pi*t/2e-5) : 0");
  const double c = halfLength * std::cos(crack.angle), s = halfLength * std::sin(crack.angle);
  Reals points(4);
  points[0] = crack.x - c;
  points[1] = crack.y - s;
  points[2] = crack.x + c;
  points[3] = crack.y + s;
  scene->sublist("Cracks").sublist("Notch").set("Points", points);
  scene->sublist("Energy Release").set("Crack Closure", false);
  // 1.3 times the lowest frequency of a held square is close to critical.
  const double shearSpeed = std::sqrt(young / (2.0 * (1.0 + poisson)) / density);
  Teuchos::ParameterList& damping = scene->sublist("Damping");
  damping.set("Mass Rate", 1.3 * pi * shearSpeed / (std::sqrt(2.0) * half));
  damping.set("Stop When Settled", true);
  damping.set("Settled Drift", 1e-5);
  return scene;
}

struct Errors
{
  std::vector<double> values;
  double mean() const
  {
    double sum = 0.0;
    for (const double v : values)
      sum += v;
    return sum / values.size();
  }
  double rms() const
  {
    double sum = 0.0;
    for (const double v : values)
      sum += v * v;
    return std::sqrt(sum / values.size());
  }
  double largest() const
  {
    double most = 0.0;
    for (const double v : values)
      most = std::max(most, std::fabs(v));
    return most;
  }
  void print(const std::string& name, const std::string& unit) const
  {
    std::cout << std::fixed << std::setprecision(2) << name << ": mean " << mean() << " " << unit << ", rms "
              << rms() << ", largest " << largest() << " of " << values.size() << " tips\n";
  }
};

} // namespace

/// What is asked of every tip: K within 1 %, the direction of the largest hoop stress within 0.5 degrees, at
/// 8 cells a half length. Without ties behind the fronts (Cracks > Front Ties) the crack of the cells is
/// longer or shorter by up to half a cell an end, and 1.2 % and 1.3 degrees are reached.
TEST(InclinedCracks, MeetTheClosedForm)
{
  std::mt19937 random(20);
  std::uniform_real_distribution<double> angle(0.0, pi), turn(-pi / 3.0, pi / 3.0), shift(-0.5, 0.5);
  Errors intensity, direction, release, length;
  for (int k = 0; k < 16; ++k)
  {
    const double a = angle(random), b = turn(random), cell = halfLength / 8.0;
    const double x = cell * shift(random), y = cell * shift(random);
    const Case crack = pulled(a, b, x, y);
    Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), plate(crack));
    simulation.initialize();
    simulation.sampleEvery(1e-5, {});
    simulation.advance(1e-3);
    EXPECT_TRUE(simulation.settled());
    const double K = std::hypot(crack.modeI(), crack.modeII());
    const double ratio = crack.modeI() / crack.modeII();
    const double kink =
        360.0 / pi *
        std::atan(0.25 * (ratio - std::copysign(std::sqrt(ratio * ratio + 8.0), crack.modeII())));
    const nlohmann::json report = simulation.report();
    ASSERT_EQ(report["cracks"][0]["fronts"].size(), 2u);
    for (const auto& front : report["cracks"][0]["fronts"])
    {
      const double found = std::hypot(front["K_I"].get<double>(), front["K_II"].get<double>());
      intensity.values.push_back(100.0 * (found / K - 1.0));
      direction.values.push_back(front["kink_angle"].get<double>() - kink);
      length.values.push_back(front["tip_offset"].get<double>() / cell);
      release.values.push_back(100.0 * (found / std::sqrt(young * front["G_J"].get<double>()) - 1.0));
    }
  }
  intensity.print("K against the closed form", "%");
  release.print("K against the root of E' J", "%");
  direction.print("kink against the closed form", "degrees");
  length.print("tip of the cells ahead of the front", "cells");
  EXPECT_LT(intensity.largest(), 1.0);
  EXPECT_LT(direction.largest(), 0.5);
  // The quadrature of both: (cell / inner)^2 / 24 of the singular products, twice for the square.
  EXPECT_LT(release.largest(), 1.0);
}
