#include "base/EntryValue.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/Judges.hpp"
#include "scene/TimeFunction.hpp"

#include <cmath>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;

/// Whether a boundary loads or moves bodies. A load of zero has a message of its own (JudgeLoads.cpp), and
/// what a type of an application does is not known.
template <int D>
bool drives(const ParameterList& boundary)
{
  const std::string type = boundary.get<std::string>("Type");
  if (type == "Velocity")
    return !boundary.isParameter("Value") || norm(readVector<D>(boundary, "Value")) > 0.0;
  return type != "Symmetry";
}

bool startsMoving(const ParameterList& body)
{
  for (const char* const motion : {"Velocity", "Angular Velocity"})
    for (const double v : *valueIf<Teuchos::Array<double>>(body, motion))
      if (v != 0.0)
        return true;
  return false;
}

template <int D>
bool isDriven(const ParameterList& scene)
{
  if (scene.isSublist("Boundaries"))
    for (const std::string& name : sublistNames(scene.sublist("Boundaries")))
      if (drives<D>(scene.sublist("Boundaries").sublist(name)))
        return true;
  for (const auto& entry : scene.sublist("Bodies"))
    if (const auto* const body = valueIf<ParameterList>(entry.second); body != nullptr && startsMoving(*body))
      return true;
  return false;
}

/// A scene in which nothing can happen.
template <int D>
void judgeRest(const JudgedScene<D>& judged, Messages& messages)
{
  if (judged.driven || isDriven<D>(judged.scene))
    return;
  const double end = judged.scene.sublist("Time").template get<double>("Final Time");
  messages.push_back("Boundaries: nothing loads or moves the bodies: there is neither a load, gravity nor a "
                     "moving support, neither heat nor pressure, and no body has a Velocity or an Angular "
                     "Velocity, so all " +
                     std::string(judged.state.method.equilibrium() ? "is without stress" : "stays at rest") +
                     " up to Time > Final Time = " + readableTime(end) +
                     "; add what is missing, such as a Traction, a Line Load or Gravity");
}

/// Centrifuges reach 2000 m/s2. Shocks are harder and short: their history ends at zero.
template <int D>
void judgeGravity(const JudgedScene<D>& judged, Messages& messages)
{
  constexpr double g = 9.81, most = 3000.0;
  if (!judged.scene.isSublist("Boundaries"))
    return;
  const ParameterList& section = judged.scene.sublist("Boundaries");
  const double end = judged.scene.sublist("Time").template get<double>("Final Time");
  for (const std::string& name : sublistNames(section))
  {
    const ParameterList& list = section.sublist(name);
    if (list.get<std::string>("Type") != "Gravity")
      continue;
    const double acceleration = norm(readVector<D>(list, "Acceleration"));
    const double lasts = std::fabs(TimeFunction::parse(list.get<std::string>("History"))(end));
    if (acceleration * lasts > most)
      messages.push_back("Boundaries > " + name + " > Acceleration is " + formatShort(acceleration * lasts) +
                         " m/s2 up to the end, " + formatShort(acceleration * lasts / g) +
                         " times that of the Earth and more than of centrifuges (2000); it is in m/s2, and "
                         "9810 mm/s2 are 9.81 m/s2");
  }
}

} // namespace

template <int D>
Messages judgeMotion(const JudgedScene<D>& judged)
{
  Messages messages;
  if (!judged.state.method.mechanics)
    return messages;
  judgeRest(judged, messages);
  judgeGravity(judged, messages);
  return messages;
}

template Messages judgeMotion(const JudgedScene<2>&);
template Messages judgeMotion(const JudgedScene<3>&);

} // namespace Rhegma
