#pragma once
/// How the cost of a scene changes while its cells do, by a run of the same scene with larger cells.

#include "parallel/Ranks.hpp"

#include <Teuchos_ParameterList.hpp>

#include <optional>
#include <vector>

namespace Rhegma::program
{

/// What the rest of a run takes for a time, as a multiple of what a part of its beginning took.
struct Growth
{
  double steps = 1.0; ///< number of steps
  double work = 1.0;  ///< particles times steps
};

/// A part of a run [s].
struct Part
{
  double from = 0.0, to = 0.0;
};

/// Steps and work of a run so far, as functions of its time.
class WorkCurve
{
public:
  /// After a step. \param time reached [s], later than before \param work particles times steps
  void add(double time, double steps, double work);
  /// Time of the last step [s].
  double end() const { return points_.back().time; }
  /// From a part to the rest. Where the curve ends before the run, it goes on as in its last third.
  /// \param end of the run, later than that of the part [s] \return none where the curve has too few steps
  std::optional<Growth> growth(const Part& part, double end) const;

private:
  struct Point
  {
    double time = 0.0, steps = 0.0, work = 0.0;
  };
  Point at(double time) const;

  std::vector<Point> points_{Point{}};
};

/// Whether the rest takes much more or less than the part.
bool isNoticeable(const Growth& growth);

/// Takes steps of a scene with cells of twice the size, counts them and their particles. Collective.
/// \param scene validated \param part of the run that was measured with its own cells
/// \param seconds of the processor that this may take
/// \return none where the scene with such cells is refused, fails or takes too long
std::optional<Growth> growthByCoarseRun(const Teuchos::ParameterList& scene, const Part& part,
                                        const Ranks& ranks, double seconds);

} // namespace Rhegma::program
