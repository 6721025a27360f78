#pragma once
/// Products of the stiffness with displacements, without a matrix.

#include "equilibrium/Resistances.hpp"
#include "equilibrium/RowOwners.hpp"

#include <vector>

namespace Rhegma::equilibrium
{

/// The derivative of all internal forces at a trial displacement. Each particle stores the tangent of its
/// law: a product takes the gradient of a displacement at the particles, multiplies, and brings the stress
/// back to the nodes. Where boxes of particles span several cells this needs a quarter of the memory of the
/// matrix, and no assembly. A product takes as long as two to three with the matrix.
template <int D>
class TangentProduct
{
public:
  /// Finds the tangents. Collective. \param state, owners must outlive this; positions of particles stay as
  /// they are \param graph of which only the rows are used \param displacement at which `add` of the forces
  /// was last called
  TangentProduct(const State<D>& state, const RowOwners& owners, const RowGraph& graph,
                 const Resistances<D>& resistances, const Values& displacement);

  /// Whether the displacement exists on all ranks: no particle is inverted.
  bool exists() const { return exists_; }
  bool isSymmetric() const { return symmetric_; }

  /// force = stiffness times u, for rows that this rank owns. Collective. \param u of such rows; gets the
  /// values of all
  void apply(const Values& u, const Values& force) const;

  /// Diagonal of the stiffness, of rows that this rank owns [N/m]. Collective.
  Values diagonal() const;

private:
  /// A part of the stiffness of forces.
  struct Block
  {
    int row, other;
    double value[D * D]; ///< [N/m]
  };

  const State<D>& state_;
  const RowOwners& owners_;
  RowGraph graph_;
  std::vector<SlopeJump> jumps_;
  std::vector<Block> blocks_;
  View<double**> tangent_;               ///< of each particle: the upper half, row by row [Pa]
  View<double*> ofNodes_, forceOfNodes_; ///< displacement and force while a product is found
  bool exists_ = true, symmetric_ = true;
};

} // namespace Rhegma::equilibrium
