#include "contact/FacePatches.hpp"

#include "transfer/LocalSpacing.hpp"

#include <cmath>

namespace Rhegma::contact
{

namespace
{

/// A point on the faces.
template <int D>
struct Place
{
  Vector<D> at, normal;
  int crack;
};

template <int D>
std::vector<Place<D>> placesOf(const FacePoints<D>& points)
{
  const auto position = onHost(points.position), normal = onHost(points.normal);
  const auto crack = onHost(points.crack);
  std::vector<Place<D>> all(points.count());
  for (int k = 0; k < points.count(); ++k)
  {
    all[k].crack = crack(k);
    for (int d = 0; d < D; ++d)
    {
      all[k].at[d] = position(k, d);
      all[k].normal[d] = normal(k, d);
    }
  }
  return all;
}

template <int D>
bool isAlike(const Place<D>& a, const Place<D>& b)
{
  return a.crack == b.crack && dot(a.normal, b.normal) > patchAlignment;
}

} // namespace

template <int D>
std::vector<int> findPatches(const State<D>& state, const FacePoints<D>& points)
{
  const std::vector<Place<D>> all = placesOf(points);
  std::vector<int> middles, patch(all.size(), -1);
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    const double apart = patchSpacing * spacingAt(state, all[k].at);
    bool isNew = true;
    for (const int m : middles)
      isNew = isNew && !(isAlike(all[k], all[m]) && norm(all[k].at - all[m].at) < (1.0 - 1e-9) * apart);
    if (isNew)
      middles.push_back(static_cast<int>(k));
  }
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    double nearest = 1e300;
    for (std::size_t m = 0; m < middles.size(); ++m)
      if (const double away = norm(all[k].at - all[middles[m]].at);
          isAlike(all[k], all[middles[m]]) && away < (1.0 - 1e-9) * nearest)
      {
        nearest = away;
        patch[k] = static_cast<int>(m);
      }
  }
  return patch;
}

template std::vector<int> findPatches(const State<2>&, const FacePoints<2>&);
template std::vector<int> findPatches(const State<3>&, const FacePoints<3>&);

} // namespace Rhegma::contact
