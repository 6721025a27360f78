#include "surface/EdgeFlips.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Rhegma::surface
{

namespace
{

/// Positive where d lies inside of the circle through a, b, c (counter-clockwise).
double insideCircle(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d)
{
  const Vector<2> p = a - d, q = b - d, r = c - d;
  return dot(p, p) * (q[0] * r[1] - r[0] * q[1]) - dot(q, q) * (p[0] * r[1] - r[0] * p[1]) +
         dot(r, r) * (p[0] * q[1] - q[0] * p[1]);
}

} // namespace

EdgeFlips::EdgeFlips(Triangulation& mesh, double spacing)
    : mesh_(mesh),
      tinyArea_(1e-9 * spacing * spacing),
      tinyCircle_(1e-9 * std::pow(spacing, 4)),
      beyond_(findNeighbours(mesh.triangles)),
      candidates_(mesh.triangles.size()),
      changed_(mesh.triangles.size(), 0)
{
  std::iota(candidates_.begin(), candidates_.end(), 0);
}

bool EdgeFlips::round()
{
  std::vector<int> flipped;
  for (const int t : candidates_)
    for (int i = 0; i < 3 && changed_[t] == 0; ++i)
    {
      const int u = beyond_[t][i];
      if (u < t || changed_[u] != 0)
        continue;
      const std::array<int, 3>& own = mesh_.triangles[t];
      const int c = own[i], a = own[(i + 1) % 3], b = own[(i + 2) % 3];
      int d = -1;
      for (const int v : mesh_.triangles[u])
        d = v != a && v != b ? v : d;
      if (!isWorthIt(a, b, c, d))
        continue;
      flip(t, i, u);
      changed_[t] = changed_[u] = 1;
      flipped.push_back(t);
      flipped.push_back(u);
    }
  candidates_ = flipped;
  for (const int t : flipped)
  {
    changed_[t] = 0;
    for (const int u : beyond_[t])
      if (u >= 0)
        candidates_.push_back(u);
  }
  std::sort(candidates_.begin(), candidates_.end());
  candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
  return !flipped.empty();
}

bool EdgeFlips::isWorthIt(int a, int b, int c, int d) const
{
  const std::vector<Vector<2>>& x = mesh_.points;
  return insideCircle(x[a], x[b], x[c], x[d]) > tinyCircle_ && doubleArea(x[a], x[d], x[c]) > tinyArea_ &&
         doubleArea(x[d], x[b], x[c]) > tinyArea_;
}

void EdgeFlips::flip(int t, int i, int u)
{
  const std::array<int, 3> own = mesh_.triangles[t], other = mesh_.triangles[u];
  const int c = own[i], a = own[(i + 1) % 3], b = own[(i + 2) % 3];
  int d = -1, oppositeA = -1, oppositeB = -1; // beyond the edges d-b and a-d
  for (int k = 0; k < 3; ++k)
    if (other[k] == a)
      oppositeA = beyond_[u][k];
    else if (other[k] == b)
      oppositeB = beyond_[u][k];
    else
      d = other[k];
  const int alongA = beyond_[t][(i + 2) % 3], alongB = beyond_[t][(i + 1) % 3]; // beyond c-a and b-c
  mesh_.triangles[t] = {a, d, c};
  mesh_.triangles[u] = {d, b, c};
  beyond_[t] = {u, alongA, oppositeB};
  beyond_[u] = {alongB, t, oppositeA};
  putBeyond(oppositeB, u, t);
  putBeyond(alongB, t, u);
}

void EdgeFlips::putBeyond(int t, int old, int now)
{
  if (t >= 0)
    std::replace(beyond_[t].begin(), beyond_[t].end(), old, now);
}

} // namespace Rhegma::surface
