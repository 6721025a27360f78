#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/Judges.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;

/// Strain with which no law goes through a step.
constexpr double most = 0.5;

/// A support of speed v strains the body next to it by v / c until the wave from it is away, whatever the
/// body's length. \param speed of the fastest waves [m/s]
template <int D>
void judgeSpeed(double speed, const ParameterList& list, double factor, const std::string& where,
                Messages& messages)
{
  double moved = 0.0;
  const Vector<D> value = readVector<D>(list, "Value");
  for (const char axis : list.get<std::string>("Components"))
    moved = std::max(moved, factor * std::fabs(value[axis - 'x']));
  if (std::isfinite(moved) && moved > most * speed)
    messages.push_back(where + ": it moves nodes at " + formatShort(moved) + " m/s, " +
                       formatShort(moved / speed) + " times the " + formatShort(speed) +
                       " m/s of waves in the bodies, which strains what is next to it by as much; velocities "
                       "are in m/s");
}

/// Section of a body that the cells at a load offer it: a cell across in every direction in which it has no
/// length [m2].
template <int D>
double sectionAt(const State<D>& state, const ParameterList& list)
{
  const bool line = list.isParameter("From");
  const Vector<D> from = readVector<D>(list, line ? "From" : "Point"),
                  to = line ? readVector<D>(list, "To") : from;
  const double cell = spacingAt(state, 0.5 * (from + to)), length = std::max(cell, norm(to - from));
  const double onAxis = 0.25 * cell; // mean radius of what a node there stands for
  return length * (D == 2 ? state.method.depth().at(std::max(onAxis, 0.5 * (from[0] + to[0]))) : cell);
}

/// A force at a point is borne by the cells around it.
template <int D>
void judgeForce(const JudgedScene<D>& judged, const ParameterList& list, double factor,
                const BodyMeasure<D>& body, const std::string& where, Messages& messages)
{
  const double stress = factor * norm(readVector<D>(list, "Force")) / sectionAt(judged.state, list);
  const double modulus = body.moduli.constrainedModulus;
  if (std::isfinite(stress) && stress > most * modulus)
    messages.push_back(where + " > Force: the cells at the load bear " + formatShort(stress) + " Pa, " +
                       formatShort(stress / modulus) + " times the modulus of " + body.material +
                       ", which crushes them; spread the force (Traction), or check its unit (N)");
}

} // namespace

template <int D>
Messages judgeFirstSteps(const JudgedScene<D>& judged)
{
  Messages messages;
  if (!judged.state.method.mechanics || !judged.scene.isSublist("Boundaries") || judged.bodies.empty())
    return messages;
  std::unordered_map<std::string, const BodyMeasure<D>*> bodies;
  double speed = 0.0;
  for (const BodyMeasure<D>& body : judged.bodies)
  {
    bodies.emplace(body.name, &body);
    speed = std::max(speed, body.speed);
  }
  const ParameterList& section = judged.scene.sublist("Boundaries");
  const double end = judged.scene.sublist("Time").template get<double>("Final Time");
  for (const std::string& name : sublistNames(section))
  {
    const ParameterList& list = section.sublist(name);
    const std::string type = list.get<std::string>("Type"), where = "Boundaries > " + name;
    const bool moves = type == "Velocity" && list.isParameter("Value");
    if (!moves && type != "Point Load" && type != "Line Load")
      continue;
    const double factor = rangeOf(list.get<std::string>("History"), end).largest;
    if (moves)
      judgeSpeed<D>(speed, list, factor, where, messages);
    else if (const auto body = bodies.find(list.get<std::string>("Body")); body != bodies.end())
      judgeForce(judged, list, factor, *body->second, where, messages);
  }
  return messages;
}

template Messages judgeFirstSteps(const JudgedScene<2>&);
template Messages judgeFirstSteps(const JudgedScene<3>&);

} // namespace Rhegma
