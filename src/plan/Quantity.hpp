#pragma once
/// The quantities that calls of a step read and write, as constants.

#include <functional>
#include <vector>

namespace Rhegma
{

/// A quantity that several calls use, named by a constant: each is declared once, `inline constexpr`, and
/// compared by its address, so that a misspelt one does not compile. Those of the core and of the crack set
/// are below; quantities of a single effect are declared in a header of that effect.
struct Quantity
{
  const char* name; ///< for the printed plan and messages; no two have one name
  explicit constexpr Quantity(const char* n) : name(n) {}
  Quantity(const Quantity&) = delete;
  Quantity& operator=(const Quantity&) = delete;
};

/// Quantities that a call writes or adds to.
using Quantities = std::vector<std::reference_wrapper<const Quantity>>;

/// A quantity that a call reads.
struct Read
{
  const Quantity* quantity;
  bool optional = false; ///< whether a plan may lack a writer, for example if its effect is absent
  Read(const Quantity& q, bool o = false) : quantity(&q), optional(o) {}
  Read(const Quantity&&, bool = false) = delete;
};

/// A quantity that is read only if a call of the plan writes it.
inline Read ifWritten(const Quantity& q) { return {q, true}; }

namespace quantity
{

// Cells, ranks and particles
inline constexpr Quantity cells("cells");                        ///< the tree and its nodes
inline constexpr Quantity ownership("ownership of cells");       ///< which rank has which cells
inline constexpr Quantity particleOrder("order of particles");   ///< blocks of cells
inline constexpr Quantity particleVelocity("particle velocity"); ///< field
inline constexpr Quantity particleStress("particle stress");     ///< field, with strain and position
inline constexpr Quantity temperature("particle temperature");   ///< field, with its gradient
inline constexpr Quantity stencils("stencils");                  ///< of flagged particles, cut at cracks

// Nodes
inline constexpr Quantity nodalMass("nodal mass");         ///< Nodes::mass
inline constexpr Quantity nodalMomentum("nodal momentum"); ///< Nodes::momentum
inline constexpr Quantity internalForce("internal force"); ///< Nodes::force, of stresses and front springs
inline constexpr Quantity nodalForce("nodal force");       ///< Nodes::force, with all that acts on nodes
inline constexpr Quantity nodalMotion("nodal motion");     ///< Nodes::motion, as solved
inline constexpr Quantity constrainedMotion("constrained motion"); ///< the same with supports
inline constexpr Quantity projection("projection");                ///< Nodes::projection, which strains
inline constexpr Quantity prescribedMotion("prescribed motion");   ///< constraints
inline constexpr Quantity massMatrix("mass matrix");               ///< rows of coupled nodes
inline constexpr Quantity substeps("substeps");                    ///< of nodes that are subcycled

// Samples
inline constexpr Quantity energyBalance("energy balance"); ///< with the momentum, measured for a sample
inline constexpr Quantity energyRelease("energy release"); ///< columns of the sample

// Cracks (CrackSet)
inline constexpr Quantity crackGeometry("crack geometry");   ///< vertices, faces, simplices and fronts
inline constexpr Quantity enrichedFields("enriched fields"); ///< CrackSet::enrichedField and nodeSide
inline constexpr Quantity facePressure("face pressure");     ///< CrackSet::pressure
inline constexpr Quantity contactGaps("contact gaps");       ///< between the faces
inline constexpr Quantity springStiffness("front spring stiffness"); ///< last column of CrackSet::spring
inline constexpr Quantity springForce("front spring force");         ///< first columns of CrackSet::spring
inline constexpr Quantity springStretch("front spring stretch");     ///< of the springs' memory
inline constexpr Quantity fractureEnergy("fracture energy");         ///< of fronts: required and pending
inline constexpr Quantity dueFronts("due fronts");                   ///< of fronts: due
inline constexpr Quantity drivingForces("driving forces");           ///< of fronts: DrivingForce
inline constexpr Quantity
    stressIntensities("stress intensities");                   ///< of fronts that advance, in DrivingForce
inline constexpr Quantity advancingFronts("advancing fronts"); ///< of fronts: advances, speed
inline constexpr Quantity frontAdvances("front advances");     ///< CrackSet::advances
inline constexpr Quantity equilibriumGrowth("growth in equilibrium"); ///< EquilibriumGrowth::drive
inline constexpr Quantity frontTemperature("front temperature");      ///< of fronts

} // namespace quantity

} // namespace Rhegma
