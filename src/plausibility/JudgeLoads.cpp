#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "boundary/BodySurface.hpp"
#include "plausibility/IdleLoads.hpp"
#include "plausibility/Judges.hpp"
#include "scene/TimeFunction.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace Rhegma
{

namespace
{

/// The strain up to which stress and strain of a linear law are right to some percent, and one that no solid
/// but an elastomer withstands.
constexpr double linearLimit = 0.05, anyLimit = 3.0;

/// One message for all loads: the worst.
template <int D>
void judgeStrain(const JudgedScene<D>& judged, Messages& messages)
{
  const LoadEstimate* load = nullptr;
  const auto excess = [](const LoadEstimate& one)
  { return one.strain / (one.linear ? linearLimit : anyLimit); };
  for (const LoadEstimate& one : judged.loads)
    if (std::isfinite(one.strain) && std::isfinite(one.stress) && excess(one) > 1.0 &&
        (load == nullptr || excess(one) > excess(*load)))
      load = &one;
  if (load == nullptr)
    return;
  messages.push_back(load->where + ": it strains the body by about " + formatShort(100.0 * load->strain) +
                     " % (" + formatShort(load->stress) + " Pa), " +
                     (load->linear ? "too much for a linear law; use a law for finite strain, or check "
                                   : "more than a solid withstands; check ") +
                     "units (N, Pa, m, m/s)");
}

/// Whether a support of prescribed velocity moves nodes.
bool moves(const Teuchos::ParameterList& list)
{
  if (list.isParameter("Field"))
    return true;
  const auto value = list.get<Teuchos::Array<double>>("Value");
  return std::any_of(value.begin(), value.end(), [](double v) { return v != 0.0; });
}

/// Loads that never act, or hardly in the time of the run.
template <int D>
void judgeHistories(const JudgedScene<D>& judged, Messages& messages)
{
  if (!judged.scene.isSublist("Boundaries"))
    return;
  const Teuchos::ParameterList& section = judged.scene.sublist("Boundaries");
  const ActingTimes times = actingTimes(judged.scene, judged.state);
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const std::string type = list.get<std::string>("Type");
    const GivenLoad load{"Boundaries > " + name, type == "Velocity" ? "support" : "boundary"};
    const bool heats = type == "Temperature" || type == "Heat Flux" || type == "Convection"; // at all times
    const Messages idle =
        type != "Velocity" ? idleMessages(load, list, {"Force", "Stress", "Acceleration", "Pressure", "Flux"},
                                          heats ? ActingTimes{times.end, 0} : times)
        : moves(list)      ? idleSupportMessages(load, list.get<std::string>("History"), times)
                           : Messages{}; // zero is a support
    messages.insert(messages.end(), idle.begin(), idle.end());
  }
}

/// A run that starts in equilibrium under loads that do not act yet.
template <int D>
void judgeStart(const JudgedScene<D>& judged, Messages& messages)
{
  const std::string start = judged.scene.sublist("Time").template get<std::string>("Initial State");
  if (start == "Unloaded" || judged.driven || !judged.scene.isSublist("Boundaries"))
    return;
  const Teuchos::ParameterList& section = judged.scene.sublist("Boundaries");
  std::string idle;
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const std::string type = list.get<std::string>("Type");
    if (type == "Symmetry" || (type == "Velocity" && !moves(list)))
      continue;
    if (type == "Velocity" || TimeFunction::parse(list.get<std::string>("History"))(0.0) == 0.0)
      idle = idle.empty() ? name : idle;
    else
      return;
  }
  if (!idle.empty())
    messages.push_back(
        "Time > Initial State is " + start + ", but no load acts at time 0 (Boundaries > " + idle +
        " starts from zero), so the run starts unloaded; write loads whose History is not zero at "
        "time 0, or leave Initial State out");
}

/// Type of the boundary that a load is; empty if it is none.
std::string typeOf(const LoadEstimate& load, const Teuchos::ParameterList& scene)
{
  const std::string root = "Boundaries > ";
  if (load.where.rfind(root, 0) != 0 || !scene.isSublist("Boundaries"))
    return {};
  const Teuchos::ParameterList& section = scene.sublist("Boundaries");
  const std::string name = load.where.substr(root.size());
  return section.isSublist(name) ? section.sublist(name).get<std::string>("Type") : std::string();
}

/// Loads all of which strain hardly anything: stresses in MPa, or displacements for velocities, perhaps.
/// Loads that break something strain it by 5e-6 and more: glass of a K_Ic of 0.7 MPa m^0.5 with a crack of 1
/// m by 6e-6. What a load factor multiplies has any size; weight is small in small parts.
template <int D>
void judgeTinyLoads(const JudgedScene<D>& judged, Messages& messages)
{
  constexpr double leastOfSupports = 1e-7, leastOfForces = 1e-8;
  const LoadEstimate* load = nullptr;
  for (const LoadEstimate& one : judged.loads)
    if (std::isfinite(one.strain) && (load == nullptr || one.strain > load->strain) &&
        typeOf(one, judged.scene) != "Gravity")
      load = &one;
  if (load == nullptr || !(load->strain > 0.0))
    return;
  const std::string type = typeOf(*load, judged.scene);
  if (type == "Velocity" && load->strain < leastOfSupports)
    messages.push_back(load->where + ": up to Time > Final Time it strains the body by about " +
                       formatShort(load->strain) +
                       " only; Value is a velocity in m/s, and the displacement is its integral over time");
  if ((type == "Traction" || type == "Point Load" || type == "Line Load") && load->strain < leastOfForces &&
      !judged.driven && judged.state.method.analysis != Analysis::LoadFactor)
    messages.push_back(load->where + ": it strains the body by about " + formatShort(load->strain) +
                       " only (" + formatShort(load->stress) +
                       " Pa), and no other force strains it more; stresses are in Pa, and 1 MPa is 1e6 Pa, "
                       "forces in N and Young's modulus in Pa");
}

