/// Rows of an equilibrium on several ranks; run on one rank and on two.

#include "equilibrium/RowOwners.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace Rhegma
{
namespace Test
{

namespace
{

using equilibrium::RowOwners;

Ranks allRanks() { return Ranks(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD))); }

/// A graph with few edges, so that it has many pieces. All ranks have all rows, each under a number of its
/// own order, and each rank has some of the edges.
struct ScatteredGraph
{
  static constexpr int rows = 60, edges = 35;

  explicit ScatteredGraph(const Ranks& ranks)
  {
    std::mt19937 same(5), random(ranks.rank()); // the same edges on all ranks
    for (int r = 0; r < rows; ++r)
      number.push_back(r);
    std::shuffle(number.begin(), number.end(), random);
    std::vector<char> own;
    for (const long long n : number)
      own.push_back(n * ranks.size() / rows == ranks.rank() ? 1 : 0);
    owners = RowOwners(ranks, own, number);
    coupled.resize(rows);
    piece.resize(rows);
    for (int e = 0; e < edges; ++e)
    {
      const int a = static_cast<int>(same() % rows), b = static_cast<int>(same() % rows);
      all.insert({a, b});
      all.insert({b, a});
      if (static_cast<int>(same() % ranks.size()) != ranks.rank())
        continue;
      coupled[owners.find(a)].push_back(owners.find(b));
      coupled[owners.find(b)].push_back(owners.find(a));
    }
  }

  /// Pieces of the edges of this rank. \return their number
  int findPieces()
  {
    std::fill(piece.begin(), piece.end(), -1);
    int count = 0;
    for (int r = 0; r < rows; ++r)
      if (piece[r] < 0)
        fill(r, count++);
    return count;
  }

  void fill(int row, int with)
  {
    piece[row] = with;
    for (const int other : coupled[row])
      if (piece[other] < 0)
        fill(other, with);
  }

  std::vector<long long> number;
  RowOwners owners;
  std::vector<std::vector<int>> coupled;
  std::set<std::pair<int, int>> all; ///< edges of all ranks, of numbers
  std::vector<int> piece;
};

} // namespace

TEST(OnRanks, OwnersGetAllCouplings)
{
  ScatteredGraph graph(allRanks());
  graph.owners.sendCouplings(graph.coupled);
  int owned = 0;
  for (int r = 0; r < ScatteredGraph::rows; ++r)
  {
    const int number = static_cast<int>(graph.owners.numberOf(r));
    EXPECT_EQ(graph.owners.find(number), r);
    owned += graph.owners.owns(r) ? 1 : 0;
    for (int other = 0; other < ScatteredGraph::rows && graph.owners.owns(r); ++other)
    {
      const std::vector<int>& list = graph.coupled[r];
      EXPECT_EQ(std::count(list.begin(), list.end(), graph.owners.find(other)) > 0,
                graph.all.count({number, other}) > 0);
    }
  }
  EXPECT_EQ(allRanks().sum(owned), ScatteredGraph::rows);
  EXPECT_EQ(graph.owners.find(ScatteredGraph::rows), -1);
  EXPECT_EQ(graph.owners.sum(ScatteredGraph::rows, [&](int r) { return graph.owners.numberOf(r); }),
            ScatteredGraph::rows * (ScatteredGraph::rows - 1) / 2);
}

TEST(OnRanks, PiecesAreThoseOfTheWholeGraph)
{
  ScatteredGraph graph(allRanks());
  const int count = graph.findPieces();
  const auto [piece, all] = graph.owners.joinPieces(graph.piece, count);
  // The same from all edges.
  for (std::vector<int>& list : graph.coupled)
    list.clear();
  for (const auto& [a, b] : graph.all)
    graph.coupled[graph.owners.find(a)].push_back(graph.owners.find(b));
  ASSERT_EQ(graph.findPieces(), all);
  EXPECT_GT(all, 10);
  for (int r = 0; r < ScatteredGraph::rows; ++r)
    for (int other = 0; other < r; ++other)
      EXPECT_EQ(piece[r] == piece[other], graph.piece[r] == graph.piece[other]);
  // All ranks number them alike.
  for (int n = 0; n < ScatteredGraph::rows; ++n)
  {
    const double here = piece[graph.owners.find(n)];
    EXPECT_EQ(allRanks().max(here), here);
  }
}

TEST(OnRanks, EntriesAddUpAtTheirOwner)
{
  ScatteredGraph graph(allRanks());
  const int size = allRanks().size();
  equilibrium::RowGraph rows; // full, each rank with all entries
  rows.rows = ScatteredGraph::rows;
  rows.first = View<int*>("first", rows.rows + 1);
  rows.column = View<int*>("column", rows.rows * rows.rows);
  for (int k = 0; k < rows.rows * rows.rows; ++k)
  {
    rows.column(k) = k % rows.rows;
    rows.first(k / rows.rows + 1) = k + 1;
  }
  const View<double*> values("values", 2 * rows.rows * rows.rows);
  for (int k = 0; k < rows.rows * rows.rows; ++k)
  {
    values(2 * k) = static_cast<double>(graph.number[k / rows.rows] * 100 + graph.number[k % rows.rows]);
    values(2 * k + 1) = 1.0;
  }
  graph.owners.sendEntries(rows, values, 2);
  for (int k = 0; k < rows.rows * rows.rows; ++k)
    if (graph.owners.owns(k / rows.rows))
    {
      EXPECT_EQ(values(2 * k), size * (graph.number[k / rows.rows] * 100 + graph.number[k % rows.rows]));
      EXPECT_EQ(values(2 * k + 1), size);
    }
}

} // namespace Test
} // namespace Rhegma
