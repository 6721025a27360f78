#include "base/ReadList.hpp"
#include "boundary/BoundaryParts.hpp"

namespace Rhegma
{

namespace
{

template <int D>
PlacedLoad<D> position(const Teuchos::ParameterList& list, const Seeds<D>& seeds, const std::string& where)
{
  return {pointLoad<D>(seeds, readVector<D>(list, "Point"), where), readVector<D>(list, "Force")};
}

template <int D>
void addPointLoad(BoundaryParts<D>& parts, const Teuchos::ParameterList& list, const std::string& name)
{
  parts.loads.push_back(
      [=](const State<D>& state)
      { return readLoad<D>(list, state, name, list.get<std::string>("History"), position<D>); });
}

} // namespace

BoundaryType pointLoadBoundary()
{
  Section s("Point Load", "A force at a material point of a body. The force moves with this point.");
  describeLoadedBody(s);
  s.realArray("Point").unit("m").perAxis().meaning("Position of the loaded point in the undeformed body.");
  s.realArray("Force").unit("N").perAxis().meaning(
      "The force vector. In axisymmetric scenes the sum over the circle on which the point lies; the first "
      "component is the sum of what pushes outwards.");
  describeHistory(s);
  return {s,
          {},
          addPointLoad<2>,
          addPointLoad<3>,
          "",
          [](const Teuchos::ParameterList& list)
          {
            return BoundaryRegion{"", BoundaryRegion::Kind::Force, readPoint(list, "Point"),
                                  readPoint(list, "Point")};
          }};
}

} // namespace Rhegma
