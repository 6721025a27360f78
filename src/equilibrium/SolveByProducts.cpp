/// How a linear system of an equilibrium is solved without its matrix.

#include "equilibrium/LinearSystem.hpp"

namespace Rhegma::equilibrium
{

template <int D>
LinearAnswer LinearSystem<D>::solve(const TangentProduct<D>& product, const MakeBlocks& approximate,
                                    const Values& right, const LinearGoal& goal, const Values& change)
{
  if (rowsOfAll_ == 0)
    return {true, 0, 0, {}};
  if (!krylov_)
    makeKrylov();
  if (method_ != Method::Diagonal)
    method_ = Method::Multigrid;
  const int n = D * matrix_.graph().rows;
  all_ = Values("rhegma::equilibrium::all", n);
  force_ = Values("rhegma::equilibrium::force", n);
  for (int k = 0; k < n; ++k)
    all_(k) = held_(k) != 0 ? change(k) : 0.0;
  product.apply(all_, force_);
  const Values ofAll = product.diagonal();
  diagonal_ = Values("rhegma::equilibrium::diagonal", matrix_.rows());
  for (int k = 0; k < matrix_.rows(); ++k)
  {
    const int of = matrix_.unknownOf(k);
    b_(k) = held_(of) != 0 ? 0.0 : right(of) - force_(of);
    diagonal_(k) = held_(of) != 0 && ofAll(of) <= 0.0 ? 1.0 : ofAll(of);
  }
  symmetric_ = product.isSymmetric();
  product_ = &product;
  approximate_ = &approximate;
  const struct Forget // also after an exception
  {
    LinearSystem& of;
    ~Forget()
    {
      of.product_ = nullptr;
      of.approximate_ = nullptr;
      of.all_ = of.force_ = of.diagonal_ = {};
    }
  } forget{*this};
  return take(iterate(goal), change);
}

template <int D>
void LinearSystem<D>::multiply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const
{
  if (product_ == nullptr)
  {
    matrix_.multiply(x, y);
    return;
  }
  for (int k = 0; k < matrix_.rows(); ++k)
    all_(matrix_.unknownOf(k)) = held_(matrix_.unknownOf(k)) != 0 ? 0.0 : x(k);
  product_->apply(all_, force_);
  for (int k = 0; k < matrix_.rows(); ++k)
    y(k) = held_(matrix_.unknownOf(k)) != 0 ? diagonal_(k) * x(k) : force_(matrix_.unknownOf(k));
}

template <int D>
Values LinearSystem<D>::diagonal() const
{
  if (product_ != nullptr)
    return diagonal_;
  const Values diagonal("rhegma::equilibrium::diagonal", matrix_.rows());
  const SparseMatrix& matrix = matrix_.sparse();
  for (int r = 0; r < matrix.rows(); ++r)
    for (std::size_t k = matrix.first(r); k < matrix.first(r + 1); ++k)
      if (matrix.column(k) == r)
        diagonal(r) = matrix.value(k);
  return diagonal;
}

template LinearAnswer LinearSystem<2>::solve(const TangentProduct<2>&, const MakeBlocks&, const Values&,
                                             const LinearGoal&, const Values&);
template LinearAnswer LinearSystem<3>::solve(const TangentProduct<3>&, const MakeBlocks&, const Values&,
                                             const LinearGoal&, const Values&);
template void LinearSystem<2>::multiply(const BorrowedView<const double*>&,
                                        const BorrowedView<double*>&) const;
template void LinearSystem<3>::multiply(const BorrowedView<const double*>&,
                                        const BorrowedView<double*>&) const;
template Values LinearSystem<2>::diagonal() const;
template Values LinearSystem<3>::diagonal() const;

} // namespace Rhegma::equilibrium
