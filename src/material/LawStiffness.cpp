#include "material/LawStiffness.hpp"

#include "material/Materials.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

template <class Law, class = void>
struct HasDirections : std::false_type
{
};
template <class Law>
struct HasDirections<Law, std::void_t<decltype(&Law::planeStiffness)>> : std::true_type
{
};

template <class Law, class = void>
struct IsHooke : std::false_type
{
};
template <class Law>
struct IsHooke<Law, std::void_t<decltype(Law::linear)>> : std::bool_constant<Law::linear>
{
};

struct LinearCall
{
  template <class Law, int, Plane>
  bool run() const
  {
    return IsHooke<Law>::value;
  }
};

struct AnisotropicCall
{
  template <class Law, int, Plane>
  bool run() const
  {
    return HasDirections<Law>::value;
  }
};

struct StiffestCall
{
  const Properties& m;
  template <class Law, int, Plane>
  double run() const
  {
    if constexpr (HasDirections<Law>::value)
      return Law::stiffestModulus(m);
    else
      return m.planeLambda + 2.0 * m.mu;
  }
};

struct SurfaceWaveCall
{
  const Properties& m;
  template <class Law, int, Plane>
  double run() const
  {
    if constexpr (HasDirections<Law>::value)
      return Law::surfaceWaveModulus(m);
    else
      return m.mu;
  }
};

struct InPlaneCall
{
  const Properties& m;
  template <class Law, int, Plane>
  PlaneStiffness run() const
  {
    if constexpr (HasDirections<Law>::value)
      return Law::planeStiffness(m);
    else
      return {m.planeLambda + 2.0 * m.mu, m.planeLambda + 2.0 * m.mu, m.planeLambda, m.mu, {{1.0, 0.0}}};
  }
};

} // namespace

bool isLinear(const Properties& properties) { return withLaw<3>(properties.law, Plane::Solid, LinearCall{}); }

bool isAnisotropic(const Properties& properties)
{
  return withLaw<3>(properties.law, Plane::Solid, AnisotropicCall{});
}

bool haveSameStiffness(const Properties& a, const Properties& b)
{
  return a.law == b.law && a.mu == b.mu && a.bulk == b.bulk &&
         (!isAnisotropic(a) || std::equal(a.own, a.own + lawNumbers, b.own));
}

double stiffestModulus(const Properties& properties)
{
  return withLaw<3>(properties.law, Plane::Solid, StiffestCall{properties});
}

double surfaceWaveModulus(const Properties& properties)
{
  return withLaw<3>(properties.law, Plane::Solid, SurfaceWaveCall{properties});
}

PlaneStiffness planeStiffness(const Properties& properties)
{
  return withLaw<3>(properties.law, Plane::Solid, InPlaneCall{properties});
}

} // namespace Rhegma
