#pragma once
/// Shape functions along one axis: linear, and linear averaged over a particle's box (GIMP).

#include "base/Types.hpp"

namespace Rhegma
{

enum class ShapeKind
{
  Linear,
  Gimp
};

/// Where the gradients are taken that give the shear strain of a particle and the nodal force of its shear
/// stress.
enum class ShearStrain
{
  AtParticles,  ///< where normal strains are
  AtCellCentres ///< at the centre of the cell in the direction of the displacement's component
};

/// Nodes that a particle touches along one axis.
template <ShapeKind S>
constexpr int nodesPerAxis = S == ShapeKind::Linear ? 2 : 3;

/// Weights and slopes of the nodes first, first + 1, ... along one axis. Weights add up to one, slopes to
/// zero.
template <int N>
struct AxisStencil
{
  int first;
  double weight[N];
  double slope[N]; ///< [1/cell]
};

/// Linear functions at a point. \param at coordinate in cells
KOKKOS_INLINE_FUNCTION AxisStencil<2> linearStencil(double at)
{
  const int cell = static_cast<int>(at);
  const double s = at - cell;
  return {cell, {1.0 - s, s}, {-1.0, 1.0}};
}

/// Linear functions averaged over a box of half width up to half a cell (uniform GIMP).
///
/// The average over each of the two cells that the box may touch is the function's value at the middle of the
/// overlap, because a linear function averages to its value there. Source: Bardenhagen and Kober, CMES 5
/// (2004) 477; the form by overlaps carries over to cells of any size. \param at coordinate in cells \param
/// half half width in cells, in (0, 1/2]
KOKKOS_INLINE_FUNCTION AxisStencil<3> gimpStencil(double at, double half)
{
  const double low = at - half;
  const int cell = static_cast<int>(low);
  const double begin = low - cell;                               // in [0, 1)
  const double end = begin + 2.0 * half;                         // in (0, 2)
  const double over = end > 1.0 ? end - 1.0 : 0.0;               // length in the second cell
  const double fraction = over / (2.0 * half);                   // of the box in the second cell
  const double middle = 0.5 * (begin + (end > 1.0 ? 1.0 : end)); // of the overlap with the first cell
  const double beyond = 0.5 * over; // middle of the overlap with the second, from its lower node
  const double rest = 1.0 - fraction;
  return {cell,
          {rest * (1.0 - middle), rest * middle + fraction * (1.0 - beyond), fraction * beyond},
          {-rest, rest - fraction, fraction}};
}

/// Value of the function of node k of an axis at the centre of the cell, averaged over the cells that the
/// point or box touches: half of the fraction of it that lies in the cells next to the node, which the slopes
/// give. \param first, last slopes of the first and the last of the N nodes [1/cell]
template <int N>
KOKKOS_FORCEINLINE_FUNCTION double centreWeight(double first, double last, int k)
{
  return k == 0 ? -0.5 * first : k == N - 1 ? 0.5 * last : 0.5;
}

/// The stencil of kind S.
template <ShapeKind S>
KOKKOS_INLINE_FUNCTION AxisStencil<nodesPerAxis<S>> axisStencil(double at, double half)
{
  if constexpr (S == ShapeKind::Linear)
    return linearStencil(at);
  else
    return gimpStencil(at, half);
}

} // namespace Rhegma
