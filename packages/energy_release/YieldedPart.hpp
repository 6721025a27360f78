#pragma once
/// Where a linear law does not see that its material yields.

#include "energy_release/FrontSample.hpp"
#include "energy_release/ToughnessReached.hpp"
#include "state/State.hpp"

#include <nlohmann/json.hpp>
#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::energy_release
{

/// What of a body yields, as far as it is clear of fronts.
template <int D>
struct YieldedPart
{
  double volume = 0.0;  ///< of particles with a stress above the yield stress [m3]
  double all = 0.0;     ///< of the whole body [m3]
  double largest = 0.0; ///< von Mises stress [Pa]
  Vector<D> at{};       ///< where that is [m]
};

/// The sample of a run in which most of a body yielded, or came closest to it.
template <int D>
struct YieldRecord
{
  YieldedPart<D> part;
  double time = 0.0;   ///< [s]
  double factor = 1.0; ///< on the loads, in an analysis by load factor
};

/// Of each body with a linear law and a known yield stress.
template <int D>
class YieldRecords
{
public:
  /// Takes the present state into account. Collective.
  void sample(const State<D>& state, const std::vector<FrontSample<D>>& samples);
  const std::vector<YieldRecord<D>>& all() const { return records_; }
  void serialize(Archive& archive);

private:
  std::vector<YieldRecord<D>> records_; ///< of each body; empty where none has a yield stress
};

/// For each body with a linear law and a known yield stress, the largest von Mises stress as an answer, or as
/// a warning where more than a thousandth of the body has more than the yield stress. Particles within the
/// contours of the fronts are left out: there the stress of any crack is singular. A sample of the run in
/// which more of the body yielded than at its end is warned of in its place. Collective. \param start at
/// which stresses are judged \param records of the run so far
template <int D>
void reportYield(const State<D>& state, const std::vector<FrontSample<D>>& samples,
                 const ToughnessReached::Factors& start, const YieldRecords<D>& records,
                 nlohmann::json& summary);

} // namespace Rhegma::energy_release
