#include "propagation/MaterialsAhead.hpp"

#include "base/Numbers.hpp"
#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/Judges.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Rhegma::propagation
{

namespace
{

/// Young's modulus of another material over that of one; none where they are the same to a hundredth, and
/// the shear moduli, too: two names of one material may have one toughness.
double stiffnessRatio(const Properties& one, const Properties& other)
{
  constexpr double same = 0.01;
  const Elasticity a = elasticity(one), b = elasticity(other);
  const bool differ = std::fabs(b.young / a.young - 1.0) > same || std::fabs(b.shear / a.shear - 1.0) > same;
  return differ ? b.young / a.young : 0.0;
}

/// "Materials > Steel (its Young's modulus is 70 times that of Materials > Acrylic)".
template <int D>
std::string comparedText(const State<D>& state, int own, int other)
{
  const MaterialSet& materials = state.materials;
  return "Materials > " + materials.names[other] + " (its Young's modulus is " +
         formatShort(stiffnessRatio(materials.properties[own], materials.properties[other])) +
         " times that of Materials > " + materials.names[own] + ")";
}

template <int D>
std::string toughnessText(const State<D>& state, const Options& options)
{
  return "Propagation > Toughness, " + formatShort(options.rule.toughness(0.0, options.temperature)) +
         " J/m2" + (state.method.equilibrium() ? "" : " at rest") + ", is that of all materials";
}

/// The material of each cell.
template <int D>
class MaterialOfCells
{
public:
  static constexpr int nothing = -1, several = -2;

  explicit MaterialOfCells(const State<D>& state) : grid_(state.mesh.grid), material_(grid_.numNodes, nothing)
  {
    const auto position = onHost(state.particles.template real<D>(fields::position));
    const auto material = onHost(state.particles.integer(fields::material));
    for (int p = 0; p < state.particles.size(); ++p)
    {
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = position(p, d);
      int& own = material_[cellOf(x)];
      own = own == nothing || own == material(p) ? material(p) : several;
    }
  }

  /// Number of the material at a position, `nothing` or `several`; `nothing` outside of the domain.
  int at(const Vector<D>& x) const { return grid_.inside(x) ? material_[cellOf(x)] : nothing; }

private:
  int cellOf(const Vector<D>& x) const
  {
    int at[D];
    for (int d = 0; d < D; ++d)
      at[d] = static_cast<int>(std::floor(grid_.inCells(x[d], d)));
    return grid_.nodeIndex(at);
  }

  const Grid<D>& grid_;
  std::vector<int> material_;
};

/// What a front node meets first straight ahead of it.
struct Ahead
{
  int own = -1, other = -1; ///< numbers of materials; -1: none
  double distance = 0.0;    ///< [m]
};

template <int D>
Ahead materialAheadOf(const State<D>& state, const MaterialOfCells<D>& cells, const FrontNode<D>& node)
{
  constexpr double step = 0.5, most = 2.0; // cells; bodies with a gap of two cells share nodes
  const Grid<D>& grid = state.mesh.grid;
  Ahead ahead;
  for (int k = 0; k < 8 && ahead.own < 0; ++k) // behind the front, whose own cell may lie on the border
    ahead.own = cells.at(node.position - (step * k * grid.spacing) * node.direction);
  double gap = 0.0;
  for (int k = 1; ahead.own >= 0 && gap <= most; ++k)
  {
    const double distance = step * k * grid.spacing;
    const Vector<D> x = node.position + distance * node.direction;
    const int here = cells.at(x);
    if (!grid.inside(x))
      break;
    gap = here == MaterialOfCells<D>::nothing ? gap + step : 0.0;
    if (here >= 0 && here != ahead.own &&
        stiffnessRatio(state.materials.properties[ahead.own], state.materials.properties[here]) > 0.0)
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
Ahead nearestAheadOf(const State<D>& state, const MaterialOfCells<D>& cells, const CrackFront<D>& front)
{
  constexpr std::size_t most = 32;
  const std::size_t stride = std::max<std::size_t>(1, front.nodes.size() / most);
  Ahead nearest;
  for (std::size_t k = 0; k < front.nodes.size(); k += stride)
    if (const Ahead ahead = materialAheadOf(state, cells, front.nodes[k]);
        ahead.other >= 0 && (nearest.other < 0 || ahead.distance < nearest.distance))
      nearest = ahead;
  return nearest;
}

} // namespace

template <int D>
void judgeMaterialsAhead(const Options& options, State<D>& state)
{
  if (state.materials.properties.size() < 2 || state.cracks.fronts.empty())
    return;
  const MaterialOfCells<D> cells(state);
  Messages messages;
  for (const CrackFront<D>& front : state.cracks.fronts)
    if (const Ahead ahead = nearestAheadOf(state, cells, front); ahead.other >= 0)
      messages.push_back(
          toughnessText(state, options) + ", and straight ahead of " + frontName(state.cracks, front) +
          " in Materials > " + state.materials.names[ahead.own] + " begins, after about " +
          readableLength(ahead.distance) + ", " + comparedText(state, ahead.own, ahead.other) +
          ": if the front comes there, a warning says when, and later results are not those "
          "of " +
          state.materials.names[ahead.other] + "; use the results before that, or end the run before (" +
          (state.method.analysis == Analysis::LoadFactor ? "Time > Load Steps" : "Time > Final Time") + ")");
  for (const std::string& message : firstTen(messages))
    state.warnings.push_back(message);
}

template <int D>
void warnOfOtherMaterial(const Options& options, const CrackFront<D>& front, const Vector<D>& from,
                         const Vector<D>& by, State<D>& state)
{
  if (state.materials.properties.size() < 2)
    return;
  const int own = materialAt(state, from), other = materialAt(state, from + by);
  if (own == other ||
      !(stiffnessRatio(state.materials.properties[own], state.materials.properties[other]) > 0.0))
    return;
  // The warnings are part of checkpoints, so that a front of a run that continues is not named again.
  const std::string start = frontName(state.cracks, front) + ": it comes into Materials > ";
  if (std::any_of(state.warnings.begin(), state.warnings.end(),
                  [&](const std::string& warning) { return warning.rfind(start, 0) == 0; }))
    return;
  const std::string when = state.method.analysis == Analysis::LoadFactor
                               ? "in load step " + std::to_string(state.clock.step)
                               : "at t = " + readableTime(state.clock.time);
  state.warnings.push_back(
      start + comparedText(state, own, other).substr(std::string("Materials > ").size()) + " " + when +
      ", at " + formatPoint(from + by) + ", but " + toughnessText(state, options) +
      ": its path, speed and energy from there on are not those of " + state.materials.names[other] +
      "; use the results before that only");
}

template void judgeMaterialsAhead(const Options&, State<2>&);
template void judgeMaterialsAhead(const Options&, State<3>&);
template void warnOfOtherMaterial(const Options&, const CrackFront<2>&, const Vector<2>&, const Vector<2>&,
                                  State<2>&);
template void warnOfOtherMaterial(const Options&, const CrackFront<3>&, const Vector<3>&, const Vector<3>&,
                                  State<3>&);

} // namespace Rhegma::propagation
