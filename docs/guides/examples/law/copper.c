/* Copper as a VUMAT in C: elastic, and plastic with the flow stress of Johnson and Cook without temperature,
       (A + B alpha^n) (1 + C ln(rate / 1 s^-1)), the rate that of the step.
   Constants: E, nu [Pa, -], A, B [Pa], n, C [-]. State variables: the plastic strain alpha. */
#include <math.h>

/* What the program checks the scene with. */
const unsigned short vumat_nMaterialProperties = 6, vumat_nInternalStateVariables = 1;

static double flow_stress(const double *p, double alpha, double rate)
{
  return (p[2] + p[3] * pow(alpha, p[4])) * (1.0 + p[5] * log(rate > 1.0 ? rate : 1.0));
}

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
    double s[6], square = 0.0, grown = 0.0;
    for (int k = 0; k < 6; ++k) /* 11 22 33 12 23 31; shear strains are those of the tensor */
      s[k] = stressOld[k * n + l] + 2.0 * mu * strainInc[k * n + l] + (k < 3 ? lambda * volume : 0.0);
    const double mean = (s[0] + s[1] + s[2]) / 3.0;
    for (int k = 0; k < 6; ++k)
      square += k < 3 ? (s[k] - mean) * (s[k] - mean) : 2.0 * s[k] * s[k];
    const double mises = sqrt(1.5 * square), alpha = stateOld[l];
    double low = 0.0, high = mises / (3.0 * mu); /* the plastic strain of the step lies between */
    if (mises > flow_stress(props, alpha, 0.0))
      for (int i = 0; i < 60; ++i)
      {
        grown = 0.5 * (low + high);
        if (mises - 3.0 * mu * grown > flow_stress(props, alpha + grown, grown / *dt))
          low = grown;
        else
          high = grown;
      }
    const double shrink = grown > 0.0 ? 1.0 - 3.0 * mu * grown / mises : 1.0;
    for (int k = 0; k < 6; ++k)
      stressNew[k * n + l] = shrink * s[k] + (k < 3 ? (1.0 - shrink) * mean : 0.0);
    stateNew[l] = alpha + grown;
    /* Energies per mass: dissipated, and with the elastic energy of the stress. */
    enerInelasNew[l] = enerInelasOld[l] + shrink * mises * grown / density[l];
    const double bulk = lambda + 2.0 / 3.0 * mu, elastic = shrink * shrink * mises * mises / (6.0 * mu) + 0.5 * mean * mean / bulk;
    enerInternNew[l] = enerInelasNew[l] + elastic / density[l];
  }
}
