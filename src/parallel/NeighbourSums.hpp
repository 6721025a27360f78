#pragma once
/// Sums over ranks of values of shared nodes.

#include "base/Types.hpp"
#include "parallel/Ranks.hpp"

#include <vector>

namespace Rhegma
{

/// Rows of an array that belong to a node: the row of the node and of its enriched field, or those that the
/// array's own numbering gives them.
struct SharedRows
{
  View<int*> enrichedField; ///< row of each node's enriched field, or -1; empty where there are none
  View<int*> rowOf;         ///< row of each node and enriched field, or -1; empty where it is its number

  KOKKOS_INLINE_FUNCTION int operator()(int node, int field) const
  {
    const int number = field == 0 ? node : enrichedField(node);
    return number < 0 || rowOf.extent(0) == 0 ? number : rowOf(number);
  }
};

/// Each rank sends its contributions to the nodes that it shares with another rank directly to that rank, and
/// adds what it received in the order of the ranks: after one exchange all have the same sum to the last
/// digit. Two ranks exchange one message in each direction. It contains only rows that are not zero, each
/// with its position in the list of both ranks: most nodes that two windows share are out of the reach of one
/// rank's particles, are in no body or have no enriched field.
class NeighbourSums
{
public:
  /// \param nodes that this rank shares, by their rows
  /// \param of    by rank: the nodes shared with it, in the same order on both
  NeighbourSums(const Ranks& ranks, const View<int*>& nodes, const std::vector<std::vector<int>>& of);

  /// Replaces columns first .. first + count - 1 by their sums over the ranks. Collective. All ranks must
  /// agree on whether there are enriched fields and which nodes have rows; throws std::logic_error where a
  /// node has a row on another rank and none here. \param values `width` numbers a row
  void sum(const SharedRows& rows, double* values, int width, int first, int count);

  // Public because compilers for devices want kernels in public functions.
  struct Neighbour
  {
    int rank, begin, end; ///< range of its entries in the lists
    int sent, received;   ///< rows in the messages to it and from it
    bool meets;           ///< whether both ranks may add to some rows
  };
  struct Columns
  {
    double* values;
    int width, first, count, fields;

    /// Numbers of a message for one row: its position and its columns.
    KOKKOS_INLINE_FUNCTION int perRow() const { return count + 1; }
  };
  void pack(const SharedRows& rows, const Columns& columns);
  void findFractions(const Columns& columns, bool forget);
  /// Sums the nodes of which this rank is the first to send a fraction. \return number of rows that this rank
  /// lacks
  int add(const SharedRows& rows, const Columns& columns, const Neighbour& from);

private:
  void exchange(const Columns& columns);

  Ranks ranks_;
  View<int*> nodes_;
  View<int*> entry_;        ///< shared nodes, neighbour after neighbour
  View<int*> part_;         ///< the first entry with the same neighbour
  View<long long*> before_; ///< rows of entries before each that are sent, and those that may be
  View<int*> receivedRow_;  ///< where the row of each entry and field is in the received rows, or -1
  View<int*> begin_;        ///< of the fractions of each node in the list that follows
  View<int*> fraction_;     ///< their entries in the order of the ranks, -1 for this rank
  std::vector<Neighbour> neighbours_;
  View<double*> sent_, received_;
};

} // namespace Rhegma
