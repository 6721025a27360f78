/* An elastic VUMAT whose stress is not a number where the strain along x has passed the third constant. State variables: that
   strain, and the number of calls. */
#include <math.h>

void vumat(const int *nblock, const int *ndir, const int *nshr, const int *nstatev, const int *nfieldv, const int *nprops,
           const int *lanneal, const double *stepTime, const double *totalTime, const double *dt, const char *cmname,
           const double *coordMp, const double *charLength, const double *props, const double *density, const double *strainInc,
           const double *relSpinInc, const double *tempOld, const double *stretchOld, const double *defgradOld,
           const double *fieldOld, const double *stressOld, const double *stateOld, const double *enerInternOld,
           const double *enerInelasOld, const double *tempNew, const double *stretchNew, const double *defgradNew,
           const double *fieldNew, double *stressNew, double *stateNew, double *enerInternNew, double *enerInelasNew)
{
  const int n = *nblock;
  const double mu = props[0] / (2.0 * (1.0 + props[1])), lambda = 2.0 * mu * props[1] / (1.0 - 2.0 * props[1]);
  for (int l = 0; l < n; ++l)
  {
    const double volume = strainInc[l] + strainInc[n + l] + strainInc[2 * n + l];
    stateNew[l] = stateOld[l] + strainInc[l];
    stateNew[n + l] = stateOld[n + l] + 1.0;
    for (int k = 0; k < 6; ++k)
    {
      const double change = 2.0 * mu * strainInc[k * n + l] + (k < 3 ? lambda * volume : 0.0);
      stressNew[k * n + l] = stateNew[l] > props[2] ? NAN : stressOld[k * n + l] + change;
    }
  }
}
