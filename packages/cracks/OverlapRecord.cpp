#include "cracks/OverlapRecord.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "cracks/Opening.hpp"
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

} // namespace

template <int D>
void recordOverlaps(const State<D>& state, std::vector<OverlapRecord>& records)
{
  records.resize(state.cracks.cracks.size());
  for (std::size_t c = 0; c < records.size(); ++c)
  {
    OverlapRecord& record = records[c];
    const int crack = static_cast<int>(c);
    const Opening opening = measureOpening(state.cracks, crack);
    if (hasFront(state.cracks, crack))
      record.opening = std::max(record.opening, opening.largest);
    const bool grew = -opening.smallest > std::max(record.overlap, least * state.mesh.grid.spacing);
    if (!grew && !state.ranks.many())
      continue; // without a look at all particles
    const double noise = noiseOfFaces(state, crack);
    if (grew)
      record = {-opening.smallest, state.clock.time, noise, record.opening};
  }
}

template <int D>
std::string warningOfRecord(const State<D>& state, int crack, const OverlapRecord& record,
                            const std::string& advice)
{
  if (!(record.overlap > ofNoise * record.noise && record.overlap > ofOpening * record.opening))
    return {};
  const double cells = record.overlap / state.mesh.grid.spacing;
  const auto& fronts = state.cracks.fronts;
  const bool grown =
      std::any_of(fronts.begin(), fronts.end(),
                  [&](const CrackFront<D>& front) { return front.crack == crack && front.grown; });
  if (!grown && !(cells > ofCells))
    return {};
  return "crack " + state.cracks.cracks[crack].name + ": its faces overlapped by up to " +
         readableLength(record.overlap) + " (" + formatShort(cells) + " cells" +
         (record.opening > record.overlap
              ? ", " + formatShort(std::round(100.0 * record.overlap / record.opening)) +
                    " % of its largest opening"
              : "") +
         ") at t = " + readableTime(record.time) +
         ", because the scene has no contact; G and K were wrong then, and so is growth that began then; " +
         advice;
}

void storeOverlaps(std::vector<OverlapRecord>& records, Archive& archive)
{
  constexpr std::size_t width = 4;
  std::vector<double> rows;
  for (const OverlapRecord& r : records)
    rows.insert(rows.end(), {r.overlap, r.time, r.noise, r.opening});
  archive("overlaps", rows, width);
  records.clear();
  for (std::size_t k = 0; k + width <= rows.size(); k += width)
    records.push_back({rows[k], rows[k + 1], rows[k + 2], rows[k + 3]});
}

template void recordOverlaps(const State<2>&, std::vector<OverlapRecord>&);
template void recordOverlaps(const State<3>&, std::vector<OverlapRecord>&);
template std::string warningOfRecord(const State<2>&, int, const OverlapRecord&, const std::string&);
template std::string warningOfRecord(const State<3>&, int, const OverlapRecord&, const std::string&);

} // namespace Rhegma::cracks
