#pragma once
/// Rhegma inside an application.

#include "base/ParticleCopy.hpp"
#include "base/RunError.hpp"

#include <Teuchos_Comm.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// A simulation that an application owns and advances.
///
/// The application initialises MPI and Kokkos before and finalises them after. The simulation never prints
/// and never exits: it throws std::invalid_argument for a wrong scene (one message per line) and
/// Rhegma::RunError when the run can't go on.
class Simulation
{
public:
  /// A sample: names and values, as a row of history.csv.
  using Row = std::vector<std::pair<std::string, double>>;

  /// Reads, validates and completes the scene in a file, with its units: `unit="mm"`, which
  /// Teuchos::getParametersFromXmlFile ignores without a message, so that it reads 2 mm as 2 m.
  ///
  /// \param file      path of the XML file
  /// \param overrides "Section:Sub:Parameter=value", as of the option --set
  /// \return the scene, all numbers in SI units
  static Teuchos::RCP<Teuchos::ParameterList> readScene(const std::string& file,
                                                        const std::vector<std::string>& overrides = {});

  /// \param comm  ranks of the run; with several, every call below is collective
  /// \param scene the list `Rhegma` of a scene; validated and completed with defaults here
  /// \param validated whether readScene has done that, and the scene has not changed since; it is then shared
  /// and must not change while this exists. Without it, it is copied
  Simulation(Teuchos::RCP<const Teuchos::Comm<int>> comm, const Teuchos::RCP<Teuchos::ParameterList>& scene,
             bool validated = false);
  /// Frees all; what advance() has done is lost unless it was written.
  ~Simulation();
  /// The source can only be destroyed or assigned to.
  Simulation(Simulation&&) noexcept;
  /// As the move constructor.
  Simulation& operator=(Simulation&&) noexcept;

  /// Makes the particles and the plan. Call once, before all functions below.
  void initialize();

  /// Data that an application stores with the state, by its own names.
  using Notes = std::map<std::string, std::string>;

  /// Writes the state as it is now to an HDF5 file (checkpoint/CheckpointFile.hpp): under another name first,
  /// so that either the older file or the complete new one exists. Do not call within a step; call-backs of
  /// sampleEvery and onStep may call it. Throws std::runtime_error when it can't be written.
  void checkpoint(const std::string& path, const Notes& notes = {});

  /// Replaces initialize(), or returns to an earlier state: makes the particles and the plan and loads the
  /// state of a checkpoint. The run continues as if it had not stopped, with one thread to the same digits.
  ///
  /// The scene must be that of the checkpoint except for parameters that may change (see --describe). Throws
  /// std::invalid_argument for a file that is no checkpoint, is damaged or belongs to another scene; this
  /// simulation then does not change. \return the notes of the checkpoint
  Notes restore(const std::string& path);

  /// Stores a copy of the current state in memory; it replaces an earlier copy.
  void hold(const Notes& notes = {});
  /// Whether a copy is stored.
  bool holds() const;
  /// Time of the copy [s]; negative without one.
  double heldTime() const;
  /// Returns to the copy, which stays stored, and halves the length of the following steps. Call after a step
  /// has thrown RunError. Collective. \return the notes of the copy
  Notes goBack();
  /// Writes the copy as checkpoint() writes the state.
  void checkpointHeld(const std::string& path) const;

  /// Whether, up to the last sample, the run has created no energy: a state worth storing.
  bool sound() const;

  /// Fraction of the stable step that is used: 1, or less after goBack().
  double stepFraction() const;

  /// The stable time step of the current state times that fraction [s].
  double stableTimeStep() const;

  /// Runs to a time [s] in stable steps, or to an earlier end of the run (`ended()`).
  void advance(double time);

  /// Of an analysis of equilibrium: solves the first linear system of the next load step, which is not taken,
  /// to learn what that costs. Throws RunError.
  /// \param onlyLoads solves nothing, and only adds a warning to the report if loads on free bodies do not
  /// balance \return whether the analysis is one of equilibrium
  bool trySolve(bool onlyLoads = false);

  /// Makes advance() sample at the end of each interval and call `observer` with the row. Without it there
  /// are no samples. \param interval time between samples [s] \param observer gets the time [s] and the row
  void sampleEvery(double interval, std::function<void(double time, const Row&)> observer);

