#pragma once
/// The rows of an equilibrium on several ranks.

#include "equilibrium/Unknowns.hpp"
#include "parallel/Ranks.hpp"

#include <utility>
#include <vector>

namespace Rhegma::equilibrium
{

/// Which rank owns each row. A node in the windows of several ranks has a row on all of them if a particle of
/// any of them sees it. One of them owns it: it adds what all of them assemble for the row, and counts it in
/// sums. By default there is one rank, which owns all rows.
class RowOwners
{
public:
  RowOwners() = default;
  /// Collective. \param own not 0 for rows of this rank \param number of each row among those of all ranks,
  /// where the rows of a rank are consecutive and ranks ascend
  RowOwners(const Ranks& ranks, std::vector<char> own, std::vector<long long> number);

  const Ranks& ranks() const { return ranks_; }
  bool owns(int row) const { return own_.empty() || own_[row] != 0; }
  /// Number of a row among those of all ranks.
  long long numberOf(int row) const { return number_.empty() ? row : number_[row]; }
  /// The row of such a number here, or -1.
  int find(long long number) const;

  /// Sum over the rows of all ranks, of a value of each.
  template <class Value>
  double sum(int rows, const Value& value) const
  {
    double all = 0.0;
    for (int r = 0; r < rows; ++r)
      all += owns(r) ? value(r) : 0.0;
    return ranks_.sum(all);
  }

  /// Adds the couplings of rows of other ranks to those of their owners. Collective.
  /// \param coupled rows coupled with each row, ascending; what is added comes after them
  void sendCouplings(std::vector<std::vector<int>>& coupled) const;

  /// Adds entries of rows of other ranks to those of their owners, which then are complete. Collective.
  /// \param values `width` numbers for each entry of the graph's columns
  void sendEntries(const RowGraph& graph, const View<double*>& values, int width) const;

  /// Pieces of all ranks from those of each. Collective. \param piece of each row here \param count of pieces
  /// here \return the same of all ranks, numbered alike on all
  std::pair<std::vector<int>, int> joinPieces(const std::vector<int>& piece, int count) const;

private:
  int ownerOf(long long number) const;
  /// The row of a number that another rank has sent. Throws std::logic_error where there is none.
  int rowOf(double number) const;

  Ranks ranks_;
  std::vector<char> own_;
  std::vector<long long> number_;
  std::vector<std::pair<long long, int>> sorted_; ///< numbers and rows
  std::vector<double> first_;                     ///< number of each rank's first row
};

/// The owners of the rows of a state. Collective.
template <int D>
RowOwners findOwners(const State<D>& state, const RowGraph& graph);

/// Gives all copies of a row the values of its owner. Collective. \param values D * row + axis
template <int D>
void copyFromOwners(const State<D>& state, const RowGraph& graph, const RowOwners& owners,
                    const View<double*>& values);

/// Adds values of rows that several ranks have. Collective. \param values D * row + axis
template <int D>
void addOverRanks(const State<D>& state, const RowGraph& graph, const View<double*>& values);

} // namespace Rhegma::equilibrium
