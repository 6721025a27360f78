#include "cracks/CrackMotion.hpp"

#include "base/SmallLoops.hpp"
#include "base/UnstableStep.hpp"
#include "cracks/CrackFrames.hpp"
#include "state/Subdomain.hpp"
#include "transfer/Stencils.hpp"

namespace Rhegma::cracks
{

namespace
{

/// \param undeformed whether the cells are, in which both faces lie where the crack is
template <int D>
void setPoints(const CrackSet<D>& cracks, bool undeformed, const ObservedPoints<D>& points)
{
  const View<double* [2][D]> face = cracks.face;
  const View<double* [D]> vertex = cracks.vertex;
  const View<int*> starBegin = cracks.starBegin, star = cracks.star, crackOf = cracks.crackOf;
  parallelForSmall(
      "rhegma::cracks::setFacePoints", points.count, KOKKOS_LAMBDA(const int k) {
        const int v = k / 2, side = k % 2, name = crackOf(star(starBegin(v))) + 1;
        points.side(k) = side == 1 ? name : -name;
        for (int d = 0; d < D; ++d)
          points.position(k, d) = undeformed ? vertex(v, d) : face(v, side, d);
      });
}

/// Displacement of each point by its nodes, D numbers, and whether it has nodes. \param byMotion by the
/// motion of the nodes, not by the projection
template <int D>
void findShifts(const Nodes<D>& nodes, const StencilTable<D>& stencils, int count, double dt, bool byMotion,
                const View<double*>& shift)
{
  parallelForSmall(
      "rhegma::cracks::findShifts", count, KOKKOS_LAMBDA(const int k) {
        const int entries = stencils.count(k);
        for (int d = 0; d < D; ++d)
        {
          double sum = 0.0;
          for (int e = 0; e < entries; ++e)
          {
            const int n = stencils.node(k, e);
            sum += dt * stencils.weight(k, e) * (byMotion ? nodes.motion(n, d) : nodes.projection(n, d));
          }
          shift(k * (D + 1) + d) = sum;
        }
        shift(k * (D + 1) + D) = entries > 0 ? 1.0 : 0.0;
      });
}

/// Moves the faces; where the cells are undeformed only apart, so that the crack stays where it is in them.
/// \return how many vertices lie beyond all cells now
template <int D>
int moveFaces(const CrackSet<D>& cracks, const Grid<D>& grid, bool undeformed, const View<double*>& shifts)
{
  const View<double* [2][D]> face = cracks.face;
  const View<double* [D]> vertex = cracks.vertex;
  const View<double* [D]> carried = cracks.carried;
  const View<int*> kind = cracks.kind;
  return parallelSumSmall<int>(
      "rhegma::cracks::moveFaces", static_cast<int>(vertex.extent(0)), KOKKOS_LAMBDA(const int v, int& lost) {
        bool in = true;
        for (int d = 0; d < D; ++d)
        {
          double shift[2];
          for (int side = 0; side < 2; ++side)
            shift[side] = shifts((2 * v + side) * (D + 1) + d);
          if ((kind(v) & vertexKind::front) != 0)
            shift[0] = shift[1] = 0.5 * (shift[0] + shift[1]);
          if (undeformed)
          {
            const double mean = 0.5 * (shift[0] + shift[1]);
            carried(v, d) += mean;
            shift[0] -= mean;
            shift[1] -= mean;
          }
          for (int side = 0; side < 2; ++side)
          {
            face(v, side, d) += shift[side];
            const double cell = grid.inCells(face(v, side, d), d);
            in = in && (undeformed || shifts((2 * v + side) * (D + 1) + D) == 0.0 ||
                        (cell >= 0.0 && cell < grid.cells[d]));
          }
          if (!undeformed)
            vertex(v, d) = 0.5 * (face(v, 0, d) + face(v, 1, d));
        }
        lost += in ? 0 : 1;
      });
}

} // namespace

template <int D>
void CrackMotion<D>::move(State<D>& state)
{
  CrackSet<D>& cracks = state.cracks;
  const int vertices = static_cast<int>(cracks.vertex.extent(0));
  if (points_.count != 2 * vertices)
  {
    points_.count = 2 * vertices;
    points_.position = View<double* [D]>("rhegma::crackFacePosition", 2 * vertices);
    points_.half = View<double* [D]>("rhegma::crackFaceHalf", 2 * vertices);
    points_.side = View<int*>("rhegma::crackFaceSide", 2 * vertices);
    points_.onAllRanks = true;
    shift_ = View<double*>("rhegma::crackFaceShift", 2 * vertices * (D + 1));
  }
  const bool undeformed = state.method.totalLagrangian;
  if (undeformed && static_cast<int>(cracks.carried.extent(0)) != vertices)
    cracks.carried = View<double* [D]>("rhegma::crackDisplacement", vertices);
  setPoints(cracks, undeformed, points_);
  pointStencils(state, points_, stencils_, true);
  findShifts(state.mesh.nodes, stencils_, points_.count, state.clock.dt,
             state.method.scheme == UpdateScheme::Usl, shift_);
  sumParts(state, shift_);
  const int lost = moveFaces(cracks, wholeLattice(state), undeformed, shift_);
  if (lost > 0 && state.failure.empty())
    state.failure = "a crack left the domain (" + unstableStep(state.mesh.subcycledLevels) +
                    "; or enlarge the domain, or end the run earlier)";
  updateNormals(cracks);
  updateFronts(cracks);
}

template class CrackMotion<2>;
template class CrackMotion<3>;

} // namespace Rhegma::cracks
