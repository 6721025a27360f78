#include "boundary/DomainEdges.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "geometry/Shape.hpp"

#include <cmath>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;

/// Whether a support holds nodes on the plane where an axis has this value.
bool holds(const ParameterList& support, int axis, double value, double slack)
{
  const std::string type = support.get<std::string>("Type");
  if (type == "Symmetry")
    return support.get<std::string>("Axis")[0] == 'x' + axis &&
           std::fabs(support.get<double>("Position") - value) <= slack;
  if (type != "Velocity" ||
      support.get<std::string>("Components").find(static_cast<char>('x' + axis)) == std::string::npos)
    return false;
  if (support.get<std::string>("Nodes") == "Outside")
    return true;
  return support.get<Teuchos::Array<double>>("Lower Corner")[axis] <= value + slack &&
         support.get<Teuchos::Array<double>>("Upper Corner")[axis] >= value - slack;
}

} // namespace

template <int D>
std::vector<std::string> warningsOfEdges(const ParameterList& scene)
{
  const ParameterList& domain = scene.sublist("Domain");
  const Vector<D> lower = readVector<D>(domain, "Lower Corner"),
                  upper = readVector<D>(domain, "Upper Corner");
  const double slack = 1e-6 * domain.get<double>("Cell Size");
  std::vector<std::string> warnings;
  for (const std::string& name : sublistNames(scene.sublist("Bodies")))
  {
    const auto bounds = makeShape<D>(scene.sublist("Bodies").sublist(name)).bounds();
    for (int d = 0; d < D; ++d)
      for (const bool low : {true, false})
      {
        const double edge = low ? lower[d] : upper[d], face = low ? bounds.lower[d] : bounds.upper[d];
        bool held = std::fabs(face - edge) > slack;
        if (scene.isSublist("Boundaries"))
          for (const std::string& support : sublistNames(scene.sublist("Boundaries")))
            held = held || holds(scene.sublist("Boundaries").sublist(support), d, edge, slack);
        if (!held)
          warnings.push_back(
              "Bodies > " + name + ": it touches the domain's edge at " + "xyz"[d] + " = " +
              formatReal(edge) +
              " m and is not supported there; the run stops if it moves outside: enlarge the domain by a few "
              "cells, or support that face (Boundaries, Symmetry or Velocity)");
      }
  }
  return warnings;
}

template std::vector<std::string> warningsOfEdges<2>(const ParameterList&);
template std::vector<std::string> warningsOfEdges<3>(const ParameterList&);

} // namespace Rhegma
