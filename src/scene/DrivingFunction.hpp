#pragma once
/// The functions of time that drive a run.

#include "scene/Schema.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// A function of time that drives a run: the history of a load or support, a pressure, a temperature, a
/// source.
struct DrivingFunction
{
  std::string where;   ///< path of the parameter in the scene
  std::string text;    ///< as TimeFunction::parse reads it
  bool ofRate = false; ///< what drives the run is its integral, as the displacement of a prescribed velocity
};

/// All parameters of a scene that are functions of time, also those of effects, by their schema; without
/// those that scale values which are zero. \param scene validated, with its defaults
std::vector<DrivingFunction> drivingFunctions(const Teuchos::ParameterList& scene, const SceneSchema& schema);

/// A noticeable change of a function, as a fraction of its largest absolute value.
constexpr double noticeableChange = 1e-3;

/// How long functions of time change in a run. Looked at are 4097 times from its start to its end and all
/// corners of tables.
class Changes
{
public:
  /// \param end of the run [s]
  Changes(const std::vector<DrivingFunction>& functions, double end);

  /// The last time at which a function that settles before the end of the run changes noticeably [s];
  /// 0: none does.
  double last() const { return last_; }

  /// The function that still changes most after a time.
  struct Change
  {
    double fraction = 0.0; ///< largest change up to the end of the run, of its largest absolute value
    std::string where;     ///< path in the scene
    bool ofRate = false;   ///< it is the change of an integral
  };
  /// \param time [s]
  Change after(double time) const;

private:
  struct Series
  {
    std::string where;
    bool ofRate;
    std::vector<double> times, values; ///< [s], fractions of the largest absolute value
  };
  std::vector<Series> all_;
  double last_ = 0.0;
};

} // namespace Rhegma
