#pragma once
/// What a user may try whose run is unstable.

#include <string>

namespace Rhegma
{

/// The words "an unstable step: try ..." without an end. \param subcycledLevels of the state: how many levels
/// take substeps of their own
inline std::string unstableStep(int subcycledLevels)
{
  return std::string("the time step is unstable; try a smaller Time > CFL") +
         (subcycledLevels > 0 ? ", fewer Sub-Cycling > Levels" : "");
}

} // namespace Rhegma
