#include "energy_release/SurfaceNodes.hpp"

#include "base/ReadList.hpp"
#include "energy_release/FrontLine.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::energy_release
{

namespace
{

/// Cells along a front from the surface within which its G is not reliable (docs/how-to/cracks-in-3d.md).
constexpr double cellsAtSurface = 2.0;

bool isAtMirror(const Vector<3>& x, double cell, const std::vector<MirrorPlane>& mirrors)
{
  return std::any_of(mirrors.begin(), mirrors.end(),
                     [&](const MirrorPlane& mirror)
                     { return std::fabs(x[mirror.axis] - mirror.position) <= cell; });
}

/// Positions of the two ends of an open line.
struct Ends
{
  Vector<3> begin{}, end{};
};

Ends endsOf(const FrontLine& line, int number)
{
  Ends ends;
  double least = 0.0, most = 0.0;
  bool any = false;
  for (std::size_t k = 0; k < line.nodes.size(); ++k)
  {
    if (line.line[k] != number)
      continue;
    if (!any || line.arc[k] < least)
    {
      least = line.arc[k];
      ends.begin = line.nodes[k].position;
    }
    if (!any || line.arc[k] > most)
    {
      most = line.arc[k];
      ends.end = line.nodes[k].position;
    }
    any = true;
  }
  return ends;
}

} // namespace

std::vector<MirrorPlane> mirrorPlanes(const Teuchos::ParameterList& scene)
{
  std::vector<MirrorPlane> planes;
  if (!scene.isSublist("Boundaries"))
    return planes;
  const Teuchos::ParameterList& boundaries = scene.sublist("Boundaries");
  for (const std::string& name : sublistNames(boundaries))
  {
    const Teuchos::ParameterList& list = boundaries.sublist(name);
    if (list.get<std::string>("Type") == "Symmetry")
      planes.push_back({list.get<std::string>("Axis")[0] - 'x', list.get<double>("Position")});
  }
  return planes;
}

template <>
std::vector<char> nodesAtSurface(const State<2>&, const CrackFront<2>& front, const std::vector<MirrorPlane>&)
{
  return std::vector<char>(front.nodes.size(), 0);
}

template <>
std::vector<char> nodesAtSurface(const State<3>& state, const CrackFront<3>& front,
                                 const std::vector<MirrorPlane>& mirrors)
{
  const FrontLine line = lineOf(front);
  std::vector<char> marked(front.nodes.size(), 0);
  std::vector<Ends> ends;
  for (std::size_t l = 0; l < line.open.size(); ++l)
    ends.push_back(endsOf(line, static_cast<int>(l)));
  for (std::size_t k = 0; k < line.nodes.size(); ++k)
  {
    const int l = line.line[k];
    if (!(line.open[l] > 0.0))
      continue;
    const double cell = spacingAt(state, line.nodes[k].position), near = cellsAtSurface * cell;
    const bool atBegin = line.arc[k] < near && !isAtMirror(ends[l].begin, cell, mirrors);
    const bool atEnd = line.open[l] - line.arc[k] < near && !isAtMirror(ends[l].end, cell, mirrors);
    marked[k] = atBegin || atEnd ? 1 : 0;
  }
  if (std::all_of(marked.begin(), marked.end(), [](char m) { return m != 0; }))
    std::fill(marked.begin(), marked.end(), char(0));
  return marked;
}

template <int D>
void reportNodesAtSurface(const State<D>& state, const CrackFront<D>& front,
                          const std::vector<MirrorPlane>& mirrors, nlohmann::json& entry)
{
  if (D == 2)
    return;
  nlohmann::json& list = entry["front_nodes"]["at_surface"] = nlohmann::json::array();
  for (const char marked : nodesAtSurface(state, front, mirrors))
    list.push_back(marked != 0);
}

template void reportNodesAtSurface(const State<2>&, const CrackFront<2>&, const std::vector<MirrorPlane>&,
                                   nlohmann::json&);
template void reportNodesAtSurface(const State<3>&, const CrackFront<3>&, const std::vector<MirrorPlane>&,
                                   nlohmann::json&);

} // namespace Rhegma::energy_release
