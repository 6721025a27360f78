#include "output/Snapshot.hpp"

#include "output/CellMesh.hpp"
#include "output/LawStates.hpp"
#include "state/ParticleDamage.hpp"
#include "state/ParticleStress.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

using Role = DataSet::Role;

/// A table of D columns with a column of zeros in 2D.
template <int D, class HostView>
DataSet padded(const std::string& name, Role role, const HostView& values, std::size_t rows)
{
  DataSet set{name, role, 3, false, std::vector<double>(3 * rows, 0.0), {}};
  for (std::size_t i = 0; i < rows; ++i)
    for (int d = 0; d < D; ++d)
      set.real[3 * i + d] = values(i, d);
  return set;
}

template <class HostView>
DataSet table(const std::string& name, const HostView& values)
{
  DataSet set{name, Role::OnPoints, static_cast<int>(values.extent(1)), false, {}, {}};
  set.real.reserve(values.size());
  for (std::size_t i = 0; i < values.extent(0); ++i)
    for (std::size_t c = 0; c < values.extent(1); ++c)
      set.real.push_back(values(i, c));
  return set;
}

template <class HostView>
DataSet numbers(const std::string& name, const HostView& values)
{
  DataSet set{name, Role::OnPoints, 1, true, {}, {}};
  for (std::size_t i = 0; i < values.extent(0); ++i)
    set.whole.push_back(values(i));
  return set;
}

/// Cauchy stress xx yy zz xy yz xz [Pa], and in a seventh column its von Mises stress.
template <int D>
View<double* [7]> stressOf(const FieldTable& particles)
{
  const ParticleStress<D> of(particles);
  View<double* [7]> stress("rhegma::cauchyStress", particles.size());
  Kokkos::parallel_for(
      "rhegma::cauchyStress", Kokkos::RangePolicy<ExecSpace>(0, particles.size()),
      KOKKOS_LAMBDA(const int p) {
        double s[6];
        of.cauchy(p, s);
        for (int i = 0; i < 6; ++i)
          stress(p, i) = s[i];
        stress(p, 6) = vonMisesStress(s);
      });
  return stress;
}

void addStress(const View<double* [7]>& device, OutputMesh& mesh)
{
  const auto host = onHost(device);
  DataSet stress{"stress", Role::OnPoints, 6, false, {}, {}};
  DataSet vonMises{"von_mises", Role::OnPoints, 1, false, {}, {}};
  for (std::size_t p = 0; p < host.extent(0); ++p)
  {
    for (int i = 0; i < 6; ++i)
      stress.real.push_back(host(p, i));
    vonMises.real.push_back(host(p, 6));
  }
  mesh.data.push_back(std::move(stress));
  mesh.data.push_back(std::move(vonMises));
}

/// A number a particle, computed by value(p) on the device.
template <int D, class Value>
DataSet derived(const std::string& name, const State<D>& state, const Value& value)
{
  View<double*> values("rhegma::" + name, state.particles.size());
  Kokkos::parallel_for(
      "rhegma::" + name, Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) { values(p) = value(p); });
  const auto host = onHost(values);
  return {name, Role::OnPoints, 1, false, std::vector<double>(host.data(), host.data() + host.size()), {}};
}

/// Fields that are written on request.
template <int D>
void addRequested(const State<D>& state, const RequestedFields& fields, OutputMesh& mesh)
{
  if (fields.principalStress)
    mesh.data.push_back(
        derived("principal_stress", state, PrincipalStressOf<D>{ParticleStress<D>(state.particles)}));
  if (fields.energyDensity)
    mesh.data.push_back(derived("energy_density", state, EnergyDensityOf<D>{ParticleEnergy<D>(state)}));
  if (fields.damage && hasDamage(state))
    mesh.data.push_back(derived("damage", state, DamageOf<D>(state)));
  if (fields.stateVariables)
    for (DataSet& set : lawStates(state))
      mesh.data.push_back(std::move(set));
}

