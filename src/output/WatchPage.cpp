#include "output/WatchPage.hpp"

#include "base/Numbers.hpp"
#include "base/OutputError.hpp"
#include "base/ShortNumber.hpp"
#include "files/TextFile.hpp"
#include "output/SampleFigures.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace Rhegma
{

namespace
{

constexpr const char* ended = "The run has ended.";
constexpr double secondsBetweenPages = 2.0;
constexpr int secondsToReload = 3;

double clockOfPages()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Whether a column is the energy release rate of a front by its J integral, in 3D the mean.
bool isRelease(const std::string& name)
{
  return name.size() > 4 && name.compare(name.size() - 4, 4, ".G_J") == 0;
}

/// The fields of a row of the history (RFC 4180).
std::vector<std::string> fieldsOf(const std::string& row)
{
  std::vector<std::string> all(1);
  bool inQuotes = false;
  for (const char c : row)
    if (c == '"')
      inQuotes = !inQuotes; // two of them in quotes are one, which no name of a plot needs
    else if (c == ',' && !inQuotes)
      all.emplace_back();
    else
      all.back() += c;
  return all;
}

/// Unit of a column of the table of last values, which has those of fronts and the energy balance; empty for
/// all others.
std::string unitOf(const std::string& name)
{
  static const std::map<std::string, std::string> ofFronts = {
      {"G_J", "J/m\u00b2"},  {"G_J_max", "J/m\u00b2"}, {"G_closure", "J/m\u00b2"},
      {"K_I", "Pa \u221am"}, {"K_II", "Pa \u221am"},   {"K_III", "Pa \u221am"},
      {"length", "m"},       {"speed", "m/s"}};
  const std::vector<std::string>& energies = energyNames();
  if (name == "residual" || std::find(energies.begin(), energies.end(), name) != energies.end())
    return "J";
  const std::size_t point = name.rfind('.');
  const auto found = point == std::string::npos ? ofFronts.end() : ofFronts.find(name.substr(point + 1));
  return found == ofFronts.end() ? std::string() : found->second;
}

bool isShown(const std::string& name) { return !unitOf(name).empty(); }

constexpr const char* styleOfPage =
    "<style>body{font:15px/1.4 sans-serif;color:#222;max-width:720px;margin:1em auto;padding:0 1em}"
    "h1{font-size:1.3em;margin:.2em 0}svg{width:100%;font-size:12px;fill:#444;display:block}"
    ".bar{background:#ddd;height:14px;border-radius:7px;overflow:hidden}.bar "
    "div{background:#0072B2;height:100%}"
    ".key{margin:.1em 0 1em;font-size:.85em}.fault{color:#c00}td{padding:0 1em 0 0}td+td{text-align:right}"
    "</style>";

} // namespace

WatchPage::WatchPage(const std::string& folder, const std::string& scene, const Progress& progress)
    : WatchPage(folder, scene, progress, clockOfPages)
{
}

WatchPage::WatchPage(const std::string& folder, const std::string& scene, const Progress& progress,
                     Clock clock)
    : folder_(folder),
      scene_(std::filesystem::path(scene).filename().string()),
      progress_(progress),
      clock_(std::move(clock)),
      written_(clock_()),
      releases_("Energy release rate of fronts", "J/m\u00b2"),
      energies_("Energies", "J")
{
  readHistory(folder + "/history.csv");
  write("The run goes on.", true);
}

void WatchPage::readHistory(const std::string& path)
{
  std::ifstream file(path);
  std::string text;
  if (!std::getline(file, text))
    return;
  const std::vector<std::string> names = fieldsOf(text);
  while (std::getline(file, text))
  {
    const std::vector<std::string> values = fieldsOf(text);
    if (values.size() != names.size())
      return; // the last row of a run that was cut off
    Row row;
    for (std::size_t c = 1; c < names.size(); ++c)
      row.emplace_back(names[c], std::strtod(values[c].c_str(), nullptr));
    sample(std::strtod(values[0].c_str(), nullptr), row);
  }
}

void WatchPage::sample(double time, const Row& row)
{
  const auto isEnergy = [](const std::string& name)
  { return isShown(name) && name.find('.') == std::string::npos; };
  const auto add = [&](SmallPlot& plot, const auto& chosen)
  {
    std::vector<std::string> names;
    std::vector<double> values;
    for (const auto& [name, value] : row)
      if (chosen(name))
      {
        names.push_back(name);
        values.push_back(value);
      }
    if (!plot.hasCurves())
      plot.setCurves(names);
    plot.add(time, values);
  };
  add(releases_, isRelease);
  add(energies_, isEnergy);
  last_.clear();
  for (const auto& column : row)
    if (isShown(column.first))
      last_.push_back(column);
  time_ = time;
}

void WatchPage::update()
{
  const double now = clock_();
  if (now - written_ < secondsBetweenPages)
    return;
  written_ = now;
  write("The run goes on.", true);
}

void WatchPage::finish(const std::string& failure) { write(failure.empty() ? ended : failure, false); }

void WatchPage::write(const std::string& status, bool goesOn)
{
  if (lost_)
    return;
  try
  {
    replaceFileUnsynced(folder_ + "/watch.html", page(status, goesOn));
  }
  catch (const OutputError&) // the run reports what it can't write itself
  {
    lost_ = true;
  }
}

std::string WatchPage::table() const
{
  if (last_.empty())
    return "<p>There is no sample yet.</p>";
  constexpr std::size_t most = 60;
  std::string text = "<table><caption>Last sample, t = " + readableTime(time_) + "</caption>";
  for (std::size_t k = 0; k < std::min(last_.size(), most); ++k)
    text += "<tr><td>" + escapedForHtml(last_[k].first) + "</td><td>" +
            (std::isfinite(last_[k].second) ? formatShort(last_[k].second) + " " + unitOf(last_[k].first)
                                            : std::string("-")) +
            "</td></tr>";
  text += "</table>";
  if (last_.size() > most)
    text += "<p>" + std::to_string(last_.size() - most) + " more values are in history.csv.</p>";
  return text;
}

std::string WatchPage::page(const std::string& status, bool goesOn) const
{
  // One that is at rest, or has done all of its steps, is complete before Final Time.
  const double done = status == ended ? 1.0 : std::min(progress_.done(), 1.0);
  const std::string percent = std::to_string(static_cast<int>(100.0 * done));
  std::string text =
      "<!DOCTYPE html>\n<!-- a run of rhegma -->\n<html lang=\"en\"><head><meta charset=\"utf-8\">";
  if (goesOn)
    text += "<meta http-equiv=\"refresh\" content=\"" + std::to_string(secondsToReload) + "\">";
  text += "<title>" + percent + " % " + escapedForHtml(scene_) + "</title>" + styleOfPage +
          "</head><body>\n<h1>" + escapedForHtml(scene_) + "</h1>\n<p" +
          (goesOn || status == ended ? "" : " class=\"fault\"") + ">" + escapedForHtml(status) +
          "</p>\n<div class=\"bar\"><div style=\"width:" + percent + "%\"></div></div>\n<p>" +
          escapedForHtml(progress_.text(goesOn)) + "</p>\n";
  const double end = std::max(progress_.finalTime(), time_);
  text += releases_.svg(end) + "\n" + energies_.svg(end) + "\n" + table() + "\n</body></html>\n";
  return text;
}

} // namespace Rhegma
