#pragma once
/// Front springs over a step of equilibrium.

#include "state/State.hpp"
#include "state/StepForce.hpp"

#include <array>
#include <vector>

namespace Rhegma::cracks
{

/// The springs of CrackSet::spring between the two fields of nodes: linear over a step.
template <int D>
class SpringsInEquilibrium : public StepForce<D>
{
public:
  using typename StepForce<D>::Values;
  using typename StepForce<D>::Groups;
  using typename StepForce<D>::AddBlock;

  /// Lists the springs whose fields both have rows, each on the rank that owns its node. \return their pairs
  /// of rows
  Groups begin(const State<D>& state, const View<int*>& rowOf) override;
  /// Adds opposite forces, stiffness times the difference of the fields [N].
  void add(const Values& displacement, const Values& force) override;
  /// Adds the stiffness of the springs, which is symmetric.
  bool addStiffness(bool symmetric, const AddBlock& addBlock) override;

private:
  struct Spring
  {
    std::array<int, 2> row;
    double stiffness; ///< [N/m]
  };
  std::vector<Spring> springs_;
};

} // namespace Rhegma::cracks
