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

void describeSurface(Section& s)
{
  describeLoadedBody(s);
  s.realArray("From").unit("m").onlyIn(2).length(2).meaning(
      "One end of a line on the surface of the undeformed body.");
  s.realArray("To").unit("m").onlyIn(2).length(2).meaning("Other end of the line.");
  s.realArray("Corner").unit("m").onlyIn(3).length(3).meaning(
      "One corner of a parallelogram on the surface of the undeformed body.");
  s.realArray("Edge 1").unit("m").onlyIn(3).length(3).meaning("Vector of its first edge from Corner.");
  s.realArray("Edge 2").unit("m").onlyIn(3).length(3).meaning("Vector of its second edge from Corner.");
}

void checkSurface(SectionChecks& checks, const Teuchos::ParameterList& list, const std::string& where)
{
  checks.surface(list, where);
}

void describeLoadedBody(Section& s) { s.text("Body").notEmpty().meaning("Name of the body."); }

} // namespace Rhegma
