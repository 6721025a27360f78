#pragma once
/// How far the faces of a crack have overlapped during a run.

#include "state/State.hpp"

#include <string>
#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::cracks
{

/// The largest overlap of the faces of a crack, in the samples of a run.
struct OverlapRecord
{
  double overlap = 0.0; ///< along the normals of its vertices [m]
  double time = 0.0;    ///< of that [s]
  double noise = 0.0;   ///< by how much single vertices may overlap at that time without meaning [m]
  double opening = 0.0; ///< largest opening, while the crack has a front [m]
};

/// Adds the present state to the record of each crack; cracks are those of the state, in their order.
/// Collective, if there are ranks.
template <int D>
void recordOverlaps(const State<D>& state, std::vector<OverlapRecord>& records);

/// A warning if the faces of a crack without contact have overlapped by more than three times the noise and
/// by more than a tenth of its largest opening, and if none of its fronts has grown by more than a fiftieth
/// of a cell; else nothing.
///
/// K of a front is proportional to the opening next to it, so that an overlap of a tenth of the largest
/// opening makes a K_I of minus a tenth of the largest. Once all fronts have ended the opening is that of
/// pieces that move apart, and says nothing of K. The noise is the strain next to the crack times the size of
/// a cell: faces follow single nodes. Contact leaves up to a fiftieth of a cell, too (unit test PennyGrowth);
/// waves that come before the load of a crack make less, unless its growth begins with them. \param advice
/// what to write for contact (contactAdvice)
template <int D>
std::string warningOfRecord(const State<D>& state, int crack, const OverlapRecord& record,
                            const std::string& advice);

void storeOverlaps(std::vector<OverlapRecord>& records, Archive& archive);

} // namespace Rhegma::cracks
