#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "geometry/Frame.hpp"
#include "plan/BoundaryType.hpp"
#include "plausibility/Bonds.hpp"
#include "plausibility/Judges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace Rhegma
{

namespace
{

using Geometry::Bounds;
using Teuchos::ParameterList;

/// A support that moves, and with it the bodies that are all inside of it.
template <int D>
struct MovingSupport
{
  Bounds<D> box;
  std::string axes;
  Vector<D> velocity; ///< mean over the run [m/s]
};

template <int D>
std::vector<MovingSupport<D>> movingSupports(const ParameterList& scene, double end)
{
  std::vector<MovingSupport<D>> supports;
  for (const BoundaryRegion& region : boundaryRegions(scene))
  {
    const ParameterList& list = scene.sublist("Boundaries").sublist(region.name);
    if (region.kind != BoundaryRegion::Kind::Held || !list.isParameter("Value"))
      continue;
    MovingSupport<D> support{{}, region.axes, {}};
    const double mean = rangeOf(list.get<std::string>("History"), end).integral / end;
    support.velocity = mean * readVector<D>(list, "Value");
    for (int d = 0; d < D; ++d)
    {
      support.box.lower[d] = region.from[d];
      support.box.upper[d] = region.to[d];
    }
    supports.push_back(support);
  }
  return supports;
}

template <int D>
bool contains(const Bounds<D>& box, const BodyMeasure<D>& body)
{
  for (int d = 0; d < D; ++d)
    if (box.lower[d] > body.lower[d] || box.upper[d] < body.upper[d])
      return false;
  return true;
}

/// Velocities of the bodies while nothing acts on them but supports that hold all of them [m/s].
template <int D>
std::vector<Vector<D>> velocities(const JudgedScene<D>& judged, double end)
{
  std::vector<Vector<D>> all;
  const auto supports = movingSupports<D>(judged.scene, end);
  for (const BodyMeasure<D>& body : judged.bodies)
  {
    Vector<D> v = body.velocity;
    for (const MovingSupport<D>& support : supports)
      for (int d = 0; d < D; ++d)
        if (contains(support.box, body) && support.axes.find(static_cast<char>('x' + d)) != std::string::npos)
          v[d] = support.velocity[d];
    all.push_back(v);
  }
  return all;
}

/// Nodes of the lattice and the first body whose particles touch each; -1: none.
template <int D>
class TouchedBy
{
public:
  explicit TouchedBy(const Grid<D>& grid) : grid_(grid), body_(grid.numNodes, -1) {}

  void add(const Vector<D>& x, int body)
  {
    visit(x,
          [&](int node)
          {
            if (body_[node] < 0)
              body_[node] = body;
          });
  }

  /// Calls see(body) for those whose nodes a particle at x touches.
  template <class See>
  void at(const Vector<D>& x, const See& see) const
  {
    visit(x,
          [&](int node)
          {
            if (body_[node] >= 0)
              see(body_[node]);
          });
  }

private:
  /// The corners of the cell of x; none outside of the domain.
  template <class Visit>
  void visit(const Vector<D>& x, const Visit& visit) const
  {
    int cell[D];
    for (int d = 0; d < D; ++d)
    {
      cell[d] = static_cast<int>(std::floor(grid_.inCells(x[d], d)));
      if (cell[d] < 0 || cell[d] >= grid_.cells[d])
        return;
    }
    for (int k = 0; k < 1 << D; ++k)
    {
      int node[D];
      for (int d = 0; d < D; ++d)
        node[d] = cell[d] + (k >> d & 1);
      visit(grid_.nodeIndex(node));
    }
  }

  const Grid<D>& grid_;
  std::vector<int> body_;
};

/// Pairs of bodies that come to touch the same nodes, and when [s].
using Meetings = std::map<std::pair<int, int>, double>;

/// Moves the particles of each body as a whole, cell by cell, past the others, which stay: of bodies that all
/// move, relative to each other's velocity.
template <int D>
class Passages
{
public:
  /// \param velocity of the bodies [m/s] \param end of the run [s]
  Passages(const State<D>& state, const std::vector<Vector<D>>& velocity, double end)
      : grid_(state.mesh.grid), velocity_(velocity), end_(end), positions_(velocity.size())
  {
    const auto host = [](const auto& view)
    { return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view); };
    const auto body = host(state.particles.integer(fields::body));
    const auto position = host(state.particles.template real<D>(fields::position));
    for (int p = 0; p < state.particles.size(); ++p)
    {
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = position(p, d);
      positions_[body(p)].push_back(x);
    }
  }

  Meetings find()
  {
    long nodes = 100'000'000; // that are looked at for all velocities together
    for (const auto& [frame, bodies] : frames())
    {
      if ((nodes -= grid_.numNodes) < 0)
        break;
      TouchedBy<D> touched(grid_);
      for (const int b : bodies)
        for (const Vector<D>& x : positions_[b])
          touched.add(x, b);
      for (std::size_t a = 0; a < positions_.size(); ++a)
        if (const Vector<D> v = velocity_[a] - velocity_[bodies.front()]; norm(v) > 0.0)
          pass(static_cast<int>(a), v, touched);
    }
    return found_;
  }

private:
  /// Bodies by their velocity.
  std::map<std::array<double, D>, std::vector<int>> frames() const
  {
    std::map<std::array<double, D>, std::vector<int>> frames;
    for (std::size_t b = 0; b < velocity_.size(); ++b)
    {
      std::array<double, D> v;
      std::copy_n(velocity_[b].c, D, v.begin());
      if (!positions_[b].empty())
        frames[v].push_back(static_cast<int>(b));
    }
    return frames;
  }

  void pass(int body, const Vector<D>& v, const TouchedBy<D>& touched)
  {
    std::set<int> before; // that it touches at the start, of which another judge speaks
    for (const Vector<D>& x : positions_[body])
      touched.at(x, [&](int other) { before.insert(other); });
    const double step = 0.5 * grid_.spacing / norm(v);
    int across = 0;
    for (int d = 0; d < D; ++d)
      across += 2 * grid_.cells[d]; // steps, after which it has left the domain
    const int steps = static_cast<int>(std::min<double>(across, end_ / step));
    for (int k = 1; k <= steps && looks_ > 0; ++k)
      for (const Vector<D>& start : positions_[body])
      {
        --looks_;
        touched.at(start + k * step * v,
                   [&](int other)
                   {
                     if (other != body && before.count(other) == 0)
                       found_.emplace(std::minmax(body, other), k * step);
                   });
      }
  }

  const Grid<D>& grid_;
  const std::vector<Vector<D>>& velocity_;
  double end_;
  std::vector<std::vector<Vector<D>>> positions_;
  Meetings found_;
  long looks_ = 20'000'000; ///< at particles; many bodies on their way have met by then
};

} // namespace

