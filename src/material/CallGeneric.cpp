#include "material/MFrontData.hpp"
#include "material/SharedLawBlock.hpp"
#include "material/StepOfShape.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

using Generic = int (*)(MFrontData*);

/// 11 22 33 12 21 13 31 23 32 of a gradient in rows.
constexpr int mfrontGradient[9] = {0, 4, 8, 1, 3, 2, 6, 5, 7};
/// 11 22 33 12 13 23 of xx yy zz xy yz xz; shear is times the root of two.
constexpr int mfrontOrder[6] = {0, 1, 2, 3, 5, 4};
const double shearFactor = std::sqrt(2.0);

/// Temperature and further external variables, which are zero.
constexpr int mostExternal = 32;

/// The arrays of one particle at one end of a step.
struct Arrays
{
  double gradients[9], forces[6], stored, dissipated;
};

/// Green-Lagrange strain (F^T F - 1) / 2.
void strainOf(const double (&F)[9], double* out)
{
  constexpr int row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};
  for (int k = 0; k < 6; ++k)
  {
    double sum = k < 3 ? -1.0 : 0.0;
    for (int i = 0; i < 3; ++i)
      sum += F[3 * i + row[k]] * F[3 * i + column[k]];
    out[k] = (k < 3 ? 0.5 : 0.5 * shearFactor) * sum;
  }
}

void gradientsOf(const LoadedLaw& law, const double* all, int n, int l, double* out)
{
  double F[9];
  for (int k = 0; k < 9; ++k)
    F[k] = all[k * n + l];
  if (law.smallStrain)
    strainOf(F, out);
  else
    for (int k = 0; k < 9; ++k)
      out[k] = F[mfrontGradient[k]];
}

/// First Piola-Kirchhoff stress J sigma F^-T of Cauchy's, of gradients and forces in the order of MFront.
void piola(const Arrays& at, double (&P)[9])
{
  double F[9], back[9];
  for (int k = 0; k < 9; ++k)
    F[mfrontGradient[k]] = at.gradients[k];
  inverseOf(F, back);
  const double J = determinantOf(F);
  double s[6];
  for (int k = 0; k < 6; ++k)
    s[mfrontOrder[k]] = J * at.forces[k] / (k < 3 ? 1.0 : shearFactor);
  const double sigma[9] = {s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2]};
  const double turned[9] = {back[0], back[3], back[6], back[1], back[4], back[7], back[2], back[5], back[8]};
  product(sigma, turned, P);
}

/// Work of the mean stress per undeformed volume, for laws that compute no stored energy: S : dE or P : dF,
/// both zero in a rotation.
double workOf(const LoadedLaw& law, const Arrays& start, const Arrays& end)
{
  double sum = 0.0;
  if (law.smallStrain)
  {
    for (int k = 0; k < 6; ++k)
      sum += 0.5 * (start.forces[k] + end.forces[k]) * (end.gradients[k] - start.gradients[k]);
    return sum;
  }
  double P0[9], P1[9];
  piola(start, P0);
  piola(end, P1);
  for (int k = 0; k < 9; ++k)
    sum += 0.5 * (P0[mfrontGradient[k]] + P1[mfrontGradient[k]]) * (end.gradients[k] - start.gradients[k]);
  return sum;
}

struct GenericCall
{
  const LoadedLaw& law;
  SharedLawBlock& b;
  double* oldState; ///< room for the state variables of one particle
  double* state;
  const double* external;

  void run(int l)
  {
    const int n = b.count;
    Arrays start{}, end{};
    gradientsOf(law, b.before, n, l, start.gradients);
    gradientsOf(law, b.F, n, l, end.gradients);
    for (int k = 0; k < 6; ++k)
      start.forces[k] = end.forces[k] = (k < 3 ? 1.0 : shearFactor) * b.oldStress[mfrontOrder[k] * n + l];
    for (int k = 0; k < law.states; ++k)
      oldState[k] = state[k] = b.oldState[k * n + l];
    if (b.guard != nullptr)
      for (double* of : {oldState, state})
        std::copy_n(b.guard->states.data(), lawSlack, of + law.states);
    start.stored = end.stored = b.oldStored[l];
    start.dissipated = end.dissipated = b.oldDissipated[l];
    // Integration without a tangent, and the speed of sound. Some laws write a tangent all the same.
    double K[54] = {100.0}, rdt = 1.0, speed = 0.0;
    char message[512] = "";
    const double* const constants = b.constants;
    MFrontData data{
        message,
        b.dt,
        K,
        &rdt,
        &speed,
        {start.gradients, start.forces, &b.density, constants, oldState, &start.stored, &start.dissipated,
         external},
        {end.gradients, end.forces, &b.density, constants, state, &end.stored, &end.dissipated, external}};
    const int answer = reinterpret_cast<Generic>(law.function)(&data);
    if (b.guard != nullptr)
      b.guard->look(state + law.states);
    message[511] = '\0';
    b.failed[l] = answer < 0 || rdt < 1.0;
    if (b.failed[l])
      b.reason = message[0] != '\0' ? std::string(message)
                 : answer < 0       ? "it reports a failure"
                                    : "it asks for a smaller step";
    keep(l, start, end, speed);
  }

private:
  void keep(int l, const Arrays& start, const Arrays& end, double speed)
  {
    const int n = b.count;
    for (int k = 0; k < 6; ++k)
      b.stress[mfrontOrder[k] * n + l] = end.forces[k] / (k < 3 ? 1.0 : shearFactor);
    for (int k = 0; k < law.states; ++k)
      b.state[k * n + l] = state[k];
    b.dissipated[l] = end.dissipated;
    b.stored[l] = end.stored != start.stored
                      ? end.stored
                      : start.stored + workOf(law, start, end) - (end.dissipated - start.dissipated);
    b.speed[l] = speed > 0.0 ? speed : 0.0;
  }
};

} // namespace

void callGeneric(const LoadedLaw& law, SharedLawBlock& b)
{
  const std::size_t states = static_cast<std::size_t>(law.states) + lawSlack;
  double* const scratch = SharedLawMemory::own().scratch(2 * states + mostExternal);
  double* const external = scratch + 2 * states;
  std::fill_n(external, mostExternal, 0.0);
  external[0] = b.temperature;
  GenericCall call{law, b, scratch, scratch + states, external};
  for (int l = 0; l < b.count; ++l)
    call.run(l);
}

} // namespace Rhegma
