#pragma once
/// Ranks that give up a solution together.

#include "base/StopRequest.hpp"
#include "parallel/Ranks.hpp"

namespace Rhegma
{

/// Throws StopRequested on all ranks if one of them has been asked to stop: a signal may reach some only.
/// Collective.
inline void stopTogetherIfRequested(const Ranks& ranks)
{
  if (ranks.max(stopRequested() ? 1.0 : 0.0) > 0.0)
    throw StopRequested("the process was asked to stop");
}

} // namespace Rhegma
