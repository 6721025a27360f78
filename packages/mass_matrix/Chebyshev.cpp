#include "mass_matrix/Chebyshev.hpp"

#include "base/SmallLoops.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <utility>

namespace Rhegma::mass_matrix
{

namespace
{

/// last <- z + momentum (z - last) + gain D^-1 (r - M z)
template <int D>
void advance(const MassSystem<D>& system, const View<double*>& inverse, const double* r, const double* z,
             double* last, double momentum, double gain)
{
  withReach(system,
            [&](auto reach)
            {
              constexpr int W = MassSystem<D>::width;
              const MassSystem<D> s = system;
              const double* const weight = inverse.data();
              parallelForSmall(
                  "rhegma::mass::chebyshev", s.first, s.last, KOKKOS_LAMBDA(const int row) {
                    const Pack<W> image = rowTimes<D, decltype(reach)::value>(s, row, z);
                    for (int d = 0; d < W; ++d)
                    {
                      const int i = W * row + d;
                      last[i] = z[i] + momentum * (z[i] - last[i]) + gain * weight[i] * (r[i] - image[d]);
                    }
                  });
            });
}

/// The same with a given product.
template <int D>
void advance(const MassSystem<D>& system, const View<double*>& inverse, const double* r, const double* z,
             const View<double*>& image, double* last, double momentum, double gain)
{
  constexpr int W = MassSystem<D>::width;
  parallelForSmall(
      "rhegma::mass::chebyshevOnRanks", W * system.first, W * system.last, KOKKOS_LAMBDA(const int i) {
        last[i] = z[i] + momentum * (z[i] - last[i]) + gain * inverse(i) * (r[i] - image(i));
      });
}

} // namespace

template <int D>
Chebyshev<D>::Chebyshev(double least, int products) : least_(std::max(least, 0.05)), products_(products)
{
}

template <int D>
void Chebyshev<D>::apply(const State<D>* state, const MassSystem<D>& system, const View<double*>& inverse,
                         const double* r, double* z, double enough)
{
  const bool onRanks = state != nullptr && state->mesh.subdomain;
  const int n = system.rowCapacity * MassSystem<D>::width;
  if (static_cast<int>(other_.extent(0)) < n)
    other_ = View<double*>("rhegma::massChebyshev", n);
  if (onRanks && static_cast<int>(image_.extent(0)) < n)
    image_ = View<double*>("rhegma::massChebyshevImage", n);
  const double middle = 0.5 * (1.0 + least_), half = 0.5 * (1.0 - least_), sigma = middle / half;
  const MassSystem<D> s = system;
  double *now = z, *before = other_.data();
  const double* const weight = inverse.data();
  double square = 0.0;
  parallelSumSmall(
      "rhegma::mass::precondition", 0, n,
      KOKKOS_LAMBDA(const int i, double& sum) {
        now[i] = weight[i] * r[i] / middle;
        before[i] = 0.0;
        sum += s.weightOf(i / MassSystem<D>::width) * r[i] * r[i];
      },
      square);
  if (onRanks)
    sumParts(*state, &square, 1);
  if (square <= enough * enough)
    return;
  double rho = 1.0 / sigma;
  for (int k = 0; k < products_; ++k)
  {
    const double next = 1.0 / (2.0 * sigma - rho);
    if (!onRanks)
      advance(system, inverse, r, now, before, rho * next, 2.0 * next / half);
    else
    {
      multiplyWhole(*state, system, now, image_.data());
      advance(system, inverse, r, now, image_, before, rho * next, 2.0 * next / half);
    }
    rho = next;
    std::swap(now, before);
  }
}

template class Chebyshev<2>;
template class Chebyshev<3>;

} // namespace Rhegma::mass_matrix
