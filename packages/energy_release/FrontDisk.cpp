#include "energy_release/FrontDisk.hpp"

#include "material/LawStiffness.hpp"
#include "material/ThermoLaw.hpp"
#include "state/CellFrame.hpp"
#include "state/ParticlePlace.hpp"
#include "state/Subdomain.hpp"
#include "transfer/NearestMaterial.hpp"

namespace Rhegma::energy_release
{

namespace
{

constexpr int D = 2;

/// Adds those of a particle in the disk: the gradient's trace and skew part, velocity, number, and where they
/// are wanted its positions now and before deformation.
struct AddMotion
{
  Disk disk;
  ParticlePlace<D> place;
  BorrowedView<double* [D]> velocity;
  BorrowedView<double * [gradientSize<D>]> F;

  static constexpr int motions = 5, positions = 4;

  template <int N>
  KOKKOS_INLINE_FUNCTION void operator()(int p, double (&sum)[N]) const
  {
    if (!disk.holds({place.position(p, 0), place.position(p, 1)}))
      return;
    sum[0] += F(p, 0) + F(p, 3);
    sum[1] += F(p, 2) - F(p, 1);
    sum[2] += velocity(p, 0);
    sum[3] += velocity(p, 1);
    sum[4] += 1.0;
    if constexpr (N > motions)
      for (int d = 0; d < D; ++d)
      {
        sum[motions + d] += place.now(p, d);
        sum[motions + D + d] += place.reference(p, d);
      }
  }
};

/// The means over a disk. \tparam N how many numbers AddMotion adds
template <int N>
FrontDisk meansOver(const State<D>& state, const AddMotion& add, const BlocksInReach<D>& blocks)
{
  double sums[N];
  blocks.sumOverParticles("rhegma::meanMotion", add, sums);
  sumParts(state, sums, N);
  FrontDisk means;
  const double along = sums[0], across = sums[1], count = sums[4];
  means.empty = !(count > 0.0);
  if (means.empty)
    return means;
  const double size = std::sqrt(along * along + across * across);
  means.cosine = along / size;
  means.sine = across / size;
  means.velocity = {{sums[2] / count, sums[3] / count}};
  if constexpr (N > AddMotion::motions)
  {
    const double* at = sums + AddMotion::motions;
    means.position = {{at[0] / count, at[1] / count}};
    means.reference = {{at[D] / count, at[D + 1] / count}};
  }
  return means;
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

CrackCompliance complianceAtFront(const State<D>& state, const CrackFront<D>& front)
{
  return crackCompliance(planeStiffness(lawAtFront(state, front)), front.direction, front.normal);
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
                       bool positions, const BlocksInReach<2>& blocks)
{
  const AddMotion add{{front.position, radii.outer},
                      ParticlePlace<D>(state.particles),
                      state.particles.real<D>(fields::velocity),
                      state.particles.real<gradientSize<D>>(fields::deformation)};
  FrontDisk means = positions ? meansOver<AddMotion::motions + AddMotion::positions>(state, add, blocks)
                              : meansOver<AddMotion::motions>(state, add, blocks);
  const Properties law = lawAtFront(state, front);
  const Elasticity e = elasticity(law);
  // The material's axes turn with the body, and the front with them unless the cells are undeformed.
  const auto before = [&](const Vector<2>& v)
  {
    const bool still = means.empty || CellFrame<D>(state).undeformed;
    return still ? v
                 : Vector<2>{
                       {means.cosine * v[0] + means.sine * v[1], means.cosine * v[1] - means.sine * v[0]}};
  };
  means.compliance = crackCompliance(planeStiffness(law), before(front.direction), before(front.normal));
  means.misfit = misfitEnergy(state, front, e);
  means.traceFactor = state.method.plane == Plane::Stress ? 1.0 : 1.0 + e.poisson;
  return means;
}

} // namespace Rhegma::energy_release
