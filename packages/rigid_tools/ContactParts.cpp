#include "rigid_tools/ContactParts.hpp"

#include "base/SmallLoops.hpp"
#include "boundary/HeldMarks.hpp"

#include <map>

namespace Rhegma::rigid_tools
{

namespace
{

/// Nodes with a smaller fraction of the heaviest one's mass get nothing: rounding decides whether the body
/// touches them. All others get their part, however light they are. The stress of a particle whose domain
/// reaches into the cell beyond by a fraction e acts on the node there with e, and is in balance if e of the
/// pressure acts there, too; without it the light node moves off until the particle has no stress.
constexpr double lightest = 1e-9;

/// Nodes further inside the tool than this are left out [cells].
constexpr double deepInside = -0.5;

template <int D>
struct DivideContact
{
  Grid<D> grid;
  Nodes<D> nodes;
  NodePositions<D> positions;
  ToolContacts<D> contacts;
  Vector<D> centre;
  bool alone;          ///< whether contacts keep their own nodes
  View<char*> several; ///< of each lattice node: whether it has several fields; empty: none has

  KOKKOS_INLINE_FUNCTION void operator()(const int c) const
  {
    keepOwnNode(c);
    Vector<D> foot, n;
    for (int d = 0; d < D; ++d)
    {
      foot[d] = centre[d] + contacts.arm(c, d);
      n[d] = contacts.normal(c, d);
    }
    if (!alone && contacts.row(c) == contacts.node(c) && grid.inside(foot))
    {
      const int own = contacts.node(c);
      const double height = dot(positions(own) - foot, n);
      if (divide(c, foot) && height < deepInside * grid.spacing)
        contacts.parts(c) = 0;
    }
    double sum = 0.0;
    for (int e = 0; e < contacts.parts(c); ++e)
    {
      const double mass = nodes.sums(contacts.partRow(c, e), Nodes<D>::massAt);
      sum += mass > 0.0 ? contacts.part(c, e) * contacts.part(c, e) / mass : 0.0;
    }
    contacts.mass(c) = sum > 0.0 ? 1.0 / sum : 0.0;
  }

  KOKKOS_INLINE_FUNCTION void keepOwnNode(int c) const
  {
    contacts.parts(c) = 1;
    contacts.partRow(c, 0) = contacts.row(c);
    contacts.part(c, 0) = 1.0;
  }

  /// Whether one of the nodes has several fields, so that its own row may be another body's.
  KOKKOS_INLINE_FUNCTION bool anySeveral(const int (&row)[1 << D], const double (&weight)[1 << D]) const
  {
    bool any = false;
    for (int e = 0; e < (1 << D) && several.extent(0) > 0; ++e)
      any = any || (weight[e] > 0.0 && several(row[e]) != 0);
    return any;
  }

