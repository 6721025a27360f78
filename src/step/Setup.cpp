#include "step/Setup.hpp"

#include "base/ReadList.hpp"
#include "material/MaterialTable.hpp"
#include "material/Materials.hpp"
#include "material/ThermoMaterials.hpp"
#include "plan/Axis.hpp"
#include "plan/LastStage.hpp"
#include "state/Ancestry.hpp"
#include "state/AtRest.hpp"
#include "step/PlaceBodies.hpp"
#include "transfer/Box.hpp"

#include <algorithm>
#include <utility>

namespace Rhegma
{

namespace
{

template <int D>
Plane readPlane(const Teuchos::ParameterList& domain)
{
  if (D == 3)
    return Plane::Solid;
  return domain.get<std::string>("Plane") == "Stress" ? Plane::Stress : Plane::Strain;
}

template <int D>
void readMethod(const Teuchos::ParameterList& scene, State<D>& state)
{
  const Teuchos::ParameterList& domain = scene.sublist("Domain");
  const Teuchos::ParameterList& time = scene.sublist("Time");
  state.method.plane = readPlane<D>(domain);
  state.method.axisymmetric = isAxisymmetric(scene);
  state.method.thickness = state.method.axisymmetric ? wholeCircle
                           : D == 2                  ? domain.get<double>("Thickness")
                                                     : 1.0;
  state.method.shape =
      domain.get<std::string>("Shape Functions") == "Linear" ? ShapeKind::Linear : ShapeKind::Gimp;
  state.method.shear = domain.get<std::string>("Shear Strain") == "At Cell Centres"
                           ? ShearStrain::AtCellCentres
                           : ShearStrain::AtParticles;
  state.method.totalLagrangian = domain.get<std::string>("Formulation") == "Total Lagrangian";
  const std::string analysis =
      time.isType<std::string>("Analysis") ? time.get<std::string>("Analysis") : "Dynamic";
  state.method.analysis = analysis == "Static"         ? Analysis::Static
                          : analysis == "Quasi-Static" ? Analysis::QuasiStatic
                          : analysis == "Preload"      ? Analysis::Preload
                                                       : Analysis::Dynamic;
  state.method.handsOver = handsOver(scene);
  state.clock.finalTime = time.get<double>("Final Time");
  const std::string scheme = time.get<std::string>("Update Scheme");
  state.method.scheme = scheme == "USF"     ? UpdateScheme::Usf
                        : scheme == "USL"   ? UpdateScheme::Usl
                        : scheme == "USAVG" ? UpdateScheme::Usavg
                                            : UpdateScheme::Musl;
  state.clock.strainPass.before = state.method.scheme == UpdateScheme::Usf;
  state.method.cfl = time.get<double>("CFL");
  state.method.picFraction = time.get<double>("PIC Fraction");
  state.clock.maximumSteps = time.get<int>("Maximum Steps");
  state.mesh.grid = makeGrid<D>(readVector<D>(domain, "Lower Corner"), readVector<D>(domain, "Upper Corner"),
                                domain.get<double>("Cell Size"));
}

template <int D>
void readMaterials(const Teuchos::ParameterList& scene, State<D>& state)
{
  const Teuchos::ParameterList& section = scene.sublist("Materials");
  for (const std::string& name : sublistNames(section))
  {
    state.materials.names.push_back(name);
    // If there are tables, an effect replaces these values.
    const std::vector<double> tables = tableTemperatures(section.sublist(name));
    state.materials.properties.push_back(makeProperties(
        materialAt(section.sublist(name), tables.empty() ? 1.0 : tables.front()), name, state.method.plane));
    state.materials.properties.back().cellSize = scene.sublist("Domain").get<double>("Cell Size");
  }
  state.materials.device = View<Properties*>("rhegma::materials", state.materials.properties.size());
  const auto host = Kokkos::create_mirror_view(state.materials.device);
  std::copy(state.materials.properties.begin(), state.materials.properties.end(), host.data());
  Kokkos::deep_copy(state.materials.device, host);
}

template <int D>
void addFields(State<D>& state, const std::vector<Field>& extra)
{
  FieldTable& table = state.particles;
  table.add({fields::position, D, "m", "current position"});
  table.add({fields::reference, D, "m", "reference position"});
  if (state.method.totalLagrangian)
    table.add({fields::displacement, D, "m", "displacement since the start"});
  if (state.method.mechanics)
    table.add({fields::velocity, D, "m/s", "its velocity"});
  table.add({fields::mass, 1, "kg", "its mass"});
  table.add({fields::volume, 1, "m3", "undeformed volume"});
  table.add({fields::deformation, gradientSize<D>, "", "deformation gradient"});
  if (state.method.mechanics)
    table.add({fields::stress, symmetricSize<D>, "Pa", "Kirchhoff stress"});
  table.add({fields::edge, D, "m", "undeformed edge lengths along the axes of the body"});
  if (state.method.shape == ShapeKind::Gimp)
    table.add({fields::box, D, "m", "half widths of the particle domain (GIMP)"});
  int history = 0;
  for (const Properties& properties : state.materials.properties)
    history = std::max(history, historySize<D>(properties));
  if (history > 0 && state.method.mechanics)
    table.add({fields::history, history, "", "history variables of the constitutive law"});
  table.add({fields::material, 1, "", "index of the material", true});
  table.add({fields::body, 1, "", "index of the body", true});
  table.add({fields::id, 1, "", "id of the particle", true});
  for (const Field& field : extra)
    if (!table.has(field.name))
      table.add(field);
}

/// Initial velocity: a translation and a rotation about the body's centre of mass.
template <int D>
Vector<D> startVelocity(const Vector<D>& velocity, const std::vector<double>& spin, const Vector<D>& arm)
{
  Vector<D> v = velocity;
  if constexpr (D == 2)
  {
    v[0] -= spin[0] * arm[1];
    v[1] += spin[0] * arm[0];
  }
  else
    for (int d = 0; d < 3; ++d)
      v[d] += spin[(d + 1) % 3] * arm[(d + 2) % 3] - spin[(d + 2) % 3] * arm[(d + 1) % 3];
  return v;
}

/// The columns of the table that bodies fill, on the host.
template <int D>
struct StartColumns
{
  FieldTable& table;
  bool moves;
  Kokkos::View<double* [D], Kokkos::LayoutRight, Kokkos::HostSpace> velocity;
  decltype(onHost(std::declval<FieldTable&>().real<D>(fields::position))) position, edge;
  decltype(onHost(std::declval<FieldTable&>().scalar(fields::mass))) mass, volume;
  decltype(onHost(std::declval<FieldTable&>().real<gradientSize<D>>(fields::deformation))) deformation;
  decltype(onHost(std::declval<FieldTable&>().integer(fields::material))) material, body, id;
  decltype(material) level, ancestor, lineage; ///< empty where an effect has not added them