/// F row by row, nine columns.
template <int D>
DataSet deformationGradients(const FieldTable& particles)
{
  const auto F = onHost(particles.real<gradientSize<D>>(fields::deformation));
  DataSet set{"deformation", Role::OnPoints, 9, false, std::vector<double>(9 * F.extent(0), 0.0), {}};
  for (std::size_t p = 0; p < F.extent(0); ++p)
  {
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        set.real[9 * p + 3 * i + j] = F(p, i * D + j);
    if (D == 2)
      set.real[9 * p + 8] = F(p, 4);
  }
  return set;
}

/// Undeformed edge vectors of each particle, one after another, nine columns [m]; zero out of the plane. With
/// F they give the current box of the particle.
template <int D>
DataSet edgeVectors(const State<D>& state)
{
  const auto length = onHost(state.particles.template real<D>(fields::edge));
  const auto body = onHost(state.particles.integer(fields::body));
  DataSet set{"edges", Role::OnPoints, 9, false, std::vector<double>(9 * length.extent(0), 0.0), {}};
  for (std::size_t p = 0; p < length.extent(0); ++p)
    for (int e = 0; e < D; ++e)
      for (int d = 0; d < D; ++d)
        set.real[9 * p + 3 * e + d] = length(p, e) * state.bodies.info[body(p)].axes[e][d];
  return set;
}

/// A field's name as a name in the file.
std::string fileName(std::string name)
{
  for (char& c : name)
    if (c == ' ' || c == '/')
      c = '_';
  return name;
}

/// The fields of the method, some of which are written under other names.
bool isCoreField(const std::string& name)
{
  using namespace fields;
  for (const std::string& core : {position, reference, displacement, velocity, mass, volume, deformation,
                                  stress, fields::edge, box, history, material, body, id})
    if (name == core)
      return true;
  return false;
}

template <int D>
OutputMesh particleMesh(const State<D>& state, const RequestedFields& requested)
{
  const FieldTable& particles = state.particles;
  const std::size_t n = particles.size();
  const auto position = onHost(particles.real<D>(fields::position));
  const auto reference = onHost(particles.real<D>(fields::reference));
  const bool undeformed = particles.has(fields::displacement);
  const auto edge = onHost(particles.real<D>(fields::edge));
  OutputMesh mesh{"particles", "Polyvertex", {}};
  mesh.data.push_back(padded<D>("position", Role::Points, position, n));
  mesh.data.push_back(padded<D>("displacement", Role::OnPoints, position, n));
  std::vector<double>& displacement = mesh.data.back().real;
  if (undeformed)
  {
    const auto moved = onHost(particles.real<D>(fields::displacement));
    for (std::size_t p = 0; p < n; ++p)
      for (int d = 0; d < D; ++d)
        displacement[3 * p + d] = (mesh.data[mesh.data.size() - 2].real[3 * p + d] += moved(p, d));
  }
  DataSet firstEdge{"edge", Role::OnPoints, 1, false, {}, {}};
  DataSet cells{"cells", Role::Cells, 1, true, {}, {}};
  for (std::size_t p = 0; p < n; ++p)
  {
    for (int d = 0; d < D; ++d)
      displacement[3 * p + d] -= reference(p, d);
    firstEdge.real.push_back(edge(p, 0));
    cells.whole.push_back(static_cast<int>(p));
  }
  mesh.data.push_back(std::move(cells));
  if (state.method.mechanics)
    mesh.data.push_back(
        padded<D>("velocity", Role::OnPoints, onHost(particles.real<D>(fields::velocity)), n));
  if (state.method.mechanics)
  {
    addStress(stressOf<D>(particles), mesh);
    addRequested(state, requested, mesh);
  }
  mesh.data.push_back(table("mass", onHost(particles.table(fields::mass))));
  mesh.data.push_back(std::move(firstEdge));
  mesh.data.push_back(deformationGradients<D>(particles));
  mesh.data.push_back(edgeVectors(state));
  mesh.data.push_back(numbers("body", onHost(particles.integer(fields::body))));
  mesh.data.push_back(numbers("material", onHost(particles.integer(fields::material))));
  for (const Field& field : particles.fields())
    if (!isCoreField(field.name))
      mesh.data.push_back(field.integer ? numbers(fileName(field.name), onHost(particles.integer(field.name)))
                                        : table(fileName(field.name), onHost(particles.table(field.name))));
  return mesh;
}

