#include "contact/FaceContact.hpp"

#include "material/MaterialTable.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace Rhegma::contact
{

namespace
{

/// A closed crack at rest presses with round-off of its material's modulus; that is no touch.
constexpr double noticeable = 1e-9;

/// Traction of the face points on their faces, as forces.
void scatterTractions(const Nodes<2>& nodes, const FacePoints& points, const View<double*>& pressure,
                      const View<double*>& shear, double thickness)
{
  Kokkos::parallel_for(
      "rhegma::contact::addForces", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k) {
        if (pressure(k) == 0.0)
          return;
        const Vector<2> n{points.normal(k, 0), points.normal(k, 1)};
        const double area = points.length(k) * thickness;
        const Vector<2> onUpper = area * (pressure(k) * n - shear(k) * tangentOf(n));
        addFaceForce(nodes, points.above, k, onUpper);
        addFaceForce(nodes, points.below, k, -1.0 * onUpper);
      });
}

/// The law at a point over one step.
struct Return
{
  double pressure, shear, slip, heat;
};

/// \param gap now \param moved slip over the step \param slip elastic slip before \param before shear before
KOKKOS_INLINE_FUNCTION Return returnMap(Law law, double friction, const Stiffness& k, double gap, bool closed,
                                        double moved, double slip, double before)
{
  Return r{gap < 0.0 ? -k.normal * gap : 0.0, 0.0, 0.0, 0.0};
  // Faces that have just met begin without slip.
  const double trial = closed ? slip + moved : 0.0;
  double limit = 0.0;
  if (r.pressure > 0.0 && law == Law::Stick)
    limit = 1e300;
  if (law == Law::Coulomb)
    limit = friction * r.pressure;
  r.shear = k.tangential * trial;
  r.slip = trial;
  if (std::fabs(r.shear) > limit)
  {
    r.shear = r.shear > 0.0 ? limit : -limit;
    r.slip = r.shear / k.tangential;
  }
  // By the mean traction, as the energy of the layer changes by it.
  r.heat = 0.5 * (before + r.shear) * (trial - r.slip);
  return r;
}

double sumOverPart(const View<double*>& value, const View<int*>& part)
{
  double total = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::contact::sumOverPart", Kokkos::RangePolicy<ExecSpace>(0, value.extent(0)),
      KOKKOS_LAMBDA(const int k, double& sum) { sum += part(k) != 0 ? value(k) : 0.0; }, total);
  return total;
}

View<double*> inherit(const View<double*>& old, const View<int*>& before, const char* label)
{
  const View<double*> fresh(std::string(label), before.extent(0));
  if (old.extent(0) > 0)
    Kokkos::parallel_for(
        "rhegma::contact::inherit", Kokkos::RangePolicy<ExecSpace>(0, before.extent(0)),
        KOKKOS_LAMBDA(const int k) { fresh(k) = before(k) >= 0 ? old(before(k)) : 0.0; });
  return fresh;
}

} // namespace

void FaceContact::prepare(const State<2>& state)
{
  if (points_.update(state))
    keepHistory();
  if (stiffness_.extent(0) != state.cracks.cracks.size())
    findStiffness(state);
  thickness_ = state.thickness;
}

void FaceContact::keepHistory()
{
  gap_ = inherit(gap_, points_.before, "rhegma::contactGap");
  slip_ = inherit(slip_, points_.before, "rhegma::contactSlip");
  pressure_ = inherit(pressure_, points_.before, "rhegma::contactPressure");
  shear_ = inherit(shear_, points_.before, "rhegma::contactShear");
  heat_ = inherit(heat_, points_.before, "rhegma::contactHeat");
}

void FaceContact::findStiffness(const State<2>& state)
{
  const int cracks = static_cast<int>(state.cracks.cracks.size());
  stiffness_ = View<Stiffness*>("rhegma::contactStiffness", cracks);
  closed_ = View<int*>("rhegma::contactClosed", cracks);
  peak_ = View<double*>("rhegma::contactPeak", cracks);
  cracks_.resize(cracks);
  const auto side =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::side));
  const auto material =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::material));
  const auto stiffness = Kokkos::create_mirror_view(stiffness_);
  // The softer of the materials that meet: a stiff layer on a soft body would ask for a smaller step.
  for (int c = 0; c < cracks; ++c)
    stiffness(c) = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const double factor = alpha_ / state.grid.spacing;
  for (int p = 0; p < state.particles.size(); ++p)
    if (side(p) != 0)
    {
      const Elasticity e = elasticity(state.materialList[material(p)]);
      Stiffness& s = stiffness(std::abs(side(p)) - 1);
      s.normal = std::min(s.normal, factor * e.constrainedModulus);
      s.tangential = std::min(s.tangential, factor * e.shear);
    }
  Kokkos::deep_copy(stiffness_, stiffness);
}

