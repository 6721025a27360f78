#include "program/CheckText.hpp"

#include "base/Counted.hpp"
#include "base/MemoryNeed.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "plan/Axis.hpp"
#include "plan/EffectSchema.hpp"
#include "plan/KnownEffects.hpp"
#include "plausibility/LoadEstimate.hpp"
#include "scene/Compatibility.hpp"
#include "scene/SceneBodies.hpp"
#include "scene/SceneError.hpp"
#include "scene/TimeFunction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace Rhegma::program
{

namespace
{

/// Four digits, with the largest unit that leaves at least 1 before the point.
std::string inUnits(double value, const std::vector<std::pair<double, const char*>>& units)
{
  char text[40];
  for (const auto& [size, name] : units)
    if (value >= size || size == units.back().first)
    {
      std::snprintf(text, sizeof text, "%.4g %s", value / size, name);
      return text;
    }
  return {};
}

std::string forceText(double force)
{
  return inUnits(force, {{1e9, "GN"}, {1e6, "MN"}, {1e3, "kN"}, {1.0, "N"}, {1e-3, "mN"}, {1e-6, "uN"}});
}

std::string areaText(double area)
{
  return inUnits(area, {{1.0, "m2"}, {1e-4, "cm2"}, {1e-6, "mm2"}, {1e-12, "um2"}});
}

/// "4 kN along (0, -1)".
template <int D>
std::string resultantText(const Vector<D>& force)
{
  std::string text = forceText(norm(force)) + " along (";
  for (int d = 0; d < D; ++d)
  {
    const double part = std::round(1e3 * force[d] / norm(force)) / 1e3;
    text += (d > 0 ? ", " : "") + formatReal(part + 0.0); // no negative zero
  }
  return text + ")";
}

/// The factor of a load that counts most: at the end of a Static analysis or one with a load factor, else the
/// largest of the run, by its size.
double factorOf(const std::string& history, const Teuchos::ParameterList& time)
{
  constexpr int samples = 256;
  const double end = time.get<double>("Final Time");
  const TimeFunction function = TimeFunction::parse(history);
  double most = function(end);
  for (int k = 0; k < samples && time.get<std::string>("Analysis") != "Static"; ++k)
    if (const double factor = function(end * k / samples); std::fabs(factor) > std::fabs(most))
      most = factor;
  return most;
}

template <int D>
std::string loadsOf(const Teuchos::ParameterList& scene)
{
  if (!scene.isSublist("Boundaries"))
    return {};
  const Teuchos::ParameterList& section = scene.sublist("Boundaries");
  std::string text;
  std::size_t count = 0, surfaces = 0;
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const Vector<D> force = forceOf<D>(scene, list);
    if (const double area = chosenArea<D>(scene, list); area > 0.0 && surfaces++ < bodiesInText)
      text += "  Boundaries > " + name + ": on " + areaText(area) + " of the surface of Bodies > " +
              list.get<std::string>("Body") + "\n";
    const double factor =
        norm(force) > 0.0 ? factorOf(list.get<std::string>("History"), scene.sublist("Time")) : 0.0;
    if (std::isfinite(factor * norm(force)) && std::fabs(factor) * norm(force) > 0.0 &&
        ++count <= bodiesInText)
      text += "  Boundaries > " + name + ": " + resultantText<D>(factor * force) +
              (list.get<std::string>("History") == "1" ? "\n" : " at most\n");
  }
  return text + (count > bodiesInText
                     ? "  and " + counted(static_cast<long>(count - bodiesInText), "more load") + "\n"
                     : std::string());
}

} // namespace

std::string loadsAsText(const Teuchos::ParameterList& scene)
{
  return scene.sublist("Domain").get<int>("Dimension") == 2 ? loadsOf<2>(scene) : loadsOf<3>(scene);
}

std::string bodiesAsText(const nlohmann::json& summary, const Teuchos::ParameterList& scene)
{
  constexpr double g = 9.81;
  std::string text;
  const nlohmann::json& bodies = summary.at("bodies");
  const std::size_t shown = std::min(bodies.size(), bodiesInText);
  for (std::size_t k = 0; k < shown; ++k)
  {
    const double mass = bodies[k].at("mass");
    text += "  Bodies > " + bodies[k].at("name").get<std::string>() + ": mass " +
            inUnits(mass, {{1e6, "kt"}, {1e3, "t"}, {1.0, "kg"}, {1e-3, "g"}, {1e-6, "mg"}, {1e-9, "ug"}}) +
            ", weight " + forceText(g * mass) + "\n";
  }
  const Teuchos::ParameterList& domain = scene.sublist("Domain");
  if (isAxisymmetric(scene) && shown > 0)
    text += "  All forces and masses are those of the whole circle around x = 0 (Domain > Plane)\n";
  else if (domain.get<int>("Dimension") == 2 && shown > 0)
    text += "  All forces and masses are those of a thickness of " +
            readableLength(domain.get<double>("Thickness")) + " (Domain > Thickness)\n";
  const std::size_t all = sublistNames(scene.sublist("Bodies")).size();
  return text + (all > shown ? "  and " + std::to_string(all - shown) +
                                   (all - shown == 1 ? " more body\n" : " more bodies\n")
                             : "");
}