  explicit StartColumns(State<D>& state)
      : table(state.particles),
        moves(state.method.mechanics),
        velocity("rhegma::startVelocity", table.size()),
        position(onHost(table.template real<D>(fields::position))),
        edge(onHost(table.template real<D>(fields::edge))),
        mass(onHost(table.scalar(fields::mass))),
        volume(onHost(table.scalar(fields::volume))),
        deformation(onHost(table.template real<gradientSize<D>>(fields::deformation))),
        material(onHost(table.integer(fields::material))),
        body(onHost(table.integer(fields::body))),
        id(onHost(table.integer(fields::id)))
  {
    for (const auto& [column, name] : parts())
      if (table.has(name))
        *column = onHost(table.integer(name));
  }

  /// Columns of particles that are parts of larger ones.
  std::vector<std::pair<decltype(material)*, std::string>> parts()
  {
    return {{&level, fields::level}, {&ancestor, fields::ancestor}, {&lineage, fields::lineage}};
  }

  void store()
  {
    for (const auto& [column, name] : parts())
      if (table.has(name))
        Kokkos::deep_copy(table.integer(name), *column);
    Kokkos::deep_copy(table.template real<D>(fields::position), position);
    Kokkos::deep_copy(table.template real<D>(fields::reference), position);
    if (moves)
      Kokkos::deep_copy(table.template real<D>(fields::velocity), velocity);
    Kokkos::deep_copy(table.scalar(fields::mass), mass);
    Kokkos::deep_copy(table.scalar(fields::volume), volume);
    Kokkos::deep_copy(table.template real<gradientSize<D>>(fields::deformation), deformation);
    Kokkos::deep_copy(table.template real<D>(fields::edge), edge);
    Kokkos::deep_copy(table.integer(fields::material), material);
    Kokkos::deep_copy(table.integer(fields::body), body);
    Kokkos::deep_copy(table.integer(fields::id), id);
  }
};

template <int D>
Vector<D> centroid(const Seeds<D>& seeds)
{
  double all = 0.0;
  for (const double volume : seeds.volume)
    all += volume;
  Vector<D> centre{};
  for (std::size_t k = 0; k < seeds.position.size(); ++k)
    centre = centre + (seeds.volume[k] / all) * seeds.position[k];
  return centre;
}

/// Writes particles first .. of a body.
template <int D>
void writeParticles(const PlacedBody<D>& body, int number, int first, const State<D>& state,
                    const StartColumns<D>& columns)
{
  const Seeds<D>& seeds = body.seeds;
  const int count = static_cast<int>(seeds.position.size());
  const int material = state.bodies.info[number].material;
  const Vector<D> centre = centroid(seeds);
  const Vector<D> velocity = readVector<D>(*body.list, "Velocity");
  const auto spin = body.list->template get<Teuchos::Array<double>>("Angular Velocity").toVector();
  const double density = state.materials.properties[material].density;
  for (int k = 0; k < count; ++k)
  {
    const int p = first + k;
    const double volume = seeds.volume[k] * state.method.depth().at(seeds.position[k][0]);
    const Vector<D> v = startVelocity<D>(velocity, spin, seeds.position[k] - centre);
    for (int d = 0; d < D; ++d)
    {
      columns.position(p, d) = seeds.position[k][d];
      columns.velocity(p, d) = v[d];
      columns.deformation(p, d * D + d) = 1.0;
      columns.edge(p, d) = seeds.box[k][d];
    }
    if (D == 2)
      columns.deformation(p, 4) = 1.0;
    columns.mass(p) = density * volume;
    columns.volume(p) = volume;
    columns.material(p) = material;
    columns.body(p) = number;
    columns.id(p) = p;
    if (columns.level.extent(0) > 0)
      columns.level(p) = seeds.level[k];
    if (columns.ancestor.extent(0) > 0)
      columns.ancestor(p) = first + seeds.family[k];
    if (columns.lineage.extent(0) > 0)
      columns.lineage(p) = seeds.lineage[k];
  }
}

template <int D>
void addBodies(const std::vector<PlacedBody<D>>& bodies, State<D>& state)
{
  std::size_t all = 0;
  for (const PlacedBody<D>& body : bodies)
  {
    BodyInfo<D> info;
    info.name = body.name;
    const auto material = std::find(state.materials.names.begin(), state.materials.names.end(),
                                    body.list->template get<std::string>("Material"));
    info.material = static_cast<int>(material - state.materials.names.begin());
    for (int e = 0; e < D; ++e)
      for (int d = 0; d < D; ++d)
        info.axes[e][d] = body.seeds.axes[e][d];
    info.edge = body.seeds.edge;
    state.bodies.info.push_back(info);
    all += body.seeds.position.size();
  }
  state.particles.resize(static_cast<int>(all));
  StartColumns<D> columns(state);
  int first = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    writeParticles(bodies[b], static_cast<int>(b), first, state, columns);
    first += static_cast<int>(bodies[b].seeds.position.size());
  }
  columns.store();
}

template <int D>
void makeBodyAxes(State<D>& state)
{
  state.bodies.axes = View<double* [D][D]>("rhegma::bodyAxes", state.bodies.info.size());
  const auto host = Kokkos::create_mirror_view(state.bodies.axes);
  for (std::size_t b = 0; b < state.bodies.info.size(); ++b)
    for (int e = 0; e < D; ++e)
      for (int d = 0; d < D; ++d)
        host(b, e, d) = state.bodies.info[b].axes[e][d];
  Kokkos::deep_copy(state.bodies.axes, host);
}

template <int D>
void makeBoxes(State<D>& state)
{
  const auto axes = state.bodies.axes;
  const auto body = state.particles.integer(fields::body);
  const auto edge = state.particles.template real<D>(fields::edge);
  const auto F = state.particles.template real<gradientSize<D>>(fields::deformation);
  const auto box = state.particles.template real<D>(fields::box);
  BorrowedView<int*> level;
  if (state.particles.has(fields::level))
    level = state.particles.integer(fields::level);
  const double largest = 0.5 * state.mesh.grid.spacing;
  Kokkos::parallel_for(
      "rhegma::makeBoxes", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        const double most = level.extent(0) > 0 ? largest / (1 << level(p)) : largest;
        updateBox<D>(axes, body(p), &edge(p, 0), &F(p, 0), most, &box(p, 0));
      });
}

