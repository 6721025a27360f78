#include "material/SharedLibrary.hpp"

#include "material/SharedLawBlock.hpp"
#include "material/StepOfShape.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

/// Position in a gradient of nine numbers of component k of one in the layout of D dimensions.
template <int D>
constexpr int solidGradient(int k)
{
  constexpr int ofPlane[5] = {0, 1, 3, 4, 8};
  return D == 2 ? ofPlane[k] : k;
}

/// The same for a symmetric tensor, of which the block has xx yy zz xy yz xz.
template <int D>
constexpr int solidShape(int k)
{
  constexpr int ofPlane[4] = {0, 1, 3, 2};
  return D == 2 ? ofPlane[k] : k;
}

/// An upper bound of the speed of waves: the modulus at small strain, which acts on the present density, and
/// the stress; or what the law computes.
double speedOf(const SharedLawBlock& b, const Properties& m, int l)
{
  const int n = b.count;
  double F[9], square = 0.0;
  for (int k = 0; k < 9; ++k)
    F[k] = b.F[k * n + l];
  for (int k = 0; k < 6; ++k)
    square += (k < 3 ? 1.0 : 2.0) * b.tau[k * n + l] * b.tau[k * n + l];
  const double J = std::max(1.0, determinantOf(F));
  const double given = b.speed[l] > 0.0 ? b.speed[l] : SharedLibrary::startSpeed(m);
  return std::sqrt(J * given * given + std::sqrt(square) / m.density);
}

} // namespace

template <int D>
void fillSharedLaw(const SharedLawBlock& b, const LoadedLaw& law, int l, const double* before,
                   const double* F, const double* history)
{
  const int n = b.count;
  for (int k = 0; k < gradientSize<D>; ++k)
  {
    b.before[solidGradient<D>(k) * n + l] = before[k];
    b.F[solidGradient<D>(k) * n + l] = F[k];
  }
  for (int k = 0; k < 6; ++k)
    b.oldStress[k * n + l] = history[SharedLawHistory::stress + k];
  b.oldStored[l] = history[SharedLawHistory::stored];
  b.oldDissipated[l] = history[SharedLawHistory::dissipated];
  for (int k = 0; k < law.numbers; ++k)
    b.oldState[k * n + l] = history[SharedLawHistory::numbers + k];
}

template <int D>
double keepSharedLaw(const SharedLawBlock& b, const LoadedLaw& law, const Properties& m, int l, double* F,
                     double* tau, double* history)
{
  const int n = b.count;
  if (D == 2)
    F[4] = b.F[8 * n + l];
  for (int k = 0; k < symmetricSize<D>; ++k)
    tau[k] = b.tau[solidShape<D>(k) * n + l];
  for (int k = 0; k < 6; ++k)
    history[SharedLawHistory::stress + k] = b.stress[k * n + l];
  history[SharedLawHistory::stored] = b.stored[l];
  history[SharedLawHistory::dissipated] = b.dissipated[l];
  for (int k = 0; k < law.numbers; ++k)
    history[SharedLawHistory::numbers + k] = b.state[k * n + l];
  return history[SharedLawHistory::speed] = speedOf(b, m, l);
}

template <int D>
bool stressOfSharedLaw(const LawStep& step, const Properties& m, double* F, double* tau, double* history)
{
  if (!(determinant<D>(F) > 0.0))
    return noStress<D>(tau);
  const LoadedLaw& law = loadedLaw(static_cast<int>(m.own[SharedLawNumber::law]));
  SharedLawBlock b = SharedLawMemory::own().block(law, 1);
  b.dt = step.dt;
  b.time = m.own[SharedLawNumber::time];
  b.temperature = step.temperature;
  b.density = m.density;
  b.length = m.cellSize;
  b.plane = D == 2;
  fillSharedLaw<D>(b, law, 0, step.before, F, history);
  if (step.dt > 0.0)
    evaluateSharedLaw(law, m, b);
  else
    restOfSharedLaw(law, b);
  if (b.failed[0])
    return noStress<D>(tau);
  keepSharedLaw<D>(b, law, m, 0, F, tau, history);
  return true;
}

template void fillSharedLaw<2>(const SharedLawBlock&, const LoadedLaw&, int, const double*, const double*,
                               const double*);
template void fillSharedLaw<3>(const SharedLawBlock&, const LoadedLaw&, int, const double*, const double*,
                               const double*);
template double keepSharedLaw<2>(const SharedLawBlock&, const LoadedLaw&, const Properties&, int, double*,
                                 double*, double*);
template double keepSharedLaw<3>(const SharedLawBlock&, const LoadedLaw&, const Properties&, int, double*,
                                 double*, double*);
template bool stressOfSharedLaw<2>(const LawStep&, const Properties&, double*, double*, double*);
template bool stressOfSharedLaw<3>(const LawStep&, const Properties&, double*, double*, double*);

} // namespace Rhegma
