#include "cracks/Nearest.hpp"

#include "base/RelaxedLoad.hpp"

namespace Rhegma::cracks
{

namespace
{

/// Square of a distance in parts of the band, above the number of a simplex, in one integer, so that the
/// smallest is the nearest whatever the order of threads.
constexpr double parts = 1073741824.0; // 2^30

KOKKOS_INLINE_FUNCTION std::uint64_t pack(double square, int simplex)
{
  return (static_cast<std::uint64_t>(square * parts) << 32) | static_cast<std::uint64_t>(simplex);
}

/// Updates the nearest simplex of a node.
template <int D>
struct ReportNode
{
  View<std::uint64_t*> nearest;
  Vector<D> corner[D], middle;
  double radius, band, scale;
  int simplex;

  KOKKOS_INLINE_FUNCTION void operator()(int n, const Vector<D>& x) const
  {
    // The sphere around the simplex bounds the distance from below.
    const double apart = norm(x - middle) - radius;
    if (apart > band || (apart > 0.0 && relaxedLoad(nearest(n)) < pack(apart * apart * scale, 0)))
      return;
    const Vector<D> away = x - pointAt<D>(corner, footOn(corner, x));
    const double square = dot(away, away) * scale;
    if (square <= 1.0)
      Kokkos::atomic_fetch_min(&nearest(n), pack(square, simplex));
  }
};

} // namespace

template <int D>
void findNearest(const State<D>& state, const Surroundings& around)
{
  using Policy = Kokkos::TeamPolicy<ExecSpace>;
  const Grid<D> grid = state.mesh.grid;
  const CrackSight<D> sight(state.cracks, grid.spacing);
  const View<std::uint64_t*> nearest = around.nearest;
  const NodePositions<D> positions = nodePositions(state);
  const bool refined = state.mesh.tree.refined();
  const View<int*> root = state.mesh.tree.root, fineBegin = state.mesh.tree.fineBegin,
                   fineIn = state.mesh.tree.fineIn;
  const double band = bandWidth * grid.spacing;
  Kokkos::parallel_for(
      "rhegma::cracks::findNearest", Policy(static_cast<int>(sight.simplex.extent(0)), Kokkos::AUTO),
      KOKKOS_LAMBDA(const typename Policy::member_type& team) {
        ReportNode<D> report;
        report.nearest = nearest;
        report.simplex = team.league_rank();
        report.band = band;
        report.scale = 1.0 / (band * band);
        report.radius = 0.0;
        sight.corners(report.simplex, report.corner);
        int first[D], count[D], all = 1;
        for (int d = 0; d < D; ++d)
        {
          double low = report.corner[0][d], high = report.corner[0][d];
          for (int i = 1; i < D; ++i)
          {
            low = report.corner[i][d] < low ? report.corner[i][d] : low;
            high = report.corner[i][d] > high ? report.corner[i][d] : high;
          }
          report.middle[d] = 0.5 * (low + high);
          report.radius += 0.25 * (high - low) * (high - low);
          // The cell below the first node has nodes of its own in the band.
          int last = static_cast<int>(grid.inCells(high, d) + bandWidth);
          first[d] = static_cast<int>(grid.inCells(low, d) - bandWidth);
          first[d] = first[d] < 0 ? 0 : first[d];
          last = last > grid.cells[d] ? grid.cells[d] : last;
          count[d] = last < first[d] ? 0 : last - first[d] + 1;
          all *= count[d];
        }
        report.radius = std::sqrt(report.radius);
        Kokkos::parallel_for(Kokkos::TeamThreadRange(team, all),
                             [&](const int k)
                             {
                               int at[D], rest = k;
                               for (int d = 0; d < D; ++d)
                               {
                                 at[d] = first[d] + rest % count[d];
                                 rest /= count[d];
                               }
                               const int n = grid.nodeIndex(at);
                               const Vector<D> x = grid.positionOf(at);
                               report(n, x);
                               const int branch = refined ? root(n) : -1;
                               for (int i = branch < 0 ? 0 : fineBegin(branch);
                                    branch >= 0 && i < fineBegin(branch + 1); ++i)
                                 report(fineIn(i), positions(fineIn(i)));
                             });
      });
}

template void findNearest(const State<2>&, const Surroundings&);
template void findNearest(const State<3>&, const Surroundings&);

} // namespace Rhegma::cracks
