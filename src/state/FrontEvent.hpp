#pragma once
/// What ends the growth of fronts.

#include "base/Types.hpp"

#include <string>

namespace Rhegma
{

class Archive;

/// What ended the growth of a front, or of nodes of it.
template <int D>
struct FrontEvent
{
  std::string what;     ///< "reached the surface of its body"; of a stop its reason alone; empty: nothing did
  double time = 0.0;    ///< [s]
  Vector<D> position{}; ///< [m]
  double release = 0.0; ///< of a stop: energy release rate that was to advance the front [J/m2]
  double toughness = 0.0; ///< that it had reached [J/m2]
  bool lost = false;      ///< whether the energy release rate is not known: it is then the last one that was

  bool happened() const { return !what.empty(); } ///< whether there was one

  /// Such as "less than three cells from crack A, G = 342 J/m2 for Gc = 8 J/m2, at t = 1 us, at 0, 1 m".
  std::string asText() const;

  /// Saves or loads it.
  void serialize(Archive& archive);
};

} // namespace Rhegma
