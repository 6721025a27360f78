#include "material/SharedLawBlock.hpp"
#include "material/StepOfShape.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

/// The arguments of the subroutine UMAT of Abaqus/Standard, as its manual documents them; the last one is the
/// length of the name.
using Umat = void (*)(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd,
                      double* rpl, double* ddsddt, double* drplde, double* drpldt, const double* stran,
                      const double* dstran, const double* time, const double* dtime, const double* temp,
                      const double* dtemp, const double* predef, const double* dpred, const char* cmname,
                      const int* ndi, const int* nshr, const int* ntens, const int* nstatv,
                      const double* props, const int* nprops, const double* coords, const double* drot,
                      double* pnewdt, const double* celent, const double* dfgrd0, const double* dfgrd1,
                      const int* noel, const int* npt, const int* layer, const int* kspt, const int* jstep,
                      const int* kinc, std::size_t lengthOfName);

/// 11 22 33 12 13 23 of xx yy zz xy yz xz.
constexpr int umatOrder[6] = {0, 1, 2, 3, 5, 4};

/// Strain and rotation of a step: those of its middle, G = (F1 - F0) ((F0 + F1) / 2)^-1, the rotation by the
/// formula of Cayley, (1 - W/2)^-1 (1 + W/2), which is orthogonal (Hughes and Winget, Int. J. Numer. Methods
/// Eng. 15 (1980) 1862).
struct UmatStep
{
  double strain[6]; ///< symmetric part of G, xx yy zz xy yz xz
  double R[9];

  UmatStep(const double (&F0)[9], const double (&F1)[9])
  {
    double middle[9], change[9], back[9], G[9], fore[9], aft[9];
    for (int k = 0; k < 9; ++k)
    {
      middle[k] = 0.5 * (F0[k] + F1[k]);
      change[k] = F1[k] - F0[k];
    }
    inverseOf(middle, back);
    product(change, back, G);
    constexpr int row[6] = {0, 1, 2, 0, 1, 0}, column[6] = {0, 1, 2, 1, 2, 2};
    for (int k = 0; k < 6; ++k)
      strain[k] = 0.5 * (G[3 * row[k] + column[k]] + G[3 * column[k] + row[k]]);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
      {
        const double spin = 0.25 * (G[3 * i + j] - G[3 * j + i]); // half of W
        fore[3 * i + j] = (i == j ? 1.0 : 0.0) + spin;
        aft[3 * i + j] = (i == j ? 1.0 : 0.0) - spin;
      }
    inverseOf(aft, back);
    product(back, fore, R);
  }
};

/// One call, for particle l of a block.
struct UmatCall
{
  const LoadedLaw& law;
  SharedLawBlock& b;
  const int l;
  double stress[6], strain[6], dstrain[6], stored, plastic, plasticBefore;
  double newStep = 1.0; ///< factor of dt that the law asks for

  UmatCall(const LoadedLaw& of, SharedLawBlock& block, int lane) : law(of), b(block), l(lane) {}

  void run(double* state)
  {
    const int n = b.count;
    double F0[9], F1[9], old[6], total[6];
    for (int k = 0; k < 9; ++k)
    {
      F0[k] = b.before[k * n + l];
      F1[k] = b.F[k * n + l];
    }
    const UmatStep step(F0, F1);
    const double J0 = determinantOf(F0), J1 = determinantOf(F1);
    for (int k = 0; k < 6; ++k)
    {
      old[k] = b.oldStress[k * n + l];
      total[k] = (k < 3 ? 1.0 : 0.5) * b.oldState[k * n + l];
    }
    turn(step.R, old);
    turn(step.R, total);
    for (int k = 0; k < 6; ++k)
    {
      const int at = umatOrder[k];
      stress[k] = old[at];
      strain[k] = (k < 3 ? 1.0 : 2.0) * total[at];
      dstrain[k] = (k < 3 ? 1.0 : 2.0) * step.strain[at];
    }
    for (int k = 0; k < law.states; ++k)
      state[k] = b.oldState[(6 + k) * n + l];
    if (b.guard != nullptr)
      std::copy_n(b.guard->states.data(), lawSlack, state + law.states);
    stored = b.oldStored[l] / J0;
    plastic = plasticBefore = b.oldDissipated[l] / J0;
    const double storedBefore = stored;
    call(step, F0, F1, state);
    if (b.guard != nullptr)
      b.guard->look(state + law.states);
    double work = 0.0;
    for (int k = 0; k < 6; ++k)
      work += 0.25 * (J0 + J1) * (old[umatOrder[k]] + stress[k]) * dstrain[k];
    keep(state, J1, work, stored == storedBefore);
  }

private:
  void call(const UmatStep& step, const double (&F0)[9], const double (&F1)[9], double* state)
  {
    const int n = b.count;
    double tangent[36] = {}, zero[6] = {}, heat = 0.0, slope = 0.0, creep = 0.0, rotation[9], before[9],
           after[9];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) // Fortran stores columns
      {
        rotation[3 * j + i] = step.R[3 * i + j];
        before[3 * j + i] = F0[3 * i + j];
        after[3 * j + i] = F1[3 * i + j];
      }
    const double start = b.time - b.dt, time[2] = {start, start}, none = 0.0;
    const double position[3] = {b.position[l], b.position[n + l], b.position[2 * n + l]};
    const int direct = 3, shear = 3, six = 6, one = 1, steps[4] = {1, 1, 1, 0},
              constants = static_cast<int>(law.of.constants.size());
    char name[81];
    std::fill_n(name, 80, ' ');
    name[80] = '\0';
    std::copy_n(law.of.behaviour.data(), std::min<std::size_t>(80, law.of.behaviour.size()), name);
    double thermal[6] = {}, coupling[6] = {};
    reinterpret_cast<Umat>(law.function)(stress, state, tangent, &stored, &plastic, &creep, &heat, thermal,
                                         coupling, &slope, strain, dstrain, time, &b.dt, &b.temperature,
                                         &none, zero, zero, name, &direct, &shear, &six, &law.states,
                                         b.constants, &constants, position, rotation, &newStep, &b.length,
                                         before, after, &one, &one, &one, &one, steps, &one, 80);
    plastic += creep;
  }

  /// \param work of the mean stress per undeformed volume \param untouched whether the law left the stored
  /// energy
  void keep(const double* state, double J1, double work, bool untouched)
  {
    const int n = b.count;
    for (int k = 0; k < 6; ++k)
    {
      b.stress[umatOrder[k] * n + l] = stress[k];
      b.state[umatOrder[k] * n + l] = strain[k] + dstrain[k];
    }
    for (int k = 0; k < law.states; ++k)
      b.state[(6 + k) * n + l] = state[k];
    b.dissipated[l] = b.oldDissipated[l] + J1 * (plastic - plasticBefore);
    b.stored[l] = untouched ? b.oldStored[l] + work - (b.dissipated[l] - b.oldDissipated[l]) : J1 * stored;
    b.speed[l] = 0.0;
    b.failed[l] = newStep < 1.0;
    if (b.failed[l])
      b.reason = "it asks for a smaller step (PNEWDT)";
  }
};

} // namespace

void callUmat(const LoadedLaw& law, SharedLawBlock& b)
{
  double* const state = SharedLawMemory::own().scratch(static_cast<std::size_t>(law.states) + lawSlack);
  for (int l = 0; l < b.count; ++l)
    UmatCall(law, b, l).run(state);
}

} // namespace Rhegma
