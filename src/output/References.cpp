#include "output/References.hpp"

#include "base/Attempts.hpp"
#include "scene/NearestName.hpp"

#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <vector>

namespace Rhegma
{

namespace
{

std::vector<std::string> splitAtDots(const std::string& path)
{
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '.');)
    parts.push_back(part);
  return parts;
}

std::vector<std::string> names(const nlohmann::json& object)
{
  std::vector<std::string> all;
  for (const auto& item : object.items())
    all.push_back(item.key());
  return all;
}

std::string nearest(const std::string& given, const std::vector<std::string>& possible)
{
  const std::string name = nearestName(given, possible);
  return name.empty() ? "" : " (did you mean \"" + name + "\"?)";
}

/// Renamed entries of the summary: former and present names.
const std::map<std::string, std::string>& renamedEntries()
{
  static const std::map<std::string, std::string> renamed = {
      {"stations", "front_nodes"},
      {"set_out", "initiated"},
      {"halted", "stopped"},
      {"closest_to_setting_out", "closest_to_initiation"},
      {"dissipated_share", "dissipated_fraction"},
      {"residual_share", "residual_fraction"},
      {"smallest_share", "smallest_fraction"},
      {"largest_share", "largest_fraction"},
      {"last_share", "last_fraction"},
      {"shear_share_below", "shear_fraction_below"},
      {"shear_share_above", "shear_fraction_above"},
      {"shear_share_friction", "shear_fraction_friction"},
      {"share_below", "fraction_below"},
      {"share_above", "fraction_above"},
      {"share_friction", "fraction_friction"},
      {"energy_taken_from_short_waves", "energy_absorbed_from_short_waves"},
      {"looks", "checks"},
  };
  return renamed;
}

bool isIndex(const std::string& part)
{
  return !part.empty() && part.size() < 10 && part.find_first_not_of("0123456789") == std::string::npos;
}

const nlohmann::json* entryOf(const nlohmann::json& list, const std::string& part)
{
  if (isIndex(part))
    return std::stoul(part) < list.size() ? &list[std::stoul(part)] : nullptr;
  for (const nlohmann::json& entry : list)
    if (entry.is_object() && entry.contains("name") && entry["name"] == part)
      return &entry;
  return nullptr;
}

/// The entry at a path, or null and why there is none.
const nlohmann::json* find(const nlohmann::json& summary, const std::string& path, std::string& problem)
{
  const nlohmann::json* at = &summary;
  std::string done;
  for (const std::string& part : splitAtDots(path))
  {
    const std::string position = done.empty() ? "the summary" : done;
    const nlohmann::json* next = nullptr;
    if (at->is_object())
      next = at->contains(part) ? &(*at)[part] : nullptr;
    else if (at->is_array())
      next = entryOf(*at, part);
    if (next == nullptr)
    {
      problem = position;
      problem.append(" has no \"").append(part).append("\"; it ");
      const auto renamed = renamedEntries().find(part);
      if (renamed != renamedEntries().end())
        problem += "is now named \"" + renamed->second + "\"";
      else if (at->is_object())
        problem +=
            at->empty() ? "is empty" : "has " + asText(names(*at), " and ") + nearest(part, names(*at));
      else if (at->is_array())
        problem += "is a list of " + std::to_string(at->size());
      else
        problem += "is one value";
      return nullptr;
    }
    at = next;
    if (!done.empty())
      done += ".";
    done += part;
  }
  return at;
}

/// The number at a path, or NaN and why there is none.
double findEntry(const nlohmann::json& summary, const std::string& path, std::string& problem)
{
  const nlohmann::json* at = find(summary, path, problem);
  if (at == nullptr)
    return std::nan("");
  const double value = at->is_number()    ? at->get<double>()
                       : at->is_boolean() ? (at->get<bool>() ? 1.0 : 0.0)
                                          : std::nan("");
  if (!std::isfinite(value))
    problem = path + " is not a number";
  return value;
}

/// Whether the loads of a run had a factor, so that its times only count load steps.
bool hasLoadFactor(const nlohmann::json& summary)
{
  const auto growth = summary.find("propagation");
  return growth != summary.end() && growth->is_object() && growth->contains("load_factor");
}

/// Whether an entry of the summary is a time of growth.
bool isTimeOfGrowth(const std::string& path)
{
  const std::string last = splitAtDots(path).back();
  return path.find('.') != std::string::npos &&
         (last == "initiated" || last == "last_advance" || last == "time");
}

/// Why a time of growth is not compared.
constexpr const char* timesAreCounts = "with Propagation > Load Control = Load Factor times only count load "
                                       "steps; compare propagation.initiation.load_factor";

