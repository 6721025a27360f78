#include "energy_release/HeldFronts.hpp"

#include "base/IntensityText.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace Rhegma::energy_release
{

namespace
{

/// Fronts that get a line each.
constexpr std::size_t mostLines = 4;

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

/// A value as its entry in the summary has it; none where it is not a number.
bool isKnown(const nlohmann::json& entry, const std::string& name)
{
  return entry.contains(name) && entry[name].is_number() && std::isfinite(entry[name].get<double>());
}

std::string releaseAsText(double value, double error = noNumber)
{
  const double percent = 100.0 * error / std::fabs(value);
  return withError(value, error) + " J/m2" +
         (std::isfinite(error) ? " (" + inDigitsOf(percent, percent) + " %)" : "");
}

/// "K_I = 2 +- 0.01 MPa m^0.5", in 3D with its range along the front.
template <class AsText>
std::string quantityAsText(const nlohmann::json& entry, const std::string& name, const std::string& shown,
                           const AsText& asText)
{
  const std::string ofError = name + "_error_estimate";
  std::string text =
      shown + " = " +
      asText(entry[name].get<double>(), isKnown(entry, ofError) ? entry[ofError].get<double>() : noNumber);
  if (isKnown(entry, name + "_min") && isKnown(entry, name + "_max"))
    text += " (" + asText(entry[name + "_min"].get<double>(), noNumber) + " to " +
            asText(entry[name + "_max"].get<double>(), noNumber) + " along the front)";
  return text;
}

/// "|K_II| = 2 +- 0.1 MPa m^0.5 at most, at (0, 0.01, 0.02) m": the largest of a mode of shear in 3D, whose
/// sign can change along the front, so that its mean says little.
std::string shearAlongFront(const nlohmann::json& entry, const std::string& name)
{
  const nlohmann::json& along = entry["front_nodes"][name];
  std::size_t at = along.size();
  double largest = -1.0;
  for (std::size_t k = 0; k < along.size(); ++k)
    if (along[k].is_number() && std::fabs(along[k].get<double>()) > largest)
    {
      largest = std::fabs(along[k].get<double>());
      at = k;
    }
  if (at == along.size())
    return {};
  const char* const ofError = "K_extremes_error_estimate";
  const double error = isKnown(entry, ofError) ? entry[ofError].get<double>() : noNumber;
  const std::vector<double> x = entry["front_nodes"]["position"][at];
  return "|" + name + "| = " + intensityAsText(largest, error) + " at most" +
         (largest < error
              ? std::string()
              : ", at (" + formatShort(x[0]) + ", " + formatShort(x[1]) + ", " + formatShort(x[2]) + ") m");
}

/// What is said of a closed crack: the part of G that K_I has closes it further.
/// \param isotropic whether the material is, so that both modes have the same part of G for their K
std::string closedAsText(const nlohmann::json& entry, const std::string& release, bool isotropic)
{
  if (!entry.value("closed", false))
    return "";
  const auto squareOf = [&](const char* name)
  { return isKnown(entry, name) ? std::pow(entry[name].get<double>(), 2) : 0.0; };
  const double closing = squareOf("K_I"), all = closing + squareOf("K_II") + squareOf("K_III");
  if (!isotropic)
    return "; the crack is closed (K_I < 0), so only the part of G that slides it would advance it";
  if (isKnown(entry, "K_I_min")) // modes that change their sign along a front vanish in its means
    return "; the crack is closed (K_I < 0 in the mean), so only the part of G that slides it would advance "
           "it";
  return "; the crack is closed (K_I < 0), so about " +
         releaseAsText(std::max(0.0, entry[release].get<double>()) * (1.0 - closing / all)) +
         " of G would advance it";
}

/// Why fronts have no error estimate, a message for each reason.
std::vector<std::string>
withoutEstimate(const std::vector<std::pair<std::string, std::string>>& namesAndReasons)
{
  std::vector<std::string> messages;
  std::vector<std::string> reasons;
  for (const auto& [name, reason] : namesAndReasons)
  {
    const auto at = std::find(reasons.begin(), reasons.end(), reason);
    if (at != reasons.end())
    {
      messages[at - reasons.begin()].append("; ").append(name);
      continue;
    }
    reasons.push_back(reason);
    messages.emplace_back("no error estimate (")
        .append(reason)
        .append("; compare with --twice) for ")
        .append(name);
  }
  return messages;
}

/// The largest G of a run where it was not the last one, by more than 1 %.
std::string largestAsText(const nlohmann::json& entry)
{
  const char* const name = "largest_G_J";
  if (!isKnown(entry, name) || !isKnown(entry, "G_J"))
    return {};
  const double largest = entry[name].get<double>(), last = entry["G_J"].get<double>();
  return largest > 1.01 * std::max(last, 0.0)
             ? "; the largest G of all samples was " + releaseAsText(largest) +
                   " at t = " + readableTime(entry["time_of_largest_G_J"].get<double>())
             : std::string();
}

} // namespace

template <int D>
void addAnswersOfHeldFronts(const CrackSet<D>& set, const std::vector<FrontSample<D>>& samples, double time,
                            nlohmann::json& summary)
{
  std::vector<std::pair<double, std::string>> lines; // G and what is said
  std::vector<std::pair<std::string, std::string>> unknown;
  for (std::size_t f = 0; f < set.fronts.size() && f < samples.size(); ++f)
  {
    const CrackFront<D>& front = set.fronts[f];
    if (front.grown || front.ended)
      continue;
    const nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
    const std::string release = isKnown(entry, "G_J") ? "G_J" : "G_closure";
    if (!isKnown(entry, release))
      continue;
    std::string text = frontName(set, front) + ": " + quantityAsText(entry, release, "G", releaseAsText);
    for (const std::string name : {"K_I", "K_II", "K_III"})
      if (isKnown(entry, name))
        text += ", " + (D == 3 && name != "K_I" ? shearAlongFront(entry, name)
                                                : quantityAsText(entry, name, name, intensityAsText));
    lines.emplace_back(entry[release].get<double>(), text + " at t = " + readableTime(time) +
                                                         largestAsText(entry) +
                                                         closedAsText(entry, release, samples[f].isotropic));
    if (entry.contains("no_error_estimate"))
      unknown.emplace_back(frontName(set, front), entry["no_error_estimate"].get<std::string>());
  }
  const std::size_t count = lines.size();
  if (count > mostLines)
    std::stable_sort(lines.begin(), lines.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t k = 0; k < std::min(count, mostLines); ++k)
    summary["answers"].push_back(lines[k].second);
  if (count > mostLines)
    summary["answers"].push_back("these are the " + std::to_string(mostLines) +
                                 " fronts with the largest G of " + std::to_string(count) +
                                 "; summary.json has all");
  for (const std::string& message : withoutEstimate(unknown))
    summary["answers"].push_back(message);
}

template void addAnswersOfHeldFronts(const CrackSet<2>&, const std::vector<FrontSample<2>>&, double,
                                     nlohmann::json&);
template void addAnswersOfHeldFronts(const CrackSet<3>&, const std::vector<FrontSample<3>>&, double,
                                     nlohmann::json&);

} // namespace Rhegma::energy_release
