#include "mass_matrix/FirstGuess.hpp"

#include "base/SmallLoops.hpp"
#include "state/Subdomain.hpp"

namespace Rhegma::mass_matrix
{

namespace
{

/// image = M x, with the sums of a first guess.
template <int D, int Reach>
struct CheckGuess
{
  using value_type = double[];
  using size_type = int;
  static constexpr int width = MassSystem<D>::width;

  int value_count = GuessSums<D>::size;
  MassSystem<D> system;
  View<double*> right, x, inverse, image;
  bool formed; ///< whether the image is there already

  KOKKOS_INLINE_FUNCTION void operator()(const int row, double* sum) const
  {
    if (formed)
      return addSums(row, system.rowWeight(row), Pack<width>::load(image.data() + width * row), sum);
    const Pack<width> product = rowTimes<D, Reach>(system, row, x.data());
    for (int d = 0; d < D; ++d)
      image(width * row + d) = product[d];
    addSums(row, 1.0, product, sum);
  }

  KOKKOS_FORCEINLINE_FUNCTION void addSums(int row, double weight, const Pack<width>& product,
                                           double* sum) const
  {
    for (int d = 0; d < D; ++d)
    {
      const int i = width * row + d;
      if (inverse(i) == 0.0)
        continue;
      const double b = weight * right(i), y = product[d];
      sum[0] += b * right(i);
      sum[1] += weight * (right(i) - y) * (right(i) - y);
      sum[2] += x(i) * b;
      sum[3] += weight * x(i) * y;
      sum[4 + d] += b;
      sum[4 + D + d] += weight * y;
      sum[4 + 2 * D + d] += system.lumped(row) * b;
    }
    if (system.coupled(row))
      sum[4 + 3 * D] += weight * system.lumped(row) * system.lumped(row);
  }
};

} // namespace

template <int D>
GuessSums<D> checkGuess(const State<D>& state, const MassSystem<D>& system, const View<double*>& right,
                        const View<double*>& x, const View<double*>& inverse, const View<double*>& image)
{
  double sum[GuessSums<D>::size] = {};
  const bool formed = static_cast<bool>(state.mesh.subdomain);
  if (formed)
    multiplyWhole(state, system, x.data(), image.data());
  withReach(system,
            [&](auto reach)
            {
              CheckGuess<D, decltype(reach)::value> work;
              work.system = system;
              work.right = right;
              work.x = x;
              work.inverse = inverse;
              work.image = image;
              work.formed = formed;
              parallelSumSmall("rhegma::mass::guess", system.first, system.last, work, sum);
            });
  sumParts(state, sum, GuessSums<D>::size);
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

template GuessSums<2> checkGuess(const State<2>&, const MassSystem<2>&, const View<double*>&,
                                 const View<double*>&, const View<double*>&, const View<double*>&);
template GuessSums<3> checkGuess(const State<3>&, const MassSystem<3>&, const View<double*>&,
                                 const View<double*>&, const View<double*>&, const View<double*>&);

} // namespace Rhegma::mass_matrix
