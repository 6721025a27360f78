#include "cracks/AvailableLength.hpp"

#include "state/BodyGroup.hpp"
#include "state/Subdomain.hpp"
#include "transfer/BlocksInReach.hpp"

#include <cmath>
#include <cstdint>

namespace Rhegma::cracks
{

namespace
{

constexpr int points = 48; ///< that are checked along a path

/// Bodies do not touch if their filled points are further apart than this [cells].
constexpr double apart = 0.125;

/// The box round all paths.
template <int D>
struct Box
{
  Vector<D> lower, upper;

  KOKKOS_INLINE_FUNCTION bool isNear(const Vector<D>& x, double reach) const
  {
    bool near = true;
    for (int d = 0; d < D; ++d)
      near = near && x[d] > lower[d] - reach && x[d] < upper[d] + reach;
    return near;
  }
};

/// The range along a path that is checked in one pass [m].
template <int D>
double stepOf(const Path<D>& path)
{
  return (path.length + leastLigament * path.cell + path.gap) / points;
}

template <int D>
Box<D> boxRound(const std::vector<Path<D>>& paths)
{
  Box<D> box;
  for (int d = 0; d < D; ++d)
  {
    box.lower[d] = 1e300;
    box.upper[d] = -1e300;
  }
  for (const Path<D>& path : paths)
    for (const Vector<D>& x : {path.from, path.from + (points * stepOf(path)) * path.direction})
      for (int d = 0; d < D; ++d)
      {
        box.lower[d] = std::fmin(box.lower[d], x[d]);
        box.upper[d] = std::fmax(box.upper[d], x[d]);
      }
  return box;
}

/// Half the diagonal of a particle and a tenth more. In 2D it is that of the deformed particle, if it is
/// stretched (edges are along the body's axes); bodies in 3D deform a little.
template <int D>
struct ParticleReach
{
  View<double* [D]> edge;
  View<double * [gradientSize<D>]> F;

