#pragma once
/// Runs that are interrupted and continued from a checkpoint, compared with uninterrupted runs.

#include "Simulation.hpp"
#include "archive/Record.hpp"

#include <string>
#include <vector>

/// What a run of some steps leaves.
struct Trace
{
  std::vector<double> times;
  std::vector<Rhegma::Simulation::Row> rows; ///< of the samples
  nlohmann::json report;
  Rhegma::Record state; ///< a checkpoint of the end, without seconds by the clock
};

/// A simulation of a list, not initialised.
Rhegma::Simulation simulationOf(const Teuchos::ParameterList& scene);

/// Takes steps up to a number of them, with a sample every seventh or so, which are added to the trace.
void runTo(Rhegma::Simulation& simulation, long steps, double interval, Trace& trace);

/// State after `steps` uninterrupted steps.
Trace unbroken(const Teuchos::ParameterList& scene, long steps);

/// The same if the run stops after `broken` steps and another one continues from its checkpoint.
Trace continued(const Teuchos::ParameterList& scene, long broken, long steps);

/// A checkpoint after some steps, with what they left where that is asked for; and what a run that goes on
/// from a record does up to `steps`.
Rhegma::Record recordAfter(const Teuchos::ParameterList& scene, long steps, Trace* left = nullptr);
Trace continuedFrom(const Teuchos::ParameterList& scene, const Rhegma::Record& record, long steps);

/// The first difference of two traces as text, exact in every digit; empty where there is none.
std::string difference(const Trace& a, const Trace& b);
