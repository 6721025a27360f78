#include "scene/SectionChecks.hpp"

#include "base/Numbers.hpp"
#include "geometry/Shape.hpp"
#include "scene/NearestName.hpp"
#include "scene/TimeFunction.hpp"
#include "scene/Validation.hpp"

#include <cmath>

namespace Rhegma
{

using Teuchos::ParameterList;
using namespace SceneValues;

namespace SceneValues
{

std::optional<double> real(const ParameterList& list, const std::string& name)
{
  const auto* value = valueIf<double>(list, name);
  return value != nullptr ? std::optional<double>(*value) : std::nullopt;
}

std::string text(const ParameterList& list, const std::string& name)
{
  const auto* value = valueIf<std::string>(list, name);
  return value != nullptr ? *value : std::string();
}

std::optional<Reals> reals(const ParameterList& list, const std::string& name)
{
  const auto* values = valueIf<Reals>(list, name);
  return values != nullptr ? std::optional<Reals>(*values) : std::nullopt;
}

std::vector<std::string> sublists(const ParameterList& list)
{
  std::vector<std::string> names;
  for (const auto& entry : list)
    if (entry.second.isList())
      names.push_back(entry.first);
  return names;
}

} // namespace SceneValues

SectionChecks::SectionChecks(const ParameterList& scene, std::vector<SceneError>& errors)
    : scene_(scene), errors_(errors), found_(errors), dimension_(dimensionOf(scene))
{
}

void SectionChecks::report(const std::string& where, const std::string& message)
{
  errors_.push_back({where, message});
}

void SectionChecks::report(const std::string& where, const std::invalid_argument& error)
{
  const std::string message = error.what();
  const auto colon = message.find(": ");
  if (message.rfind(where, 0) == 0 && colon != std::string::npos)
    report(message.substr(0, colon), message.substr(colon + 2));
  else
    report(where, message);
}

bool SectionChecks::isWhole(const std::string& where, const std::string& aside) const
{
  return errors_.empty() || (!found_.has(where) && !found_.hasBelow(where, scenePath(where, aside)));
}

bool SectionChecks::corners(const ParameterList& list, const std::string& where, bool mayTouch)
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

void SectionChecks::named(const ParameterList& list, const std::string& parameter, const std::string& section,
                          const std::string& where)
{
  const std::string name = text(list, parameter);
  if (name.empty() || !scene_.isSublist(section) || scene_.sublist(section).isSublist(name))
    return;
  const auto names = sublists(scene_.sublist(section));
  if (!names.empty())
    report(scenePath(where, parameter),
           "there is no \"" + name + "\" in " + section + "; " + suggestion(name, names));
}

void SectionChecks::different(const ParameterList& list, const std::string& one, const std::string& other,
                              const std::string& where)
{
  const auto a = reals(list, one);
  const auto b = reals(list, other);
  if (a && b && *a == *b)
    report(scenePath(where, other), "is the same point as " + one + "; write another end of the line.");
}

void SectionChecks::history(const ParameterList& boundary, const std::string& where)
{
  const auto end = scene_.isSublist("Time") ? real(scene_.sublist("Time"), "Final Time") : std::nullopt;
  const std::string given = text(boundary, "History");
  if (!end || given.empty())
    return;
  if (const auto message = messageIfNotFinite(given, *end))
    report(scenePath(where, "History"), *message);
}

void SectionChecks::surface(const ParameterList& list, const std::string& where)
{
  different(list, "From", "To", where);
  parallelogram(list, where);
  if (dimension_ == 2)
    alongSurface(list, where);
}

void SectionChecks::parallelogram(const ParameterList& list, const std::string& where)
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
    report(scenePath(where, "Edge 2"), "is parallel to Edge 1 or zero; write an edge in another direction.");
}

/// Refuses a line inside the body: it is no surface, and nothing could act on it.
void SectionChecks::alongSurface(const ParameterList& boundary, const std::string& where)
{
  const auto from = reals(boundary, "From"), to = reals(boundary, "To");
  const std::string body = scenePath("Bodies", text(boundary, "Body"));
  if (!from || !to || from->size() != 2 || to->size() != 2 || *from == *to || !scene_.isSublist("Bodies") ||
      !scene_.sublist("Bodies").isSublist(text(boundary, "Body")) || !isWhole(body, "Material"))
    return;
  const Shape<2> shape = makeShape<2>(scene_.sublist("Bodies").sublist(text(boundary, "Body")));
  const double x = (*to)[0] - (*from)[0], y = (*to)[1] - (*from)[1];
  constexpr int samples = 20;
  constexpr double aside = 1e-4; // of the line's length
  for (int k = 0; k < samples; ++k)
    for (const double side : {-aside, aside})
    {
      const double at = (k + 0.5) / samples;
      if (!shape.contains({{(*from)[0] + at * x - side * y, (*from)[1] + at * y + side * x}}))
        return;
    }
  report(where,
         "lies inside " + body + ", but it acts on surfaces; write a line along a surface, such as an edge.");
}

} // namespace Rhegma
