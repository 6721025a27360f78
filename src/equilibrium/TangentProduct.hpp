#pragma once
/// Products of the stiffness with displacements, without a matrix.

#include "equilibrium/Resistances.hpp"
#include "equilibrium/RowOwners.hpp"

#include <vector>

namespace Rhegma::equilibrium
{

/// Products with the ghost penalty and the stiffness of forces: row by row, each row in the order in which
/// its parts were found, so that they do not depend on the number of threads.
template <int D>
struct CoupledRows
{
  /// A part of the stiffness of forces.
  struct Block
  {
    int row, other;
    double value[D * D]; ///< [N/m]
  };

  View<int*> firstOfJump;     ///< of each jump in the next two; one more at the end
  View<int*> rowOfJump;       ///< rows of its nodes
  View<double*> coefficient;  ///< SlopeJump::coefficient
  View<double*> weight;       ///< of each jump [N/m]
  View<double*> force;        ///< D numbers of each jump while a product is found [N]
  View<int*> firstOfRow;      ///< of each row in the next two; one more at the end
  View<int*> jumpOfRow;       ///< its jumps
  View<double*> ofJump;       ///< their coefficients
  View<int*> firstBlockOfRow; ///< of each row in the next two; one more at the end
  View<int*> other;           ///< rows to which blocks couple it
  View<double*> value;        ///< D x D numbers of each block [N/m]

  CoupledRows() = default;
  CoupledRows(const std::vector<SlopeJump>& jumps, const std::vector<Block>& blocks, int rows);

  /// result = stiffness times u, D numbers a row [m], [N].
  void multiply(const Values& u, const Values& result) const;
  /// Adds the diagonal [N/m].
  void addDiagonal(const Values& diagonal) const;
};

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
  const State<D>& state_;
  const RowOwners& owners_;
  RowGraph graph_;
  CoupledRows<D> coupled_;
  View<double**> tangent_;               ///< of each particle: the upper half, row by row [Pa]
  View<double*> ofNodes_, forceOfNodes_; ///< displacement and force while a product is found
  bool exists_ = true, symmetric_ = true;
};

} // namespace Rhegma::equilibrium
