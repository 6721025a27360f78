#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "boundary/BoundaryParts.hpp"

#include <cmath>
#include <set>
#include <stdexcept>

namespace Rhegma
{

namespace
{

using SceneValues::text;
using Teuchos::ParameterList;

/// The rows of nodes next to a box along the axes along which it contains none, such as "y = 0.02 m"; empty
/// if it contains a node.
template <int D>
std::string missedRows(const Grid<D>& grid, const Vector<D>& lower, const Vector<D>& upper)
{
  std::string rows;
  for (int d = 0; d < D; ++d)
  {
    const double from = std::max(lower[d], grid.lower[d]), to = std::min(upper[d], grid.upper[d]);
    if (std::ceil(grid.inCells(from, d) - 1e-9) <= grid.inCells(to, d) + 1e-9)
      continue;
    const double first = std::ceil(grid.inCells(grid.lower[d], d) - 1e-9),
                 last = std::floor(grid.inCells(grid.upper[d], d) + 1e-9),
                 row = std::round(grid.inCells(0.5 * (lower[d] + upper[d]), d));
    const double x = grid.origin[d] + grid.spacing * std::min(std::max(row, first), last);
    rows += (rows.empty() ? "" : " and ") + std::string(1, "xyz"[d]) + " = " + formatReal(x) + " m";
  }
  return rows;
}

template <int D>
TimedConstraint<D> readVelocity(const Teuchos::ParameterList& list, const State<D>& state,
                                const std::string& name)
{
  const std::string where = "Boundaries > " + name;
  const Grid<D>& grid = state.mesh.grid;
  TimedConstraint<D> timed{{}, {}, TimeFunction::parse(list.get<std::string>("History")), name};
  timed.constraint.lower = readVector<D>(list, "Lower Corner");
  timed.constraint.upper = readVector<D>(list, "Upper Corner");
  timed.constraint.outside = list.get<std::string>("Nodes") == "Outside";
  const std::string boxMotion = list.get<std::string>("Box Motion");
  timed.gridMoves = boxMotion == "With Grid";
  if (timed.gridMoves && state.method.totalLagrangian)
    throw std::invalid_argument(where +
                                " > Box Motion: cells of the undeformed body do not move, and the box "
                                "holds the same material throughout; leave it out, or write Domain > "
                                "Formulation = Updated Lagrangian");
  // Nodes on the rim count as held whatever the rounding, which grows where box and grid move.
  const double least = timed.gridMoves ? 1e-6 : 1e-9;
  const double rim = (timed.constraint.outside ? -least : least) * grid.spacing;
  for (int d = 0; d < D; ++d)
  {
    timed.constraint.lower[d] -= rim;
    timed.constraint.upper[d] += rim;
    timed.constraint.holds[d] = false;
    timed.value[d] = 0.0;
  }
  if (const std::string rows = missedRows(grid, timed.constraint.lower, timed.constraint.upper);
      !timed.constraint.outside && !rows.empty())
    throw std::invalid_argument(where +
                                ": the box contains no grid node inside the domain, so nothing is "
                                "prescribed; the nearest row of nodes is at " +
                                rows + ", which the box must contain");
  for (const char letter : list.get<std::string>("Components"))
    if (letter >= 'x' && letter < 'x' + D)
      timed.constraint.holds[letter - 'x'] = true;
  if (list.isParameter("Value"))
    timed.value = readVector<D>(list, "Value");
  else
  {
    timed.field = PositionFunction::parse(list.get<std::string>("Field"), D);
    setFieldAtNodes(timed, state);
  }
  const bool moves = boxMoves(timed, boxMotion, state); // and the box contains particles
  timed.boxMoves = moves && !state.method.totalLagrangian;
  timed.leftBehind = boxMotion == "Automatic" && leavesBox(timed, state);
  timed.lag = timed.gridMoves || timed.constraint.outside ? 0.0 : 0.5 * grid.spacing;
  return timed;
}

template <int D>
void addVelocity(BoundaryParts<D>& parts, const Teuchos::ParameterList& list, const std::string& name)
{
  parts.supports.push_back([=](State<D>& state) { return readVelocity<D>(list, state, name); });
}

BoundaryRegion heldBoxOf(const ParameterList& list)
{
  using Kind = BoundaryRegion::Kind;
  return {"", list.get<std::string>("Nodes") == "Outside" ? Kind::HeldOutside : Kind::Held,
          readPoint(list, "Lower Corner"), readPoint(list, "Upper Corner"),
          list.get<std::string>("Components")};
}

void checkComponents(SectionChecks& checks, const ParameterList& boundary, const std::string& where)
{
  const std::string letters = text(boundary, "Components");
  const std::string axes = checks.dimension() == 2 ? "xy" : "xyz";
  std::set<char> seen;
  bool good = !letters.empty() || !boundary.isParameter("Components");
  for (const char letter : letters)
    good = good && axes.find(letter) != std::string::npos && seen.insert(letter).second;
  if (!good)
    checks.report(scenePath(where, "Components"),
                  "is \"" + letters + "\"; write each axis once, such as \"" + axes + "\" or \"y\".");
}

void checkField(SectionChecks& checks, const ParameterList& boundary, const std::string& where)
{
  if (!boundary.isParameter("Field"))
    return;
  try
  {
    PositionFunction::parse(text(boundary, "Field"), checks.dimension());
  }
  catch (const std::invalid_argument& error)
  {
    checks.report(scenePath(where, "Field"), error.what());
  }
}

void checkVelocity(SectionChecks& checks, const ParameterList& boundary, const std::string& where)
{
  checks.corners(boundary, where, true);
  checkComponents(checks, boundary, where);
  checkField(checks, boundary, where);
  const std::string motion = text(boundary, "Box Motion");
  if (boundary.isParameter("Field") && (motion == "With Material" || motion == "With Grid"))
    checks.report(scenePath(where, "Box Motion"),
                  "is \"" + motion +
                      "\", but the box can't follow a Field, whose velocity differs from node to node; write "
                      "Value instead of Field, or set Box Motion to Fixed.");
}

} // namespace

BoundaryType velocityBoundary()
{
  Section s("Velocity", "Prescribes the velocity of all grid nodes in a box.");
  s.realArray("Lower Corner").unit("m").perAxis().meaning("Corner of the box with the smallest coordinates.");
  s.realArray("Upper Corner").unit("m").perAxis().meaning("Corner of the box with the largest coordinates.");
  s.text("Components")
      .byDefault("xy", "xyz")
      .meaning("Axes along which the velocity is prescribed, such as \"y\" or \"xy\". Other axes are free.");
  s.choice("Nodes", {"Inside", "Outside"})
      .byDefault("Inside")
      .meaning("Which nodes are prescribed: those inside the box or those outside it. Nodes on the edge of "
               "the box belong to both.");
  s.choice("Box Motion", {"Automatic", "Fixed", "With Material", "With Grid"})
      .byDefault("Automatic")
      .meaning(
          "Whether the box moves. Fixed: it holds the nodes of a fixed region, through which material may "
          "flow. With Material: it moves with the prescribed velocity, along the axes in Components, and "
          "goes "
          "on holding the same part of the body; at the start it must contain particles. With Grid: the "
          "same, and "
          "all cells and the domain move, too, so that the same nodes are held throughout; without it stress "
          "alternates from particle to particle near a box that moves by more than about half a cell. "
          "Automatic: With Material where Value is not zero along such an axis and the box contains "
          "particles; else Fixed.");
  s.realArray("Value").unit("m/s").perAxis().optional().meaning(
      "The velocity, the same at all nodes. Axes that are not in Components are ignored.");
  s.text("Field").unit("m/s").notEmpty().optional().meaning(
      "The velocity as a function of the nodal position x, y, z: one expression for each axis, such as "
      "\"2*x, -y\". Common terms are defined first, as in \"r = sqrt(x*x + y*y); x / r, y / r\".");
  s.exactlyOneOf({"Value", "Field"});
  describeHistory(s).scalesRate("Value");
  return {s, checkVelocity, addVelocity<2>, addVelocity<3>, "", heldBoxOf};
}

} // namespace Rhegma
