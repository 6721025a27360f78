#pragma once
/// Friction of surfaces that press on each other.

#include "base/Types.hpp"

namespace Rhegma
{

/// Coefficients of friction: infinite where surfaces stick, zero where they slide freely.
struct FrictionLaw
{
  double atRest = 0.0;  ///< up to which they stick [-]
  double sliding = 0.0; ///< while they slide [-]
};

/// What one of two surfaces gets from the other.
template <int D>
struct ContactImpulse
{
  Vector<D> impulse{};   ///< [N s]; zero where the two do not press on each other
  double pressing = 0.0; ///< its part along the normal [N s]
  bool sticks = false;   ///< whether the two do not move along each other
};

/// The impulse of a contact: all of the one after which the two surfaces move alike, if it presses and
/// friction bears the part along the surface; else that part is cut to the sliding friction. \param n unit
/// normal towards the surface that gets the impulse \param alike the impulse after which both move alike
/// [N s]
template <int D>
KOKKOS_INLINE_FUNCTION ContactImpulse<D> contactImpulse(const FrictionLaw& law, const Vector<D>& n,
                                                        const Vector<D>& alike)
{
  ContactImpulse<D> contact;
  const double pressing = dot(n, alike);
  if (!(pressing > 0.0))
    return contact;
  const Vector<D> along = alike - pressing * n;
  const double size = norm(along);
  const double fraction = size <= law.atRest * pressing ? 1.0 : law.sliding * pressing / size;
  contact.impulse = pressing * n + fraction * along;
  contact.pressing = pressing;
  contact.sticks = fraction == 1.0 && law.atRest > 0.0;
  return contact;
}

} // namespace Rhegma
