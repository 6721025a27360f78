#pragma once
/// Constants of the law of the front's cell in 2D.

namespace Rhegma::cracks::frontCell
{

/// With particles that the crack divides. Written by unit_tests/studies/front_cell.py --fit.
namespace atRest
{

constexpr double stiffness = 0.224;   ///< a: fraction of E' times the thickness [-]
constexpr double range = 1.01;        ///< l0: where springs end, for a crack along the cells [cells]
constexpr double lag = 0.238;         ///< s0: by how much nodes open ahead of the front [cells]
constexpr double lagMidCell = 0.0105; ///< m: added to s0 midway between rows of nodes [cells]
constexpr double lagTurned = 0.178;   ///< q: times 1 - c, added to s0 at an angle to the cells [cells]

} // namespace atRest

/// With whole particles on both sides, for cracks along the cells, from the same patch.
namespace inMotion
{

constexpr double stiffness = 0.22, range = 0.99, lag = 0.21, lagMidCell = 0.032;

} // namespace inMotion

/// Conductance of heat between the fields where a is a stiffness: fraction of the conductivity times the
/// width [-], from the same patch with the temperature of an insulating crack on its rim.
constexpr double conductance = 0.574;

} // namespace Rhegma::cracks::frontCell
