#include "state/StateArchive.hpp"

#include "grid/LeafList.hpp"
#include "state/EnergySums.hpp"
#include "state/MovingCells.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <numeric>

namespace Rhegma
{

namespace
{

void archiveEnergyBalance(EnergyBalance& energy, Archive& archive)
{
  const Archive::Group group(archive, "energy");
  archive("kinetic", energy.kinetic);
  archive("strain", energy.strain);
  archive("tools", energy.tools);
  archive("start", energy.start);
  archive("thermal", energy.thermal);
  archive("thermal_start", energy.thermalStart);
  archive("heat", energy.heat);
  archive("round_off", energy.roundOff);
  archive("external_work", energy.externalWork);
  archive.parts("springs", energy.springs);
  archive("damped", energy.damped);
  archive("plastic", energy.plastic);
  archive("contact", energy.contact);
  archive("fracture", energy.fracture);
  archive("merged", energy.merged);
  archive("combustion", energy.combustion);
  archive("stabilised", energy.stabilised);
  archive("filtered", energy.filtered);
}

template <int D>
void archiveEnergies(State<D>& state, Archive& archive)
{
  EnergyBalance energy = archive.loads() ? EnergyBalance() : energyOfAllRanks(state);
  archiveEnergyBalance(energy, archive);
  if (archive.loads())
    state.energy = state.sample.energy = energy;
}

template <int D>
void archiveProgress(State<D>& state, Archive& archive)
{
  const Archive::Group group(archive, "run");
  archive("time", state.clock.time);
  archive("dt", state.clock.dt);
  archive("step", state.clock.step);
  archive("fastest", state.clock.fastestSpeed);
  archive("particle_steps", state.particles.particleSteps);
  archive("momentum", state.sample.momentum);
  archive("sample_step", state.sample.step);
  archive("settled", state.clock.settled);
  if (state.method.analysis == Analysis::LoadFactor)
    archive("load_factor", state.clock.factor.end);
  archive("warnings", state.warnings);
}

/// Leaves by level and position, counted in cells of the level from node 0.
template <int D>
void archiveTree(State<D>& state, Archive& archive)
{
  const Archive::Group group(archive, "leaves");
  Tree<D>& tree = state.mesh.tree;
  std::vector<int> level, cell;
  if (!archive.loads())
  {
    const Branches<D> refined = refinedCells(state);
    const LeafList<D> list(refined);
    level = list.level;
    for (const auto& at : list.cell)
      cell.insert(cell.end(), at.begin(), at.end());
  }
  archive("level", level);
  archive("cell", cell, D);
  int generation = tree.generation;
  archive("generation", generation);
  if (!archive.loads())
    return;
  if (cell.size() != D * level.size())
    throw std::invalid_argument("\"leaves/cell\" has another number of rows than \"leaves/level\"");
  std::vector<LeafName<D>> leaves(level.size());
  for (std::size_t l = 0; l < leaves.size(); ++l)
  {
    leaves[l].level = level[l];
    std::copy_n(cell.begin() + D * l, D, leaves[l].cell.begin());
  }
  buildTree(branchesOf(state.mesh.grid, leaves), tree);
  tree.generation = generation;
}

/// Rows of the particles of all ranks, one rank after another, in the order of their ids; on the first rank.
std::vector<int> orderOfIds(const FieldTable& particles, const Ranks& ranks)
{
  const auto own = onHost(particles.integer(fields::id));
  const std::vector<int> id = ranks.gather(std::vector<int>(own.data(), own.data() + particles.size()));
  std::vector<int> order(ranks.rank() == 0 ? id.size() : 0);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return id[a] < id[b]; });
  return order;
}

/// A field as a table in the order of the ids. \param order row of the particle with each of them
template <class AnyView, class T>
void archiveField(const std::string& name, const AnyView& field, int columns, const std::vector<int>& order,
                  std::vector<T>& table, Archive& archive)
{
  const auto host = onHost(field);
  T* const values = host.data();
  if (!archive.loads())
  {
    const std::size_t own = static_cast<std::size_t>(host.extent(0)) * columns;
    const std::vector<T> all = archive.ranks().gather(std::vector<T>(values, values + own));
    table.resize(order.size() * columns);
    for (std::size_t k = 0; k < order.size(); ++k)
      std::copy_n(all.data() + static_cast<std::size_t>(order[k]) * columns, columns,
                  table.data() + k * columns);
    return archive(name, table, columns);
  }
  archive(name, table, columns);
  if (table.size() != order.size() * columns)
    throw std::invalid_argument("\"particles/" + name +
                                "\" has another number of rows than there are particles");
  for (std::size_t k = 0; k < order.size(); ++k)
    std::copy_n(table.data() + k * columns, columns, values + static_cast<std::size_t>(order[k]) * columns);
  Kokkos::deep_copy(field, host);
}

