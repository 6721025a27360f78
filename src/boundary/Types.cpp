#include "boundary/BoundaryParts.hpp"

namespace Rhegma
{

std::vector<BoundaryType> builtInBoundaryTypes()
{
#define RHEGMA_MAKE(name) BoundaryTypes::name(),
  return {RHEGMA_BOUNDARY_TYPES(RHEGMA_MAKE)};
#undef RHEGMA_MAKE
}

void describeHistory(Section& s)
{
  s.timeFunction("History").byDefault("1").meaning(
      "Factor on the value as a function of time: an expression of t or a table \"0:0, 1e-3:5\".");
}

void describeLoadedBody(Section& s) { s.text("Body").notEmpty().meaning("Name of the loaded body."); }

} // namespace Rhegma
