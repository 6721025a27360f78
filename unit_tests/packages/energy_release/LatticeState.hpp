#pragma once
/// A body of particles on a lattice with a displacement given in closed form.

#include "energy_release/CrackTipFields.hpp"
#include "energy_release/InternalAcceleration.hpp"
#include "material/MaterialTable.hpp"
#include "material/Materials.hpp"
#include "state/State.hpp"

#include <cmath>
#include <functional>

namespace Rhegma::energy_release::test
{

constexpr double young = 3e9, poisson = 0.3, density = 1200.0, thickness = 0.01;

/// Displacement [m] and its gradient, row by row, at a reference position.
struct Displacement
{
  Vector<2> u;
  double gradient[4];
};
using DisplacementField = std::function<Displacement(const Vector<2>&)>;

/// Velocity and acceleration of a node.
struct Motion
{
  Vector<2> velocity, acceleration;
};

/// A square body of half width `half` around the origin, its lattice shifted against the grid by `shift` of a
/// particle's spacing, with 2 x 2 particles a cell.
State<2> makeBody(double half, double cell, Plane plane, ShapeKind shape,
                  const Vector<2>& shift = {{0.0, 0.0}});

/// Gives the body another material.
void setMaterial(State<2>& state, const Teuchos::ParameterList& material);

/// Puts the particles where the displacement says, with the stress of their law.
void deform(State<2>& state, const DisplacementField& field);

/// Gives the nodes a motion.
void setMotion(State<2>& state, const std::function<Motion(const Vector<2>&)>& motion);

/// Acceleration of the nodes as setMotion gave it.
NodalAcceleration<2> nodalAcceleration(const State<2>& state);

/// Adds a crack with one front at `tip` in the direction of `angle`, side +1 on its left.
CrackFront<2> addFront(State<2>& state, const Vector<2>& tip, double angle);

/// Displacement of the singular fields of the program of modes I and II around a front.
DisplacementField tipDisplacement(const CrackFront<2>& front, const CrackCompliance& material, double modeI,
                                  double modeII);

/// Displacement of Williams' field of modes I and II around a front.
DisplacementField tipDisplacement(const State<2>& state, const CrackFront<2>& front, double modeI,
                                  double modeII);

} // namespace Rhegma::energy_release::test