/// Below this fraction of a particle the parts that a crack makes of it are joined with others. With a half,
/// as at the edges of bodies, cells next to the crack had fewer particles than nodes, whose forces then moved
/// particles to and fro for the whole run.
constexpr double joinedAtCracks = 0.05;

/// Particles near cracks sit evenly in the cells as long as they stay in them: at rest, or where the cells
/// lie in the undeformed body. Elsewhere the lattice of a body, which has no parts at its edges, integrates
/// constant strain exactly at any place.
template <int D>
SeedRules<D> rulesOf(const State<D>& state, const RulesOfSeeds<D>& rules)
{
  SeedRules<D> all = rules ? rules(state) : SeedRules<D>{};
  if (all.cuts.ofBox)
    all.joinedBelowAtCuts = joinedAtCracks;
  if ((staysAtRest(state) || state.method.totalLagrangian) && all.cuts.ofBox)
  {
    all.node.emplace();
    for (int d = 0; d < D; ++d)
      (*all.node)[d] = state.mesh.grid.lower[d];
  }
  return all;
}

} // namespace

template <int D>
void makeState(const Teuchos::ParameterList& scene, const std::vector<Field>& extra, State<D>& state,
               const RulesOfSeeds<D>& rules)
{
  readMethod(scene, state);
  readMaterials(scene, state);
  addFields(state, extra);
  const Teuchos::ParameterList& bodies = scene.sublist("Bodies");
  addBodies(placeBodies<D>(bodies, state, rulesOf(state, rules)), state);
  makeBodyAxes(state);
  if (state.method.shape == ShapeKind::Gimp)
    makeBoxes(state);
  state.mesh.nodes.reserve(state.mesh.grid.numNodes, 0);
}

template void makeState(const Teuchos::ParameterList&, const std::vector<Field>&, State<2>&,
                        const RulesOfSeeds<2>&);
template void makeState(const Teuchos::ParameterList&, const std::vector<Field>&, State<3>&,
                        const RulesOfSeeds<3>&);

} // namespace Rhegma