template <int D>
Messages judgeMeetings(const JudgedScene<D>& judged)
{
  Messages messages;
  if (!judged.state.method.mechanics || judged.bodies.size() < 2 || areKeptApart(judged.state))
    return messages;
  const double end = judged.scene.sublist("Time").template get<double>("Final Time");
  const std::vector<Vector<D>> velocity = velocities(judged, end);
  if (std::none_of(velocity.begin(), velocity.end(), [](const Vector<D>& v) { return norm(v) > 0.0; }))
    return messages;
  const auto bonded = bondedPairs(judged.scene);
  for (const auto& [pair, time] : Passages<D>(judged.state, velocity, end).find())
  {
    const std::string &one = judged.bodies[pair.first].name, &other = judged.bodies[pair.second].name;
    if (bonded.count({one, other}) > 0)
      continue;
    messages.push_back(
        "Bodies > " + other + ": it and Bodies > " + one + " approach each other at " +
        formatShort(norm(velocity[pair.first] - velocity[pair.second])) +
        " m/s, and are less than one to two cells (" + readableLength(judged.state.mesh.grid.spacing) +
        ") apart from about t = " + readableTime(time) + " on. " +
        (judged.state.method.totalLagrangian
             ? "With Domain > Formulation = Total Lagrangian bodies do not meet: they pass through each "
               "other; "
               "write Updated Lagrangian"
             : "Without the section Body Contact they share one motion from then on, which resists not only "
               "compression but also sliding and separation; add that section, such as with Law = "
               "Frictionless"));
  }
  return messages;
}

template Messages judgeMeetings(const JudgedScene<2>&);
template Messages judgeMeetings(const JudgedScene<3>&);

} // namespace Rhegma
