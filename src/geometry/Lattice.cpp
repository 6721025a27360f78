#include "geometry/Lattice.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::Geometry
{

namespace
{

/// Bounds of the whole shape in the base shape's own coordinates; exact where nothing is added.
template <int D>
Bounds<D> reach(const Shape<D>& shape)
{
  const Part<D>& base = shape.base();
  Bounds<D> result = base.ownBounds();
  for (const auto& part : shape.parts())
    if (&part != &base && part.operation == Operation::Add)
      for (const auto& corner : part.bounds().corners())
        result.include(base.frame.toOwn(corner));
  return result;
}

/// Whether own coordinates are those of space.
template <int D>
bool isAlongAxes(const Frame<D>& frame)
{
  bool found = true;
  for (int d = 0; d < D; ++d)
    found = found && frame.axes[d][d] == 1.0;
  return found;
}

} // namespace

template <int D>
Lattice<D> makeLattice(const Shape<D>& shape, double edge, const std::optional<Vector<D>>& node)
{
  const Bounds<D> base = shape.base().ownBounds();
  const Bounds<D> all = reach(shape);
  Lattice<D> lattice;
  lattice.origin = base.lower;
  for (int d = 0; d < D; ++d)
  {
    // A part that ends on a lattice line must not get an additional row because of rounding.
    const double slack = 1.0e-9;
    if (node && isAlongAxes(shape.base().frame))
    {
      lattice.edge[d] = edge;
      lattice.origin[d] = (*node)[d];
      lattice.first[d] = std::floor((all.lower[d] - (*node)[d]) / edge + slack);
      lattice.count[d] = std::ceil((all.upper[d] - (*node)[d]) / edge - slack) - lattice.first[d];
      continue;
    }
    const double length = base.upper[d] - base.lower[d];
    const double across = std::max(1.0, std::round(length / edge));
    lattice.edge[d] = length / across;
    lattice.first[d] = std::floor((all.lower[d] - base.lower[d]) / lattice.edge[d] + slack);
    const double last = std::ceil((all.upper[d] - base.lower[d]) / lattice.edge[d] - slack);
    lattice.count[d] = last - lattice.first[d];
  }
  return lattice;
}

template Lattice<2> makeLattice(const Shape<2>&, double, const std::optional<Vector<2>>&);
template Lattice<3> makeLattice(const Shape<3>&, double, const std::optional<Vector<3>>&);

} // namespace Rhegma::Geometry
