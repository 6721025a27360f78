#include "CubeScene.hpp"
#include "Pi.hpp"

#include "cracks/CrackGrowth.hpp"
#include "cracks/Opening.hpp"

#include <algorithm>
#include <functional>

using namespace Rhegma;
using namespace Rhegma::cracks;
using namespace Rhegma::cracks::test;

namespace
{

using Rhegma::Test::pi;
constexpr double toughness = 100.0;

/// A block with a disk at rest.
Teuchos::ParameterList disk(const Vector<3>& centre, double radius, double size)
{
  Teuchos::ParameterList scene = blockScene({size, size, size});
  Teuchos::ParameterList& crack = scene.sublist("Cracks").sublist("Cut");
  crack.set("Centre", numbers({centre[0], centre[1], centre[2]}));
  crack.set("Normal", numbers({0.0, 0.0, 1.0}));
  crack.set("Radius", radius);
  return scene;
}

/// The advance of a front node: direction and length.
using Step = std::function<FrontNodeAdvance<3>(const FrontNode<3>&)>;

void advance(State<3>& state, CrackGrowth<3>& growth, const Step& step)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    FrontAdvance<3> moved;
    moved.front = static_cast<int>(f);
    for (const FrontNode<3>& frontNode : state.cracks.fronts[f].nodes)
      moved.nodes.push_back(step(frontNode));
    if (!moved.nodes.empty())
      state.cracks.advances.push_back(moved);
  }
  growth.grow(state);
}

Step straightBy(double length)
{
  return [=](const FrontNode<3>& s) { return FrontNodeAdvance<3>{s.direction, length, toughness}; };
}

double radiusOf(const FrontNode<3>& s, const Vector<3>& centre)
{
  return std::hypot(s.position[0] - centre[0], s.position[1] - centre[1]);
}

} // namespace

/// A disk that grows evenly by a fifth of a cell at a time from 3 to 8 cells stays flat to rounding and
/// round: between front nodes a polygon of pieces of up to 1.5 cells lies up to 1.5^2 / (8 r) cells inside of
/// its circle, 0.1 here, and a front node that comes between two others begins there. The area that it
/// records is its new area to rounding, pieces keep within 0.5 and 1.5 cells, and each inner edge has a
/// triangle on both sides.
TEST(CrackGrowth, KeepsADiskRoundAndRecordsItsArea)
{
  const Vector<3> centre{10e-3, 10e-3, 10.3e-3};
  const auto run = start<3>(disk(centre, 3e-3, 20e-3));
  State<3>& state = run->state();
  CrackGrowth<3> growth;
  const double before = measureOpening(state.cracks, 0).size;
  for (int k = 0; k < 25; ++k)
    advance(state, growth, straightBy(0.2 * cell));
  const CrackFront<3>& front = state.cracks.fronts[0];
  const double area = measureOpening(state.cracks, 0).size;
  EXPECT_NEAR(front.budget.required, toughness * (area - before), 1e-10 * toughness * area);
  EXPECT_NEAR(front.budget.pending, front.budget.required, 1e-12);
  EXPECT_NEAR(front.extension.area, area - before, 1e-10 * area);
  EXPECT_NEAR(front.extension.mean, 5e-3, 0.02 * 5e-3);
  EXPECT_NEAR(front.extension.largest, 5e-3, 0.1 * cell);
  // The polygon's area is less than the circle's by a fraction of up to (1.5 / 8)^2 / 6.
  EXPECT_NEAR(area, pi * 64e-6, 0.02 * pi * 64e-6);
  ASSERT_GE(front.nodes.size(), 34u); // the rim has 50 cells
  ASSERT_LE(front.nodes.size(), 100u);
  double mean = 0.0;
  for (const FrontNode<3>& s : front.nodes)
    mean += radiusOf(s, centre) / double(front.nodes.size());
  EXPECT_NEAR(mean, 8e-3, 0.1 * cell);
  for (std::size_t k = 0; k < front.nodes.size(); ++k)
  {
    const FrontNode<3>&s = front.nodes[k], &next = front.nodes[(k + 1) % front.nodes.size()];
    EXPECT_NEAR(radiusOf(s, centre), mean, 0.12 * cell) << k;
    EXPECT_NEAR(s.position[2], centre[2], 1e-12);
    EXPECT_GE(s.facet, 0);
    const double piece = norm(next.position - s.position);
    EXPECT_GT(piece, 0.45 * cell);
    EXPECT_LT(piece, 1.55 * cell);
  }
  const auto neighbour = onHost(state.cracks.neighbour);
  int open = 0;
  for (std::size_t s = 0; s < neighbour.extent(0); ++s)
    for (int i = 0; i < 3; ++i)
      open += neighbour(s, i) < 0 ? 1 : 0;
  EXPECT_EQ(open, front.numFacets);
}

