#pragma once
/// How far the faces of a crack have overlapped during a run.

#include "cracks/Opening.hpp"
#include "state/State.hpp"

#include <string>
#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::cracks
{

/// The largest overlap of the faces of a crack in some samples of a run, and what it is judged by.
struct LargestOverlap
{
  double overlap = 0.0; ///< along the normals of its vertices [m]
  double time = 0.0;    ///< of that [s]
  double noise = 0.0;   ///< by how much single vertices may overlap at that time without meaning [m]
  double opening = 0.0; ///< largest opening in the samples, while the crack has a front [m]
};

/// Of one crack.
struct OverlapRecord
{
  LargestOverlap ever;         ///< in all samples
  LargestOverlap beforeGrowth; ///< in those before any of its fronts has grown
};

/// Adds the present state to the record of each crack; cracks are those of the state, in their order.
/// Collective. \param openings of the cracks now (openingsOf) \param touching contact keeps faces apart, so
/// that no overlap is warned of: the noise is not measured
template <int D>
void recordOverlaps(const State<D>& state, const std::vector<Opening>& openings, bool touching,
                    std::vector<OverlapRecord>& records);

/// A warning if the faces of a crack without contact have overlapped by more than three times the noise and
/// by more than a tenth of the largest opening; else nothing. Overlaps of a crack that has not grown count
/// from a fiftieth of a cell on. Those before growth are compared with the opening before growth alone: a
/// crack opens further as it grows, which does not mend how it started.
///
/// K of a front is proportional to the opening next to it, so that an overlap of a tenth of the largest
/// opening makes a K_I of minus a tenth of the largest. Once all fronts have ended the opening is that of
/// pieces that move apart, and says nothing of K. The noise is the strain next to the crack times the size of
/// a cell: faces follow single nodes. A fiftieth of a cell is what contact leaves, too (unit test
/// PennyGrowth). \param advice what to write for contact (contactAdvice)
template <int D>
std::string warningOfRecord(const State<D>& state, int crack, const OverlapRecord& record,
                            const std::string& advice);

void storeOverlaps(std::vector<OverlapRecord>& records, Archive& archive);

} // namespace Rhegma::cracks
