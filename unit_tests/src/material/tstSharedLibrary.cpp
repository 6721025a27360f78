/// Laws of shared libraries against the law of the program with the same equations, and against closed forms.

#include "SharedLawCase.hpp"

#include "material/PolarDecomposition.hpp"

#include <algorithm>

namespace Rhegma
{
namespace Test
{

namespace
{

template <int D>
double largestOf(const Symmetric<D>& a)
{
  double largest = 0.0;
  for (const double c : a)
    largest = std::max(largest, std::fabs(c));
  return largest;
}

/// Strains both along random paths. The equations are the same, so that only rounding differs: the paths end
/// at stresses of the order of the yield stress, 0.01, of moduli of order one, so that 1e-10 of the stress
/// are some 5000 units of rounding of a strain.
template <int D>
void expectTheSame(const Teuchos::ParameterList& shared, Plane plane, unsigned seed)
{
  const Metal metal;
  Strained<D> mine(makeProperties(shared, "Test", plane));
  Strained<D> built(plastic(plane, metal.young, metal.poisson, metal.yield, metal.hardening));
  double worst = 0.0, largest = 0.0;
  for (const Gradient<D>& F : randomPath<D>(seed, 0.05, 8, 25))
  {
    mine.strain(F);
    built.strain(F);
    ASSERT_TRUE(mine.good && built.good);
    largest = std::max(largest, largestOf<D>(built.tau));
    for (int k = 0; k < symmetricSize<D>; ++k)
      worst = std::max(worst, std::fabs(mine.tau[k] - built.tau[k]));
    ASSERT_NEAR(mine.F[gradientSize<D> - 1], built.F[gradientSize<D> - 1], 1e-10);
  }
  EXPECT_GT(built.history[J2Plastic::plasticStrainIndex<D>], 0.02); // the path has flow to show
  EXPECT_LT(worst, 1e-10 * largest);
  EXPECT_NEAR(mine.stored(), built.stored(), 1e-10 * built.stored());
  EXPECT_NEAR(mine.dissipated(), built.dissipated(), 1e-10 * built.dissipated());
}

void expectTheSameEverywhere(const Teuchos::ParameterList& shared, const char* test)
{
  const unsigned seed = seedOf(test);
  for (unsigned k = 0; k < 5; ++k)
  {
    expectTheSame<3>(shared, Plane::Solid, seed + k);
    expectTheSame<2>(shared, Plane::Strain, seed + k);
    expectTheSame<2>(shared, Plane::Stress, seed + k);
  }
}

TEST(SharedLibrary, VumatIsTheBuiltInLaw)
{
  expectTheSameEverywhere(sharedLaw("j2_vumat", "VUMAT", "vumat", Metal{}), "SharedLibrary.Vumat");
}

TEST(SharedLibrary, GenericBehaviourIsTheBuiltInLaw)
{
  expectTheSameEverywhere(sharedLaw("j2_generic", "MFront", "J2", Metal{}), "SharedLibrary.Generic");
}

/// J2 in rate form with the rate of Jaumann, along stretches of one axis: the increments of strain add to the
/// logarithm of the stretch. In the middle of a step of x they have an error of x^3 / 12.
TEST(SharedLibrary, UmatSumsTheLogarithmicStrain)
{
  Metal metal;
  metal.yield = 0.02;
  Teuchos::ParameterList list = sharedLaw("j2_umat", "UMAT", "umat", metal);
  list.set("State Variables", 1);
  Strained<3> at(makeProperties(list, "Test", Plane::Solid));
  constexpr int steps = 400;
  constexpr double stretch = 1.1;
  for (int s = 1; s <= steps; ++s)
  {
    Gradient<3> F = identity<3>();
    F[0] = std::pow(stretch, static_cast<double>(s) / steps);
    at.strain(F);
  }
  ASSERT_TRUE(at.good);
  const double strain = std::log(stretch), mu = metal.young / (2.0 * (1.0 + metal.poisson));
  const double bulk = metal.young / (3.0 * (1.0 - 2.0 * metal.poisson));
  // mises = 2 mu (strain - 3/2 alpha) = yield + hardening alpha
  const double alpha = (2.0 * mu * strain - metal.yield) / (3.0 * mu + metal.hardening);
  const double mises = metal.yield + metal.hardening * alpha;
  const double step = strain / steps, error = steps * step * step * step; // generous by 12
  EXPECT_NEAR(at.tau[0] / stretch, bulk * strain + 2.0 / 3.0 * mises, 3.0 * error * metal.young);
  EXPECT_NEAR(at.tau[1] / stretch, bulk * strain - 1.0 / 3.0 * mises, 3.0 * error * metal.young);
  EXPECT_NEAR(at.history[SharedLawHistory::numbers + 6], alpha, 3.0 * error);
  // The strain that the law gets next: STRAN.
  EXPECT_NEAR(at.history[SharedLawHistory::numbers], strain, error);
  // Work is conserved: stored and dissipated add to the integral of tau : d, by the trapezoidal rule.
  const double J = stretch, start = metal.yield / (2.0 * mu); // strain at yield
  double work = 0.0;
  constexpr int fine = 20000;
  for (int i = 0; i < fine; ++i)
  {
    const double e = (i + 0.5) * strain / fine;
    const double flowed = e > start ? (2.0 * mu * e - metal.yield) / (3.0 * mu + metal.hardening) : 0.0;
    const double axial =
        bulk * e + 2.0 / 3.0 * (e > start ? metal.yield + metal.hardening * flowed : 2.0 * mu * e);
    work += std::exp(e) * axial * strain / fine;
  }
  EXPECT_NEAR(at.stored() + at.dissipated(), work, 1e-5 * work);
  EXPECT_GT(at.dissipated(), 0.5 * J * alpha * metal.yield);
}

/// A rotation of a strained body turns the stress, for each interface and at once by any angle; nothing else
/// changes.
TEST(SharedLibrary, RotationsTurnTheStress)
{
  const Metal metal;
  Teuchos::ParameterList umat = sharedLaw("j2_umat", "UMAT", "umat", metal);
  umat.set("State Variables", 1);
  for (const Teuchos::ParameterList& list :
       {sharedLaw("j2_vumat", "VUMAT", "vumat", metal), umat, sharedLaw("j2_generic", "MFront", "J2", metal)})
  {
    Random random;
    Strained<3> at(makeProperties(list, "Test", Plane::Solid));
    Gradient<3> F = random.deformation<3>(0.98, 1.02);
    // From the identity by steps, for the one with increments.
    for (int s = 1; s <= 20; ++s)
    {
      Gradient<3> part = identity<3>();
      for (int k = 0; k < 9; ++k)
        part[k] += s / 20.0 * (k % 2 == 0 ? 0.01 * (k + 1) : -0.004 * k) / 9.0;
      F = part;
      at.strain(F);
    }
    const Symmetric<3> before = at.tau;
    const double stored = at.stored(), dissipated = at.dissipated();
    constexpr double angle = 0.7;
    Gradient<3> Q = identity<3>();
    Q[0] = Q[4] = std::cos(angle);
    Q[1] = -std::sin(angle);
    Q[3] = std::sin(angle);
    at.strain(multiply<3>(Q, F));
    ASSERT_TRUE(at.good);
    const Symmetric<3> turned = rotate<3>(Q, before);
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(at.tau[k], turned[k], 1e-12 * metal.young);
    EXPECT_NEAR(at.stored(), stored, 1e-13);
    EXPECT_NEAR(at.dissipated(), dissipated, 1e-13);
  }
}

/// No step: the stress is that of the history.
TEST(SharedLibrary, StressAtRestIsThatOfTheLastStep)
{
  for (const auto& list :
       {sharedLaw("j2_vumat", "VUMAT", "vumat", Metal{}), sharedLaw("j2_generic", "MFront", "J2", Metal{})})
  {
    Strained<2> at(makeProperties(list, "Test", Plane::Stress));
    for (const Gradient<2>& F : randomPath<2>(7u, 0.05, 3, 10))
      at.strain(F);
    const Symmetric<2> before = at.tau;
    const LawHistory history = at.history;
    at.strain(at.F, 0.0);
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(at.tau[k], before[k], 1e-15);
    EXPECT_EQ(at.history, history);
  }
}

/// R^T R = 1 and U = U^T = R^T F, of gradients up to stretches of ten, each the same beside any others.
TEST(SharedLibrary, PolarDecompositionOfManyGradients)
{
  constexpr int n = 21;
  Random random;
  std::vector<double> F(9 * n), R(9 * n), U(6 * n);
  for (int l = 0; l < n; ++l)
  {
    const Gradient<3> one = random.deformation<3>(l % 2 == 0 ? 0.1 : 0.99, l % 2 == 0 ? 10.0 : 1.01);
    for (int k = 0; k < 9; ++k)
      F[k * n + l] = one[k];
  }
  polarDecomposition(n, F.data(), R.data(), U.data());
  constexpr int at[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  for (int l = 0; l < n; ++l)
  {
    std::array<double, 9> alone, R1;
    std::array<double, 6> U1;
    for (int k = 0; k < 9; ++k)
      alone[k] = F[k * n + l];
    polarDecomposition(1, alone.data(), R1.data(), U1.data());
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
      {
        double square = 0.0, product = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          square += R[(3 * k + i) * n + l] * R[(3 * k + j) * n + l];
          product += R[(3 * i + k) * n + l] * U[at[k][j] * n + l];
        }
        EXPECT_NEAR(square, i == j ? 1.0 : 0.0, 1e-14);
        EXPECT_NEAR(product, F[(3 * i + j) * n + l], 1e-13);
        EXPECT_NEAR(R1[3 * i + j], R[(3 * i + j) * n + l], 1e-15);
      }
    EXPECT_GT(U[l], 0.0);
  }
}

/// In the plane in closed form: the same as in general.
TEST(SharedLibrary, PolarDecompositionInThePlane)
{
  Random random;
  for (int i = 0; i < 20; ++i)
  {
    const Gradient<3> F = solid(random.deformation<2>(0.2, 5.0));
    std::array<double, 9> R, RofPlane;
    std::array<double, 6> U, UofPlane;
    polarDecomposition(1, F.data(), R.data(), U.data());
    polarDecomposition(1, F.data(), RofPlane.data(), UofPlane.data(), true);
    for (int k = 0; k < 9; ++k)
      EXPECT_NEAR(R[k], RofPlane[k], 1e-14);
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(U[k], UofPlane[k], 1e-13);
  }
}

std::string messageOf(const Teuchos::ParameterList& list)
{
  try
  {
    makeProperties(list, "Steel", Plane::Solid);
  }
  catch (const std::invalid_argument& wrong)
  {
    return wrong.what();
  }
  return "nothing was refused";
}

void expectRefusal(const Teuchos::ParameterList& list, const char* parameter, const char* part)
{
  const std::string message = messageOf(list);
  EXPECT_NE(message.find(std::string("Materials > Steel > ") + parameter), std::string::npos) << message;
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

/// What a scene may have wrong: one sentence each, with the parameter.
TEST(SharedLibrary, WrongLawsAreRefused)
{
  const auto expect = expectRefusal;
  const Teuchos::ParameterList right = sharedLaw("j2_vumat", "VUMAT", "vumat", Metal{});
  Teuchos::ParameterList list = right;
  list.set("Library File", std::string("/nowhere/law.so"));
  expect(list, "Library File", "there is no file /nowhere/law.so");
  list.set("Library File", std::string(__FILE__));
  expect(list, "Library File", "can't be loaded");
  list = right;
  list.set("Behaviour", std::string("Copper"));
  expect(list, "Behaviour", "has no function Copper, Copper_, copper or copper_");
  list = right;
  list.set("Constants", Teuchos::Array<double>(std::vector<double>{2.6, 0.3, 0.01}));
  expect(list, "Constants", "has 3 numbers, but vumat needs 4: Young, Poisson, Yield, Hardening");
  list = right;
  list.set("Constants", Teuchos::Array<double>(std::vector<double>{2.6, 0.5, 0.01, 0.0})); // 1 - 2 nu is zero
  expect(list, "Behaviour", "that is not finite for a strain of 1e-6");
  list = right;
  list.set("State Variables", 9);
  expect(list, "State Variables", "is 9, but vumat has 7");
  list = right;
  list.set("Young Modulus", 2.0);
  expect(list, "Young Modulus", "gives waves a modulus of 2.692 Pa, but \"vumat\" has one of 3.5 Pa");
  list.set("Wave Speed", 1.4);
  EXPECT_EQ(messageOf(list), "nothing was refused");
  list = sharedLaw("j2_umat", "UMAT", "umat", Metal{});
  expect(list, "State Variables", "the library does not say");
  list = right;
  list.set("Library File", std::string(RHEGMA_LAWS));
  expect(list, "Library File", "is a folder");
  list = sharedLaw("ends", "VUMAT", "data", Metal{});
  list.set("State Variables", 0);
  expect(list, "Behaviour", "is a variable");
}

/// A law that uses more than the scene gives it, where its library does not say how much: constants that
/// count only where it flows, and state variables that it reads and writes.
TEST(SharedLibrary, NumbersBehindArraysAreNotUsed)
{
  Teuchos::ParameterList list = sharedLaw("j2_umat", "UMAT", "umat", Metal{});
  list.set("State Variables", 1);
  EXPECT_EQ(messageOf(list), "nothing was refused");
  list.set("State Variables", mostStateVariables);
  EXPECT_EQ(messageOf(list), "nothing was refused");
  list.set("State Variables", 0);
  expectRefusal(list, "State Variables", "is 0, but \"umat\" writes number 1 too");
  const std::vector<double> right = {2.6, 0.3, 0.01, 0.05};
  list.set("State Variables", 1);
  for (std::size_t given = 0; given < right.size(); ++given)
  {
    const std::vector<double> few(right.begin(), right.begin() + static_cast<std::ptrdiff_t>(given));
    list.set("Constants", Teuchos::Array<double>(few));
    expectRefusal(list, "Constants", "uses number");
  }
  expectRefusal(list, "Constants", "has 3 numbers, but \"umat\" uses number 4 too");
}

/// What a law does in its first call. The third constant of the law says what.
TEST(SharedLibrary, LawsThatEndTheProcessAreRefused)
{
  Teuchos::ParameterList list = sharedLaw("ends", "VUMAT", "vumat", Metal{});
  list.set("State Variables", 0);
  const auto does = [&](double what)
  {
    list.set("Constants", Teuchos::Array<double>(std::vector<double>{2.6, 0.3, what, 0.0}));
    return list;
  };
  EXPECT_EQ(messageOf(does(0.0)), "nothing was refused");
  expectRefusal(does(1.0), "Behaviour", "ends the program (by exit or STOP) when it is called");
  expectRefusal(does(2.0), "Behaviour",
                "ends the program by signal 11 (segmentation fault) when it is called");
  expectRefusal(does(3.0), "Behaviour", "that is not finite");
  // 1 J/kg of a density of 2 kg/m3
  expectRefusal(does(4.0), "Behaviour", "dissipates -2 J/m3 in a strain of 1e-6");
  expectRefusal(does(5.0), "Behaviour", "resists no strain: its largest modulus is 0 Pa");
}

} // namespace

} // namespace Test
} // namespace Rhegma