nlohmann::json compare(const std::string& name, const Teuchos::ParameterList& entry,
                       const nlohmann::json& summary)
{
  const std::string quantity = entry.get<std::string>("Quantity");
  const double reference = entry.get<double>("Value");
  const double tolerance = entry.get<double>("Tolerance");
  std::string problem;
  const double value = findEntry(summary, quantity, problem);
  nlohmann::json result;
  result["name"] = name;
  result["quantity"] = quantity;
  result["reference"] = reference;
  result["tolerance"] = tolerance;
  result["source"] = entry.get<std::string>("Source");
  if (hasLoadFactor(summary) && isTimeOfGrowth(quantity))
  {
    result["value"] = result["relative_error"] = result["within"] = nullptr;
    result["left_out"] = timesAreCounts;
  }
  else if (problem.empty())
  {
    const double difference = std::fabs(value - reference);
    const double error = reference != 0.0 ? difference / std::fabs(reference) : difference;
    result["value"] = value;
    result["relative_error"] = error;
    result["within"] = error <= tolerance;
  }
  else
  {
    result["value"] = nullptr;
    result["relative_error"] = nullptr;
    result["within"] = false;
    result["problem"] = problem;
  }
  return result;
}

std::string comparison(const nlohmann::json& result)
{
  const std::string quantity = result["quantity"].get<std::string>();
  if (result.contains("left_out"))
    return "left out " + quantity + ": " + result["left_out"].get<std::string>() + "\n";
  const std::string start = result["within"].get<bool>() ? "within   " : "OUTSIDE  ";
  if (result.contains("problem"))
    return start + quantity + ": " + result["problem"].get<std::string>() + "\n";
  const double reference = result["reference"].get<double>();
  const bool relative = reference != 0.0;
  const double factor = relative ? 100.0 : 1.0;
  const char* unit = relative ? " %" : "";
  char text[160];
  std::snprintf(text, sizeof text, " = %.6g, reference %.6g, error %.3g%s, tolerance %.3g%s",
                result["value"].get<double>(), reference, factor * result["relative_error"].get<double>(),
                unit, factor * result["tolerance"].get<double>(), unit);
  return start + quantity + text + " (" + result["source"].get<std::string>() + ")\n";
}

} // namespace

bool addReferences(const Teuchos::ParameterList& section, nlohmann::json& summary)
{
  nlohmann::json results = nlohmann::json::array();
  bool all = true, compared = false;
  for (auto item = section.begin(); item != section.end(); ++item)
    if (section.isSublist(section.name(item)))
    {
      results.push_back(compare(section.name(item), section.sublist(section.name(item)), summary));
      if (results.back().contains("left_out"))
        continue;
      compared = true;
      all = all && results.back()["within"].get<bool>();
    }
  summary["references"] = results;
  return all && (compared || results.empty());
}

void refuseUnknownQuantities(const Teuchos::ParameterList& section, const nlohmann::json& summary)
{
  Attempts attempts;
  for (auto item = section.begin(); item != section.end(); ++item)
    if (section.isSublist(section.name(item)))
    {
      const std::string quantity = section.sublist(section.name(item)).get<std::string>("Quantity");
      std::string problem;
      const nlohmann::json* at = find(summary, quantity, problem);
      if (at != nullptr && (at->is_object() || at->is_array() || at->is_string()))
        problem = quantity + " is not a number; write the path of a number";
      attempts.attempt(
          [&]
          {
            if (!problem.empty())
              throw std::invalid_argument("Reference > " + section.name(item) + " > Quantity: " + problem);
          });
    }
  attempts.throwIfAny();
}

std::string warningOfReferences(const Teuchos::ParameterList& section)
{
  bool any = false;
  for (auto item = section.begin(); item != section.end(); ++item)
  {
    if (!section.isSublist(section.name(item)))
      continue;
    any = true;
    if (!isTimeOfGrowth(section.sublist(section.name(item)).get<std::string>("Quantity")))
      return {};
  }
  return any ? std::string(
                   "Reference: none of the references will be compared, so that the run does not pass "
                   "(exit status 4): ") +
                   timesAreCounts
             : std::string();
}

std::string referencesAsText(const nlohmann::json& summary)
{
  std::string text;
  bool compared = false;
  for (const nlohmann::json& result : summary.value("references", nlohmann::json::array()))
  {
    text += comparison(result);
    compared = compared || !result.contains("left_out");
  }
  return text.empty() || compared ? text : text + "OUTSIDE  none of the references could be compared\n";
}

} // namespace Rhegma
