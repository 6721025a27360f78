/// The part of the stress that alternates from particle to particle.

#include "measure/StressAlternation.hpp"
#include "src/step/Bodies.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr int cells = 12; ///< along each axis

/// A body in whole cells, and a crack through it at a height that is no row of nodes.
template <int D>
Rhegma::Run<D> cutBody(const std::string& shape)
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-2.0), all<D>(cells + 2.0), 1.0, "MUSL", shape);
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<D>(scene, "Body", all<D>(0.0), all<D>(double(cells)));
  if (D == 2)
    scene.sublist("Cracks").sublist("Cut").set(
        "Points", Teuchos::Array<double>(Teuchos::tuple(-0.5, 4.6, cells + 0.5, 4.6)));
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  run.step(1e30, false); // nothing moves
  return run;
}

/// Gives the particles a stress. \param stress of a position and a component
template <int D, class Stress>
void setStress(State<D>& state, const Stress& stress)
{
  const HostParticles<D> particles(state);
  for (int p = 0; p < particles.size; ++p)
    for (int k = 0; k < symmetricSize<D>; ++k)
      particles.stress(p, k) = stress(particles.at(p), k);
  particles.store(state);
}

/// 1 in the upper row of particles of each cell, -1 in the lower one.
double row(double y) { return y - std::floor(y) > 0.5 ? 1.0 : -1.0; }

template <int D>
void testLinear()
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  Rhegma::Run<D> run = cutBody<D>("GIMP");
  double value[2][symmetricSize<D>][D + 1]; // below and above the crack
  for (auto& side : value)
    for (auto& component : side)
      for (double& number : component)
        number = between(random);
  setStress(run.state(),
            [&](const Vector<D>& x, int k)
            {
              const auto& own = value[D == 2 && x[1] > 4.6][k];
              double sum = own[D];
              for (int d = 0; d < D; ++d)
                sum += own[d] * x[d];
              return sum;
            });
  const measure::StressAlternation found = measure::stressAlternation(run.state(), 0);
  EXPECT_GT(found.largest, 1.0);
  EXPECT_LT(found.ratio(), 1e-10);
}

} // namespace

TEST(StressAlternation, LinearStressOnEachSideOfACrackHasNone) { testLinear<2>(); }
TEST(StressAlternation, LinearStressHasNone3D) { testLinear<3>(); }

/// Stresses of 0.1 and -0.1 from row to row, the third and fourth component as large as the second: the norm
/// of 0.1 (0, 1, 1, 1) is 0.2 as shear counts twice. Around nodes inside the body both the mean and the slope
/// vanish: sum w s = 0 and sum w s r = 0 with the weights 1/4, 3/4, 3/4, 1/4 of four rows. In the cells at
/// the upper and lower edge and on both sides of the crack the fit follows a part of it.
TEST(StressAlternation, OfRowsThatAlternate)
{
  Rhegma::Run<2> run = cutBody<2>("Linear");
  setStress(run.state(), [](const Vector<2>& x, int k) { return k == 0 ? 10.0 : 0.1 * row(x[1]); });
  const measure::StressAlternation found = measure::stressAlternation(run.state(), 0);
  EXPECT_NEAR(found.largest, 10.0, 0.01);
  EXPECT_LT(found.deviation, 0.2);
  EXPECT_GT(found.deviation, 0.2 * (cells - 5.0) / cells);
}

/// Scenes that do not ask for it have no such entry.
TEST(StressAlternation, IsInTheSummaryOnRequest)
{
  for (const bool asked : {false, true})
  {
    Teuchos::ParameterList scene = emptyScene<2>(all<2>(-2.0), all<2>(4.0), 1.0, "MUSL", "GIMP");
    addMaterial(scene, "Linear Elastic", 0.3);
    addBox<2>(scene, "Body", all<2>(0.0), all<2>(2.0));
    if (asked)
      scene.sublist("Measure").sublist("Stress Alternation");
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    run.step(1e30, false);
    nlohmann::json summary;
    summary["bodies"] = nlohmann::json::array({nlohmann::json::object()});
    int effects = 0;
    for (const Effect<2>& effect : run.plan().effects)
      if (effect.name == "Measure")
      {
        ++effects;
        effect.report(run.state(), summary);
      }
    EXPECT_EQ(effects, asked ? 1 : 0);
    EXPECT_EQ(summary["bodies"][0].contains("stress_alternation"), asked);
  }
}

} // namespace Test
} // namespace Rhegma
