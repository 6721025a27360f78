/// Forces that contact in equilibrium exerts on nodes outside of Newton's method.

#include "contact/ContactInEquilibrium.hpp"
#include "state/Subdomain.hpp"

namespace Rhegma::contact
{

template <int D>
void ContactInEquilibrium<D>::addForces(const State<D>& state, const View<double * [D + 1]>& force)
{
  patches_.collect(state);
  for (const Patch& patch : patches_.all())
    for (const Part& part : patch.parts)
      for (int d = 0; d < D && part.ofThisRank; ++d)
      {
        double onPlus = part.jump[0][d] * patch.pressure;
        for (int t = 0; t < D - 1; ++t)
          onPlus -= part.jump[1 + t][d] * patch.shear[t];
        force(part.plus, d) += patch.area * onPlus;
        force(part.minus, d) -= patch.area * onPlus;
      }
}

template <int D>
void ContactInEquilibrium<D>::balance(const State<D>& state, const View<double * [D + 1]>& force)
{
  patches_.collect(state);
  const View<double * [D + 1]>& spring = state.cracks.spring;
  View<double * [D + 1]> all = force; // of all ranks
  if (patches_.ranks().many())
  {
    all = View<double * [D + 1]>("rhegma::contact::forceOfRanks", force.extent(0));
    Kokkos::deep_copy(all, force);
    sumOverRanks(state, all.data(), D + 1, 0, D);
  }
  std::vector<char> done(force.extent(0), 0);
  for (const Patch& patch : patches_.all())
    for (const Part& part : patch.parts)
    {
      if (!(patch.pressure > 0.0) || done[part.plus] != 0 || !part.ofThisRank)
        continue;
      done[part.plus] = 1;
      const bool plusIsPrimary = part.plus < state.mesh.nodes.numLattice;
      const int primary = plusIsPrimary ? part.plus : part.minus;
      for (int d = 0; d < D; ++d)
      {
        const double ofSpring = spring.extent(0) > 0 ? spring(primary, d) : 0.0;
        const double apart =
            0.5 * (all(part.plus, d) - all(part.minus, d)) + (plusIsPrimary ? ofSpring : -ofSpring);
        force(part.plus, d) -= apart;
        force(part.minus, d) += apart;
      }
    }
}

template void ContactInEquilibrium<2>::addForces(const State<2>&, const View<double* [3]>&);
template void ContactInEquilibrium<2>::balance(const State<2>&, const View<double* [3]>&);
template void ContactInEquilibrium<3>::addForces(const State<3>&, const View<double* [4]>&);
template void ContactInEquilibrium<3>::balance(const State<3>&, const View<double* [4]>&);

} // namespace Rhegma::contact
