#include "scene/CrossChecks.hpp"

#include "base/Numbers.hpp"
#include "geometry/Shape.hpp"
#include "material/MaterialTable.hpp"
#include "material/ThermoMaterials.hpp"
#include "scene/HeatWords.hpp"
#include "scene/NearestName.hpp"
#include "scene/PlaceFunction.hpp"
#include "scene/TimeFunction.hpp"
#include "scene/Validation.hpp"

#include <Teuchos_Array.hpp>

#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;
using Reals = Teuchos::Array<double>;

std::optional<double> real(const ParameterList& list, const std::string& name)
{
  return list.isType<double>(name) ? std::optional<double>(list.get<double>(name)) : std::nullopt;
}

std::string text(const ParameterList& list, const std::string& name)
{
  return list.isType<std::string>(name) ? list.get<std::string>(name) : std::string();
}

std::optional<Reals> reals(const ParameterList& list, const std::string& name)
{
  return list.isType<Reals>(name) ? std::optional<Reals>(list.get<Reals>(name)) : std::nullopt;
}

std::vector<std::string> sublists(const ParameterList& list)
{
  std::vector<std::string> names;
  for (const auto& entry : list)
    if (entry.second.isList())
      names.push_back(entry.first);
  return names;
}

/// Checks one scene; the errors go where the caller says.
class Checks
{
public:
  Checks(const ParameterList& scene, std::vector<SceneError>& errors)
      : m_scene(scene), m_errors(errors), m_dimension(dimensionOf(scene))
  {
  }

  void all()
  {
    if (m_scene.isSublist("Domain"))
      domain(m_scene.sublist("Domain"));
    forEach("Materials", [this](const ParameterList& material, const std::string& where)
            { this->material(material, where); });
    forEach("Bodies",
            [this](const ParameterList& body, const std::string& where) { this->body(body, where); });
    forEach("Boundaries", [this](const ParameterList& boundary, const std::string& where)
            { this->boundary(boundary, where); });
    if (m_scene.isSublist("Output") && m_scene.isSublist("Time"))
      output(m_scene.sublist("Output"), m_scene.sublist("Time"));
    refuseHeatWords(m_scene, m_errors);
  }

private:
  template <class Check>
  void forEach(const std::string& section, const Check& check)
  {
    if (!m_scene.isSublist(section))
      return;
    const auto& list = m_scene.sublist(section);
    for (const auto& name : sublists(list))
      check(list.sublist(name), scenePath(section, name));
  }

  void report(const std::string& where, const std::string& message) { m_errors.push_back({where, message}); }

  /// A sentence that starts with the path of its place.
  void report(const std::string& where, const std::invalid_argument& error)
  {
    const std::string sentence = error.what();
    const auto colon = sentence.find(": ");
    if (sentence.rfind(where, 0) == 0 && colon != std::string::npos)
      report(sentence.substr(0, colon), sentence.substr(colon + 2));
    else
      report(where, sentence);
  }

  /// Whether the corners are in order along every axis; reports the axis where they are not.
  bool corners(const ParameterList& list, const std::string& where, bool mayTouch)
  {
    const auto lower = reals(list, "Lower Corner");
    const auto upper = reals(list, "Upper Corner");
    if (!lower || !upper || lower->size() != upper->size())
      return false;
    for (int d = 0; d < lower->size(); ++d)
      if (!((*upper)[d] > (*lower)[d] || (mayTouch && (*upper)[d] == (*lower)[d])))
      {
        report(scenePath(where, "Upper Corner"),
               "its " + std::string(1, "xyz"[d]) + " = " + formatReal((*upper)[d]) + " m is not above the " +
                   formatReal((*lower)[d]) +
                   " m of Lower Corner; write the corner with the larger coordinates.");
        return false;
      }
    return true;
  }

  static bool mentions(const SceneError& error, const char* name)
  {
    return error.where.find(name) != std::string::npos || error.message.find(name) != std::string::npos;
  }

  void domain(const ParameterList& domain)
  {
    const auto spacing = real(domain, "Cell Size");
    // Somebody who misspelt one of the two has been told.
    const bool told = std::any_of(m_errors.begin(), m_errors.end(),
                                  [](const SceneError& error)
                                  {
                                    return error.where.rfind("Domain > ", 0) == 0 &&
                                           (mentions(error, "Cell Size") || mentions(error, "Accuracy"));
                                  });
    if (!spacing && !told && !domain.isParameter("Accuracy"))
      report("Domain > Cell Size", "is missing; write a real number [m], or write Accuracy instead.");
    if (!corners(domain, "Domain", false) || !spacing)
      return;
    const auto lower = *reals(domain, "Lower Corner");
    const auto upper = *reals(domain, "Upper Corner");
    for (int d = 0; d < lower.size(); ++d)
    {
      const double extent = upper[d] - lower[d];
      if (extent / *spacing < 1.0 - 1e-9) // room for the rounding of the corners
      {
        report("Domain > Cell Size", "is " + formatReal(*spacing) + " m, more than the domain's " +
                                         formatReal(extent) + " m along " + std::string(1, "xyz"[d]) +
                                         "; write at most that, so that there is a cell.");
        return;
      }
    }
    m_domainKnown = true;
  }

