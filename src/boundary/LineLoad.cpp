#include "base/ReadList.hpp"
#include "boundary/BoundaryParts.hpp"

#include <stdexcept>

namespace Rhegma
{

namespace
{

template <int D>
PlacedLoad<D> place(const Teuchos::ParameterList& list, const Seeds<D>& seeds, const std::string& where,
                    bool around)
{
  const Profile profile =
      list.get<std::string>("Profile") == "Parabolic" ? Profile::Parabolic : Profile::Uniform;
  const Vector<D> from = readVector<D>(list, "From"), to = readVector<D>(list, "To");
  if (around && from[0] == 0.0 && to[0] == 0.0)
    throw std::invalid_argument(
        where + ": the line lies on the axis of revolution, so that it sweeps no area; write a "
                "Point Load, or a line away from the axis");
  return {lineLoad<D>(seeds, from, to, profile, where, around), readVector<D>(list, "Force")};
}

template <int D>
void addLineLoad(BoundaryParts<D>& parts, const Teuchos::ParameterList& list, const std::string& name)
{
  parts.loads.push_back(
      [=](const State<D>& state)
      {
        return readLoad<D>(list, state, name, list.get<std::string>("History"),
                           [around = state.method.axisymmetric](const auto&... of)
                           { return place<D>(of..., around); });
      });
}

void checkLineLoad(SectionChecks& checks, const Teuchos::ParameterList& boundary, const std::string& where)
{
  checks.different(boundary, "From", "To", where);
}

} // namespace

BoundaryType lineLoadBoundary()
{
  Section s("Line Load", "A force distributed over a straight line in a body. It moves with the body.");
  describeLoadedBody(s);
  s.realArray("From").unit("m").perAxis().meaning("One end of the line, in the undeformed body.");
  s.realArray("To").unit("m").perAxis().meaning("Other end of the line.");
  s.realArray("Force").unit("N").perAxis().meaning("Total force on the line.");
  s.choice("Profile", {"Uniform", "Parabolic"})
      .byDefault("Uniform")
      .meaning("Distribution along the line: uniform, or a parabola that is zero at both ends; in "
               "axisymmetric scenes per area of the surface that the line sweeps.");
  describeHistory(s);
  return {s, checkLineLoad, addLineLoad<2>, addLineLoad<3>, "", [](const Teuchos::ParameterList& list) {
            return BoundaryRegion{"", BoundaryRegion::Kind::Force, readPoint(list, "From"),
                                  readPoint(list, "To")};
          }};
}

} // namespace Rhegma
