#pragma once
/// Ghost penalty: what holds the nodes of cells that a body's edge or a crack cuts.

#include "equilibrium/Unknowns.hpp"

namespace Rhegma::equilibrium
{

/// A jump of the slope of displacement between two cells, along an axis: its energy is
/// weight / 2 |sum of coefficient u|^2.
struct SlopeJump
{
  std::vector<int> row;            ///< of nodes of one side of a crack
  std::vector<double> coefficient; ///< 1, -2 and 1 for nodes in a line; hanging ones go to their masters
  double weight = 0.0;             ///< [N/m]
};

/// Jump of the slope along an axis, times the edge of the cells. \param u D numbers a row [m]
template <int D>
double jumpOf(const SlopeJump& jump, const View<double*>& u, int axis)
{
  double sum = 0.0;
  for (std::size_t a = 0; a < jump.row.size(); ++a)
    sum += jump.coefficient[a] * u(D * jump.row[a] + axis);
  return sum;
}

/// The jumps at the faces of cut cells (Burman, C. R. Acad. Sci. Paris 348 (2010) 1217): the energy of a face
/// of area A is 1/2 ghostFactor E h A (jump of grad u . n)^2. A few particles in a corner of a cell leave
/// motions of its nodes that strain none of them; the jump carries the slope of the full cell next to it over
/// into the cut one. Fields that are linear have none. A cell is cut where the particles in it fill less than
/// `fullCell` of it on the side in question. Where cells of two sizes meet, A is the face of the smaller one
/// and the slope in the larger one is that next to the face. On several ranks each jump is that of one rank,
/// which has the smaller leaf. A face of a cell without particles has a jump only where the box of a particle
/// lies on both sides of it, and a tenth of the penalty if neither cell has particles. Collective.
template <int D>
std::vector<SlopeJump> findSlopeJumps(const State<D>& state, const RowGraph& graph);

/// Factor of the ghost penalty [-]. Of 24 random cuts all could be solved with 1e-4 to 1e-2; energy release
/// rates change by at most 0.3 % with 1e-3, 0.7 % with 1e-2, 2.6 % with 0.1.
constexpr double ghostFactor = 1e-3;

/// A cell with one of four particles missing is cut; rounding of what is filled is far smaller.
constexpr double fullCell = 0.8;

/// Young's modulus [Pa].
inline double youngModulus(const Properties& m)
{
  return m.mu * (3.0 * m.lambda + 2.0 * m.mu) / (m.lambda + m.mu);
}

} // namespace Rhegma::equilibrium
