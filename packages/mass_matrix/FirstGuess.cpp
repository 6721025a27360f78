#include "mass_matrix/FirstGuess.hpp"
#include "state/FewItems.hpp"

namespace Rhegma::mass_matrix
{

namespace
{

/// image = M x, with the sums of a first guess.
template <int D, int Reach>
struct LookAtGuess
{
  using value_type = double[];
  using size_type = int;

  int value_count = GuessSums<D>::size;
  MassSystem<D> system;
  View<double*> right, x, inverse, image;

  KOKKOS_INLINE_FUNCTION void operator()(const int row, double* sum) const
  {
    const Pack<MassSystem<D>::width> product = rowTimes<D, Reach>(system, row, x.data());
    for (int d = 0; d < D; ++d)
    {
      const int i = MassSystem<D>::width * row + d;
      image(i) = product[d];
      if (inverse(i) == 0.0)
        continue;
      const double b = right(i), y = product[d];
      sum[0] += b * b;
      sum[1] += (b - y) * (b - y);
      sum[2] += x(i) * b;
      sum[3] += x(i) * y;
      sum[4 + d] += b;
      sum[4 + D + d] += y;
      sum[4 + 2 * D + d] += system.lumped(row) * b;
    }
    if (system.coupled(row))
      sum[4 + 3 * D] += system.lumped(row) * system.lumped(row);
  }
};

} // namespace

template <int D>
GuessSums<D> lookAtGuess(const MassSystem<D>& system, const View<double*>& right, const View<double*>& x,
                         const View<double*>& inverse, const View<double*>& image)
{
  double sum[GuessSums<D>::size] = {};
  withReach(system,
            [&](auto reach)
            {
              LookAtGuess<D, decltype(reach)::value> work;
              work.system = system;
              work.right = right;
              work.x = x;
              work.inverse = inverse;
              work.image = image;
              sumFew("rhegma::mass::guess", system.first, system.last, work, sum);
            });
  GuessSums<D> sums;
  sums.rightSquare = sum[0];
  sums.residualSquare = sum[1];
  sums.along = sum[2];
  sums.energy = sum[3];
  for (int d = 0; d < D; ++d)
  {
    sums.right[d] = sum[4 + d];
    sums.image[d] = sum[4 + D + d];
    sums.weighted[d] = sum[4 + 2 * D + d];
  }
  sums.lumpedSquare = sum[4 + 3 * D];
  return sums;
}

template GuessSums<2> lookAtGuess(const MassSystem<2>&, const View<double*>&, const View<double*>&,
                                  const View<double*>&, const View<double*>&);
template GuessSums<3> lookAtGuess(const MassSystem<3>&, const View<double*>&, const View<double*>&,
                                  const View<double*>&, const View<double*>&);

} // namespace Rhegma::mass_matrix
