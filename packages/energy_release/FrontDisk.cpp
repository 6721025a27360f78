#include "energy_release/FrontDisk.hpp"

#include "material/MaterialTable.hpp"
#include "material/ThermoLaw.hpp"
#include "state/Subdomain.hpp"
#include "transfer/NearestMaterial.hpp"

namespace Rhegma::energy_release
{

namespace
{

constexpr int D = 2;

/// Mean positions of the particles in a disk, now and before deformation.
void addMeanPositions(const State<D>& state, const Disk& disk, const BlocksInReach<D>& blocks,
                      FrontDisk& means)
{
  const auto position = state.particles.real<D>(fields::position);
  const auto reference = state.particles.real<D>(fields::reference);
  double sums[5]; // of positions, of positions before deformation, number
  blocks.sumOverParticles(
      "rhegma::meanPosition",
      KOKKOS_LAMBDA(const int p, double(&sum)[5]) {
        if (!disk.holds({position(p, 0), position(p, 1)}))
          return;
        sum[0] += position(p, 0);
        sum[1] += position(p, 1);
        sum[2] += reference(p, 0);
        sum[3] += reference(p, 1);
        sum[4] += 1.0;
      },
      sums);
  sumParts(state, sums, 5);
  const double count = sums[4];
  if (count == 0.0)
    return;
  means.position = {{sums[0] / count, sums[1] / count}};
  means.reference = {{sums[2] / count, sums[3] / count}};
}

} // namespace

Properties lawAtFront(const State<D>& state, const CrackFront<D>& front)
{
  const int number = materialAt(state, front.position);
  Properties law = state.materials.properties[number];
  if (state.materials.thermo.empty() || !(front.nodes[0].temperature > 0.0))
    return law;
  const ThermoTables tables = state.materials.thermo;
  const double temperature = front.nodes[0].temperature;
  double moduli[4] = {}; // from the device
  Kokkos::parallel_reduce(
      "rhegma::lawAtFront", Kokkos::RangePolicy<ExecSpace>(0, 1),
      KOKKOS_LAMBDA(const int, double& mu, double& bulk, double& lambda, double& planeLambda) {
        const Properties now = ThermoPoint(tables, number, temperature).properties();
        mu += now.mu;
        bulk += now.bulk;
        lambda += now.lambda;
        planeLambda += now.planeLambda;
      },
      moduli[0], moduli[1], moduli[2], moduli[3]);
  law.mu = moduli[0];
  law.bulk = moduli[1];
  law.lambda = moduli[2];
  law.planeLambda = moduli[3];
  return law;
}

namespace
{

/// FrontDisk::misfit: E e^2 / 2 for a thermal strain e, from the stress E e across the plane.
double misfitEnergy(const State<D>& state, const CrackFront<D>& front, const Elasticity& e)
{
  const double temperature = front.nodes[0].temperature;
  if (state.method.plane == Plane::Stress || state.materials.thermo.empty() || !(temperature > 0.0))
    return 0.0;
  const int number = materialAt(state, front.position);
  const ThermoTables tables = state.materials.thermo;
  double strain = 0.0; // from the device
  Kokkos::parallel_reduce(
      "rhegma::misfitAtFront", Kokkos::RangePolicy<ExecSpace>(0, 1),
      KOKKOS_LAMBDA(const int, double& sum) {
        if (tables.material(number).coupled)
          sum += ThermoPoint(tables, number, temperature).stretch() - 1.0;
      },
      strain);
  return 0.5 * e.young * strain * strain;
}

} // namespace

FrontDisk describeDisk(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                       const BlocksInReach<2>& blocks)
{
  const auto position = state.particles.real<D>(fields::position);
  const auto velocity = state.particles.real<D>(fields::velocity);
  const auto F = state.particles.real<gradientSize<D>>(fields::deformation);
  const Disk disk{front.position, radii.outer};
  double sums[5]; // of the gradient's trace and skew part, of velocity, number
  blocks.sumOverParticles(
      "rhegma::meanMotion",
      KOKKOS_LAMBDA(const int p, double(&sum)[5]) {
        if (!disk.holds({position(p, 0), position(p, 1)}))
          return;
        sum[0] += F(p, 0) + F(p, 3);
        sum[1] += F(p, 2) - F(p, 1);
        sum[2] += velocity(p, 0);
        sum[3] += velocity(p, 1);
        sum[4] += 1.0;
      },
      sums);
  sumParts(state, sums, 5);
  FrontDisk means;
  const double along = sums[0], across = sums[1], count = sums[4];
  means.empty = !(count > 0.0);
  if (!means.empty)
  {
    const double size = std::sqrt(along * along + across * across);
    means.cosine = along / size;
    means.sine = across / size;
    means.velocity = {{sums[2] / count, sums[3] / count}};
  }
  addMeanPositions(state, disk, blocks, means);
  const Elasticity e = elasticity(lawAtFront(state, front));
  means.moduli.shear = e.shear;
  means.moduli.kolosov =
      state.method.plane == Plane::Stress ? (3.0 - e.poisson) / (1.0 + e.poisson) : 3.0 - 4.0 * e.poisson;
  means.effectiveModulus = e.effectiveModulus;
  means.misfit = misfitEnergy(state, front, e);
  means.traceFactor = state.method.plane == Plane::Stress ? 1.0 : 1.0 + e.poisson;
  return means;
}

} // namespace Rhegma::energy_release
