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
void addMeanPositions(const State<D>& state, const Vector<D>& centre, double reach, FrontDisk& disk)
{
  const auto position = state.particles.real<D>(fields::position);
  const auto reference = state.particles.real<D>(fields::reference);
  double sums[5] = {}; // of positions, of positions before deformation, number
  Kokkos::parallel_reduce(
      "rhegma::meanPosition", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sumX, double& sumY, double& sumFromX, double& sumFromY,
                    double& number) {
        if (distance(position, p, centre) > reach)
          return;
        sumX += position(p, 0);
        sumY += position(p, 1);
        sumFromX += reference(p, 0);
        sumFromY += reference(p, 1);
        number += 1.0;
      },
      sums[0], sums[1], sums[2], sums[3], sums[4]);
  sumParts(state, sums, 5);
  const double count = sums[4];
  if (count == 0.0)
    return;
  disk.position = {{sums[0] / count, sums[1] / count}};
  disk.reference = {{sums[2] / count, sums[3] / count}};
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

FrontDisk describeDisk(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii)
{
  const auto position = state.particles.real<D>(fields::position);
  const auto velocity = state.particles.real<D>(fields::velocity);
  const auto F = state.particles.real<gradientSize<D>>(fields::deformation);
  const Vector<D> centre = front.position;
  const double reach = radii.outer;
  double sums[5] = {}; // of the gradient's trace and skew part, of velocity, number
  Kokkos::parallel_reduce(
      "rhegma::meanMotion", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& trace, double& skew, double& x, double& y, double& number) {
        if (distance(position, p, centre) > reach)
          return;
        trace += F(p, 0) + F(p, 3);
        skew += F(p, 2) - F(p, 1);
        x += velocity(p, 0);
        y += velocity(p, 1);
        number += 1.0;
      },
      sums[0], sums[1], sums[2], sums[3], sums[4]);
  sumParts(state, sums, 5);
  FrontDisk disk;
  const double along = sums[0], across = sums[1], count = sums[4];
  disk.empty = !(count > 0.0);
  if (!disk.empty)
  {
    const double size = std::sqrt(along * along + across * across);
    disk.cosine = along / size;
    disk.sine = across / size;
    disk.velocity = {{sums[2] / count, sums[3] / count}};
  }
  addMeanPositions(state, centre, reach, disk);
  const Elasticity e = elasticity(lawAtFront(state, front));
  disk.moduli.shear = e.shear;
  disk.moduli.kolosov =
      state.method.plane == Plane::Stress ? (3.0 - e.poisson) / (1.0 + e.poisson) : 3.0 - 4.0 * e.poisson;
  disk.effectiveModulus = e.effectiveModulus;
  disk.traceFactor = state.method.plane == Plane::Stress ? 1.0 : 1.0 + e.poisson;
  return disk;
}

} // namespace Rhegma::energy_release
