#pragma once
/// Some particles of one material, as laws of shared libraries get them.

#include "material/LoadedLaw.hpp"

#include <array>
#include <cstring>
#include <vector>

namespace Rhegma
{

/// Numbers that are behind the constants and the state variables of a law, so that one that uses more than it
/// has changes nothing else: a law has at most so many state variables.
constexpr int lawSlack = mostStateVariables;

/// What is behind the arrays of a law in a trial.
struct LawGuard
{
  std::vector<double> constants;             ///< of the law, and lawSlack numbers behind
  std::array<double, lawSlack> states{};     ///< behind the state variables of each particle at the start
  static constexpr double canary = -7.25e77; ///< behind those at the end, where these are other arrays
  int written = 0;                           ///< out: up to which of them the law wrote

  /// \param k of the number behind the state variables \param changed whether the law has changed it
  void look(int k, bool changed)
  {
    if (changed && k >= written)
      written = k + 1;
  }
  /// \param behind the numbers behind those of a particle, which were `states`
  void look(const double* behind)
  {
    for (int k = 0; k < lawSlack; ++k)
      look(k, std::memcmp(behind + k, states.data() + k, sizeof(double)) != 0);
  }
};

/// What a law needs to know of some particles, and what it gives. An array of c numbers a particle has
/// component k of particle l at [k * count + l]. All are of a solid: in 2D the shear across the plane is
/// zero.
struct SharedLawBlock
{
  int count = 0;            ///< number of particles
  double dt = 0.0;          ///< length of the step, positive [s]
  double time = 0.0;        ///< at the end of the step [s]
  double temperature = 0.0; ///< [K]
  double density = 0.0;     ///< of the undeformed material [kg/m3]
  bool plane = false;       ///< whether the deformation is that of a 2D scene
  double length = 0.0;      ///< edge of a cell; 0 if not known [m]

  const double* constants = nullptr; ///< of the law; lawSlack numbers follow
  LawGuard* guard = nullptr;         ///< in a trial

  double* before = nullptr;   ///< deformation gradient at the start of the step, 9, row by row
  double* F = nullptr;        ///< at its end, 9
  double* position = nullptr; ///< 3, zero where it is not known [m]
  /// Cauchy stress at the start, 6: xx yy zz xy yz xz [Pa]. Of a law that is corotational, R^T sigma R.
  double* oldStress = nullptr;
  double* stress = nullptr;        ///< out: at the end, 6
  double* oldStored = nullptr;     ///< energy stored per undeformed volume at the start [J/m3]
  double* stored = nullptr;        ///< out: at the end
  double* oldDissipated = nullptr; ///< dissipated so far per undeformed volume at the start [J/m3]
  double* dissipated = nullptr;    ///< out: at the end
  double* speed = nullptr;         ///< out: wave speed where the law computes it, else zero [m/s]
  double* oldState = nullptr;      ///< numbers of the law at the start, law.numbers; lawSlack * count follow
  double* state = nullptr;         ///< out: at the end; lawSlack * count follow
  double* tau = nullptr;           ///< out: Kirchhoff stress, 6 [Pa]
  bool* failed = nullptr;          ///< out: whether the law returned no usable stress

  // Only of corotational laws: F = R U before and after the step.
  double* rotation = nullptr;   ///< R after it, 9
  double* oldStretch = nullptr; ///< U before it, 6
  double* stretch = nullptr;    ///< U after it, 6

  std::string reason; ///< out: what the law said of a failure; may be empty
};

/// Constants of a law that loadLaw has loaded, and lawSlack zeros.
const double* constantsOf(const LoadedLaw& law);

/// Memory of a thread for blocks, so that steps allocate nothing.
class SharedLawMemory
{
public:
  /// A block of `count` particles of a law; its arrays are valid until the next call. Deformation gradients
  /// and positions are zero.
  SharedLawBlock block(const LoadedLaw& law, int count);
  /// Further arrays for a call of the law: `numbers` numbers, valid until the next call.
  double* scratch(std::size_t numbers);

  /// That of the calling thread.
  static SharedLawMemory& own();

private:
  std::vector<double> numbers_, scratch_;
  std::vector<unsigned char> flags_;
};

/// Stress, energies and state of the particles of a block after its step. In plane stress it first finds the
/// thickness stretch, F[8] of the block, which holds a first guess. `failed` is set where the law returned a
/// stress, an energy or a state that is not finite, where it asked for a smaller step, or F is inverted.
void evaluateSharedLaw(const LoadedLaw& law, const Properties& m, SharedLawBlock& block);

/// Results where nothing moves: stress, energies and state are those of the start.
void restOfSharedLaw(const LoadedLaw& law, SharedLawBlock& block);

/// tau from the stress of a block.
void kirchhoffStress(const LoadedLaw& law, SharedLawBlock& block);

} // namespace Rhegma
