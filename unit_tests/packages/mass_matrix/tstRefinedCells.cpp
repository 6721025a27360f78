/// The mass matrix where cells are refined: what it keeps, with each type.

#include "Refined.hpp"

#include "output/CoreRow.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

struct Case
{
  const char* type;
  const char* update;
};

/// The types that refined cells go with.
const Case cases[] = {{"Lumped", "FLIP"}, {"FMPM", "FLIP"}, {"Lumped", "XPIC"}, {"Lumped", "FMPM"}};

} // namespace

TEST(MassOnRefinedCells, KeepsMomentumWithEveryType)
{
  for (const Case& c : cases)
    for (const char* shape : {"Linear", "GIMP"})
    {
      Teuchos::ParameterList scene = askewSquare(shape);
      scene.sublist("Mass Matrix").set("Type", c.type);
      scene.sublist("Mass Matrix").set("Velocity Update", c.update);
      scene.sublist("Adaptivity").set("Velocity Change", 4e-4);
      scene.sublist("Adaptivity").set("Interval", 5);
      Rhegma::Run<2> run(validated(scene));
      run.initialize();
      State<2>& state = run.state();
      const double size = shake(state, 1e-3);
      measureEnergy(state);
      const Vector<2> start = state.momentum;
      const int generation = state.tree.generation;
      for (int k = 0; k < 40; ++k)
      {
        run.step(1e30, false);
        measureEnergy(state);
        for (int d = 0; d < 2; ++d)
          EXPECT_NEAR(state.momentum[d], start[d], 1e-12 * size) << c.type << " " << c.update << " " << shape;
      }
      EXPECT_EQ(state.tree.deepest, 2);
      EXPECT_GT(state.tree.generation, generation + 2) << "the cells hardly changed";
    }
}

/// The first mode of a bar whose middle is refined, free at its ends.
TEST(MassOnRefinedCells, KeepsEnergyOverTenPeriods)
{
  for (const Case& c : {Case{"Lumped", "FLIP"}, Case{"FMPM", "FLIP"}})
    for (const char* shape : {"Linear", "GIMP"})
      for (const int level : {1, 2})
      {
        Teuchos::ParameterList scene = barScene<2>("MUSL", shape);
        scene.sublist("Time").set("CFL", 0.3);
        scene.sublist("Mass Matrix").set("Type", c.type);
        refine(scene, Vector<2>{{6.5, 0.5}}, Vector<2>{{9.5, 1.5}}, level);
        const Vibration v = vibrate<2>(scene, 1, 2.0 * barCells);
        std::printf("%s, %s, %d level(s): energy kept over ten periods %.5f, period %+.3f %%\n", c.type,
                    shape, level, v.kept, 100.0 * (v.period / (2.0 * barCells) - 1.0));
        // As the bar of equal cells.
        EXPECT_NEAR(v.kept, 1.0, 1e-3) << c.type << " " << shape << " " << level;
      }
}

} // namespace Test
} // namespace Rhegma
