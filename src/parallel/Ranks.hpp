#pragma once
/// The ranks of a run, and their collective operations on a few numbers.

#include <memory>
#include <string>
#include <vector>

namespace Teuchos
{
template <class Ordinal>
class Comm;
template <class T>
class RCP;
} // namespace Teuchos

namespace Rhegma
{

/// A group of ranks; by default only the calling one. Every call but `rank` and `size` is collective: all
/// ranks must make it, in the same order.
class Ranks
{
public:
  Ranks() = default;
  explicit Ranks(const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool many() const { return size_ > 1; }
  /// Number of ranks on this machine.
  int onThisMachine() const { return onThisMachine_; }

  /// Replaces each value by its sum over the ranks.
  void sum(double* values, int count) const;
  double sum(double value) const;
  /// Replaces each value by the largest of any rank.
  void max(double* values, int count) const;
  double max(double value) const;
  /// The text of the lowest rank that has one; empty where none has.
  std::string firstText(const std::string& text) const;

  /// The numbers of all ranks one after another on rank 0; nothing on others.
  std::vector<double> gather(const std::vector<double>& own) const;
  std::vector<int> gather(const std::vector<int>& own) const;
  /// The numbers of each rank, `own` of them, from those of all ranks one after another on rank 0.
  std::vector<double> scatter(const std::vector<double>& all, int own) const;
  /// As `gather`, on all ranks.
  std::vector<double> gatherOnAll(const std::vector<double>& own) const;

  /// The communicator; null with one rank.
  const Teuchos::RCP<const Teuchos::Comm<int>>& comm() const;

private:
  struct Holder;
  std::shared_ptr<const Holder> holder_;
  int rank_ = 0, size_ = 1, onThisMachine_ = 1;
};

} // namespace Rhegma
