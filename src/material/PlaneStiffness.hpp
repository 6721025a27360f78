#pragma once
/// The stiffness of a material in the plane of a 2D scene.

#include "base/Types.hpp"

namespace Rhegma
{

/// Stiffness at small strain in the plane, of a material whose third axis is across the plane: with axis 1
/// along `axis` and axis 2 a quarter turn from it,
///
///     s_11 = xx e_11 + xy e_22,   s_22 = xy e_11 + yy e_22,   s_12 = 2 shear e_12   [Pa].
///
/// In plane stress it is that of the thin plate, in plane strain that of the body held across the plane.
struct PlaneStiffness
{
  double xx = 0.0, yy = 0.0, xy = 0.0, shear = 0.0; ///< [Pa]
  Vector<2> axis{{1.0, 0.0}};                       ///< in the undeformed body, of length one
};

} // namespace Rhegma
