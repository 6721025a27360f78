#include "transfer/FacePoints.hpp"

#include "transfer/Stencils.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Rhegma
{

namespace
{

/// Longest piece of crack that one point stands for, in cells.
constexpr double longestPiece = 0.5;

struct Place
{
  int segment, crack;
  double along, share, length;
  Vector<2> at;
};

std::vector<Place> places(const CrackSet<2>& cracks, double spacing)
{
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.vertex);
  const auto simplex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.simplex);
  const auto crackOf = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.crackOf);
  std::vector<Place> all;
  for (int s = 0; s < static_cast<int>(simplex.extent(0)); ++s)
  {
    const Vector<2> a{vertex(simplex(s, 0), 0), vertex(simplex(s, 0), 1)};
    const Vector<2> b{vertex(simplex(s, 1), 0), vertex(simplex(s, 1), 1)};
    const double length = norm(b - a);
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / (longestPiece * spacing) - 1e-6)));
    for (int i = 0; i < pieces; ++i)
    {
      const double along = (i + 0.5) / pieces;
      all.push_back({s, crackOf(s), along, 1.0 / pieces, length / pieces, a + along * (b - a)});
    }
  }
  return all;
}

/// Leaves a point out on both faces where one of them has no node to act on.
void leaveOutLonely(const StencilTable<2>& below, const StencilTable<2>& above, int count)
{
  Kokkos::parallel_for(
      "rhegma::leaveOutLonelyFaces", Kokkos::RangePolicy<ExecSpace>(0, count), KOKKOS_LAMBDA(const int k) {
        if (below.count(k) == 0 || above.count(k) == 0)
          below.count(k) = above.count(k) = 0;
      });
}

} // namespace

bool FacePoints::update(const State<2>& state)
{
  const int segments = static_cast<int>(state.cracks.simplex.extent(0));
  const bool anew = segments != segments_;
  if (anew)
    place(state.cracks, state.grid.spacing);
  segments_ = segments;
  follow(state.cracks);
  pointStencils(state, lower_, below, true);
  pointStencils(state, upper_, above, true);
  leaveOutLonely(below, above, count_);
  return anew;
}

void FacePoints::place(const CrackSet<2>& cracks, double spacing)
{
  const std::vector<Place> all = places(cracks, spacing);
  std::vector<Place> old(count_);
  if (count_ > 0)
  {
    const auto oldCrack = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, crack);
    const auto oldPosition = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, position);
    for (int k = 0; k < count_; ++k)
    {
      old[k].crack = oldCrack(k);
      old[k].at = {oldPosition(k, 0), oldPosition(k, 1)};
    }
  }
  count_ = static_cast<int>(all.size());
  crack = View<int*>("rhegma::facePointCrack", count_);
  length = View<double*>("rhegma::facePointLength", count_);
  currentLength = View<double*>("rhegma::facePointCurrentLength", count_);
  position = View<double* [2]>("rhegma::facePointPosition", count_);
  normal = View<double* [2]>("rhegma::facePointNormal", count_);
  separation = View<double*>("rhegma::facePointSeparation", count_);
  before = View<int*>("rhegma::facePointBefore", count_);
  segment_ = View<int*>("rhegma::facePointSegment", count_);
  along_ = View<double*>("rhegma::facePointAlong", count_);
  share_ = View<double*>("rhegma::facePointShare", count_);
  for (ObservedPoints<2>* face : {&lower_, &upper_})
  {
    face->count = count_;
    face->position = View<double* [2]>("rhegma::facePosition", count_);
    face->half = View<double* [2]>("rhegma::faceHalf", count_);
    face->side = View<int*>("rhegma::faceSide", count_);
  }
  const auto hostCrack = Kokkos::create_mirror_view(crack);
  const auto hostLength = Kokkos::create_mirror_view(length);
  const auto hostBefore = Kokkos::create_mirror_view(before);
  const auto hostSegment = Kokkos::create_mirror_view(segment_);
  const auto hostAlong = Kokkos::create_mirror_view(along_);
  const auto hostShare = Kokkos::create_mirror_view(share_);
  for (int k = 0; k < count_; ++k)
  {
    hostCrack(k) = all[k].crack;
    hostLength(k) = all[k].length;
    hostSegment(k) = all[k].segment;
    hostAlong(k) = all[k].along;
    hostShare(k) = all[k].share;
    hostBefore(k) = -1;
    double nearest = longestPiece * spacing;
    for (std::size_t o = 0; o < old.size(); ++o)
      if (old[o].crack == all[k].crack && norm(old[o].at - all[k].at) < nearest)
      {
        nearest = norm(old[o].at - all[k].at);
        hostBefore(k) = static_cast<int>(o);
      }
  }
  Kokkos::deep_copy(crack, hostCrack);
  Kokkos::deep_copy(length, hostLength);
  Kokkos::deep_copy(before, hostBefore);
  Kokkos::deep_copy(segment_, hostSegment);
  Kokkos::deep_copy(along_, hostAlong);
  Kokkos::deep_copy(share_, hostShare);
}

void FacePoints::follow(const CrackSet<2>& cracks)
{
  const FacePoints p = *this;
  const View<int*> segment = segment_;
  const View<double*> along = along_, share = share_;
  const ObservedPoints<2> lower = lower_, upper = upper_;
  const View<int* [2]> simplex = cracks.simplex;
  const View<double* [2]> vertex = cracks.vertex;
  const View<double* [2][2]> face = cracks.face;
  Kokkos::parallel_for(
      "rhegma::followFaces", Kokkos::RangePolicy<ExecSpace>(0, count_), KOKKOS_LAMBDA(const int k) {
        const int a = simplex(segment(k), 0), b = simplex(segment(k), 1);
        const Vector<2> t{vertex(b, 0) - vertex(a, 0), vertex(b, 1) - vertex(a, 1)};
        const double now = norm(t);
        const Vector<2> n{-t[1] / now, t[0] / now};
        double apart = 0.0;
        for (int d = 0; d < 2; ++d)
          apart += n[d] * ((1.0 - along(k)) * (face(a, 1, d) - face(a, 0, d)) +
                           along(k) * (face(b, 1, d) - face(b, 0, d)));
        p.separation(k) = apart;
        p.currentLength(k) = share(k) * now;
        lower.side(k) = -(p.crack(k) + 1);
        upper.side(k) = p.crack(k) + 1;
        for (int d = 0; d < 2; ++d)
        {
          p.normal(k, d) = n[d];
          p.position(k, d) = vertex(a, d) + along(k) * t[d];
          lower.position(k, d) = p.position(k, d) - 0.5 * apart * n[d];
          upper.position(k, d) = p.position(k, d) + 0.5 * apart * n[d];
        }
      });
}

} // namespace Rhegma
