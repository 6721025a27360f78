#include "transfer/StressInBlocks.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "material/Materials.hpp"
#include "material/SharedLawBlock.hpp"
#include "state/CellFrame.hpp"

#include <algorithm>
#include <limits>
#include <mutex>

namespace Rhegma
{

namespace
{

/// Particles of a call. The arrays of a block, some 120 numbers a particle and its state, stay in a cache of
/// 256 KiB.
constexpr int blockSize = 128;

/// The first particle at which a law failed, and what the law said.
struct Failure
{
  std::mutex mutex;
  int particle = std::numeric_limits<int>::max();
  std::string reason;

  void report(int p, const std::string& why)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (p >= particle)
      return;
    particle = p;
    reason = why;
  }
};

/// The particles [blockSize * i, blockSize * (i + 1)), by material.
template <int D>
struct BlocksOfParticles
{
  View<double * [gradientSize<D>]> before;
  View<Properties*> materials;
  BorrowedView<int*> material;
  BorrowedView<double*[D]> position, velocity;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<double * [symmetricSize<D>]> stress;
  BorrowedView<double**> history;
  double duration;
  bool undeformed, placed;
  int size, numMaterials;
  Failure* failure;

  void operator()(int i, double& fastest) const
  {
    const int first = i * blockSize, end = std::min(size, first + blockSize);
    int list[blockSize];
    for (int kind = 0; kind < numMaterials; ++kind)
    {
      if (!isInBlocks(materials(kind)))
        continue;
      int count = 0;
      for (int p = first; p < end; ++p)
        if (material(p) == kind)
          list[count++] = p;
      if (count > 0)
        run(materials(kind), list, count, fastest);
    }
  }

private:
  void run(const Properties& m, const int* list, int count, double& fastest) const
  {
    const LoadedLaw& law = loadedLaw(static_cast<int>(m.own[SharedLawNumber::law]));
    SharedLawBlock b = SharedLawMemory::own().block(law, count);
    b.dt = duration;
    b.time = m.own[SharedLawNumber::time];
    b.temperature = m.temperature;
    b.density = m.density;
    b.length = m.cellSize;
    b.plane = D == 2;
    for (int l = 0; l < count; ++l)
    {
      const int p = list[l];
      for (int d = 0; d < D && placed; ++d)
        b.position[d * count + l] = position(p, d);
      fillSharedLaw<D>(b, law, l, &before(p, 0), &deformation(p, 0), &history(p, 0));
    }
    if (duration > 0.0)
      evaluateSharedLaw(law, m, b);
    else
      restOfSharedLaw(law, b);
    for (int l = 0; l < count; ++l)
      if (b.failed[l])
        failure->report(list[l], b.reason);
      else
        fastest = std::max(fastest, keep(b, law, m, l, list[l]));
  }

  /// \return speed of waves and of the particle, as the step needs it
  double keep(const SharedLawBlock& b, const LoadedLaw& law, const Properties& m, int l, int p) const
  {
    double* const F = &deformation(p, 0);
    const double wave = keepSharedLaw<D>(b, law, m, l, F, &stress(p, 0), &history(p, 0));
    if (undeformed)
      return wave * slowestStretch<D>(F);
    double square = 0.0;
    for (int d = 0; d < D; ++d)
      square += velocity(p, d) * velocity(p, d);
    return wave + std::sqrt(square);
  }
};

/// "Materials > Steel: the law returned ... at (x, y, z) m at the time t".
template <int D>
std::string messageOf(const State<D>& state, const Failure& failure)
{
  const auto x = state.particles.template real<D>(fields::position);
  const int p = failure.particle;
  std::string place;
  for (int d = 0; d < D; ++d)
    place += (d == 0 ? "" : ", ") + formatShort(x(p, d));
  const std::string name = state.materials.names[state.particles.integer(fields::material)(p)];
  return "Materials > " + name + " > Behaviour: the law " +
         (failure.reason.empty() ? "returned a stress, an energy or a state that is not finite"
                                 : "failed (" + failure.reason + ")") +
         " for the particle at (" + place + ") m, at the time " +
         formatShort(state.clock.time + state.clock.dt) +
         " s; look at the law for the strain and the rate of that particle";
}

} // namespace

template <int D>
bool hasLawInBlocks(const State<D>& state)
{
  return std::any_of(state.materials.properties.begin(), state.materials.properties.end(),
                     [](const Properties& m) { return isInBlocks(m); });
}

template <int D>
View<double* [gradientSize<D>]> deformationBefore(const State<D>& state)
{
  if (!hasLawInBlocks(state))
    return {};
  const auto now = state.particles.template real<gradientSize<D>>(fields::deformation);
  const View<double * [gradientSize<D>]> before(
      Kokkos::view_alloc(Kokkos::WithoutInitializing, "rhegma::deformationBefore"), state.particles.size());
  Kokkos::deep_copy(before, now);
  return before;
}

template <int D>
double stressInBlocks(State<D>& state, const View<double * [gradientSize<D>]>& before, double duration)
{
  double fastest = 0.0;
  if constexpr (callsSharedLaws)
  {
    setTimeOfLaws(state);
    Failure failure;
    BlocksOfParticles<D> blocks;
    blocks.before = before;
    blocks.materials = state.materials.device;
    blocks.material = state.particles.integer(fields::material);
    blocks.position = state.particles.template real<D>(fields::position);
    blocks.velocity = state.particles.template real<D>(fields::velocity);
    blocks.deformation = state.particles.template real<gradientSize<D>>(fields::deformation);
    blocks.stress = state.particles.template real<symmetricSize<D>>(fields::stress);
    blocks.history = state.particles.table(fields::history);
    blocks.duration = duration;
    blocks.undeformed = CellFrame<D>(state).undeformed;
    blocks.placed = !state.method.equilibrium(); // trials of equilibrium do not know it
    blocks.size = state.particles.size();
    blocks.numMaterials = static_cast<int>(state.materials.properties.size());
    blocks.failure = &failure;
    Kokkos::parallel_reduce("rhegma::stressInBlocks",
                            Kokkos::RangePolicy<ExecSpace>(0, (blocks.size + blockSize - 1) / blockSize),
                            blocks, Kokkos::Max<double>(fastest));
    if (failure.particle < blocks.size && state.failure.empty())
      state.failure = messageOf(state, failure);
  }
  return fastest;
}

template <int D>
void setTimeOfLaws(State<D>& state)
{
  const double time =
      state.clock.time +
      state.clock.dt * (state.clock.strainPass.before ? state.clock.strainPass.fraction : 1.0);
  if constexpr (callsSharedLaws)
    for (std::size_t k = 0; k < state.materials.properties.size(); ++k)
      if (isInBlocks(state.materials.properties[k]))
        state.materials.device(k).own[SharedLawNumber::time] = time;
}

template bool hasLawInBlocks(const State<2>&);
template bool hasLawInBlocks(const State<3>&);
template View<double * [gradientSize<2>]> deformationBefore<2>(const State<2>&);
template View<double * [gradientSize<3>]> deformationBefore<3>(const State<3>&);
template double stressInBlocks(State<2>&, const View<double * [gradientSize<2>]>&, double);
template double stressInBlocks(State<3>&, const View<double * [gradientSize<3>]>&, double);
template void setTimeOfLaws(State<2>&);
template void setTimeOfLaws(State<3>&);

} // namespace Rhegma
