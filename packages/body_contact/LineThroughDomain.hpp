#pragma once
/// Where a line runs through the domain of a particle.

#include "base/Types.hpp"

namespace Rhegma::body_contact
{

/// The part of a line that lies in a parallelogram or parallelepiped, from `first` to `last` along the line
/// [m].
struct PartOfLine
{
  double first = -1e300;
  double last = 1e300;

  /// Whether there is such a part.
  KOKKOS_INLINE_FUNCTION bool any() const { return first <= last; }
};

/// The vector whose product with edge k is 1 and with the other edges 0 [1/m].
template <int D>
KOKKOS_INLINE_FUNCTION Vector<D> acrossEdge(const Vector<D> (&edges)[D], int k)
{
  Vector<D> across;
  if constexpr (D == 2)
  {
    const Vector<D>& other = edges[1 - k];
    across = {other[1], -other[0]};
  }
  else
  {
    const Vector<D>&a = edges[(k + 1) % 3], &b = edges[(k + 2) % 3];
    across = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  return (1.0 / dot(across, edges[k])) * across;
}

/// The part of the line start + t n in the domain with these edge vectors about the origin.
///
/// \param start a point of the line [m] \param n unit vector along it \param size of the domain; 1: as the
/// edges give it
template <int D>
KOKKOS_INLINE_FUNCTION PartOfLine partOfLine(const Vector<D> (&edges)[D], const Vector<D>& start,
                                             const Vector<D>& n, double size)
{
  constexpr double parallel = 1e-12; // the line and a pair of faces
  PartOfLine part;
  for (int k = 0; k < D; ++k)
  {
    const Vector<D> across = acrossEdge<D>(edges, k);
    const double at = dot(across, start), slope = dot(across, n), half = 0.5 * size;
    if (std::fabs(slope) <= parallel * norm(across))
    {
      if (std::fabs(at) > half)
        return {1.0, -1.0};
      continue;
    }
    const double one = (-half - at) / slope, other = (half - at) / slope;
    part.first = std::fmax(part.first, std::fmin(one, other));
    part.last = std::fmin(part.last, std::fmax(one, other));
  }
  return part;
}

} // namespace Rhegma::body_contact
