#include "geometry/Slivers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::Geometry
{
namespace
{

template <int D>
bool isBefore(const std::array<long long, D>& a, const std::array<long long, D>& b)
{
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

/// Calls visit(index) for the parts in the cells around one.
template <int D, class Visit>
void forEachNeighbour(const std::vector<LatticePart<D>>& parts, const std::array<long long, D>& cell,
                      const Visit& visit)
{
  int cells = 1;
  for (int d = 0; d < D; ++d)
    cells *= 3;
  for (int k = 0; k < cells; ++k)
  {
    std::array<long long, D> at = cell;
    for (int d = 0, rest = k; d < D; ++d, rest /= 3)
      at[d] += rest % 3 - 1;
    auto part = std::lower_bound(parts.begin(), parts.end(), at,
                                 [](const LatticePart<D>& p, const std::array<long long, D>& c)
                                 { return isBefore<D>(p.cell, c); });
    for (; part != parts.end() && part->cell == at; ++part)
      visit(static_cast<int>(part - parts.begin()));
  }
}

/// The neighbours that a part is joined with: the nearest, or several that are equally near, so that mirror
/// images stay mirror images; those that can stand alone before others.
template <int D>
std::vector<int> hostsOf(const std::vector<LatticePart<D>>& parts, const std::vector<char>& gone, int part,
                         const IsSeen<D>& isSeen)
{
  constexpr double equally = 1.0 + 1e-6;
  const LatticePart<D>& sliver = parts[part];
  std::vector<int> hosts;
  bool alone = false;
  double nearest = std::numeric_limits<double>::infinity();
  forEachNeighbour<D>(
      parts, sliver.cell,
      [&](int k)
      {
        const bool stands = parts[k].stands();
        if (k == part || gone[k] != 0 || parts[k].fraction < sliver.fraction || (alone && !stands))
          return;
        const double distance = norm(parts[k].centroid - sliver.centroid);
        const bool better = stands && !alone;
        if ((distance > nearest * equally && !better) || !isSeen(sliver.centroid, parts[k].centroid))
          return;
        if (better || distance * equally < nearest)
        {
          hosts.clear();
          nearest = distance;
        }
        alone = stands;
        hosts.push_back(k);
      });
  return hosts;
}

} // namespace

template <int D>
void join(const LatticePart<D>& one, LatticePart<D>& to)
{
  const double all = one.fraction + to.fraction, a = one.fraction / all, b = to.fraction / all;
  for (int d = 0; d < D; ++d)
  {
    const double apart = one.centroid[d] - to.centroid[d];
    to.centroid[d] += a * apart;
    to.variance[d] = a * one.variance[d] + b * to.variance[d] + a * b * apart * apart;
  }
  to.fraction = all;
  to.family = -1;
}

/// Whether the box of a part is longer than a joined one may be.
template <int D>
bool isLong(const LatticePart<D>& part, const Vector<D>& edge)
{
  constexpr double rounding = 1.0 + 1e-6; // of two whole cells
  bool found = false;
  for (int d = 0; d < D; ++d)
    found = found || 12.0 * part.variance[d] > std::pow(longestJoined * rounding * edge[d], 2);
  return found;
}

template <int D>
void sortByCell(std::vector<LatticePart<D>>& parts)
{
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return isBefore<D>(a.cell, b.cell); });
}

template <int D>
void joinSlivers(std::vector<LatticePart<D>>& parts, const Vector<D>& edge, const IsSeen<D>& isSeen)
{
  std::vector<int> slivers;
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (!parts[k].stands())
      slivers.push_back(static_cast<int>(k));
  std::stable_sort(slivers.begin(), slivers.end(),
                   [&](int a, int b) { return parts[a].fraction < parts[b].fraction; });
  std::vector<char> gone(parts.size(), 0);
  // Hosts are chosen by the parts as they were, so that the order of mirror images does not matter.
  const std::vector<LatticePart<D>> before = slivers.empty() ? std::vector<LatticePart<D>>{} : parts;
  for (const int k : slivers)
  {
    if (parts[k].stands()) // by what has joined it
      continue;
    const std::vector<int> hosts = hostsOf(before, gone, k, isSeen);
    LatticePart<D> piece = parts[k];
    piece.fraction /= static_cast<double>(std::max<std::size_t>(hosts.size(), 1));
    std::vector<LatticePart<D>> joined;
    for (const int host : hosts)
      join(piece, joined.emplace_back(parts[host]));
    if (joined.empty() ||
        std::any_of(joined.begin(), joined.end(), [&](const auto& part) { return isLong(part, edge); }))
      continue;
    for (std::size_t h = 0; h < hosts.size(); ++h)
      parts[hosts[h]] = joined[h];
    gone[k] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (gone[k] == 0)
      parts[kept++] = parts[k];
  parts.resize(kept);
}

template <int D>
void joinOverLevels(PartsOfLevels<D>& parts, const Vector<D>& edge, const IsSeen<D>& isSeen)
{
  constexpr std::size_t most = 1000; // more are those of thin walls, which stay alone
  std::size_t slivers = 0;
  const auto isSliver = [](const LatticePart<D>& part) { return !part.stands(); };
  for (const std::vector<LatticePart<D>>& these : parts)
    slivers += std::count_if(these.begin(), these.end(), isSliver);
  if (parts.size() < 2 || slivers > most)
    return;
  for (std::size_t level = 0; level < parts.size(); ++level)
  {
    const auto hosted = [&](LatticePart<D> part)
    {
      LatticePart<D>* host = nullptr;
      std::size_t hostLevel = 0;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t other = 0; other < parts.size() && isSliver(part); ++other)
        for (LatticePart<D>& candidate : parts[other])
        {
          const double distance = norm(candidate.centroid - part.centroid);
          const double within = std::ldexp(norm(edge), -static_cast<int>(std::min(level, other)));
          if (other == level || isSliver(candidate) || distance >= std::min(nearest, within) ||
              !isSeen(part.centroid, candidate.centroid))
            continue;
          host = &candidate;
          hostLevel = other;
          nearest = distance;
        }
      if (host == nullptr)
        return false;
      part.fraction = std::ldexp(part.fraction, D * (static_cast<int>(hostLevel) - static_cast<int>(level)));
      join(part, *host);
      return true;
    };
    parts[level].erase(std::remove_if(parts[level].begin(), parts[level].end(), hosted), parts[level].end());
  }
}

template void join(const LatticePart<2>&, LatticePart<2>&);
template void join(const LatticePart<3>&, LatticePart<3>&);
template void sortByCell(std::vector<LatticePart<2>>&);
template void sortByCell(std::vector<LatticePart<3>>&);
template void joinSlivers(std::vector<LatticePart<2>>&, const Vector<2>&, const IsSeen<2>&);
template void joinSlivers(std::vector<LatticePart<3>>&, const Vector<3>&, const IsSeen<3>&);
template void joinOverLevels(PartsOfLevels<2>&, const Vector<2>&, const IsSeen<2>&);
template void joinOverLevels(PartsOfLevels<3>&, const Vector<3>&, const IsSeen<3>&);

} // namespace Rhegma::Geometry