/// The order in which the run has its particles, by their positions in the order of ids; not loaded where it
/// does not fit. \return row of the particle with each of the ids in their order
template <int D>
std::vector<int> archiveOrder(State<D>& state, Archive& archive)
{
  const Archive::Group group(archive, "order");
  int ranks = archive.ranks().size(), width = lanes, count = allParticles(state);
  archive("ranks", ranks);
  archive("lanes", width);
  archive("particles", count);
  archive.setSameOrder(ranks == 1 && width == lanes && !archive.ranks().many());
  std::vector<int> order;
  if (!archive.loads())
    order = orderOfIds(state.particles, archive.ranks());
  else
    state.particles.resize(count);
  if (archive.sameOrder())
    archive("row", order);
  if (archive.sameOrder() && static_cast<int>(order.size()) != count)
    throw std::invalid_argument("\"order/row\" has another number of rows than there are particles");
  if (archive.loads() && !archive.sameOrder())
  {
    order.resize(count);
    std::iota(order.begin(), order.end(), 0);
  }
  return order;
}

template <int D>
void archiveBlocks(State<D>& state, Archive& archive)
{
  const Archive::Group group(archive, "order");
  if (!archive.sameOrder())
  {
    state.particles.sorted = false;
    return;
  }
  Blocks<D>& blocks = state.mesh.blocks;
  archive("sorted", state.particles.sorted);
  archive("first", blocks.first);
  archive("corner", blocks.corner);
  archive("bundle first", blocks.bundleFirst);
  archive("bundle block", blocks.bundleBlock);
  archive("nearby", blocks.nearby);
  archive("refined", blocks.refined);
  archive("strays", blocks.strays);
  archive("colour start", blocks.colourStart);
  archive("blocks", blocks.numBlocks);
  archive("bundles", blocks.numBundles);
  archive("active nodes", state.mesh.nodes.active);
  archive("index of particle", state.particles.indexOf);
  // Capacity of nodal values in rows: caches have as many rows.
  int rows = static_cast<int>(state.mesh.nodes.sums.extent(0));
  archive("nodal rows", rows);
  archive("enriched fields", state.mesh.nodes.numEnriched);
  if (archive.loads()) // of which kind they are is known from the next step on
    state.mesh.nodes.numOfCracks = state.mesh.nodes.numEnriched;
  if (archive.loads())
    state.mesh.nodes.reserve(state.mesh.nodes.numLattice, rows - state.mesh.nodes.numLattice);
}

template <int D>
void archiveParticles(State<D>& state, Archive& archive)
{
  const std::vector<int> order = archiveOrder(state, archive);
  const Archive::Group group(archive, "particles");
  std::vector<double> real;
  std::vector<int> whole;
  for (const Field& field : state.particles.fields())
    if (field.integer)
      archiveField(field.name, state.particles.integer(field.name), 1, order, whole, archive);
    else
      archiveField(field.name, state.particles.table(field.name), field.components, order, real, archive);
}

} // namespace

template <int D>
void archiveState(State<D>& state, Archive& archive)
{
  archiveProgress(state, archive);
  archiveEnergies(state, archive);
  if (archive.loads())
    gatherLattice(state);
  archiveCells(state, archive);
  archiveTree(state, archive);
  archiveParticles(state, archive);
  if (archive.loads())
  {
    state.mesh.nodes.reserve(state.mesh.grid.numNodes + state.mesh.tree.numFine, 0);
    divideState(state);
  }
  archiveBlocks(state, archive);
}

template <int D>
void archiveNodalFields(State<D>& state, Archive& archive)
{
  NodalFieldTable<D>& table = state.mesh.nodalFields;
  const std::vector<NodalField> fields = table.fields();
  const Archive::Group group(archive, "nodal fields");
  if (archive.loads())
    table.layOut(nodesOfFields(state));
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    const Archive::Group own(archive, fields[f].field.name);
    const std::size_t name = table.nameWidth, components = fields[f].field.components;
    std::vector<int> nodes;
    std::vector<double> values, rows;
    if (!archive.loads())
      rows = table.namedRows(static_cast<int>(f));
    for (std::size_t k = 0; k < rows.size(); k += name + components)
    {
      nodes.insert(nodes.end(), &rows[k], &rows[k + name]);
      values.insert(values.end(), &rows[k + name], &rows[k + name] + components);
    }
    archive.together("node", nodes, name);
    archive.together("value", values, components);
    if (!archive.loads())
      continue;
    if (nodes.size() / name != values.size() / components)
      throw std::invalid_argument("\"node\" of the nodal field \"" + fields[f].field.name +
                                  "\" has another number of rows than \"value\"");
    for (std::size_t k = 0; k < nodes.size() / name; ++k)
    {
      rows.insert(rows.end(), &nodes[k * name], &nodes[k * name] + name);
      rows.insert(rows.end(), &values[k * components], &values[k * components] + components);
    }
    const std::vector<double> found = table.assign(static_cast<int>(f), rows);
    if (!state.ranks.many() && std::count(found.begin(), found.end(), 0.0) > 0)
      throw std::invalid_argument("the nodal field \"" + fields[f].field.name +
                                  "\" names a node that is not there");
  }
}

template void archiveNodalFields(State<2>&, Archive&);
template void archiveNodalFields(State<3>&, Archive&);
template void archiveState(State<2>&, Archive&);
template void archiveState(State<3>&, Archive&);

} // namespace Rhegma
