/* J2 plasticity (j2.h) with the generic interface of MFront: be = J^(-2/3) F Cp^-1 F^T, by U and R of F. */
#include "j2.h"

typedef struct
{
  const double *gradients;
  double *thermodynamic_forces;
  const double *mass_density, *material_properties;
  double *internal_state_variables, *stored_energy, *dissipated_energy;
  const double *external_state_variables;
} State;

typedef struct
{
  char *error_message;
  double dt;
  double *K, *rdt, *speed_of_sound;
  State s0, s1;
} Data;

const unsigned short J2_nMaterialProperties = 4, J2_nInternalStateVariables = 2, J2_BehaviourType = 2;
const char *const J2_MaterialProperties[4] = {"YoungModulus", "PoissonRatio", "YieldStress", "Hardening"};
const int J2_InternalStateVariablesTypes[2] = {1, 0};

/* R of F = R U by Newton's iteration. F and R in rows. */
static void rotation(const double F[9], double R[9])
{
  for (int k = 0; k < 9; ++k)
    R[k] = F[k];
  double change = 1.0;
  for (int step = 0; step < 60 && change > 1e-8; ++step)
  {
    change = 0.0;
    double C[9];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
      {
        const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
        C[3 * i + j] = R[3 * a + c] * R[3 * b + d] - R[3 * a + d] * R[3 * b + c];
      }
    const double J = R[0] * C[0] + R[1] * C[1] + R[2] * C[2];
    for (int k = 0; k < 9; ++k)
    {
      const double by = 0.5 * (C[k] / J - R[k]);
      R[k] += by;
      change = fmax(change, fabs(by));
    }
  }
}

int J2_Tridimensional(Data *d)
{
  static const int place[9] = {0, 4, 8, 1, 3, 2, 6, 5, 7}; /* 11 22 33 12 21 13 31 23 32 */
  static const int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
  double F[9], R[9], U[6], stress[6], done;
  for (int k = 0; k < 9; ++k)
    F[place[k]] = d->s1.gradients[k];
  rotation(F, R);
  for (int k = 0; k < 6; ++k)
  {
    U[k] = 0.0;
    for (int i = 0; i < 3; ++i)
      U[k] += 0.5 * (R[3 * i + row[k]] * F[3 * i + column[k]] + R[3 * i + column[k]] * F[3 * i + row[k]]);
  }
  j2(d->s1.material_properties, U, d->s0.internal_state_variables, d->s1.internal_state_variables, stress,
     d->s1.stored_energy, &done);
  *d->s1.dissipated_energy = *d->s0.dissipated_energy + done;
  static const int at[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}, order[6] = {0, 1, 2, 3, 5, 4}; /* 11 22 33 12 13 23 */
  for (int k = 0; k < 6; ++k)
  {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        sum += R[3 * row[order[k]] + i] * stress[at[i][j]] * R[3 * column[order[k]] + j];
    d->s1.thermodynamic_forces[k] = (k < 3 ? 1.0 : sqrt(2.0)) * sum;
  }
  if (d->K[0] > 50.0)
  {
    const double *p = d->s1.material_properties, mu = p[0] / (2.0 * (1.0 + p[1])), bulk = p[0] / (3.0 * (1.0 - 2.0 * p[1]));
    *d->speed_of_sound = sqrt((bulk + 4.0 / 3.0 * mu) / *d->s1.mass_density);
  }
  return 1;
}
