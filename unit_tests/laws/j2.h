/* Finite J2 plasticity with linear hardening in the stretch U alone, the equations of Rhegma's J2 Plastic: with
   be = J^(-2/3) U Cp^-1 U, W = K/2 ((J^2 - 1)/2 - ln J) + mu/2 (tr be - 3). Tensors: 11 22 33 12 23 31. */
#ifndef J2_H
#define J2_H

#include <math.h>

/* b = a s a for symmetric a and s. */
static void sandwich(const double a[6], const double s[6], double b[6])
{
  const double A[3][3] = {{a[0], a[3], a[5]}, {a[3], a[1], a[4]}, {a[5], a[4], a[2]}};
  const double S[3][3] = {{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}};
  const int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
  double half[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      half[i][j] = A[i][0] * S[0][j] + A[i][1] * S[1][j] + A[i][2] * S[2][j];
  for (int k = 0; k < 6; ++k)
  {
    const double *h = half[row[k]];
    b[k] = h[0] * A[0][column[k]] + h[1] * A[1][column[k]] + h[2] * A[2][column[k]];
  }
}

static double determinant(const double a[6])
{
  return a[0] * (a[1] * a[2] - a[4] * a[4]) - a[3] * (a[3] * a[2] - a[4] * a[5]) + a[5] * (a[3] * a[4] - a[1] * a[5]);
}

static void invert(const double a[6], double b[6])
{
  const double J = determinant(a);
  b[0] = (a[1] * a[2] - a[4] * a[4]) / J;
  b[1] = (a[0] * a[2] - a[5] * a[5]) / J;
  b[2] = (a[0] * a[1] - a[3] * a[3]) / J;
  b[3] = (a[5] * a[4] - a[3] * a[2]) / J;
  b[4] = (a[3] * a[5] - a[0] * a[4]) / J;
  b[5] = (a[3] * a[4] - a[5] * a[1]) / J;
}

/* constants: E, nu, yield stress, hardening. state: Cp^-1 - 1 (6), alpha. out: Cauchy stress in the frame of U,
   new state, stored energy and dissipation of the step per undeformed volume. */
static void j2(const double *constants, const double U[6], const double *old, double *state, double stress[6], double *stored,
               double *dissipated)
{
  const double mu = constants[0] / (2.0 * (1.0 + constants[1])), bulk = constants[0] / (3.0 * (1.0 - 2.0 * constants[1]));
  const double J = determinant(U), scale = 1.0 / cbrt(J * J);
  double C[6], be[6], s[6];
  for (int k = 0; k < 6; ++k)
    C[k] = old[k] + (k < 3 ? 1.0 : 0.0);
  sandwich(U, C, be);
  const double mean = scale * (be[0] + be[1] + be[2]) / 3.0;
  double square = 0.0;
  for (int k = 0; k < 6; ++k)
  {
    s[k] = scale * be[k] - (k < 3 ? mean : 0.0);
    square += (k < 3 ? 1.0 : 2.0) * s[k] * s[k];
    state[k] = old[k];
  }
  double alpha = old[6], now = mean;
  const double trial = mu * sqrt(square), limit = sqrt(2.0 / 3.0) * (constants[2] + constants[3] * alpha);
  *dissipated = 0.0;
  if (trial > limit)
  {
    const double gamma = (trial - limit) / (2.0 * mu * mean + 2.0 / 3.0 * constants[3]);
    const double shrink = (trial - 2.0 * mu * mean * gamma) / trial;
    for (int k = 0; k < 6; ++k)
      s[k] *= shrink;
    const double half = 0.5 * shrink * shrink * square, cube = determinant(s);
    double step = 1.0;
    for (int i = 0; i < 60 && step > 1e-15; ++i) /* det(s + now 1) = 1, from above */
      now -= step = (now * now * now - half * now + cube - 1.0) / (3.0 * now * now - half);
    double back[6], whole[6];
    for (int k = 0; k < 6; ++k)
      whole[k] = (s[k] + (k < 3 ? now : 0.0)) / scale;
    invert(U, back);
    sandwich(back, whole, state);
    for (int k = 0; k < 3; ++k)
      state[k] -= 1.0;
    const double grown = sqrt(2.0 / 3.0) * gamma, mid = constants[2] + constants[3] * (alpha + 0.5 * grown);
    *dissipated = mid * grown * 3.0 * now * (now - 1.5 * cube / half) / (3.0 * now * now - half);
    alpha += grown;
  }
  state[6] = alpha;
  for (int k = 0; k < 6; ++k)
    stress[k] = (mu * s[k] + (k < 3 ? 0.5 * bulk * (J * J - 1.0) : 0.0)) / J;
  *stored = 0.5 * bulk * (0.5 * (J * J - 1.0) - log(J)) + 1.5 * mu * (now - 1.0);
}

#endif
