#include "material/SharedLibrary.hpp"

#include "material/SharedLawBlock.hpp"
#include "material/StepOfShape.hpp"

#include <algorithm>
#include <sstream>

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

template <class Number>
std::string shortText(Number value)
{
  std::ostringstream out;
  out.precision(4);
  out << value;
  return out.str();
}

/// Strains of 1e-6 along three axes and in three planes, from the undeformed state.
SharedLawBlock smallStrains(const LoadedLaw& law, const Properties& m, double strain)
{
  constexpr int cases = 6;
  SharedLawBlock b = SharedLawMemory::own().block(law, cases);
  b.dt = 1e-9;
  b.temperature = m.temperature;
  b.density = m.density;
  b.length = m.cellSize;
  for (int k = 0; k < 9; ++k)
    std::fill_n(b.F + k * cases, cases, k % 4 == 0 ? 1.0 : 0.0);
  std::copy_n(b.F, 9 * cases, b.before);
  constexpr int row[6] = {0, 1, 2, 0, 1, 0}, column[6] = {0, 1, 2, 1, 2, 2};
  for (int l = 0; l < cases; ++l)
  {
    b.F[(3 * row[l] + column[l]) * cases + l] += strain;
    if (l >= 3)
      b.F[(3 * column[l] + row[l]) * cases + l] += strain;
  }
  const std::pair<double*, int> zeros[] = {{b.position, 3},          {b.oldStress, 6},     {b.stress, 6},
                                           {b.oldStored, 1},         {b.oldDissipated, 1}, {b.speed, 1},
                                           {b.oldState, law.numbers}};
  for (const auto& [array, components] : zeros)
    std::fill_n(array, components * cases, 0.0);
  return b;
}

} // namespace

int loadAndTry(const LawRequest& request, const Properties& m)
{
  constexpr double strain = 1e-6, tolerance = 1.05;
  const int number = loadLaw(request);
  const LoadedLaw& law = loadedLaw(number);
  SharedLawBlock b = smallStrains(law, m, strain);
  Properties solid = m; // what is compared are the moduli of the solid
  solid.plane = Plane::Solid;
  evaluateSharedLaw(law, solid, b);
  const std::string what = "\"" + request.behaviour + "\"";
  for (int l = 0; l < b.count; ++l)
    if (b.failed[l])
      throw LawRefused(
          "Behaviour",
          what +
              (b.reason.empty() ? " returns a stress, an energy or a state that is not finite"
                                : " fails (" + b.reason + ")") +
              " for a strain of 1e-6 of the undeformed material; check Constants, State Variables "
              "and Interface.");
  const double speed = SharedLibrary::startSpeed(m), given = m.density * speed * speed;
  double stiffest = 0.0;
  for (int l = 0; l < 3; ++l)
    stiffest = std::max(stiffest, b.tau[l * b.count + l] / strain);
  for (int l = 3; l < 6; ++l)
    stiffest = std::max(stiffest, b.tau[l * b.count + l] / (2.0 * strain));
  if (stiffest > tolerance * given)
    throw LawRefused(
        m.own[SharedLawNumber::speed] > 0.0 ? "Wave Speed" : "Young Modulus",
        "gives waves a modulus of " + shortText(given) + " Pa, but " + what + " has one of " +
            shortText(stiffest) +
            " Pa at a strain of 1e-6; give the elastic constants of the law, or a Wave Speed of " +
            shortText(std::sqrt(stiffest / m.density)) + " m/s.");
  return number;
}

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
