#pragma once
/// What ends the growth of fronts.

#include "state/CrackSet.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::cracks
{

/// What ended the growth of a front, or of nodes of it.
template <int D>
struct FrontEvent
{
  std::string what;       ///< such as "reached the surface of its body"; empty: it has not happened
  double time = 0.0;      ///< [s]
  Vector<D> position{};   ///< [m]
  double release = 0.0;   ///< energy release rate that was to advance the front [J/m2]
  double toughness = 0.0; ///< that it exceeded [J/m2]

  bool happened() const { return !what.empty(); }

  /// Such as "stopped less than three cells from crack A, G = 342 J/m2 for Gc = 8 J/m2, at t = 1 us, at 0, 1
  /// m".
  std::string asText() const;

  /// Its entry in the summary of the front.
  nlohmann::json asEntry() const;

  /// Saves or loads it.
  void serialize(Archive& archive);
};

/// Its name in messages, such as "crack Notch, front 0".
template <int D>
std::string frontName(const CrackSet<D>& set, const CrackFront<D>& front)
{
  return "crack " + set.cracks[front.crack].name + ", front " + std::to_string(front.number);
}

} // namespace Rhegma::cracks
