#include "cracks/WayAhead.hpp"

#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::cracks
{

namespace
{

constexpr int places = 48; ///< that are looked at along an advance

/// Which of the places x + k step (k = 1 .. places) lie within a half diagonal of a particle's centre. \param
/// of a body; -1: any
std::uint64_t filledPlaces(const State<2>& state, const Vector<2>& x, const Vector<2>& step, int of = -1)
{
  const auto body = state.particles.integer(fields::body);
  const auto position = state.particles.real<2>(fields::position);
  const auto edge = state.particles.real<2>(fields::edge);
  const auto F = state.particles.real<gradientSize<2>>(fields::deformation);
  const double length = norm(step);
  std::uint64_t filled = 0;
  Kokkos::parallel_reduce(
      "rhegma::cracks::filledPlaces", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, std::uint64_t& bits) {
        if (of >= 0 && body(p) != of)
          return;
        // Half the diagonal of the deformed particle and a little more. (Edges are along the body's axes.)
        const double stretch =
            std::fmax(F(p, 0) * F(p, 0) + F(p, 2) * F(p, 2), 1.0) * edge(p, 0) * edge(p, 0) +
            std::fmax(F(p, 1) * F(p, 1) + F(p, 3) * F(p, 3), 1.0) * edge(p, 1) * edge(p, 1);
        const double reach = 0.55 * std::sqrt(stretch);
        const Vector<2> from{{position(p, 0) - x[0], position(p, 1) - x[1]}};
        const double along = dot(from, step) / length;
        const double aside = dot(from, from) - along * along;
        if (aside > reach * reach || along < -reach || along > places * length + reach)
          return;
        const double half = std::sqrt(reach * reach - aside);
        for (int k = 1; k <= places; ++k)
          if (std::fabs(k * length - along) <= half)
            bits |= std::uint64_t(1) << k;
      },
      Kokkos::BOr<std::uint64_t>(filled));
  if (!state.mesh.subdomain)
    return filled;
  double found[places + 1];
  for (int k = 0; k <= places; ++k)
    found[k] = (filled >> k & 1) != 0 ? 1.0 : 0.0;
  maxParts(state, found, places + 1);
  for (int k = 0; k <= places; ++k)
    filled |= found[k] > 0.0 ? std::uint64_t(1) << k : 0;
  return filled;
}

/// Whether two of these places are filled by particles of one body. Collective.
bool ofOneBody(const State<2>& state, const Vector<2>& x, const Vector<2>& step, int one, int other)
{
  for (int b = 0; b < static_cast<int>(state.bodies.axes.extent(0)); ++b)
    if (const std::uint64_t filled = filledPlaces(state, x, step, b);
        (filled >> one & 1) != 0 && (filled >> other & 1) != 0)
      return true;
  return false;
}

/// A front that has less than this left ahead of it runs on to the surface [cells].
constexpr double leastLigament = 0.5;

/// Bodies that are further apart than this, as filledPlaces sees them, do not touch [cells].
constexpr double apart = 0.125;

/// Opening of a crack one cell behind its front [m]. It grows as the root of the distance up to the first
/// vertex behind.
double openingBehind(const Chain& chain, bool first, double cell)
{
  const int count = static_cast<int>(chain.links.size());
  double behind = 0.0, before = 0.0;
  for (int k = 1; k < count; ++k)
  {
    const Link &from = chain.links[first ? k - 1 : count - k], &to = chain.links[first ? k : count - 1 - k];
    const double length = norm(to.vertex - from.vertex), opening = norm(to.face[1] - to.face[0]);
    if (behind + length >= cell)
      return k == 1 ? opening * std::sqrt(cell / length)
                    : before + (opening - before) * (cell - behind) / length;
    behind += length;
    before = opening;
  }
  return before;
}

} // namespace

Outcome findRoom(const State<2>& state, const Chain& chain, bool first, const CrackFront<2>& front,
                 const FrontAdvance<2>& advance)
{
  const double cell = spacingAt(state, front.position);
  // What lacks for no longer than this is the opening of the crack that the cells have, right at the front or
  // where it has drawn particles of a body apart. What lacks for longer, or between two bodies, is a surface.
  const double opening = std::max(leastLigament * cell, openingBehind(chain, first, cell));
  const double enough = advance.nodes[0].length + leastLigament * cell, step = (enough + opening) / places;
  const std::uint64_t filled = filledPlaces(state, front.position, step * advance.nodes[0].direction);
  int last = 0;
  for (int i = 1; i <= places && (i - last) * step <= opening; ++i)
    if ((filled >> i & 1) != 0)
    {
      if (last > 0 && (i - last) * step > apart * cell &&
          !ofOneBody(state, front.position, step * advance.nodes[0].direction, last, i))
        break;
      last = i;
    }
  return last * step < enough ? Outcome{last * step, true} : Outcome{advance.nodes[0].length, false};
}

} // namespace Rhegma::cracks
