#pragma once
/// The law of contact at a point of the faces.

#include "base/Types.hpp"

namespace Rhegma::contact
{

enum class Law
{
  Stick,
  Frictionless,
  Coulomb
};

/// What contact needs to know about a material.
struct Stiffness
{
  double normal;     ///< traction per overlap [Pa/m]
  double tangential; ///< traction per elastic slip [Pa/m]
};

/// The law at a point over one step; T tangents.
template <int T>
struct Return
{
  double pressure;
  Vector<T> shear, slip;
  double heat;
};

/// \param gap now \param moved slip over the step \param slip elastic slip before \param before shear before
template <int T>
KOKKOS_INLINE_FUNCTION Return<T> returnMap(Law law, double friction, const Stiffness& k, double gap,
                                           bool closed, const Vector<T>& moved, const Vector<T>& slip,
                                           const Vector<T>& before)
{
  Return<T> r{gap < 0.0 ? -k.normal * gap : 0.0, {}, {}, 0.0};
  // Faces that have just met begin without slip.
  const Vector<T> trial = closed ? slip + moved : Vector<T>{};
  double limit = 0.0;
  if (r.pressure > 0.0 && law == Law::Stick)
    limit = 1e300;
  if (law == Law::Coulomb)
    limit = friction * r.pressure;
  r.shear = k.tangential * trial;
  r.slip = trial;
  const double size = norm(r.shear);
  if (size > limit)
  {
    r.shear = (limit / size) * r.shear;
    r.slip = (1.0 / k.tangential) * r.shear;
  }
  // By the mean traction, as the energy of the layer changes by it.
  r.heat = 0.5 * dot(before + r.shear, trial - r.slip);
  return r;
}

} // namespace Rhegma::contact
