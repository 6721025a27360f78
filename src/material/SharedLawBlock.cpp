#include "material/SharedLawBlock.hpp"

#include "base/LawInCall.hpp"
#include "material/PolarDecomposition.hpp"
#include "material/StepOfShape.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

/// F = R U of both ends of the step.
void decompose(SharedLawBlock& b)
{
  polarDecomposition(b.count, b.before, b.rotation, b.oldStretch, b.plane);
  polarDecomposition(b.count, b.F, b.rotation, b.stretch, b.plane);
}

bool isFinite(const double* values, int components, int n, int l)
{
  double sum = 0.0; // finite only if all are
  for (int k = 0; k < components; ++k)
    sum += std::fabs(values[k * n + l]);
  return std::isfinite(sum);
}

void call(const LoadedLaw& law, SharedLawBlock& b)
{
  const int n = b.count;
  std::fill_n(b.failed, n, false);
  if (law.corotational)
    decompose(b);
  {
    const LawInCall in(law.of.behaviour.c_str(), law.of.file.c_str());
    law.call(law, b);
  }
  kirchhoffStress(law, b);
  for (int l = 0; l < n; ++l)
    b.failed[l] = b.failed[l] || !isFinite(b.tau, 6, n, l) || !isFinite(b.stored, 1, n, l) ||
                  !isFinite(b.dissipated, 1, n, l) || !isFinite(b.state, law.numbers, n, l);
}

/// Search for the thickness stretch s at which tau_zz vanishes: the secant method in ln s, begun with the
/// elastic modulus. The law is always called for the step from the same start.
class Thickness
{
public:
  Thickness(const Properties& m, SharedLawBlock& block)
      : b(block),
        stiff(m.lambda + 2.0 * m.mu),
        slope_(block.count, stiff),
        last_(block.count),
        at_(block.count)
  {
    const double ratio = m.thicknessRatio;
    for (int l = 0; l < b.count; ++l)
    {
      double& s = b.F[8 * b.count + l];
      s = b.before[8 * b.count + l] * std::pow(area(b.before, l) / area(b.F, l), ratio);
      if (!std::isfinite(s))
        s = 1.0;
    }
  }

  /// Moves s after a call of the law. \return whether all are found
  bool improve(bool first)
  {
    const int n = b.count;
    bool found = true;
    for (int l = 0; l < n; ++l)
    {
      const double residual = b.tau[2 * n + l];
      double& s = b.F[8 * n + l];
      if (b.failed[l] || std::fabs(residual) <= relativeError * std::max(stiff, slope_[l]))
        continue;
      found = false;
      if (!first && at_[l] != s)
      {
        const double slope = (residual - last_[l]) / std::log(s / at_[l]);
        if (std::isfinite(slope))
          slope_[l] = std::min(std::max(slope, 1e-3 * stiff), 1e3 * stiff);
      }
      last_[l] = residual;
      at_[l] = s;
      s *= std::exp(std::min(std::max(-residual / slope_[l], -longest), longest));
    }
    return found;
  }

private:
  static constexpr double relativeError = 1e-14, longest = 0.2; // of a strain

  double area(const double* F, int l) const
  {
    const int n = b.count;
    return F[l] * F[4 * n + l] - F[n + l] * F[3 * n + l];
  }

  SharedLawBlock& b;
  double stiff;
  std::vector<double> slope_, last_, at_;
};

void callInPlaneStress(const LoadedLaw& law, const Properties& m, SharedLawBlock& b)
{
  constexpr int mostCalls = 60;
  Thickness thickness(m, b);
  call(law, b);
  bool found = thickness.improve(true);
  for (int i = 1; i < mostCalls && !found; ++i)
  {
    call(law, b);
    found = thickness.improve(false);
  }
  const double largest = 1e-6 * (m.lambda + 2.0 * m.mu);
  for (int l = 0; l < b.count; ++l)
    if (!b.failed[l] && !(std::fabs(b.tau[2 * b.count + l]) <= largest))
    {
      b.failed[l] = true;
      b.reason = "no thickness was found at which the stress across the plane vanishes";
    }
}

} // namespace

SharedLawBlock SharedLawMemory::block(const LoadedLaw& law, int count)
{
  SharedLawBlock b;
  b.count = count;
  b.constants = constantsOf(law);
  const std::size_t n = count;
  const std::pair<double**, int> arrays[] = {{&b.before, 9},
                                             {&b.F, 9},
                                             {&b.position, 3},
                                             {&b.oldStress, 6},
                                             {&b.stress, 6},
                                             {&b.oldStored, 1},
                                             {&b.stored, 1},
                                             {&b.oldDissipated, 1},
                                             {&b.dissipated, 1},
                                             {&b.speed, 1},
                                             {&b.oldState, law.numbers + lawSlack},
                                             {&b.state, law.numbers + lawSlack},
                                             {&b.tau, 6},
                                             {&b.rotation, 9},
                                             {&b.oldStretch, 6},
                                             {&b.stretch, 6}};
  std::size_t all = 0;
  for (const auto& [array, components] : arrays)
    all += components * n;
  if (numbers_.size() < all)
    numbers_.resize(all);
  double* next = numbers_.data();
  for (const auto& [array, components] : arrays)
  {
    *array = next;
    next += components * n;
  }
  for (const auto& [array, components] : {arrays[0], arrays[1], arrays[2]})
    std::fill_n(*array, components * n, 0.0);
  if (flags_.size() < n)
    flags_.resize(n);
  b.failed = reinterpret_cast<bool*>(flags_.data());
  return b;
}

double* SharedLawMemory::scratch(std::size_t numbers)
{
  if (scratch_.size() < numbers)
    scratch_.resize(numbers);
  return scratch_.data();
}

SharedLawMemory& SharedLawMemory::own()
{
  static thread_local SharedLawMemory memory;
  return memory;
}

void kirchhoffStress(const LoadedLaw& law, SharedLawBlock& b)
{
  const int n = b.count;
  for (int l = 0; l < n; ++l)
  {
    double F[9], frame[9], s[6];
    for (int k = 0; k < 9; ++k)
      F[k] = b.F[k * n + l];
    for (int k = 0; k < 6; ++k)
      s[k] = b.stress[k * n + l];
    const double J = law.smallStrain ? 1.0 : determinantOf(F);
    if (law.corotational || law.smallStrain)
    {
      for (int k = 0; k < 9; ++k)
        frame[k] = law.smallStrain ? F[k] : b.rotation[k * n + l];
      turn(frame, s);
    }
    for (int k = 0; k < 6; ++k)
      b.tau[k * n + l] = J * s[k];
  }
}

void restOfSharedLaw(const LoadedLaw& law, SharedLawBlock& b)
{
  const int n = b.count;
  std::fill_n(b.failed, n, false);
  std::fill_n(b.speed, n, 0.0);
  std::copy_n(b.oldStress, 6 * n, b.stress);
  std::copy_n(b.oldStored, n, b.stored);
  std::copy_n(b.oldDissipated, n, b.dissipated);
  std::copy_n(b.oldState, static_cast<std::size_t>(law.numbers) * n, b.state);
  if (law.corotational)
    polarDecomposition(n, b.F, b.rotation, b.stretch, b.plane);
  kirchhoffStress(law, b);
}

void evaluateSharedLaw(const LoadedLaw& law, const Properties& m, SharedLawBlock& block)
{
  if (m.plane == Plane::Stress)
    callInPlaneStress(law, m, block);
  else
    call(law, block);
}

} // namespace Rhegma
