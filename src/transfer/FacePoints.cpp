#include "transfer/FacePoints.hpp"

#include "archive/Archive.hpp"
#include "geometry/Cross.hpp"
#include "state/Subdomain.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <type_traits>
#include <vector>

namespace Rhegma
{

namespace
{

/// Longest piece of crack that one point stands for, in cells.
constexpr double longestPiece = 0.5;

template <int D>
struct FixedPoint
{
  int simplex, crack;
  double weight[D], fraction, size;
  Vector<D> at;
};

/// Middles of the equal pieces of a simplex whose edges are cut into n.
std::vector<std::array<double, 2>> middles(std::integral_constant<int, 2>, int n)
{
  std::vector<std::array<double, 2>> all;
  all.reserve(n);
  for (int i = 0; i < n; ++i)
    all.push_back({1.0 - (i + 0.5) / n, (i + 0.5) / n});
  return all;
}

std::vector<std::array<double, 3>> middles(std::integral_constant<int, 3>, int n)
{
  std::vector<std::array<double, 3>> all;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n - i; ++j)
      for (const double third : {1.0 / 3.0, 2.0 / 3.0}) // upright pieces and those between them
        if (third < 0.5 || j + 1 < n - i)
        {
          const double b = (i + third) / n, c = (j + third) / n;
          all.push_back({1.0 - b - c, b, c});
        }
  return all;
}

KOKKOS_INLINE_FUNCTION Vector<2> sizedNormal(const Vector<2> (&corner)[2])
{
  return {corner[0][1] - corner[1][1], corner[1][0] - corner[0][0]};
}

KOKKOS_INLINE_FUNCTION Vector<3> sizedNormal(const Vector<3> (&corner)[3])
{
  return 0.5 * cross(corner[1] - corner[0], corner[2] - corner[0]);
}

template <int D>
std::vector<FixedPoint<D>> positions(const CrackSet<D>& cracks, double spacing)
{
  const auto vertex = onHost(cracks.vertex);
  const auto simplex = onHost(cracks.simplex);
  const auto crackOf = onHost(cracks.crackOf);
  std::vector<FixedPoint<D>> all;
  for (int s = 0; s < static_cast<int>(simplex.extent(0)); ++s)
  {
    Vector<D> corner[D];
    for (int i = 0; i < D; ++i)
      for (int d = 0; d < D; ++d)
        corner[i][d] = vertex(simplex(s, i), d);
    double longest = 0.0;
    for (int i = 0; i < D; ++i)
      longest = std::max(longest, norm(corner[(i + 1) % D] - corner[i]));
    const int n = std::max(1, static_cast<int>(std::ceil(longest / (longestPiece * spacing) - 1e-6)));
    const auto weights = middles(std::integral_constant<int, D>{}, n);
    const double size = norm(sizedNormal(corner));
    for (const std::array<double, D>& weight : weights)
    {
      FixedPoint<D> point;
      point.simplex = s;
      point.crack = crackOf(s);
      point.fraction = 1.0 / double(weights.size());
      point.size = size * point.fraction;
      point.at = Vector<D>{};
      for (int i = 0; i < D; ++i)
      {
        point.weight[i] = weight[i];
        point.at = point.at + weight[i] * corner[i];
      }
      all.push_back(point);
    }
  }
  return all;
}

/// Finds the nearest of some positions on the same crack.
template <int D>
class PositionBins
{
public:
  PositionBins(const std::vector<FixedPoint<D>>& all, double reach) : all_(all), reach_(reach)
  {
    for (std::size_t o = 0; o < all.size(); ++o)
      bins_[binOf(all[o])].push_back(static_cast<int>(o));
  }

