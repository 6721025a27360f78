#include "base/Numbers.hpp"
#include "base/PointText.hpp"
#include "plausibility/Bonds.hpp"
#include "plausibility/Judges.hpp"
#include "plausibility/NodesAround.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

namespace Rhegma
{

namespace
{

/// Calls see(body, node, position) for each node of the lattice that a particle touches.
template <int D, class See>
void forEachTouch(const State<D>& state, const See& see)
{
  const Grid<D>& grid = state.mesh.grid;
  const auto body = onHost(state.particles.integer(fields::body));
  const auto position = onHost(state.particles.template real<D>(fields::position));
  const auto edge = onHost(state.particles.template real<D>(fields::edge));
  for (int p = 0; p < state.particles.size(); ++p)
  {
    Vector<D> x;
    double longest = 0.0;
    for (int d = 0; d < D; ++d)
    {
      x[d] = position(p, d);
      longest = std::max(longest, edge(p, d));
    }
    forEachNode(grid, x, reachOfParticle(grid, longest),
                [&](int node, const Vector<D>& at) { see(body(p), node, at); });
  }
}

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
      forEachNode(grid_, x, 3.0, [&](int node, const Vector<D>&) { owner_[node] = nearCrack; });
    }
  }

  /// Calls meet(one body, the other, where) for each node that two bodies touch away from cracks.
  template <class Meet>
  void forEachMeeting(const Meet& meet)
  {
    forEachTouch(state_,
                 [&](int body, int node, const Vector<D>& at)
                 {
                   if (owner_[node] == -1)
                     owner_[node] = body;
                   else if (owner_[node] != nearCrack && owner_[node] != body)
                     meet(owner_[node], body, at);
                 });
  }

private:
  static constexpr int nearCrack = -2; ///< a crack may part the bodies there

  const State<D>& state_;
  const Grid<D>& grid_;
  std::vector<int> owner_;
};

/// Of the pairs of bodies that the scene bonds those that have no node in common, in the order of numbers.
template <int D>
std::set<std::pair<int, int>> bondedApart(const JudgedScene<D>& judged,
                                          const std::set<std::pair<std::string, std::string>>& bonded)
{
  std::unordered_map<std::string, int> numbers;
  for (const BodyMeasure<D>& body : judged.bodies)
    numbers.emplace(body.name, static_cast<int>(numbers.size()));
  std::set<std::pair<int, int>> apart;
  std::vector<char> wanted(judged.bodies.size(), 0);
  for (const auto& [one, other] : bonded)
    if (numbers.count(one) > 0 && numbers.count(other) > 0)
    {
      apart.insert(std::minmax(numbers.at(one), numbers.at(other)));
      wanted[numbers.at(one)] = wanted[numbers.at(other)] = 1;
    }
  std::vector<std::pair<int, int>> touched; // nodes and bodies
  if (!apart.empty())
    forEachTouch(judged.state,
                 [&](int body, int node, const Vector<D>&)
                 {
                   if (wanted[body] != 0)
                     touched.emplace_back(node, body);
                 });
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (auto first = touched.begin(); first != touched.end();)
  {
    const auto end =
        std::find_if(first, touched.end(), [&](const auto& t) { return t.first != first->first; });
    for (auto a = first; a != end; ++a)
      for (auto b = a + 1; b != end; ++b)
        apart.erase({a->second, b->second});
    first = end;
  }
  return apart;
}

/// Distance between the bounds of two bodies [m]; zero where they overlap.
template <int D>
double gapBetween(const BodyMeasure<D>& one, const BodyMeasure<D>& other)
{
  Vector<D> gap;
  for (int d = 0; d < D; ++d)
    gap[d] = std::max({0.0, one.lower[d] - other.upper[d], other.lower[d] - one.upper[d]});
  return norm(gap);
}

} // namespace

template <int D>
Messages judgeNeighbours(const JudgedScene<D>& judged)
{
  Messages messages;
  if (judged.bodies.size() < 2)
    return messages;
  std::map<std::pair<int, int>, Vector<D>> pairs;
  if (!areKeptApart(judged.state))
    Owners<D>(judged.state)
        .forEachMeeting([&](int one, int other, const Vector<D>& x)
                        { pairs.emplace(std::minmax(one, other), x); });
  const auto bonded = bondedPairs(judged.scene);
  for (const auto& [pair, x] : pairs)
  {
    const std::string &one = judged.bodies[pair.first].name, &other = judged.bodies[pair.second].name;
    if (bonded.count({one, other}) == 0)
      messages.push_back(
          "Bodies > " + other + ": it touches Bodies > " + one +
          " or is less than two cells away, such as at " + formatPoint(x) +
          ", so both share one motion there, as if bonded; leave two cells between them, write "
          "Bonded To = " +
          one + " if that is meant, or add the section Body Contact if they are to slide and part");
  }
  if (bonded.empty())
    return messages;
  for (const auto& pair : bondedApart(judged, bonded))
  {
    const BodyMeasure<D>&one = judged.bodies[pair.first], &other = judged.bodies[pair.second];
    const bool far = gapBetween(one, other) > 0.0;
    messages.push_back("Bodies > " + other.name + ": it and Bodies > " + one.name +
                       " are to be bonded (Bonded To), but have no node in common" +
                       (far ? " and are " + readableLength(gapBetween(one, other)) + " or more apart"
                            : ", though their bounds overlap") +
                       ", so each moves on its own; bodies are bonded where at most one to two cells of " +
                       readableLength(judged.state.mesh.grid.spacing) +
                       " lie between them: move one to the other, or leave Bonded To out");
  }
  return messages;
}

template Messages judgeNeighbours(const JudgedScene<2>&);
template Messages judgeNeighbours(const JudgedScene<3>&);

} // namespace Rhegma
