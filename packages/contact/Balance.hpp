#pragma once
/// Energy conservation of a run, sample by sample.

#include "state/State.hpp"

namespace Rhegma
{
class Archive;
}

namespace Rhegma::contact
{

/// Energy in the body against energy put in.
///
/// Velocities and stresses of an explicit step belong to times half a step apart, so that the sum of their
/// energies oscillates by the fraction w dt / 2 for motion of the frequency w: by percents after an impact,
/// without any loss. What the step conserves is v_before . v_after m / 2 plus the strain energy of the forces
/// between the two (the leapfrog's own invariant: Hairer, Lubich and Wanner, Acta Numerica 12 (2003) 399);
/// that is what is measured here, from the nodes' momentum and acceleration. Where nodes move in substeps,
/// v_after is that after the impulses at the start of the step.
template <int D>
class Balance
{
public:
  /// Call when a step begins.
  void begin(const State<D>& state);

  /// Call after the solve of a step that is sampled. \param stored energy of contact then [J]
  void measure(const State<D>& state, double stored);

  /// Call at the end of a step that is sampled. \param lost energy [J] known to be dissipated
  void compare(const State<D>& state, double lost);

  void serialize(Archive& archive);

  /// Smallest, largest and last energy found, where the largest energy ever put in stands for 1.
  double smallestFraction() const { return relative(smallest_); }
  double largestFraction() const { return relative(largest_); }
  double lastFraction() const { return relative(last_); }

private:
  double relative(double excess) const { return scale_ > 0.0 ? 1.0 + excess / scale_ : 1.0; }

  double workBefore_ = 0.0;
  double found_ = 0.0;
  double smallest_ = 0.0, largest_ = 0.0, last_ = 0.0; ///< found less put in [J]
  double scale_ = 0.0;                                 ///< largest energy put in [J]
};

} // namespace Rhegma::contact