/// Front nodes that lag behind catch up: a front with a ripple of a fifth of a cell in every advance, at
/// every other front node, has a smaller ripple than without smoothing, 10 x 0.2 cells, and still records the
/// area that it gains.
TEST(CrackGrowth, SmoothsRipplesWithoutLossOfArea)
{
  const Vector<3> centre{10e-3, 10e-3, 10.3e-3};
  const auto run = start<3>(disk(centre, 5e-3, 20e-3));
  State<3>& state = run->state();
  CrackGrowth<3> growth;
  const double before = measureOpening(state.cracks, 0).size;
  for (int k = 0; k < 10; ++k)
    advance(
        state, growth,
        [&](const FrontNode<3>& s)
        {
          const double around = std::atan2(s.position[1] - centre[1], s.position[0] - centre[0]);
          return FrontNodeAdvance<3>{s.direction, (0.2 + 0.1 * std::sin(12.0 * around)) * cell, toughness};
        });
  const CrackFront<3>& front = state.cracks.fronts[0];
  const double area = measureOpening(state.cracks, 0).size;
  EXPECT_NEAR(front.budget.required, toughness * (area - before), 1e-10 * toughness * area);
  double least = 1e300, largest = 0.0;
  for (const FrontNode<3>& s : front.nodes)
  {
    least = std::min(least, radiusOf(s, centre));
    largest = std::max(largest, radiusOf(s, centre));
  }
  EXPECT_LT(largest - least, 0.9 * 2.0 * cell);
}

/// One front node never advances by itself. With nine tenths of the driving force of the others, smoothing
/// advances it: in each step by 0.375 of its distance behind them, by the smoothing of 0.25 and the
/// curvatures of a lone point and its neighbours, that is by at least 0.375 of what these advance once they
/// are ahead. With a tenth it does not move. The energy of the faces is still their area times the toughness.
TEST(CrackGrowth, AdvancesANodeThatNothingHoldsBackWithItsNeighbours)
{
  const Vector<3> centre{10e-3, 10e-3, 10.3e-3};
  for (const double driven : {0.9, 0.1})
  {
    const auto run = start<3>(disk(centre, 5e-3, 20e-3));
    State<3>& state = run->state();
    CrackGrowth<3> growth;
    const double before = measureOpening(state.cracks, 0).size;
    const int alone = state.cracks.fronts[0].nodes[5].name;
    const auto radii = [&]
    {
      std::pair<double, double> least(1e300, 0.0); // of the one alone, and of all
      for (const FrontNode<3>& s : state.cracks.fronts[0].nodes)
      {
        least.second = std::max(least.second, radiusOf(s, centre));
        if (s.name == alone)
          least.first = radiusOf(s, centre);
      }
      return least;
    };
    const double start = radii().first;
    for (int k = 0; k < 8; ++k)
    {
      for (FrontNode<3>& s : state.cracks.fronts[0].nodes)
        s.driving.release = (s.name == alone ? driven : 1.0) * toughness;
      advance(state, growth,
              [&](const FrontNode<3>& s) {
                return FrontNodeAdvance<3>{s.direction, s.name == alone ? 0.0 : 0.25 * cell, toughness};
              });
    }
    const auto [own, largest] = radii();
    if (driven < 0.5)
      EXPECT_NEAR(own, start, 1e-9);
    else
      EXPECT_GT(own - start, 0.375 * (largest - start - 0.25 * cell));
    const double area = measureOpening(state.cracks, 0).size;
    EXPECT_NEAR(state.cracks.fronts[0].budget.required, toughness * (area - before),
                1e-10 * toughness * area);
  }
}

