#include "scene/CrossChecks.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "geometry/Shape.hpp"
#include "material/MaterialTable.hpp"
#include "material/ThermoMaterials.hpp"
#include "scene/NearestName.hpp"
#include "scene/SectionChecks.hpp"
#include "scene/Validation.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{

namespace
{

using namespace SceneValues;
using Teuchos::ParameterList;

/// Checks one scene; adds to the errors of the caller.
class Checks : private SectionChecks
{
public:
  using SectionChecks::SectionChecks;

  void all()
  {
    if (scene().isSublist("Domain"))
      domain(scene().sublist("Domain"));
    forEach("Materials", [this](const ParameterList& material, const std::string& where)
            { this->material(material, where); });
    forEach("Bodies",
            [this](const ParameterList& body, const std::string& where) { this->body(body, where); });
    if (scene().isSublist("Output") && scene().isSublist("Time"))
      output(scene().sublist("Output"), scene().sublist("Time"));
  }

private:
  static bool mentions(const SceneError& error, const char* name)
  {
    return error.where.find(name) != std::string::npos || error.message.find(name) != std::string::npos;
  }

  void domain(const ParameterList& domain)
  {
    const auto spacing = real(domain, "Cell Size");
    // A misspelt name has been reported already.
    const bool reported = std::any_of(errors().begin(), errors().end(),
                                      [](const SceneError& error)
                                      {
                                        return error.where.rfind("Domain > ", 0) == 0 &&
                                               (mentions(error, "Cell Size") || mentions(error, "Accuracy"));
                                      });
    if (!spacing && !reported && !domain.isParameter("Accuracy"))
      report("Domain > Cell Size", "is missing; write a real number [m], or write Accuracy instead.");
    if (!corners(domain, "Domain", false) || !spacing)
      return;
    m_lower = *reals(domain, "Lower Corner");
    m_upper = *reals(domain, "Upper Corner");
    m_spacing = *spacing;
    for (int d = 0; d < m_lower.size(); ++d)
    {
      const double extent = m_upper[d] - m_lower[d];
      if (extent / *spacing < 1.0 - 1e-9) // tolerance for the rounding of the corners
      {
        report("Domain > Cell Size", "is " + formatReal(*spacing) + " m, more than the domain's " +
                                         formatReal(extent) + " m along " + std::string(1, "xyz"[d]) +
                                         "; write at most that, so that there is a cell.");
        return;
      }
    }
    if (text(domain, "Plane") == "Axisymmetric" && m_lower[0] < 0.0)
      return report(
          "Domain > Lower Corner",
          "begins at x = " + formatReal(m_lower[0]) +
              " m in an axisymmetric scene, in which x is the radius; write 0, or the radius inside "
              "of a hollow body.");
    m_domainKnown = true;
  }

  void body(const ParameterList& body, const std::string& where)
  {
    named(body, "Material", "Materials", where);
    bonded(body, where);
    if (!isWhole(where, "Material"))
      return;
    if (dimension() == 2)
      shape<2>(body, where);
    else if (dimension() == 3)
      shape<3>(body, where);
  }

  void bonded(const ParameterList& body, const std::string& where)
  {
    const std::string given = text(body, "Bonded To");
    if (given.empty())
      return;
    std::istringstream names(given);
    for (std::string name; std::getline(names, name, ',');)
      if (const ParameterList& bodies = scene().sublist("Bodies"); !bodies.isSublist(trimmed(name)))
        report(scenePath(where, "Bonded To"), "there is no body \"" + trimmed(name) + "\"; " +
                                                  suggestion(trimmed(name), sublistNames(bodies)));
  }

  void material(const ParameterList& material, const std::string& where)
  {
    if (dimension() == 0 || !isWhole(where, ""))
      return;
    const std::string plane =
        scene().isSublist("Domain") ? text(scene().sublist("Domain"), "Plane") : std::string();
    const std::string name = where.substr(std::string("Materials > ").size());
    try
    {
      std::vector<double> temperatures = tableTemperatures(material);
      if (temperatures.empty())
        temperatures = {1.0};
      for (const double T : temperatures)
      {
        makeProperties(materialAt(material, T), name,
                       dimension() == 3    ? Plane::Solid
                       : plane == "Stress" ? Plane::Stress
                                           : Plane::Strain);
      }
    }
    catch (const std::invalid_argument& error)
    {
      report(where, error);
    }
  }

