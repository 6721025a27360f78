#pragma once
/// The state of fronts that lasts from step to step.

#include "propagation/FrontHistory.hpp"
#include "state/State.hpp"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace Rhegma::propagation
{

/// Where a front node grows whose toughness depends on direction.
struct Aim
{
  double angle = 0.0; ///< by which it turns [rad]
  double drive =
      1.0; ///< largest G of a kink over the toughness there, over G of the straight extension over Toughness
  double weight = 0.0; ///< toughness in that direction over Toughness; 0: not known yet
};

/// Of one front node.
struct FrontNodeState
{
  FrontHistory history;        ///< of its increments
  double speedLimit = 0.0;     ///< [m/s]; 0: not known yet
  double increment = 0.0;      ///< its next advance [m]; 0: not known yet
  double straightLength = 0.0; ///< still to advance straight after a sharp kink [m]
  Aim aim;                     ///< if its toughness depends on direction
};

/// An advance of a front with one node.
template <int D>
struct PathPoint
{
  double time = 0.0;    ///< of its last increment [s]
  Vector<D> position{}; ///< after it [m]
};

/// Where a front with one node initiated, and in which directions.
template <int D>
struct PathStart
{
  Vector<D> position{};  ///< [m]
  Vector<D> direction{}; ///< of the crack that was there
  Vector<D> first{};     ///< of the first advance
};

/// The first advance of a front: of its nodes that advance in that step the one with the largest G.
struct FirstAdvance
{
  double release = 0.0;                            ///< G over the initiation toughness; 0: there is none
  double modeI = 0.0, modeII = 0.0, modeIII = 0.0; ///< stress intensities [Pa m^0.5]
  /// In motion: G had reached the toughness before the start time, and growth began with it.
  bool held = false;

  /// Takes a node into account that advances in the first step in which any does.
  void include(const FirstAdvance& node)
  {
    if (node.release > release)
      *this = node;
  }
};

/// How close a front with one node that was never initiated came to its start by the largest hoop stress.
struct HoopStart
{
  /// Load at which it starts by the largest hoop stress over that of G of a straight extension, with the
  /// stress intensities of the time of `intensity` or, once it is initiated, of that time.
  double load = 1.0;
  /// Stress intensity of the largest hoop stress over that of the toughness, sqrt(E' Gc); over the factor of
  /// the loads where they have one. 0: not known.
  double intensity = 0.0;
};

/// The largest difference of G_J in history from G by which growth in equilibrium was found.
struct ContourDifference
{
  double release = 0.0; ///< the latter [J/m2]; 0: none is known
  double ratio = 1.0;   ///< of the former to it
  double time = 0.0;    ///< [s]

  /// Takes a sample into account.
  void include(double other, double by, double now)
  {
    if (by > 0.0 && (release == 0.0 || std::fabs(other / by - 1.0) > std::fabs(ratio - 1.0)))
      *this = {by, other / by, now};
  }
};

/// Of one front: of its present nodes, by their names, and of all former ones.
template <int D>
struct FrontState
{
  std::map<int, FrontNodeState> nodes;
  long increments = 0;            ///< of all its nodes, including former ones
  double firstTime = 0.0;         ///< of the first of them [s]
  double lastTime = 0.0;          ///< and of the last [s]
  double speedLimit = 0.0;        ///< the largest of its nodes' [m/s]; 0: not known yet
  double lastSettledSpeed = 0.0;  ///< mean of the settled speeds of its last nodes [m/s]
  double earlyOfFormer = 0.0;     ///< the largest FrontHistory::early of nodes that are no more
  FirstAdvance first;             ///< of its first nodes to advance
  PathStart<D> start;             ///< of a front with one node
  HoopStart hoop;                 ///< of a front with one node
  ContourDifference contours;     ///< of a front with one node
  std::vector<PathPoint<D>> path; ///< of a front with one node

  /// Goes on as motion from a state of equilibrium, in which increments are shorter.
  void startMotion();
  /// Whether any of its nodes runs that can.
  bool running(const CrackFront<D>& front) const;
  /// Whether its nodes that run, and can, are slower than a front that may be arrested.
  bool hasAlmostStopped(const CrackFront<D>& front, double time) const;
  /// FrontHistory::arrest of the front node that was arrested closest to its toughness; zeros if none was.
  std::pair<double, double> arrest() const;
  /// Mean of the settled speeds of its nodes that have one [m/s]; 0 if none has.
  double settledSpeed() const;
  /// FrontHistory::closest of the node that came closest.
  double closest() const;
  /// The largest FrontHistory::early of its nodes, including former ones.
  double early() const;

  /// Adds increments that a node has made. \param history of the node, with them
  void count(const FrontHistory& history, int made);

  /// Copies the state of their origins to new nodes and removes that of former ones.
  void matchNodes(const CrackFront<D>& front);

  /// Saves or loads it.
  void serialize(Archive& archive);
};

} // namespace Rhegma::propagation
