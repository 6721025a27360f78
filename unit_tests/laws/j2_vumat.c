/* J2 plasticity (j2.h) as a VUMAT in C. */
#include "j2.h"

const unsigned short vumat_nMaterialProperties = 4, vumat_nInternalStateVariables = 7;
const char *const vumat_MaterialProperties[4] = {"Young", "Poisson", "Yield", "Hardening"};

void vumat(const int *nblock, const int *ndir, const int *nshr, const int *nstatev, const int *nfieldv, const int *nprops,
           const int *lanneal, const double *stepTime, const double *totalTime, const double *dt, const char *cmname,
           const double *coordMp, const double *charLength, const double *props, const double *density, const double *strainInc,
           const double *relSpinInc, const double *tempOld, const double *stretchOld, const double *defgradOld,
           const double *fieldOld, const double *stressOld, const double *stateOld, const double *enerInternOld,
           const double *enerInelasOld, const double *tempNew, const double *stretchNew, const double *defgradNew,
           const double *fieldNew, double *stressNew, double *stateNew, double *enerInternNew, double *enerInelasNew)
{
  const int n = *nblock;
  for (int l = 0; l < n; ++l)
  {
    double U[6], old[7], state[7], stress[6], stored, dissipated;
    for (int k = 0; k < 6; ++k)
      U[k] = stretchNew[k * n + l];
    for (int k = 0; k < 7; ++k)
      old[k] = stateOld[k * n + l];
    j2(props, U, old, state, stress, &stored, &dissipated);
    for (int k = 0; k < 6; ++k)
      stressNew[k * n + l] = stress[k];
    for (int k = 0; k < 7; ++k)
      stateNew[k * n + l] = state[k];
    /* Energies are per mass; `density` is that of the middle of the step. */
    const double before[6] = {stretchOld[l],         stretchOld[n + l],     stretchOld[2 * n + l],
                              stretchOld[3 * n + l], stretchOld[4 * n + l], stretchOld[5 * n + l]};
    const double density0 = density[l] * 0.5 * (determinant(before) + determinant(U));
    enerInelasNew[l] = enerInelasOld[l] + dissipated / density0;
    enerInternNew[l] = stored / density0 + enerInelasNew[l];
  }
}
