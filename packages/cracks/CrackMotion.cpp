#include "cracks/CrackMotion.hpp"

#include "base/SmallLoops.hpp"
#include "base/UnstableStep.hpp"
#include "cracks/CrackFrames.hpp"
#include "state/Subdomain.hpp"
#include "transfer/FaceRotation.hpp"
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

/// Displacement of both faces of a vertex in this step along an axis: at a front the same.
template <int D>
KOKKOS_INLINE_FUNCTION void shiftsOf(const View<int*>& kind, const View<double*>& shifts, int v, int axis,
                                     double (&shift)[2])
{
  for (int side = 0; side < 2; ++side)
    shift[side] = shifts((2 * v + side) * (D + 1) + axis);
  if ((kind(v) & vertexKind::front) != 0)
    shift[0] = shift[1] = 0.5 * (shift[0] + shift[1]);
}

/// Moves the faces of undeformed cells: the crack stays in them, and its faces part by their opening, which
/// is turned back with the rotation of the crack, so that it is that of the cells' axes.
template <int D>
void partFaces(CrackSet<D>& cracks, const View<double*>& shifts)
{
  const int count = static_cast<int>(cracks.vertex.extent(0));
  if (static_cast<int>(cracks.carried.extent(0)) != count)
    cracks.carried = View<double* [D]>("rhegma::crackDisplacement", count);
  const View<double*[D]> carried("rhegma::crackDisplacement", count), before = cracks.carried;
  const View<int*> kind = cracks.kind;
  parallelForSmall(
      "rhegma::cracks::carryVertices", count, KOKKOS_LAMBDA(const int v) {
        for (int d = 0; d < D; ++d)
        {
          double shift[2];
          shiftsOf<D>(kind, shifts, v, d, shift);
          carried(v, d) = before(v, d) + 0.5 * (shift[0] + shift[1]);
        }
      });
  const FaceRotation<D> was(cracks, before), is(cracks, carried);
  const View<double* [2][D]> face = cracks.face;
  const View<double* [D]> vertex = cracks.vertex;
  parallelForSmall(
      "rhegma::cracks::partFaces", count, KOKKOS_LAMBDA(const int v) {
        double old[D][D], now[D][D], jump[D];
        was.at(v, old);
        is.at(v, now);
        for (int i = 0; i < D; ++i)
        {
          double shift[2];
          shiftsOf<D>(kind, shifts, v, i, shift);
          jump[i] = shift[1] - shift[0];
          for (int j = 0; j < D; ++j)
            jump[i] += old[i][j] * (face(v, 1, j) - face(v, 0, j));
        }
        for (int i = 0; i < D; ++i)
        {
          double back = 0.0;
          for (int j = 0; j < D; ++j)
            back += now[j][i] * jump[j];
          face(v, 0, i) = vertex(v, i) - 0.5 * back;
          face(v, 1, i) = vertex(v, i) + 0.5 * back;
        }
      });
  cracks.carried = carried;
}

/// Moves the faces. \return how many vertices lie beyond all cells now
template <int D>
int moveFaces(const CrackSet<D>& cracks, const Grid<D>& grid, const View<double*>& shifts)
{
  const View<double* [2][D]> face = cracks.face;
  const View<double* [D]> vertex = cracks.vertex;
  const View<int*> kind = cracks.kind;
  return parallelSumSmall<int>(
      "rhegma::cracks::moveFaces", static_cast<int>(vertex.extent(0)), KOKKOS_LAMBDA(const int v, int& lost) {
        bool in = true;
        for (int d = 0; d < D; ++d)
        {
          double shift[2];
          shiftsOf<D>(kind, shifts, v, d, shift);
          for (int side = 0; side < 2; ++side)
          {
            face(v, side, d) += shift[side];
            const double cell = grid.inCells(face(v, side, d), d);
            in = in && (shifts((2 * v + side) * (D + 1) + D) == 0.0 || (cell >= 0.0 && cell < grid.cells[d]));
          }
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
  setPoints(cracks, undeformed, points_);
  pointStencils(state, points_, stencils_, true);
  findShifts(state.mesh.nodes, stencils_, points_.count, state.clock.dt,
             state.method.scheme == UpdateScheme::Usl, shift_);
  sumParts(state, shift_);
  if (undeformed)
  {
    partFaces(cracks, shift_);
    updateFronts(cracks);
    return;
  }
  const int lost = moveFaces(cracks, wholeLattice(state), shift_);
  if (lost > 0 && state.failure.empty())
    state.failure = "a crack left the domain (" + unstableStep(state.mesh.subcycledLevels) +
                    "; or enlarge the domain, or end the run earlier)";
  updateNormals(cracks);
  updateFronts(cracks);
}

template class CrackMotion<2>;
template class CrackMotion<3>;

} // namespace Rhegma::cracks
