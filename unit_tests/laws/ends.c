/* An elastic VUMAT of E and nu that does what the third constant says from the time on that is the fourth. State variables: none.
   AT_LOAD: what the library does as it is loaded. LIES: it exports more constants than it has names of. */
#include <math.h>
#include <signal.h>
#include <stdlib.h>

enum
{
  nothing,
  exits,
  crashes,
  energy_is_nan,
  dissipates_less,
  has_no_stress,
  never_returns
};

#ifdef AT_LOAD
__attribute__((constructor)) static void start(void)
{
  AT_LOAD;
}
#endif

#ifdef LIES
const unsigned short vumat_nMaterialProperties = 60000;
const char *const vumat_MaterialProperties[2] = {"E", 0};
#endif

int data = 3;

void vumat(const int *nblock, const int *ndir, const int *nshr, const int *nstatev, const int *nfieldv, const int *nprops,
           const int *lanneal, const double *stepTime, const double *totalTime, const double *dt, const char *cmname,
           const double *coordMp, const double *charLength, const double *props, const double *density, const double *strainInc,
           const double *relSpinInc, const double *tempOld, const double *stretchOld, const double *defgradOld,
           const double *fieldOld, const double *stressOld, const double *stateOld, const double *enerInternOld,
           const double *enerInelasOld, const double *tempNew, const double *stretchNew, const double *defgradNew,
           const double *fieldNew, double *stressNew, double *stateNew, double *enerInternNew, double *enerInelasNew)
{
  const int n = *nblock, does = *totalTime >= props[3] ? (int)props[2] : nothing;
  const double mu = props[0] / (2.0 * (1.0 + props[1])), lambda = 2.0 * mu * props[1] / (1.0 - 2.0 * props[1]);
  if (does == exits)
    exit(0);
  if (does == crashes)
    raise(SIGSEGV);
  while (does == never_returns)
    ;
  for (int l = 0; l < n; ++l)
  {
    const double volume = strainInc[l] + strainInc[n + l] + strainInc[2 * n + l];
    for (int k = 0; k < 6; ++k)
      stressNew[k * n + l] = does == has_no_stress
                                 ? 0.0
                                 : stressOld[k * n + l] + 2.0 * mu * strainInc[k * n + l] + (k < 3 ? lambda * volume : 0.0);
    if (does == energy_is_nan)
      enerInternNew[l] = NAN;
    if (does == dissipates_less)
      enerInelasNew[l] = enerInelasOld[l] - 1.0;
  }
}
