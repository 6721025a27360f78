#include "cracks/OverlapRecord.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "cracks/Overlap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Rhegma::cracks
{

namespace
{

/// Least overlap that is reported, over the noise and over the largest opening.
constexpr double ofNoise = 3.0, ofOpening = 0.1;
/// Overlap that contact leaves, too [cells]: that of a crack that does not grow is no more of a fault.
constexpr double ofCells = 0.02;
/// Overlap that is recorded at all: more than rounding [cells].
constexpr double least = 1e-9;

/// Whether an overlap is a fault of the scene. \param grown whether a front of the crack has grown
bool isFault(const LargestOverlap& record, bool grown, double cell)
{
  return record.overlap > ofNoise * record.noise && record.overlap > ofOpening * record.opening &&
         (grown || record.overlap > ofCells * cell);
}

template <int D>
bool hasGrown(const CrackSet<D>& cracks, int crack)
{
  return std::any_of(cracks.fronts.begin(), cracks.fronts.end(),
                     [&](const CrackFront<D>& front) { return front.crack == crack && front.grown; });
}

} // namespace

template <int D>
void recordOverlaps(const State<D>& state, const std::vector<Opening>& openings, bool touching,
                    std::vector<OverlapRecord>& records)
{
  const std::size_t count = state.cracks.cracks.size();
  records.resize(count);
  std::vector<double> rises(count); // 1 where the overlap is larger than ever
  for (std::size_t c = 0; c < count; ++c)
    rises[c] = -openings[c].smallest > std::max(records[c].ever.overlap, least * state.mesh.grid.spacing)
                   ? 1.0
                   : 0.0;
  if (!touching && state.ranks.many() && count > 0)
    state.ranks.max(rises.data(), static_cast<int>(count)); // all look at their particles, or none does
  for (std::size_t c = 0; c < count; ++c)
  {
    const int crack = static_cast<int>(c);
    LargestOverlap& ever = records[c].ever;
    if (hasFront(state.cracks, crack))
      ever.opening = std::max(ever.opening, openings[c].largest);
    if (rises[c] > 0.0)
    {
      ever.noise = touching ? 0.0 : noiseOfFaces(state, crack);
      ever.overlap = std::max(ever.overlap, -openings[c].smallest);
      ever.time = state.clock.time;
    }
    if (!hasGrown(state.cracks, crack))
      records[c].beforeGrowth = ever;
  }
}

template <int D>
std::string warningOfRecord(const State<D>& state, int crack, const OverlapRecord& record,
                            const std::string& advice)
{
  const double cell = state.mesh.grid.spacing;
  const bool grown = hasGrown(state.cracks, crack), always = isFault(record.ever, grown, cell);
  if (!always && !(grown && isFault(record.beforeGrowth, grown, cell)))
    return {};
  const LargestOverlap& worst = always ? record.ever : record.beforeGrowth;
  return "crack " + state.cracks.cracks[crack].name + ": its faces overlapped by up to " +
         readableLength(worst.overlap) + " (" + formatShort(worst.overlap / cell) + " cells" +
         (worst.opening > worst.overlap
              ? ", " + formatShort(std::round(100.0 * worst.overlap / worst.opening)) +
                    " % of its largest opening" + (always ? "" : " before it grew")
              : "") +
         ") at t = " + readableTime(worst.time) + (always ? "" : ", before it grew") +
         ", because the scene has no contact; G and K were wrong then, and so is growth that began then; " +
         advice;
}

void storeOverlaps(std::vector<OverlapRecord>& records, Archive& archive)
{
  constexpr std::size_t width = 8;
  std::vector<double> rows;
  for (const OverlapRecord& record : records)
    for (const LargestOverlap& r : {record.ever, record.beforeGrowth})
      rows.insert(rows.end(), {r.overlap, r.time, r.noise, r.opening});
  archive("overlaps", rows, width);
  records.clear();
  const auto read = [&](std::size_t k) {
    return LargestOverlap{rows[k], rows[k + 1], rows[k + 2], rows[k + 3]};
  };
  for (std::size_t k = 0; k + width <= rows.size(); k += width)
    records.push_back({read(k), read(k + width / 2)});
}

template void recordOverlaps(const State<2>&, const std::vector<Opening>&, bool, std::vector<OverlapRecord>&);
template void recordOverlaps(const State<3>&, const std::vector<Opening>&, bool, std::vector<OverlapRecord>&);
template std::string warningOfRecord(const State<2>&, int, const OverlapRecord&, const std::string&);
template std::string warningOfRecord(const State<3>&, int, const OverlapRecord&, const std::string&);

} // namespace Rhegma::cracks
