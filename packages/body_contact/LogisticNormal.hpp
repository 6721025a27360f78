#pragma once
/// The plane between two clouds of points, by logistic regression.

#include "base/Types.hpp"

namespace Rhegma::body_contact
{

/// Weight of the square of the plane's coefficients. The smaller it is, the closer the plane comes to the one
/// with the largest distance to both clouds, whatever points lie further away; a smaller one needs more
/// iterations, one for each unit of its logarithm.
constexpr double regularisation = 1e-7;

/// The function that logistic regression minimises, with its derivatives: coefficients are the normal
/// [1/cell] and then the offset.
template <int D>
struct LogisticSums
{
  static constexpr int size = D + 1; ///< number of coefficients
  double value = 0.0;                ///< of the function
  double slope[size] = {};           ///< its first derivatives
  double curvature[size][size] = {}; ///< its second ones, the lower half

  /// Adds a point. \param label +1 or -1 \param weight of the point \param x position [cells]
  KOKKOS_INLINE_FUNCTION void add(const double (&plane)[size], double label, double weight,
                                  const Vector<D>& x)
  {
    double at[size];
    double product = 0.0;
    for (int d = 0; d < D; ++d)
      product += (at[d] = x[d]) * plane[d];
    at[D] = 1.0;
    const double margin = label * (product + plane[D]);
    const double small = std::exp(-std::fabs(margin));
    value += weight * (std::log1p(small) + (margin < 0.0 ? -margin : 0.0));
    const double wrong = margin > 0.0 ? small / (1.0 + small) : 1.0 / (1.0 + small);
    const double bend = weight * small / ((1.0 + small) * (1.0 + small));
    for (int i = 0; i < size; ++i)
    {
      slope[i] -= weight * label * wrong * at[i];
      for (int j = 0; j <= i; ++j)
        curvature[i][j] += bend * at[i] * at[j];
    }
  }

  /// Adds the squares of the coefficients.
  KOKKOS_INLINE_FUNCTION void addRegularisation(const double (&plane)[size])
  {
    for (int i = 0; i < size; ++i)
    {
      value += 0.5 * regularisation * plane[i] * plane[i];
      slope[i] += regularisation * plane[i];
      curvature[i][i] += regularisation;
    }
  }

  /// The step of Newton's method; the curvature is overwritten by its factor. \return the decrease that the
  /// step would bring along its slope
  KOKKOS_INLINE_FUNCTION double newtonStep(double (&step)[size])
  {
    for (int i = 0; i < size; ++i)
      for (int j = 0; j <= i; ++j)
      {
        double sum = curvature[i][j];
        for (int k = 0; k < j; ++k)
          sum -= curvature[i][k] * curvature[j][k];
        curvature[i][j] = i == j ? std::sqrt(std::fmax(sum, 1e-30)) : sum / curvature[j][j];
      }
    for (int i = 0; i < size; ++i)
    {
      step[i] = -slope[i];
      for (int k = 0; k < i; ++k)
        step[i] -= curvature[i][k] * step[k];
      step[i] /= curvature[i][i];
    }
    double decrease = 0.0;
    for (int i = size - 1; i >= 0; --i)
    {
      for (int k = i + 1; k < size; ++k)
        step[i] -= curvature[k][i] * step[k];
      step[i] /= curvature[i][i];
    }
    for (int i = 0; i < size; ++i)
      decrease -= slope[i] * step[i];
    return decrease;
  }
};

/// Unit normal, from the points with label -1 to those with +1, of the plane that separates them best; zero
/// where one of the two has no point.
///
/// The plane minimises the mean over each cloud of log(1 + exp(-label (normal . x + offset))) plus the
/// regularisation: the logistic regression of Nairn, Hammerquist and Smith, Comput. Methods Appl. Mech.
/// Engrg. 362 (2020) 112859, with the likelihood for their squares, so that it has one minimum. Found by
/// Newton's method with steps that are halved until the function falls.
///
/// \param points points(visit) calls visit(label, x), x in cells
template <int D, class Points>
KOKKOS_INLINE_FUNCTION Vector<D> logisticNormal(const Points& points)
{
  constexpr int size = D + 1, mostIterations = 60;
  constexpr double converged = 1e-14; // decrease of the function; its minimum is above the regularisation
  double number[2] = {0.0, 0.0};
  Vector<D> mean[2] = {};
  points(
      [&](double label, const Vector<D>& x)
      {
        const int k = label > 0.0 ? 1 : 0;
        number[k] += 1.0;
        mean[k] = mean[k] + x;
      });
  Vector<D> normal{};
  if (number[0] == 0.0 || number[1] == 0.0)
    return normal;
  for (int k = 0; k < 2; ++k)
    mean[k] = (1.0 / number[k]) * mean[k];
  const double weight[2] = {0.5 / number[0], 0.5 / number[1]};
  double plane[size];
  const Vector<D> across = mean[1] - mean[0];
  const double distance = std::fmax(norm(across), 1e-6);
  plane[D] = 0.0;
  for (int d = 0; d < D; ++d)
  {
    plane[d] = 8.0 / (distance * std::fmax(distance, 0.5)) * across[d];
    plane[D] -= 0.5 * plane[d] * (mean[0][d] + mean[1][d]);
  }
  const auto evaluate = [&](const double(&at)[size])
  {
    LogisticSums<D> sums;
    points([&](double label, const Vector<D>& x) { sums.add(at, label, weight[label > 0.0 ? 1 : 0], x); });
    sums.addRegularisation(at);
    return sums;
  };
  LogisticSums<D> sums = evaluate(plane);
  double step[size], fraction = 1.0;
  double decrease = sums.newtonStep(step);
  for (int k = 0; k < mostIterations && decrease > converged; ++k)
  {
    double next[size];
    for (int i = 0; i < size; ++i)
      next[i] = plane[i] + fraction * step[i];
    LogisticSums<D> trial = evaluate(next);
    if (!(trial.value <= sums.value - 1e-4 * fraction * decrease))
    {
      fraction *= 0.5;
      continue;
    }
    for (int i = 0; i < size; ++i)
      plane[i] = next[i];
    sums = trial;
    fraction = 1.0;
    decrease = sums.newtonStep(step);
  }
  for (int d = 0; d < D; ++d)
    normal[d] = plane[d];
  const double length = norm(normal);
  return length > 0.0 ? (1.0 / length) * normal : Vector<D>{};
}

} // namespace Rhegma::body_contact
