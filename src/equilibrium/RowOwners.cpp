#include "equilibrium/RowOwners.hpp"

#include "parallel/SendRows.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace Rhegma::equilibrium
{

namespace
{

/// Numbers of pieces that are one.
class JoinedPieces
{
public:
  explicit JoinedPieces(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int first(int piece)
  {
    while (parent_[piece] != piece)
      piece = parent_[piece] = parent_[parent_[piece]];
    return piece;
  }

  void join(int a, int b)
  {
    a = first(a);
    b = first(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<int> parent_;
};

} // namespace

RowOwners::RowOwners(const Ranks& ranks, std::vector<char> own, std::vector<long long> number)
    : ranks_(ranks), own_(std::move(own)), number_(std::move(number))
{
  for (std::size_t r = 0; r < number_.size(); ++r)
    sorted_.emplace_back(number_[r], static_cast<int>(r));
  std::sort(sorted_.begin(), sorted_.end());
  first_ = ranks_.gatherOnAll({static_cast<double>(std::count(own_.begin(), own_.end(), 1))});
  double before = 0.0;
  for (double& first : first_)
    before += std::exchange(first, before);
}

int RowOwners::find(long long number) const
{
  if (number_.empty())
    return static_cast<int>(number);
  const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::make_pair(number, -1));
  return at != sorted_.end() && at->first == number ? at->second : -1;
}

int RowOwners::rowOf(double number) const
{
  const int row = find(static_cast<long long>(number));
  if (row < 0)
    throw std::logic_error("an equilibrium couples rows that no window of a rank has");
  return row;
}

int RowOwners::ownerOf(long long number) const
{
  const auto above = std::upper_bound(first_.begin(), first_.end(), static_cast<double>(number));
  return static_cast<int>(above - first_.begin()) - 1;
}

void RowOwners::sendCouplings(std::vector<std::vector<int>>& coupled) const
{
  if (!ranks_.many())
    return;
  std::vector<int> to;
  std::vector<double> pairs;
  for (std::size_t r = 0; r < coupled.size(); ++r)
    if (!owns(static_cast<int>(r)))
      for (const int other : coupled[r])
      {
        to.push_back(ownerOf(number_[r]));
        pairs.push_back(static_cast<double>(number_[r]));
        pairs.push_back(static_cast<double>(number_[other]));
      }
  const std::vector<double> received = sendRows(ranks_, to, pairs, 2);
  for (std::size_t k = 0; k < received.size(); k += 2)
    coupled[rowOf(received[k])].push_back(rowOf(received[k + 1]));
}

void RowOwners::sendEntries(const RowGraph& graph, const View<double*>& values, int width) const
{
  if (!ranks_.many())
    return;
  std::vector<int> to;
  std::vector<double> sent;
  for (int r = 0; r < graph.rows; ++r)
    for (int e = graph.first(r); e < graph.first(r + 1) && !owns(r); ++e)
    {
      const double* const entry = &values(static_cast<std::size_t>(e) * width);
      if (std::all_of(entry, entry + width, [](double v) { return v == 0.0; }))
        continue;
      to.push_back(ownerOf(number_[r]));
      sent.push_back(static_cast<double>(number_[r]));
      sent.push_back(static_cast<double>(number_[graph.column(e)]));
      sent.insert(sent.end(), entry, entry + width);
    }
  const std::vector<double> received = sendRows(ranks_, to, sent, 2 + width);
  for (std::size_t k = 0; k < received.size(); k += 2 + width)
  {
    const std::size_t e = graph.find(rowOf(received[k]), rowOf(received[k + 1]));
    for (int c = 0; c < width; ++c)
      values(e * width + c) += received[k + 2 + c];
  }
}

std::pair<std::vector<int>, int> RowOwners::joinPieces(const std::vector<int>& piece, int count) const
{
  if (!ranks_.many())
    return {piece, count};
  const std::vector<double> counts = ranks_.gatherOnAll({static_cast<double>(count)});
  const double before = std::accumulate(counts.begin(), counts.begin() + ranks_.rank(), 0.0);
  std::vector<int> to;
  std::vector<double> sent;
  for (std::size_t r = 0; r < piece.size(); ++r)
    if (!owns(static_cast<int>(r)))
    {
      to.push_back(ownerOf(number_[r]));
      sent.push_back(static_cast<double>(number_[r]));
      sent.push_back(before + piece[r]);
    }
  const std::vector<double> received = sendRows(ranks_, to, sent, 2);
  std::vector<std::pair<double, double>> same;
  for (std::size_t k = 0; k < received.size(); k += 2)
    same.emplace_back(before + piece[rowOf(received[k])], received[k + 1]);
  std::sort(same.begin(), same.end());
  same.erase(std::unique(same.begin(), same.end()), same.end());
  std::vector<double> flat;
  for (const auto& [a, b] : same)
    flat.insert(flat.end(), {a, b});
  flat = ranks_.gatherOnAll(flat);
  JoinedPieces joined(static_cast<int>(std::accumulate(counts.begin(), counts.end(), 0.0)));
  for (std::size_t k = 0; k < flat.size(); k += 2)
    joined.join(static_cast<int>(flat[k]), static_cast<int>(flat[k + 1]));
  std::vector<int> number(static_cast<std::size_t>(std::accumulate(counts.begin(), counts.end(), 0.0)));
  int all = 0;
  for (std::size_t k = 0; k < number.size(); ++k)
  {
    const int first = joined.first(static_cast<int>(k));
    number[k] = first == static_cast<int>(k) ? all++ : number[first];
  }
  std::vector<int> result;
  for (const int own : piece)
    result.push_back(number[static_cast<std::size_t>(before) + own]);
  return {result, all};
}

template <int D>
RowOwners findOwners(const State<D>& state, const RowGraph& graph)
{
  const Ranks ranks = ranksOf(state);
  if (!ranks.many())
    return {};
  std::vector<char> own(graph.rows);
  for (int r = 0; r < graph.rows; ++r)
    own[r] = isOwnedByThisRank(state.mesh.nodes, graph.nodeOf(r)) ? 1 : 0;
  const std::vector<double> counts =
      ranks.gatherOnAll({static_cast<double>(std::count(own.begin(), own.end(), 1))});
  double next = std::accumulate(counts.begin(), counts.begin() + ranks.rank(), 0.0);
  const View<double*> one("rhegma::equilibrium::numbers", graph.rows); // from 1: 0 is not sent
  for (int r = 0; r < graph.rows; ++r)
    one(r) = own[r] != 0 ? ++next : 0.0;
  sumOverRanks(state, one.data(), 1, 0, 1, graph.rowOf);
  std::vector<long long> number(graph.rows);
  for (int r = 0; r < graph.rows; ++r)
  {
    number[r] = static_cast<long long>(one(r)) - 1;
    if (number[r] < 0)
      throw std::logic_error("no rank owns a row of an equilibrium");
  }
  return {ranks, std::move(own), std::move(number)};
}

template <int D>
void addOverRanks(const State<D>& state, const RowGraph& graph, const View<double*>& values)
{
  sumOverRanks(state, values.data(), D, 0, D, graph.rowOf);
}

template <int D>
void copyFromOwners(const State<D>& state, const RowGraph& graph, const RowOwners& owners,
                    const View<double*>& values)
{
  if (!owners.ranks().many())
    return;
  for (int r = 0; r < graph.rows; ++r)
    for (int d = 0; d < D && !owners.owns(r); ++d)
      values(D * r + d) = 0.0;
  addOverRanks(state, graph, values);
}

template RowOwners findOwners(const State<2>&, const RowGraph&);
template RowOwners findOwners(const State<3>&, const RowGraph&);
template void addOverRanks(const State<2>&, const RowGraph&, const View<double*>&);
template void addOverRanks(const State<3>&, const RowGraph&, const View<double*>&);
template void copyFromOwners(const State<2>&, const RowGraph&, const RowOwners&, const View<double*>&);
template void copyFromOwners(const State<3>&, const RowGraph&, const RowOwners&, const View<double*>&);

} // namespace Rhegma::equilibrium