  /// A name of a sublist of another section.
  void named(const ParameterList& list, const std::string& parameter, const std::string& section,
             const std::string& where)
  {
    const std::string name = text(list, parameter);
    if (name.empty() || !m_scene.isSublist(section) || m_scene.sublist(section).isSublist(name))
      return;
    const auto names = sublists(m_scene.sublist(section));
    if (!names.empty())
      report(scenePath(where, parameter),
             "there is no \"" + name + "\" in " + section + "; " + suggestion(name, names));
  }

  void body(const ParameterList& body, const std::string& where)
  {
    named(body, "Material", "Materials", where);
    if (!isWhole(where, "Material"))
      return;
    if (m_dimension == 2)
      shape<2>(body, where);
    else if (m_dimension == 3)
      shape<3>(body, where);
  }

  void material(const ParameterList& material, const std::string& where)
  {
    if (m_dimension == 0 || !isWhole(where, ""))
      return;
    const std::string plane =
        m_scene.isSublist("Domain") ? text(m_scene.sublist("Domain"), "Plane") : std::string();
    const std::string name = where.substr(std::string("Materials > ").size());
    try
    {
      std::vector<double> temperatures = tableTemperatures(material);
      if (temperatures.empty())
        temperatures = {1.0};
      for (const double T : temperatures)
        makeProperties(materialAt(material, T), name,
                       m_dimension == 3    ? Plane::Solid
                       : plane == "Stress" ? Plane::Stress
                                           : Plane::Strain);
    }
    catch (const std::invalid_argument& error)
    {
      report(where, error);
    }
  }

  /// Whether no entry of the section was refused, one parameter aside, so that what it describes can be made.
  bool isWhole(const std::string& where, const std::string& aside) const
  {
    for (const auto& error : m_errors)
      if (error.where == where ||
          (error.where.rfind(where + " > ", 0) == 0 && error.where != scenePath(where, aside)))
        return false;
    return true;
  }

  template <int D>
  void shape(const ParameterList& body, const std::string& where)
  {
    try
    {
      const auto bounds = makeShape<D>(body).bounds();
      if (m_domainKnown)
        insideDomain<D>(bounds.lower, bounds.upper, where);
    }
    catch (const std::invalid_argument& error)
    {
      report(where, error);
    }
  }

  template <int D>
  void insideDomain(const Vector<D>& lower, const Vector<D>& upper, const std::string& where)
  {
    const auto& domain = m_scene.sublist("Domain");
    const auto from = *reals(domain, "Lower Corner");
    const auto to = *reals(domain, "Upper Corner");
    const double slack = 1e-6 * *real(domain, "Cell Size"); // for the rounding of turned corners
    for (int d = 0; d < D; ++d)
      if (lower[d] < from[d] - slack || upper[d] > to[d] + slack)
      {
        report(where, "lies from " + formatReal(lower[d]) + " to " + formatReal(upper[d]) + " m along " +
                          "xyz"[d] + ", outside of the domain's " + formatReal(from[d]) + " to " +
                          formatReal(to[d]) + " m; enlarge the domain or move the body.");
        return;
      }
  }

  void boundary(const ParameterList& boundary, const std::string& where)
  {
    const std::string type = text(boundary, "Type");
    named(boundary, "Body", "Bodies", where);
    history(boundary, where);
    if (type == "Velocity")
    {
      corners(boundary, where, true);
      components(boundary, where);
      field(boundary, where);
    }
    else if (type == "Symmetry" && m_dimension == 2 && text(boundary, "Axis") == "z")
      report(scenePath(where, "Axis"), "is z in a 2D scene; write x or y.");
    else if (type == "Temperature")
      corners(boundary, where, true);
    else if (type == "Line Load")
      different(boundary, "From", "To", where);
    else if (type == "Traction" || type == "Heat Flux" || type == "Convection")
    {
      different(boundary, "From", "To", where);
      parallelogram(boundary, where);
      if (m_dimension == 2)
        alongSurface(boundary, where);
    }
  }

