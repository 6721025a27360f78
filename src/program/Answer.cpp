#include "program/Answer.hpp"

#include "base/Counted.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "program/RunEnd.hpp"
#include "program/StartForces.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace Rhegma::program
{

namespace
{

double numberOrZero(const nlohmann::json& of, const char* name)
{
  return of.contains(name) && of[name].is_number() ? of[name].get<double>() : 0.0;
}

std::string howItEnded(const nlohmann::json& summary)
{
  const auto status = summary.value("status", std::string());
  if (!isFinished(endOf(summary))) // time and step are in it
    return status;
  return "the run " + status + " at t = " + readableTime(numberOrZero(summary, "time")) + " after " +
         counted(summary.value("steps", 0L), "step") + (summary.value("settled", false) ? ", at rest" : "");
}

/// "4 of 32 front nodes of " where a front has several. \param stop of a front in the summary
std::string partOfFront(const nlohmann::json& stop)
{
  const int all = stop.value("of_nodes", 1);
  return all == 1
             ? std::string()
             : std::to_string(stop.value("nodes", all)) + " of " + std::to_string(all) + " front nodes of ";
}

/// Fronts whose path and length the cells decided, in one line; empty where there is none.
std::string stoppedFronts(const nlohmann::json& summary)
{
  std::string names;
  int count = 0;
  for (const auto& crack : summary.value("cracks", nlohmann::json::array()))
    for (std::size_t k = 0; crack.contains("fronts") && k < crack["fronts"].size(); ++k)
      if (crack["fronts"][k].is_object() && crack["fronts"][k].contains("stop") && ++count <= 3)
        names += (count > 1 ? "; " : "") + partOfFront(crack["fronts"][k]["stop"]) + "crack " +
                 crack.value("name", std::string()) + ", front " + std::to_string(k);
  if (count == 0)
    return {};
  return "numerical stop of " + names + (count > 3 ? " and " + std::to_string(count - 3) + " more" : "") +
         " (not arrest): later results of this run are not valid";
}

/// Whether an entry of the energies is one: effects add ratios of them.
bool isEnergy(const std::string& name, const nlohmann::json& value)
{
  static const std::string ratio = "_fraction";
  return value.is_number() &&
         (name.size() < ratio.size() || name.compare(name.size() - ratio.size(), ratio.size(), ratio) != 0);
}

/// Energies below this part of the largest are not named.
constexpr double rounding = 1e-9;

/// Part of the largest energy that is open, from which on a reason is given.
constexpr double noticeable = 0.1;

/// The terms of the energy balance that not every scene has, where they are more than rounding.
/// \param given the largest of those that every scene has [J]
std::string otherEnergies(const nlohmann::json& energy, double given)
{
  static const std::set<std::string> ofAll{"external_work", "strain", "kinetic", "fracture", "residual"};
  std::string text;
  for (const auto& [name, value] : energy.items())
    if (isEnergy(name, value) && name != "start" && ofAll.count(name) == 0 &&
        std::fabs(value.get<double>()) > rounding * given)
    {
      std::string words = name;
      std::replace(words.begin(), words.end(), '_', ' ');
      text += ", " + words + " " + readableEnergy(value.get<double>());
    }
  return text;
}

/// Whether cracks have grown unstably under given loads in equilibrium, and not in motion that followed.
bool isUnstableGrowth(const nlohmann::json& summary)
{
  const nlohmann::json growth = summary.value("propagation", nlohmann::json::object());
  const nlohmann::json motion = growth.value("motion_from", nlohmann::json::object());
  if (motion.value("time", nlohmann::json()).is_number())
    return false;
  const nlohmann::json from = growth.value("unstable_from", nlohmann::json());
  return from.is_object() && !from.contains("load_factor") &&
         from.value("new_area", nlohmann::json()).is_number();
}

/// The largest term of the energy balance [J], and whether it is one without heat: millionths of heat become
/// mechanical energy, and in equilibrium only that says whether the balance closes, if it is more than
/// rounding.
std::pair<double, bool> largestOf(const nlohmann::json& energy, bool isEquilibrium)
{
  double mechanical = 0.0, heat = 0.0;
  for (const auto& [name, value] : energy.items())
    if (isEnergy(name, value) && name != "residual")
    {
      double& largest = name == "heat" || name == "thermal" ? heat : mechanical;
      largest = std::max(largest, std::fabs(value.get<double>()));
    }
  const bool heated = isEquilibrium && heat > 0.0 && mechanical > rounding * heat;
  return {heated ? mechanical : std::max(mechanical, heat), heated};
}

/// What is to be known of a residual.
std::string noteOnResidual(const nlohmann::json& summary, bool heated, double fraction)
{
  const bool flows = numberOrZero(summary["energy"], "plastic") > 0.0;
  if (isUnstableGrowth(summary))
    return "; this includes what unstable growth of cracks under given loads releases above the toughness; "
           "it "
           "would become motion";
  if (heated && !flows && fraction > noticeable)
    return "; a part of this can be the error in the work of thermal strain, which is small only if "
           "temperatures change over several load steps; stresses do not have this error";
  return {};
}

/// The residual of the energy balance, and what it is compared with.
struct Residual
{
  double value = 0.0;    ///< [J]
  double of = 0.0;       ///< the energy that it is compared with [J]
  bool heated = false;   ///< that is one without heat
  bool unloaded = false; ///< that is the energy supplied at most, as bodies have given theirs back
  double given = 0.0;    ///< the largest energy, without heat if heated [J]
  double fraction() const { return std::fabs(value) / of; }
  bool isKnown() const { return std::isfinite(of) && std::isfinite(value) && of > 0.0; }
};

Residual residualOf(const nlohmann::json& summary)
{
  const nlohmann::json energy = summary.value("energy", nlohmann::json::object());
  const auto [given, heated] = largestOf(energy, summary.contains("equilibrium"));
  // A body that is unloaded has given its energy back: the residual is that of all of it.
  const double supplied = numberOrZero(summary, "largest_energy_supplied");
  return {numberOrZero(energy, "residual"), given > 0.0 ? std::max(given, supplied) : given, heated,
          supplied > 1.01 * given, given};
}

/// Whether the energies of a summary are those of one state.
bool hasBalance(const nlohmann::json& summary)
{
  return summary.value("energy", nlohmann::json::object()).contains("residual") &&
         summary.value("equilibrium", nlohmann::json::object()).value("last_step_complete", true);
}

/// What a residual is compared with, in words.
std::string basisOf(const Residual& residual)
{
  return residual.unloaded ? "energy supplied at most"
         : residual.heated ? "largest energy without heat"
                           : "largest energy";
}

/// The residual over the fracture energy of the growth, where cracks have grown.
std::string ofGrowth(const nlohmann::json& summary)
{
  const nlohmann::json growth = summary.value("propagation", nlohmann::json::object());
  const nlohmann::json fraction = growth.value("residual_fraction", nlohmann::json());
  return fraction.is_number() && std::isfinite(fraction.get<double>()) &&
                 numberOrZero(growth, "energy_of_new_faces") > 0.0
             ? ", " + formatShort(100.0 * std::fabs(fraction.get<double>())) + " % of the fracture energy" +
                   (summary.contains("equilibrium") ? " since cracks grew" : "")
             : std::string();
}

/// The energy balance: its terms, and its residual as a fraction of the largest one.
std::string energyBalance(const nlohmann::json& summary)
{
  const nlohmann::json energy = summary.value("energy", nlohmann::json::object());
  if (!energy.contains("residual"))
    return {};
  const bool isEquilibrium = summary.contains("equilibrium");
  if (!hasBalance(summary))
    return "energy balance: not given, as the run stopped within a load step, which has no equilibrium";
  const Residual residual = residualOf(summary);
  const double given = residual.given, start = numberOrZero(energy, "start");
  if (!std::isfinite(given) || !std::isfinite(residual.value))
    return "energy balance: not available, because energies are not finite";
  if (!(given > 0.0))
    return numberOrZero(summary, "steps") > 0.0
               ? "energy balance: all energies are zero: no load, motion or heat has acted on the bodies"
               : std::string();
  return "energy balance: external work " + readableEnergy(numberOrZero(energy, "external_work")) +
         ", strain " + readableEnergy(numberOrZero(energy, "strain")) + ", kinetic " +
         readableEnergy(numberOrZero(energy, "kinetic")) + ", fracture " +
         readableEnergy(numberOrZero(energy, "fracture")) + otherEnergies(energy, given) +
         (start > rounding * given ? std::string(isEquilibrium ? ", stored in equilibrium at the start "
                                                               : ", stored at the start ") +
                                         readableEnergy(start)
                                   : std::string()) +
         "; residual " + readableEnergy(residual.value) + " (" + formatShort(100.0 * residual.fraction()) +
         (residual.unloaded ? " % of the " + readableEnergy(residual.of) + " supplied at most"
          : residual.heated ? " % of the largest of these without heat"
                            : " % of the largest of these") +
         ofGrowth(summary) + ")" + noteOnResidual(summary, residual.heated, residual.fraction());
}

/// The residual as numbers, for tools: `energy_balance`, null where it is not known.
void addBalance(nlohmann::json& summary)
{
  nlohmann::json& balance = summary["energy_balance"];
  balance = {{"residual", nullptr}, {"compared_with", nullptr}, {"energy", nullptr}, {"fraction", nullptr}};
  const Residual residual = residualOf(summary);
  if (hasBalance(summary) && residual.isKnown())
    balance = {{"residual", residual.value},
               {"compared_with", basisOf(residual)},
               {"energy", residual.of},
               {"fraction", residual.fraction()}};
}

/// Warnings that are named, and the longest name [characters].
constexpr std::size_t mostWarnings = 3, longestName = 72;

/// The first words of a warning: its path in the scene or its crack, and what it is about.
std::string nameOf(const std::string& warning)
{
  const std::size_t end = warning.rfind(' ', longestName);
  return warning.size() <= longestName || end == std::string::npos ? warning
                                                                   : warning.substr(0, end) + " ...";
}

/// How many warnings there are, and what the first ones are about.
std::string countOf(const nlohmann::json& warnings)
{
  const std::size_t count = warnings.size(), named = std::min(count, mostWarnings);
  if (count == 0)
    return "no warnings";
  std::string text = std::to_string(count) + (count == 1 ? " warning (" : " warnings (");
  for (std::size_t k = 0; k < named; ++k)
    text += (k > 0 ? "; " : "") + nameOf(warnings[k].get<std::string>());
  return text + (named < count ? "; and " + std::to_string(count - named) + " more" : "") +
         "), in full above and in summary.json";
}

} // namespace

void addAnswers(nlohmann::json& summary)
{
  const nlohmann::json ofEffects = summary.value("answers", nlohmann::json::array());
  nlohmann::json answers = nlohmann::json::array({howItEnded(summary)});
  if (const std::string stopped = stoppedFronts(summary); !stopped.empty())
    answers.push_back(stopped);
  for (const auto& answer : ofEffects)
    answers.push_back(answer);
  if (const std::string forces = startForcesAsText(summary); !forces.empty())
    answers.push_back(forces);
  addBalance(summary);
  if (const std::string balance = energyBalance(summary); !balance.empty())
    answers.push_back(balance);
  answers.push_back(countOf(summary.value("warnings", nlohmann::json::array())));
  summary["answers"] = answers;
}

void printAnswers(const nlohmann::json& summary, bool failed, std::ostream& out)
{
  const nlohmann::json& answers = summary["answers"];
  for (std::size_t k = failed ? 1 : 0; k < answers.size(); ++k)
    out << answers[k].get<std::string>() << "\n";
  out << std::flush;
}

} // namespace Rhegma::program
