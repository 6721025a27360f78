#pragma once
/// Rhegma inside an application.

#include "base/ParticleCopy.hpp"
#include "base/RunError.hpp"

#include <Teuchos_Comm.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <functional>
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
/// and never exits: it throws std::invalid_argument for a wrong scene (one sentence, or one a line where
/// there are several) and Rhegma::RunError when the run can't go on.
class Simulation
{
public:
  /// A sample: names and values, as a row of history.csv.
  using Row = std::vector<std::pair<std::string, double>>;

  /// \param comm  ranks that take part; every call below is then collective
  /// \param scene the list `Rhegma` of a scene; validated and completed with defaults here
  Simulation(Teuchos::RCP<const Teuchos::Comm<int>> comm, const Teuchos::RCP<Teuchos::ParameterList>& scene);
  /// Frees all; what advance() has done is lost unless it was written.
  ~Simulation();
  /// The one moved from can only be destroyed or assigned to.
  Simulation(Simulation&&) noexcept;
  /// The same by assignment.
  Simulation& operator=(Simulation&&) noexcept;

  /// Makes the particles and the plan. Call once, before all that follows.
  void initialize();

  /// What an application wants kept next to the state, by names of its own.
  using Notes = std::map<std::string, std::string>;

  /// Writes the state as it is now to an HDF5 file (checkpoint/CheckpointFile.hpp): under another name first,
  /// so that there is the older file or the whole new one. Not to be called within a step; a call-back of
  /// sampleEvery or onStep may. Throws std::runtime_error when it can't be written.
  void checkpoint(const std::string& path, const Notes& notes = {});

  /// Takes the place of initialize(), or goes back later: makes the particles and the plan and puts the state
  /// of a checkpoint in place. The run goes on as if it had never stopped, on one thread with the same
  /// digits.
  ///
  /// The scene must be the one of the checkpoint but for what may change (--describe says which parameters).
  /// Throws std::invalid_argument, with one sentence, for a file that is no checkpoint, is damaged or belongs
  /// to another scene; this simulation then is as it was. \return the notes of the checkpoint
  Notes restore(const std::string& path);

  /// Keeps a copy of the state as it is now in memory, in place of an earlier one.
  void hold(const Notes& notes = {});
  /// Whether there is a copy.
  bool holds() const;
  /// Its time [s]; negative where there is none.
  double heldTime() const;
  /// Goes back to the copy, which stays, and on from there with steps of half the length that they have now.
  /// Belongs where a step has thrown RunError. Collective. \return the notes of the copy
  Notes goBack();
  /// Writes the copy as checkpoint() would have written the state.
  void checkpointHeld(const std::string& path) const;

  /// Whether, up to the last sample, the bodies had no energy of which nobody knows where it came from: a
  /// state worth keeping.
  bool sound() const;

  /// Fraction of the stable step that is taken: 1, or less after goBack().
  double stepFraction() const;

  /// The time step that the state allows now, times that share [s].
  double stableTimeStep() const;

  /// Runs to a time [s] in stable steps, or to where the scene has the run end (`ended()`).
  void advance(double time);

  /// Has advance() sample, in the step that ends an interval and at its end, and call `observer` with the
  /// row. \param interval time between samples [s]; none are taken before this is called \param observer gets
  /// the time [s] and the row
  void sampleEvery(double interval, std::function<void(double time, const Row&)> observer);

  /// Has advance() call `progress` after each step. \param progress gets the time [s] and the number of steps
  void onStep(std::function<void(double time, long step)> progress);

  /// The last sample.
  const Row& observe() const;

  /// Names of the fields that the particles of this scene have.
  std::vector<std::string> particleFields() const;

  /// A copy of a field of the particles that this rank has now; what all fields have in one row belongs to
  /// one particle. Order and number may change with every step. No other rank need call it.
  ///
  /// Throws std::invalid_argument, naming those that there are, where no field has the name.
  ParticleCopy particleField(const std::string& name) const;

  /// Gives heat to the particles that this rank has now, between steps: at constant strain, and recorded in
  /// the energy balance's `heat`. The particles then hold just as much more; their temperatures rise by heat
  /// over capacity.
  ///
  /// \param joules of each particle, in the order of particleField() [J]; negative: taken away
  /// Throws std::invalid_argument, and gives nothing, where the scene has no section Thermal, where there are
  /// more or fewer numbers than particles, or where one is not finite or would take its particle to zero
  /// kelvin. No other rank need call it.
  void giveHeat(const std::vector<double>& joules);

  /// Time that has been simulated [s].
  double time() const;
  /// Steps that have been taken, of all parts of the run.
  long steps() const;
  /// Whether the run is at rest, by Damping > Settled Energy Ratio and Settled Drift.
  bool settled() const;
  /// Whether the scene has the run end here, whatever time it is: at rest with Damping > Stop When Settled,
  /// or after Time > Maximum Steps. advance() then does nothing.
  bool ended() const;
  /// How many particles there are now, of all ranks.
  int particles() const;
  /// Particles times steps, summed over the steps that have been taken.
  double particleSteps() const;
  /// Names of the effects that the scene asks for.
  std::vector<std::string> effects() const;
  /// Effects, fields and stages, for a person to read.
  std::string plan() const;
  /// Seconds spent in each stage.
  std::map<std::string, double> stageSeconds() const;
  /// Energies, momentum, bodies, cracks and what else the effects report, as in summary.json.
  nlohmann::json report() const;
  /// Writes the fields as they are now; the first call makes the files fields.h5 and fields.xdmf in the
  /// folder, or goes on with them after restore().
  void writeFields(const std::string& folder);
  /// After restore(): takes up fields.h5 and fields.xdmf in the folder, without the times that they have
  /// beyond the checkpoint; where it had none, they will be made anew. \return false where they should be
  /// there and are not, or can't be read: they will be made anew too
  bool continueFields(const std::string& folder);
  /// Seconds by the clock since it was made, and those of the run before that it restored [s].
  double wallSeconds() const;

private:
  class Engine;
  template <int D>
  class EngineOf;
  std::unique_ptr<Engine> engine_;
};

} // namespace Rhegma
