/// Which cells are refined: near fronts, in boxes, where the mean velocity gradient is large, with hysteresis
/// and rings; and when.

#include "Refined.hpp"

#include "adaptivity/Criteria.hpp"
#include "adaptivity/VelocityCriterion.hpp"

#include <functional>

namespace Rhegma
{
namespace Test
{

namespace
{

using adaptivity::Criteria;
using adaptivity::wantedBranches;

/// A square, or cube, of 8 cells of 1 m whose particles have a velocity gradient; nothing is refined.
template <int D>
Run<D> block()
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-2.0), all<D>(10.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Neo-Hookean", 0.3);
  addBox<D>(scene, "Block", all<D>(0.0), all<D>(8.0));
  scene.sublist("Adaptivity").set("Maximum Level", 2);
  scene.sublist("Adaptivity").set("Velocity Change", 1e30);
  Run<D> run(validated(scene));
  run.initialize();
  run.state().clock.step = 1; // before the first step particles have no gradient
  return run;
}

/// Sets the velocity gradient of all particles to `value` in its first component.
template <int D>
void setRate(State<D>& state, const std::function<double(const Vector<D>&)>& value)
{
  const HostParticles<D> particles(state);
  const auto rate = state.particles.table(fields::rate);
  for (int p = 0; p < particles.size; ++p)
    rate(p, 0) = value(particles.at(p));
}

template <int D>
Criteria<D> byVelocity(double change, int buffer, int levels = 2)
{
  Criteria<D> criteria;
  criteria.maximumLevel = levels;
  criteria.velocityChange = change;
  criteria.buffer = buffer;
  return criteria;
}

/// Refines by the criteria, then splits and merges particles.
template <int D>
Branches<D> adapt(State<D>& state, const Criteria<D>& criteria, const Branches<D>& now)
{
  Branches<D> wanted = wantedBranches(state, criteria, now);
  buildTree(wanted, state.mesh.tree);
  state.mesh.nodes.reserve(state.mesh.grid.numNodes + state.mesh.tree.numFine, state.mesh.nodes.numEnriched);
  state.particles.sorted = false;
  updateCells(state);
  return wanted;
}

template <int D>
int count(const Branches<D>& branches, int level)
{
  return level < branches.depth() ? static_cast<int>(branches.cells(level).size()) : 0;
}

/// The cell of a level that holds a position.
template <int D>
std::array<int, D> cellAt(const Grid<D>& grid, int level, const Vector<D>& x)
{
  std::array<int, D> cell;
  for (int d = 0; d < D; ++d)
    cell[d] = static_cast<int>(std::floor(std::ldexp(grid.inCells(x[d], d), level)));
  return cell;
}

template <int D>
void refinesWhereTheVelocityChanges()
{
  Run<D> run = block<D>();
  State<D>& state = run.state();
  const Branches<D> none(state.mesh.grid);
  const Vector<D> there = all<D>(3.5);
  const auto inCell = [&](const Vector<D>& x) { return norm(x - there) < 0.5 * std::sqrt(D) ? 1.0 : 0.0; };
  setRate<D>(state, inCell);
  // One cell, as 1 m * 1/s is above 0.9 m/s and not above 1.1 m/s.
  EXPECT_EQ(count(wantedBranches(state, byVelocity<D>(1.1, 0), none), 0), 0);
  const Branches<D> one = wantedBranches(state, byVelocity<D>(0.9, 0), none);
  EXPECT_EQ(count(one, 0), 1);
  EXPECT_TRUE(one.isRefined(0, cellAt(state.mesh.grid, 0, there)));
  EXPECT_EQ(one.depth(), 1);
  // Rings around it.
  EXPECT_EQ(count(wantedBranches(state, byVelocity<D>(0.9, 1), none), 0), D == 2 ? 9 : 27);
  EXPECT_EQ(count(wantedBranches(state, byVelocity<D>(0.9, 2), none), 0), D == 2 ? 25 : 125);
  // By one level at a time, however large the gradient.
  EXPECT_EQ(wantedBranches(state, byVelocity<D>(1e-3, 0), none).depth(), 1);
  // Before the first step there is no gradient.
  state.clock.step = 0;
  EXPECT_EQ(count(wantedBranches(state, byVelocity<D>(0.9, 0), none), 0), 0);
}

/// A gradient that alternates from particle to particle cancels in every cell.
template <int D>
void ignoresNoise()
{
  Run<D> run = block<D>();
  State<D>& state = run.state();
  const Branches<D> none(state.mesh.grid);
  setRate<D>(state,
             [](const Vector<D>& x) { return std::lround(2.0 * x[0] - 0.5) % 2 == 0 ? 100.0 : -100.0; });
  EXPECT_EQ(wantedBranches(state, byVelocity<D>(0.01, 0), none).depth(), 0);
}

template <int D>
void keepsCellsUntilTheChangeIsBelowItsFraction()
{
  Run<D> run = block<D>();
  State<D>& state = run.state();
  const Criteria<D> criteria = byVelocity<D>(1.0, 0);
  Branches<D> now(state.mesh.grid);
  double rate = 0.0;
  const auto levelsFor = [&](double value)
  {
    rate = value;
    setRate<D>(state, [&](const Vector<D>& x) { return x[0] > 3.0 && x[0] < 4.0 ? rate : 0.0; });
    now = adapt(state, criteria, now);
    return now.depth();
  };
  EXPECT_EQ(levelsFor(0.95), 0); // 0.95 m/s over a coarse cell
  EXPECT_EQ(levelsFor(1.05), 1);
  EXPECT_EQ(levelsFor(0.95), 1); // below what refines, above half of it
  EXPECT_EQ(levelsFor(0.55), 1);
  EXPECT_EQ(levelsFor(1.95), 1); // 0.975 m/s over a cell of level 1
  EXPECT_EQ(levelsFor(2.05), 2);
  EXPECT_EQ(levelsFor(1.05), 2); // 0.525 m/s over a cell of level 1
  EXPECT_EQ(levelsFor(0.95), 1);
  EXPECT_EQ(levelsFor(0.45), 0);
  EXPECT_EQ(levelsFor(2.05), 1);
  EXPECT_EQ(levelsFor(2.05), 2);
  EXPECT_EQ(levelsFor(0.0), 0); // from the deepest level to none
}

/// The mean over a refined cell counts for keeping it, not that of one of its parts.
template <int D>
void keepsByTheMeanOverTheLargeCell()
{
  Run<D> run = block<D>();
  State<D>& state = run.state();
  const Criteria<D> criteria = byVelocity<D>(1.0, 0, 1);
  Branches<D> now(state.mesh.grid);
  const auto set = [&](double lower, double upper)
  {
    setRate<D>(state,
               [=](const Vector<D>& x) {
                 return x[0] < 3.0 || x[0] > 4.0 ? 0.0 : x[0] < 3.5 ? lower : upper;
               });
    now = adapt(state, criteria, now);
  };
  set(1.2, 1.2);
  EXPECT_EQ(now.depth(), 1);
  set(1.2, 0.0); // 0.6 m/s
  EXPECT_EQ(now.depth(), 1);
  set(0.8, 0.0); // 0.4 m/s, though a part alone would have 0.8
  EXPECT_EQ(now.depth(), 0);
}

template <int D>
void refinesBoxes()
{
  Run<D> run = block<D>();
  State<D>& state = run.state();
  Criteria<D> criteria;
  criteria.maximumLevel = 2;
  criteria.regions.push_back({all<D>(2.0), all<D>(4.0), 2});
  const Branches<D> branches = wantedBranches(state, criteria, Branches<D>(state.mesh.grid));
  EXPECT_EQ(count(branches, 1), D == 2 ? 16 : 64); // all of 2^D cells of the lattice
  EXPECT_EQ(count(branches, 0), D == 2 ? 16 : 64); // and what balance needs around them
  // No deeper than the largest level.
  criteria.maximumLevel = 1;
  const Branches<D> shallow = wantedBranches(state, criteria, Branches<D>(state.mesh.grid));
  EXPECT_EQ(shallow.depth(), 1);
  EXPECT_EQ(count(shallow, 0), D == 2 ? 4 : 8);
  // What reaches out of the domain is cut off.
  criteria.regions = {{all<D>(-50.0), all<D>(-1.0), 1}};
  EXPECT_EQ(count(wantedBranches(state, criteria, Branches<D>(state.mesh.grid)), 0), 1);
}

/// A crack with one front, in 2D, or with a straight one.
template <int D>
void putFront(State<D>& state, const Vector<D>& at)
{
  CrackSet<D>& cracks = state.cracks;
  const int vertices = D;
  cracks.vertex = View<double* [D]>("vertex", vertices);
  cracks.simplex = View<int* [D]>("simplex", 1);
  cracks.frontFacet = View<int* [2]>("frontFacet", 1);
  for (int v = 0; v < vertices; ++v)
  {
    cracks.simplex(0, v) = v;
    for (int d = 0; d < D; ++d)
      cracks.vertex(v, d) = at[d];
  }
  // The facet opposite of vertex 0 is the front: vertex 1, or 1 and 2, which lies along the last axis.
  cracks.vertex(0, 0) = at[0] - 3.0;
  if (D == 3)
    cracks.vertex(2, 2) = at[2] + 1.0;
  cracks.frontFacet(0, 0) = 0;
  cracks.frontFacet(0, 1) = 0;
  CrackFront<D> front;
  front.firstFacet = 0;
  front.numFacets = 1;
  cracks.fronts = {front};
  cracks.cracks = {Crack<D>()};
}

template <int D>
void refinesNearFronts()
{
  Run<D> run = block<D>();
  State<D>& state = run.state();
  Vector<D> tip = all<D>(3.5);
  putFront(state, tip);
  ASSERT_FALSE(state.cracks.empty());
  Criteria<D> criteria;
  criteria.maximumLevel = 1;
  criteria.frontCells = 0.9;
  const Branches<D> none(state.mesh.grid);
  Branches<D> now = wantedBranches(state, criteria, none);
  // In 2D cells whose faces are nearer than 0.9 m: 3 x 3, whose corners are 0.71 m away.
  EXPECT_EQ(count(now, 0), D == 2 ? 9 : 9 * 4);
  EXPECT_TRUE(now.isRefined(0, cellAt(state.mesh.grid, 0, tip)));
  // The cell at its left, 0.5 m away, stays as the front sways to 1.15 m from it; it would be refined from
  // 0.9 m on.
  const Vector<D> left = tip + (-1.0) * Vector<D>{1.0};
  tip[0] = 4.15;
  putFront(state, tip);
  const Branches<D> fresh = wantedBranches(state, criteria, none);
  EXPECT_FALSE(now == fresh);
  const Branches<D> kept = wantedBranches(state, criteria, now);
  EXPECT_TRUE(kept.isRefined(0, cellAt(state.mesh.grid, 0, left)));
  EXPECT_FALSE(fresh.isRefined(0, cellAt(state.mesh.grid, 0, left)));
  // Half a cell beyond, they are coarsened.
  tip[0] = 4.5;
  putFront(state, tip);
  EXPECT_FALSE(wantedBranches(state, criteria, kept).isRefined(0, cellAt(state.mesh.grid, 0, left)));
  criteria.frontCells = 0.0;
  EXPECT_EQ(wantedBranches(state, criteria, none).depth(), 0);
}

} // namespace

/// Cells are checked in step 1 and then in every step that Interval divides.
TEST(Criteria, IntervalSetsWhenCellsAreChecked)
{
  Teuchos::ParameterList scene = emptyScene<2>(all<2>(-2.0), all<2>(10.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Neo-Hookean", 0.3);
  addBox<2>(scene, "Block", all<2>(0.0), all<2>(8.0));
  scene.sublist("Adaptivity").set("Velocity Change", 0.1);
  scene.sublist("Adaptivity").set("Maximum Level", 1);
  scene.sublist("Adaptivity").set("Interval", 5);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  std::vector<long> refined;
  for (int k = 0; k < 20; ++k)
  {
    const int before = state.mesh.tree.generation;
    // Refined and coarse in turn.
    setRate<2>(state, [&](const Vector<2>& x)
               { return x[0] < 1.0 && state.mesh.tree.deepest == 0 && state.clock.step > 0 ? 1.0 : 0.0; });
    const long step = state.clock.step;
    run.step(1e30, false);
    if (state.mesh.tree.generation != before)
      refined.push_back(step);
  }
  EXPECT_EQ(refined, (std::vector<long>{1, 5, 10, 15}));
}
TEST(Criteria, VelocityRefinesIn2D) { refinesWhereTheVelocityChanges<2>(); }
TEST(Criteria, VelocityRefinesIn3D) { refinesWhereTheVelocityChanges<3>(); }
TEST(Criteria, VelocityIgnoresNoise)
{
  ignoresNoise<2>();
  ignoresNoise<3>();
}
TEST(Criteria, VelocityHasHysteresis)
{
  keepsCellsUntilTheChangeIsBelowItsFraction<2>();
  keepsCellsUntilTheChangeIsBelowItsFraction<3>();
}
TEST(Criteria, VelocityKeepsByTheMeanOverTheLargeCell)
{
  keepsByTheMeanOverTheLargeCell<2>();
  keepsByTheMeanOverTheLargeCell<3>();
}
TEST(Criteria, BoxesAreRefined)
{
  refinesBoxes<2>();
  refinesBoxes<3>();
}
TEST(Criteria, FrontsRefine)
{
  refinesNearFronts<2>();
  refinesNearFronts<3>();
}

} // namespace Test
} // namespace Rhegma
