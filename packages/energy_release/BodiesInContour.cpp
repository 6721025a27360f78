#include "energy_release/BodiesInContour.hpp"

#include "base/Numbers.hpp"
#include "state/BodyGroup.hpp"
#include "transfer/BlocksInReach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace Rhegma::energy_release
{

namespace
{

constexpr char beginning[] = "Energy Release: the body ";

bool isWarnedOf(const std::vector<std::string>& warnings, const std::string& front)
{
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& warning)
                     {
                       return warning.compare(0, sizeof beginning - 1, beginning) == 0 &&
                              warning.find(front) != std::string::npos;
                     });
}

/// A body near a front.
struct NearBody
{
  double distance = std::numeric_limits<double>::infinity(); ///< of its nearest particle [m]
  int body = -1;                                             ///< -1: there is none
};

/// The nearest particle of another group than that of the front's crack, up to a radius around a point.
template <int D>
NearBody nearestBody(const State<D>& state, const ParticlesOfGroup& own, const Vector<D>& x, double radius)
{
  using Nearest = Kokkos::MinLoc<double, int>;
  BlocksInReach<D> blocks;
  blocks.find(state, {boxAround(x, radius)});
  const View<int* [2]> range = blocks.ranges();
  const auto position = state.particles.template real<D>(fields::position);
  const auto body = state.particles.integer(fields::body);
  typename Nearest::value_type found;
  Kokkos::parallel_reduce(
      "rhegma::nearestOtherBody", Kokkos::RangePolicy<ExecSpace>(0, blocks.count()),
      KOKKOS_LAMBDA(const int b, typename Nearest::value_type& best) {
        for (int p = range(b, 0); p < range(b, 1); ++p)
        {
          double square = 0.0;
          for (int d = 0; d < D; ++d)
            square += (position(p, d) - x[d]) * (position(p, d) - x[d]);
          if (!own.hold(p) && square < best.val)
          {
            best.val = square;
            best.loc = body(p);
          }
        }
      },
      Nearest(found));
  return found.val < radius * radius ? NearBody{std::sqrt(found.val), found.loc} : NearBody{};
}

} // namespace

template <int D>
void warnOfBodies(State<D>& state, const CrackFront<D>& front, double radius)
{
  const ParticlesOfGroup own = particlesOfCrack(state, front.crack);
  const std::string name = "of " + frontName(state.cracks, front) + ",";
  if (own.group == 0 || isWarnedOf(state.warnings, name))
    return;
  NearBody nearest;
  for (const Vector<D>& x : front.points())
    if (const NearBody found = nearestBody(state, own, x, radius); found.distance < nearest.distance)
      nearest = found;
  if (nearest.body < 0)
    return;
  state.warnings.push_back(beginning + state.bodies.info[nearest.body].name + " comes within " +
                           readableLength(nearest.distance) + " " + name +
                           " from t = " + readableTime(state.clock.time) +
                           " on, and the domain integral reaches " + readableLength(radius) +
                           ": if that body presses within this distance, its force is missing in G_J; choose "
                           "a smaller Outer Radius");
}

template void warnOfBodies(State<2>&, const CrackFront<2>&, double);
template void warnOfBodies(State<3>&, const CrackFront<3>&, double);

} // namespace Rhegma::energy_release
