#include "LatticeState.hpp"

#include "WilliamsField.hpp"

namespace Rhegma::energy_release::test
{

void setMaterial(State<2>& state, const Teuchos::ParameterList& material)
{
  state.materials.properties = {makeProperties(material, "Resin", state.method.plane)};
  state.materials.device = View<Properties*>("rhegma::materials", 1);
  Kokkos::deep_copy(state.materials.device, state.materials.properties[0]);
}

State<2> makeBody(double half, double cell, Plane plane, ShapeKind shape, const Vector<2>& shift)
{
  State<2> state;
  state.method.plane = plane;
  state.method.thickness = thickness;
  state.method.shape = shape;
  state.clock.step = 1;
  state.clock.dt = 1e-6;
  state.mesh.grid =
      makeGrid<2>({{-half - 2.0 * cell, -half - 2.0 * cell}}, {{half + 2.0 * cell, half + 2.0 * cell}}, cell);
  state.mesh.nodes.reserve(state.mesh.grid.numNodes, 0);

  Teuchos::ParameterList material;
  material.set<std::string>("Model", "Linear Elastic");
  material.set("Density", density);
  material.set("Young Modulus", young);
  material.set("Poisson Ratio", poisson);
  setMaterial(state, material);

  FieldTable& table = state.particles;
  table.add({fields::position, 2, "m", ""});
  table.add({fields::reference, 2, "m", ""});
  table.add({fields::velocity, 2, "m/s", ""});
  table.add({fields::mass, 1, "kg", ""});
  table.add({fields::volume, 1, "m3", ""});
  table.add({fields::deformation, gradientSize<2>, "", ""});
  table.add({fields::stress, symmetricSize<2>, "Pa", ""});
  table.add({fields::box, 2, "m", ""});
  table.add({fields::material, 1, "", "", true});
  const double edge = 0.5 * cell;
  const int n = static_cast<int>(std::lround(2.0 * half / edge));
  table.resize(n * n);
  const auto reference = table.real<2>(fields::reference);
  const auto box = table.real<2>(fields::box);
  const auto mass = table.scalar(fields::mass);
  const auto volume = table.scalar(fields::volume);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
      const int p = i * n + j;
      reference(p, 0) = -half + (i + 0.5 + shift[0]) * edge;
      reference(p, 1) = -half + (j + 0.5 + shift[1]) * edge;
      box(p, 0) = box(p, 1) = 0.5 * edge;
      volume(p) = edge * edge * thickness;
      mass(p) = density * volume(p);
    }
  deform(state, [](const Vector<2>&) { return Displacement{{{0.0, 0.0}}, {0.0, 0.0, 0.0, 0.0}}; });
  return state;
}

void deform(State<2>& state, const DisplacementField& field)
{
  const auto reference = state.particles.real<2>(fields::reference);
  const auto position = state.particles.real<2>(fields::position);
  const auto F = state.particles.real<gradientSize<2>>(fields::deformation);
  const auto stress = state.particles.real<symmetricSize<2>>(fields::stress);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    const Displacement d = field({{reference(p, 0), reference(p, 1)}});
    for (int i = 0; i < 2; ++i)
      position(p, i) = reference(p, i) + d.u[i];
    for (int k = 0; k < 4; ++k)
      F(p, k) = d.gradient[k] + (k == 0 || k == 3 ? 1.0 : 0.0);
    F(p, 4) = 1.0;
    updateStress<2>(state.materials.properties[0], &F(p, 0), &stress(p, 0), nullptr);
  }
}

void setMotion(State<2>& state, const std::function<Motion(const Vector<2>&)>& motion)
{
  for (int n = 0; n < state.mesh.grid.numNodes; ++n)
  {
    const Motion m = motion(state.mesh.grid.nodePosition(n));
    for (int d = 0; d < 2; ++d)
    {
      state.mesh.nodes.motion(n, d) = state.mesh.nodes.projection(n, d) = m.velocity[d];
      state.mesh.nodes.motion(n, Nodes<2>::accelerationAt + d) = m.acceleration[d];
    }
  }
}

