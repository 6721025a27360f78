#include "parallel/NodalFieldTable.hpp"

#include "parallel/SendRows.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

namespace Rhegma
{

namespace
{

/// The name of a row of NamedRows: node and primary (0) or enriched (1) field.
template <int D>
using RowName = std::array<int, D + 1>;

template <int D>
RowName<D> nameOfRow(const double* row)
{
  RowName<D> name;
  std::transform(row, row + D + 1, name.begin(), [](double n) { return static_cast<int>(n); });
  return name;
}

template <int D>
typename NodeIdentities<D>::Identity nodeOf(const RowName<D>& row)
{
  typename NodeIdentities<D>::Identity name;
  std::copy_n(row.begin(), D, name.begin());
  return name;
}

/// Sends rows to all ranks whose part of the lattice has their nodes. Collective.
template <int D>
std::vector<double> sendToHolders(const std::vector<double>& rows, std::size_t width,
                                  const Division<D>& division, const Ranks& ranks)
{
  std::vector<int> to;
  std::vector<double> sent;
  for (int rank = 0; rank < ranks.size(); ++rank)
  {
    const Grid<D> window = division.window(rank);
    for (std::size_t k = 0; k < rows.size(); k += width)
      if (NodeIdentities<D>::isWithin(window, nodeOf<D>(nameOfRow<D>(&rows[k]))))
      {
        to.push_back(rank);
        sent.insert(sent.end(), &rows[k], &rows[k] + width);
      }
  }
  return sendRows(ranks, to, sent, static_cast<int>(width));
}

template <int D>
bool sameLattice(const NodalFieldNodes<D>& a, const NodalFieldNodes<D>& b)
{
  return a.perNode == b.perNode && std::equal(a.grid.cells, a.grid.cells + D, b.grid.cells) &&
         std::equal(a.grid.before, a.grid.before + D, b.grid.before);
}

} // namespace

template <int D>
void NodalFieldTable<D>::add(const NodalField& field)
{
  if (has(field.field.name))
    throw std::logic_error("the nodal field \"" + field.field.name + "\" exists already");
  columns_.push_back({field, {}, {}});
}

template <int D>
bool NodalFieldTable<D>::has(const std::string& name) const
{
  return std::any_of(columns_.begin(), columns_.end(),
                     [&](const Column& column) { return column.field.field.name == name; });
}

template <int D>
std::vector<NodalField> NodalFieldTable<D>::fields() const
{
  std::vector<NodalField> all;
  for (const Column& column : columns_)
    all.push_back(column.field);
  return all;
}

template <int D>
const typename NodalFieldTable<D>::Column& NodalFieldTable<D>::find(const std::string& name,
                                                                    int components) const
{
  for (const Column& column : columns_)
    if (column.field.field.name == name)
    {
      if (components != 0 && column.field.field.components != components)
        throw std::logic_error("the nodal field \"" + name + "\" has another shape than asked for");
      if (column.values.extent(0) == 0)
        column.values =
            View<double**>("rhegma::nodal field " + name, rows(column.field), column.field.field.components);
      return column;
    }
  throw std::logic_error("there is no nodal field \"" + name + "\"");
}

template <int D>
void NodalFieldTable<D>::layOut(const NodalFieldNodes<D>& nodes)
{
  nodes_ = nodes;
  identities_ = NodeIdentities<D>(nodes.grid, nodes.finePosition);
  lastRemesh_ = -1;
  for (Column& column : columns_)
  {
    column.values = {};
    column.lost.clear();
  }
}

template <int D>
void NodalFieldTable<D>::move(const NodalFieldNodes<D>& to, long step, const Ranks& ranks)
{
  for (Column& column : columns_)
    column.lost.clear();
  if (nodes_.generation == to.generation && nodes_.perNode == to.perNode)
    return;
  if (nodes_.generation < 0)
    return layOut(to);
  const bool remeshed = !(nodes_.refined && to.refined && *nodes_.refined == *to.refined);
  // Unless the lattice nodes of some rank change, no values are sent between ranks.
  const bool divided = ranks.max(sameLattice(nodes_, to) ? 0.0 : 1.0) > 0.0;
  const int count = static_cast<int>(columns_.size()), first = divided ? 0 : nodes_.grid.numNodes;
  std::vector<NamedRows> rows(count), lost(count);
  for (int f = 0; f < count; ++f)
    if (!remeshed || columns_[f].field.onRemesh != OnRemesh::Drop)
    {
      if (!divided)
        rows[f] = namedRows(f, first, true);
      else if (!remeshed && to.division)
        rows[f] =
            sendToHolders(namedRows(f), nameWidth + columns_[f].field.field.components, *to.division, ranks);
      else // all ranks must see which nodes are lost, and between which new ones lie
        rows[f] = ranks.gatherOnAll(namedRows(f));
      if (columns_[f].field.reportsLost && !divided)
        lost[f] = namedRows(f, first);
    }
  nodes_ = to;
  identities_ = NodeIdentities<D>(to.grid, to.finePosition);
  lastRemesh_ = remeshed ? step : lastRemesh_;
  for (int f = 0; f < count; ++f)
  {
    const NodalField& field = columns_[f].field;
    const bool drop = remeshed && field.onRemesh == OnRemesh::Drop;
    fit(columns_[f], divided || drop ? 0 : first);
    std::vector<double> found = assign(f, rows[f]);
    if (remeshed && field.onRemesh == OnRemesh::Interpolate && columns_[f].values.extent(0) > 0)
      interpolate(f, rows[f]);
    if (!field.reportsLost || !remeshed || drop)
      continue;
    if (divided)
      ranks.max(found.data(), static_cast<int>(found.size()));
    else
      found = isHere(f, lost[f]);
    listLost(f, divided ? rows[f] : lost[f], found, divided ? Ranks() : ranks);
  }
}

template <int D>
void NodalFieldTable<D>::fit(Column& column, int kept)
{
  View<double**>& values = column.values;
  const auto width = static_cast<std::size_t>(perNode(column.field));
  const std::size_t count = width * identities_.size();
  if (kept == 0 || values.extent(0) == 0)
    values = {};
  else
  {
    if (values.extent(0) < count)
      Kokkos::resize(values, count + count / 4, values.extent(1));
    Kokkos::deep_copy(Kokkos::subview(values, std::make_pair(width * kept, values.extent(0)), Kokkos::ALL),
                      0.0);
  }
}

template <int D>
typename NodalFieldTable<D>::NamedRows NodalFieldTable<D>::namedRows(int field, int first,
                                                                     bool ofOthers) const
{
  NamedRows rows;
  const Column& column = columns_[field];
  const int width = perNode(column.field), components = column.field.field.components;
  const auto values = onHost(column.values);
  const auto foreign = onHost(nodes_.foreign);
  if (values.extent(0) == 0)
    return rows;
  for (int r = width * first; r < width * identities_.size(); ++r)
  {
    const int node = r / width;
    // Interpolation needs zeros, too.
    const bool counts = column.field.onRemesh == OnRemesh::Interpolate && node >= nodes_.grid.numNodes;
    const double* const row = &values(r, 0);
    if ((!counts && std::all_of(row, row + components, [](double v) { return v == 0.0; })) ||
        (!ofOthers && foreign.extent(0) > 0 && foreign(node) != 0))
      continue;
    const auto name = identities_.of(node);
    rows.insert(rows.end(), name.begin(), name.end());
    rows.push_back(r % width);
    rows.insert(rows.end(), row, row + components);
  }
  return rows;
}

template <int D>
std::vector<double> NodalFieldTable<D>::assign(int field, const NamedRows& rows)
{
  const Column& column = columns_[field];
  const int components = column.field.field.components;
  std::vector<double> found = isHere(field, rows);
  if (rows.empty())
    return found;
  const auto values = onHost(find(column.field.field.name, components).values);
  for (std::size_t k = 0; k < found.size(); ++k)
    if (found[k] != 0.0)
    {
      const double* const row = &rows[k * (nameWidth + components)];
      std::copy_n(row + nameWidth, components, &values(rowOf(column.field, nameOfRow<D>(row)), 0));
    }
  Kokkos::deep_copy(column.values, values);
  return found;
}

template <int D>
std::vector<double> NodalFieldTable<D>::isHere(int field, const NamedRows& rows) const
{
  const NodalField& of = columns_[field].field;
  const std::size_t width = nameWidth + of.field.components;
  std::vector<double> here(rows.size() / width);
  for (std::size_t k = 0; k < here.size(); ++k)
    here[k] = rowOf(of, nameOfRow<D>(&rows[k * width])) >= 0 ? 1.0 : 0.0;
  return here;
}

template <int D>
int NodalFieldTable<D>::rowOf(const NodalField& field, const std::array<int, D + 1>& name) const
{
  const int node = identities_.find(nodeOf<D>(name)), width = perNode(field);
  return node < 0 || name[D] >= width ? -1 : width * node + name[D];
}

/// The multilinear function of the earlier cells, including hanging nodes: a new node gets the mean over the
/// ends of the edge, or the corners of the face or cell, in whose middle it lies.
template <int D>
void NodalFieldTable<D>::interpolate(int field, const NamedRows& rows)
{
  const NodalField& of = columns_[field].field;
  const int components = of.field.components, width = perNode(of);
  std::map<RowName<D>, const double*> before; // of nodes of refined cells; others do not change
  for (std::size_t k = 0; k < rows.size(); k += nameWidth + components)
    before[nameOfRow<D>(&rows[k])] = &rows[k + nameWidth];
  const auto values = onHost(find(of.field.name, components).values);
  const std::function<std::vector<double>(const RowName<D>&)> at = [&](const RowName<D>& name)
  {
    std::vector<double> value(components, 0.0);
    const auto found = before.find(name);
    const bool stays = NodeIdentities<D>::isOfLattice(nodeOf<D>(name));
    if (stays || found != before.end())
    {
      const int row = stays ? rowOf(of, name) : 0;
      if (row >= 0)
        std::copy_n(stays ? &values(row, 0) : found->second, components, value.begin());
      return value;
    }
    int edge = 1; // half of the edge of the smallest cell in whose middle it lies
    while (std::none_of(name.begin(), name.begin() + D, [&](int n) { return (n & edge) != 0; }))
      edge *= 2;
    std::vector<RowName<D>> corners{name};
    for (int d = 0; d < D; ++d)
      for (std::size_t k = (name[d] & edge) != 0 ? corners.size() : 0; k > 0; --k)
      {
        corners.push_back(corners[k - 1]);
        corners[k - 1][d] -= edge;
        corners.back()[d] += edge;
      }
    for (const RowName<D>& corner : corners)
    {
      const std::vector<double> there = at(corner);
      for (int c = 0; c < components; ++c)
        value[c] += there[c] / static_cast<double>(corners.size());
    }
    return value;
  };
  for (int r = width * nodes_.grid.numNodes; r < width * identities_.size(); ++r)
  {
    RowName<D> name;
    const auto node = identities_.of(r / width);
    std::copy(node.begin(), node.end(), name.begin());
    name[D] = r % width;
    if (before.count(name) > 0)
      continue;
    const std::vector<double> value = at(name);
    std::copy(value.begin(), value.end(), &values(r, 0));
  }
  Kokkos::deep_copy(columns_[field].values, values);
}

template <int D>
void NodalFieldTable<D>::listLost(int field, const NamedRows& rows, const std::vector<double>& found,
                                  const Ranks& ranks)
{
  const std::size_t width = nameWidth + columns_[field].field.field.components;
  NamedRows own;
  for (std::size_t k = 0; k < found.size(); ++k)
    if (found[k] == 0.0)
      own.insert(own.end(), &rows[k * width], &rows[k * width] + width);
  const NamedRows all = ranks.gatherOnAll(own);
  std::map<RowName<D>, Lost> sorted;
  for (std::size_t k = 0; k < all.size(); k += width)
  {
    const RowName<D> name = nameOfRow<D>(&all[k]);
    sorted[name] = {identities_.position(nodeOf<D>(name)), {&all[k + nameWidth], &all[k + width - 1] + 1}};
  }
  for (const auto& [name, lost] : sorted)
    columns_[field].lost.push_back(lost);
}

template class NodalFieldTable<2>;
template class NodalFieldTable<3>;

} // namespace Rhegma
