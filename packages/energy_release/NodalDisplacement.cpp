#include "energy_release/NodalDisplacement.hpp"

#include "material/Tensors.hpp"
#include "state/CellFrame.hpp"
#include "state/ParticlePlace.hpp"
#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"
#include "transfer/Stencils.hpp"

namespace Rhegma::energy_release
{

namespace
{

/// Adds the displacements of a block of particles to their nodes.
template <int D, class Range, class Connect>
struct DisplacementBlock
{
  Connect connect;
  Range range;
  NodalDisplacements<D> sum;
  NodePositions<D> positions;
  View<int*> parent; ///< node of each enriched field
  int numFirst;      ///< nodes before them
  ParticlePlace<D> place;
  bool undeformed; ///< whether the cells are
  BorrowedView<double*> mass;
  BorrowedView<double * [gradientSize<D>]> deformation;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = place.position(p, d);
      if (range.holds(x))
        add(p, x);
    }
  }

private:
  KOKKOS_INLINE_FUNCTION void add(int p, const Vector<D>& x) const
  {
    // The gradient of the displacement: 1 - F^-1 with respect to present positions, F - 1 to undeformed ones.
    double slope[D * D];
    if (undeformed)
      for (int k = 0; k < D * D; ++k)
        slope[k] = deformation(p, k) - (k % (D + 1) == 0 ? 1.0 : 0.0);
    else
    {
      inverseInAxes<D>(&deformation(p, 0), slope);
      for (int k = 0; k < D * D; ++k)
        slope[k] = (k % (D + 1) == 0 ? 1.0 : 0.0) - slope[k];
    }
    connect.visit(p,
                  [&](int node, double fraction, const double*)
                  {
                    const Vector<D> away = positions(node < numFirst ? node : parent(node - numFirst)) - x;
                    const double weight = fraction * mass(p);
                    for (int d = 0; d < D; ++d)
                    {
                      double there = place.moved(p, d);
                      for (int e = 0; e < D; ++e)
                        there += slope[D * d + e] * away[e];
                      sum(node, d) += weight * there;
                    }
                    sum(node, D) += weight;
                  });
  }
};

template <int D, class Range>
NodalDisplacements<D> displacementIn(const State<D>& state, const Range& range)
{
  const NodalDisplacements<D> sum("rhegma::nodalDisplacement", state.mesh.nodes.sums.extent(0));
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const DisplacementBlock<D, Range, Connect> block{
                         connect,
                         range,
                         sum,
                         nodePositions(state),
                         state.mesh.nodes.parent,
                         state.mesh.nodes.numLattice,
                         ParticlePlace<D>(state.particles),
                         state.method.totalLagrangian,
                         state.particles.scalar(fields::mass),
                         state.particles.template real<gradientSize<D>>(fields::deformation)};
                     forEachBlock("rhegma::nodalDisplacement", state.mesh.blocks, block);
                   });
  sumOverRanks(state, sum.data(), D + 1, 0, D + 1);
  Kokkos::parallel_for(
      "rhegma::averageDisplacement", Kokkos::RangePolicy<ExecSpace>(0, sum.extent(0)),
      KOKKOS_LAMBDA(const int n) {
        for (int d = 0; d < D; ++d)
          sum(n, d) = sum(n, D) > 0.0 ? sum(n, d) / sum(n, D) : 0.0;
      });
  return sum;
}

} // namespace

NodalDisplacements<2> displacementOfNodes(const State<2>& state, const Disk& range)
{
  return displacementIn<2>(state, range);
}

NodalDisplacements<3> displacementOfNodes(const State<3>& state, const Region<3>& range)
{
  return displacementIn<3>(state, range);
}

template <int D>
StencilTable<D> stencilsOnFaces(const State<D>& state, int crack, const std::vector<Vector<D>>& positions)
{
  const int half = static_cast<int>(positions.size());
  ObservedPoints<D> points;
  points.onAllRanks = true;
  points.count = 2 * half;
  points.position = View<double* [D]>("rhegma::nearFrontPosition", points.count);
  points.half = View<double* [D]>("rhegma::nearFrontHalf", points.count);
  points.side = View<int*>("rhegma::nearFrontSide", points.count);
  const auto position = Kokkos::create_mirror_view(points.position);
  const auto side = Kokkos::create_mirror_view(points.side);
  for (int k = 0; k < points.count; ++k)
  {
    for (int d = 0; d < D; ++d)
      position(k, d) = positions[k % half][d];
    side(k) = k < half ? -crack - 1 : crack + 1;
  }
  Kokkos::deep_copy(points.position, position);
  Kokkos::deep_copy(points.side, side);
  StencilTable<D> table;
  pointStencils(state, points, table, true);
  return table;
}

template <int D>
std::vector<Vector<D>> openingAt(const State<D>& state, const NodalDisplacements<D>& displacement, int crack,
                                 const std::vector<Vector<D>>& positions)
{
  const int half = static_cast<int>(positions.size());
  std::vector<Vector<D>> jump(half);
  if (half == 0)
    return jump;
  const StencilTable<D> table = stencilsOnFaces(state, crack, positions);
  const View<double * [D + 1]> face("rhegma::nearFrontDisplacement", 2 * half); // and whether there is a node
  Kokkos::parallel_for(
      "rhegma::nearFrontDisplacement", Kokkos::RangePolicy<ExecSpace>(0, 2 * half),
      KOKKOS_LAMBDA(const int k) {
        for (int e = 0; e < table.count(k); ++e)
          for (int d = 0; d < D; ++d)
            face(k, d) += table.weight(k, e) * displacement(table.node(k, e), d);
        face(k, D) = table.count(k) > 0 ? 1.0 : 0.0;
      });
  const auto host = onHost(face);
  std::vector<double> both(2 * half * (D + 1));
  for (int k = 0; k < 2 * half; ++k)
    for (int d = 0; d <= D; ++d)
      both[k * (D + 1) + d] = host(k, d);
  sumParts(state, both.data(), static_cast<int>(both.size()));
  for (int k = 0; k < half; ++k)
  {
    const double *below = &both[k * (D + 1)], *above = &both[(half + k) * (D + 1)];
    for (int d = 0; d < D; ++d)
      jump[k][d] = below[D] > 0.0 && above[D] > 0.0 ? above[d] - below[d] : 0.0;
  }
  return jump;
}

template StencilTable<2> stencilsOnFaces(const State<2>&, int, const std::vector<Vector<2>>&);
template StencilTable<3> stencilsOnFaces(const State<3>&, int, const std::vector<Vector<3>>&);
template std::vector<Vector<2>> openingAt(const State<2>&, const NodalDisplacements<2>&, int,
                                          const std::vector<Vector<2>>&);
template std::vector<Vector<3>> openingAt(const State<3>&, const NodalDisplacements<3>&, int,
                                          const std::vector<Vector<3>>&);

} // namespace Rhegma::energy_release
