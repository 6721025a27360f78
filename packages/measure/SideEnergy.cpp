#include "measure/SideEnergy.hpp"

#include "state/ParticleEnergy.hpp"
#include "state/Subdomain.hpp"

#include <cmath>

namespace Rhegma::measure
{

namespace
{

/// A position seen from a crack that is continued straight on.
template <int D>
struct Foot
{
  double along; ///< length of crack up to the nearest point on it; of a 2D crack [m]
  bool above;
  Vector<D> normal; ///< of the crack there
};

KOKKOS_INLINE_FUNCTION Foot<2> footOf(const View<double* [2]>& vertex, const Vector<2>&,
                                      const Vector<2>& position)
{
  const double x = position[0], y = position[1];
  Foot<2> foot{0.0, false, {0.0, 0.0}};
  double nearest = 1e300, passed = 0.0;
  const int last = static_cast<int>(vertex.extent(0)) - 1;
  for (int s = 0; s < last; ++s)
  {
    const double tx = vertex(s + 1, 0) - vertex(s, 0), ty = vertex(s + 1, 1) - vertex(s, 1);
    const double length = std::sqrt(tx * tx + ty * ty);
    const double rx = x - vertex(s, 0), ry = y - vertex(s, 1);
    const double along = (rx * tx + ry * ty) / length;
    double at = along;
    if (s > 0 && at < 0.0)
      at = 0.0;
    if (s + 1 < last && at > length)
      at = length;
    const double dx = rx - at * tx / length, dy = ry - at * ty / length;
    const double square = dx * dx + dy * dy;
    if (square < nearest)
    {
      nearest = square;
      foot.along = passed + at;
      foot.above = tx * ry - ty * rx > 0.0;
      foot.normal = {-ty / length, tx / length};
    }
    passed += length;
  }
  return foot;
}

KOKKOS_INLINE_FUNCTION Foot<3> footOf(const View<double* [3]>& vertex, const Vector<3>& normal,
                                      const Vector<3>& position)
{
  const Vector<3> from{position[0] - vertex(0, 0), position[1] - vertex(0, 1), position[2] - vertex(0, 2)};
  return {0.0, dot(from, normal) > 0.0, normal};
}

} // namespace

template <int D>
MeasuredCrack<D> measuredCrack(const CrackSet<D>& cracks, int crack, double part)
{
  MeasuredCrack<D> measured;
  const Crack<D>& c = cracks.cracks[crack];
  measured.vertex = View<double* [D]>("rhegma::measuredVertex", c.numVertices);
  const auto all = onHost(cracks.vertex);
  const auto normal = onHost(cracks.normal);
  const auto vertex = Kokkos::create_mirror_view(measured.vertex);
  for (int d = 0; d < D; ++d)
    measured.normal[d] = normal(c.firstSimplex, d);
  for (int k = 0; k < c.numVertices; ++k)
  {
    for (int d = 0; d < D; ++d)
      vertex(k, d) = all(c.firstVertex + k, d);
    if (D == 2 && k > 0)
      measured.length += std::hypot(vertex(k, 0) - vertex(k - 1, 0), vertex(k, 1) - vertex(k - 1, 1));
  }
  Kokkos::deep_copy(measured.vertex, vertex);
  measured.reach = part < 1.0 ? part * (0.5 * measured.length) : 1e300;
  return measured;
}

template <int D>
SideEnergy measureSides(const State<D>& state, const MeasuredCrack<D>& crack)
{
  const auto reference = state.particles.template real<D>(fields::reference);
  const ParticleEnergy<D> energy(state);
  const View<double* [D]> vertex = crack.vertex;
  const Vector<D> normal = crack.normal;
  const double middle = 0.5 * crack.length, reach = crack.reach;
  double sums[4] = {};
  Kokkos::parallel_reduce(
      "rhegma::measure::sides", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& below, double& above, double& alongBelow, double& alongAbove) {
        Vector<D> position, v;
        for (int d = 0; d < D; ++d)
        {
          position[d] = reference(p, d);
          v[d] = energy.mechanics ? energy.velocity(p, d) : 0.0;
        }
        const Foot<D> foot = footOf(vertex, normal, position);
        if (std::fabs(foot.along - middle) > reach)
          return;
        v = v - dot(v, foot.normal) * foot.normal;
        (foot.above ? above : below) += energy.kinetic(p) + energy.strain(p);
        (foot.above ? alongAbove : alongBelow) += 0.5 * energy.mass(p) * dot(v, v);
      },
      sums[0], sums[1], sums[2], sums[3]);
  sumParts(state, sums, 4);
  SideEnergy sum;
  sum.below = sums[0];
  sum.above = sums[1];
  sum.alongBelow = sums[2];
  sum.alongAbove = sums[3];
  return sum;
}

template MeasuredCrack<2> measuredCrack(const CrackSet<2>&, int, double);
template MeasuredCrack<3> measuredCrack(const CrackSet<3>&, int, double);
template SideEnergy measureSides(const State<2>&, const MeasuredCrack<2>&);
template SideEnergy measureSides(const State<3>&, const MeasuredCrack<3>&);

} // namespace Rhegma::measure