/// A quarter of a disk between two planes of symmetry: the front node that lies on one of them advances by a
/// quarter of a cell in each step, the others by a tenth of a cell. With a mirror there it passes a part on
/// to the next one, as any other would, and without it does not.
TEST(CrackGrowth, EvensAFrontAtAMirror)
{
  double ahead[2] = {};
  for (const bool mirrored : {false, true})
  {
    Teuchos::ParameterList scene = disk({0.0, 0.0, 4.3e-3}, 5e-3, 10e-3);
    const auto run = start<3>(scene);
    State<3>& state = run->state();
    CrackGrowth<3> growth(mirrored ? std::vector<MirrorPlane>{{0, 0.0}, {1, 0.0}}
                                   : std::vector<MirrorPlane>{});
    ASSERT_LT(state.cracks.fronts[0].nodes.back().facet, 0); // an open line
    const int end = state.cracks.fronts[0].nodes.front().name;
    const double before = measureOpening(state.cracks, 0).size;
    for (int k = 0; k < 6; ++k)
      advance(state, growth,
              [&](const FrontNode<3>& s) {
                return FrontNodeAdvance<3>{s.direction, (s.name == end ? 0.25 : 0.1) * cell, toughness};
              });
    const CrackFront<3>& front = state.cracks.fronts[0];
    double mean = 0.0;
    for (const FrontNode<3>& s : front.nodes)
      mean += radiusOf(s, {0.0, 0.0, 0.0}) / double(front.nodes.size());
    ahead[mirrored] = radiusOf(front.nodes.front(), {0.0, 0.0, 0.0}) - mean;
    const double area = measureOpening(state.cracks, 0).size;
    EXPECT_NEAR(front.budget.required, toughness * (area - before), 1e-10 * toughness * area);
  }
  // Six advances by 0.15 cells more than the others.
  EXPECT_GT(ahead[0], 0.75 * 0.9 * cell);
  EXPECT_LT(ahead[1], 0.75 * ahead[0]);
}

