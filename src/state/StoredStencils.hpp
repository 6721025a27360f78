#pragma once
/// Stencils that are stored because an effect edits them.

#include "base/Types.hpp"
#include "grid/StencilTable.hpp"

#include <functional>
#include <vector>

namespace Rhegma
{

template <int D>
struct State;

/// Points that need stencils: positions, half widths of their boxes (zero for points), the side of a crack on
/// which each lies (CrackSet; 0 away from cracks), and its group of bodies.
template <int D>
struct ObservedPoints
{
  View<double* [D]> position; ///< [m]
  View<double* [D]> half;     ///< [m]
  View<int*> side;            ///< of a crack
  /// fields::bodyGroup, 0: that of the body which the crack of its side cuts, if any. Empty: all are 0.
  View<int*> group;
  int count = 0; ///< number of points; views may be longer
  /// All ranks list the same points: each has a stencil on the rank that owns its cell, and none elsewhere.
  bool onAllRanks = false;
};

/// Interface of an effect that cuts bodies, or keeps them apart: it decides which particles need stored
/// stencils, and edits stencils so that they end at the cut. The core knows nothing else of cracks. Of
/// several editors, each edits what those before it have left.
template <int D>
struct StencilEditor
{
  /// Called once a step before any transfer: marks particles (row = 0 where a stored stencil is needed, -1
  /// elsewhere) and claims enriched fields of nodes (Nodes). Empty: it needs none in this step.
  std::function<void(State<D>&, const View<int*>& row)> prepare;
  /// Called instead of the former where particles lie in the same order in the same places of the same cells,
  /// and cracks are the same, as when it was last called; the stored stencils are then still right. Empty:
  /// `edit` depends on more than these. Stencils are kept if all editors that prepare any have it.
  std::function<void(State<D>&)> keep;
  /// Edits unbroken stencils of points in rows 0 .. points.count - 1.
  std::function<void(const State<D>&, const ObservedPoints<D>& points, const StencilTable<D>& table)> edit;
};

/// What stored stencils were made of.
struct StencilSource
{
  long sorts = -1;     ///< Particles::sorts
  int generation = -1; ///< of the cells
  long cracks = -1;    ///< CrackSet::changes

  /// Whether it says anything: stencils that are made anew in each step have none.
  bool isKnown() const { return sorts >= 0; }

  /// Whether they are the same.
  bool operator==(const StencilSource& other) const
  {
    return sorts == other.sorts && generation == other.generation && cracks == other.cracks;
  }
};

/// Stencils of the particles that editors marked, one a row.
template <int D>
struct StoredStencils
{
  std::vector<StencilEditor<D>> editors; ///< in the order of their effects; that of cracks is the first
  View<int*> row;                        ///< row of each particle, or -1; empty without an editor
  View<int*> particle;                   ///< particle of each row
  ObservedPoints<D> points;              ///< the particles of the rows as points
  StencilTable<D> table;                 ///< their stencils
  int count = 0;                         ///< number of rows
  StencilSource source;                  ///< of the rows
};

} // namespace Rhegma
