#include "sub_cycling/FineParticles.hpp"

#include "sub_cycling/SlotRow.hpp"
#include "sub_cycling/TrialStress.hpp"
#include "transfer/Connectivity.hpp"

#include <algorithm>

namespace Rhegma::sub_cycling
{

namespace
{

/// Particles of a part of a sum. Each part has a sum for every slot, so small parts cost more than they share
/// among threads: small ones only where a few threads would have nothing to do.
constexpr int particlesPerPart = 2048, fewParticlesPerPart = 512;
constexpr int fewParts = 4, mostParts = 32;

/// Parts of the sum over a number of particles; the same for any number of threads.
int partsOf(int particles)
{
  const int large = (particles + particlesPerPart - 1) / particlesPerPart,
            small = (particles + fewParticlesPerPart - 1) / fewParticlesPerPart;
  return std::min(std::max(large, std::min(small, fewParts)), mostParts);
}

using Range = Kokkos::RangePolicy<ExecSpace>;

/// (1 + G)^-1.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION void inverseOfMotion(const double (&G)[D][D], double (&result)[D][D])
{
  if constexpr (D == 2)
  {
    const double scale = 1.0 / ((1.0 + G[0][0]) * (1.0 + G[1][1]) - G[0][1] * G[1][0]);
    result[0][0] = scale * (1.0 + G[1][1]);
    result[0][1] = -scale * G[0][1];
    result[1][0] = -scale * G[1][0];
    result[1][1] = scale * (1.0 + G[0][0]);
  }
  else
  {
    double F[9], inverted[9];
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        F[a * 3 + b] = G[a][b] + (a == b ? 1.0 : 0.0);
    inverse<3>(F, determinant<3>(F), inverted);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        result[a][b] = inverted[a * 3 + b];
  }
}

} // namespace

template <int D>
template <class Add>
void FineParticles<D>::sumInParts(const char* label, int begin, int end, const Add& add)
{
  const int number = partsOf(end - begin);
  if (static_cast<int>(parts_.extent(0)) < number || static_cast<int>(parts_.extent(1)) < numSlots_)
    parts_ = View<double** [D]>("rhegma::subcycling::parts", mostParts, numSlots_ + numSlots_ / 4);
  numParts_ = number;
  const View<double** [D]> parts = parts_;
  const int slots = numSlots_;
  Kokkos::parallel_for(
      label,
      Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>(0, number, Kokkos::ChunkSize(1)),
      KOKKOS_LAMBDA(const int part) {
        double* const to = &parts(part, 0, 0);
        for (int i = 0; i < slots * D; ++i)
          to[i] = 0.0;
        const int from = begin + static_cast<int>(static_cast<long>(end - begin) * part / number);
        const int until = begin + static_cast<int>(static_cast<long>(end - begin) * (part + 1) / number);
        for (int i = from; i < until; ++i)
          add(i, to);
      });
}

template <int D>
template <ShearStrain H, class Trial>
void FineParticles<D>::sumForces(const State<D>& state, int level, const Values& displacement,
                                 const Trial& trial)
{
  const View<int*> count = count_, particle = particle_;
  const View<int * [stencilCapacity<D>]> slot = slot_;
  const View<double***> slope = slope_;
  const auto volume = state.particles.scalar(fields::volume);
  const double* const displaced = displacement.data();
  constexpr bool eachComponent = H == ShearStrain::AtCellCentres;
  constexpr int slopes = ComponentSlopes<D, H>::size;
  sumInParts(
      "rhegma::subcycling::force", particlesFrom_[level + 1], particlesFrom_[level],
      KOKKOS_LAMBDA(const int i, double* sums) {
        const int p = particle(i), entries = count(i);
        const int* const at = &slot(i, 0);
        const double* const of = &slope(i, 0, 0);
        SlotRow<D> steep[D]; // column b: slopes along axis b
        for (int b = 0; b < D; ++b)
          steep[b] = SlotRow<D>::zero();
        for (int k = 0; k < entries; ++k)
        {
          const SlotRow<D> moved = SlotRow<D>::load(displaced + D * at[k]);
          forEachSlope<D, eachComponent>(of + k * slopes,
                                         [&](int b, const auto& along) { steep[b].add(along, moved); });
        }
        double gradient[D][D], tau[symmetricSize<D>], back[D][D];
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b)
            gradient[a][b] = steep[b][a];
        trial(p, gradient, tau);
        inverseOfMotion<D>(gradient, back);
        SlotRow<D> flux[D];
        for (int c = 0; c < D; ++c)
        {
          double column[D];
          for (int a = 0; a < D; ++a)
          {
            column[a] = 0.0;
            for (int b = 0; b < D; ++b)
              column[a] -= volume(p) * tau[symmetricIndex<D>(a, b)] * back[c][b];
          }
          flux[c] = SlotRow<D>::load(column);
        }
        for (int k = 0; k < entries; ++k)
        {
          double* const to = sums + D * at[k];
          SlotRow<D> sum = SlotRow<D>::load(to);
          forEachSlope<D, eachComponent>(of + k * slopes,
                                         [&](int c, const auto& along) { sum.add(along, flux[c]); });
          sum.store(to);
        }
      });
}

