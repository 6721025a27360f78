#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "boundary/MirrorSide.hpp"
#include "plausibility/Judges.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;

/// A plane of symmetry, and what lies on the side of its mirror image.
struct Mirror
{
  std::string name;
  int axis;
  double position;              ///< [m]
  bool below;                   ///< which side that is
  bool given;                   ///< whether the scene says so
  std::vector<double> beyond{}; ///< mass of each body there [kg]; empty: no body reaches there
};

/// Those that some body reaches beyond by more than a twentieth of a cell.
template <int D>
std::vector<Mirror> reachedMirrors(const JudgedScene<D>& judged)
{
  std::vector<Mirror> mirrors;
  if (!judged.scene.isSublist("Boundaries"))
    return mirrors;
  const ParameterList &section = judged.scene.sublist("Boundaries"), &domain = judged.scene.sublist("Domain");
  const Vector<D> lower = readVector<D>(domain, "Lower Corner"),
                  upper = readVector<D>(domain, "Upper Corner");
  const double slack = 0.05 * judged.state.mesh.grid.spacing;
  for (const std::string& name : sublistNames(section))
  {
    const ParameterList& list = section.sublist(name);
    if (list.get<std::string>("Type") != "Symmetry")
      continue;
    const int axis = list.get<std::string>("Axis")[0] - 'x';
    Mirror mirror{name, axis, list.get<double>("Position"), mirrorIsBelow(list, lower[axis], upper[axis]),
                  list.isParameter("Side")};
    const bool reached = std::any_of(judged.bodies.begin(), judged.bodies.end(),
                                     [&](const BodyMeasure<D>& body)
                                     {
                                       return mirror.below ? body.lower[axis] < mirror.position - slack
                                                           : body.upper[axis] > mirror.position + slack;
                                     });
    if (!reached)
      continue;
    mirror.beyond.assign(judged.bodies.size(), 0.0);
    mirrors.push_back(std::move(mirror));
  }
  return mirrors;
}

/// Adds the particles whose middles lie beyond the planes: of those that a plane cuts, most lies in the body.
template <int D>
void weigh(const State<D>& state, std::vector<Mirror>& mirrors)
{
  const auto body = onHost(state.particles.integer(fields::body));
  const auto mass = onHost(state.particles.scalar(fields::mass));
  const auto x = onHost(state.particles.template real<D>(fields::position));
  const double slack = 1e-6 * state.mesh.grid.spacing;
  for (Mirror& mirror : mirrors)
    for (int p = 0; p < state.particles.size(); ++p)
      if (mirror.below ? x(p, mirror.axis) < mirror.position - slack
                       : x(p, mirror.axis) > mirror.position + slack)
        mirror.beyond[body(p)] += mass(p);
}

/// \param part of the body that lies beyond the plane [-]
std::string messageOn(const Mirror& mirror, const std::string& body, double part)
{
  const std::string side = mirror.below ? "lower" : "upper", other = mirror.below ? "Upper" : "Lower";
  const std::string axis(1, static_cast<char>('x' + mirror.axis));
  const std::string plane = " side of the plane " + axis + " = " + readableLength(mirror.position);
  const bool all = part > 1.0 - 1e-9;
  return "Boundaries > " + mirror.name + " > " + (all ? "Side" : "Position") + ": " +
         (all ? "all" : formatShort(100.0 * part) + " %") + " of Bodies > " + body + " lies on the " + side +
         plane + ", which is that of the mirror image" +
         (mirror.given ? std::string() : " (by default, the nearer end of the domain)") +
         ", so that it is held along " + axis + "; " +
         (all ? "write Side = " + other
              : "cut the body at the plane, move the plane to its surface, or leave it out for a whole body");
}

/// Planes of symmetry that a scene has twice: the second adds nothing, and probably another was meant.
Messages repeatedMirrors(const ParameterList& scene, double slack)
{
  Messages messages;
  if (!scene.isSublist("Boundaries"))
    return messages;
  std::vector<Mirror> earlier;
  for (const std::string& name : sublistNames(scene.sublist("Boundaries")))
  {
    const ParameterList& list = scene.sublist("Boundaries").sublist(name);
    if (list.get<std::string>("Type") != "Symmetry")
      continue;
    const Mirror mirror{name, list.get<std::string>("Axis")[0] - 'x', list.get<double>("Position"), false,
                        false};
    const auto same = std::find_if(earlier.begin(), earlier.end(),
                                   [&](const Mirror& other) {
                                     return other.axis == mirror.axis &&
                                            std::fabs(other.position - mirror.position) <= slack;
                                   });
    if (same != earlier.end())
      messages.push_back("Boundaries > " + name + ": it is the same plane as Boundaries > " + same->name +
                         ", " + std::string(1, static_cast<char>('x' + mirror.axis)) + " = " +
                         readableLength(mirror.position) +
                         ", so it adds nothing; check Axis and Position, or leave one of them out");
    earlier.push_back(mirror);
  }
  return messages;
}

} // namespace

template <int D>
Messages judgeMirrors(const JudgedScene<D>& judged)
{
  Messages messages = repeatedMirrors(judged.scene, 0.05 * judged.state.mesh.grid.spacing);
  if (!judged.state.method.mechanics)
    return messages;
  std::vector<Mirror> mirrors = reachedMirrors(judged);
  weigh(judged.state, mirrors);
  for (const Mirror& mirror : mirrors)
  {
    std::size_t most = 0;
    for (std::size_t b = 1; b < judged.bodies.size(); ++b)
      most = mirror.beyond[b] > mirror.beyond[most] ? b : most;
    if (mirror.beyond[most] > 0.0)
      messages.push_back(messageOn(mirror, judged.bodies[most].name,
                                   std::min(1.0, mirror.beyond[most] / judged.bodies[most].mass)));
  }
  return messages;
}

template Messages judgeMirrors(const JudgedScene<2>&);
template Messages judgeMirrors(const JudgedScene<3>&);

} // namespace Rhegma
