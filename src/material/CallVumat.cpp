#include "material/SharedLawBlock.hpp"
#include "material/StepOfShape.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace Rhegma
{

namespace
{

/// The arguments of the subroutine VUMAT of Abaqus/Explicit, as its manual documents them; the last one is
/// the length of the name, which compilers of Fortran pass behind the others.
using Vumat = void (*)(const int* nblock, const int* ndir, const int* nshr, const int* nstatev,
                       const int* nfieldv, const int* nprops, const int* lanneal, const double* stepTime,
                       const double* totalTime, const double* dt, const char* cmname, const double* coordMp,
                       const double* charLength, const double* props, const double* density,
                       const double* strainInc, const double* relSpinInc, const double* tempOld,
                       const double* stretchOld, const double* defgradOld, const double* fieldOld,
                       const double* stressOld, const double* stateOld, const double* enerInternOld,
                       const double* enerInelasOld, const double* tempNew, const double* stretchNew,
                       const double* defgradNew, const double* fieldNew, double* stressNew, double* stateNew,
                       double* enerInternNew, double* enerInelasNew, std::size_t lengthOfName);

/// The NaN that marks an energy which the law has not set. It has other digits than those that come of
/// computing.
constexpr std::uint64_t unsetBits = 0x7ff80000deadbeefULL;

double unset()
{
  double value;
  std::memcpy(&value, &unsetBits, sizeof value);
  return value;
}

bool isUnset(double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits == unsetBits;
}

/// 11 22 33 12 23 31 21 32 13 of a gradient in rows.
constexpr int vumatGradient[9] = {0, 4, 8, 1, 5, 6, 3, 7, 2};

/// Arrays of one number a particle and of several that only a VUMAT needs.
struct VumatArrays
{
  double *length, *density, *temperature, *internOld, *internNew, *inelasOld, *inelasNew, *volume;
  double *strain, *spin, *gradientOld, *gradientNew;

  VumatArrays(int n, SharedLawMemory& memory)
  {
    double* next = memory.scratch(static_cast<std::size_t>(n) * (8 + 6 + 3 + 9 + 9));
    const auto take = [&](int components)
    {
      double* const from = next;
      next += static_cast<std::ptrdiff_t>(components) * n;
      return from;
    };
    for (double** one :
         {&length, &density, &temperature, &internOld, &internNew, &inelasOld, &inelasNew, &volume})
      *one = take(1);
    strain = take(6);
    spin = take(3);
    gradientOld = take(9);
    gradientNew = take(9);
  }
};

/// Strain increment D dt and relative spin (W - Omega) dt in the frame of R, where R^T L R = Omega +
/// dU/dt U^-1: the symmetric and the skew part of (U1 - U0) ((U0 + U1) / 2)^-1. Rotations do not enter.
void strainAndSpin(const SharedLawBlock& b, const VumatArrays& a)
{
  const int n = b.count;
  for (int l = 0; l < n; ++l)
  {
    double change[6], middle[6], G[9];
    for (int k = 0; k < 6; ++k)
    {
      change[k] = b.stretch[k * n + l] - b.oldStretch[k * n + l];
      middle[k] = 0.5 * (b.stretch[k * n + l] + b.oldStretch[k * n + l]);
    }
    stepOfShape(change, middle, G);
    constexpr int row[6] = {0, 1, 2, 0, 1, 0}, column[6] = {0, 1, 2, 1, 2, 2};
    for (int k = 0; k < 6; ++k)
      a.strain[k * n + l] = 0.5 * (G[3 * row[k] + column[k]] + G[3 * column[k] + row[k]]);
    a.spin[l] = 0.5 * (G[7] - G[5]);
    a.spin[n + l] = 0.5 * (G[2] - G[6]);
    a.spin[2 * n + l] = 0.5 * (G[3] - G[1]);
  }
}

void fill(const SharedLawBlock& b, const VumatArrays& a)
{
  const int n = b.count;
  const double none = unset();
  for (int k = 0; k < 9; ++k)
  {
    std::copy_n(b.before + vumatGradient[k] * n, n, a.gradientOld + k * n);
    std::copy_n(b.F + vumatGradient[k] * n, n, a.gradientNew + k * n);
  }
  std::fill_n(a.length, n, b.length);
  std::fill_n(a.temperature, n, b.temperature);
  strainAndSpin(b, a);
  for (int l = 0; l < n; ++l)
  {
    // Volume ratio in the middle of the step, between those of its ends.
    a.volume[l] = 0.5 * (shapeDeterminant(b.oldStretch, n, l) + shapeDeterminant(b.stretch, n, l));
    a.density[l] = b.density / a.volume[l];
    a.inelasOld[l] = b.oldDissipated[l] / b.density;
    a.internOld[l] = (b.oldStored[l] + b.oldDissipated[l]) / b.density;
    a.inelasNew[l] = a.inelasOld[l];
    a.internNew[l] = none;
  }
}

/// Energies per undeformed volume from those per mass. A law that leaves its internal energy out gets the
/// work of the mean stress.
void energies(const SharedLawBlock& b, const VumatArrays& a)
{
  const int n = b.count;
  for (int l = 0; l < n; ++l)
  {
    double intern = b.density * a.internNew[l];
    if (isUnset(a.internNew[l]))
    {
      intern = b.oldStored[l] + b.oldDissipated[l];
      for (int k = 0; k < 6; ++k)
        intern += (k < 3 ? 0.5 : 1.0) * a.volume[l] * (b.oldStress[k * n + l] + b.stress[k * n + l]) *
                  a.strain[k * n + l];
    }
    b.dissipated[l] = b.density * a.inelasNew[l];
    b.stored[l] = intern - b.dissipated[l];
  }
}

/// What is behind the state variables in a trial.
void guardStates(const LoadedLaw& law, const SharedLawBlock& b)
{
  const int n = b.count;
  for (int k = 0; k < lawSlack; ++k)
  {
    std::fill_n(b.oldState + (law.numbers + k) * n, n, b.guard->states[k]);
    std::fill_n(b.state + (law.numbers + k) * n, n, LawGuard::canary);
  }
}

void lookAtGuard(const LoadedLaw& law, const SharedLawBlock& b)
{
  const double* const behind = b.state + law.numbers * b.count;
  for (int k = 0; k < lawSlack; ++k)
    for (int l = 0; l < b.count; ++l)
      b.guard->look(k, !(behind[k * b.count + l] == LawGuard::canary));
}

} // namespace

void callVumat(const LoadedLaw& law, SharedLawBlock& b)
{
  const VumatArrays a(b.count, SharedLawMemory::own());
  fill(b, a);
  std::copy_n(b.oldState, static_cast<std::size_t>(law.numbers) * b.count, b.state);
  std::fill_n(b.speed, b.count, 0.0);
  if (b.guard != nullptr)
    guardStates(law, b);
  char name[81];
  std::fill_n(name, 80, ' ');
  name[80] = '\0';
  std::copy_n(law.of.behaviour.data(), std::min<std::size_t>(80, law.of.behaviour.size()), name);
  const int direct = 3, shear = 3, none = 0, constants = static_cast<int>(law.of.constants.size());
  reinterpret_cast<Vumat>(law.function)(
      &b.count, &direct, &shear, &law.states, &none, &constants, &none, &b.time, &b.time, &b.dt, name,
      b.position, a.length, b.constants, a.density, a.strain, a.spin, a.temperature, b.oldStretch,
      a.gradientOld, nullptr, b.oldStress, b.oldState, a.internOld, a.inelasOld, a.temperature, b.stretch,
      a.gradientNew, nullptr, b.stress, b.state, a.internNew, a.inelasNew, 80);
  if (b.guard != nullptr)
    lookAtGuard(law, b);
  energies(b, a);
}

} // namespace Rhegma
