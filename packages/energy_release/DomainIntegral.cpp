#include "energy_release/DomainIntegral.hpp"

#include "base/SmallLoops.hpp"
#include "energy_release/DomainIntegrand.hpp"
#include "energy_release/FaceTractions.hpp"
#include "state/NodalValues.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::energy_release
{

namespace
{

constexpr int D = 2;

/// Distance from the front within which particles may have a node in the disk: a box of equal cells touches
/// nodes up to 1.5 cells away along each axis, and others up to 2.5 [m].
double reachOfParticles(const State<D>& state, const ContourRadii& radii)
{
  constexpr double equal = 1.5 * 1.415, other = 4.0;
  const bool isEqual = state.cracks.dualField && !state.mesh.tree.refined();
  return radii.outer + (isEqual ? equal : other) * state.mesh.grid.spacing;
}

/// Offset from the crack, along the normal of the front, of the cut between the particles, where the weight
/// falls: particles stand for their boxes, so that it is midway between the nearest above and the nearest
/// below. With the hat (1 - |z| / h) about the crack, the sums of volume on its two sides differ by 2 h times
/// the offset per h^2. Zero where particles have no sides.
double offsetAside(const State<D>& state, const CrackFront<D>& front, const ContourRadii& radii,
                   const BlocksInReach<D>& blocks)
{
  if (!state.particles.has(fields::side))
    return 0.0;
  const auto side = state.particles.integer(fields::side);
  const auto position = state.particles.real<D>(fields::position);
  const auto volume = state.particles.scalar(fields::volume);
  const Vector<D> tip = front.position, direction = front.direction, normal = front.normal;
  const double cell = spacingAt(state, front.position), from = radii.inner, to = radii.outer + cell;
  const int name = front.crack + 1;
  double sums[2]; // of volume above and below
  blocks.sumOverParticles(
      "rhegma::offsetAside",
      KOKKOS_LAMBDA(const int p, double(&sum)[2]) {
        const Vector<D> away{{position(p, 0) - tip[0], position(p, 1) - tip[1]}};
        const double behind = -dot(away, direction), z = std::fabs(dot(away, normal));
        if ((side(p) == name || side(p) == -name) && behind >= from && behind <= to && z <= cell)
          sum[side(p) == name ? 0 : 1] += volume(p) * (1.0 - z / cell);
      },
      sums);
  sumParts(state, sums, 2);
  const double above = sums[0], below = sums[1];
  return above + below > 0.0 ? 0.5 * cell * (below - above) / (above + below) : 0.0;
}

/// The thermal part of an interaction integral near the front. \param sums of the particles
template <class Work>
double heatOfMode(const Work& work, const double* sums, int mode)
{
  return work.nearFront.near(sums + Work::heatAt + HeatNearFront::numSums * (1 + mode),
                             mode == 0 ? 0.5 : 1.0);
}

/// What springs behind the front of an axisymmetric scene add to J [J]: a shift along the radius makes their
/// ring, and so their energy, larger.
double releaseOfSprings(const State<D>& state, const CrackFront<D>& front, const NodalWeight<D>& weight)
{
  const View<double*> energy = state.cracks.springEnergy;
  if (energy.extent(0) == 0)
    return 0.0;
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  const double along = front.direction[0];
  double sum = parallelSumSmall<double>(
      "rhegma::releaseOfSprings", nodes.numOfCracks, KOKKOS_LAMBDA(const int i, double& part) {
        const int primary = nodes.parent(i);
        const double radius = positions(primary)[0];
        if (radius > 0.0 && isOwnedByThisRank(nodes, primary))
          part -= energy(primary) * weight(primary) * along / radius;
      });
  sumParts(state, &sum, 1);
  return sum;
}

/// What corrects that of J [J] (HeatNearFront.hpp).
template <class Work>
double heatOfRelease(const Work& work, const double* sums, double modeI, double modeII)
{
  constexpr int count = HeatNearFront::numSums;
  const double* ofJ = sums + Work::heatAt;
  double near = -ofJ[0], remainder[count] = {0.0, ofJ[1], ofJ[2]};
  for (int mode = 0; mode < 2; ++mode)
  {
    const double intensity = mode == 0 ? modeI : modeII;
    near += intensity * heatOfMode(work, sums, mode);
    for (int k = 1; k < count; ++k)
      remainder[k] -= intensity * ofJ[count * (1 + mode) + k];
  }
  return near + work.nearFront.nearOfRemainder(remainder, work.nearFront.moduliVary);
}

/// Stress intensities from half of both interaction integrals, the derivatives of J by them.
void setIntensities(const CrackCompliance& c, double modeI, double modeII, DomainIntegral& sum)
{
  const double determinant = c.modeI * c.modeII - c.coupled * c.coupled;
  sum.modeI = (c.modeII * modeI - c.coupled * modeII) / determinant;
  sum.modeII = (c.modeI * modeII - c.coupled * modeI) / determinant;
}

/// Scales intensities such that they release J. The singular fields of plane strain, which the interaction
/// integrals take, are not those of rings: they give the ratio of the modes, which differs from the right one
/// by the order of the disk's radius over that of the front, and the sign.
void fitToRelease(const CrackCompliance& c, DomainIntegral& sum)
{
  const double released = c.modeI * sum.modeI * sum.modeI + 2.0 * c.coupled * sum.modeI * sum.modeII +
                          c.modeII * sum.modeII * sum.modeII;
  if (!(sum.J > 0.0) || !(released > 0.0))
    return;
  const double factor = std::sqrt(sum.J / released);
  sum.modeI *= factor;
  sum.modeII *= factor;
}

/// Intensities by the singular fields about the tip of the crack in the cells. Each iteration finds the
/// remaining offset, which falls by a factor of 50 or so.
template <class Work>
DomainIntegral integrateAboutTip(const State<D>& state, const CrackFront<D>& front,
                                 const NodalWeight<D>& weight, const BlocksInReach<D>& blocks, Work& work)
{
  const FaceTractions pressure(state, front, weight, pressedPieces(state, front), OpeningBy::Nodes);
  FaceTractions contact(state, front, weight, touchingPieces(state, front), OpeningBy::Faces);
  const bool closed = contact.closed();
  if (closed)
    contact.takeMean();
  constexpr int turns = 4;
  const double most = spacingAt(state, front.position), enough = 1e-3 * most;
  const double thickness = state.method.depth().at(front.position[0]), scale = 0.5 / thickness;
  DomainIntegral sum;
  double releaseOfParticles = 0.0;
  const double ofSprings = work.axisymmetric ? releaseOfSprings(state, front, weight) : 0.0;
  Vector<D> middle = front.position;
  if (work.intensities)
    middle = middle + offsetAside(state, front, weight.radii, blocks) * front.normal;
  for (int turn = 1;; ++turn)
  {
    work.tip = middle + sum.tipOffset * front.direction;
    double sums[Work::numSums];
    blocks.sum("rhegma::domainIntegral", work, sums);
    sumParts(state, sums, Work::numSums);
    // J does not depend on the tip, but for what is corrected near it.
    releaseOfParticles = work.release ? sums[0] + ofSprings : releaseOfParticles;
    work.release = work.nearFront.corrects();
    for (int mode = 0; mode < 2 && work.nearFront.corrects(); ++mode)
      sums[1 + mode] +=
          heatOfMode(work, sums, mode) - sums[Work::heatAt + HeatNearFront::numSums * (1 + mode)];
    const FaceTractions::Interaction pressed = pressure.interaction(sum.tipOffset, work.disk.compliance),
                                     touching = contact.interaction(sum.tipOffset, work.disk.compliance);
    // The tractions of closed faces are those with which K_I is that of their opening: the integral over the
    // particles scatters less than the tractions.
    double corrected = 1.0;
    if (closed && touching.M[0] > 0.0)
      corrected =
          (contact.halfInteractionOfOpening(sum.tipOffset) / scale - sums[1]) / (thickness * touching.M[0]);
    sum.J = releaseOfParticles / thickness + pressure.release() + corrected * contact.release();
    if (!work.intensities)
      return sum;
    const auto all = [&](double ofParticles, double ofPressure, double ofContact)
    { return ofParticles + thickness * (ofPressure + ofContact); };
    const double modeI = all(sums[1], pressed.M[0], corrected * touching.M[0]),
                 modeII = all(sums[2], pressed.M[1], corrected * touching.M[1]),
                 reciprocalI = all(sums[3], pressed.R[0], touching.R[0]),
                 reciprocalII = all(sums[4], pressed.R[1], touching.R[1]);
    setIntensities(work.disk.compliance, scale * modeI, scale * modeII, sum);
    if (work.nearFront.corrects())
      sum.J += heatOfRelease(work, sums, sum.modeI, sum.modeII) / thickness;
    if (work.axisymmetric)
      fitToRelease(work.disk.compliance, sum);
    const double square = modeI * modeI + modeII * modeII;
    if (turn == turns || !(square > 0.0))
      return sum;
    // Without a singular field, as before a wave arrives, noise has no tip: limit the offset to the cells
    // around the front.
    const double next = sum.tipOffset + (reciprocalI * modeI + reciprocalII * modeII) / square;
    const double offset = next > most ? most : (next < -most ? -most : next);
    if (std::fabs(offset - sum.tipOffset) < enough)
      return sum;
    sum.tipOffset = offset;
  }
}

/// Corrects nothing if the stress of no material depends on temperature.
HeatNearFront heatNearFront(const State<D>& state, const Vector<D>& front, const ContourRadii& radii)
{
  const auto materials = onHost(state.materials.thermo.material);
  bool strains = false, tabulated = false;
  for (std::size_t m = 0; m < materials.extent(0); ++m)
  {
    strains = strains || materials(m).coupled;
    tabulated = tabulated || (materials(m).coupled && materials(m).count > 1);
  }
  if (!strains)
    return {};
  HeatNearFront near(spacingAt(state, front), radii.inner, radii.outer);
  near.moduliVary = tabulated;
  return near;
}

/// What is integrated over particles, but for the values of nodes and what the disk and the front are.
template <ShapeKind S, bool Stored>
domainIntegrand::Integrand<S, Stored> integrandOf(const State<D>& state,
                                                  const Connectivity<D, S, Stored>& broken)
{
  domainIntegrand::Integrand<S, Stored> work;
  work.broken = broken;
  work.place = ParticlePlace<D>(state.particles);
  work.frame = CellFrame<D>(state);
  work.mass = state.particles.scalar(fields::mass);
  work.volume = state.particles.scalar(fields::volume);
  work.deformation = state.particles.template real<gradientSize<D>>(fields::deformation);
  work.stress = state.particles.template real<symmetricSize<D>>(fields::stress);
  if (state.particles.has(fields::history))
    work.history = state.particles.table(fields::history);
  work.material = state.particles.integer(fields::material);
  work.sides = state.particles.has(fields::side);
  if (work.sides)
    work.side = state.particles.integer(fields::side);
  work.materials = state.materials.device;
  work.heat = ParticleHeat<D>(state);
  work.axisymmetric = state.method.axisymmetric;
  work.moving = haveNodalValues(state) && state.mesh.nodes.motion.extent(0) > 0;
  return work;
}

/// \param intensities whether K is wanted too
DomainIntegral integrate(const State<D>& state, const CrackFront<D>& front, const ContourRadii& radii,
                         const NodalAcceleration<D>& acceleration, bool intensities, const FrontWork<2>& kept)
{
  DomainIntegral sum;
  withConnectivity(state,
                   [&](const auto& broken)
                   {
                     auto work = integrandOf(state, broken);
                     const NodalWeight<D> weight{nodePositions(state), front.position, radii};
                     const CrackPath path = crackPathBehind(state, front, radii.outer);
                     work.centre = front.position;
                     work.reach = reachOfParticles(state, radii);
                     work.direction = front.direction;
                     work.normal = front.normal;
                     work.positive = front.crack + 1;
                     work.negative = -front.crack - 1;
                     work.bent = path.count > 0;
                     if (!work.bent)
                       work.nearFront = heatNearFront(state, front.position, radii);
                     // What closed faces press with follows from their opening (integrateAboutTip).
                     work.intensities = intensities || state.cracks.tractions || work.nearFront.corrects();
                     kept.blocks.find(state, {boxAround(front.position, work.reach)},
                                      particlesOfCrack(state, front.crack));
                     work.disk = describeDisk(state, front, radii, work.intensities, kept.blocks);
                     const Region<D> nodes = nodesOf(state, boxAround(front.position, work.reach));
                     work.rows = kept.rows.fill(state, nodes, work.moving, acceleration, weight, path);
                     sum = integrateAboutTip(state, front, weight, kept.blocks, work);
                     sum.lost = work.disk.empty;
                   });
  return sum;
}

} // namespace

DomainIntegral integrateDomain(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                               const NodalAcceleration<2>& acceleration)
{
  FrontRowTable<2> rows;
  BlocksInReach<2> blocks;
  return integrateDomain(state, front, radii, acceleration, FrontWork<2>{rows, blocks});
}

DomainIntegral integrateDomain(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                               const NodalAcceleration<2>& acceleration, const FrontWork<2>& kept)
{
  return integrate(state, front, radii, acceleration, true, kept);
}

std::optional<double> integrateRelease(const State<2>& state, const CrackFront<2>& front,
                                       const ContourRadii& radii, const NodalAcceleration<2>& acceleration)
{
  FrontRowTable<2> rows;
  BlocksInReach<2> blocks;
  return integrateRelease(state, front, radii, acceleration, FrontWork<2>{rows, blocks});
}

std::optional<double> integrateRelease(const State<2>& state, const CrackFront<2>& front,
                                       const ContourRadii& radii, const NodalAcceleration<2>& acceleration,
                                       const FrontWork<2>& kept)
{
  const DomainIntegral result = integrate(state, front, radii, acceleration, false, kept);
  return result.lost ? std::nullopt : std::optional<double>(result.J);
}

/// Particles in the integrals reach 3 cells beyond the disk, and nodes that they touch are touched by others.
Disk accelerationRange(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii)
{
  return {front.position, radii.outer + 6.0 * state.mesh.grid.spacing};
}

DomainIntegral integrateDomain(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                               InternalAcceleration<2>& acceleration)
{
  return integrateDomain(state, front, radii,
                         acceleration.around(state, accelerationRange(state, front, radii)));
}

} // namespace Rhegma::energy_release
