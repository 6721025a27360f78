#pragma once
/// Constants of the law of the front's cell in 2D.

namespace Rhegma::cracks::frontCell
{

/// Springs of any stiffness, and particles that the crack divides. Written by
/// unit_tests/studies/front_cell.py --fit.
namespace unlimited
{

constexpr double stiffness = 0.218; ///< a: fraction of E' times the thickness [-]
constexpr double range = 1.0;       ///< l0: where springs end, for a crack along the cells [cells]
constexpr double lag = 0.248;       ///< s0: by how much nodes open ahead of the front [cells]
constexpr double lagTurned = 0.312; ///< q: times 1 - c, added to s0 at an angle to the cells [cells]
/// b: by how much springs of nodes on the crack are stiffer than those half a cell or more away from it [-]
constexpr double onCrack = 0.174;

} // namespace unlimited

/// Springs that explicit steps of coupled masses limit (StableStiffness), and whole particles on both sides,
/// for cracks along the cells, from the same patch.
namespace limited
{

constexpr double stiffness = 0.22, range = 0.99, lag = 0.21, lagMidCell = 0.032;

} // namespace limited

/// Conductance of heat between the fields where a is a stiffness: fraction of the conductivity times the
/// width [-], from the same patch with the temperature of an insulating crack on its rim.
constexpr double conductance = 0.606;

} // namespace Rhegma::cracks::frontCell