  /// Refuses a line that has its body on both sides all along: what acts on a surface would act nowhere.
  void alongSurface(const ParameterList& boundary, const std::string& where)
  {
    const auto from = reals(boundary, "From"), to = reals(boundary, "To");
    const std::string body = scenePath("Bodies", text(boundary, "Body"));
    if (!from || !to || from->size() != 2 || to->size() != 2 || *from == *to ||
        !m_scene.isSublist("Bodies") || !m_scene.sublist("Bodies").isSublist(text(boundary, "Body")) ||
        !isWhole(body, "Material"))
      return;
    const Shape<2> shape = makeShape<2>(m_scene.sublist("Bodies").sublist(text(boundary, "Body")));
    const double x = (*to)[0] - (*from)[0], y = (*to)[1] - (*from)[1];
    constexpr int looks = 20;
    constexpr double aside = 1e-4; // of the line's length
    for (int k = 0; k < looks; ++k)
      for (const double side : {-aside, aside})
      {
        const double at = (k + 0.5) / looks;
        if (!shape.contains({{(*from)[0] + at * x - side * y, (*from)[1] + at * y + side * x}}))
          return;
      }
    report(where, "lies inside " + body +
                      ", but it acts on surfaces; write a line along a surface, such as an edge.");
  }

  void different(const ParameterList& list, const std::string& one, const std::string& other,
                 const std::string& where)
  {
    const auto a = reals(list, one);
    const auto b = reals(list, other);
    if (a && b && *a == *b)
      report(scenePath(where, other), "is the same point as " + one + "; write another end of the line.");
  }

  void parallelogram(const ParameterList& list, const std::string& where)
  {
    const auto a = reals(list, "Edge 1");
    const auto b = reals(list, "Edge 2");
    if (!a || !b || a->size() != 3 || b->size() != 3)
      return;
    const auto& u = *a;
    const auto& v = *b;
    const double area =
        std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    if (!(area > 1e-12 * std::hypot(u[0], u[1], u[2]) * std::hypot(v[0], v[1], v[2])))
      report(scenePath(where, "Edge 2"),
             "is parallel to Edge 1 or zero; write an edge in another direction.");
  }

  void components(const ParameterList& boundary, const std::string& where)
  {
    const std::string letters = text(boundary, "Components");
    const std::string axes = m_dimension == 2 ? "xy" : "xyz";
    std::set<char> seen;
    bool good = !letters.empty() || !boundary.isParameter("Components");
    for (const char letter : letters)
      good = good && axes.find(letter) != std::string::npos && seen.insert(letter).second;
    if (!good)
      report(scenePath(where, "Components"),
             "is \"" + letters + "\"; write each axis once, such as \"" + axes + "\" or \"y\".");
  }

  void field(const ParameterList& boundary, const std::string& where)
  {
    if (!boundary.isParameter("Field"))
      return;
    try
    {
      PlaceFunction::parse(text(boundary, "Field"), m_dimension);
    }
    catch (const std::invalid_argument& error)
    {
      report(scenePath(where, "Field"), error.what());
    }
  }

  /// A load must be a number at any time of the run; looked at where the parser is cheap enough to.
  void history(const ParameterList& boundary, const std::string& where)
  {
    const auto end = m_scene.isSublist("Time") ? real(m_scene.sublist("Time"), "Final Time") : std::nullopt;
    const std::string given = text(boundary, "History");
    if (!end || given.empty())
      return;
    if (const auto complaint = complaintIfNotFinite(given, *end))
      report(scenePath(where, "History"), *complaint);
  }

  void output(const ParameterList& output, const ParameterList& time)
  {
    const auto end = real(time, "Final Time");
    const auto interval = real(output, "History Interval");
    if (end && interval && *end / *interval > 1e7)
      report("Output > History Interval",
             "gives more than ten million rows; write at least " + formatReal(*end * 1e-7) + " s.");
    const auto fields = real(output, "Field Interval");
    if (end && fields && *end / *fields > 1e5)
      report("Output > Field Interval",
             "gives more than a hundred thousand outputs; write at least " + formatReal(*end * 1e-5) + " s.");
    const auto checkpoints = real(output, "Checkpoint Interval");
    if (end && checkpoints && *end / *checkpoints > 1e7)
      report("Output > Checkpoint Interval",
             "gives more than ten million checkpoints; write at least " + formatReal(*end * 1e-7) + " s.");
  }

  const ParameterList& m_scene;
  std::vector<SceneError>& m_errors;
  int m_dimension;
  bool m_domainKnown = false;
};

} // namespace

void crossCheckCore(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  Checks(scene, errors).all();
}

void deriveDefaults(Teuchos::ParameterList& scene)
{
  if (!scene.isSublist("Output") || !scene.isSublist("Time"))
    return;
  auto& output = scene.sublist("Output");
  const auto end = real(scene.sublist("Time"), "Final Time");
  if (end && !output.isParameter("History Interval"))
    output.set("History Interval", *end / 200.0, "Time between two rows of history.csv. [s]");
}

} // namespace Rhegma