NodalAcceleration<2> nodalAcceleration(const State<2>& state)
{
  const NodalAcceleration<2> acceleration("rhegma::acceleration", state.mesh.grid.numNodes);
  for (int n = 0; n < state.mesh.grid.numNodes; ++n)
    for (int d = 0; d < 2; ++d)
      acceleration(n, d) = state.mesh.nodes.motion(n, Nodes<2>::accelerationAt + d);
  return acceleration;
}

CrackFront<2> addFront(State<2>& state, const Vector<2>& tip, double angle)
{
  CrackFront<2> front;
  front.position = tip;
  front.direction = {{std::cos(angle), std::sin(angle)}};
  front.normal = {{-std::sin(angle), std::cos(angle)}};
  Crack<2> crack;
  crack.name = "Notch";
  state.cracks.cracks = {crack};
  state.cracks.fronts = {front};
  return front;
}

DisplacementField tipDisplacement(const State<2>& state, const CrackFront<2>& front, double modeI,
                                  double modeII)
{
  const double kolosov =
      state.method.plane == Plane::Stress ? (3.0 - poisson) / (1.0 + poisson) : 3.0 - 4.0 * poisson;
  const double shear = young / (2.0 * (1.0 + poisson));
  return [=](const Vector<2>& x)
  {
    const Vector<2> from = x - front.position;
    const double along = dot(from, front.direction), across = dot(from, front.normal);
    const double r = std::sqrt(along * along + across * across), theta = std::atan2(across, along);
    const double c = std::cos(0.5 * theta), s = std::sin(0.5 * theta);
    const double size = std::sqrt(r / (8.0 * std::atan(1.0))) / (2.0 * shear);
    const double own[2] = {
        size * (modeI * c * (kolosov - 1.0 + 2.0 * s * s) + modeII * s * (kolosov + 1.0 + 2.0 * c * c)),
        size * (modeI * s * (kolosov + 1.0 - 2.0 * c * c) - modeII * c * (kolosov - 1.0 - 2.0 * s * s))};
    const TipModuli moduli{shear, kolosov};
    const TipField one = williamsField(0, r, theta, moduli), two = williamsField(1, r, theta, moduli);
    const Vector<2> axis[2] = {front.direction, front.normal};
    Displacement d{{{0.0, 0.0}}, {0.0, 0.0, 0.0, 0.0}};
    for (int a = 0; a < 2; ++a)
    {
      d.u = d.u + own[a] * axis[a];
      for (int b = 0; b < 2; ++b)
      {
        const double value = modeI * one.gradient[a][b] + modeII * two.gradient[a][b];
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j)
            d.gradient[2 * i + j] += value * axis[a][i] * axis[b][j];
      }
    }
    return d;
  };
}

DisplacementField tipDisplacement(const CrackFront<2>& front, const CrackCompliance& material, double modeI,
                                  double modeII)
{
  return [=](const Vector<2>& x)
  {
    const Vector<2> from = x - front.position;
    const double along = dot(from, front.direction), across = dot(from, front.normal);
    const TipPosition at(std::hypot(along, across), std::atan2(across, along), material);
    const TipField one = at.field(0), two = at.field(1);
    const Vector<2> axis[2] = {front.direction, front.normal};
    Displacement d{{{0.0, 0.0}}, {0.0, 0.0, 0.0, 0.0}};
    for (int a = 0; a < 2; ++a)
    {
      d.u = d.u + (modeI * one.displacement[a] + modeII * two.displacement[a]) * axis[a];
      for (int b = 0; b < 2; ++b)
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j)
            d.gradient[2 * i + j] +=
                (modeI * one.gradient[a][b] + modeII * two.gradient[a][b]) * axis[a][i] * axis[b][j];
    }
    return d;
  };
}

} // namespace Rhegma::energy_release::test
