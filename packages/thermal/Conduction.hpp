#pragma once
/// Steps of conduction.

#include "thermal/ConductionIntegrator.hpp"
#include "thermal/Sources.hpp"

#include <limits>

namespace Rhegma::thermal
{

/// The state of conduction that lasts from step to step.
template <int D>
struct Conduction
{
  double diffusionNumber = 0.35;
  double finalTime = std::numeric_limits<double>::infinity(); ///< of the run [s]
  double frontFraction = 0.0, frontRadius = 0.0;
  std::vector<Source<D>> sources;
  HeatBoundaries<D> boundaries;
  CrackConduction<D> faces;
  ConductionIntegrator<D> integrator;
  HeatNodes<D> nodes;
  View<double*> supply;                 ///< of each particle [W]
  double pending = 0.0;                 ///< time since the last step of conduction [s]
  int waited = 0;                       ///< steps since then
  double diffusivity = 0.0;             ///< largest of the materials [m2/s]
  double leastDiffusivity = 0.0;        ///< least of the materials that conduct [m2/s]
  bool several = false;                 ///< materials may meet, and some conduct
  bool expands = false;                 ///< temperature strains some material
  double leastCapacity = 0.0;           ///< least of the materials [J/(m3 K)]
  double fractureSeen = 0.0;            ///< fracture energy for which fronts have received heat [J]
  std::vector<double> frontHeat;        ///< of which of each front [J]
  std::vector<double> frontTemperature; ///< at the position of each front [K]
  double finestHeated = std::numeric_limits<double>::infinity(); ///< finest cells when fronts were heated [m]
  long stepsTaken = 0;                                           ///< steps of conduction
  bool warned = false;
  int cellsSeen = 0;        ///< generation of the cells on which supports were compared
  bool facesKnown = false;  ///< whether the faces' conductance is that of this step of the run
  ObservedPoints<D> fronts; ///< of cracks, then their front nodes
  StencilTable<D> frontStencils;

  /// Finds the largest diffusivity. To be called when the state's tables are there.
  void measure(const State<D>& state);

  /// The longest explicit step that conduction and surfaces allow [s].
  double explicitLimit(const State<D>& state) const;

  /// The longest step as conduction steps here [s].
  double stepLimit(const State<D>& state) const;

  /// Longest step in which sources move by half a cell at most [s].
  double sourceLimit(const State<D>& state) const;

  /// One step of the run. Conduction takes substeps where the run's step is longer than its own; where it is
  /// much shorter, conduction waits up to `longestWait` steps and then conducts for all of them at once.
  void step(State<D>& state);

  static constexpr int longestWait = 4;

  /// Steps of conduction in a step of the run, and the number from which a warning is due.
  double substeps(const State<D>& state, double dt) const;
  static constexpr double mostSubsteps = 10000.0;
  std::string tooMany(const State<D>& state, double count) const;

  /// Part of `step`; public because compilers for devices want kernels in public functions.
  void keepGradients(const State<D>& state);
  View<double* [D]> gradientBefore; ///< of the particles, before a step of conduction [K/m]

private:
  void once(State<D>& state, double dt, double begin, double end, const View<double*>& supplied);
  void solveSteady(State<D>& state);
  void reportFronts(State<D>& state);              ///< FrontHeat.cpp, as the next
  double heatOfFronts(State<D>& state, double dt); ///< \return what was added [J]
  double supplyAll(State<D>& state, double dt, double time);
};

} // namespace Rhegma::thermal
