#pragma once
/// Thermal strain that the shape functions of a cell cannot represent.
///
/// The strain of a particle is that of the shape functions of its nodes. A bilinear cell has no normal strain
/// along an axis that varies along that axis, but the thermal strain alpha T of its particles varies: in a
/// free body with a linear temperature, stresses would alternate from particle to particle by E alpha g h /
/// 4, g the gradient of temperature. Strains should be taken from the space of strains that the cell can have
/// (Prathap and Naganarayana, Comput. Struct. 54 (1995) 415).
///
/// Around a particle at x the free displacement of a linear temperature T + g . r, r the distance from x, is
///
///     u_i = alpha (T r_i + r_i (g . r) - g_i r^2 / 2),
///
/// and its strain at x is alpha T times the unit tensor. The shape functions of the particle's nodes n give
///
///     alpha (T d_ij + (M_ij + M_ji) / 2),   M_ij = sum_n dN_n/dx_j (r_i (g . r) - g_i r^2 / 2)_n.
///
/// In a cell of a lattice M_ii = g_i (centre - x)_i, so that T + M_ii is the temperature in the middle of the
/// cell along axis i, and M_ij + M_ji is the shear strain of a bilinear cell that bends. In refined cells,
/// for boxes across several cells, and with the nodes of one side of a crack, M is that of the same slopes
/// which strain the particle. Thus the deformation gradient of a particle changes by -alpha (M + M^T) F / 2
/// along with every change of the gradient of the nodes' temperature: when the motion of the nodes has
/// followed, it contains the thermal strain of the particle itself, and W(F / theta; T) needs no change. The
/// mean over a cell that is full of particles does not change.
///
/// As a change of strain, it is that of the cell in which the particle is at that time. A body that moves
/// through the cells with a constant temperature is not strained by it.

#include "thermal/HeatNodes.hpp"

namespace Rhegma::thermal
{

/// Strain per kelvin at which a material is free of stress within the plane: alpha, in plane strain (1 + nu)
/// alpha; over the stretch so far [1/K].
KOKKOS_INLINE_FUNCTION double freeExpansion(const ThermoPoint& at)
{
  const Properties law = at.properties();
  const double held = law.plane == Plane::Strain ? 1.5 * law.bulk / (law.lambda + law.mu) : 1.0;
  return held * at.expansion() / at.stretch();
}

/// Heat that free expansion takes up in addition to the capacity at constant strain, over temperature and
/// strain: 3 K alpha times the number of axes that expand [Pa/K].
template <int D>
KOKKOS_INLINE_FUNCTION double heatOfExpansion(const ThermoPoint& at)
{
  const Properties law = at.properties();
  return (law.plane == Plane::Stress ? 3.0 : D) * 3.0 * law.bulk * at.expansion();
}

/// Whether the strain of any material depends on temperature.
bool anyExpands(const ThermoTables& tables);

/// Corrects the deformation gradients for the change of the particles' temperature gradients. The changes of
/// the nodes' temperatures in the steps have another sum: next to nodes whose temperature is prescribed they
/// need not fade in a steady state, as the prescribed temperature differs from that of the particles around.
/// \param before the gradients when it was called last. Particles that do not take part in the conduction of
/// their nodes are left out (Insulators.hpp).
template <int D>
void correctExpansion(State<D>& state, const HeatNodes<D>& nodes, const View<double* [D]>& before);

/// Corrects the deformation gradients of particles that nothing has strained yet for the temperature at the
/// start. \param gradient of the temperature of each particle [K/m]
template <int D>
void correctExpansion(State<D>& state, const View<double* [D]>& gradient);

} // namespace Rhegma::thermal
