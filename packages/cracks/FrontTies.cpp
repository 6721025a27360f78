#include "cracks/FrontTies.hpp"

#include "archive/Archive.hpp"
#include "base/FewItems.hpp"
#include "cracks/HoldingForce.hpp"
#include "cracks/NearestFront.hpp"
#include "material/MaterialTable.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::cracks
{

namespace
{

constexpr double factor = 0.1;  ///< of E'
constexpr double offset = 0.05; ///< [cells]
constexpr double full = 0.9;    ///< share of a node's cells that counts as all: strain changes it by less

/// A tie with less stretch than this holds no energy to speak of and may stiffen [cells]. Beyond round-off,
/// so that ties are the same on any number of ranks.
constexpr double unstretched = 1e-6;

/// Whether a tie is stretched by more than round-off, beside cells of this size.
template <int D>
KOKKOS_INLINE_FUNCTION bool stretched(const View<double* [D]>& jump, int own, double cell)
{
  double square = 0.0;
  for (int d = 0; d < D; ++d)
    square += jump(own, d) * jump(own, d);
  return square > unstretched * unstretched * cell * cell;
}

/// Makes a cohesive force of a stretched tie: from its force at its stretch j it falls to zero over another
/// |j|. \return the energy that it holds, which no longer is elastic energy of ties [J]
template <int D>
KOKKOS_INLINE_FUNCTION double softenTie(const View<double * [D + 4]>& cohesive, const View<double* [D]>& jump,
                                        int own, double stiffness)
{
  double square = 0.0;
  for (int d = 0; d < D; ++d)
    square += jump(own, d) * jump(own, d);
  if (!(square > 0.0))
    return 0.0;
  const double size = std::sqrt(square);
  cohesive(own, cohesion::peak) = stiffness * size;
  cohesive(own, cohesion::range) = size;
  cohesive(own, cohesion::start) = cohesive(own, cohesion::reached) = size;
  for (int d = 0; d < D; ++d)
    cohesive(own, cohesion::shift + d) = 0.0;
  return 0.5 * stiffness * square;
}

} // namespace

template <int D>
void FrontTies<D>::readMaterials(const State<D>& state)
{
  if (modulus_ > 0.0)
    return;
  modulus_ = std::numeric_limits<double>::infinity();
  for (const Properties& material : state.materials.list)
  {
    modulus_ = std::min(modulus_, elasticity(material).effectiveModulus);
    density_ = std::max(density_, material.density);
  }
}

template <int D>
void FrontTies<D>::placeFronts(const State<D>& state)
{
  const std::vector<CrackFront<D>>& fronts = state.cracks.fronts;
  if (fronts_.extent(0) != fronts.size())
    fronts_ = View<double * [D + 1]>("rhegma::cracks::fronts", fronts.size());
  const auto host = Kokkos::create_mirror_view(fronts_);
  for (std::size_t f = 0; f < fronts.size(); ++f)
  {
    for (int d = 0; d < D; ++d)
      host(f, d) = fronts[f].position[d];
    host(f, D) = (fronts[f].grown ? 1.0 : -1.0) * (1.0 + fronts[f].crack);
  }
  Kokkos::deep_copy(fronts_, host);
}

template <int D>
void FrontTies<D>::note(const std::vector<FrontAdvance<D>>& advances)
{
  for (const FrontAdvance<D>& advance : advances)
  {
    const auto f = static_cast<std::size_t>(advance.front);
    if (toughness_.size() <= f)
      toughness_.resize(f + 1, 0.0);
    toughness_[f] = advance.nodes[0].toughness;
  }
}

template <int D>
void FrontTies<D>::prepare(State<D>& state, const Surroundings& surroundings)
{
  memory_.makeRoom(state);
  readMaterials(state);
  const Nodes<D> nodes = state.mesh.nodes;
  const double spacing = state.mesh.grid.spacing;
  const NodePlaces<D> places = nodePlaces(state);
  const bool refined = state.mesh.tree.refined();
  const View<int*> level = state.mesh.tree.nodeLevel;
  const int firstShort = firstOfShortSteps(state);
  const CrackSight<D> sight(state.cracks, spacing);
  const View<std::uint64_t*> nearest = surroundings.nearest;
  const View<int*> last = memory_.step();
  const View<double* [D]> jump = memory_.jump();
  const View<double * [D + 1]> tie = state.cracks.tie;
  const double modulus = factor * modulus_, thickness = state.method.thickness;
  [[maybe_unused]] const double density = density_;
  const double limit = stable / (state.clock.dt * state.clock.dt);
  const int step = surroundings.stamp;
  const View<double*> stiffness = memory_.stiffness();
  const bool grows = grows_;
  const View<double * [D + 4]> cohesive = memory_.cohesion();
  if (grows)
    placeFronts(state);
  const NearestFront<D> frontOf{fronts_};
  double converted = 0.0;
  sumFew(
      "rhegma::cracks::findTies", 0, nodes.numSecond,
      KOKKOS_LAMBDA(const int i, int& waiting, double& spent) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        const bool fresh = last(own) != step - 1;
        if (fresh)
        {
          stiffness(own) = 0.0;
          for (int d = 0; d < D; ++d)
            jump(own, d) = 0.0;
          // All of it, as checkpoints keep all of it: another node that had this number may have left some.
          for (int k = 0; grows && k < D + 4; ++k)
            cohesive(own, k) = 0.0;
        }
        last(own) = step;
        tie(own, D) = 0.0;
        const int s = simplexOf(nearest(own));
        const double a = nodes.sums(own, Nodes<D>::massAt), b = nodes.sums(other, Nodes<D>::massAt);
        const int halvings = refined && level(own) >= firstShort ? level(own) - firstShort + 1 : 0;
        const double most = a > 0.0 && b > 0.0 ? std::ldexp(limit, 2 * halvings) * a * b / (a + b) : 0.0;
        if (grows)
        {
          if (cohesive(own, cohesion::peak) > 0.0)
          {
            const double now = cohesion::secant(cohesive, own);
            tie(own, D) = now < most ? now : most;
            stiffness(own) = 0.0;
            return;
          }
          const int f = frontOf(places(own), sight.crackOf(s));
          if (f >= 0)
          {
            if (fresh && most > 0.0)
            {
              cohesive(own, cohesion::peak) = -1.0 - f;
              ++waiting;
            }
            else if (stiffness(own) > 0.0)
            {
              const double held = softenTie<D>(cohesive, jump, own, stiffness(own));
              spent += countsHere(nodes, own) ? held : 0.0;
            }
            const bool softened = cohesive(own, cohesion::peak) > 0.0;
            tie(own, D) = stiffness(own) < most ? stiffness(own) : most;
            stiffness(own) = softened ? -1.0 : 0.0; // seen by the sum below, once
            return;
          }
        }
        if (sight.nearFront(s) != nearFront::tied)
        {
          stiffness(own) = 0.0;
          return;
        }
        const Sight seen = sight.look(s, places(own));
        const double cell = refined ? spacing / (1 << level(own)) : spacing;
        double steepest = 0.0;
        for (int d = 0; d < D; ++d)
          steepest = std::fmax(steepest, std::fabs(sight.normal(s, d)));
        const double xi = seen.behind / cell * std::sqrt(steepest) + offset;
        const double away = std::fabs(seen.distance) / (cell * steepest);
        double wanted = 0.0, width = thickness;
        if constexpr (D == 3) // less at the surface, by what of the node's cells is filled
        {
          const double filled = (a + b) / (density * cell * cell * cell);
          width = cell * (filled > full ? 1.0 : filled);
        }
        if (xi < 1.0 && away < 1.0)
          wanted = modulus * width * (1.0 - xi) / xi * (1.0 - away);
        wanted = wanted < most ? wanted : most;
        // A stretched spring that stiffens would make energy.
        if (wanted > stiffness(own) && stretched<D>(jump, own, cell))
          wanted = stiffness(own);
        tie(own, D) = stiffness(own) = wanted;
      },
      waiting_, converted);
  state.energy.fracture += converted;
  if (!grows)
    return;
  if constexpr (D == 3)
    giveBack(state, memory_, fronts_, step);
  sumParts(state, &converted, 1);
  if (!(converted > 0.0))
    return;
  // What these ties held and will take is part of the energy of new faces.
  debt_.resize(state.cracks.fronts.size(), 0.0);
  for (std::size_t f = 0; f < debt_.size(); ++f)
  {
    auto owed = sumFew<double>(
        "rhegma::cracks::energyOfTies", nodes.numSecond, KOKKOS_LAMBDA(const int i, double& sum) {
          const int own = nodes.parent(i);
          if (stiffness(own) < 0.0 && countsHere(nodes, own) &&
              frontOf(places(own), sight.crackOf(simplexOf(nearest(own)))) == static_cast<int>(f))
            sum += cohesive(own, cohesion::peak) * cohesive(own, cohesion::range);
        });
    sumParts(state, &owed, 1);
    if constexpr (D == 2)
      debt_[f] += owed;
    else
      state.cracks.fronts[f].unspent -= owed;
  }
}

template <int D>
void FrontTies<D>::keep(State<D>& state, int step, Archive& archive)
{
  memory_.keep(state, step, archive);
  archive("debts", debt_);
  archive("torn", torn_);
  archive("toughnesses", toughness_);
}

template class FrontTies<2>;
template class FrontTies<3>;

} // namespace Rhegma::cracks
