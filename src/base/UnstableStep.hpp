#pragma once
/// Advice for an unstable run.

#include <string>

namespace Rhegma
{

/// The text "an unstable step: try ..." without a full stop. \param subcycledLevels number of levels of the
/// state that take substeps
inline std::string unstableStep(int subcycledLevels)
{
  return std::string("the time step is unstable; try a smaller Time > CFL") +
         (subcycledLevels > 0 ? ", fewer Sub-Cycling > Levels" : "");
}

} // namespace Rhegma
