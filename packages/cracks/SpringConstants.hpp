#pragma once
/// Every constant of the springs behind a front and of the release of new faces.

namespace Rhegma::cracks::springs
{

/// Stiffness of a front spring as a fraction of E' times its width [-]; along the cells in 2D: FrontCell.hpp.
constexpr double stiffnessFraction = 0.1;

/// Added to the distance of a node behind its front, except along the cells in 2D [cells]: keeps the
/// stiffness finite at the front.
constexpr double distanceOffset = 0.05;

/// Least xi of a node that opens by the law of FrontCell.hpp [cells]. A limited spring is far too soft below,
/// and the node is closed. Where no spring is limited, a node with one of this xi is as good as closed.
constexpr double leastOfLimited = 0.05, leastOfUnlimited = 0.003;

/// Where nodes open, except along the cells in 2D [cells]. At an angle, nodes open a little before the front
/// passes them, which measures better; within five degrees of the cells that is so in 2D alone. In 3D, and
/// where faces touch in motion, a node at such a front is closed.
constexpr double splitBehindAligned = 0.02, splitAheadInclined = 0.03;
constexpr double alongTheCells = 0.99619; ///< cosine of five degrees
constexpr double onTheCells = 0.9999985;  ///< cosine of a tenth of a degree

/// Filled fraction of a node's cells from which they count as full [-]: strain changes it by less.
constexpr double fullCells = 0.9;

/// A spring with less stretch than this stores no energy worth counting and may stiffen [cells]. Larger than
/// round-off, so that springs are the same on any number of ranks.
constexpr double unstretched = 1e-6;

/// Largest stiffness in units of reduced mass / dt^2 [-]: an explicit step of two masses on a spring is
/// stable up to 4, of which the material needs its part.
constexpr double stableStiffness = 1.0;

/// Inertia that is added to the relative motion of a node's fields, in units of its spring's stiffness times
/// dt^2 [-]. A quarter makes any spring stable in a step in which the material is (slowRelativeMotion); a
/// half leaves enough to the damping (addedInertia).
constexpr double addedInertia = 0.5;

/// Damping of a front spring as a fraction of the critical damping of its two masses [-]: the smallest
/// damping ratio at which no frequency is amplified above the static response, 1 / sqrt(2). That is of two
/// masses on a spring in continuous time (stableDamping: in steps).
constexpr double damping = 0.70710678;

/// Distance over which a moving body may advect a front before its springs are disabled [cells]: half a cell,
/// as the springs then belong to other nodes.
constexpr double advectionLimit = 0.5;

/// Further opening over which the traction of a softening spring falls to zero, as a fraction of the stretch
/// that it has when its front is initiated [-].
constexpr double softeningStretch = 1.0;

/// Initial traction of a released node as a fraction of the force that would hold its fields together [-]. A
/// node that is held exactly is in an unstable equilibrium, which only noise would end.
constexpr double initialFraction = 0.95;

/// Largest part of the energy of a release that goes to softened springs instead of new faces [-]; at the
/// first release all that is more than a cell requires. Chosen.
constexpr double carriedOverFraction = 0.25;

/// Part of its energy by which a node may dissipate more than required without deduction [-]: where the
/// traction falls within more than some two steps the last step overshoots by less (CohesiveLaw.hpp).
constexpr double toleratedExcess = 0.05;

/// Largest part of the rest that is deducted for nodes that over-dissipated [-]. A node keeps
/// (1 - 1/4) (1 - 9/10) = 7.5 % of its energy, and with that a traction, however much is to be deducted. The
/// nine tenths are chosen: with another value the same energy is deducted from more nodes or fewer.
constexpr double deductedFraction = 0.9;

/// Largest and smallest energy of a node at a 3D front as fractions of toughness times area [-]: the areas of
/// nodes add up to that of the crack, but need not do so in every step.
constexpr double largestByArea = 1.5, smallestByArea = 0.5;

} // namespace Rhegma::cracks::springs