/// Front nodes of a straight front advance one after the other, always in the same order, so that each sees
/// one neighbour ahead and the other behind, and its path is inclined by seven degrees: over ten cells that
/// would move it more than a cell to one side. Pieces stay within 0.3 of what they were, and the area is
/// recorded.
TEST(CrackGrowth, KeepsPointsApartThatAdvanceInTurn)
{
  const double size = 16e-3;
  Teuchos::ParameterList scene = blockScene({size, size, 8e-3});
  const std::vector<double> corners = {-1e-3, -1e-3,       4.3e-3, 3e-3,  -1e-3,       4.3e-3,
                                       3e-3,  size + 1e-3, 4.3e-3, -1e-3, size + 1e-3, 4.3e-3};
  scene.sublist("Cracks").sublist("Cut").set("Points", Teuchos::Array<double>(corners));
  const auto run = start<3>(scene);
  State<3>& state = run->state();
  CrackGrowth<3> growth;
  const auto pieces = [&]
  {
    const std::vector<FrontNode<3>>& frontNodes = state.cracks.fronts[0].nodes;
    std::vector<double> lengths;
    lengths.reserve(frontNodes.size());
    for (std::size_t k = 0; k + 1 < frontNodes.size(); ++k)
      lengths.push_back(norm(frontNodes[k + 1].position - frontNodes[k].position));
    return lengths;
  };
  const double before = measureOpening(state.cracks, 0).size;
  const std::size_t count = state.cracks.fronts[0].nodes.size();
  ASSERT_GE(count, 10u);
  const double usual = pieces()[count / 2];
  for (int turn = 0; turn < 40; ++turn)
    for (std::size_t k = 0; k < count; ++k)
    {
      ASSERT_EQ(state.cracks.fronts[0].nodes.size(), count) << turn;
      FrontAdvance<3> moved;
      moved.front = 0;
      moved.nodes.reserve(count);
      for (const FrontNode<3>& frontNode : state.cracks.fronts[0].nodes)
        moved.nodes.push_back({frontNode.direction, 0.0, 0.0});
      moved.nodes[k].length = 0.25 * cell;
      moved.nodes[k].toughness = toughness;
      state.cracks.advances.push_back(moved);
      growth.grow(state);
    }
  for (const double piece : pieces())
    EXPECT_NEAR(piece, usual, 0.3 * usual);
  const double area = measureOpening(state.cracks, 0).size;
  EXPECT_NEAR(state.cracks.fronts[0].budget.required, toughness * (area - before), 1e-10 * toughness * area);
  EXPECT_NEAR(area, before + 10.0 * cell * size, 0.02 * area);
}

/// A front that turns by 30 degrees makes a cone behind a sharp edge: its new faces lie at that angle.
TEST(CrackGrowth, Kinks)
{
  const Vector<3> centre{10e-3, 10e-3, 10.3e-3};
  const double radius = 4e-3, angle = pi / 6.0;
  const auto run = start<3>(disk(centre, radius, 20e-3));
  State<3>& state = run->state();
  CrackGrowth<3> growth;
  for (int k = 0; k < 8; ++k)
    advance(state, growth,
            [&](const FrontNode<3>& s)
            {
              const Vector<3> out{s.position[0] - centre[0], s.position[1] - centre[1], 0.0};
              const Vector<3> to = (std::cos(angle) / norm(out)) * out + std::sin(angle) * Vector<3>{0, 0, 1};
              return FrontNodeAdvance<3>{to, 0.25 * cell, toughness};
            });
  for (const FrontNode<3>& s : state.cracks.fronts[0].nodes)
  {
    const double rise = s.position[2] - centre[2], out = radiusOf(s, centre) - radius;
    EXPECT_NEAR(rise, 2.0 * cell * std::sin(angle), 0.15 * cell);
    EXPECT_NEAR(out, 2.0 * cell * std::cos(angle), 0.25 * cell);
    EXPECT_NEAR(s.direction[2], std::sin(angle), 0.05);
  }
}

/// A quarter of a disk slides along the two faces of its block, reaches the others piece by piece, and ends
/// there as a square that cuts the block: pi / 4 r^2 of the square's area at first, all of it but for what a
/// half cell at the corner makes up in the end.
TEST(CrackGrowth, EndsAtTheSurface)
{
  const double size = 8e-3;
  const auto run = start<3>(disk({0.0, 0.0, 4.3e-3}, 4e-3, size));
  State<3>& state = run->state();
  CrackGrowth<3> growth;
  bool parted = false;
  int steps = 0;
  while (!state.cracks.fronts[0].ended && steps < 80)
  {
    advance(state, growth, straightBy(0.25 * cell));
    for (const FrontNode<3>& s : state.cracks.fronts[0].nodes)
    {
      EXPECT_LT(s.position[0], size + 0.5 * cell);
      EXPECT_LT(s.position[1], size + 0.5 * cell);
      parted = parted || s.stopped;
    }
    ++steps;
  }
  EXPECT_TRUE(parted);
  EXPECT_TRUE(state.cracks.fronts[0].ended);
  EXPECT_NEAR(measureOpening(state.cracks, 0).size, size * size, 0.06 * size * size);
  EXPECT_EQ(state.cracks.frontFacet.extent(0), 0u);
  EXPECT_EQ(growth.toughnessAlong(state.cracks, 0).size(), 1u);
  EXPECT_NEAR(growth.toughnessAlong(state.cracks, 0)[0], toughness, 1e-10 * toughness);
  ASSERT_FALSE(state.warnings.empty());
  EXPECT_NE(state.warnings.back().find("reached the surface"), std::string::npos);
}

