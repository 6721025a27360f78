#include "base/PointText.hpp"
#include "plausibility/Bonds.hpp"
#include "plausibility/Judges.hpp"

#include <cmath>
#include <map>

namespace Rhegma
{

namespace
{

/// Nodes of the lattice, and which body's particles touch each first.
template <int D>
class Owners
{
public:
  explicit Owners(const State<D>& state) : state_(state), grid_(state.mesh.grid), owner_(grid_.numNodes, -1)
  {
    const auto vertices = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.cracks.vertex);
    for (std::size_t v = 0; v < vertices.extent(0); ++v)
    {
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = vertices(v, d);
      forEachNode(x, 3.0, [&](int node, const Vector<D>&) { owner_[node] = nearCrack; });
    }
  }

  /// Calls meet(one body, the other, where) for each node that two bodies touch away from cracks.
  template <class Meet>
  void forEachMeeting(const Meet& meet)
  {
    const auto host = [](const auto& view)
    { return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view); };
    const auto body = host(state_.particles.integer(fields::body));
    const auto position = host(state_.particles.template real<D>(fields::position));
    const auto edge = host(state_.particles.template real<D>(fields::edge));
    for (int p = 0; p < state_.particles.size(); ++p)
    {
      Vector<D> x;
      double half = 0.0;
      for (int d = 0; d < D; ++d)
      {
        x[d] = position(p, d);
        half = std::max(half, 0.5 * edge(p, d));
      }
      forEachNode(x, (1.0 + half * grid_.inverse) * (1.0 - 1e-9),
                  [&](int node, const Vector<D>& at)
                  {
                    if (owner_[node] == -1)
                      owner_[node] = body(p);
                    else if (owner_[node] != nearCrack && owner_[node] != body(p))
                      meet(owner_[node], body(p), at);
                  });
    }
  }

private:
  static constexpr int nearCrack = -2; ///< a crack may part the bodies there

  /// Nodes within so many cells of x along each axis.
  template <class See>
  void forEachNode(const Vector<D>& x, double cells, const See& see) const
  {
    int first[D], count[D], all = 1;
    for (int d = 0; d < D; ++d)
    {
      first[d] = std::max(0, static_cast<int>(std::ceil(grid_.inCells(x[d], d) - cells)));
      count[d] = std::min(grid_.cells[d], static_cast<int>(std::floor(grid_.inCells(x[d], d) + cells))) -
                 first[d] + 1;
      all *= std::max(0, count[d]);
    }
    for (int k = 0; k < all; ++k)
    {
      int at[D], rest = k;
      for (int d = 0; d < D; ++d)
      {
        at[d] = first[d] + rest % count[d];
        rest /= count[d];
      }
      see(grid_.nodeIndex(at), grid_.positionOf(at));
    }
  }

  const State<D>& state_;
  const Grid<D>& grid_;
  std::vector<int> owner_;
};

} // namespace

template <int D>
Messages judgeNeighbours(const JudgedScene<D>& judged)
{
  Messages messages;
  if (judged.bodies.size() < 2)
    return messages;
  std::map<std::pair<int, int>, Vector<D>> pairs;
  Owners<D>(judged.state)
      .forEachMeeting([&](int one, int other, const Vector<D>& x)
                      { pairs.emplace(std::minmax(one, other), x); });
  const auto bonded = bondedPairs(judged.scene);
  for (const auto& [pair, x] : pairs)
  {
    const std::string &one = judged.bodies[pair.first].name, &other = judged.bodies[pair.second].name;
    if (bonded.count({one, other}) == 0)
      messages.push_back("Bodies > " + other + ": it touches Bodies > " + one +
                         " or is less than two cells away, such as at " + formatPoint(x) +
                         ", so both share one motion there, as if bonded; leave two cells between them, or "
                         "write Bonded To = " +
                         one + " if that is meant");
  }
  return messages;
}

template Messages judgeNeighbours(const JudgedScene<2>&);
template Messages judgeNeighbours(const JudgedScene<3>&);

} // namespace Rhegma
