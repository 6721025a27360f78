#pragma once
/// Interface of constitutive laws. How to add one: docs/how-to/add-a-material.md.
///
/// A law is a struct that inherits LawDefaults, with static members only. Each of these is a template of the
/// dimension and of the plane:
///
///     bool   stress<D, P>([step,] numbers, F, tau, history)   once per particle and step
///     double energy<D, P>(numbers, F, history)                [J/m3], stored, per undeformed volume
///     double waveSpeed<D, P>(numbers, F, history)             [m/s], in 3D, relative to the material
///
/// `F` is the deformation gradient (gradientSize<D>), `tau` the Kirchhoff stress J sigma [Pa]
/// (symmetricSize<D>), so that the force of a particle on a node is -V0 tau grad N. In plane stress `stress`
/// writes the thickness stretch that lets tau_zz vanish into F[4]; on entry F[4] is only where the search
/// starts. `stress` returns false, with tau zero, when F is inverted or not a number: the run aborts.
/// `waveSpeed` and `energy` get F as completed by `stress`. `waveSpeed` is an upper bound of the speed of
/// every small plane wave in the deformed state, and is the dilatational wave speed where F = 1. A law with
/// `usesStep = true` gets a LawStep before the numbers.
///
/// For scenes a law has its `name`, the value of `Model`, its `meaning`, and two more templates, so that
/// kernels include neither schema nor parameter lists:
///
///     void describe(section)         adds its parameters (scene/Schema.hpp)
///     void read(reader, numbers)     checks them and sets the numbers (material/MaterialReader.hpp)

#include "base/Types.hpp"

namespace Rhegma
{

/// How a history variable of a merged particle follows from those of its parts.
enum class Mean
{
  Volume, ///< mean weighted by undeformed volume: anything given per volume, tensors of strain
  Mass,   ///< mean weighted by mass: anything given per mass
  Largest ///< the largest: damage, a maximum over the past
};

/// Largest number of parameters specific to one law.
constexpr int lawNumbers = 24;

/// Parameters of one material; plain data for a View<Properties*>. `makeProperties` (MaterialTable.hpp) fills
/// it. lambda, mu and bulk are set for every law: they are its moduli at small strain.
struct Properties
{
  int law = 0; ///< index in the list of laws (Laws.hpp)
  Plane plane = Plane::Solid;
  double density = 0.0;        ///< of the undeformed material [kg/m3]
  double temperature = 293.15; ///< at which a law is evaluated in scenes without heat [K]
  double lambda = 0.0;         ///< Lame's first parameter [Pa]
  double mu = 0.0;             ///< shear modulus [Pa]
  double bulk = 0.0;           ///< bulk modulus [Pa]
  double planeLambda = 0.0;    ///< lambda, in plane stress 2 lambda mu / (lambda + 2 mu) [Pa]
  double thicknessRatio = 0.0; ///< lambda / (lambda + 2 mu), contraction of the thickness in plane stress [-]
  double cellSize = 0.0; ///< edge of the scene's cells, the length of artificial viscosity; 0: not known [m]
  bool heated = false;   ///< the scene has heat, so that temperatures come from it and not from the law
  double own[lawNumbers] = {}; ///< of the law alone; the law's header names them
};

/// Sets what follows from lambda and mu.
KOKKOS_INLINE_FUNCTION void setPlaneModuli(Properties& m)
{
  m.thicknessRatio = m.lambda / (m.lambda + 2.0 * m.mu);
  m.planeLambda = m.plane == Plane::Stress ? 2.0 * m.mu * m.thicknessRatio : m.lambda;
}

/// The step that leads to F, for laws with `usesStep`. Both F are without thermal strain.
struct LawStep
{
  const double* before; ///< F at the start of the step; in plane stress with the thickness stretch of then
  double dt;            ///< [s]; zero where stress is evaluated with nothing moving: F is then `before`
  double temperature;   ///< [K]
};

/// Defaults of laws.
struct LawDefaults
{
  /// Whether `stress` gets a LawStep.
  static constexpr bool usesStep = false;
  /// Numbers that the law stores per particle. All zero is the undeformed, unused material.
  template <int D>
  static constexpr int historySize = 0;
  /// Index in the history of the energy dissipated so far per undeformed volume [J/m3]; -1: none.
  template <int D>
  static constexpr int dissipationIndex = -1;
  /// Whether the law has a damage: a law with `damages = true` has double damage<D>(numbers, history), from 0
  /// of a whole to 1 of a broken material.
  static constexpr bool damages = false;
  /// How a history variable averages when particles merge.
  template <int D>
  KOKKOS_INLINE_FUNCTION static constexpr Mean meanOf(int /*variable*/)
  {
    return Mean::Volume;
  }
  /// What a law computes once for all particles of a material in a step without heat; a law with `prepares =
  /// true` gets it before the LawStep.
  static constexpr bool prepares = false;
  struct Ready
  {
    KOKKOS_INLINE_FUNCTION Ready(const Properties& /*m*/, double /*dt*/, double /*temperature*/) {}
  };
  /// Whether the law has a use for Specific Heat in scenes without heat.
  static constexpr bool warms = false;
  /// Why the law can't be used in a scene with heat; null where it can.
  static const char* refusesHeat(const Properties&) { return nullptr; }
  /// Stress in tension at which the material first flows; 0 where that is not known [Pa].
  static double firstYield(const Properties&) { return 0.0; }
  /// Multiplies those of `own` that are shear moduli, for materials that are `Entropic`.
  static void scaleShear(Properties&, double /*factor*/) {}
};

} // namespace Rhegma
