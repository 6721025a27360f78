#include "thermal/LibraryRanges.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "scene/MaterialLibrary.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma::thermal
{

namespace
{

constexpr const char* fromLibrary = "Material From Library";

/// "250 to 500 K" as a range; none of another text.
std::optional<std::pair<double, double>> kelvins(const std::string& text)
{
  const std::size_t unit = text.rfind(" K");
  return unit == std::string::npos ? std::nullopt : Rhegma::rangeOf(text.substr(0, unit));
}

} // namespace

double LibraryRange::outside() const
{
  return std::max(valid.lowest - had.lowest, had.highest - valid.highest);
}

std::string LibraryRange::warning() const
{
  constexpr double noticeable = 1.0; // K
  if (said > 0.0 && !(outside() > said + noticeable))
    return {};
  const double below = valid.lowest - had.lowest, above = had.highest - valid.highest;
  if (!(had.highest > 0.0) || !(below > 0.0 || above > 0.0))
    return {};
  const bool cold = below > above;
  const double at = cold ? lowestAt : highestAt;
  return where + ": the constants of " + name + " in the library are valid from " +
         formatShort(valid.lowest) + " to " + formatShort(valid.highest) + " K, and its bodies " +
         (at > 0.0 ? "came to " : "start at ") + formatShort(cold ? had.lowest : had.highest) + " K" +
         (at > 0.0 ? " at t = " + readableTime(at) : "") +
         "; temperatures are absolute (K); where they are right, write constants for them, as numbers or "
         "tables of temperature";
}

std::vector<LibraryRange> libraryRanges(const Teuchos::ParameterList& materials)
{
  std::vector<LibraryRange> ranges;
  int number = 0;
  for (const std::string& name : sublistNames(materials))
  {
    const Teuchos::ParameterList& list = materials.sublist(name);
    const LibraryMaterial* const found = list.isType<std::string>(fromLibrary)
                                             ? materialLibrary().find(list.get<std::string>(fromLibrary))
                                             : nullptr;
    if (found != nullptr)
      if (const auto valid = kelvins(found->temperature))
        ranges.push_back({std::string("Materials > ").append(name),
                          found->name,
                          number,
                          {valid->first, valid->second},
                          {}});
    ++number;
  }
  return ranges;
}

template <int D>
void sampleRanges(const State<D>& state, std::vector<LibraryRange>& ranges)
{
  if (ranges.empty())
    return; // without a look at all particles
  const std::vector<TemperatureRange> here = temperaturesOf(state);
  for (LibraryRange& range : ranges)
  {
    const TemperatureRange& own = here[range.material];
    const double lowest = -state.ranks.max(-own.lowest), highest = state.ranks.max(own.highest);
    if (lowest < range.had.lowest)
      range.lowestAt = state.clock.time;
    if (highest > range.had.highest)
      range.highestAt = state.clock.time;
    if (highest > 0.0)
    {
      range.had.include(lowest);
      range.had.include(highest);
    }
  }
}

template <int D>
void warnOfRangesAtStart(State<D>& state, std::vector<LibraryRange>& ranges)
{
  std::vector<LibraryRange> start = ranges;
  sampleRanges(state, start);
  for (std::size_t k = 0; k < ranges.size(); ++k)
    if (const std::string warning = start[k].warning(); !warning.empty())
    {
      ranges[k].said = start[k].outside();
      state.warnings.push_back(warning);
    }
}

void storeRanges(std::vector<LibraryRange>& ranges, Archive& archive)
{
  std::vector<double> rows;
  for (const LibraryRange& r : ranges)
    rows.insert(rows.end(), {r.had.lowest, r.lowestAt, r.had.highest, r.highestAt});
  archive("library temperatures", rows, 4);
  for (std::size_t k = 0; k < ranges.size() && 4 * k + 3 < rows.size(); ++k)
  {
    ranges[k].had = {rows[4 * k], rows[4 * k + 2]};
    ranges[k].lowestAt = rows[4 * k + 1];
    ranges[k].highestAt = rows[4 * k + 3];
  }
}

template void sampleRanges(const State<2>&, std::vector<LibraryRange>&);
template void sampleRanges(const State<3>&, std::vector<LibraryRange>&);
template void warnOfRangesAtStart(State<2>&, std::vector<LibraryRange>&);
template void warnOfRangesAtStart(State<3>&, std::vector<LibraryRange>&);

} // namespace Rhegma::thermal
