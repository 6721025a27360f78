#pragma once
/// Implementation of Simulation for a dimension.

#include "Simulation.hpp"

#include "archive/Record.hpp"
#include "parallel/Ranks.hpp"

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma
{

/// A valid checkpoint from which this simulation can't continue; the message follows the name of the file.
class CheckpointMisfit : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class Simulation::Engine
{
public:
  explicit Engine(const Ranks& ranks) : ranks_(ranks) {}
  virtual ~Engine() = default;

  /// For the dimension of a validated scene, which is shared and must not change afterwards.
  static std::unique_ptr<Engine> make(const Teuchos::RCP<Teuchos::ParameterList>& scene, const Ranks& ranks);

  const Ranks& ranks() const { return ranks_; }
  virtual void initialize() = 0;
  virtual double stableTimeStep() const = 0;
  virtual double stepFraction() const = 0;
  virtual void advance(double until) = 0;
  virtual bool trySolve(bool onlyLoads) = 0;
  virtual nlohmann::json report(std::size_t mostBodies) const = 0;
  virtual std::string plan() const = 0;
  virtual std::map<std::string, double> stageSeconds() const = 0;
  virtual void writeFields(const std::string& folder) = 0;
  /// \return why the fields can't be continued; empty: they can, or there were none
  virtual std::string continueFields(const std::string& folder) = 0;
  virtual void writeFronts(const std::string& folder) = 0;
  /// \return as continueFields(), of the values along fronts
  virtual std::string continueFronts(const std::string& folder) = 0;
  virtual std::vector<std::string> effects() const = 0;
  virtual void syncFields() const = 0;
  virtual bool sound() const = 0;
  virtual double wallSeconds() const = 0;
  virtual const FieldTable& particles() const = 0;
  virtual void giveHeat(const std::vector<double>& joules) = 0;
  virtual Record save(const Notes& notes) = 0;
  virtual Notes load(const Record& record) = 0;
  virtual Notes goBack() = 0;

  struct Progress
  {
    double time = 0.0;
    long steps = 0;
    bool settled = false;
    bool ended = false;
    int particles = 0;
    double particleSteps = 0.0;
  };
  virtual Progress progress() const = 0;

  double interval = 0.0;
  std::function<void(double, const Row&)> observer;
  std::function<void(double, long)> afterStep;
  std::function<void(int, double)> onIteration;
  bool sampleNext =
      false; ///< the next step ends with a sample, which the observer does not get unless it is due
  bool sampled = false; ///< the last step ended with a sample
  Row last;
  Record held;
  double heldTime = -1.0; ///< negative: nothing is held

  /// Only the first rank keeps the copy; the others need it only when the run goes back.
  void keepOnFirst()
  {
    if (ranks_.rank() > 0)
      held.clear();
  }

private:
  Ranks ranks_;
};

} // namespace Rhegma
