#pragma once
/// The integrands of the domain integrals around a front in 2D.

#include "energy_release/FrontDisk.hpp"
#include "energy_release/FrontRows.hpp"
#include "energy_release/HeatNearFront.hpp"
#include "energy_release/ParticleHeat.hpp"
#include "material/Materials.hpp"
#include "state/CellFrame.hpp"
#include "state/ParticlePlace.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::energy_release
{

namespace domainIntegrand
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

/// Of the fields of the two modes at a particle.
struct Pair
{
  double interaction[2] = {0.0, 0.0};
  double reciprocal[2] = {0.0, 0.0};
  double ofHeat[2] = {0.0, 0.0}; ///< of interaction, for a weight of one
};

/// Sums the integrands of particles: J, both interaction integrals, both reciprocal integrals, and for the
/// first three what corrects their part of heat (HeatNearFront.hpp).
template <ShapeKind S, bool Stored>
struct Integrand
{
  static constexpr int heatAt = 5, numSums = heatAt + 3 * HeatNearFront::numSums;
  Connectivity<D, S, Stored> broken;
  FrontRows<D> rows; ///< of the nodes
  Vector<D> centre;
  double reach; ///< of particles from the centre that count [m]
  ParticlePlace<D> place;
  CellFrame<D> frame;
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<double * [symmetricSize<D>]> stress;
  BorrowedView<double**> history;
  BorrowedView<int*> material, side;
  View<Properties*> materials;
  ParticleHeat<D> heat;
  HeatNearFront nearFront;
  FrontDisk disk;
  Vector<D> tip; ///< of the singular fields
  Vector<D> direction, normal;
  int positive, negative; ///< names of the crack's sides
  bool sides, moving;
  bool bent;                 ///< the weight is a vector along the crack
  bool intensities;          ///< false: only J is wanted
  bool axisymmetric = false; ///< shifts along the radius widen rings
  bool release = true;       ///< false: J, which does not depend on the tip, is not wanted

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end, double (&sums)[numSums]) const
  {
    for (int first = begin; first < end; first += lanes)
    {
      const int last = end - first < lanes ? end : first + lanes;
      int near = 0;
      for (int p = first; p < last; ++p)
        near += isNear(p) ? 1 : 0;
      if (near > 0)
        broken.forEachParticle(first, last,
                               [&](int p, const auto& stencil)
                               {
                                 if (isNear(p))
                                   add(p, stencil, sums);
                               });
    }
  }

  KOKKOS_INLINE_FUNCTION bool isNear(int p) const
  {
    const double x = place.position(p, 0) - centre[0], y = place.position(p, 1) - centre[1];
    return x * x + y * y <= reach * reach;
  }

  /// At a particle.
  struct Motion
  {
    Vector<D> v{}, a{};   ///< velocity relative to the disk, acceleration times weight (FrontRows)
    double dv[D][D] = {}; ///< gradient of velocity
  };

  template <class Stencil>
  KOKKOS_INLINE_FUNCTION void readMotion(const Stencil& stencil, Motion& at) const
  {
    constexpr int width = FrontRows<D>::width;
    const double* const from = rows.data + FrontRows<D>::motionAt;
    Pack<4> change[D];
    const Pack<4> motion = release ? stencil.template valueAndGradient<width>(from, change)
                                   : stencil.template value<width, 4>(from);
    for (int i = 0; i < D; ++i)
    {
      at.v[i] = motion[i] - disk.velocity[i];
      at.a[i] = motion[D + i];
      for (int j = 0; j < D && release; ++j)
        at.dv[i][j] = change[j][i];
    }
  }

  /// Adds what a particle adds to J. \param image of the direction in the cells \param du u,1
  /// \param flux of momentum by the slope of the weight \param hoop strain of the shift \param r distance
  /// from the tip of a particle whose part of heat is corrected [m], else negative
  KOKKOS_INLINE_FUNCTION void addRelease(int p, const Pack<4>& weight, const Pack<4> (&slope)[D],
                                         const Vector<D>& image, const Vector<D>& du, const Vector<D>& flux,
                                         const Motion& motion, double hoop, double r,
                                         double (&sums)[numSums]) const
  {
    const double q = weight[0];
    const Vector<D> dq{{slope[0][0], slope[1][0]}};
    const Vector<D>&v = motion.v, &a = motion.a;
    const auto& dv = motion.dv;
    const Vector<D> dv1{
        {dv[0][0] * image[0] + dv[0][1] * image[1], dv[1][0] * image[0] + dv[1][1] * image[1]}};
    const double *F = &deformation(p, 0), *tau = &stress(p, 0);
    const double density = mass(p) / volume(p);
    const double* variables = history.extent(1) > 0 ? &history(p, 0) : nullptr;
    const Properties& law = materials(material(p));
    // Where the weight is constant, that of the energy is zero.
    const bool slopes = bent || axisymmetric || dq[0] != 0.0 || dq[1] != 0.0;
    const double energy =
        slopes ? heat.energy(p, material(p), law, F, variables) - disk.misfit + 0.5 * density * dot(v, v)
               : 0.0;
    const double warming = heat.energyAlong(p, material(p), law, F, tau, variables, image);
    if (r >= 0.0)
      nearFront.add(r, -volume(p) * warming, q, sums + heatAt);
    if (!bent)
      sums[0] += volume(p) * (dot(flux, du) - energy * dot(dq, image) + density * dot(a, du) -
                              (density * dot(v, dv1) + warming) * q);
    else
      sums[0] += volume(p) * alongPath(p, weight, slope, energy, density, v, a, dv);
    if (hoop != 0.0)
      sums[0] += volume(p) * hoop * widening(p, energy);
  }

  /// What a radial shift s adds to J, per hoop strain s / r: a shift widens the ring of a particle, so that
  /// the gradient of the shift has a third component, which takes the place of q,J in P_iJ u_i,1 - W d_1J.
  KOKKOS_INLINE_FUNCTION double widening(int p, double energy) const
  {
    const double stretch = deformation(p, gradientSize<D> - 1);
    return stress(p, normalIndex<D>(2)) * frame.hoopFactor(p) * (stretch - 1.0) -
           energy * (frame.undeformed ? 1.0 : stretch);
  }

  /// Hoop strain of the shift of the disk at a particle [1/m]. \param along radial component of the direction
  /// in the undeformed disk, of a straight crack
  template <class Stencil>
  KOKKOS_INLINE_FUNCTION double hoopOfShift(const Stencil& stencil, double along) const
  {
    if constexpr (Stencil::mayHaveHoop)
      if (stencil.hasHoop())
      {
        const Pack<4> weight =
            stencil.template hoopValue<FrontRows<D>::width, 4>(rows.data + FrontRows<D>::weightAt);
        return bent ? weight[1] : weight[0] * along;
      }
    return 0.0;
  }

  template <class Stencil>
  KOKKOS_INLINE_FUNCTION void add(int p, const Stencil& stencil, double (&sums)[numSums]) const
  {
    // Interpolated like the motion, a weighted shift of the body is a motion that the cells can represent:
    // stresses in equilibrium do no work on it, for any rotation of the body next to the crack
    // (docs/explanation/broken-cells.md).
    Pack<4> slope[D];
    const Pack<4> weight =
        stencil.template valueAndGradient<FrontRows<D>::width>(rows.data + FrontRows<D>::weightAt, slope);
    const double q = weight[0];
    const Vector<D> dq{{slope[0][0], slope[1][0]}};
    if (q == 0.0 && dq[0] == 0.0 && dq[1] == 0.0)
      return;
    Motion motion;
    if (moving)
      readMotion(stencil, motion);

    // The direction in the undeformed disk, its image, and u,1 relative to the turned disk.
    const Vector<D> before = frame.undeformed ? direction : turnedBack(direction);
    const Vector<D> image = imageOf(p, before);
    const Vector<D> du = image - ahead();
    // P_iJ q,J in undeformed space is tau_ij q,j in 3D.
    double T[D * D];
    frame.stress(p, &stress(p, 0), T);
    const Vector<D> flux{{T[0] * dq[0] + T[1] * dq[1], T[2] * dq[0] + T[3] * dq[1]}};
    const Vector<D> inCells = frame.undeformed ? before : image;
    const double density = mass(p) / volume(p);
    const Vector<D> from{{place.position(p, 0) - tip[0], place.position(p, 1) - tip[1]}};
    const double r = std::sqrt(dot(from, from));
    const bool corrects = heat.strains(material(p)) && nearFront.reaches(r);
    if (release)
      addRelease(p, weight, slope, inCells, du, flux, motion, hoopOfShift(stencil, before[0]),
                 corrects ? r : -1.0, sums);
    if (!intensities)
      return;
    const Pair sum = interaction(p, q, dq, flux, du, density, motion.a, inCells);
    for (int mode = 0; mode < 2; ++mode)
    {
      if (corrects)
        nearFront.add(r, sum.ofHeat[mode], q, sums + heatAt + (1 + mode) * HeatNearFront::numSums);
      sums[1 + mode] += sum.interaction[mode];
      sums[3 + mode] += sum.reciprocal[mode];
    }
  }

  /// The same with a weight that is a vector along the crack: the sum over both axes of the integrand in the
  /// direction of the axis with the weight's component.
  KOKKOS_INLINE_FUNCTION double alongPath(int p, const Pack<4>& weight, const Pack<4> (&weightSlope)[D],
                                          double energy, double density, const Vector<D>& v,
                                          const Vector<D>& a, const double (&dv)[D][D]) const
  {
    const double *F = &deformation(p, 0), *tau = &stress(p, 0);
    double T[D * D];
    frame.stress(p, tau, T);
    double sum = 0.0;
    for (int k = 0; k < D; ++k)
    {
      // The axis in the undeformed disk, its image, and u,k relative to the turned disk.
      const Vector<D> axis{{k == 0 ? 1.0 : 0.0, k == 0 ? 0.0 : 1.0}};
      const Vector<D> before = frame.undeformed ? axis : turnedBack(axis);
      const Vector<D> now = imageOf(p, before), image = frame.undeformed ? axis : now;
      const Vector<D> du = now - (frame.undeformed ? turned(axis) : axis);
      const Vector<D> dvk{
          {dv[0][0] * image[0] + dv[0][1] * image[1], dv[1][0] * image[0] + dv[1][1] * image[1]}};
      const Vector<D> slope{{weightSlope[0][1 + k], weightSlope[1][1 + k]}};
      const Vector<D> flux{{T[0] * slope[0] + T[1] * slope[1], T[2] * slope[0] + T[3] * slope[1]}};
      const double* variables = history.extent(1) > 0 ? &history(p, 0) : nullptr;
      sum += dot(flux, du) - energy * dot(slope, image) -
             (density * dot(v, dvk) +
              heat.energyAlong(p, material(p), materials(material(p)), F, tau, variables, image)) *
                 weight[1 + k];
      if (weight[0] > 0.0)
        sum += density * dot(a, du) * weight[1 + k] / weight[0];
    }
    return sum;
  }

  /// A vector of the undeformed disk turned with it, and one of the turned disk turned back.
  KOKKOS_INLINE_FUNCTION Vector<D> turned(const Vector<D>& v) const
  {
    return {{disk.cosine * v[0] - disk.sine * v[1], disk.sine * v[0] + disk.cosine * v[1]}};
  }
  KOKKOS_INLINE_FUNCTION Vector<D> turnedBack(const Vector<D>& v) const
  {
    return {{disk.cosine * v[0] + disk.sine * v[1], -disk.sine * v[0] + disk.cosine * v[1]}};
  }

  /// The direction of the front and its normal in the turned disk. The crack turns with the body, unless the
  /// cells are undeformed.
  KOKKOS_INLINE_FUNCTION Vector<D> ahead() const { return frame.undeformed ? turned(direction) : direction; }
  KOKKOS_INLINE_FUNCTION Vector<D> across() const { return frame.undeformed ? turned(normal) : normal; }

  /// F times a vector of the undeformed body.
  KOKKOS_INLINE_FUNCTION Vector<D> imageOf(int p, const Vector<D>& v) const
  {
    const double* F = &deformation(p, 0);
    return {{F[0] * v[0] + F[1] * v[1], F[2] * v[0] + F[3] * v[1]}};
  }

  /// Displacement relative to the disk's mean motion and turn, as `du` is.
  KOKKOS_INLINE_FUNCTION Vector<D> displacement(int p) const
  {
    const Vector<D> from{
        {place.reference(p, 0) - disk.reference[0], place.reference(p, 1) - disk.reference[1]}};
    return Vector<D>{{place.now(p, 0) - disk.position[0], place.now(p, 1) - disk.position[1]}} - turned(from);
  }

  KOKKOS_INLINE_FUNCTION Pair interaction(int p, double q, const Vector<D>& dq, const Vector<D>& flux,
                                          const Vector<D>& du, double density, const Vector<D>& a,
                                          const Vector<D>& image) const
  {
    Pair sum;
    const Vector<D> from{{place.position(p, 0) - tip[0], place.position(p, 1) - tip[1]}};
    const double x1 = dot(from, direction), x2 = dot(from, normal);
    const double r = std::sqrt(x1 * x1 + x2 * x2);
    if (!(r > 0.0))
      return sum;
    const int named = sides ? side(p) : 0;
    const double theta = tipAngle(x1, x2, named == positive ? 1 : (named == negative ? -1 : 0));
    const Vector<D> e1 = ahead(), e2 = across();
    const double fluxIn[2] = {dot(flux, e1), dot(flux, e2)};
    const double slopeIn[2] = {dot(dq, direction), dot(dq, normal)};
    const double duIn[2] = {dot(du, e1), dot(du, e2)};
    const double aIn[2] = {dot(a, e1), dot(a, e2)};
    const Vector<D> u = displacement(p);
    const double uIn[2] = {dot(u, e1), dot(u, e2)};
    const double* tau = &stress(p, 0);
    const Vector<D> pull{{tau[0] * e1[0] + tau[2] * e1[1], tau[2] * e1[0] + tau[1] * e1[1]}};
    const Vector<D> lift{{tau[0] * e2[0] + tau[2] * e2[1], tau[2] * e2[0] + tau[1] * e2[1]}};
    const double s11 = dot(pull, e1), s12 = dot(pull, e2), s22 = dot(lift, e2);
    const bool warm = heat.strains(material(p));
    const double expanded = warm ? heat.strain(p, material(p)) : 0.0;
    const double expansionAlong = warm ? heat.expansion(p, material(p)) * heat.alongImage(p, image) : 0.0;
    const TipPosition at(r, theta, disk.compliance);
    for (int mode = 0; mode < 2; ++mode)
    {
      const TipField w = at.field(mode);
      double m = -slopeIn[0] * (s11 * w.gradient[0][0] + s22 * w.gradient[1][1] +
                                s12 * (w.gradient[0][1] + w.gradient[1][0]));
      double reciprocal = 0.0;
      for (int i = 0; i < 2; ++i)
      {
        const double pulled = fluxIn[i], pushed = density * aIn[i];
        m += (pulled + pushed) * w.gradient[i][0];
        reciprocal += (pulled + pushed) * w.displacement[i];
        for (int j = 0; j < 2; ++j)
        {
          m += w.stress[i][j] * duIn[i] * slopeIn[j];
          reciprocal -= w.stress[i][j] * uIn[i] * slopeIn[j];
        }
      }
      const double traced = disk.traceFactor * (w.stress[0][0] + w.stress[1][1]);
      m += expansionAlong * traced * q;
      reciprocal -= expanded * traced * q;
      sum.ofHeat[mode] = volume(p) * expansionAlong * traced;
      sum.interaction[mode] = volume(p) * m;
      sum.reciprocal[mode] = volume(p) * reciprocal;
    }
    return sum;
  }
};

} // namespace domainIntegrand

} // namespace Rhegma::energy_release
