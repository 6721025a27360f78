#pragma once
/// The table of nodal fields, which effects store from step to step.

#include "base/Field.hpp"
#include "grid/Branches.hpp"
#include "grid/NodeIdentities.hpp"
#include "grid/Nodes.hpp"
#include "parallel/Division.hpp"
#include "parallel/Ranks.hpp"

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma
{

/// The nodes of nodal fields: those of one rank, for one generation of refined cells.
template <int D>
struct NodalFieldNodes
{
  Grid<D> grid{};
  View<double* [D]> finePosition; ///< positions of the nodes of refined cells [m]
  View<char*> foreign;            ///< not 0 for nodes that another rank owns; empty where there is one rank
  std::shared_ptr<const Branches<D>> refined;  ///< refined cells of all ranks; none where there is one rank
  std::shared_ptr<const Division<D>> division; ///< which rank has which cells; none where there is one rank
  int generation = -1;                         ///< of the tree; -1: there are no nodes yet
  int perNode = 1;                             ///< 2 where nodes may have an enriched field
};

/// Row of a node in nodal fields that have values for enriched fields of nodes, whose own numbers change from
/// step to step. In other nodal fields the row is the node.
template <int D>
struct NodalFieldRow
{
  Nodes<D> nodes;
  int perNode;

  /// \param node primary or enriched field, as in Nodes
  KOKKOS_INLINE_FUNCTION int operator()(int node) const
  {
    return node < nodes.numLattice ? perNode * node : perNode * latticeNode(nodes, node) + 1;
  }
};

/// Owns one view per nodal field.
///
/// An effect registers a field once, in Effect::addsNodal:
///
///     effect.addsNodal.push_back({{"damage", 1, "", "fraction of the bonds that have failed"},
///                                 OnRemesh::Interpolate});
///
/// and uses it in its calls, from Scatter on:
///
///     const auto damage = state.mesh.nodalFields.scalar("damage");
///     // in a kernel: damage(node)
///
/// Between Stage::BetweenSteps and Stage::Scatter of each step the run moves all fields to the current nodes
/// (moveNodalFields in state/Subdomain.hpp), if cells were refined or coarsened or the domain was divided
/// anew; checkpoints save and load them. An effect needs no code for this. It must not read a nodal field in
/// Stage::BetweenSteps.
///
/// Rules:
/// - A field is zero until something is written. It uses no memory before it is first requested.
/// - Views are valid until the next step: fetch them anew in each call.
/// - Nodes that several ranks have must get the same value on all of them. That is so if it is found from
/// nodal
///   sums, which are the same on all ranks.
/// - Where a value is good only if it was written in the step before, keep the number of that step in a field
/// of
///   its own, as sub_cycling/FineForces.cpp does: a node that is not in use keeps its value.
template <int D>
class NodalFieldTable
{
public:
  /// Values of a node that no longer exists.
  struct Lost
  {
    Vector<D> position; ///< [m]
    std::vector<double> values;
  };

  /// Adds a field. Throws std::logic_error when the name exists already.
  void add(const NodalField& field);

  bool has(const std::string& name) const; ///< whether there is a field of this name
  bool empty() const { return columns_.empty(); }
  std::vector<NodalField> fields() const; ///< all of them, in the order of adding

  /// A field of C numbers a node, shape (rows, C).
  template <int C>
  BorrowedView<double* [C]> real(const std::string& name) const {
    const Column& column = find(name, C);
    return BorrowedView<double* [C]>(column.values.data(), rows(column.field));
  }

  /// A field of one number a node, shape (rows).
  BorrowedView<double*> scalar(const std::string& name) const
  {
    const Column& column = find(name, 1);
    return BorrowedView<double*>(column.values.data(), rows(column.field));
  }

  /// Rows of fields with NodalField::enriched. \param nodes as they are in this step
  NodalFieldRow<D> rowsOf(const Nodes<D>& nodes) const { return {nodes, nodes_.perNode}; }

  /// Values of nodes that vanished before this step, in the order of their identities; the same on all ranks.
  const std::vector<Lost>& lost(const std::string& name) const { return find(name, 0).lost; }

  /// Step before which cells were last refined or coarsened and fields with OnRemesh::Drop were zeroed; -1:
  /// none.
  long lastRemesh() const { return lastRemesh_; }

  // The following functions are for moving, saving and loading the fields.

  /// Moves all values to these nodes. Collective. \param step the step that begins
  void move(const NodalFieldNodes<D>& to, long step, const Ranks& ranks);

  /// A row for each node that has values: its identity, 1 for its enriched field, then the values.
  using NamedRows = std::vector<double>;
  static constexpr int nameWidth = D + 1;

  /// Sets the nodes; all values become zero.
  void layOut(const NodalFieldNodes<D>& nodes);
  /// Values of nodes. \param field index in fields() \param first first node \param ofOthers whether to
  /// include nodes that another rank owns
  NamedRows namedRows(int field, int first = 0, bool ofOthers = false) const;
  /// Assigns rows to the nodes of this rank. \return for each row, 1 where its node is on this rank
  std::vector<double> assign(int field, const NamedRows& rows);

private:
  struct Column
  {
    NodalField field;
    mutable View<double**> values; ///< allocated when first requested
    std::vector<Lost> lost;
  };
  /// Allocates the values if necessary. \param components 0: any
  const Column& find(const std::string& name, int components) const;
  int perNode(const NodalField& field) const { return field.enriched ? nodes_.perNode : 1; }
  int rows(const NodalField& field) const { return perNode(field) * identities_.size(); }
  /// Row of a node by its identity and 1 for its enriched field, or -1.
  int rowOf(const NodalField& field, const std::array<int, D + 1>& name) const;
  std::vector<double> isHere(int field, const NamedRows& rows) const;
  /// Allocates rows for the nodes; those below `kept` keep their values, others are zero.
  void fit(Column& column, int kept);
  /// Gives nodes of refined cells that are in none of the rows the value interpolated in the earlier cells.
  void interpolate(int field, const NamedRows& rows);
  void listLost(int field, const NamedRows& rows, const std::vector<double>& found, const Ranks& ranks);

  std::vector<Column> columns_;
  NodalFieldNodes<D> nodes_;
  NodeIdentities<D> identities_; ///< of these
  long lastRemesh_ = -1;
};

} // namespace Rhegma
