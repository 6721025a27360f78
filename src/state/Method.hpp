#pragma once
/// How a run integrates the equations of motion.

#include "base/Types.hpp"
#include "grid/ShapeFunctions.hpp"

namespace Rhegma
{

/// When stress is updated within a step (Bardenhagen, J. Comput. Phys. 180 (2002) 383; Nairn, CMES 4 (2003)
/// 649).
enum class UpdateScheme
{
  Musl, ///< last, with velocities projected anew
  Usf,  ///< first
  Usl,  ///< last
  Usavg ///< half first, half last with velocities projected anew
};

/// Whether a step ends with velocities projected anew, which strain and move the particles.
constexpr bool projectsLast(UpdateScheme scheme)
{
  return scheme == UpdateScheme::Musl || scheme == UpdateScheme::Usavg;
}

/// What a run solves.
enum class Analysis
{
  Dynamic,     ///< motion, by explicit steps
  Static,      ///< equilibrium under the loads at the final time, reached in proportion
  Preload,     ///< equilibrium under the loads at the start, in which another run starts
  QuasiStatic, ///< equilibrium at each time under the loads of that time
  LoadFactor   ///< equilibrium in which cracks are about to grow: the loads at the final time times a factor
};

/// Extent of a 2D scene normal to its plane: the thickness, or the length of the circle on which a point
/// lies.
struct Depth
{
  double thickness = 1.0; ///< [m]; with `around` the angle of the circle, 2 pi
  bool around = false;    ///< whether points are circles around the axis

  /// \param x first coordinate of a point [m] \return [m]
  KOKKOS_FORCEINLINE_FUNCTION double at(double x) const { return around ? thickness * x : thickness; }
};

/// What the scene's Domain and Time sections choose.
struct Method
{
  Analysis analysis = Analysis::Dynamic;        ///< what is solved
  Plane plane = Plane::Solid;                   ///< how 2D treats the third direction
  double thickness = 1.0;                       ///< of 2D scenes [m]; axisymmetric: 2 pi, see Depth
  bool axisymmetric = false;                    ///< 2D: x is the radius, and the third direction the hoop's
  ShapeKind shape = ShapeKind::Gimp;            ///< shape functions
  ShearStrain shear = ShearStrain::AtParticles; ///< where slopes of shear are taken
  UpdateScheme scheme = UpdateScheme::Musl;     ///< when stress is updated
  /// Whether the cells lie in the undeformed body, through which it does not move.
  bool totalLagrangian = false;
  double picFraction = 0.0; ///< fraction of PIC in the velocity update
  double cfl = 0.4;         ///< fraction of the stable step that is used
  bool mechanics = true;    ///< false: nothing moves, and there is neither velocity nor stress
  /// Whether unstable growth of cracks in equilibrium ends it: the run goes on as motion from there.
  bool handsOver = false;
  bool heldTemperatures = false; ///< true: strain does not change temperatures, which steady conduction holds

  /// Extent normal to the plane.
  Depth depth() const { return {thickness, axisymmetric}; }

  /// Whether each step ends in equilibrium; its length is then no limit of what acts on nodes.
  bool equilibrium() const { return analysis != Analysis::Dynamic; }
};

} // namespace Rhegma
