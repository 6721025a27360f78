#include "material/LawTrial.hpp"

#include "base/ShortNumber.hpp"
#include "material/SharedLawBlock.hpp"
#include "material/SharedLibrary.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace Rhegma
{

namespace
{

constexpr double smallStrain = 1e-6;

std::string quoted(const LoadedLaw& law) { return "\"" + law.of.behaviour + "\""; }

/// A strain along each of three axes and in each of three planes, from the undeformed state.
struct StrainStep
{
  double strain, dt, time;
};

constexpr StrainStep atStart = {smallStrain, 1e-9, 0.0};
/// Metals flow at the first two and rubber softens at the others. Some laws take time zero as elastic.
constexpr StrainStep large[] = {
    {0.01, 1e-5, 1e-5}, {-0.01, 1e-5, 1e-5}, {0.3, 3e-4, 3e-4}, {-0.3, 3e-4, 3e-4}};

constexpr int cases = 6;

/// Calls of one law.
class Trial
{
public:
  Trial(const LoadedLaw& of, const Properties& m) : law(of), solid_(m)
  {
    solid_.plane = Plane::Solid; // what is compared are the moduli of the solid
    guard.constants = of.of.constants;
    guard.constants.resize(of.of.constants.size() + lawSlack, 0.0);
  }

  /// The results stay in `block`.
  void call(const StrainStep& step)
  {
    fill(step);
    block.constants = guard.constants.data();
    block.guard = &guard;
    evaluateSharedLaw(law, solid_, block);
  }

  /// All results, bit by bit.
  std::vector<double> results() const
  {
    std::vector<double> all;
    const std::pair<const double*, int> arrays[] = {{block.tau, 6},
                                                    {block.stored, 1},
                                                    {block.dissipated, 1},
                                                    {block.speed, 1},
                                                    {block.state, law.numbers}};
    for (const auto& [array, components] : arrays)
      all.insert(all.end(), array, array + components * cases);
    for (int l = 0; l < cases; ++l)
      all.push_back(block.failed[l] ? 1.0 : 0.0);
    return all;
  }

  const LoadedLaw& law;
  LawGuard guard;
  SharedLawBlock block;

private:
  void fill(const StrainStep& step)
  {
    SharedLawBlock& b = block = SharedLawMemory::own().block(law, cases);
    b.dt = step.dt;
    b.time = step.time;
    b.temperature = solid_.temperature;
    b.density = solid_.density;
    b.length = solid_.cellSize;
    for (int k = 0; k < 9; ++k)
      std::fill_n(b.F + k * cases, cases, k % 4 == 0 ? 1.0 : 0.0);
    std::copy_n(b.F, 9 * cases, b.before);
    constexpr int row[6] = {0, 1, 2, 0, 1, 0}, column[6] = {0, 1, 2, 1, 2, 2};
    for (int l = 0; l < cases; ++l)
    {
      b.F[(3 * row[l] + column[l]) * cases + l] += step.strain;
      if (l >= 3)
        b.F[(3 * column[l] + row[l]) * cases + l] += step.strain;
    }
    const std::pair<double*, int> zeros[] = {{b.position, 3},          {b.oldStress, 6},     {b.stress, 6},
                                             {b.oldStored, 1},         {b.oldDissipated, 1}, {b.speed, 1},
                                             {b.oldState, law.numbers}};
    for (const auto& [array, components] : zeros)
      std::fill_n(array, components * cases, 0.0);
  }

  Properties solid_;
};

bool isSame(const std::vector<double>& a, const std::vector<double>& b)
{
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!(a[k] == b[k] || (std::isnan(a[k]) && std::isnan(b[k]))))
      return false;
  return true;
}

/// Results with numbers behind an array of the law.
std::vector<double> resultsWith(Trial& trial, const StrainStep& step, double* behind,
                                const std::array<double, lawSlack>& numbers)
{
  std::copy(numbers.begin(), numbers.end(), behind);
  trial.call(step);
  std::fill_n(behind, lawSlack, 0.0);
  return trial.results();
}

/// The last number of those behind an array by which the results of a law change; 0 if by none, also where
/// two calls with the same arguments differ.
int lastRead(Trial& trial, const StrainStep& step, double* behind)
{
  std::array<double, lawSlack> zeros{}, others;
  const std::vector<double> right = resultsWith(trial, step, behind, zeros);
  // Comparisons with NaN may take the same way as with zero.
  for (const double value : {1.5, std::numeric_limits<double>::quiet_NaN()})
  {
    others.fill(value);
    const std::vector<double> wrong = resultsWith(trial, step, behind, others);
    if (isSame(wrong, right))
      continue;
    if (!isSame(resultsWith(trial, step, behind, zeros), right))
      return 0;
    for (int k = lawSlack; k > 0; --k)
    {
      std::array<double, lawSlack> one = zeros, butOne = others;
      one[k - 1] = value;
      butOne[k - 1] = 0.0;
      if (!isSame(resultsWith(trial, step, behind, one), right) ||
          !isSame(resultsWith(trial, step, behind, butOne), wrong))
        return k;
    }
  }
  return 0;
}

void refuseStates(const LoadedLaw& law, const std::string& does, int last)
{
  throw LawRefused("State Variables",
                   (law.of.states < 0 ? "is by the library " : "is ") + std::to_string(law.states) +
                       ", but " + quoted(law) + " " + does + " number " + std::to_string(law.states + last) +
                       " too; give as many as the law has" +
                       (law.of.states < 0 ? ", and export that number from the library." : "."));
}

/// Whether the law reads or writes behind its arrays.
void checkGuards(Trial& trial, const StrainStep& step, ChildTalk* talk)
{
  constexpr int seconds = 20;
  const LoadedLaw& law = trial.law;
  const std::size_t given = law.of.constants.size();
  if (talk != nullptr)
    talk->stage(LawStage::constants, seconds);
  if (const int last = lastRead(trial, step, trial.guard.constants.data() + given); last > 0)
    throw LawRefused("Constants", "has " + std::to_string(given) + (given == 1 ? " number" : " numbers") +
                                      ", but " + quoted(law) + " uses number " +
                                      std::to_string(given + last) +
                                      " too; give all constants of the law, in its order.");
  if (talk != nullptr)
    talk->stage(LawStage::states, seconds);
  const int last = lastRead(trial, step, trial.guard.states.data());
  if (trial.guard.written > 0)
    refuseStates(law, "writes", trial.guard.written);
  if (last > 0)
    refuseStates(law, "uses", last);
}

void checkFinite(const SharedLawBlock& b, const LoadedLaw& law)
{
  for (int l = 0; l < b.count; ++l)
    if (b.failed[l])
      throw LawRefused(
          "Behaviour",
          quoted(law) +
              (b.reason.empty() ? " returns a stress, an energy or a state that is not finite"
                                : " fails (" + b.reason + ")") +
              " for a strain of 1e-6 of the undeformed material; check Constants, State Variables "
              "and Interface.");
}

/// Largest modulus that the stresses after strains of one size show [Pa].
double stiffness(const SharedLawBlock& b, double strain)
{
  double stiffest = -std::numeric_limits<double>::max();
  for (int l = 0; l < cases; ++l)
    stiffest = std::max(stiffest, b.tau[l * b.count + l] / ((l < 3 ? 1.0 : 2.0) * strain));
  return stiffest;
}

double givenStiffness(const Properties& m)
{
  const double speed = SharedLibrary::startSpeed(m);
  return m.density * speed * speed;
}

void checkStiffness(Trial& trial, const Properties& m)
{
  constexpr double tolerance = 1.05, least = 1e-9;
  const double given = givenStiffness(m);
  double stiffest = stiffness(trial.block, smallStrain);
  if (stiffest > tolerance * given)
    throw LawRefused(
        m.own[SharedLawNumber::speed] > 0.0 ? "Wave Speed" : "Young Modulus",
        "gives waves a modulus of " + formatShort(given) + " Pa, but " + quoted(trial.law) + " has one of " +
            formatShort(stiffest) +
            " Pa at a strain of 1e-6; give the elastic constants of the law, or a Wave Speed of " +
            formatShort(std::sqrt(stiffest / m.density)) + " m/s.");
  if (stiffest > least * given)
    return;
  // Some materials resist compression alone.
  StrainStep back = atStart;
  back.strain = -smallStrain;
  trial.call(back);
  stiffest = std::max(stiffest, stiffness(trial.block, -smallStrain));
  if (stiffest <= least * given)
    throw LawRefused("Behaviour", quoted(trial.law) + " resists no strain: its largest modulus is " +
                                      formatShort(stiffest) +
                                      " Pa at strains of 1e-6, and the elastic constants give " +
                                      formatShort(given) +
                                      " Pa; look whether it sets the stress, and check Constants and "
                                      "Interface.");
}

/// Dissipation is negative by more than rounding of the elastic energy.
void checkDissipation(const SharedLawBlock& b, const LoadedLaw& law, const Properties& m)
{
  const double elastic = 0.5 * givenStiffness(m) * smallStrain * smallStrain;
  const double least = *std::min_element(b.dissipated, b.dissipated + b.count);
  if (least < -1e-3 * elastic)
    throw LawRefused(
        "Behaviour",
        quoted(law) + " dissipates " + formatShort(least) +
            " J/m3 in a strain of 1e-6, but dissipated energy can't decrease; look at the energies "
            "that the law returns (enerInelasNew; SPD and SCD; dissipated_energy).");
}

} // namespace

void tryLaw(const LoadedLaw& law, const Properties& m, ChildTalk* talk)
{
  constexpr int seconds = 60, secondsIfLarge = 5;
  Trial trial(law, m);
  if (talk != nullptr)
    talk->stage(LawStage::call, seconds);
  trial.call(atStart);
  checkGuards(trial, atStart, talk);
  trial.call(atStart);
  checkFinite(trial.block, law);
  checkDissipation(trial.block, law, m);
  checkStiffness(trial, m);
  if (talk == nullptr)
    return;
  for (const StrainStep& step : large)
  {
    talk->stage(LawStage::large, secondsIfLarge);
    trial.call(step);
    checkGuards(trial, step, talk);
  }
}

} // namespace Rhegma
