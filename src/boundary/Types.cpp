#include "boundary/BoundaryParts.hpp"

#include <algorithm>

namespace Rhegma
{

std::vector<BoundaryType> builtInBoundaryTypes()
{
#define RHEGMA_MAKE(name) name##Boundary(),
  return {RHEGMA_BOUNDARY_TYPES(RHEGMA_MAKE)};
#undef RHEGMA_MAKE
}

ParameterBuilder describeHistory(Section& s)
{
  return s.timeFunction("History").byDefault("1").meaning(
      "Factor on the value as a function of time: an expression of t or a table \"0:0, 1e-3:5\".");
}

Vector<3> readPoint(const Teuchos::ParameterList& list, const std::string& name)
{
  const auto& values = list.get<Teuchos::Array<double>>(name);
  Vector<3> point{};
  std::copy_n(values.begin(), std::min<int>(3, values.size()), point.c);
  return point;
}

void describeLoadedBody(Section& s) { s.text("Body").notEmpty().meaning("Name of the body."); }

} // namespace Rhegma