  /// \return -1 where none is nearer than `reach`
  int nearest(const FixedPoint<D>& to) const
  {
    int found = -1;
    double shortest = reach_;
    const Bin middle = binOf(to);
    for (int k = 0; k < (D == 2 ? 9 : 27); ++k)
    {
      Bin bin = middle;
      for (int d = 0, rest = k; d < D; ++d, rest /= 3)
        bin[d] += rest % 3 - 1;
      const auto at = bins_.find(bin);
      if (at == bins_.end())
        continue;
      for (const int o : at->second)
      {
        const double distance = norm(all_[o].at - to.at);
        // The first of equally near positions, independent of the order of bins.
        if (distance < shortest || (distance == shortest && found >= 0 && o < found))
        {
          shortest = distance;
          found = o;
        }
      }
    }
    return found;
  }

private:
  using Bin = std::array<long, D + 1>; ///< along each axis, and the crack
  Bin binOf(const FixedPoint<D>& point) const
  {
    Bin bin;
    for (int d = 0; d < D; ++d)
      bin[d] = std::lround(point.at[d] / reach_);
    bin[D] = point.crack;
    return bin;
  }
  const std::vector<FixedPoint<D>>& all_;
  double reach_;
  std::map<Bin, std::vector<int>> bins_;
};

/// Opening at a point divided by linear interpolation: behind a front it is proportional to the root of the
/// distance (Irwin, J. Appl. Mech. 24 (1957) 361), and a simplex at the front has only its end values.
template <int D>
KOKKOS_INLINE_FUNCTION double frontShape(const View<int* [D]>& neighbour, const View<double* [D]>& weight,
                                         int simplex, int k)
{
  double distance = 1.0; // from the nearest facet at a front, over that of the vertex opposite to it
  for (int i = 0; i < D; ++i)
    if (neighbour(simplex, i) == facet::front && weight(k, i) < distance)
      distance = weight(k, i);
  return 1.0 / std::sqrt(distance);
}

/// Faces closer than this, in smallest cells, get stencils at the middle between them, so that both faces of
/// a closed crack belong to the same rank. No force is moved by more than half of it.
constexpr double nearlyClosed = 1e-3;

/// Marks the faces that have nodes with mass on this rank.
template <int D>
void findReached(const StencilTable<D>& below, const StencilTable<D>& above, int count,
                 const View<double*>& reached)
{
  Kokkos::parallel_for(
      "rhegma::findReached", Kokkos::RangePolicy<ExecSpace>(0, count), KOKKOS_LAMBDA(const int k) {
        reached(2 * k) = below.count(k) > 0 ? 1.0 : 0.0;
        reached(2 * k + 1) = above.count(k) > 0 ? 1.0 : 0.0;
      });
}

/// Leaves a point out on both faces where one of them has no node to act on.
template <int D>
void leaveOutOneSided(const View<double*>& reached, const StencilTable<D>& below,
                      const StencilTable<D>& above, const View<int*>& acts)
{
  Kokkos::parallel_for(
      "rhegma::leaveOutOneSided", Kokkos::RangePolicy<ExecSpace>(0, acts.extent(0)),
      KOKKOS_LAMBDA(const int k) {
        acts(k) = reached(2 * k) > 0.0 && reached(2 * k + 1) > 0.0 ? 1 : 0;
        if (acts(k) == 0)
          below.count(k) = above.count(k) = 0;
      });
}

} // namespace

template <int D>
bool FacePoints<D>::update(const State<D>& state)
{
  const int simplices = static_cast<int>(state.cracks.simplex.extent(0));
  const double spacing = state.mesh.smallestSpacing();
  double required = 0.0; // grows with every advance, also one that only stretches triangles
  for (const CrackFront<D>& front : state.cracks.fronts)
    required += front.budget.required;
  const bool anew = simplices != simplices_ || required != required_ || spacing != spacing_;
  if (anew)
    place(state.cracks, spacing);
  simplices_ = simplices;
  required_ = required;
  spacing_ = spacing;
  moveWithCracks(state.cracks, state.method.totalLagrangian);
  pointStencils(state, lower_, below, true);
  pointStencils(state, upper_, above, true);
  findReached(below, above, count_, reached_);
  sumParts(state, reached_);
  leaveOutOneSided(reached_, below, above, acts);
  return anew;
}

template <int D>
void FacePoints<D>::place(const CrackSet<D>& cracks, double spacing)
{
  const std::vector<FixedPoint<D>> all = positions(cracks, spacing);
  std::vector<FixedPoint<D>> old(count_);
  if (count_ > 0)
  {
    const auto oldCrack = onHost(crack);
    const auto oldPosition = onHost(position);
    for (int k = 0; k < count_; ++k)
    {
      old[k].crack = oldCrack(k);
      for (int d = 0; d < D; ++d)
        old[k].at[d] = oldPosition(k, d);
    }
  }
  // Corresponding points of pieces of different size are at most half the longer piece apart.
  const double reach = longestPiece * std::max(spacing, spacing_);
  const PositionBins<D> earlier(old, reach), now(all, reach);
  reserveRows(static_cast<int>(all.size()));
  after = View<int*>("rhegma::facePointAfter", old.size());
  const auto hostCrack = Kokkos::create_mirror_view(crack);
  const auto hostSize = Kokkos::create_mirror_view(size);
  const auto hostBefore = Kokkos::create_mirror_view(before);
  const auto hostAfter = Kokkos::create_mirror_view(after);
  const auto hostSimplex = Kokkos::create_mirror_view(simplex_);
  const auto hostWeight = Kokkos::create_mirror_view(weight_);
  const auto hostFraction = Kokkos::create_mirror_view(fraction_);
  for (int k = 0; k < count_; ++k)
  {
    hostCrack(k) = all[k].crack;
    hostSize(k) = all[k].size;
    hostSimplex(k) = all[k].simplex;
    for (int i = 0; i < D; ++i)
      hostWeight(k, i) = all[k].weight[i];
    hostFraction(k) = all[k].fraction;
    hostBefore(k) = earlier.nearest(all[k]);
  }
  for (std::size_t o = 0; o < old.size(); ++o)
    hostAfter(o) = now.nearest(old[o]);
  Kokkos::deep_copy(crack, hostCrack);
  Kokkos::deep_copy(size, hostSize);
  Kokkos::deep_copy(before, hostBefore);
  Kokkos::deep_copy(after, hostAfter);
  Kokkos::deep_copy(simplex_, hostSimplex);
  Kokkos::deep_copy(weight_, hostWeight);
  Kokkos::deep_copy(fraction_, hostFraction);
}

