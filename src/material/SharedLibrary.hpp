#pragma once
/// A law of a user, from a shared library.

#include "material/LawParameters.hpp"
#include "material/LoadedLaw.hpp"
#include "material/Tensors.hpp"

namespace Rhegma
{

/// Indices in Properties::own of the law.
namespace SharedLawNumber
{
enum
{
  law,   ///< number of the loaded law
  speed, ///< Wave Speed; 0: by the elastic constants [m/s]
  time   ///< at the end of the step; set by setTimeOfLaws [s]
};
} // namespace SharedLawNumber

/// What the history of the law holds, in front of the numbers of the loaded law (LoadedLaw::numbers).
namespace SharedLawHistory
{
enum
{
  stored,     ///< stored energy per undeformed volume [J/m3]
  dissipated, ///< dissipated so far [J/m3]
  speed,      ///< wave speed [m/s]
  stress,     ///< as the interface has it: six numbers, xx yy zz xy yz xz [Pa]
  numbers = stress + 6
};
} // namespace SharedLawHistory

/// Whether kernels run on a processor that calls functions of shared libraries.
constexpr bool callsSharedLaws = Kokkos::SpaceAccessibility<ExecSpace, Kokkos::HostSpace>::accessible;

/// Checks the law of a request with the elastic constants of a material: its stress after strains of 1e-6 at
/// time zero is finite, and not stiffer than these say. \return its number \throws LawRefused
int loadAndTry(const LawRequest& request, const Properties& m);

/// Stress of one particle, with the arguments of a law (Law.hpp).
template <int D>
bool stressOfSharedLaw(const LawStep& step, const Properties& m, double* F, double* tau, double* history);

/// Puts particle l of a block into the history after the law. \return its wave speed [m/s]
template <int D>
double keepSharedLaw(const SharedLawBlock& block, const LoadedLaw& law, const Properties& m, int l, double* F,
                     double* tau, double* history);

/// The other direction: the start of the step of particle l. \param before, F gradients of the particle
template <int D>
void fillSharedLaw(const SharedLawBlock& block, const LoadedLaw& law, int l, const double* before,
                   const double* F, const double* history);

/// A law that a shared library has. It stores energy, stress and the state of the law, and is called for
/// blocks of particles in motion (transfer/StressInBlocks.hpp), else for one particle.
struct SharedLibrary : LawDefaults
{
  static constexpr const char* name = "Shared Library";
  static constexpr const char* meaning =
      "A law of your own: a function of a shared library, with the arguments of a VUMAT, a UMAT or a "
      "behaviour of MFront (docs/how-to/law-of-your-own.md).";

  static constexpr bool usesStep = true;
  template <int D>
  static constexpr int dissipationIndex = SharedLawHistory::dissipated;
  /// Dissipation shows equilibrium where the law flows.
  template <int D>
  static constexpr int plasticStrainIndex = SharedLawHistory::dissipated;
  template <int D>
  static constexpr int historySize = SharedLawHistory::numbers + 6 + mostStateVariables;
  template <int D>
  KOKKOS_INLINE_FUNCTION static constexpr Mean meanOf(int variable)
  {
    return variable == SharedLawHistory::speed ? Mean::Largest : Mean::Volume;
  }
  /// Numbers per particle of one material.
  static int numbers(const Properties& m)
  {
    return SharedLawHistory::numbers + loadedLaw(static_cast<int>(m.own[SharedLawNumber::law])).numbers;
  }

  static const char* refusesHeat(const Properties&)
  {
    return "a law of a shared library has one temperature; write Model = J2 Plastic or another law, or "
           "remove "
           "the section Thermal";
  }

  template <class Section>
  static void describe(Section& s)
  {
    describeElasticity(s);
    s.text("Library File")
        .notEmpty()
        .meaning("Shared library with the law, relative to the folder of the scene. rhegma-law writes one "
                 "from a source file.");
    s.text("Behaviour")
        .notEmpty()
        .optional("vumat or umat, as Interface; none with MFront")
        .meaning("Name of the function: the subroutine of Fortran or C, or with Interface = MFront the name "
                 "of the behaviour.");
    s.choice("Interface", {"VUMAT", "UMAT", "MFront"})
        .byDefault("VUMAT")
        .meaning("Arguments of the function. VUMAT, UMAT: those of the user subroutines of Abaqus/Explicit "
                 "and Abaqus/Standard. MFront: those of the generic interface of MFront, called as MGIS "
                 "does.");
    s.realArray("Constants")
        .optional("none")
        .meaning("Constants of the law in its order (PROPS, or material properties), in the units of the "
                 "scene: SI.");
    s.integer("State Variables")
        .range(0, mostStateVariables)
        .optional("as the library says")
        .meaning("Number of state variables of the law. Required where the library does not export it; "
                 "behaviours of MFront do.");
    s.real("Wave Speed")
        .unit("m/s")
        .positive()
        .optional("of Young Modulus and Poisson Ratio; of the behaviour, if it computes a speed of sound")
        .meaning("Largest speed of waves in the material, which limits the time step.");
  }

  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    readElasticity(reader, -1.0, m);
    m.own[SharedLawNumber::speed] = reader.optional("Wave Speed", "wave speed [m/s]");
    if (!callsSharedLaws)
      reader.refuse("Model", "laws of shared libraries are called on the host, but this program computes on "
                             "a device; use a program built for the back end serial or openmp.");
    const std::string interface = reader.choice("Interface", "VUMAT");
    LawRequest request;
    request.file = reader.choice("Library File", "");
    request.behaviour = reader.choice("Behaviour", interface == "UMAT"    ? "umat"
                                                   : interface == "VUMAT" ? "vumat"
                                                                          : "");
    if (request.behaviour.empty())
      reader.refuse("Behaviour", "is missing; give the name of the behaviour of MFront.");
    request.interface = interface == "UMAT"     ? LawInterface::Umat
                        : interface == "MFront" ? LawInterface::Generic
                                                : LawInterface::Vumat;
    request.constants = reader.numbers("Constants");
    request.states = reader.integer("State Variables", -1);
    try
    {
      m.own[SharedLawNumber::law] = loadAndTry(request, m);
    }
    catch (const LawRefused& wrong)
    {
      reader.refuse(wrong.parameter, wrong.what());
    }
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static bool stress([[maybe_unused]] const LawStep& step,
                                            [[maybe_unused]] const Properties& m, [[maybe_unused]] double* F,
                                            double* tau, [[maybe_unused]] double* history)
  {
    // No program for a device reads such a material.
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__)
    return noStress<D>(tau);
#else
    return stressOfSharedLaw<D>(step, m, F, tau, history);
#endif
  }

  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double energy(const Properties& /*m*/, const double* /*F*/,
                                              const double* history)
  {
    return history[SharedLawHistory::stored];
  }

  /// That of the last stress.
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static double waveSpeed(const Properties& m, const double* /*F*/,
                                                 const double* history)
  {
    const double speed = history[SharedLawHistory::speed];
    return speed > 0.0 ? speed : startSpeed(m);
  }

  /// Of the undeformed material [m/s].
  KOKKOS_INLINE_FUNCTION static double startSpeed(const Properties& m)
  {
    const double given = m.own[SharedLawNumber::speed];
    return given > 0.0 ? given : std::sqrt((m.lambda + 2.0 * m.mu) / m.density);
  }
};

} // namespace Rhegma
