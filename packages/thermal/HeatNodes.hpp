#pragma once
/// Heat on the nodes.

#include "state/State.hpp"

namespace Rhegma::thermal
{

/// Nodal values of heat, a row a node, second fields of nodes beside a crack included: a crack does not
/// conduct.
template <int D>
struct HeatNodes
{
  static constexpr int sumWidth = D == 2 ? 4 : 8;
  static constexpr int capacityAt = 0, heatAt = 1, momentAt = 2;

  /// Heat capacity C [J/K]; sum N c (T - g.x) [J] and sum N c g [J/m], x from the origin of the lattice, c
  /// the capacity of a particle, T its temperature and g its temperature gradient.
  View<double* [sumWidth]> sums;
  View<double* [2]> rate; ///< heat that flows in [W]; the second column is not used
  /// Temperature [K], prescribed where it is held; its change over the step [K]; the temperature as projected
  /// [K].
  View<double* [4]> value;
  View<char*> held; ///< not 0 where the temperature is prescribed

  /// Makes room for the nodes of the state and clears those in use.
  void clear(const State<D>& state);
};

/// Adds capacity and heat of the particles to the nodes. The temperature of a node is then sum N c (T +
/// g.(x_i - x)) / C: exact for a linear field, whatever the particles' places, and without a smoothing that
/// would repeat every step.
template <int D>
void heatToNodes(const State<D>& state, const HeatNodes<D>& nodes);

/// Temperature of the nodes from their sums.
template <int D>
void findTemperature(State<D>& state, const HeatNodes<D>& nodes);

/// Flux of the particles, -k grad T, to the nodes' rate, and their supply of heat with it. Renews the
/// particles' temperature gradient. \param supply of each particle [W]; empty where there is none
template <int D>
void fluxToNodes(const State<D>& state, const HeatNodes<D>& nodes, const View<double*>& supply);

/// Change of the nodes' temperature over dt. \return heat [J] that held nodes take up from outside
template <int D>
double changeTemperature(const State<D>& state, const HeatNodes<D>& nodes, double dt);

/// Gives the particles the change of the nodes' temperature: their heat changes by just as much as that of
/// the nodes.
///
/// Of what the nodes can't see, differences between the particles of a cell, a share is taken away: T +=
/// share (sum N_i T_i - T) with the projected T_i, which leaves linear fields and the heat of all particles
/// as they are.
template <int D>
void changeToParticles(State<D>& state, const HeatNodes<D>& nodes, double share);

} // namespace Rhegma::thermal