/// Two disks that grow towards each other stop three cells apart, front node by front node, which is reported
/// once for each.
TEST(CrackGrowth, SaysOnceThatAFrontStops)
{
  Teuchos::ParameterList scene = disk({6e-3, 8e-3, 4.3e-3}, 3e-3, 22e-3);
  scene.sublist("Bodies").sublist("Block").set("Upper Corner", numbers({22e-3, 16e-3, 8e-3}));
  Teuchos::ParameterList& other = scene.sublist("Cracks").sublist("Other");
  other = scene.sublist("Cracks").sublist("Cut");
  other.set("Centre", numbers({16e-3, 8e-3, 4.3e-3}));
  const auto run = start<3>(scene);
  State<3>& state = run->state();
  CrackGrowth<3> growth;
  for (int k = 0; k < 8; ++k)
    advance(state, growth, straightBy(0.25 * cell));
  int said = 0;
  for (const std::string& warning : state.warnings)
    said += warning.find("stopped") != std::string::npos ? 1 : 0;
  EXPECT_EQ(said, 2);
  for (const CrackFront<3>& front : state.cracks.fronts)
  {
    EXPECT_FALSE(front.stopped());
    EXPECT_TRUE(
        std::any_of(front.nodes.begin(), front.nodes.end(), [](const FrontNode<3>& s) { return s.stopped; }));
  }
  // Some nodes are stopped, whether others run or not.
  const CrackFront<3>& front = state.cracks.fronts[0];
  const auto landed =
      std::count_if(front.nodes.begin(), front.nodes.end(), [](const FrontNode<3>& s) { return s.landed; });
  EXPECT_EQ(landed, 0);
  EXPECT_GT(front.numStopped(), 0);
  EXPECT_LT(front.numStopped(), static_cast<int>(front.nodes.size()) / 2);
  EXPECT_EQ(front.stop.what, "less than three cells from crack Other");
  EXPECT_DOUBLE_EQ(front.stop.toughness, toughness);
}

/// Where half of a front advances, nodes next to the other half are opened too, by the triangles between
/// them: they require the energy of the nearest front node that has made a face.
TEST(CrackGrowth, GivesNodesThatStayTheToughnessOfTheirNeighbours)
{
  const Vector<3> centre{10e-3, 10e-3, 10.3e-3};
  const auto run = start<3>(disk(centre, 4e-3, 20e-3));
  State<3>& state = run->state();
  CrackGrowth<3> growth;
  const auto isDriven = [&](const FrontNode<3>& s) { return s.position[1] > centre[1]; };
  for (int k = 0; k < 12; ++k)
    advance(state, growth,
            [&](const FrontNode<3>& s) {
              return FrontNodeAdvance<3>{s.direction, isDriven(s) ? 0.2 * cell : 0.0, toughness};
            });
  const std::vector<FrontNode<3>>& frontNodes = state.cracks.fronts[0].nodes;
  EXPECT_TRUE(std::any_of(frontNodes.begin(), frontNodes.end(), isDriven));
  EXPECT_FALSE(std::all_of(frontNodes.begin(), frontNodes.end(), isDriven));
  const std::vector<double> along = growth.toughnessAlong(state.cracks, 0);
  ASSERT_EQ(along.size(), frontNodes.size());
  for (const double here : along)
    EXPECT_DOUBLE_EQ(here, toughness);
}
