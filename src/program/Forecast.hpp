#pragma once
/// What a scene will cost on this machine, before it runs.

#include "Simulation.hpp"
#include "parallel/Ranks.hpp"
#include "program/Options.hpp"
#include "program/StepRates.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <string>

namespace Rhegma::program
{

struct Forecast
{
  StepRates rates;
  bool kept = false;          ///< rates are those of an earlier measurement
  double steps = 0.0;         ///< to the end; of an analysis of equilibrium load steps
  double solves = 0.0;        ///< linear systems to the end, of an analysis of equilibrium
  double seconds = 0.0;       ///< to the end, on a machine without other work [s]
  double secondsToRest = 0.0; ///< to where damping has the run settle and end; 0: it does not [s]
  double bytes = 0.0;         ///< of files of fields
  double checkpoints = 0.0;   ///< written to the end; each replaces the one before
};

/// Checkpoints that a run writes in a part of it: at each Output > Checkpoint Interval and at its end, and by
/// Checkpoint Minutes; at most one a step. \param from, to of the part [s] \param seconds that it takes by
/// the clock
double checkpointsOf(const Teuchos::ParameterList& scene, double from, double to, double steps,
                     double seconds);

/// Cost of a run from the rates of its steps. \param time reached so far [s] \param slowest angular frequency
/// of the slowest motion that damping must bring to rest [1/s]; 0: unknown
Forecast forecastOf(const StepRates& rates, const Teuchos::ParameterList& scene, double time,
                    double slowest = 0.0);

/// Measures the rates on the simulation's own steps, or takes those that are kept for this scene and this
/// machine. Collective. \param simulation made for this alone: it is advanced \param scene validated
/// \param setup processor time from the start of a program that runs this scene to its first step [s]
Forecast makeForecast(Simulation& simulation, const Teuchos::ParameterList& scene, const Ranks& ranks,
                      double setup);

/// One line, without its end.
std::string asText(const Forecast& forecast);

/// For a scene that leaves its cells to Domain > Accuracy: prints what it costs, and what 3 % and 10 % would;
/// a line each, once it is known. None where it does not, or where the cost can't be found. Collective.
/// \param scene validated \param own forecast of the scene as it is, or null: it is made
/// \param start processor time that the program took before it read the scene [s]
void printCostOfAccuracy(const Options& options, const Teuchos::ParameterList& scene, const Ranks& ranks,
                         const Forecast* own, double start, std::ostream& out);

} // namespace Rhegma::program