template <int D>
OutputMesh crackMesh(const CrackSet<D>& set)
{
  std::size_t vertices = 0;
  std::size_t simplices = 0;
  for (const Crack<D>& crack : set.cracks)
  {
    vertices = std::max<std::size_t>(vertices, crack.firstVertex + crack.numVertices);
    simplices = std::max<std::size_t>(simplices, crack.firstSimplex + crack.numSimplices);
  }
  const auto face = onHost(set.face);
  const auto simplex = onHost(set.simplex);
  const auto crackOf = onHost(set.crackOf);
  OutputMesh mesh{"cracks", D == 2 ? "Polyline" : "Triangle", {}};
  mesh.onAllRanks = true;
  mesh.data.push_back(padded<D>("points", Role::Points, onHost(set.vertex), vertices));
  if (const auto carried = onHost(set.carried); carried.extent(0) > 0)
    for (std::size_t v = 0; v < vertices; ++v)
      for (int d = 0; d < D; ++d)
        mesh.data.back().real[3 * v + d] += carried(v, d);
  DataSet opening{"opening", Role::OnPoints, 3, false, std::vector<double>(3 * vertices, 0.0), {}};
  for (std::size_t v = 0; v < vertices; ++v)
    for (int d = 0; d < D; ++d)
      opening.real[3 * v + d] = face(v, 1, d) - face(v, 0, d);
  DataSet cells{"cells", Role::Cells, D, true, {}, {}};
  DataSet owner{"crack", Role::OnCells, 1, true, {}, {}};
  for (std::size_t s = 0; s < simplices; ++s)
  {
    for (int k = 0; k < D; ++k)
      cells.whole.push_back(simplex(s, k));
    owner.whole.push_back(crackOf(s));
  }
  mesh.data.push_back(std::move(cells));
  mesh.data.push_back(std::move(opening));
  mesh.data.push_back(std::move(owner));
  return mesh;
}

template <int D>
OutputMesh toolMesh(const std::vector<ToolOutline<D>>& tools)
{
  OutputMesh mesh{"tools", D == 2 ? "Polyline" : "Triangle", {}};
  mesh.onAllRanks = true;
  DataSet points{"points", Role::Points, 3, false, {}, {}};
  DataSet cells{"cells", Role::Cells, D, true, {}, {}};
  DataSet owner{"tool", Role::OnCells, 1, true, {}, {}};
  for (std::size_t k = 0; k < tools.size(); ++k)
  {
    const int before = static_cast<int>(points.rows());
    for (const Vector<D>& x : tools[k].points)
      for (int d = 0; d < 3; ++d)
        points.real.push_back(d < D ? x[d] : 0.0);
    for (const std::array<int, D>& cell : tools[k].cells)
    {
      for (const int point : cell)
        cells.whole.push_back(before + point);
      owner.whole.push_back(static_cast<int>(k));
    }
  }
  mesh.data.push_back(std::move(points));
  mesh.data.push_back(std::move(cells));
  mesh.data.push_back(std::move(owner));
  return mesh;
}

} // namespace

template <int D>
Snapshot makeSnapshot(const State<D>& state, const RequestedFields& requested)
{
  Snapshot snapshot;
  snapshot.time = state.clock.time;
  snapshot.meshes.push_back(particleMesh(state, requested));
  snapshot.meshes.push_back(cellMesh(state));
  if (!state.cracks.empty())
    snapshot.meshes.push_back(crackMesh<D>(state.cracks));
  if (std::any_of(state.tools.begin(), state.tools.end(),
                  [](const ToolOutline<D>& tool) { return !tool.cells.empty(); }))
    snapshot.meshes.push_back(toolMesh<D>(state.tools));
  return snapshot;
}

template Snapshot makeSnapshot(const State<2>&, const RequestedFields&);
template Snapshot makeSnapshot(const State<3>&, const RequestedFields&);

} // namespace Rhegma
