#include "propagation/MaterialsAhead.hpp"

#include "base/Numbers.hpp"
#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "material/LawStiffness.hpp"
#include "material/RayleighSpeed.hpp"
#include "plan/LoadOverStep.hpp"
#include "plausibility/Judges.hpp"
#include "state/BodyGroup.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace Rhegma::propagation
{

namespace
{

/// Whether two moduli differ by more than a hundredth: those of one material scatter by as much, so that two
/// names with closer ones may be one material, of one toughness.
bool differ(double one, double other)
{
  constexpr double same = 0.01;
  return std::fabs(other / one - 1.0) > same;
}

/// Whether two materials are different ones: whether Young's modulus or the shear modulus differs, or the
/// stiffness of some direction.
bool differ(const Properties& one, const Properties& other)
{
  const Elasticity a = elasticity(one), b = elasticity(other);
  return differ(a.young, b.young) || differ(a.shear, b.shear) ||
         ((isAnisotropic(one) || isAnisotropic(other)) && !haveSameStiffness(one, other));
}

template <int D>
bool differ(const State<D>& state, int one, int other)
{
  return one >= 0 && other >= 0 && one != other &&
         differ(state.materials.properties[one], state.materials.properties[other]);
}

/// "Materials > Steel (its Young's modulus is 70 times that of Materials > Acrylic)".
template <int D>
std::string comparedText(const State<D>& state, int own, int other)
{
  const MaterialSet& materials = state.materials;
  const Elasticity a = elasticity(materials.properties[own]), b = elasticity(materials.properties[other]);
  const bool young = differ(a.young, b.young);
  if (!young && !differ(a.shear, b.shear))
    return "Materials > " + materials.names[other] + " (its stiffness has other directions than that of " +
           "Materials > " + materials.names[own] + ")";
  return "Materials > " + materials.names[other] + " (its " + (young ? "Young's" : "shear") + " modulus is " +
         formatShort(young ? b.young / a.young : b.shear / a.shear) + " times that of Materials > " +
         materials.names[own] + ")";
}

template <int D>
std::string toughnessText(const State<D>& state, const Options& options)
{
  return "Propagation > Toughness, " + formatShort(options.rule.toughness(0.0, options.temperature)) +
         " J/m2" + (state.method.equilibrium() ? "" : " at rest") + ", is that of all materials";
}

/// The material of each cell, of the particles that a crack may cut.
template <int D>
class MaterialOfCells
{
public:
  static constexpr int nothing = -1, several = -2, edge = -3;

  MaterialOfCells(const State<D>& state, const ParticlesOfGroup& among)
      : grid_(state.mesh.grid), material_(grid_.numNodes, nothing)
  {
    const auto group = onHost(among.of);
    const auto position = onHost(state.particles.template real<D>(fields::position));
    const auto edges = onHost(state.particles.template real<D>(fields::edge));
    const auto material = onHost(state.particles.integer(fields::material));
    constexpr double within = 0.5 * (1.0 - 1e-9); // boxes end at faces of cells, to rounding
    for (int p = 0; p < state.particles.size(); ++p)
    {
      if (among.group != 0 && group(p) != among.group)
        continue;
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = position(p, d);
      int& own = material_[cellOf(x)];
      own = own == nothing || own == edge || own == material(p) ? material(p) : several;
      for (int corner = 0; corner < 1 << D; ++corner)
      {
        Vector<D> at = x;
        for (int d = 0; d < D; ++d)
          at[d] += ((corner >> d & 1) != 0 ? within : -within) * edges(p, d);
        int& reached = material_[cellOf(at)];
        reached = reached == nothing ? edge : reached;
      }
    }
  }

  /// Number of the material of the particles that have their centres in the cell of a position, `several`,
  /// `edge` where particles only reach into it, or `nothing`; `nothing` outside of the domain.
  int at(const Vector<D>& x) const { return grid_.inside(x) ? material_[cellOf(x)] : nothing; }

  /// The material on one side of a position: of the first cell of one material, within two cells.
  int nextTo(const Vector<D>& x, const Vector<D>& across) const
  {
    for (int k = 1; k <= 4; ++k)
      if (const int here = at(x + (0.5 * k * grid_.spacing) * across); here >= 0)
        return here;
    return nothing;
  }

private:
  int cellOf(const Vector<D>& x) const
  {
    int at[D];
    for (int d = 0; d < D; ++d)
      at[d] = std::clamp(static_cast<int>(std::floor(grid_.inCells(x[d], d))), 0, grid_.cells[d] - 1);
    return grid_.nodeIndex(at);
  }

  const Grid<D>& grid_;
  std::vector<int> material_;
};

/// Cells behind a front at which the crack, too, lies on the border that it runs along. A crack that comes to
/// a border at 14 degrees or more is a cell away from it there.
constexpr int behind = 4;

/// Whether a crack has lain on the border of two materials for some cells: its toughness is then that of the
/// border, whatever material the front is in.
template <int D>
bool liesAlongBorder(const State<D>& state, const MaterialOfCells<D>& cells, const FrontNode<D>& node)
{
  const double h = state.mesh.grid.spacing;
  if (!differ(state, cells.nextTo(node.position, node.normal),
              cells.nextTo(node.position, -1.0 * node.normal)))
    return false;
  for (int k = behind; k > 0; --k)
  {
    const Vector<D> x = node.position - (k * h) * node.direction;
    const int one = cells.nextTo(x, node.normal), other = cells.nextTo(x, -1.0 * node.normal);
    if (one >= 0 && other >= 0) // a short crack may begin at a surface nearer than that
      return differ(state, one, other);
  }
  return true;
}

/// The same while fronts grow, from the particles nearest to points a cell away. Collective.
template <int D>
bool runsAlongBorder(const State<D>& state, const FrontNode<D>& node, const ParticlesOfGroup& among)
{
  const double h = state.mesh.grid.spacing;
  for (const int k : {0, behind})
  {
    const Vector<D> x = node.position - (k * h) * node.direction;
    if (!differ(state, materialAt(state, x + h * node.normal, among),
                materialAt(state, x - h * node.normal, among)))
      return false;
  }
  return true;
}

/// How far a front gets at most up to the end of the run [m]. \param own its material
template <int D>
double reachOf(const Teuchos::ParameterList& scene, const Options& options, const State<D>& state,
               const FrontNode<D>& node, int own)
{
  const double end = scene.sublist("Time").get<double>("Final Time");
  if (state.method.analysis == Analysis::LoadFactor) // an increment a load step
    return std::round(end / largestLoadStep(scene)) * options.cells * spacingAt(state, node.position);
  if (options.equilibrium)
    return std::numeric_limits<double>::infinity();
  const double speed =
      options.speedLimit > 0.0 ? options.speedLimit : rayleighSpeed(state.materials.properties[own]);
  return speed * std::max(0.0, end - options.rule.startTime);
}

/// What a front node meets first straight ahead of it.
struct Ahead
{
  int own = -1, other = -1; ///< numbers of materials; -1: none
  double distance = 0.0;    ///< [m]
};

template <int D>
Ahead materialAheadOf(const Teuchos::ParameterList& scene, const Options& options, const State<D>& state,
                      const MaterialOfCells<D>& cells, const FrontNode<D>& node)
{
  // Across a cell that nothing reaches bodies have no node in common. The line cuts corners of empty cells,
  // too, which do not count.
  constexpr double step = 0.25, apart = 0.75; // cells
  const Grid<D>& grid = state.mesh.grid;
  Ahead ahead;
  if (liesAlongBorder(state, cells, node))
    return ahead;
  for (int k = 0; k < 16 && ahead.own < 0; ++k) // behind the front, whose own cell may lie on the border
    ahead.own = cells.at(node.position - (step * k * grid.spacing) * node.direction);
  if (ahead.own < 0)
    return ahead;
  const double reach = reachOf(scene, options, state, node, ahead.own) + grid.spacing;
  double gap = 0.0;
  for (int k = 1; gap < apart && step * k * grid.spacing <= reach; ++k)
  {
    const double distance = step * k * grid.spacing;
    const Vector<D> x = node.position + distance * node.direction;
    const int here = cells.at(x);
    if (!grid.inside(x))
      break;
    gap = here == MaterialOfCells<D>::nothing ? gap + step : 0.0;
    if (differ(state, ahead.own, here))
    {
      ahead.other = here;
      ahead.distance = distance;
      break;
    }
  }
  return ahead;
}

/// Of the nodes of a front the one that is closest to another material, of some along it.
template <int D>
Ahead nearestAheadOf(const Teuchos::ParameterList& scene, const Options& options, const State<D>& state,
                     const MaterialOfCells<D>& cells, const CrackFront<D>& front)
{
  constexpr std::size_t most = 32;
  const std::size_t stride = std::max<std::size_t>(1, front.nodes.size() / most);
  Ahead nearest;
  for (std::size_t k = 0; k < front.nodes.size(); k += stride)
    if (const Ahead ahead = materialAheadOf(scene, options, state, cells, front.nodes[k]);
        ahead.other >= 0 && (nearest.other < 0 || ahead.distance < nearest.distance))
      nearest = ahead;
  return nearest;
}

} // namespace

template <int D>
void judgeMaterialsAhead(const Teuchos::ParameterList& scene, const Options& options, State<D>& state)
{
  if (state.materials.properties.size() < 2 || state.cracks.fronts.empty())
    return;
  std::map<int, MaterialOfCells<D>> cellsOf; // by group of bodies
  Messages messages;
  for (const CrackFront<D>& front : state.cracks.fronts)
  {
    const ParticlesOfGroup among = particlesOfCrack(state, front.crack);
    const MaterialOfCells<D>& cells = cellsOf.try_emplace(among.group, state, among).first->second;
    if (const Ahead ahead = nearestAheadOf(scene, options, state, cells, front); ahead.other >= 0)
      messages.push_back(
          toughnessText(state, options) + ", and straight ahead of " + frontName(state.cracks, front) +
          " in Materials > " + state.materials.names[ahead.own] + " begins, after about " +
          readableLength(ahead.distance) + ", " + comparedText(state, ahead.own, ahead.other) +
          ": if the front comes there, a warning says when, and later results are not those "
          "of " +
          state.materials.names[ahead.other] + "; use the results before that, or end the run before (" +
          (state.method.analysis == Analysis::LoadFactor ? "Time > Load Steps" : "Time > Final Time") + ")");
  }
  for (const std::string& message : firstTen(messages))
    state.warnings.push_back(message);
}

template <int D>
void warnOfOtherMaterial(const Options& options, const CrackFront<D>& front, const FrontNode<D>& node,
                         const Vector<D>& by, State<D>& state)
{
  if (state.materials.properties.size() < 2)
    return;
  // The warnings are part of checkpoints, so that a front of a run that continues is not named again.
  const std::string start = frontName(state.cracks, front) + ": it comes into Materials > ";
  if (std::any_of(state.warnings.begin(), state.warnings.end(),
                  [&](const std::string& warning) { return warning.rfind(start, 0) == 0; }))
    return;
  const Vector<D> to = node.position + by;
  const ParticlesOfGroup among = particlesOfCrack(state, front.crack);
  const int own = materialAt(state, node.position, among), other = materialAt(state, to, among);
  if (!differ(state, own, other) || runsAlongBorder(state, node, among))
    return;
  const std::string when = state.method.analysis == Analysis::LoadFactor
                               ? "in load step " + std::to_string(state.clock.step)
                               : "at t = " + readableTime(state.clock.time);
  state.warnings.push_back(start +
                           comparedText(state, own, other).substr(std::string("Materials > ").size()) + " " +
                           when + ", at " + formatPoint(to) + ", but " + toughnessText(state, options) +
                           ": its path, speed and energy from there on are not those of " +
                           state.materials.names[other] + "; use the results before that only");
}

template void judgeMaterialsAhead(const Teuchos::ParameterList&, const Options&, State<2>&);
template void judgeMaterialsAhead(const Teuchos::ParameterList&, const Options&, State<3>&);
template void warnOfOtherMaterial(const Options&, const CrackFront<2>&, const FrontNode<2>&, const Vector<2>&,
                                  State<2>&);
template void warnOfOtherMaterial(const Options&, const CrackFront<3>&, const FrontNode<3>&, const Vector<3>&,
                                  State<3>&);

} // namespace Rhegma::propagation
