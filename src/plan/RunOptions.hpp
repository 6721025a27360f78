#pragma once
/// Options that effects exchange. Each value is set by the effect that owns it, before any effect is made
/// (EffectEntry::declare), so that no effect reads the section of another.

#include "scene/DrivingFunction.hpp"
#include "state/CrackSet.hpp"

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace Rhegma
{

/// The nodal mass that a scene chooses.
struct NodalMass
{
  double lumpedFraction = 1.0; ///< of (1 - f) M + f diag(M 1)
  double smallestNode = 0.0; ///< particles that touch a lighter node stay lumped, in fractions of a full cell
  int terms = 0;             ///< of the series about the row sums that stands for the inverse; 0: solved
  /// M is consistent up to this distance from a front and lumped beyond the edge, each the sum of a length
  /// [m] and of cells as they are at the front.
  double radius = std::numeric_limits<double>::infinity(), radiusCells = 0.0;
  double edge = 0.0, edgeCells = 0.0;
};

/// A run that ends as soon as it is at rest.
struct EndAtRest
{
  double energyRatio = 0.0; ///< largest kinetic over strain energy at rest
  double drift = 0.0;       ///< largest relative change of the answers at rest
  double massRate = 0.0;    ///< of mass-proportional damping [1/s]; may be 0
  double notBefore = 0.0;   ///< the last change of loads that settle [s]
};

/// Defaults: values of a scene without effects.
struct RunOptions
{
  bool mechanics = true; ///< false: nothing moves
  /// [K]; none without heat.
  std::optional<double> initialTemperature;
  bool heat() const { return initialTemperature.has_value(); }
  bool fieldsConduct = true; ///< heat, if any, can pass between the two fields of a node

  bool adaptive = false; ///< cells change
  int frontLevels = 0;   ///< levels of finer cells at crack fronts

  bool openingKnown = true;     ///< stencils at cracks have linear completeness
  bool extrapolated = false;    ///< they extrapolate from nodes on one side
  bool bodiesKeptApart = false; ///< bodies that are not bonded have a motion of their own at common nodes
  bool toolsPress = false;      ///< rigid tools press on bodies
  bool contact = false;         ///< faces that close press against each other
  std::set<std::string> pressedCracks; ///< with a given pressure
  /// These pressures as functions of time [Pa], by their paths in the scene.
  std::map<std::string, std::string> facePressures;
  bool burning = false; ///< faces burn, and their gas presses on them
  bool growth = false;  ///< cracks may grow
  /// Energy release rate at which fronts that may grow initiate [J/m2]; none where there are none, or where
  /// it depends on temperature.
  std::optional<double> initiationToughness;
  double growthFrom = 0.0;  ///< time before which no crack grows [s]
  bool loadFactor = false;  ///< in equilibrium, under loads whose factor is found from their growth
  DrivingContours contours; ///< contours for the driving forces of growing cracks, given in 2D
  NodalMass nodalMass;
  /// What drives the run as functions of time. Effects declare what no parameter that is such a function
  /// says; those parameters follow where a run ends at rest.
  std::vector<DrivingFunction> driving;
  std::optional<EndAtRest> endAtRest; ///< none: at Time > Final Time

  /// Of the motion that starts in this equilibrium (Time > Initial State); null: no such motion follows. Its
  /// scene has sections that the equilibrium's has not.
  std::shared_ptr<const RunOptions> motion;
  /// Options of the motion that this run is or starts, else those of the equilibrium.
  const RunOptions& ofMotion() const { return motion ? *motion : *this; }
};

/// The motion that starts in an equilibrium.
struct MotionToCome
{
  std::shared_ptr<const RunOptions> options;
  double step = 0.0;       ///< its first stable one, of nodes that take the whole step [s]
  int subcycledLevels = 0; ///< number of the deepest levels that take substeps
};

} // namespace Rhegma
