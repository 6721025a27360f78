#include "cracks/FacesAhead.hpp"

#include "cracks/CrackGeometry.hpp"

#include <cmath>

namespace Rhegma::cracks
{

namespace
{

/// The nearest of the triangles that are of a crack, or of all but that.
std::pair<double, int> nearest(const CrackSet<3>& set, int crack, bool others, const Vector<3>& x)
{
  const CrackSight<3> sight(set, 1.0);
  using Nearest = Kokkos::MinLoc<double, int>;
  Nearest::value_type found{};
  Kokkos::parallel_reduce(
      "rhegma::cracks::nearestFace", Kokkos::RangePolicy<ExecSpace>(0, sight.simplex.extent(0)),
      KOKKOS_LAMBDA(const int s, Nearest::value_type& best) {
        const double square = (sight.crackOf(s) != crack) == others ? sight.square(s, x) : 1e300;
        if (square < best.val)
        {
          best.val = square;
          best.loc = sight.crackOf(s);
        }
      },
      Nearest(found));
  return {std::sqrt(found.val), found.loc};
}

/// Cells ahead of a front from where it is looked at, and the part of the way back within which faces are
/// others than those behind the front.
constexpr double ahead = 2.0, nearer = 0.5;

} // namespace

std::pair<double, int> nearestOther(const CrackSet<3>& set, int own, const Vector<3>& x)
{
  return set.cracks.size() == 1 ? std::pair<double, int>{1e300, -1} : nearest(set, own, true, x);
}

bool meetsItself(const CrackSet<3>& set, int own, const Vector<3>& x, const Vector<3>& direction, double cell)
{
  const double way = ahead * cell;
  return nearest(set, own, false, x + way * direction).first < nearer * way;
}

} // namespace Rhegma::cracks
