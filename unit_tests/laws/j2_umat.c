/* Small-strain J2 plasticity with linear hardening in rate form, as a UMAT in C under the name that compilers of Fortran
   give it: Cauchy stress, which the caller has turned, and the strain increment. PROPS: E, nu, yield stress, hardening.
   STATEV: equivalent plastic strain. */
#include <math.h>
#include <stddef.h>

void umat_(double *stress, double *statev, double *ddsdde, double *sse, double *spd, double *scd, double *rpl, double *ddsddt,
           double *drplde, double *drpldt, const double *stran, const double *dstran, const double *time, const double *dtime,
           const double *temp, const double *dtemp, const double *predef, const double *dpred, const char *cmname,
           const int *ndi, const int *nshr, const int *ntens, const int *nstatv, const double *props, const int *nprops,
           const double *coords, const double *drot, double *pnewdt, const double *celent, const double *dfgrd0,
           const double *dfgrd1, const int *noel, const int *npt, const int *layer, const int *kspt, const int *jstep,
           const int *kinc, size_t length)
{
  const double mu = props[0] / (2.0 * (1.0 + props[1])), lambda = 2.0 * mu * props[1] / (1.0 - 2.0 * props[1]);
  const double volume = dstran[0] + dstran[1] + dstran[2];
  for (int k = 0; k < 6; ++k)
    stress[k] += k < 3 ? lambda * volume + 2.0 * mu * dstran[k] : mu * dstran[k];
  const double mean = (stress[0] + stress[1] + stress[2]) / 3.0;
  double square = 0.0;
  for (int k = 0; k < 6; ++k)
    square += k < 3 ? (stress[k] - mean) * (stress[k] - mean) : 2.0 * stress[k] * stress[k];
  const double mises = sqrt(1.5 * square), limit = props[2] + props[3] * statev[0];
  if (mises > limit)
  {
    const double grown = (mises - limit) / (3.0 * mu + props[3]), shrink = 1.0 - 3.0 * mu * grown / mises;
    for (int k = 0; k < 6; ++k)
      stress[k] = k < 3 ? mean + shrink * (stress[k] - mean) : shrink * stress[k];
    *spd += grown * (limit + 0.5 * props[3] * grown);
    statev[0] += grown;
  }
  if (*nprops > 4 && statev[0] > props[4]) /* a law that can't go on */
    *pnewdt = 0.5;
}
