#include "adaptivity/Ids.hpp"

#include "parallel/SendRows.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <vector>

namespace Rhegma::adaptivity
{

namespace
{

/// The ids from 0 to the largest in use, of which each rank keeps the list of an equal part.
class FreeIds
{
public:
  FreeIds(const Ranks& ranks, const std::vector<int>& ids) : ranks_(ranks), freeOf_(ranks.size(), 0.0)
  {
    const int largest = ids.empty() ? -1 : *std::max_element(ids.begin(), ids.end());
    end_ = static_cast<int>(ranks.max(double(largest))) + 1;
    part_ = std::max(1, (end_ + ranks.size() - 1) / ranks.size());
    const int begin = std::min(end_, part_ * ranks.rank()), until = std::min(end_, begin + part_);
    std::vector<char> used(until - begin, 0);
    std::vector<int> owners;
    owners.reserve(ids.size());
    for (const int id : ids)
      owners.push_back(id / part_);
    for (const double id : sendRows(ranks, owners, std::vector<double>(ids.begin(), ids.end()), 1))
      used[static_cast<int>(id) - begin] = 1;
    for (int id = begin; id < until; ++id)
      if (used[id - begin] == 0)
        free_.push_back(id);
    freeOf_[ranks.rank()] = static_cast<double>(free_.size());
    ranks.sum(freeOf_.data(), ranks.size());
  }

  /// The smallest free ids, in the order of the ranks. \param wanted by each rank \return this rank's
  std::vector<int> claim(const std::vector<double>& wanted) const
  {
    double before = 0.0; // free ids of ranks before
    for (int r = 0; r < ranks_.rank(); ++r)
      before += freeOf_[r];
    // The k-th free id goes to the rank whose range of wanted ids holds k.
    std::vector<int> to;
    std::vector<double> rows; // k, id
    double end = 0.0;
    std::size_t i = 0;
    for (int r = 0; r < ranks_.size(); ++r)
    {
      end += wanted[r];
      for (; i < free_.size() && before + double(i) < end; ++i)
      {
        to.push_back(r);
        rows.push_back(before + double(i));
        rows.push_back(free_[i]);
      }
    }
    double first = 0.0, all = 0.0;
    for (int r = 0; r < ranks_.size(); ++r)
    {
      first += r < ranks_.rank() ? wanted[r] : 0.0;
      all += freeOf_[r];
    }
    // All ids beyond the largest in use are free.
    std::vector<int> mine(static_cast<std::size_t>(wanted[ranks_.rank()]));
    for (std::size_t k = 0; k < mine.size(); ++k)
      mine[k] = end_ + static_cast<int>(first + double(k) - all);
    const std::vector<double> reported = sendRows(ranks_, to, rows, 2);
    for (std::size_t row = 0; row < reported.size(); row += 2)
      mine[static_cast<std::size_t>(reported[row] - first)] = static_cast<int>(reported[row + 1]);
    return mine;
  }

private:
  const Ranks& ranks_;
  std::vector<int> free_;      ///< of this rank's part
  std::vector<double> freeOf_; ///< how many each rank has
  int end_ = 0, part_ = 1;
};

/// The smallest ids that no particle has, where one rank has all particles.
std::vector<int> freeIds(const std::vector<int>& named, std::size_t wanted)
{
  const int end = named.empty() ? 0 : *std::max_element(named.begin(), named.end()) + 1;
  std::vector<char> used(end, 0);
  for (const int id : named)
    used[id] = 1;
  std::vector<int> free;
  for (int id = 0; free.size() < wanted; ++id)
    if (id >= end || used[id] == 0)
      free.push_back(id);
  return free;
}

} // namespace

template <int D>
void nameParticles(State<D>& state)
{
  const auto id = state.particles.integer(fields::id);
  const auto host = onHost(id);
  const Ranks ranks = ranksOf(state);
  std::vector<int> named, unnamed;
  for (int p = 0; p < static_cast<int>(host.extent(0)); ++p)
    if (host(p) >= 0)
      named.push_back(host(p));
    else
      unnamed.push_back(p);
  std::vector<int> found;
  if (!ranks.many())
    found = freeIds(named, unnamed.size());
  else
  {
    std::vector<double> wanted(ranks.size(), 0.0);
    wanted[ranks.rank()] = static_cast<double>(unnamed.size());
    ranks.sum(wanted.data(), ranks.size());
    found = FreeIds(ranks, named).claim(wanted);
  }
  for (std::size_t k = 0; k < unnamed.size(); ++k)
    host(unnamed[k]) = found[k];
  Kokkos::deep_copy(id, host);
}

template void nameParticles(State<2>&);
template void nameParticles(State<3>&);

} // namespace Rhegma::adaptivity
