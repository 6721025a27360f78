/// Data sent between ranks arrive completely; run on one rank and on two.

#include "parallel/SendRows.hpp"
#include "src/output/SmallState.hpp"
#include "src/step/Bodies.hpp"
#include "state/Migration.hpp"
#include "state/Subdomain.hpp"
#include "step/CoreStep.hpp"
#include "transfer/Scatter.hpp"
#include "transfer/Stencils.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <map>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

Ranks allRanks() { return Ranks(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD))); }

/// A position that follows from a particle's number, so that one whose rows were mixed up is found.
double positionOf(int id, int axis) { return 0.25 + 3.5 * std::fmod(0.618 * (id + 1) * (axis + 1), 1.0); }

/// Every rank has particles numbered by its rank.
template <int D>
State<D> scattered(const Ranks& ranks, int each)
{
  State<D> state = smallState<D>(each);
  state.ranks = ranks;
  std::vector<double> position;
  std::vector<int> ids;
  for (int k = 0; k < each; ++k)
  {
    ids.push_back(ranks.rank() * each + k);
    for (int d = 0; d < D; ++d)
      position.push_back(positionOf(ids.back(), d));
  }
  fill(state.particles.table(fields::position), position);
  fill(state.particles.integer(fields::id), ids);
  return state;
}

template <int D>
void particlesStayWhole()
{
  const Ranks ranks = allRanks();
  if (!ranks.many())
    return;
  const int each = 200;
  State<D> state = scattered<D>(ranks, each);
  std::mt19937 random(ranks.rank());
  for (int round = 0; round < 3; ++round)
  {
    std::vector<int> owner;
    std::vector<double> sent(ranks.size(), 0.0);
    for (int p = 0; p < state.particles.size(); ++p)
    {
      owner.push_back(static_cast<int>(random() % ranks.size()));
      sent[owner.back()] += 1.0;
    }
    ranks.sum(sent.data(), ranks.size());
    sendParticles(state, owner);
    ASSERT_EQ(state.particles.size(), static_cast<int>(sent[ranks.rank()]));
  }
  const auto position = onHost(state.particles.template real<D>(fields::position));
  const auto id = onHost(state.particles.integer(fields::id));
  std::vector<double> found(each * ranks.size(), 0.0);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    found[id(p)] += 1.0;
    for (int d = 0; d < D; ++d)
      EXPECT_EQ(position(p, d), positionOf(id(p), d));
  }
  ranks.sum(found.data(), static_cast<int>(found.size()));
  for (const double count : found)
    EXPECT_EQ(count, 1.0);
}

/// Two boxes that touch, of 8 x 8 (x 8) cells, on these ranks; scattered and summed over them.
template <int D>
Run<D> onNodes(const Ranks& ranks)
{
  Vector<D> lower = all<D>(0.0), upper = all<D>(D == 2 ? 8.0 : 5.0), beyond = upper;
  upper[0] = 4.0;
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-3.0), beyond + all<D>(3.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<D>(scene, "Left", lower, upper);
  lower[0] = 4.0;
  addBox<D>(scene, "Right", lower, beyond).set("Velocity", array(all<D>(0.5)));
  Run<D> run(validated(scene), {}, ranks);
  run.initialize();
  State<D>& state = run.state();
  sortState(state);
  storeStencils(state);
  clearNodes(state);
  scatter(state, ScatterWhat::All);
  sumOverRanks(state, SharedSums::MassAndMomentum);
  return run;
}

/// Mass and momentum along the first axis of the nodes that count here, by their positions in cells.
template <int D>
std::map<std::vector<long>, std::array<double, 2>> sumsOf(const State<D>& state)
{
  std::map<std::vector<long>, std::array<double, 2>> sums;
  const auto values = onHost(state.mesh.nodes.sums);
  const auto foreign = onHost(state.mesh.nodes.foreign);
  for (int n = 0; n < state.mesh.nodes.numLattice; ++n)
  {
    if (foreign.extent(0) > 0 && foreign(n) != 0)
      continue;
    const Vector<D> x = state.mesh.grid.nodePosition(n);
    std::vector<long> position;
    for (int d = 0; d < D; ++d)
      position.push_back(std::lround(x[d]));
    if (values(n, Nodes<D>::massAt) > 0.0)
      sums[position] = {values(n, Nodes<D>::massAt), values(n, Nodes<D>::momentumAt)};
  }
  return sums;
}

template <int D>
void nodesHaveTheSumsOfOneRank()
{
  const Ranks ranks = allRanks();
  const Run<D> alone = onNodes<D>(Ranks()), together = onNodes<D>(ranks);
  const auto right = sumsOf(alone.state()), found = sumsOf(together.state());
  for (const auto& [position, sums] : found)
  {
    ASSERT_EQ(right.count(position), 1u);
    EXPECT_NEAR(sums[0], right.at(position)[0], 1e-14);
    EXPECT_NEAR(sums[1], right.at(position)[1], 1e-14);
  }
  EXPECT_EQ(ranks.sum(static_cast<double>(found.size())), static_cast<double>(right.size()))
      << "each node counts on one rank";
}

} // namespace

TEST(OnRanks, RowsArriveOnce)
{
  const Ranks ranks = allRanks();
  std::mt19937 random(3 + ranks.rank());
  const int count = 500;
  std::vector<int> to;
  std::vector<double> rows, sent(2 * ranks.size(), 0.0);
  for (int i = 0; i < count; ++i)
  {
    to.push_back(static_cast<int>(random() % ranks.size()));
    const double number = static_cast<double>(random() % 1000);
    rows.insert(rows.end(), {number, -number, 0.5 * number});
    sent[2 * to.back()] += number;
    sent[2 * to.back() + 1] += 1.0;
  }
  ranks.sum(sent.data(), static_cast<int>(sent.size()));
  const std::vector<double> received = sendRows(ranks, to, rows, 3);
  ASSERT_EQ(received.size(), static_cast<std::size_t>(3 * sent[2 * ranks.rank() + 1]));
  double sum = 0.0;
  for (std::size_t i = 0; i < received.size(); i += 3)
  {
    sum += received[i];
    EXPECT_EQ(received[i + 1], -received[i]);
    EXPECT_EQ(received[i + 2], 0.5 * received[i]);
  }
  EXPECT_EQ(sum, sent[2 * ranks.rank()]);
}

TEST(OnRanks, ParticlesStayWhole)
{
  particlesStayWhole<2>();
  particlesStayWhole<3>();
}

TEST(OnRanks, NodesHaveTheSumsOfOneRank)
{
  nodesHaveTheSumsOfOneRank<2>();
  nodesHaveTheSumsOfOneRank<3>();
}

TEST(OnRanks, EveryCellHasOneOwner)
{
  const Ranks ranks = allRanks();
  const Grid<2> lattice = makeGrid<2>({{0.0, 0.0}}, {{9.0, 5.0}}, 1.0);
  std::vector<Vector<2>> positions;
  for (int k = 0; k < 100; ++k)
    positions.push_back({2.0 * positionOf(ranks.rank() * 100 + k, 0), positionOf(k, 1)});
  const Division<2> division = divide<2>(ranks, lattice, positions);
  ASSERT_EQ(static_cast<int>(division.boxes.size()), ranks.size());
  for (const Vector<2>& x : positions)
  {
    int cell[2];
    division.cellAt(x, cell);
    const int owner = division.ownerOf(cell);
    ASSERT_TRUE(owner >= 0 && owner < ranks.size());
    EXPECT_TRUE(division.boxes[owner].holds(cell));
  }
}

} // namespace Test
} // namespace Rhegma