std::string cellsAsText(const nlohmann::json& summary, long particles)
{
  const double largest = summary["cells"]["largest"], smallest = summary["cells"]["smallest"];
  return counted(particles, "particle") + (summary.contains("adaptivity") ? " at the start" : "") +
         " in cells of " + readableLength(largest) +
         (smallest < largest ? ", the finest of " + readableLength(smallest) : "");
}

std::string unknownsAsText(const nlohmann::json& summary)
{
  if (!summary.contains("equilibrium"))
    return {};
  const nlohmann::json& of = summary["equilibrium"];
  // Three digits: bodies that deform touch other nodes.
  const double unknowns = of["unknowns"].get<double>();
  const double digits = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(unknowns, 1.0))) - 2.0));
  char text[96];
  std::snprintf(text, sizeof text, "; about %.0f unknowns, a matrix of %.3g MB before factorisation",
                digits * std::round(unknowns / digits), 1e-6 * of["matrix_bytes"].get<double>());
  return text;
}

std::string stepsAsText(const Simulation& simulation, const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& time = scene.sublist("Time");
  const bool equilibrium = time.get<std::string>("Analysis") != "Dynamic";
  const double step = simulation.stableTimeStep();
  const double steps =
      std::ceil((time.get<double>("Final Time") - simulation.time()) / step - (equilibrium ? 1e-6 : 0.0));
  if (!(steps >= 1.0 && steps < 1e15))
    return {};
  const double most = time.get<int>("Maximum Steps");
  if (equilibrium)
    return "; " + std::to_string(std::lround(std::min(steps, most))) +
           (std::min(steps, most) == 1.0 ? " load step" : " load steps");
  // Three digits: the step changes as bodies and cells do.
  const double digits = std::pow(10.0, std::max(0.0, std::floor(std::log10(steps)) - 2.0));
  char text[96];
  std::snprintf(text, sizeof text, "; about %.0f steps of %s to %s",
                std::min(digits * std::round(steps / digits), most), readableTime(step).c_str(),
                steps > most ? "Time > Maximum Steps" : "Time > Final Time");
  return text;
}

std::string equilibriumAsText(const Teuchos::ParameterList& scene, const Ranks& ranks)
{
  if (!declaredOptions(scene).endAtRest || ranks.many())
    return {};
  Teuchos::ParameterList other = scene;
  other.sublist("Time").set("Analysis", std::string("Static"));
  std::vector<SceneError> errors;
  checkRules(other, effectSchema(), errors);
  const auto another = [&errors](const SceneError& error) { return error.where != errors.front().where; };
  if (errors.empty() || std::any_of(errors.begin(), errors.end(), another))
    return {};
  return "  Time > Analysis = Static, without " + errors.front().where +
         ", solves for the static equilibrium directly\n";
}

std::string sizeAsText(const Teuchos::ParameterList& scene)
{
  constexpr double bytes = 1.2e3; // of a particle with its nodes and output (docs/explanation/forecasts.md)
  const double particles = estimateParticles(scene);
  // What does not fit at all is refused, with its reasons, as soon as its lattice is known.
  if (particles < manyParticles || bytes * particles > 2.0 * freeMemoryBytes())
    return {};
  char text[160];
  std::snprintf(text, sizeof text,
                "about %.2g million particles, which take some %.2g GB and a minute or more "
                "to set up\n",
                1e-6 * particles, 1e-9 * bytes * particles);
  return "Bodies: " +
         (text +
          std::string(scene.sublist("Domain").isType<std::string>("Accuracy")
                          ? "  Domain > Accuracy = " + scene.sublist("Domain").get<std::string>("Accuracy") +
                                " chooses cells of " +
                                readableLength(scene.sublist("Domain").get<double>("Cell Size")) + "\n"
                          : ""));
}

} // namespace Rhegma::program
