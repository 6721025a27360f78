#include "energy_release/FrontRows.hpp"

#include "energy_release/ParticleMotion.hpp"
#include "transfer/NearNodes.hpp"

#include <algorithm>

namespace Rhegma::energy_release
{

template <int D>
void FrontRowTable<D>::reserve(const State<D>& state)
{
  const std::size_t count = std::max<std::size_t>(state.mesh.nodes.sums.extent(0),
                                                  state.mesh.grid.numNodes + state.mesh.tree.numFine);
  if (rows_.extent(0) < count)
    rows_ = View<double * [FrontRows<D>::width]>("rhegma::frontRows", count);
}

template <int D>
FrontRows<D> FrontRowTable<D>::fillMotion(const State<D>& state, const Region<D>& box, bool moving,
                                          const NodalAcceleration<D>& acceleration)
{
  reserve(state);
  const View<double * [FrontRows<D>::width]> rows = rows_;
  const NodalVelocity<D> velocity(state);
  const double lightest = lightestNode(state);
  forEachNodeIn(
      "rhegma::motionAroundFront", state, box, KOKKOS_LAMBDA(const int n, const Vector<D>&) {
        const bool moves = moving && !(acceleration(n, D) < lightest);
        for (int d = 0; d < D; ++d)
        {
          rows(n, FrontRows<D>::motionAt + d) = moves ? velocity(n, d) : 0.0;
          rows(n, FrontRows<D>::accelerationAt + d) = moves ? acceleration(n, d) : 0.0;
        }
      });
  return {rows.data()};
}

template <>
FrontRows<2> FrontRowTable<2>::fill(const State<2>& state, const Region<2>& box, bool moving,
                                    const NodalAcceleration<2>& acceleration, const NodalWeight<2>& weight,
                                    const CrackPath& path)
{
  reserve(state);
  const View<double * [FrontRows<2>::width]> rows = rows_;
  const NodalVelocity<2> velocity(state);
  const double lightest = lightestNode(state);
  const bool bent = path.count > 0;
  const Vector<2> centre = weight.centre;
  const ContourRadii radii = weight.radii;
  forEachNodeIn(
      "rhegma::valuesAroundFront", state, box, KOKKOS_LAMBDA(const int n, const Vector<2>& x) {
        const double q = weightAt(norm(x - centre), radii);
        const Vector<2> shift = bent && q > 0.0 ? q * path(x) : Vector<2>{};
        const bool moves = moving && !(acceleration(n, 2) < lightest);
        rows(n, FrontRows<2>::weightAt) = q;
        for (int d = 0; d < 2; ++d)
        {
          rows(n, FrontRows<2>::weightAt + 1 + d) = shift[d];
          rows(n, FrontRows<2>::motionAt + d) = moves ? velocity(n, d) : 0.0;
          rows(n, FrontRows<2>::accelerationAt + d) = moves ? q * acceleration(n, d) : 0.0;
        }
      });
  return {rows.data()};
}

template <int D>
View<double* [4]> FrontRowTable<D>::clearForces(const State<D>& state, const Region<D>& box)
{
  if (forces_.extent(0) < state.mesh.nodes.sums.extent(0))
    forces_ = View<double* [4]>("rhegma::forcesAroundFront", state.mesh.nodes.sums.extent(0));
  View<double* [4]> forces = forces_;
  forEachNodeIn(
      "rhegma::clearForcesAroundFront", state, box, KOKKOS_LAMBDA(const int n, const Vector<D>&) {
        for (int k = 0; k < 4; ++k)
          forces(n, k) = 0.0;
      });
  return forces;
}

template <int D>
View<double* [4 * D]> FrontRowTable<D>::clearMoments(const State<D>& state, const Region<D>& box, bool moving)
{
  if (!moving)
    return moments_ = {};
  if (moments_.extent(0) < state.mesh.nodes.sums.extent(0))
    moments_ = View<double * [4 * D]>("rhegma::momentsAroundFront", state.mesh.nodes.sums.extent(0));
  const View<double * [4 * D]> moments = moments_;
  forEachNodeIn(
      "rhegma::clearMomentsAroundFront", state, box, KOKKOS_LAMBDA(const int n, const Vector<D>&) {
        for (int k = 0; k < 4 * D; ++k)
          moments(n, k) = 0.0;
      });
  return moments_;
}

template <int D>
void FrontRowTable<D>::addWorkOfAcceleration(const State<D>& state, const Region<D>& box) const
{
  if (moments_.extent(0) == 0)
    return;
  const View<double * [FrontRows<D>::width]> rows = rows_;
  const View<double * [4 * D]> moments = moments_;
  const View<double* [4]> forces = forces_;
  forEachNodeIn(
      "rhegma::workOfAccelerationAroundFront", state, box, KOKKOS_LAMBDA(const int n, const Vector<D>&) {
        for (int i = 0; i < D; ++i)
          for (int k = 0; k < D; ++k)
            forces(n, k) += rows(n, FrontRows<D>::accelerationAt + i) * moments(n, 4 * i + k);
      });
}

template class FrontRowTable<2>;
template class FrontRowTable<3>;

} // namespace Rhegma::energy_release
