#include "cracks/CrackMotion.hpp"

#include "cracks/CrackSetup.hpp"
#include "transfer/Stencils.hpp"

namespace Rhegma::cracks
{

namespace
{

void placePoints(const CrackSet<2>& cracks, const View<int*>& crackOfVertex, const ObservedPoints<2>& points)
{
  const View<double* [2][2]> face = cracks.face;
  Kokkos::parallel_for(
      "rhegma::cracks::placeFaces", Kokkos::RangePolicy<ExecSpace>(0, points.count),
      KOKKOS_LAMBDA(const int k) {
        const int v = k / 2, side = k % 2;
        points.side(k) = side == 1 ? crackOfVertex(v) + 1 : -(crackOfVertex(v) + 1);
        for (int d = 0; d < 2; ++d)
          points.position(k, d) = face(v, side, d);
      });
}

void moveFaces(const CrackSet<2>& cracks, const Nodes<2>& nodes, const StencilTable<2>& stencils,
               const View<int*>& isFront, double dt)
{
  const View<double* [2][2]> face = cracks.face;
  const View<double* [2]> vertex = cracks.vertex;
  Kokkos::parallel_for(
      "rhegma::cracks::moveFaces", Kokkos::RangePolicy<ExecSpace>(0, vertex.extent(0)),
      KOKKOS_LAMBDA(const int v) {
        for (int d = 0; d < 2; ++d)
        {
          double shift[2] = {0.0, 0.0};
          for (int side = 0; side < 2; ++side)
            for (int e = 0; e < stencils.count(2 * v + side); ++e)
              shift[side] +=
                  dt * stencils.weight(2 * v + side, e) * nodes.motion(stencils.node(2 * v + side, e), d);
          if (isFront(v) != 0)
            shift[0] = shift[1] = 0.5 * (shift[0] + shift[1]);
          for (int side = 0; side < 2; ++side)
            face(v, side, d) += shift[side];
          vertex(v, d) = 0.5 * (face(v, 0, d) + face(v, 1, d));
        }
      });
}

} // namespace

void CrackMotion::move(State<2>& state)
{
  CrackSet<2>& cracks = state.cracks;
  const int vertices = static_cast<int>(cracks.vertex.extent(0));
  if (points_.count != 2 * vertices)
  {
    points_.count = 2 * vertices;
    points_.position = View<double* [2]>("rhegma::crackFacePosition", 2 * vertices);
    points_.half = View<double* [2]>("rhegma::crackFaceHalf", 2 * vertices);
    points_.side = View<int*>("rhegma::crackFaceSide", 2 * vertices);
  }
  const View<int*> crackOfVertex("rhegma::crackOfVertex", vertices);
  const View<int*> isFront("rhegma::isFront", vertices);
  const auto hostCrack = Kokkos::create_mirror_view(crackOfVertex);
  const auto hostFront = Kokkos::create_mirror_view(isFront);
  for (std::size_t c = 0; c < cracks.cracks.size(); ++c)
    for (int k = 0; k < cracks.cracks[c].numVertices; ++k)
      hostCrack(cracks.cracks[c].firstVertex + k) = static_cast<int>(c);
  for (const CrackFront<2>& front : cracks.fronts)
    hostFront(front.vertex) = 1;
  Kokkos::deep_copy(crackOfVertex, hostCrack);
  Kokkos::deep_copy(isFront, hostFront);

  placePoints(cracks, crackOfVertex, points_);
  pointStencils(state, points_, stencils_, true);
  moveFaces(cracks, state.nodes, stencils_, isFront, state.dt);
  updateFronts(cracks);
}

} // namespace Rhegma::cracks
