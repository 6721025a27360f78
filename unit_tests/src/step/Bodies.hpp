#pragma once
/// Scenes that tests put together, and the particles of their runs.

#include "output/CoreRow.hpp"
#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"
#include "step/Run.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <string>
#include <tuple>
#include <vector>

namespace Rhegma
{
namespace Test
{

/// The views of a state's particles, in host memory; `store` writes positions, velocities, deformation and
/// stress back.
template <int D>
struct HostParticles
{
  Kokkos::View<double*[D], Kokkos::LayoutRight, Kokkos::HostSpace> position, velocity;
  Kokkos::View<double * [gradientSize<D>], Kokkos::LayoutRight, Kokkos::HostSpace> deformation;
  Kokkos::View<double * [symmetricSize<D>], Kokkos::LayoutRight, Kokkos::HostSpace> stress;
  Kokkos::View<double*, Kokkos::LayoutRight, Kokkos::HostSpace> mass;
  int size;

  explicit HostParticles(const State<D>& state) : size(state.particles.size())
  {
    const FieldTable& table = state.particles;
    copy(position, table.real<D>(fields::position));
    copy(velocity, table.real<D>(fields::velocity));
    copy(deformation, table.real<gradientSize<D>>(fields::deformation));
    copy(stress, table.real<symmetricSize<D>>(fields::stress));
    copy(mass, table.scalar(fields::mass));
  }

  void store(State<D>& state) const
  {
    Kokkos::deep_copy(state.particles.template real<D>(fields::position), position);
    Kokkos::deep_copy(state.particles.template real<D>(fields::velocity), velocity);
    Kokkos::deep_copy(state.particles.template real<gradientSize<D>>(fields::deformation), deformation);
    Kokkos::deep_copy(state.particles.template real<symmetricSize<D>>(fields::stress), stress);
  }

  Vector<D> at(int p) const
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = position(p, d);
    return x;
  }

private:
  template <class Host, class Source>
  static void copy(Host& host, const Source& source)
  {
    host = Host("host", source.extent(0));
    Kokkos::deep_copy(host, source);
  }
};

template <int D>
Teuchos::Array<double> array(const Vector<D>& v)
{
  return Teuchos::Array<double>(v.c, v.c + D);
}

/// The same number along every axis.
template <int D>
Vector<D> all(double value)
{
  Vector<D> v;
  for (int d = 0; d < D; ++d)
    v[d] = value;
  return v;
}

/// Moves all particles.
template <int D>
void moveBody(State<D>& state, const Vector<D>& shift)
{
  const HostParticles<D> particles(state);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < D; ++d)
      particles.position(p, d) += shift[d];
  particles.store(state);
}

/// Gives all particles the same stress, of 1 Pa at most, all its components different.
template <int D>
void setUniformStress(State<D>& state)
{
  const HostParticles<D> particles(state);
  for (int p = 0; p < particles.size; ++p)
    for (int k = 0; k < symmetricSize<D>; ++k)
      particles.stress(p, k) = 1.0 - 0.3 * k;
  particles.store(state);
}

/// Names a test after its two parameters: the letters and digits of both.
struct CaseName
{
  std::string operator()(const testing::TestParamInfo<std::tuple<std::string, std::string>>& test) const
  {
    std::string name;
    for (const char c : std::get<0>(test.param) + std::get<1>(test.param))
      if (std::isalnum(static_cast<unsigned char>(c)) != 0)
        name += c;
    return name;
  }
};

/// A scene without bodies or materials, advanced by the test. \param scheme MUSL, USF, USL or USAVG \param
/// shape Linear or GIMP
template <int D>
Teuchos::ParameterList emptyScene(const Vector<D>& lower, const Vector<D>& upper, double cell,
                                  const std::string& scheme, const std::string& shape,
                                  const std::string& plane = "Strain")
{
  Teuchos::ParameterList scene("Rhegma");
  Teuchos::ParameterList& domain = scene.sublist("Domain");
  domain.set("Dimension", D);
  domain.set("Lower Corner", array(lower));
  domain.set("Upper Corner", array(upper));
  domain.set("Cell Size", cell);
  domain.set("Shape Functions", shape);
  if (D == 2)
    domain.set("Plane", plane);
  scene.sublist("Time").set("Final Time", 1e30);
  scene.sublist("Time").set("Maximum Steps",
                            1000000); // a limit that none reaches: the tests count steps themselves
  scene.sublist("Time").set("Update Scheme", scheme);
  return scene;
}

/// A solid with Young's modulus and density of 1, so that the speed of waves in a thin bar is 1 m/s.
inline void addMaterial(Teuchos::ParameterList& scene, const std::string& model, double poisson)
{
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  material.set("Model", model);
  material.set("Density", 1.0);
  if (model == "Mooney-Rivlin")
  {
    // E = 6 (C10 + C01) / (1 + mu / 3K) is close to 1 and Poisson's ratio 0.45.
    material.set("C10", 0.14);
    material.set("C01", 0.03);
    material.set("Bulk Modulus", 3.3);
    return;
  }
  if (model == "Ogden")
  {
    // mu = (0.4 x 1.5 + 0.04 x 2) / 2 = 0.34, as of Mooney-Rivlin.
    material.set("Moduli", Teuchos::Array<double>(Teuchos::tuple<double>(0.4, -0.04)));
    material.set("Exponents", Teuchos::Array<double>(Teuchos::tuple<double>(1.5, -2.0)));
    material.set("Bulk Modulus", 3.3);
    return;
  }
  material.set("Young Modulus", 1.0);
  material.set("Poisson Ratio", poisson);
  if (model == "J2 Plastic")
    material.set("Yield Stress", 1e3);
}

template <int D>
Teuchos::ParameterList& addBox(Teuchos::ParameterList& scene, const std::string& name, const Vector<D>& lower,
                               const Vector<D>& upper)
{
  Teuchos::ParameterList& body = scene.sublist("Bodies").sublist(name);
  body.set("Material", "Solid");
  body.set("Shape", "Box");
  body.set("Lower Corner", array(lower));
  body.set("Upper Corner", array(upper));
  return body;
}

template <int D>
Teuchos::ParameterList& addBall(Teuchos::ParameterList& scene, const std::string& name,
                                const Vector<D>& centre, double radius)
{
  Teuchos::ParameterList& body = scene.sublist("Bodies").sublist(name);
  body.set("Material", "Solid");
  body.set("Shape", "Ball");
  body.set("Centre", array(centre));
  body.set("Radius", radius);
  return body;
}

/// The scene as the program would take it; its mistakes fail the test.
inline Teuchos::ParameterList validated(Teuchos::ParameterList scene)
{
  std::vector<SceneError> errors;
  validateList(scene, effectSchema(), errors);
  for (const SceneError& error : errors)
    ADD_FAILURE() << toString(error);
  return scene;
}

} // namespace Test
} // namespace Rhegma