  /// \return whether the contact is divided among nodes with mass
  KOKKOS_INLINE_FUNCTION bool divide(int c, const Vector<D>& foot) const
  {
    int row[1 << D], first[D];
    double weight[1 << D], heaviest = 0.0, sum = 0.0;
    for (int d = 0; d < D; ++d)
      first[d] = static_cast<int>(grid.inCells(foot[d], d));
    for (int e = 0; e < (1 << D); ++e)
    {
      int at[D];
      weight[e] = 1.0;
      for (int d = 0; d < D; ++d)
      {
        const int up = (e >> d) & 1;
        const double from = grid.inCells(foot[d], d) - first[d];
        at[d] = first[d] + up;
        weight[e] *= up != 0 ? from : 1.0 - from;
      }
      row[e] = grid.nodeIndex(at);
      heaviest = std::fmax(heaviest, weight[e] > 0.0 ? nodes.sums(row[e], Nodes<D>::massAt) : 0.0);
    }
    if (anySeveral(row, weight))
      return false;
    int kept = 0;
    for (int e = 0; e < (1 << D); ++e)
      if (weight[e] > 1e-9 && nodes.sums(row[e], Nodes<D>::massAt) > lightest * heaviest)
      {
        contacts.partRow(c, kept) = row[e];
        contacts.part(c, kept++) = weight[e];
        sum += weight[e];
      }
    if (!(sum > 0.0))
      return false;
    contacts.parts(c) = kept;
    for (int e = 0; e < kept; ++e)
      contacts.part(c, e) /= sum;
    return true;
  }
};

/// Sets the marks of nodes with several fields.
template <int D>
void markSeveral(const State<D>& state, const View<char*>& several, char mark)
{
  const View<int*> parent = state.mesh.nodes.parent;
  parallelForSmall(
      "rhegma::markNodesWithSeveralFields", state.mesh.nodes.numEnriched,
      KOKKOS_LAMBDA(const int r) { several(parent(r)) = mark; });
}

/// Gives all contacts of a tool their own node again if one of its nodes is another tool's, too.
template <int D>
void keepOwnNodes(const State<D>& state, const ToolContacts<D>& contacts, const std::map<int, int>& toolOf)
{
  const auto rows = onHost(contacts.partRow);
  const auto parts = onHost(contacts.parts);
  const auto own = onHost(contacts.row);
  bool common = false;
  for (int c = 0; c < contacts.count; ++c)
  {
    common = common || toolOf.at(own(c)) < 0;
    for (int e = 0; e < parts(c); ++e)
      common = common || toolOf.at(rows(c, e)) < 0;
  }
  if (!common)
    return;
  const DivideContact<D> divide{
      state.mesh.grid, state.mesh.nodes, nodePositions(state), contacts, Vector<D>{}, true, {}};
  parallelForSmall("rhegma::keepOwnNodesOfTool", contacts.count, divide);
}

} // namespace

template <int D>
void divideContacts(const State<D>& state, const Vector<D>& centre, ToolContacts<D>& contacts)
{
  const bool alone = state.mesh.tree.refined(), fields = state.mesh.nodes.numEnriched > 0;
  if (fields && static_cast<int>(contacts.several.extent(0)) < state.mesh.nodes.numLattice)
    contacts.several = View<char*>("rhegma::nodesWithSeveralFields", state.mesh.nodes.numLattice);
  markSeveral(state, contacts.several, 1);
  const DivideContact<D> divide{state.mesh.grid,
                                state.mesh.nodes,
                                nodePositions(state),
                                contacts,
                                centre,
                                alone,
                                fields ? contacts.several : View<char*>()};
  parallelForSmall("rhegma::divideContactsOfTool", contacts.count, divide);
  markSeveral(state, contacts.several, 0);
}

template <int D>
void separateTools(const State<D>& state, const std::vector<ToolContacts<D>*>& all)
{
  std::map<int, int> toolOf; // of each row, or -1 where there are several
  for (std::size_t t = 0; t < all.size(); ++t)
  {
    const auto rows = onHost(all[t]->partRow);
    const auto parts = onHost(all[t]->parts);
    const auto own = onHost(all[t]->row);
    const auto use = [&](int row)
    {
      const auto [entry, added] = toolOf.emplace(row, static_cast<int>(t));
      if (!added && entry->second != static_cast<int>(t))
        entry->second = -1;
    };
    for (int c = 0; c < all[t]->count; ++c)
    {
      use(own(c));
      for (int e = 0; e < parts(c); ++e)
        use(rows(c, e));
    }
  }
  for (ToolContacts<D>* const contacts : all)
    keepOwnNodes(state, *contacts, toolOf);
}

template <int D>
void holdContacts(const State<D>& state, const ToolContacts<D>& contacts)
{
  // The node of the contact first, then those of its parts.
  constexpr int each = 1 + (1 << D);
  const View<int*> node("rhegma::nodesOfToolParts", each * contacts.count);
  const View<char* [D]> held("rhegma::heldToolParts", each * contacts.count);
  const ToolContacts<D> at = contacts;
  const Nodes<D> nodes = state.mesh.nodes;
  parallelForSmall(
      "rhegma::listNodesOfToolParts", contacts.count, KOKKOS_LAMBDA(const int c) {
        for (int e = 0; e < each; ++e)
          node(each * c + e) =
              e > 0 && e <= at.parts(c) ? latticeNode(nodes, at.partRow(c, e - 1)) : at.node(c);
      });
  markHeldAxes(state, node, each * contacts.count, held);
  parallelForSmall(
      "rhegma::holdContactsOfTool", contacts.count, KOKKOS_LAMBDA(const int c) {
        double square = 0.0;
        for (int d = 0; d < D; ++d)
        {
          bool any = false;
          for (int e = 0; e < each; ++e)
            any = any || held(each * c + e, d) != 0;
          at.held(c, d) = any ? 1 : 0;
          at.normal(c, d) = any ? 0.0 : at.normal(c, d);
          square += at.normal(c, d) * at.normal(c, d);
        }
        const double factor = square > 1e-12 ? 1.0 / std::sqrt(square) : 0.0;
        for (int d = 0; d < D; ++d)
          at.normal(c, d) *= factor;
      });
}

template void divideContacts(const State<2>&, const Vector<2>&, ToolContacts<2>&);
template void divideContacts(const State<3>&, const Vector<3>&, ToolContacts<3>&);
template void separateTools(const State<2>&, const std::vector<ToolContacts<2>*>&);
template void separateTools(const State<3>&, const std::vector<ToolContacts<3>*>&);
template void holdContacts(const State<2>&, const ToolContacts<2>&);
template void holdContacts(const State<3>&, const ToolContacts<3>&);

} // namespace Rhegma::rigid_tools
