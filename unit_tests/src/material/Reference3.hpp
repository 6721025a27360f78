#pragma once
/// 3 x 3 matrices for reference solutions of constitutive laws, which share no code with the laws.

#include <array>
#include <cmath>

namespace Rhegma
{
namespace Test
{

using Matrix = std::array<double, 9>;

inline Matrix times(const Matrix& a, const Matrix& b)
{
  Matrix c{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        c[3 * i + j] += a[3 * i + k] * b[3 * k + j];
  return c;
}

inline Matrix transposed(const Matrix& a) { return {a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]}; }

inline double det(const Matrix& a)
{
  return a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
         a[2] * (a[3] * a[7] - a[4] * a[6]);
}

inline Matrix inverted(const Matrix& a)
{
  Matrix r{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      r[3 * j + i] = (a[3 * i1 + j1] * a[3 * i2 + j2] - a[3 * i1 + j2] * a[3 * i2 + j1]) / det(a);
    }
  return r;
}

inline double traceOf(const Matrix& a) { return a[0] + a[4] + a[8]; }

inline double doubleProduct(const Matrix& a, const Matrix& b)
{
  double sum = 0.0;
  for (int k = 0; k < 9; ++k)
    sum += a[k] * b[k];
  return sum;
}

/// a x + b y.
inline Matrix sumOf(double a, const Matrix& x, double b, const Matrix& y)
{
  Matrix r{};
  for (int k = 0; k < 9; ++k)
    r[k] = a * x[k] + b * y[k];
  return r;
}

constexpr Matrix one = {1, 0, 0, 0, 1, 0, 0, 0, 1};

inline Matrix deviator(const Matrix& a) { return sumOf(1.0, a, -traceOf(a) / 3.0, one); }

/// Numbers of an ordinary differential equation y' = f(t, y), by the classical method of Runge and Kutta.
template <std::size_t N, class Rate>
std::array<double, N> integrate(const Rate& rate, std::array<double, N> y, double end, int steps)
{
  const double h = end / steps;
  const auto moved = [&](const std::array<double, N>& k, double size)
  {
    std::array<double, N> r = y;
    for (std::size_t i = 0; i < N; ++i)
      r[i] += size * k[i];
    return r;
  };
  for (int s = 0; s < steps; ++s)
  {
    const double t = s * h;
    const auto a = rate(t, y), b = rate(t + 0.5 * h, moved(a, 0.5 * h)),
               c = rate(t + 0.5 * h, moved(b, 0.5 * h)), d = rate(t + h, moved(c, h));
    for (std::size_t i = 0; i < N; ++i)
      y[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
  }
  return y;
}

} // namespace Test
} // namespace Rhegma
