#pragma once
/// Sums over ranks of numbers that each keeps for itself and few others have too.

#include "base/Types.hpp"
#include "parallel/Ranks.hpp"

#include <vector>

namespace Rhegma
{

/// Which rows of an array belong to a node: those of its number and of its second field's, or where an array
/// has rows of its own, those that it gives to them.
struct SharedRows
{
  View<int*> second; ///< number of each node's second field, or -1; empty where there are none
  View<int*> rowOf;  ///< row of each node and second field, or -1; empty where it is its number

  KOKKOS_INLINE_FUNCTION int operator()(int node, int field) const
  {
    const int number = field == 0 ? node : second(node);
    return number < 0 || rowOf.extent(0) == 0 ? number : rowOf(number);
  }
};

/// Each rank sends its fractions of the nodes that it has in common with another straight to that one, and
/// adds what came in the order of the ranks: all have the same sum to the last digit after one exchange.
/// Between two ranks there is one message each way, of the rows that are not zero here, each behind its
/// position in the list that both have: of the nodes that two windows share most are out of the reach of one
/// rank's particles, are in no body or have no second field.
class NeighbourSums
{
public:
  /// \param nodes that this rank shares, by their rows
  /// \param of    by rank: which of them it has too, in the same order on both
  NeighbourSums(const Ranks& ranks, const View<int*>& nodes, const std::vector<std::vector<int>>& of);

  /// Replaces columns first .. first + count - 1 by their sums over the ranks. Collective. Whether there are
  /// second fields, and which nodes have rows of their own, is the same on all ranks; throws std::logic_error
  /// where a node that has one elsewhere has none here. \param values `width` numbers a row
  void sum(const SharedRows& rows, double* values, int width, int first, int count);

  // Public because compilers for devices want kernels in public functions.
  struct Neighbour
  {
    int rank, begin, end; ///< its part of the lists
    int sent, came;       ///< rows in the messages to it and from it
    bool meets;           ///< whether there are rows that both may add to
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
  /// Sums of nodes of which this is the first rank to send a fraction. \return rows without one here
  int add(const SharedRows& rows, const Columns& columns, const Neighbour& from);

private:
  void exchange(const Columns& columns);

  Ranks ranks_;
  View<int*> nodes_;
  View<int*> entry_;        ///< shared nodes, neighbour after neighbour
  View<int*> part_;         ///< the first entry with the same neighbour
  View<long long*> before_; ///< rows of entries before each that are sent, and those that may be
  View<int*> came_;         ///< where the row of each entry and field is in what came, or -1
  View<int*> begin_;        ///< of the fractions of each node in the list that follows
  View<int*> fraction_;     ///< their entries in the order of the ranks, -1 for the own
  std::vector<Neighbour> neighbours_;
  View<double*> sent_, received_;
};

} // namespace Rhegma
