#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "boundary/BoundaryParts.hpp"
#include "boundary/MirrorSide.hpp"

#include <cmath>
#include <stdexcept>

namespace Rhegma
{

namespace
{

template <int D>
TimedConstraint<D> readSymmetry(const Teuchos::ParameterList& list, State<D>& state, const std::string& name)
{
  const std::string where = "Boundaries > " + name;
  const Grid<D>& grid = state.mesh.grid;
  TimedConstraint<D> timed{{}, {}, TimeFunction::parse("0"), name};
  const int axis = list.get<std::string>("Axis")[0] - 'x';
  const double position = list.get<double>("Position");
  timed.reported = !(state.method.axisymmetric && axis == 0); // the axis is in each such scene
  const double slack = 1e-6 * grid.spacing;
  if (position < grid.lower[axis] - slack || position > grid.upper[axis] + slack)
    throw std::invalid_argument(where +
                                " > Position: the plane lies outside the domain, which reaches from " +
                                formatReal(grid.lower[axis]) + " to " + formatReal(grid.upper[axis]) +
                                " m along " + "xyz"[axis] + "; write a position between");
  const double cells = grid.inCells(position, axis), off = std::fabs(cells - std::round(cells));
  if (off > 1e-3)
    state.warnings.push_back(
        where + " > Position: the plane lies " + formatReal(off) +
        " cells away from the nearest plane of grid nodes, so the body meets its mirror image up to a cell "
        "too late; move the plane onto grid nodes, or move Domain > Lower Corner");
  const double huge = 1e300;
  for (int d = 0; d < D; ++d)
  {
    timed.constraint.lower[d] = -huge;
    timed.constraint.upper[d] = huge;
    timed.constraint.holds[d] = d == axis;
    timed.value[d] = 0.0;
  }
  // The plane and everything beyond it. The body lies on the side where the domain extends further, unless
  // the scene gives the side.
  if (mirrorIsBelow(list, grid.lower[axis], grid.upper[axis]))
    timed.constraint.upper[axis] = position + 1e-9 * grid.spacing;
  else
    timed.constraint.lower[axis] = position - 1e-9 * grid.spacing;
  return timed;
}

template <int D>
void addSymmetry(BoundaryParts<D>& parts, const Teuchos::ParameterList& list, const std::string& name)
{
  parts.supports.push_back([=](State<D>& state) { return readSymmetry<D>(list, state, name); });
}

BoundaryRegion mirrorPlaneOf(const Teuchos::ParameterList& list)
{
  BoundaryRegion plane{"", BoundaryRegion::Kind::Mirror, {}, {}, list.get<std::string>("Axis")};
  const int axis = plane.axes[0] - 'x';
  plane.from[axis] = plane.to[axis] = list.get<double>("Position");
  return plane;
}

void checkSymmetry(SectionChecks& checks, const Teuchos::ParameterList& boundary, const std::string& where)
{
  if (checks.dimension() == 2 && SceneValues::text(boundary, "Axis") == "z")
    checks.report(scenePath(where, "Axis"), "is z in a 2D scene; write x or y.");
}

} // namespace

BoundaryType symmetryBoundary()
{
  Section s("Symmetry", "A plane of symmetry: zero normal velocity, free sliding along the plane.");
  s.choice("Axis", {"x", "y", "z"}).meaning("Axis normal to the plane.");
  s.real("Position").unit("m").meaning("Coordinate of the plane on that axis.");
  s.choice("Side", {"Lower", "Upper"})
      .optional("the side of the nearer end of the domain")
      .meaning("Side of the plane that is the mirror image and holds no material.");
  return {s, checkSymmetry, addSymmetry<2>, addSymmetry<3>, "", mirrorPlaneOf};
}

} // namespace Rhegma
