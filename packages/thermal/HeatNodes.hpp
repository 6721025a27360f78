#pragma once
/// Heat on the nodes.

#include "state/State.hpp"

namespace Rhegma::thermal
{

/// Nodal values of heat, a row a node, enriched fields of nodes next to a crack included: a crack does not
/// conduct.
template <int D>
struct HeatNodes
{
  static constexpr int sumWidth = D == 2 ? 4 : 8;
  static constexpr int capacityAt = 0, heatAt = 1, momentAt = 2;

  /// Heat capacity C [J/K]; sum N c (T - g.x) [J] and sum N c g [J/m], x from the origin of the lattice, c
  /// the capacity of a particle, T its temperature and g its temperature gradient.
  View<double* [sumWidth]> sums;
  /// Heat that flows in [W], and the capacity [J/K] of the parts with negative weights, with its sign turned.
  View<double* [2]> rate;
  static constexpr int leftOutAt = 1;
  /// Temperature [K], prescribed where it is held; its change over the step [K]; the temperature as projected
  /// [K].
  View<double* [4]> value;
  View<char*> held; ///< not 0 where the temperature is prescribed

  static constexpr int meetWidth = 4, joinAt = 3;
  /// Of the conducting particles that touch a node: how many they are, the sum of the numbers of their
  /// materials and that of the squares of these; and the fraction of the difference to the temperature of the
  /// node by which its particles approach it in the step, in addition to that of changeToParticles
  /// (MeetingMaterials.hpp). Empty where there is one material.
  View<double* [meetWidth]> meets;

  /// Change of the temperature of each particle by MeetingMaterials.hpp [K]. Empty where there is one
  /// material.
  View<double*> joined;

  /// Of particles with stored stencils, sum N_i g . (x_i - x) over positive weights N_i, by their gradient
  /// before the step [K]. Used only while there are any.
  View<double*> aside;

  /// Whether a particle with this weight touches a node: more than round-off at the edge of its box.
  KOKKOS_INLINE_FUNCTION static bool touches(double weight) { return weight > 1e-12; }
  /// Whether a node has conductors.
  KOKKOS_INLINE_FUNCTION bool conductsAt(int node) const { return meets(node, 0) > 0.0; }
  /// Whether all on a node are insulators next to other materials.
  KOKKOS_INLINE_FUNCTION bool insulates(int node) const { return meets.extent(0) > 0 && !conductsAt(node); }
  /// Whether several materials that conduct meet on a node. Sums of whole numbers are exact.
  KOKKOS_INLINE_FUNCTION bool severalAt(int node) const
  {
    return meets(node, 0) * meets(node, 2) != meets(node, 1) * meets(node, 1);
  }

  /// Resizes for the nodes of the state and clears those in use. \param several whether materials may meet
  void clear(const State<D>& state, bool several = false);
};

/// Adds capacity and heat of the particles to the nodes. The temperature of a node is then sum N c (T +
/// g.(x_i - x)) / C: exact for a linear field, whatever the particles' positions, and without a smoothing
/// that would repeat every step.
///
/// Extrapolated stencils (packages/cracks/Ghosts.hpp) have negative weights, which are left out of the mean
/// but not of C: with them, other weights of the mean would be above 1, and as gradients of one step enter
/// the means of the next one, gradients grew 1.2 times a step at nodes at the edge of a body next to a crack.
template <int D>
void heatToNodes(const State<D>& state, const HeatNodes<D>& nodes);

/// The largest sum of the positive weights of a particle: 1 where no stencil extrapolates. Collective where
/// there are cracks.
template <int D>
double largestPositiveSum(const State<D>& state);

/// Temperature of the nodes from their sums.
template <int D>
void findTemperature(State<D>& state, const HeatNodes<D>& nodes);

/// Flux of the particles, -k grad T, to the nodes' rate, and their supply of heat with it. Renews the
/// particles' temperature gradient. A particle that does not conduct, on a node with a conductor, keeps its
/// supply for `changeToParticles`. \param supply of each particle [W]; empty where there is none
template <int D>
void fluxToNodes(const State<D>& state, const HeatNodes<D>& nodes, const View<double*>& supply);

/// Change of the nodes' temperature over dt. \return heat [J] that held nodes take up from outside
template <int D>
double changeTemperature(const State<D>& state, const HeatNodes<D>& nodes, double dt);

/// Gives the particles the change of the nodes' temperature: the heat of the particles changes by that of the
/// nodes.
///
/// A fraction of the differences between the particles of a cell that nodes do not resolve is removed: T +=
/// fraction sum N_i (T_i - T - g.(x_i - x)) with the projected T_i and the gradient of before the step, which
/// leaves linear fields and the heat of all particles alone. Of stored stencils, whose weights need not be
/// positive, only the positive ones count, as in the means of the nodes. \param supply as `fluxToNodes` has
/// it, for dt \param fraction at most 1 over largestPositiveSum
template <int D>
void changeToParticles(State<D>& state, const HeatNodes<D>& nodes, double fraction,
                       const View<double*>& supply, double dt);

} // namespace Rhegma::thermal