  /// Makes advance() call `progress` after each step. \param progress gets the time [s] and the number of
  /// steps
  void onStep(std::function<void(double time, long step)> progress);

  /// Makes advance() call `progress` within load steps of equilibrium, before each iteration of Newton's
  /// method. \param progress gets the number of the iteration, from 0 for each solution, and the residual as
  /// a fraction of the forces
  void onIteration(std::function<void(int iteration, double residual)> progress);

  /// Makes the next step end with a sample, from which observe() and report() answer; the observer of
  /// sampleEvery() gets it only where its interval has passed. Collective. \return false: the last step was
  /// sampled, and nothing is to do
  bool sampleNextStep();

  /// The last sample.
  const Row& observe() const;

  /// Names of the fields that the particles of this scene have.
  std::vector<std::string> particleFields() const;

  /// A copy of a field of the particles of this rank; the same row of all fields belongs to the same
  /// particle. Order and number may change with every step. Not collective.
  ///
  /// Throws std::invalid_argument, which lists the existing fields, where no field has this name.
  ParticleCopy particleField(const std::string& name) const;

  /// Adds heat to the particles of this rank between steps, at constant strain; it is recorded as `heat` of
  /// the energy balance. The internal energy rises by as much, the temperature by heat over capacity.
  ///
  /// \param joules of each particle, in the order of particleField() [J]; negative: removed Throws
  /// std::invalid_argument, and changes nothing, where the scene has no section Thermal, where the number of
  /// values is not that of the particles, or where one is not finite or would cool its particle to zero
  /// kelvin. Not collective.
  void giveHeat(const std::vector<double>& joules);

  /// Simulated time [s].
  double time() const;
  /// Number of steps of the run, those before a restart included.
  long steps() const;
  /// Whether the run is at rest, by Damping > Settled Energy Ratio and Settled Drift.
  bool settled() const;
  /// Whether the run ends here, before its final time: at rest with Damping > Stop When Settled, or after
  /// Time > Maximum Steps. advance() then does nothing.
  bool ended() const;
  /// Current number of particles of all ranks.
  int particles() const;
  /// Particles times steps, summed over the run.
  double particleSteps() const;
  /// Names of the effects of the scene.
  std::vector<std::string> effects() const;
  /// Effects, fields and stages as text.
  std::string plan() const;
  /// Seconds spent in each stage.
  std::map<std::string, double> stageSeconds() const;
  /// Energies, momentum, bodies, cracks and the reports of effects, as in summary.json. What samples measure
  /// (kinetic and strain energy, momentum, forces of supports and loads, G and K of fronts) is of the last
  /// sample, and after steps without one not a number: use sampleEvery().
  /// \param mostBodies that are in it: the first ones
  nlohmann::json report(std::size_t mostBodies = std::numeric_limits<std::size_t>::max()) const;
  /// Writes the current fields; the first call makes the files fields.h5 and fields.xdmf in the folder, or
  /// continues them after restore(); a call with another folder makes files there. Throws OutputError when
  /// they can't be written; the first call after restore() also where fields.h5 exists and is damaged or of
  /// another run: later calls, or continueFields() before it, replace it.
  void writeFields(const std::string& folder);
  /// After restore(): continues fields.h5 and fields.xdmf in the folder, and removes times later than the
  /// checkpoint; if the checkpoint had no fields, the files will be made anew. \return false where the files
  /// are missing, damaged or can't be read: they will be made anew too
  /// \param folder of the output
  /// \param why is set to the reason, with the frames that are damaged or missing
  bool continueFields(const std::string& folder, std::string* why = nullptr);
  /// Writes G, K and speed at the nodes of crack fronts in 3D, as last sampled, to fronts.h5 and fronts.csv
  /// in the folder. Does nothing where the last step was not sampled or no such front is measured. Errors as
  /// of writeFields().
  void writeFronts(const std::string& folder);
  /// The same as continueFields() for fronts.h5 and fronts.csv.
  bool continueFronts(const std::string& folder, std::string* why = nullptr);
  /// Wall time since construction plus that of the restored run [s].
  double wallSeconds() const;

private:
  class Engine;
  template <int D>
  class EngineOf;
  std::unique_ptr<Engine> engine_;
};

} // namespace Rhegma