void FaceContact::addForces(const State<2>& state) const
{
  scatterTractions(state.nodes, points_, pressure_, shear_, thickness_);
}

template <class Velocity>
void FaceContact::advance(const State<2>& state, const Velocity& velocity)
{
  const FacePoints points = points_;
  const View<double*> gap = gap_, slip = slip_, pressure = pressure_, shear = shear_, heat = heat_;
  const View<double*> peak = peak_;
  const View<int*> closed = closed_;
  const View<Stiffness*> stiffness = stiffness_;
  const Law law = law_;
  const double friction = friction_, dt = state.dt, thickness = thickness_;
  const double threshold = noticeable * state.grid.spacing / alpha_;
  Kokkos::deep_copy(closed_, 0);
  double stored = 0.0, lost = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::contact::advance", Kokkos::RangePolicy<ExecSpace>(0, points_.count()),
      KOKKOS_LAMBDA(const int k, double& energy, double& loss) {
        const int c = points.crack(k);
        const double area = points.length(k) * thickness;
        if (points.above.count(k) > 0)
        {
          const Vector<2> n{points.normal(k, 0), points.normal(k, 1)};
          const Vector<2> jump = jumpAt(points.below, points.above, k, velocity);
          const bool wasClosed = gap(k) < 0.0;
          gap(k) += dt * dot(jump, n);
          const Return now = returnMap(law, friction, stiffness(c), gap(k), wasClosed,
                                       dt * dot(jump, tangentOf(n)), slip(k), shear(k));
          pressure(k) = now.pressure;
          shear(k) = now.shear;
          slip(k) = now.slip;
          heat(k) += area * now.heat;
          loss += area * now.heat;
          if (now.pressure > threshold * stiffness(c).normal)
            Kokkos::atomic_increment(&closed(c));
          Kokkos::atomic_fetch_max(&peak(c), now.pressure);
        }
        energy += area * 0.5 * (gap(k) < 0.0 ? -gap(k) * pressure(k) : 0.0);
        energy += area * 0.5 * slip(k) * shear(k);
      },
      stored, lost);
  stored_ = stored;
  dissipated_ += lost;
  note(state);
}

void FaceContact::note(const State<2>& state)
{
  const auto closed = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, closed_);
  const auto peak = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, peak_);
  for (std::size_t c = 0; c < cracks_.size(); ++c)
  {
    if (closed(c) > 0 && cracks_[c].closedPoints == 0)
    {
      if (cracks_[c].touches++ == 0)
        cracks_[c].firstTouch = state.time + state.dt;
    }
    cracks_[c].closedPoints = closed(c);
    cracks_[c].largestPressure = peak(c);
  }
}

double FaceContact::dissipatedIn(const View<int*>& part) const { return sumOverPart(heat_, part); }

double FaceContact::storedIn(const View<int*>& part) const
{
  const View<double*> gap = gap_, slip = slip_, pressure = pressure_, shear = shear_;
  const View<double*> length = points_.length;
  const double thickness = thickness_;
  double total = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::contact::storedIn", Kokkos::RangePolicy<ExecSpace>(0, part.extent(0)),
      KOKKOS_LAMBDA(const int k, double& sum) {
        if (part(k) != 0)
          sum += 0.5 * length(k) * thickness *
                 ((gap(k) < 0.0 ? -gap(k) * pressure(k) : 0.0) + slip(k) * shear(k));
      },
      total);
  return total;
}

template void FaceContact::advance(const State<2>&, const View<double * [Nodes<2>::motionWidth]>&);
template void FaceContact::advance(const State<2>&, const View<double * [Nodes<2>::projectionWidth]>&);

} // namespace Rhegma::contact