template <int D>
void FacePoints<D>::reserveRows(int number)
{
  count_ = number;
  crack = View<int*>("rhegma::facePointCrack", count_);
  size = View<double*>("rhegma::facePointSize", count_);
  currentSize = View<double*>("rhegma::facePointCurrentSize", count_);
  position = View<double* [D]>("rhegma::facePointPosition", count_);
  normal = View<double* [D]>("rhegma::facePointNormal", count_);
  edge = View<double* [D]>("rhegma::facePointEdge", count_);
  separation = View<double*>("rhegma::facePointSeparation", count_);
  before = View<int*>("rhegma::facePointBefore", count_);
  simplex_ = View<int*>("rhegma::facePointSimplex", count_);
  weight_ = View<double* [D]>("rhegma::facePointWeight", count_);
  fraction_ = View<double*>("rhegma::facePointFraction", count_);
  acts = View<int*>("rhegma::facePointActs", count_);
  reached_ = View<double*>("rhegma::facePointReached", 2 * count_);
  for (ObservedPoints<D>* face : {&lower_, &upper_})
  {
    face->count = count_;
    face->onAllRanks = true;
    face->position = View<double* [D]>("rhegma::facePosition", count_);
    face->half = View<double* [D]>("rhegma::faceHalf", count_);
    face->side = View<int*>("rhegma::faceSide", count_);
  }
}

template <int D>
void FacePoints<D>::serialize(Archive& archive)
{
  int number = count_;
  archive("count", number);
  if (archive.loads())
    reserveRows(number);
  archive("crack", crack);
  archive("size", size);
  archive("position", position);
  archive("before", before);
  archive("simplex", simplex_);
  archive("weight", weight_);
  archive("fraction", fraction_);
  archive("simplices", simplices_);
  archive("required", required_);
  archive("spacing", spacing_);
}

template <int D>
void FacePoints<D>::moveWithCracks(const CrackSet<D>& cracks, bool inCells)
{
  const FacePoints p = *this;
  const View<int*> simplexOf = simplex_;
  const View<double* [D]> weight = weight_;
  const View<double*> fraction = fraction_;
  const ObservedPoints<D> lower = lower_, upper = upper_;
  const View<int* [D]> simplex = cracks.simplex;
  const View<double* [D]> vertex = cracks.vertex;
  const View<double* [2][D]> face = cracks.face;
  const View<double* [D]> carried = cracks.carried; // of vertices that do not move with the body
  const bool moved = carried.extent(0) > 0;
  const View<int* [D]> neighbour = cracks.neighbour;
  const double near = nearlyClosed * spacing_;
  Kokkos::parallel_for(
      "rhegma::moveFacePoints", Kokkos::RangePolicy<ExecSpace>(0, count_), KOKKOS_LAMBDA(const int k) {
        Vector<D> corner[D], undeformed[D], at{}, jump{};
        for (int i = 0; i < D; ++i)
        {
          const int v = simplex(simplexOf(k), i);
          for (int d = 0; d < D; ++d)
          {
            undeformed[i][d] = vertex(v, d);
            corner[i][d] = vertex(v, d) + (moved ? carried(v, d) : 0.0);
            at[d] += weight(k, i) * vertex(v, d);
            jump[d] += weight(k, i) * (face(v, 1, d) - face(v, 0, d));
          }
        }
        const Vector<D> area = sizedNormal(corner), along = corner[1] - corner[0];
        const double now = norm(area), length = norm(along);
        const Vector<D> n = (1.0 / now) * area;
        // The opening is along the axes of the cells.
        const Vector<D> ofCells = sizedNormal(undeformed);
        const double straight = moved ? dot(ofCells, jump) / norm(ofCells) : dot(n, jump);
        const double apart =
            straight > 0.0 ? frontShape<D>(neighbour, weight, simplexOf(k), k) * straight : straight;
        p.separation(k) = apart;
        p.currentSize(k) = fraction(k) * now;
        lower.side(k) = -(p.crack(k) + 1);
        upper.side(k) = p.crack(k) + 1;
        for (int d = 0; d < D; ++d)
        {
          p.normal(k, d) = n[d];
          p.edge(k, d) = along[d] / length;
          p.position(k, d) = at[d];
          const double off = apart > near && !inCells ? 0.5 * apart : 0.0;
          lower.position(k, d) = at[d] - off * n[d];
          upper.position(k, d) = at[d] + off * n[d];
        }
      });
}

template class FacePoints<2>;
template class FacePoints<3>;

} // namespace Rhegma
