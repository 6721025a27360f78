#include "cracks/Overlap.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "cracks/Opening.hpp"
#include "material/ThermoTables.hpp"
#include "state/ContactAdvice.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::cracks
{

namespace
{

/// Root mean square of Green's strain of the particles next to a crack, without their thermal strain: a body
/// that cools freely keeps its cracks as they are.
template <int D>
double strainNextTo(const State<D>& state, int crack)
{
  const auto side = state.particles.integer(fields::side);
  const auto F = state.particles.template real<gradientSize<D>>(fields::deformation);
  const ThermoTables tables = state.materials.thermo;
  const bool expands = !tables.empty();
  const auto material = state.particles.integer(fields::material);
  BorrowedView<double*> temperature;
  if (expands)
    temperature = state.particles.scalar(fields::temperature);
  const int name = crack + 1;
  double found[2] = {0.0, 0.0}; // sum of squares, number of particles
  Kokkos::parallel_reduce(
      "rhegma::cracks::strainNextTo", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum, double& number) {
        if (side(p) != name && side(p) != -name)
          return;
        const double free = expands ? ThermoPoint(tables, material(p), temperature(p)).stretch() : 1.0;
        const double half = 0.5 / (free * free);
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j)
          {
            double strain = i == j ? -0.5 : 0.0;
            for (int k = 0; k < D; ++k)
              strain += half * F(p, k * D + i) * F(p, k * D + j);
            sum += strain * strain;
          }
        number += 1.0;
      },
      found[0], found[1]);
  sumParts(state, found, 2);
  return found[1] > 0.0 ? std::sqrt(found[0] / found[1]) : 0.0;
}

template <int D>
Vector<D> firstVertex(const CrackSet<D>& cracks, int crack)
{
  const auto vertex = onHost(cracks.vertex);
  Vector<D> x;
  for (int d = 0; d < D; ++d)
    x[d] = vertex(cracks.cracks[crack].firstVertex, d);
  return x;
}

} // namespace

template <int D>
double noiseOfFaces(const State<D>& state, int crack)
{
  return strainNextTo(state, crack) * spacingAt(state, state.cracks.cracks[crack].numVertices > 0
                                                           ? firstVertex(state.cracks, crack)
                                                           : Vector<D>{});
}

template <int D>
std::string adviceAgainstOverlap(const State<D>& state, int crack, bool startsInEquilibrium)
{
  const bool cuts = !hasFront(state.cracks, crack);
  return (cuts && state.method.equilibrium() ? "it has no front, so that it may cut its body: support each "
                                               "piece (Boundaries), and "
                                             : "") +
         contactAdvice(state, cuts, startsInEquilibrium) +
         (state.method.equilibrium() ? ", or run it with Time > Analysis = Dynamic and Contact" : "");
}

template <int D>
std::string warningOfOverlap(const State<D>& state, int crack, bool startsInEquilibrium)
{
  // A crack of length a that a strain e closes everywhere overlaps by 2 a e. Single vertices follow single
  // nodes, by as much as a cell is strained.
  constexpr double fraction = 1.0, ofLength = 0.2;
  const double least = 1e-9 * state.mesh.grid.spacing;
  const Opening opening = measureOpening(state.cracks, crack);
  const double length = D == 2 ? opening.size : std::sqrt(opening.size);
  const double overlap = -opening.smallest;
  if (!state.ranks.many() && !(overlap > least))
    return {}; // without a look at all particles
  const double strain = strainNextTo(state, crack);
  const double noise = noiseOfFaces(state, crack);
  const bool atRest = state.method.equilibrium() || state.clock.settled; // waves close faces for a while
  const double closed = measureOpening(state.cracks, crack, noise).closed;
  if (!(overlap > least) ||
      !(overlap > fraction * length * strain || (atRest && closed > ofLength * opening.size)))
    return {};
  return "crack " + state.cracks.cracks[crack].name +
         ": its faces overlap at t = " + readableTime(state.clock.time) + " by up to " +
         readableLength(overlap) +
         (closed < 0.005 * opening.size ? " next to single vertices"
          : closed < 0.9 * opening.size
              ? " over " + formatShort(std::round(100.0 * closed / opening.size)) + " % of the crack"
              : "") +
         ", because the scene has no contact; G and K are wrong from then on; " +
         adviceAgainstOverlap(state, crack, startsInEquilibrium);
}

template std::string warningOfOverlap(const State<2>&, int, bool);
template std::string warningOfOverlap(const State<3>&, int, bool);
template double noiseOfFaces(const State<2>&, int);
template double noiseOfFaces(const State<3>&, int);
template std::string adviceAgainstOverlap(const State<2>&, int, bool);
template std::string adviceAgainstOverlap(const State<3>&, int, bool);

} // namespace Rhegma::cracks
