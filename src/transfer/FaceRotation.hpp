#pragma once
/// How far the faces of cracks have turned with the body, where the cells do not.

#include "geometry/Cross.hpp"
#include "state/CrackSet.hpp"

#include <cmath>
#include <vector>

namespace Rhegma
{

/// Rotation of the crack at its vertices from undeformed cells to the deformed body: that between the edges
/// of the simplices at a vertex before and after their displacement (CrackSet::carried). Both faces open away
/// from their middle, so that opening does not turn it.
template <int D>
struct FaceRotation
{
  View<double* [D]> vertex;   ///< [m]
  View<double* [D]> carried;  ///< [m]
  View<int* [D]> simplex;     ///< of CrackSet
  View<int*> starBegin, star; ///< of CrackSet

  /// \param cracks with displacements \param moved the displacements
  FaceRotation(const CrackSet<D>& cracks, const View<double* [D]>& moved)
      : vertex(cracks.vertex),
        carried(moved),
        simplex(cracks.simplex),
        starBegin(cracks.starBegin),
        star(cracks.star)
  {
  }

  /// The rotation at a vertex. \param v its row \param R becomes it, row by row
  KOKKOS_INLINE_FUNCTION void at(int v, double (&R)[D][D]) const
  {
    double sum[D][D] = {};
    for (int k = starBegin(v); k < starBegin(v + 1); ++k)
      add(star(k), sum);
    nearest(sum, R);
  }

  /// The normal of a simplex of a normal of undeformed cells. \param s the simplex \param n its normal there
  KOKKOS_INLINE_FUNCTION Vector<D> turned(int s, const Vector<D>& n) const
  {
    double sum[D][D] = {}, R[D][D];
    add(s, sum);
    nearest(sum, R);
    Vector<D> all{};
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        all[i] += R[i][j] * n[j];
    return all;
  }

private:
  /// Edge i of a simplex, before and after.
  KOKKOS_INLINE_FUNCTION Vector<D> edge(int s, int i, bool after) const
  {
    Vector<D> along;
    const int from = simplex(s, 0), to = simplex(s, i);
    for (int d = 0; d < D; ++d)
      along[d] = vertex(to, d) - vertex(from, d) + (after ? carried(to, d) - carried(from, d) : 0.0);
    return along;
  }

  /// Adds the products of the axes of a simplex after and before.
  KOKKOS_INLINE_FUNCTION void add(int s, double (&sum)[D][D]) const
  {
    Vector<D> axes[2][D];
    for (int after = 0; after < 2; ++after)
    {
      const Vector<D> along = edge(s, 1, after == 1);
      axes[after][0] = 1.0 / norm(along) * along;
      if constexpr (D == 2)
        axes[after][1] = {{-axes[after][0][1], axes[after][0][0]}};
      else
      {
        const Vector<D> area = cross(along, edge(s, 2, after == 1));
        axes[after][1] = 1.0 / norm(area) * area;
        axes[after][2] = cross(axes[after][0], axes[after][1]);
      }
    }
    for (int a = 0; a < D; ++a)
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
          sum[i][j] += axes[1][a][i] * axes[0][a][j];
  }

  /// The rotation nearest to a sum of rotations: in 2D its direction, in 3D by the mean of a matrix and its
  /// inverse transposed, over and over (Higham, SIAM J. Sci. Stat. Comput. 7 (1986) 1160).
  KOKKOS_INLINE_FUNCTION static void nearest(const double (&sum)[D][D], double (&R)[D][D])
  {
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        R[i][j] = sum[i][j];
    if constexpr (D == 2)
    {
      const double c = sum[0][0] + sum[1][1], s = sum[1][0] - sum[0][1], size = std::sqrt(c * c + s * s);
      R[0][0] = R[1][1] = size > 0.0 ? c / size : 1.0;
      R[1][0] = size > 0.0 ? s / size : 0.0;
      R[0][1] = -R[1][0];
    }
    else
      for (int turns = 0; turns < 12; ++turns)
      {
        double cofactor[D][D];
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j)
          {
            const int k = (i + 1) % D, l = (i + 2) % D, m = (j + 1) % D, n = (j + 2) % D;
            cofactor[i][j] = R[k][m] * R[l][n] - R[k][n] * R[l][m];
          }
        const double determinant =
            R[0][0] * cofactor[0][0] + R[0][1] * cofactor[0][1] + R[0][2] * cofactor[0][2];
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j)
            R[i][j] = 0.5 * (R[i][j] + cofactor[i][j] / determinant);
      }
  }
};

/// A rotation on the host, row by row.
template <int D>
struct Rotation
{
  double of[D][D]; ///< its components

  /// A vector of the deformed body in undeformed cells. \param v the vector
  Vector<D> back(const Vector<D>& v) const
  {
    Vector<D> turned{};
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        turned[i] += of[j][i] * v[j];
    return turned;
  }

  /// Its angle [rad].
  double angle() const
  {
    double trace = 0.0;
    for (int i = 0; i < D; ++i)
      trace += of[i][i];
    const double cosine = D == 2 ? 0.5 * trace : 0.5 * (trace - 1.0);
    return std::acos(std::fmin(1.0, std::fmax(-1.0, cosine)));
  }
};

/// The rotations of the crack at its vertices; none where the cells are not undeformed. \param cracks the
/// cracks
template <int D>
std::vector<Rotation<D>> rotationsOfFaces(const CrackSet<D>& cracks)
{
  const int count = static_cast<int>(cracks.carried.extent(0));
  const View<double * [D * D]> rows("rhegma::rotationsOfFaces", count);
  const FaceRotation<D> rotation(cracks, cracks.carried);
  Kokkos::parallel_for(
      "rhegma::rotationsOfFaces", Kokkos::RangePolicy<ExecSpace>(0, count), KOKKOS_LAMBDA(const int v) {
        double R[D][D];
        rotation.at(v, R);
        for (int k = 0; k < D * D; ++k)
          rows(v, k) = R[k / D][k % D];
      });
  const auto host = onHost(rows);
  std::vector<Rotation<D>> all(count);
  for (int v = 0; v < count; ++v)
    for (int k = 0; k < D * D; ++k)
      all[v].of[k / D][k % D] = host(v, k);
  return all;
}

/// Unit normals of the simplices in the deformed body: those of the cracks, turned with it where the cells
/// are undeformed. \param cracks the cracks
template <int D>
View<double* [D]> normalsInBody(const CrackSet<D>& cracks)
{
  if (cracks.carried.extent(0) == 0)
    return cracks.normal;
  const int count = static_cast<int>(cracks.simplex.extent(0));
  View<double* [D]> normals("rhegma::normalsInBody", count);
  const View<double* [D]> undeformed = cracks.normal;
  const FaceRotation<D> rotation(cracks, cracks.carried);
  Kokkos::parallel_for(
      "rhegma::normalsInBody", Kokkos::RangePolicy<ExecSpace>(0, count), KOKKOS_LAMBDA(const int s) {
        Vector<D> n;
        for (int d = 0; d < D; ++d)
          n[d] = undeformed(s, d);
        n = rotation.turned(s, n);
        for (int d = 0; d < D; ++d)
          normals(s, d) = n[d];
      });
  return normals;
}

} // namespace Rhegma
