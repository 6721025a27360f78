#include "propagation/Options.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "material/LawStiffness.hpp"
#include "material/RayleighSpeed.hpp"
#include "material/StartOfGrowth.hpp"
#include "plan/LastStage.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace Rhegma::propagation
{

namespace
{

/// Cells that a Rayleigh wave travels between two evaluations of G.
constexpr double usualSampling = 0.5;

/// Increment of each kind of analysis [cells].
constexpr double usualWhileRunning = 1.0, usualAtRest = 0.25;

void refuseContour(const Teuchos::ParameterList& list, const std::string& name,
                   std::vector<SceneError>& errors)
{
  if (!list.isType<Teuchos::Array<double>>(name))
    return;
  const auto& radii = list.get<Teuchos::Array<double>>(name);
  if (radii.size() == 2 && !(radii[0] >= 1.0 && radii[1] >= radii[0] + 1.0))
    errors.push_back(
        {"Propagation > " + name,
         "the radii must be at least 1 and a cell apart, the inner one first; write such as {5, 10}"});
}

} // namespace

void checkPropagation(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  const Teuchos::ParameterList& list = scene.sublist("Propagation");
  refuseContour(list, "Release Contour", errors);
  refuseContour(list, "Direction Contour", errors);
  if (list.isType<std::string>("Toughness"))
    try
    {
      Toughness::parse(list.get<std::string>("Toughness"), true);
    }
    catch (const std::invalid_argument& error)
    {
      errors.push_back({"Propagation > Toughness", error.what()});
    }
  if (list.isType<std::string>("Toughness Ratio"))
    try
    {
      ToughnessRatio::parse(list.get<std::string>("Toughness Ratio"));
    }
    catch (const std::invalid_argument& error)
    {
      errors.push_back({"Propagation > Toughness Ratio", error.what()});
    }
}

namespace
{

DirectionRule readDirection(const Teuchos::ParameterList& list)
{
  const auto name = list.get<std::string>("Direction");
  return name == "Straight"                 ? DirectionRule::Straight
         : name == "Maximum Energy Release" ? DirectionRule::EnergyRelease
                                            : DirectionRule::HoopStress;
}

/// Toughness at which fronts initiate, unless it depends on temperature [J/m2].
std::optional<double> initiationToughness(const Teuchos::ParameterList& list)
{
  if (list.isParameter("Initiation Toughness"))
    return list.get<double>("Initiation Toughness");
  const std::string text = list.get<std::string>("Toughness");
  try
  {
    if (!Toughness::namesTemperature(text))
      return Toughness::parse(text)(0.0);
  }
  catch (const std::invalid_argument&) // which the checks of the scene report
  {
  }
  return std::nullopt;
}

} // namespace

void declareGrowth(const Teuchos::ParameterList& list, RunOptions& run)
{
  run.growth = true;
  if (list.isType<double>("Start Time"))
    run.growthFrom = list.get<double>("Start Time");
  run.initiationToughness = initiationToughness(list);
  run.loadFactor =
      list.isType<std::string>("Load Control") && list.get<std::string>("Load Control") == "Load Factor";
  if (!list.isParameter("Release Contour")) // in 3D
    return;
  const auto release = list.get<Teuchos::Array<double>>("Release Contour");
  const auto intensity = list.get<Teuchos::Array<double>>("Direction Contour");
  run.contours = {release[0], release[1], intensity[0], intensity[1]};
}

Options readOptions(const Teuchos::ParameterList& scene, const RunOptions& run)
{
  const Teuchos::ParameterList& list = scene.sublist("Propagation");
  const Toughness toughness = Toughness::parse(list.get<std::string>("Toughness"), run.heat());
  const auto orAtRest = [&](const char* name)
  { return list.isParameter(name) ? list.get<double>(name) : 0.0; };
  Options options{{toughness, orAtRest("Initiation Toughness"), orAtRest("Arrest Toughness"),
                   list.get<double>("Start Time")},
                  readDirection(list),
                  list.isParameter("Increment") ? list.get<double>("Increment")
                  : isEquilibrium(scene)        ? usualAtRest
                                                : usualWhileRunning,
                  list.isParameter("Speed Limit") ? list.get<double>("Speed Limit") : 0.0,
                  run.initialTemperature.value_or(0.0),
                  {},
                  list.isParameter("Sampling Interval") ? list.get<double>("Sampling Interval")
                                                        : usualSampling,
                  0.0,
                  isEquilibrium(scene),
                  !list.isParameter("On Stop") || list.get<std::string>("On Stop") == "Stop"};
  options.contours = run.contours;
  if (list.isType<std::string>("Toughness Ratio"))
    options.ratio = ToughnessRatio::parse(list.get<std::string>("Toughness Ratio"));
  options.criticalIntensity = list.isType<double>("K_Ic") ? list.get<double>("K_Ic") : 0.0;
  return options;
}

template <int D>
double speedLimitAt(const State<D>& state, const Vector<D>& position, const Options& options)
{
  return options.speedLimit > 0.0 ? options.speedLimit
                                  : rayleighSpeed(state.materials.properties[materialAt(state, position)]);
}

template <int D>
double fastestRayleighWave(const State<D>& state)
{
  double fastest = 0.0;
  for (const Properties& material : state.materials.properties)
    fastest = std::max(fastest, rayleighSpeed(material));
  return fastest;
}

AdvanceRule ruleAt(double temperature, const Options& options)
{
  AdvanceRule rule = options.rule;
  rule.temperature = temperature;
  const double atRest = rule.toughness(0.0, temperature);
  rule.initiation = rule.initiation > 0.0 ? rule.initiation : atRest;
  rule.arrest = rule.arrest > 0.0 ? rule.arrest : atRest;
  return rule;
}

bool isWeak(const AdvanceRule& rule, double fastest)
{
  return !(rule.toughness(0.0, rule.temperature) > 0.0 && rule.toughness(fastest, rule.temperature) > 0.0);
}

std::string failureOfWeak(double temperature)
{
  return "the toughness is not positive at the temperature of a crack front, " + formatReal(temperature) +
         " K (Propagation > Toughness)";
}

template <int D>
void refuseWeak(const State<D>& state, const Options& options)
{
  const double fastest = std::max(options.speedLimit, fastestRayleighWave(state));
  try
  {
    options.rule.toughness.refuseWeak(fastest, options.temperature);
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument(std::string("Propagation > Toughness: ") + error.what());
  }
  const AdvanceRule rule = ruleAt(options.temperature, options);
  if (options.rule.arrest > rule.initiation)
    throw std::invalid_argument("Propagation > Arrest Toughness: is " + formatReal(rule.arrest) +
                                " J/m2, above the Initiation Toughness of " + formatReal(rule.initiation) +
                                " J/m2: a front would be arrested as soon as it is initiated; write at most "
                                "that");
}

template <int D>
void refuseAnisotropic(const State<D>& state, const Options& options)
{
  for (std::size_t m = 0; m < state.materials.properties.size(); ++m)
  {
    if (!isAnisotropic(state.materials.properties[m]))
      continue;
    const std::string material = "Materials > " + state.materials.names[m] + " is anisotropic";
    if (options.direction != DirectionRule::Straight)
      throw std::invalid_argument("Propagation > Direction: " + material +
                                  ", and the rules for turning cracks are those of isotropic bodies: write "
                                  "Straight, for a crack that keeps its direction, such as along fibres");
    if (!options.equilibrium && !(options.speedLimit > 0.0))
      throw std::invalid_argument(
          "Propagation > Speed Limit: is missing, and " + material +
          ", so that the speed of Rayleigh waves depends on direction: write that in the direction of the "
          "crack (m/s), below " +
          formatShort(rayleighSpeed(state.materials.properties[m])));
  }
}

double openingRelease(const DrivingForce& driving, const ModeRelease& modes)
{
  return Rhegma::openingRelease(driving.release, driving.modeI, driving.modeII, driving.modeIII, modes);
}

template double speedLimitAt(const State<2>&, const Vector<2>&, const Options&);
template double speedLimitAt(const State<3>&, const Vector<3>&, const Options&);
template double fastestRayleighWave(const State<2>&);
template double fastestRayleighWave(const State<3>&);
template void refuseWeak(const State<2>&, const Options&);
template void refuseWeak(const State<3>&, const Options&);
template void refuseAnisotropic(const State<2>&, const Options&);
template void refuseAnisotropic(const State<3>&, const Options&);

} // namespace Rhegma::propagation
