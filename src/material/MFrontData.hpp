#pragma once
/// Memory layout of the argument of laws with the generic interface of MFront (TFEL 4 and later), as the
/// documentation of MFront and MGIS gives it.

namespace Rhegma
{

/// The material at one end of a step. \tparam Number double, or const double at its start
template <class Number>
struct MFrontState
{
  const double* gradients;              ///< deformation gradient 9, or strain 6
  Number* thermodynamicForces;          ///< stress, 6
  const double* massDensity;            ///< of the undeformed material [kg/m3]
  const double* materialProperties;     ///< constants of the law
  Number* internalStateVariables;       ///< state variables
  Number* storedEnergy;                 ///< per volume [J/m3]
  Number* dissipatedEnergy;             ///< per volume, so far [J/m3]
  const double* externalStateVariables; ///< temperature [K], then zeros
};

/// The argument of `int NAME_Tridimensional(MFrontData*)`, which returns 1 if all is right, 0 if the result
/// is less accurate and -1 if there is none.
struct MFrontData
{
  char* errorMessage;   ///< of 512 characters
  double dt;            ///< [s]
  double* K;            ///< in: what to compute, in K[0]; out: the tangent, which is not asked for
  double* rdt;          ///< out: factor of dt that the law asks for
  double* speedOfSound; ///< out [m/s]
  MFrontState<const double> s0;
  MFrontState<double> s1;
};

} // namespace Rhegma