/// Whether a body has a part of voxels.
bool hasVoxels(const Teuchos::ParameterList& body)
{
  const auto isOfVoxels = [](const Teuchos::ParameterList& shape)
  { return shape.isType<std::string>("Shape") && shape.get<std::string>("Shape") == "Voxels"; };
  if (isOfVoxels(body) || !body.isSublist("Operations"))
    return isOfVoxels(body);
  const Teuchos::ParameterList& operations = body.sublist("Operations");
  const std::vector<std::string> names = sublistNames(operations);
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return isOfVoxels(operations.sublist(name)); });
}

/// The largest edge of the voxels of a body [m].
double voxelEdge(const Teuchos::ParameterList& body)
{
  double edge = body.isType<double>("Voxel Size") && body.get<double>("Voxel Size") > 0.0
                    ? body.get<double>("Voxel Size")
                    : 0.0;
  if (!body.isSublist("Operations"))
    return edge;
  const Teuchos::ParameterList& operations = body.sublist("Operations");
  for (const std::string& name : sublistNames(operations))
    edge = std::max(edge, voxelEdge(operations.sublist(name)));
  return edge;
}

/// Whether a noticeable part of a surface of voxels are steps: flat pieces that are less than three voxels
/// wide along some axis, between edges of the surface. A face along the axes, which has none, is as large as
/// it is meant. \param edge of a voxel \param cell the largest cell, within which a face has a point [m]
template <int D>
bool hasSteps(const std::vector<Geometry::SurfacePoint<D>>& points, double edge, double cell)
{
  constexpr double noticeable = 0.02;
  // Rows of points along an axis of a flat piece: its normal, the axis, and the voxel in all other
  // directions.
  std::map<std::vector<long>, std::vector<std::pair<double, double>>> rows; // position along it, and area
  double all = 0.0, steps = 0.0;
  for (const Geometry::SurfacePoint<D>& point : points)
  {
    int out = 0;
    for (int d = 1; d < D; ++d)
      out = std::fabs(point.normal[d]) > std::fabs(point.normal[out]) ? d : out;
    for (int along = 0; along < D; ++along)
    {
      if (along == out)
        continue;
      std::vector<long> row{out, point.normal[out] > 0.0 ? 1 : 0, along};
      for (int d = 0; d < D; ++d)
        // Quarters of voxels, off their edges and middles, so that rounding does not divide a row.
        row.push_back(d == along ? 0 : std::lround(4.0 * point.x[d] / edge + 0.318));
      rows[row].emplace_back(point.x[along], point.size);
    }
  }
  for (auto& [row, places] : rows)
  {
    std::sort(places.begin(), places.end());
    for (std::size_t first = 0; first < places.size();)
    {
      std::size_t end = first + 1;
      double area = places[first].second;
      // Pieces of large faces are as long as a cell, and at the edge of a body narrower.
      const auto length = [](double size) { return D == 2 ? size : std::sqrt(size); };
      for (; end < places.size() && places[end].first - places[end - 1].first < 2.0 * std::max(edge, cell);
           ++end)
        area += places[end].second;
      all += area;
      const double wide = places[end - 1].first - places[first].first + length(places[end - 1].second);
      steps += wide < 2.75 * edge ? area : 0.0;
      first = end;
    }
  }
  return steps > noticeable * all / (D - 1); // in 3D each place is met along two axes
}

/// What acts by area on faces of voxels, which go up and down in steps. Of a pressure the steps cancel.
template <int D>
void judgeVoxelFaces(const JudgedScene<D>& judged, Messages& messages)
{
  if (!judged.scene.isSublist("Boundaries") || !judged.scene.isSublist("Bodies"))
    return;
  const Teuchos::ParameterList& section = judged.scene.sublist("Boundaries");
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const bool ofBody = list.isType<std::string>("Surface") && list.get<std::string>("Surface") == "Body";
    if (!ofBody || list.isParameter("Pressure") ||
        !hasVoxels(judged.scene.sublist("Bodies").sublist(list.get<std::string>("Body"))))
      continue;
    const double edge = voxelEdge(judged.scene.sublist("Bodies").sublist(list.get<std::string>("Body")));
    if (!(edge > 0.0) || !hasSteps(chosenSurface<D>(judged.scene, list, "Boundaries > " + name), edge,
                                   judged.state.mesh.grid.spacing))
      continue;
    messages.push_back("Boundaries > " + name +
                       " acts on the steps of its voxels: on faces that are not along " +
                       "the axes their area is larger than that of the smooth surface, of a " +
                       (D == 2 ? "disk by 27 % (4 / pi)" : "ball by 50 %") +
                       ", and what acts in all is too large by as much; divide it by that ratio, or take the "
                       "part from a surface file");
  }
}

} // namespace

template <int D>
Messages judgeLoads(const JudgedScene<D>& judged)
{
  Messages messages;
  judgeStrain(judged, messages);
  judgeTinyLoads(judged, messages);
  judgeStart(judged, messages);
  judgeHistories(judged, messages);
  judgeVoxelFaces(judged, messages);
  return messages;
}

template Messages judgeLoads(const JudgedScene<2>&);
template Messages judgeLoads(const JudgedScene<3>&);

} // namespace Rhegma
