#include "energy_release/DomainIntegral.hpp"

#include "energy_release/CrackPath.hpp"
#include "energy_release/CrackTipFields.hpp"
#include "energy_release/FaceTractions.hpp"
#include "energy_release/FrontDisk.hpp"
#include "energy_release/ParticleHeat.hpp"
#include "energy_release/ParticleMotion.hpp"
#include "material/MaterialTable.hpp"
#include "material/Materials.hpp"
#include "state/NodalValues.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearestMaterial.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::energy_release
{

namespace
{

constexpr int D = 2;

/// Angle of a position around the front in the front's frame; the side of a particle decides on which face it
/// is.
KOKKOS_INLINE_FUNCTION double tipAngle(double along, double across, int side)
{
  const double halfTurn = 4.0 * std::atan(1.0);
  const double theta = std::atan2(across, along);
  if (side > 0 && theta < -0.75 * halfTurn)
    return theta + 2.0 * halfTurn;
  if (side < 0 && theta > 0.75 * halfTurn)
    return theta - 2.0 * halfTurn;
  return theta;
}

/// Williams' fields of the two modes at a particle.
struct Pair
{
  double interaction[2] = {0.0, 0.0};
  double reciprocal[2] = {0.0, 0.0};
};

/// Sums the integrands of one particle.
template <ShapeKind S, bool Stored>
struct Integrand
{
  Connectivity<D, S, Stored> broken;
  View<int*> parent; ///< node of each enriched field
  int numFirst;      ///< nodes before them
  NodalWeight<D> weight;
  NodalVelocity<D> motion;
  NodalAcceleration<D> acceleration;
  BorrowedView<double*[D]> position, reference;
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<double * [symmetricSize<D>]> stress;
  BorrowedView<double**> history;
  BorrowedView<int*> material, side;
  View<Properties*> materials;
  ParticleHeat<D> heat;
  FrontDisk disk;
  Vector<D> tip; ///< of Williams' field
  Vector<D> direction, normal;
  int positive, negative; ///< names of the crack's sides
  bool sides, moving;
  bool intensities; ///< false: only J is wanted
  CrackPath path;

  KOKKOS_INLINE_FUNCTION void operator()(int p, double& J, double& modeI, double& modeII, double& reciprocalI,
                                         double& reciprocalII) const
  {
    const Vector<D> centre = weight.centre;
    // A stencil reaches at most 2.5 cells along each axis.
    if (distance(position, p, centre) > weight.radii.outer + 4.0 * weight.positions.grid.spacing)
      return;
    // Interpolated like the motion, a weighted shift of the body is a motion that the cells can represent:
    // stresses in equilibrium do no work on it, for any rotation of the body next to the crack
    // (docs/broken_cells.md).
    double q = 0.0;
    Vector<D> dq{{0.0, 0.0}};
    broken.visit(p,
                 [&](int node, double fraction, const double* slope)
                 {
                   const double at = weight(node < numFirst ? node : parent(node - numFirst));
                   q += fraction * at;
                   for (int d = 0; d < D; ++d)
                     dq[d] += slope[d] * at;
                 });
    if (q == 0.0 && dq[0] == 0.0 && dq[1] == 0.0)
      return;
    ParticleMotion<D> is;
    if (moving)
      is = particleMotion(broken, p, motion, acceleration, disk.velocity);
    const Vector<D>&v = is.v, &a = is.a;
    const auto& dv = is.dv;

    const double* F = &deformation(p, 0);
    // The direction in the undeformed disk, its image, and u,1 relative to the turned disk.
    const Vector<D> material1{{disk.cosine * direction[0] + disk.sine * direction[1],
                               -disk.sine * direction[0] + disk.cosine * direction[1]}};
    const Vector<D> image{
        {F[0] * material1[0] + F[1] * material1[1], F[2] * material1[0] + F[3] * material1[1]}};
    const Vector<D> du = image - direction;
    const Vector<D> dv1{
        {dv[0][0] * image[0] + dv[0][1] * image[1], dv[1][0] * image[0] + dv[1][1] * image[1]}};
    // P_iJ q,J in undeformed space is tau_ij q,j in 3D.
    const double* tau = &stress(p, 0);
    const Vector<D> flux{{tau[0] * dq[0] + tau[2] * dq[1], tau[2] * dq[0] + tau[1] * dq[1]}};
    const double density = mass(p) / volume(p);
    const double* variables = history.extent(1) > 0 ? &history(p, 0) : nullptr;
    const Properties& law = materials(material(p));
    const double energy = heat.energy(p, material(p), law, F, variables) + 0.5 * density * dot(v, v);
    if (path.count == 0)
      J += volume(p) * (dot(flux, du) - energy * dot(dq, image) +
                        (density * (dot(a, du) - dot(v, dv1)) -
                         heat.energyAlong(p, material(p), law, F, tau, variables, image)) *
                            q);
    else
      J += volume(p) * alongPath(p, F, tau, energy, density, v, a, dv);
    if (!intensities)
      return;
    const Pair sum = interaction(p, q, dq, flux, du, density, a, image);
    modeI += sum.interaction[0];
    modeII += sum.interaction[1];
    reciprocalI += sum.reciprocal[0];
    reciprocalII += sum.reciprocal[1];
  }

  /// The same with a weight that is a vector along the crack: the sum over both axes of the integrand in the
  /// direction of the axis with the weight's component.
  KOKKOS_INLINE_FUNCTION double alongPath(int p, const double* F, const double* tau, double energy,
                                          double density, const Vector<D>& v, const Vector<D>& a,
                                          const double (&dv)[D][D]) const
  {
    double Q[D] = {}, dQ[D][D] = {};
    broken.visit(p,
                 [&](int node, double fraction, const double* slope)
                 {
                   const int lattice = node < numFirst ? node : parent(node - numFirst);
                   const double at = weight(lattice);
                   if (at == 0.0)
                     return;
                   const Vector<D> shift = at * path(weight.positions(lattice));
                   for (int k = 0; k < D; ++k)
                   {
                     Q[k] += fraction * shift[k];
                     for (int d = 0; d < D; ++d)
                       dQ[k][d] += slope[d] * shift[k];
                   }
                 });
    double sum = 0.0;
    for (int k = 0; k < D; ++k)
    {
      // The axis in the undeformed disk, its image, and u,k relative to the turned disk.
      const Vector<D> axis{{k == 0 ? 1.0 : 0.0, k == 0 ? 0.0 : 1.0}};
      const Vector<D> before{
          {disk.cosine * axis[0] + disk.sine * axis[1], -disk.sine * axis[0] + disk.cosine * axis[1]}};
      const Vector<D> image{{F[0] * before[0] + F[1] * before[1], F[2] * before[0] + F[3] * before[1]}};
      const Vector<D> du = image - axis;
      const Vector<D> dvk{
          {dv[0][0] * image[0] + dv[0][1] * image[1], dv[1][0] * image[0] + dv[1][1] * image[1]}};
      const Vector<D> slope{{dQ[k][0], dQ[k][1]}};
      const Vector<D> flux{{tau[0] * slope[0] + tau[2] * slope[1], tau[2] * slope[0] + tau[1] * slope[1]}};
      const double* variables = history.extent(1) > 0 ? &history(p, 0) : nullptr;
      sum += dot(flux, du) - energy * dot(slope, image) +
             (density * (dot(a, du) - dot(v, dvk)) -
              heat.energyAlong(p, material(p), materials(material(p)), F, tau, variables, image)) *
                 Q[k];
    }
    return sum;
  }

  /// Displacement relative to the disk's mean motion and turn, as `du` is.
  KOKKOS_INLINE_FUNCTION Vector<D> displacement(int p) const
  {
    const double x = reference(p, 0) - disk.reference[0], y = reference(p, 1) - disk.reference[1];
    return {{position(p, 0) - disk.position[0] - disk.cosine * x + disk.sine * y,
             position(p, 1) - disk.position[1] - disk.sine * x - disk.cosine * y}};
  }

  KOKKOS_INLINE_FUNCTION Pair interaction(int p, double q, const Vector<D>& dq, const Vector<D>& flux,
                                          const Vector<D>& du, double density, const Vector<D>& a,
                                          const Vector<D>& image) const
  {
    Pair sum;
    const Vector<D> from{{position(p, 0) - tip[0], position(p, 1) - tip[1]}};
    const double along = dot(from, direction), across = dot(from, normal);
    const double r = std::sqrt(along * along + across * across);
    if (!(r > 0.0))
      return sum;
    const int named = sides ? side(p) : 0;
    const double theta = tipAngle(along, across, named == positive ? 1 : (named == negative ? -1 : 0));
    const double fluxIn[2] = {dot(flux, direction), dot(flux, normal)};
    const double slopeIn[2] = {dot(dq, direction), dot(dq, normal)};
    const double duIn[2] = {dot(du, direction), dot(du, normal)};
    const double aIn[2] = {dot(a, direction), dot(a, normal)};
    const Vector<D> u = displacement(p);
    const double uIn[2] = {dot(u, direction), dot(u, normal)};
    const double* tau = &stress(p, 0);
    const Vector<D> pull{
        {tau[0] * direction[0] + tau[2] * direction[1], tau[2] * direction[0] + tau[1] * direction[1]}};
    const Vector<D> lift{{tau[0] * normal[0] + tau[2] * normal[1], tau[2] * normal[0] + tau[1] * normal[1]}};
    const double s11 = dot(pull, direction), s12 = dot(pull, normal), s22 = dot(lift, normal);
    const bool warm = heat.strains(material(p));
    const double expanded = warm ? heat.strain(p, material(p)) : 0.0;
    const double expansionAlong = warm ? heat.expansion(p, material(p)) * heat.alongImage(p, image) : 0.0;
    for (int mode = 0; mode < 2; ++mode)
    {
      const TipField w = williamsField(mode, r, theta, disk.moduli);
      double m = -slopeIn[0] * (s11 * w.gradient[0][0] + s22 * w.gradient[1][1] +
                                s12 * (w.gradient[0][1] + w.gradient[1][0]));
      double reciprocal = 0.0;
      for (int i = 0; i < 2; ++i)
      {
        const double pulled = fluxIn[i], pushed = density * aIn[i] * q;
        m += (pulled + pushed) * w.gradient[i][0];
        reciprocal += (pulled + pushed) * w.displacement[i];
        for (int j = 0; j < 2; ++j)
        {
          m += w.stress[i][j] * duIn[i] * slopeIn[j];
          reciprocal -= w.stress[i][j] * uIn[i] * slopeIn[j];
        }
      }
      const double traced = disk.traceFactor * (w.stress[0][0] + w.stress[1][1]) * q;
      m += expansionAlong * traced;
      reciprocal -= expanded * traced;
      sum.interaction[mode] = volume(p) * m;
      sum.reciprocal[mode] = volume(p) * reciprocal;
    }
    return sum;
  }
};

/// Offset from the crack, along the normal of the front, of the cut between the particles, where the weight
/// falls: particles stand for their boxes, so that it is midway between the nearest above and the nearest
/// below. With the hat (1 - |z| / h) about the crack, the sums of volume on its two sides differ by 2 h times
/// the offset per h^2. Zero where particles have no sides.
double offsetAside(const State<D>& state, const CrackFront<D>& front, const ContourRadii& radii)
{
  if (!state.particles.has(fields::side))
    return 0.0;
  const auto side = state.particles.integer(fields::side);
  const auto position = state.particles.real<D>(fields::position);
  const auto volume = state.particles.scalar(fields::volume);
  const Vector<D> tip = front.position, direction = front.direction, normal = front.normal;
  const double cell = spacingAt(state, front.position), from = radii.inner, to = radii.outer + cell;
  const int name = front.crack + 1;
  double sums[2] = {}; // of volume above and below
  Kokkos::parallel_reduce(
      "rhegma::offsetAside", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& up, double& down) {
        const Vector<D> away{{position(p, 0) - tip[0], position(p, 1) - tip[1]}};
        const double behind = -dot(away, direction), z = std::fabs(dot(away, normal));
        if ((side(p) != name && side(p) != -name) || behind < from || behind > to || z > cell)
          return;
        (side(p) == name ? up : down) += volume(p) * (1.0 - z / cell);
      },
      sums[0], sums[1]);
  sumParts(state, sums, 2);
  const double above = sums[0], below = sums[1];
  return above + below > 0.0 ? 0.5 * cell * (below - above) / (above + below) : 0.0;
}

/// Intensities by Williams' field about the tip of the crack in the cells. Each iteration finds the remaining
/// offset, which falls by a factor of 50 or so.
template <class Work>
DomainIntegral integrateAboutTip(const State<D>& state, const CrackFront<D>& front, Work& work)
{
  const FaceTractions pressure(state, front, work.weight, pressedPieces(state, front), OpeningBy::Nodes);
  FaceTractions contact(state, front, work.weight, touchingPieces(state, front), OpeningBy::Faces);
  const bool closed = contact.closed();
  if (closed)
    contact.takeMean();
  constexpr int turns = 4;
  const double most = spacingAt(state, front.position), enough = 1e-3 * most;
  const double thickness = state.method.thickness, scale = 0.5 * work.disk.effectiveModulus / thickness;
  DomainIntegral sum;
  const Vector<D> middle = front.position + offsetAside(state, front, work.weight.radii) * front.normal;
  for (int turn = 1;; ++turn)
  {
    work.tip = middle + sum.tipOffset * front.direction;
    double sums[5] = {}; // J, both intensities, both reciprocal integrals
    Kokkos::parallel_reduce("rhegma::domainIntegral",
                            Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()), work, sums[0], sums[1],
                            sums[2], sums[3], sums[4]);
    sumParts(state, sums, 5);
    const FaceTractions::Interaction pressed = pressure.interaction(sum.tipOffset, work.disk.moduli),
                                     touching = contact.interaction(sum.tipOffset, work.disk.moduli);
    // The tractions of closed faces are those with which K_I is that of their opening: the integral over the
    // particles scatters less than the tractions.
    double corrected = 1.0;
    if (closed && touching.M[0] > 0.0)
      corrected = (contact.intensityOfOpening(sum.tipOffset, work.disk.effectiveModulus) / scale - sums[1]) /
                  (thickness * touching.M[0]);
    sum.J = sums[0] / thickness + pressure.release() + corrected * contact.release();
    if (!work.intensities)
      return sum;
    const auto all = [&](double ofParticles, double ofPressure, double ofContact)
    { return ofParticles + thickness * (ofPressure + ofContact); };
    const double modeI = all(sums[1], pressed.M[0], corrected * touching.M[0]),
                 modeII = all(sums[2], pressed.M[1], corrected * touching.M[1]),
                 reciprocalI = all(sums[3], pressed.R[0], touching.R[0]),
                 reciprocalII = all(sums[4], pressed.R[1], touching.R[1]);
    sum.modeI = scale * modeI;
    sum.modeII = scale * modeII;
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

template <ShapeKind S, bool Stored>
DomainIntegral integrate(const State<D>& state, const CrackFront<D>& front, const ContourRadii& radii,
                         const NodalAcceleration<D>& acceleration, bool intensities,
                         const Connectivity<D, S, Stored>& broken)
{
  Integrand<S, Stored> work;
  work.broken = broken;
  work.parent = state.mesh.nodes.parent;
  work.numFirst = state.mesh.nodes.numLattice;
  work.weight = {nodePositions(state), front.position, radii};
  work.motion = NodalVelocity<D>(state);
  work.acceleration = acceleration;
  work.position = state.particles.template real<D>(fields::position);
  work.reference = state.particles.template real<D>(fields::reference);
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
  work.disk = describeDisk(state, front, radii);
  work.path = crackPathBehind(state, front, radii.outer);
  work.direction = front.direction;
  work.normal = front.normal;
  work.positive = front.crack + 1;
  work.negative = -front.crack - 1;
  work.moving = haveNodalValues(state) && state.mesh.nodes.motion.extent(0) > 0;
  // What closed faces press with follows from their opening (integrateAboutTip).
  work.intensities = intensities || state.cracks.tractions;
  DomainIntegral sum = integrateAboutTip(state, front, work);
  sum.lost = work.disk.empty;
  return sum;
}

} // namespace

DomainIntegral integrateDomain(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                               const NodalAcceleration<2>& acceleration)
{
  DomainIntegral result;
  withConnectivity(state, [&](const auto& broken)
                   { result = integrate(state, front, radii, acceleration, true, broken); });
  return result;
}

std::optional<double> integrateRelease(const State<2>& state, const CrackFront<2>& front,
                                       const ContourRadii& radii, const NodalAcceleration<2>& acceleration)
{
  DomainIntegral result;
  withConnectivity(state, [&](const auto& broken)
                   { result = integrate(state, front, radii, acceleration, false, broken); });
  return result.lost ? std::nullopt : std::optional<double>(result.J);
}

/// Particles in the integrals reach 3 cells beyond the disk, and nodes that they touch are touched by others.
double accelerationReach(const State<2>& state, const ContourRadii& radii)
{
  return radii.outer + 6.0 * state.mesh.grid.spacing;
}

DomainIntegral integrateDomain(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                               InternalAcceleration<2>& acceleration)
{
  return integrateDomain(state, front, radii,
                         acceleration.around(state, {front.position, accelerationReach(state, radii)}));
}

} // namespace Rhegma::energy_release