  KOKKOS_INLINE_FUNCTION double operator()(int p) const
  {
    double square = 0.0;
    for (int d = 0; d < D; ++d)
    {
      const double stretch = D == 2 ? F(p, d) * F(p, d) + F(p, D + d) * F(p, D + d) : 1.0;
      square += std::fmax(stretch, 1.0) * edge(p, d) * edge(p, d);
    }
    return 0.55 * std::sqrt(square);
  }
};

/// The points that are filled on any rank.
template <int D>
void uniteRanks(const State<D>& state, std::vector<std::uint64_t>& bits)
{
  if (!state.mesh.subdomain)
    return;
  std::vector<double> filled;
  for (const std::uint64_t row : bits)
    for (int i = 1; i <= points; ++i)
      filled.push_back((row >> i & 1) != 0 ? 1.0 : 0.0);
  maxParts(state, filled.data(), static_cast<int>(filled.size()));
  for (std::size_t k = 0; k < bits.size(); ++k)
    for (int i = 1; i <= points; ++i)
      bits[k] |= filled[k * points + i - 1] > 0.0 ? std::uint64_t(1) << i : 0;
}

/// Which of the points k = 1 .. 48 along each path are filled by particles of a body, or of any for -1: a bit
/// each. Collective.
template <int D>
std::vector<std::uint64_t> filledPoints(const State<D>& state, int crack, const std::vector<Path<D>>& paths,
                                        int of)
{
  const int count = static_cast<int>(paths.size());
  const View<double * [2 * D + 1]> rows("rhegma::cracks::paths", count);
  const View<std::uint64_t*> filled("rhegma::cracks::filledPoints", count);
  const auto host = Kokkos::create_mirror_view(rows);
  for (int k = 0; k < count; ++k)
  {
    for (int d = 0; d < D; ++d)
    {
      host(k, d) = paths[k].from[d];
      host(k, D + d) = paths[k].direction[d];
    }
    host(k, 2 * D) = stepOf(paths[k]);
  }
  Kokkos::deep_copy(rows, host);
  const ParticlesOfGroup own = particlesOfCrack(state, crack);
  const auto body = state.particles.integer(fields::body);
  const auto position = state.particles.template real<D>(fields::position);
  const ParticleReach<D> reachOf{state.particles.template real<D>(fields::edge),
                                 state.particles.template real<gradientSize<D>>(fields::deformation)};
  const Box<D> box = boxRound(paths);
  constexpr double reachOfParticles = 3.0; // cells; half the diagonal of a stretched one is less
  BlocksInReach<D> blocks;
  blocks.find(state, {AxisBox<D>{box.lower, box.upper}.widened(reachOfParticles * state.mesh.grid.spacing)});
  blocks.forEachParticle(
      "rhegma::cracks::filledPoints", KOKKOS_LAMBDA(const int p) {
        if ((of >= 0 && body(p) != of) || !own.hold(p))
          return;
        Vector<D> x;
        for (int d = 0; d < D; ++d)
          x[d] = position(p, d);
        const double reach = reachOf(p);
        if (!box.isNear(x, reach))
          return;
        for (int k = 0; k < count; ++k)
        {
          Vector<D> from, direction;
          for (int d = 0; d < D; ++d)
          {
            from[d] = x[d] - rows(k, d);
            direction[d] = rows(k, D + d);
          }
          const double step = rows(k, 2 * D), along = dot(from, direction);
          const double aside = dot(from, from) - along * along;
          if (aside > reach * reach || along < -reach || along > points * step + reach)
            continue;
          const double half = std::sqrt(reach * reach - aside);
          std::uint64_t bits = 0;
          for (int i = 1; i <= points; ++i)
            if (std::fabs(i * step - along) <= half)
              bits |= std::uint64_t(1) << i;
          if ((bits & ~filled(k)) != 0)
            Kokkos::atomic_fetch_or(&filled(k), bits);
        }
      });
  const auto found = onHost(filled);
  std::vector<std::uint64_t> bits(found.data(), found.data() + count);
  uniteRanks(state, bits);
  return bits;
}

/// Whether two points of a path are filled by particles of one body. Collective.
template <int D>
bool isOneBody(const State<D>& state, int crack, const Path<D>& path, int one, int other)
{
  for (int b = 0; b < static_cast<int>(state.bodies.axes.extent(0)); ++b)
    if (const std::uint64_t filled = filledPoints<D>(state, crack, {path}, b)[0];
        (filled >> one & 1) != 0 && (filled >> other & 1) != 0)
      return true;
  return false;
}

} // namespace

template <int D>
std::vector<Ligament> ligamentsAhead(const State<D>& state, int crack, const std::vector<Path<D>>& paths)
{
  std::vector<Ligament> ligaments;
  if (paths.empty())
    return ligaments;
  const std::vector<std::uint64_t> filled = filledPoints(state, crack, paths, -1);
  for (std::size_t k = 0; k < paths.size(); ++k)
  {
    const Path<D>& path = paths[k];
    const double step = stepOf(path), enough = path.length + leastLigament * path.cell;
    int last = 0;
    for (int i = 1; i <= points && (i - last == 1 || (i - last) * step <= path.gap); ++i)
      if ((filled[k] >> i & 1) != 0)
      {
        if (last > 0 && i - last > 1 && (i - last) * step > apart * path.cell &&
            !isOneBody(state, crack, path, last, i))
          break;
        last = i;
      }
    const bool ends = last * step < enough * (1.0 - 1e-9);
    ligaments.push_back({ends ? last * step : path.length, ends});
  }
  return ligaments;
}

template std::vector<Ligament> ligamentsAhead(const State<2>&, int, const std::vector<Path<2>>&);
template std::vector<Ligament> ligamentsAhead(const State<3>&, int, const std::vector<Path<3>>&);

} // namespace Rhegma::cracks
