#pragma once
/// What steps, samples and snapshots of a scene cost on this machine, measured on its own first steps.

#include "Simulation.hpp"
#include "parallel/Ranks.hpp"
#include "program/CoarseRun.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace Rhegma::program
{

/// Times are those of the first thread's processor: what they are by the clock where a machine has no other
/// work.
struct StepRates
{
  double setup = 0.0;           ///< from the program's start to the first step [s]
  double spent = 0.0;           ///< by all steps that were taken [s]
  double step = 0.0;            ///< mean of the second half of them [s]
  double sample = 0.0;          ///< a row of the history [s]
  double frame = 0.0;           ///< a snapshot of the fields [s]
  double frameBytes = 0.0;      ///< the size of its files
  double checkpoint = 0.0;      ///< a checkpoint, by the clock: it waits for the disk [s]
  double checkpointBytes = 0.0; ///< the size of its file
  double memory = 0.0;          ///< largest of the program, of all ranks together [bytes]
  double timeStep = 0.0;        ///< mean of the second half of the steps that were taken [s]
  double time = 0.0;            ///< simulated by all of them [s]
  double busy = 1.0;            ///< time by the clock over that of the processor, while it was measured
  int particles = 0;            ///< that the scene begins with
  int steps = 0;                ///< that were taken; of an analysis of equilibrium load steps
  Growth growth;                ///< from the second half of them to the rest of the run, where cells change
  int unknowns = 0;             ///< of the linear systems of an equilibrium; 0: the analysis is dynamic
  double solves = 0.0;          ///< linear systems of a load step, mean
  double solve = 0.0;           ///< of one of them [s]
  double incrementSolves = 0.0; ///< more of them for each increment of a front; 0: counted in `solves`
  long long measured = 0;       ///< when, in seconds since 1970
  std::string failure;          ///< why the scene could not go on; empty if it could
};

/// Takes the first steps of a simulation that is made for this alone, and some with samples. Writes a
/// snapshot, and a checkpoint where the run writes some (writesCheckpoints), in a folder that is removed
/// again. Of a scene whose cells change, one with larger cells is run too. Of an equilibrium one linear
/// system is solved; load steps are taken only where that is soon done. Collective. \param scene validated
/// \param seconds of the processor that this may take, about, as long again for the larger cells, and no more
/// than four times as many by the clock; one step, one sample and one snapshot are taken in any case
StepRates measureRates(Simulation& simulation, const Teuchos::ParameterList& scene, const Ranks& ranks,
                       double seconds);

} // namespace Rhegma::program
