/// The mass matrix: its entries and its size.

#include "SquareScene.hpp"
#include "mass_matrix/MassRows.hpp"
#include "mass_matrix/MatrixMemory.hpp"
#include "transfer/ParticleViews.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace Rhegma
{
namespace Test
{

namespace
{

using mass_matrix::MassSystem;
using mass_matrix::Unlumping;

} // namespace

/// M u for a linear u against the sum over particles, and the row sums: A 1 = 0.
TEST(MassSystem, MultipliesAsTheSumOverParticles)
{
  for (const char* shape : {"Linear", "GIMP"})
  {
    Rhegma::Run<2> run(validated(squareScene("MUSL", shape, 17.0)));
    run.initialize();
    State<2>& state = run.state();
    run.step(1e30, false);
    Unlumping whole;
    whole.lumpedFraction = 0.0;
    whole.smallestNode = 0.0;
    MassSystem<2> system;
    // The nodes keep the masses of the step, for which the particles stood where they are but for the step's
    // move: so none moves here.
    mass_matrix::assemble(state, whole, system);
    ASSERT_GT(system.numCoupled, 30);
    const int n = system.rowCapacity * 2;
    View<double*> one("one", n), x("x", n), y("y", n);
    const auto hostOne = Kokkos::create_mirror_view(one), hostX = Kokkos::create_mirror_view(x);
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 2 * system.first; i < 2 * system.last; ++i)
    {
      hostOne(i) = 1.0;
      hostX(i) = number(generator);
    }
    Kokkos::deep_copy(one, hostOne);
    Kokkos::deep_copy(x, hostX);
    const auto lumped = onHost(system.lumped);
    // M x - L x
    const auto beyondLumped = [&](const View<double*>& from)
    {
      mass_matrix::multiply<2>(system, from.data(), y.data());
      const auto image = onHost(y);
      const auto given = onHost(from);
      std::vector<double> difference(n);
      for (int i = 2 * system.first; i < 2 * system.last; ++i)
        difference[i] = image(i) - lumped(i / 2) * given(i);
      return difference;
    };
    const double cellMass = 1.0;
    const auto ofOne = beyondLumped(one);
    double largest = 0.0;
    for (int i = 0; i < n; ++i)
      largest = std::max(largest, std::fabs(ofOne[i]));
    EXPECT_LT(largest, 1e-14 * cellMass) << shape;
    // x^T (M - L) x = - sum over particles of m times the variance of x over the weights; and the sum of
    // (M - L) x is 0, as it is symmetric with row sums of zero.
    const auto ofX = beyondLumped(x);
    double form = 0.0, sumOfImage = 0.0;
    for (int i = 0; i < n; ++i)
    {
      form += hostX(i) * ofX[i];
      sumOfImage += ofX[i];
    }
    const auto rowOf = onHost(system.rowOf);
    const auto mass = state.particles.scalar(fields::mass);
    double byParticles = 0.0;
    withConnectivity(state,
                     [&](const auto& connect)
                     {
                       for (int p = 0; p < state.particles.size(); ++p)
                         for (int d = 0; d < 2; ++d)
                         {
                           double mean = 0.0, square = 0.0;
                           connect.visit(p,
                                         [&](int node, double weight, const double*)
                                         {
                                           if (weight == 0.0)
                                             return;
                                           const double value = hostX(2 * rowOf(node) + d);
                                           mean += weight * value;
                                           square += weight * value * value;
                                         });
                           byParticles -= mass(p) * (square - mean * mean);
                         }
                     });
    EXPECT_LT(form, -0.1 * cellMass) << shape;
    EXPECT_NEAR(form, byParticles, 1e-12 * std::fabs(form)) << shape;
    EXPECT_LT(std::fabs(sumOfImage), 1e-12 * cellMass) << shape;
  }
}

/// Extrapolated weights are negative: the entries of a row next to its diagonal may add up to less than
/// nothing. Such a row is coupled all the same: a row that takes no part in solves has no entries.
TEST(MassSystem, LeavesOutOnlyRowsWithoutEntries)
{
  std::random_device device;
  const unsigned seed = device();
  std::printf("seed %u\n", seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  int negative = 0;
  for (int trial = 0; trial < 20; ++trial)
  {
    Teuchos::ParameterList scene =
        withMass(squareScene("MUSL", trial % 2 == 0 ? "Linear" : "GIMP", 20.0), {"", "Full", "FLIP", 0});
    scene.sublist("Cracks").set("Formulation", "Corrected Broken Cell");
    const double angle = 0.5 * number(generator), x = number(generator), y = number(generator);
    scene.sublist("Cracks").sublist("Slit").set(
        "Points", Teuchos::Array<double>(
                      std::vector<double>{x - 5.0 * std::cos(angle), y - 5.0 * std::sin(angle), x, y}));
    scene.sublist("Time").set("CFL", 0.1);
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    run.step(1e30, false);
    Unlumping whole;
    whole.lumpedFraction = 0.1;
    MassSystem<2> system;
    mass_matrix::assemble(run.state(), whole, system);
    const int n = system.rowCapacity * 2;
    View<double*> given("given", n), image("image", n);
    const auto hostGiven = Kokkos::create_mirror_view(given);
    const auto coupled = onHost(system.coupled);
    for (int i = 2 * system.first; i < 2 * system.last; ++i)
      hostGiven(i) = coupled(i / 2) ? number(generator) : 0.0;
    Kokkos::deep_copy(given, hostGiven);
    mass_matrix::multiply<2>(system, given.data(), image.data());
    const auto found = onHost(image);
    const auto lumped = onHost(system.lumped), band = onHost(system.band);
    for (int row = system.first; row < system.last; ++row)
    {
      const double diagonal = band(static_cast<std::size_t>(row) * system.stride + system.slots / 2);
      negative += diagonal > lumped(row) ? 1 : 0;
      if (coupled(row))
        continue;
      EXPECT_EQ(found(2 * row), 0.0) << "row " << row;
    }
  }
  EXPECT_GT(negative, 0);
}

TEST(MassMatrix, IsRefusedWhereItDoesNotFit)
{
  // A row of GIMP in 3D has 125 numbers of the band and 16 of vectors of four; a list has twice 125
  // numbers and their positions.
  const double row = mass_matrix::bytesPerRow<3>(ShapeKind::Gimp, false);
  EXPECT_GT(row, (125 + 16 * 4) * sizeof(double));
  EXPECT_LT(row, 2.0 * (125 + 16 * 4) * sizeof(double));
  EXPECT_EQ(mass_matrix::bytesPerRow<3>(ShapeKind::Gimp, true) - row, 250 * (sizeof(double) + sizeof(int)));
  EXPECT_NO_THROW(mass_matrix::refuseLargeMatrix(1e6, row, 1e6 * row, "less"));
  try
  {
    mass_matrix::refuseLargeMatrix(1e6, row, 0.5e6 * row, "less");
    ADD_FAILURE() << "a matrix of twice the memory was accepted";
  }
  catch (const std::invalid_argument& error)
  {
    const std::string words = error.what();
    EXPECT_EQ(words.rfind("Mass Matrix > Type: the matrix of about 1e+06 nodes needs ", 0), 0u) << words;
    EXPECT_NE(words.find("; take less"), std::string::npos) << words;
  }
}

/// As many rows as are reckoned with before a run, or fewer; in two fields next to a crack, and one
/// elsewhere.
TEST(MassMatrix, HasNoMoreRowsThanAreReckonedWith)
{
  for (const char* shape : {"Linear", "GIMP"})
    for (const char* type : {"Full", "Partial"})
    {
      Rhegma::Run<2> run(validated(withMass(squareScene("MUSL", shape, 17.0), {type, type, "FLIP", 0})));
      run.initialize();
      Unlumping unlumping;
      unlumping.everywhere = std::string(type) == "Full";
      unlumping.radius = 1.5;
      unlumping.edge = 1.0;
      const double reckoned = mass_matrix::largestRows(run.state(), unlumping);
      run.step(1e30, false);
      MassSystem<2> system;
      mass_matrix::assemble(run.state(), unlumping, system);
      const int rows = system.last - system.first;
      EXPECT_LE(rows, reckoned) << type << " " << shape;
      EXPECT_GT(rows, 0.2 * reckoned) << type << " " << shape;
    }
}

} // namespace Test
} // namespace Rhegma
