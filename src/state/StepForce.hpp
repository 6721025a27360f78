#pragma once
/// Nodal forces that depend on the displacement over a step of equilibrium.

#include "base/Types.hpp"

#include <functional>
#include <string>
#include <vector>

namespace Rhegma
{

template <int D>
struct State;

/// A direction in which a force resists the motion of a node's row at a position.
template <int D>
struct HeldDirection
{
  int row = 0;           ///< of the equilibrium's unknowns
  Vector<D> position{};  ///< [m]
  Vector<D> direction{}; ///< unit vector
};

/// A nodal force that depends on the displacement over a step of equilibrium (contact, front springs), as
/// Newton's method needs it. Its value at the start of the step is part of the nodal force before the solve;
/// `add` adds its change since. Displacements [m] and forces [N] have D numbers a row.
///
/// On several ranks each rank adds its part of the force; displacements are the same on all that have a row.
/// `begin` and `add` are collective; what `addStiffness` and `update` return is the same on all ranks.
///
/// A law may have branches, such as closed and open: `update` chooses them, `begin` by a first guess.
template <int D>
class StepForce
{
public:
  using Values = View<double*>;                 ///< D numbers a row
  using Groups = std::vector<std::vector<int>>; ///< rows that are coupled, a group a list
  /// Adds a block of D x D numbers, of a row's force and another row's displacement [N/m].
  using AddBlock = std::function<void(int row, int other, const double (&block)[D * D])>;

  virtual ~StepForce() = default;

  /// Begins a step, again where the step is repeated. \param state with the stencils of the step
  /// \param rowOf row of each node, enriched fields included, or -1 \return rows that the force couples
  virtual Groups begin(const State<D>& state, const View<int*>& rowOf) = 0;

  /// Adds the change of the force at a displacement over the step.
  virtual void add(const Values& displacement, const Values& force) = 0;

  /// Adds minus the derivative of the force, where `add` was last called.
  /// \param symmetric wants the symmetric part alone \param addBlock takes it \return whether it is symmetric
  virtual bool addStiffness(bool symmetric, const AddBlock& addBlock) = 0;

  /// Chooses branches, and improves what the force takes as known, such as multipliers, at the displacement
  /// of the last `add`, which has been accepted. \return whether the force may have changed
  virtual bool update() { return false; }

  /// Whether `update` chooses between branches: their stiffness is not that of the iteration before, may be
  /// unsymmetric, and takes more iterations than a smooth law.
  virtual bool hasBranches() const { return false; }

  /// Where the force resists motion now, in addition to supports.
  virtual std::vector<HeldDirection<D>> heldDirections() const { return {}; }

  /// Rows whose pieces resist a rotation by their functions, without a support.
  virtual std::vector<int> rowsThatResistRotation() const { return {}; }

  /// Whether pieces that only this force joins may have free motions, as closed faces that slide.
  virtual bool joinsPieces() const { return false; }

  /// Cells of the lattice between the farthest rows that the force couples, and one more. On several ranks
  /// the part of the lattice that a rank has reaches so far beyond its own cells. 0: the force couples rows
  /// of nearby nodes only, as particles do.
  virtual int reach() const { return 0; }

  /// What of the force may keep a step from its equilibrium, for a message; empty if there is nothing to say.
  virtual std::string reason() const { return {}; }
};

} // namespace Rhegma
