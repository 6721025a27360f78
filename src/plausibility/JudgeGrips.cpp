#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "geometry/NearBoxes.hpp"
#include "grid/LeafEdge.hpp"
#include "plan/BoundaryType.hpp"
#include "plausibility/Judges.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma
{

namespace
{

/// How far the nodes that hold a face may lie outside of it [cells]. Measured on a strip of 32 cells a width
/// whose held faces lie 0.25, 0.5, 0.75 cells inside the nodes: forces are 9, 4, 9 % too low.
constexpr double mostOutside = 0.1;

/// Whether the faces of a body's bounds are its own.
bool isBoxAlongAxes(const Teuchos::ParameterList& body)
{
  return body.get<std::string>("Shape") == "Box" &&
         !(body.isType<double>("Rotation") && body.get<double>("Rotation") != 0.0);
}

/// A face of a body's bounds.
struct Face
{
  int axis;
  bool upper;
};

/// Where a support's nodes begin along the normal of a face that it holds all over, going outwards [m]; not a
/// number where it does not hold the face.
template <int D>
double holdsFrom(const BoundaryRegion& support, const BodyMeasure<D>& body, const Face& face, double slack)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const int a = face.axis;
  const double at = face.upper ? body.upper[a] : body.lower[a];
  if (support.kind == BoundaryRegion::Kind::HeldOutside)
  {
    const double begin = face.upper ? support.to[a] : support.from[a];
    return (face.upper ? at >= begin - slack : at <= begin + slack) ? begin : none;
  }
  for (int d = 0; d < D; ++d)
    if (d == a ? support.from[d] > at + slack || support.to[d] < at - slack
               : support.from[d] > body.lower[d] + slack || support.to[d] < body.upper[d] - slack)
      return none;
  return face.upper ? support.from[a] : support.to[a];
}

/// How far outside of a face the first of these nodes lie [cells], where they do.
template <int D>
double cellsOutside(const BodyMeasure<D>& body, const Face& face, double begin, const Branches<D>& refined,
                    double& cell)
{
  const int a = face.axis;
  Vector<D> middle = 0.5 * (body.lower + body.upper);
  const double at = face.upper ? body.upper[a] : body.lower[a];
  middle[a] = at;
  cell = leafEdge(refined, middle);
  const double inCells = (begin - refined.grid().origin[a]) / cell;
  const double node = face.upper ? std::ceil(inCells - 1e-6) : std::floor(inCells + 1e-6);
  const double position = refined.grid().origin[a] + node * cell;
  return (face.upper ? position - at : at - position) / cell;
}

} // namespace

template <int D>
Messages judgeGrips(const JudgedScene<D>& judged)
{
  Messages messages;
  std::vector<Geometry::Bounds<D>> bounds;
  for (const BodyMeasure<D>& body : judged.bodies)
    bounds.push_back({body.lower, body.upper});
  const Geometry::NearBoxes<D> boxes(bounds);
  const Branches<D> refined = refinedCells(judged.state);
  const Teuchos::ParameterList& bodies = judged.scene.sublist("Bodies");
  const double slack = 1e-6 * judged.state.mesh.grid.spacing;
  for (const BoundaryRegion& support : boundaryRegions(judged.scene))
  {
    const bool outside = support.kind == BoundaryRegion::Kind::HeldOutside;
    if (!outside && support.kind != BoundaryRegion::Kind::Held)
      continue;
    Geometry::Bounds<D> reach = Geometry::emptyBounds<D>();
    for (int d = 0; d < D; ++d)
    {
      reach.lower[d] = outside ? judged.state.mesh.grid.lower[d] : support.from[d];
      reach.upper[d] = outside ? judged.state.mesh.grid.upper[d] : support.to[d];
    }
    for (const int b : boxes.near(reach, slack))
    {
      const BodyMeasure<D>& body = judged.bodies[b];
      if (!isBoxAlongAxes(bodies.sublist(body.name)))
        continue;
      for (int f = 0; f < 2 * D; ++f)
      {
        const Face face{f / 2, f % 2 == 1};
        const double begin = holdsFrom<D>(support, body, face, slack);
        double cell = 0.0;
        if (std::isnan(begin))
          continue;
        const double off = cellsOutside<D>(body, face, begin, refined, cell);
        if (off <= mostOutside)
          continue;
        messages.push_back("Boundaries > " + support.name + ": the first nodes that it holds at the " +
                           (face.upper ? "upper " : "lower ") + "xyz"[face.axis] + " face of Bodies > " +
                           body.name + " lie " + formatShort(off) + " cells (of " + readableLength(cell) +
                           ") outside of it, so that it hardly holds the face, and forces, G and K can be "
                           "wrong by 10 % or more: move the lines of cells onto the face (Domain > Lower "
                           "Corner, Cell Size), or let the box begin a cell inside the body");
        break;
      }
    }
  }
  return messages;
}

template Messages judgeGrips(const JudgedScene<2>&);
template Messages judgeGrips(const JudgedScene<3>&);

} // namespace Rhegma
