#include "contact/SideEnergy.hpp"

#include "material/Materials.hpp"

#include <cmath>

namespace Rhegma::contact
{

namespace
{

/// A place seen from a polyline that is continued straight on.
struct Foot
{
  double along; ///< length of crack up to the nearest place on it [m]
  bool above;
  double direction[2]; ///< unit vector along the crack there
};

KOKKOS_INLINE_FUNCTION Foot footOf(const View<double* [2]>& vertex, double x, double y)
{
  Foot foot{0.0, false, {0.0, 0.0}};
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
      foot.direction[0] = tx / length;
      foot.direction[1] = ty / length;
    }
    passed += length;
  }
  return foot;
}

/// Kinetic and strain energy of a particle [J].
struct ParticleEnergy
{
  BorrowedView<double* [2]> velocity;
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [gradientSize<2>]> F;
  BorrowedView<int*> material;
  BorrowedView<double**> history;
  View<Properties*> materials;

  explicit ParticleEnergy(const State<2>& state)
      : velocity(state.particles.real<2>(fields::velocity)),
        mass(state.particles.scalar(fields::mass)),
        volume(state.particles.scalar(fields::volume)),
        F(state.particles.real<gradientSize<2>>(fields::deformation)),
        material(state.particles.integer(fields::material)),
        materials(state.materials)
  {
    if (state.particles.has(fields::history))
      history = state.particles.table(fields::history);
  }

  KOKKOS_INLINE_FUNCTION double operator()(int p) const
  {
    const double* memory = history.extent(1) > 0 ? &history(p, 0) : nullptr;
    const double square = velocity(p, 0) * velocity(p, 0) + velocity(p, 1) * velocity(p, 1);
    return 0.5 * mass(p) * square + volume(p) * storedEnergy<2>(materials(material(p)), &F(p, 0), memory);
  }
};

} // namespace

WatchedCrack watch(const CrackSet<2>& cracks, int crack, double part)
{
  WatchedCrack watched;
  watched.part = part;
  const Crack<2>& c = cracks.cracks[crack];
  watched.vertex = View<double* [2]>("rhegma::watchedVertex", c.numVertices);
  const auto all = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.vertex);
  const auto vertex = Kokkos::create_mirror_view(watched.vertex);
  for (int k = 0; k < c.numVertices; ++k)
  {
    for (int d = 0; d < 2; ++d)
      vertex(k, d) = all(c.firstVertex + k, d);
    if (k > 0)
      watched.length += std::hypot(vertex(k, 0) - vertex(k - 1, 0), vertex(k, 1) - vertex(k - 1, 1));
  }
  Kokkos::deep_copy(watched.vertex, vertex);
  return watched;
}

SideEnergy measureSides(const State<2>& state, const WatchedCrack& crack)
{
  const auto reference = state.particles.real<2>(fields::reference);
  const ParticleEnergy energy(state);
  const View<double* [2]> vertex = crack.vertex;
  const double middle = 0.5 * crack.length;
  const double reach = crack.part < 1.0 ? crack.part * middle : 1e300;
  SideEnergy sum;
  Kokkos::parallel_reduce(
      "rhegma::contact::measureSides", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& below, double& above, double& alongBelow, double& alongAbove) {
        const Foot foot = footOf(vertex, reference(p, 0), reference(p, 1));
        if (std::fabs(foot.along - middle) > reach)
          return;
        const double v =
            energy.velocity(p, 0) * foot.direction[0] + energy.velocity(p, 1) * foot.direction[1];
        (foot.above ? above : below) += energy(p);
        (foot.above ? alongAbove : alongBelow) += 0.5 * energy.mass(p) * v * v;
      },
      sum.below, sum.above, sum.alongBelow, sum.alongAbove);
  return sum;
}

double totalEnergy(const State<2>& state)
{
  const ParticleEnergy energy(state);
  double total = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::contact::totalEnergy", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum) { sum += energy(p); }, total);
  return total;
}

} // namespace Rhegma::contact