template <int D>
void FineParticles<D>::force(const State<D>& state, int level, const Values& displacement, double duration,
                             const Values& force)
{
  const auto sumWith = [&](const auto& trial)
  {
    if (state.method.shear == ShearStrain::AtCellCentres)
      sumForces<ShearStrain::AtCellCentres>(state, level, displacement, trial);
    else
      sumForces<ShearStrain::AtParticles>(state, level, displacement, trial);
  };
  if (state.materials.thermo.empty())
    sumWith(LawStress<D>(state, duration));
  else
    sumWith(HeatedStress<D>(state, duration));
  const View<double** [D]> parts = parts_;
  const int number = numParts_;
  Kokkos::parallel_for(
      "rhegma::subcycling::sumForces", Range(0, numSlots_), KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
        {
          double sum = 0.0;
          for (int part = 0; part < number; ++part)
            sum += parts(part, i, d);
          force(i, d) = sum;
        }
      });
}

template <int D>
void FineParticles<D>::accelerate(const State<D>& state, int level, double duration, const Values& force,
                                  const Values& velocity, bool supports)
{
  fit(acceleration_, "rhegma::subcycling::acceleration", numSlots_);
  const Values acceleration = acceleration_, before = before_, momentum = momentum_;
  const View<int*> count = count_, reach = reach_, particle = particle_;
  const View<int * [stencilCapacity<D>]> slot = slot_;
  const View<double * [stencilCapacity<D>]> weight = weight_;
  const double* const accelerated = acceleration.data();
  const View<int* [D]> held = held_;
  const View<double*> nodal = mass_;
  const View<double* [D]> heldVelocity = heldVelocity_;
  const auto mass = state.particles.scalar(fields::mass);
  const bool coupled = static_cast<bool>(state.motion.coupledSlots.solve);
  const int lowest = coupled ? 0 : level; // a coupled mass moves nodes without a force too
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::accelerate", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        const double inverse = nodal(i) > 0.0 ? 1.0 / nodal(i) : 0.0;
        for (int d = 0; d < D; ++d)
          acceleration(i, d) = held(i, d) == 0 ? inverse * force(i, d)
                               : supports      ? (heldVelocity(i, d) - before(i, d)) / duration
                                               : 0.0;
      });
  if (coupled)
    state.motion.coupledSlots.solve(force, acceleration, true);
  sumInParts(
      "rhegma::subcycling::roundTrip", 0, numListed_, KOKKOS_LAMBDA(const int i, double* to) {
        if (reach(i) < lowest)
          return;
        const int entries = count(i);
        const int* const at = &slot(i, 0);
        const double* const w = &weight(i, 0);
        SlotRow<D> own = SlotRow<D>::zero();
        for (int k = 0; k < entries; ++k)
          own.add(w[k], SlotRow<D>::load(accelerated + D * at[k]));
        const double m = mass(particle(i));
        for (int k = 0; k < entries; ++k)
        {
          SlotRow<D> sum = SlotRow<D>::load(to + D * at[k]);
          sum.add(m * w[k], own);
          sum.store(to + D * at[k]);
        }
      });
  const View<double** [D]> parts = parts_;
  const int number = numParts_;
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::sumMomentum", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
        {
          double sum = 0.0;
          for (int part = 0; part < number; ++part)
            sum += parts(part, i, d);
          momentum(i, d) = sum;
        }
      });
  sumSlots(state, momentum);
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::arrive", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        const double inverse = nodal(i) > 0.0 ? 1.0 / nodal(i) : 0.0;
        for (int d = 0; d < D; ++d)
          acceleration(i, d) = held(i, d) != 0 ? 0.0 : inverse * momentum(i, d);
      });
  if (coupled)
    state.motion.coupledSlots.solve(momentum, acceleration, true);
  parallelForSmall<smallSlots>(
      "rhegma::subcycling::kick", 0, numSlots_, KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
          velocity(i, d) += duration * acceleration(i, d);
      });
}

template void FineParticles<2>::force(const State<2>&, int, const Values&, double, const Values&);
template void FineParticles<2>::accelerate(const State<2>&, int, double, const Values&, const Values&, bool);
template void FineParticles<3>::force(const State<3>&, int, const Values&, double, const Values&);
template void FineParticles<3>::accelerate(const State<3>&, int, double, const Values&, const Values&, bool);

} // namespace Rhegma::sub_cycling