  static bool isCut(const ParameterList& body)
  {
    if (!body.isSublist("Operations"))
      return false;
    const ParameterList& operations = body.sublist("Operations");
    const std::vector<std::string> names = sublistNames(operations);
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name)
                       { return text(operations.sublist(name), "Operation") == "Cut"; });
  }

  /// Whether a body from a file without a scale is larger than the domain, and would not be in millimetres.
  template <int D>
  bool seemsMillimetres(const ParameterList& body, const Geometry::Bounds<D>& bounds) const
  {
    if (text(body, "Shape") != "File" || body.isParameter("Scale"))
      return false;
    double largest = 0.0; // of the domain's extent
    for (int d = 0; d < D; ++d)
      largest = std::max(largest, (bounds.upper[d] - bounds.lower[d]) / (m_upper[d] - m_lower[d]));
    return largest > 1.0 && largest <= 1000.0;
  }

  template <int D>
  void shape(const ParameterList& body, const std::string& where)
  {
    try
    {
      const auto bounds = makeShape<D>(body).bounds();
      if (m_domainKnown && seemsMillimetres<D>(body, bounds))
        return report(
            where + " > Scale",
            "is not given, so numbers of the file are metres and the body is larger than the domain, " +
                formatReal(bounds.upper[0] - bounds.lower[0]) +
                " m along x; write Scale = 0.001 if the "
                "file is in millimetres, or enlarge the domain.");
      // A body from which something is cut is checked by its particles.
      if (m_domainKnown && !isCut(body))
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
    const Reals &from = m_lower, &to = m_upper;
    const double slack = 1e-6 * m_spacing; // for the rounding of turned corners
    for (int d = 0; d < D; ++d)
      if (lower[d] < from[d] - slack || upper[d] > to[d] + slack)
      {
        report(where, "lies from " + formatReal(lower[d]) + " to " + formatReal(upper[d]) + " m along " +
                          "xyz"[d] + ", outside of the domain's " + formatReal(from[d]) + " to " +
                          formatReal(to[d]) +
                          " m; enlarge the domain (Domain > Lower Corner, Upper Corner), move the body, or "
                          "cut off what sticks out (Operations, Operation = Cut); if material lies on the "
                          "wrong side of a plane of symmetry, set Boundaries > * > Side (Type = Symmetry) to "
                          "the side without material.");
        return;
      }
  }

  void output(const ParameterList& output, const ParameterList& time)
  {
    const auto end = real(time, "Final Time");
    const auto check = [&](const char* name, double most, const std::string& many)
    {
      const auto interval = real(output, name);
      if (end && interval && *end / *interval > most)
        report(std::string("Output > ") + name,
               "gives more than " + many + " up to Time > Final Time = " + formatReal(*end) +
                   " s; write at least " + formatReal(*end / most) + " s, or an earlier end.");
    };
    check("History Interval", 1e7, "ten million rows");
    check("Field Interval", 1e5, "a hundred thousand outputs");
    check("Checkpoint Interval", 1e7, "ten million checkpoints");
  }

  bool m_domainKnown = false;
  Reals m_lower, m_upper; ///< corners of the domain, where it is known
  double m_spacing = 0.0; ///< its cells'
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

void addAxis(Teuchos::ParameterList& scene)
{
  if (!scene.isSublist("Domain") || text(scene.sublist("Domain"), "Plane") != "Axisymmetric")
    return;
  ParameterList& domain = scene.sublist("Domain");
  auto lower = reals(domain, "Lower Corner");
  const auto cell = real(domain, "Cell Size");
  constexpr double rounding = 1e-9; // of a cell
  if (!lower || lower->size() == 0 || !(std::fabs((*lower)[0]) <= rounding * cell.value_or(0.0)))
    return;
  if ((*lower)[0] != 0.0)
  {
    (*lower)[0] = 0.0;
    domain.set("Lower Corner", *lower);
  }
  ParameterList& boundaries = scene.sublist("Boundaries");
  for (const std::string& name : sublists(boundaries))
    if (const auto position = real(boundaries.sublist(name), "Position");
        text(boundaries.sublist(name), "Type") == "Symmetry" &&
        text(boundaries.sublist(name), "Axis") == "x" && position && *position == 0.0)
      return;
  ParameterList& axis = boundaries.sublist("Axis of Revolution");
  Teuchos::ParameterEntry type;
  type.setValue(std::string("Symmetry"), true); // not given by the scene, which checks can see
  axis.setEntry("Type", type);
  axis.set("Axis", std::string("x"));
  axis.set("Position", 0.0);
  axis.set("Side", std::string("Lower"));
}

} // namespace Rhegma
