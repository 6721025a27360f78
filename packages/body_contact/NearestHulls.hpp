#pragma once
/// The shortest way between the convex hulls of two sets of domains.

#include "base/Types.hpp"

namespace Rhegma::body_contact
{

/// Up to D + 1 points, and the point of their convex hull that is nearest to the origin.
template <int D>
struct NearestOfSimplex
{
  Vector<D> point[D + 1]; ///< the points
  int count = 0;          ///< their number

  /// Keeps the points whose hull has the nearest point inside. All subsets are tried, as they are few.
  /// \return that point
  KOKKOS_INLINE_FUNCTION Vector<D> reduce()
  {
    Vector<D> best{};
    double least = 1e300;
    int chosen = 0;
    for (int subset = 1; subset < (1 << count); ++subset)
    {
      Vector<D> nearest;
      if (!nearestOf(subset, nearest))
        continue;
      const double square = dot(nearest, nearest);
      // Of two subsets with the same point the smaller one comes first.
      if (square < least * (1.0 - 1e-14))
      {
        least = square;
        best = nearest;
        chosen = subset;
      }
    }
    int kept = 0;
    for (int k = 0; k < count; ++k)
      if ((chosen >> k & 1) != 0)
        point[kept++] = point[k];
    count = kept;
    return best;
  }

private:
  /// The nearest point of the plane through a subset, if it lies in the subset's hull.
  KOKKOS_INLINE_FUNCTION bool nearestOf(int subset, Vector<D>& nearest) const
  {
    int first = 0, edges = 0;
    while ((subset >> first & 1) == 0)
      ++first;
    Vector<D> edge[D];
    for (int k = first + 1; k < count; ++k)
      if ((subset >> k & 1) != 0)
      {
        if (edges == D)
          return false;
        edge[edges++] = point[k] - point[first];
      }
    double matrix[D][D], right[D];
    for (int i = 0; i < edges; ++i)
    {
      right[i] = -dot(edge[i], point[first]);
      for (int j = 0; j < edges; ++j)
        matrix[i][j] = dot(edge[i], edge[j]);
    }
    double largest = 0.0;
    for (int i = 0; i < edges; ++i)
      largest = std::fmax(largest, matrix[i][i]);
    for (int i = 0; i < edges; ++i) // symmetric and positive: no pivoting
    {
      if (!(matrix[i][i] > 1e-14 * largest))
        return false;
      for (int k = i + 1; k < edges; ++k)
      {
        const double factor = matrix[k][i] / matrix[i][i];
        for (int j = i; j < edges; ++j)
          matrix[k][j] -= factor * matrix[i][j];
        right[k] -= factor * right[i];
      }
    }
    double rest = 1.0;
    nearest = point[first];
    for (int i = edges - 1; i >= 0; --i)
    {
      for (int j = i + 1; j < edges; ++j)
        right[i] -= matrix[i][j] * right[j];
      right[i] /= matrix[i][i];
      if (!(right[i] >= 0.0))
        return false;
      rest -= right[i];
      nearest = nearest + right[i] * edge[i];
    }
    return rest >= 0.0;
  }
};

/// The shortest vector from the hull of one set to that of another one; zero where they overlap.
///
/// The algorithm of Gilbert, Johnson and Keerthi, IEEE J. Robotics and Automation 4 (1988) 193.
///
/// \param start any vector from a point of the first set to one of the second
/// \param nearest nearest(v) returns the vector from a point of the first set to one of the second whose
/// product with v is smallest
template <int D, class Nearest>
KOKKOS_INLINE_FUNCTION Vector<D> shortestBetweenHulls(const Vector<D>& start, const Nearest& nearest)
{
  constexpr int mostIterations = 40;
  // Of the square of the distance: the direction is then right to the root of it.
  constexpr double converged = 1e-13;
  NearestOfSimplex<D> simplex;
  Vector<D> shortest = start;
  for (int k = 0; k < mostIterations; ++k)
  {
    const double square = dot(shortest, shortest);
    const Vector<D> next = nearest(shortest);
    if (k > 0 && square - dot(shortest, next) <= converged * square)
      break;
    simplex.point[simplex.count++] = next;
    const Vector<D> closer = simplex.reduce();
    if (simplex.count > D) // the origin is inside
      return Vector<D>{};
    if (k > 0 && !(dot(closer, closer) < square)) // rounding
      break;
    shortest = closer;
  }
  return shortest;
}

} // namespace Rhegma::body_contact
