#pragma once
/// What became of a front of a crack that may grow, at the end of a run.

#include "propagation/FrontState.hpp"
#include "propagation/Options.hpp"
#include "state/State.hpp"

#include <string>

namespace Rhegma::propagation
{

/// What became of a front.
enum class Fate
{
  NotInitiated,
  Running,
  Growing,  ///< in equilibrium, at its toughness
  Arrested, ///< G is below the toughness everywhere
  AtRest,   ///< it is not
  Stopped,  ///< a numerical reason stopped nodes of it
  Ended
};

/// The end of a front, in numbers.
template <int D>
struct FrontEnd
{
  Fate fate = Fate::Ended;
  bool inPart = false; ///< other nodes have neither stopped nor landed
  /// Of the node that can advance and is closest to its toughness [J/m2]; 0: there is none
  double release = 0.0, toughness = 0.0;
  /// Running, but with G below the toughness everywhere and without an advance for three times the mean time
  /// between two of a front node: its speed is then only a bound.
  bool pauses = false;
  /// Pausing for so long that it would have been arrested, were G below the arrest toughness.
  bool waits = false;
  double arrest = 0.0; ///< arrest toughness of that node [J/m2]

  FrontEnd(const State<D>& state, const Options& options, const CrackFront<D>& front,
           const FrontState<D>& own);
};

/// What became of a front, for the answer.
template <int D>
std::string fateAsText(const CrackFront<D>& front, const FrontState<D>& own, const FrontEnd<D>& end);

/// The status of a front: one word, and the reason of a stop.
template <int D>
std::string statusOf(const CrackFront<D>& front, const FrontEnd<D>& end);

} // namespace Rhegma::propagation
