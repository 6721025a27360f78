#include "contact/FaceContact.hpp"

#include "material/MaterialTable.hpp"
#include "transfer/PushNodes.hpp"

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
template <int D>
void scatterTractions(const Nodes<D>& nodes, const FacePoints<D>& points, const View<double*>& pressure,
                      const View<double * [D - 1]>& shear, double thickness)
{
  forEachPushing(
      "rhegma::contact::addForces", points.count(), KOKKOS_LAMBDA(const int k) {
        if (pressure(k) == 0.0)
          return;
        Vector<D> onUpper;
        for (int d = 0; d < D; ++d)
          onUpper[d] = pressure(k) * points.normal(k, d);
        for (int t = 0; t < D - 1; ++t)
          onUpper = onUpper - shear(k, t) * tangentOf(points, k, t);
        onUpper = (points.size(k) * thickness) * onUpper;
        addFaceForce(nodes, points.above, k, onUpper);
        addFaceForce(nodes, points.below, k, -1.0 * onUpper);
      });
}

/// The law at a point over one step; T tangents.
template <int T>
struct Return
{
  double pressure;
  Vector<T> shear, slip;
  double heat;
};

/// \param gap now \param moved slip over the step \param slip elastic slip before \param before shear before
template <int T>
KOKKOS_INLINE_FUNCTION Return<T> returnMap(Law law, double friction, const Stiffness& k, double gap,
                                           bool closed, const Vector<T>& moved, const Vector<T>& slip,
                                           const Vector<T>& before)
{
  Return<T> r{gap < 0.0 ? -k.normal * gap : 0.0, {}, {}, 0.0};
  // Faces that have just met begin without slip.
  const Vector<T> trial = closed ? slip + moved : Vector<T>{};
  double limit = 0.0;
  if (r.pressure > 0.0 && law == Law::Stick)
    limit = 1e300;
  if (law == Law::Coulomb)
    limit = friction * r.pressure;
  r.shear = k.tangential * trial;
  r.slip = trial;
  const double size = norm(r.shear);
  if (size > limit)
  {
    r.shear = (limit / size) * r.shear;
    r.slip = (1.0 / k.tangential) * r.shear;
  }
  // By the mean traction, as the energy of the layer changes by it.
  r.heat = 0.5 * dot(before + r.shear, trial - r.slip);
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
  View<double*> fresh(std::string(label), before.extent(0));
  if (old.extent(0) > 0)
    Kokkos::parallel_for(
        "rhegma::contact::inherit", Kokkos::RangePolicy<ExecSpace>(0, before.extent(0)),
        KOKKOS_LAMBDA(const int k) { fresh(k) = before(k) >= 0 ? old(before(k)) : 0.0; });
  return fresh;
}

/// Along the tangents of a point.
template <int T>
View<double* [T]> inherit(const View<double* [T]>& old, const View<int*>& before, const char* label)
{
  View<double* [T]> fresh(std::string(label), before.extent(0));
  if (old.extent(0) > 0)
    Kokkos::parallel_for(
        "rhegma::contact::inheritTangents", Kokkos::RangePolicy<ExecSpace>(0, before.extent(0)),
        KOKKOS_LAMBDA(const int k) {
          for (int t = 0; t < T; ++t)
            fresh(k, t) = before(k) >= 0 ? old(before(k), t) : 0.0;
        });
  return fresh;
}

} // namespace

template <int D>
void FaceContact<D>::prepare(const State<D>& state)
{
  if (points_.update(state))
    keepHistory();
  if (stiffness_.extent(0) != state.cracks.cracks.size())
    findStiffness(state);
  thickness_ = state.thickness;
}

template <int D>
void FaceContact<D>::keepHistory()
{
  gap_ = inherit(gap_, points_.before, "rhegma::contactGap");
  slip_ = inherit<D - 1>(slip_, points_.before, "rhegma::contactSlip");
  pressure_ = inherit(pressure_, points_.before, "rhegma::contactPressure");
  shear_ = inherit<D - 1>(shear_, points_.before, "rhegma::contactShear");
  heat_ = inherit(heat_, points_.before, "rhegma::contactHeat");
}

template <int D>
void FaceContact<D>::findStiffness(const State<D>& state)
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
  const double infinity = std::numeric_limits<double>::infinity();
  for (int c = 0; c < cracks; ++c)
    stiffness(c) = {infinity, infinity};
  const double factor = alpha_ / state.grid.spacing;
  for (int p = 0; p < state.particles.size(); ++p)
    if (side(p) != 0)
    {
      const Elasticity e = elasticity(state.materialList[material(p)]);
      Stiffness& s = stiffness(std::abs(side(p)) - 1);
      s.normal = std::min(s.normal, factor * e.constrainedModulus);
      s.tangential = std::min(s.tangential, factor * e.shear);
    }
  // A crack shorter than a cell may have no particle beside it yet; later it may meet any of the materials.
  for (int c = 0; c < cracks; ++c)
    if (stiffness(c).normal == infinity)
      for (const Properties& any : state.materialList)
      {
        const Elasticity e = elasticity(any);
        stiffness(c).normal = std::min(stiffness(c).normal, factor * e.constrainedModulus);
        stiffness(c).tangential = std::min(stiffness(c).tangential, factor * e.shear);
      }
  Kokkos::deep_copy(stiffness_, stiffness);
}

template <int D>
void FaceContact<D>::addForces(const State<D>& state) const
{
  scatterTractions(state.nodes, points_, pressure_, shear_, thickness_);
}

template <int D>
template <class Velocity>
void FaceContact<D>::advance(const State<D>& state, const Velocity& velocity)
{
  const FacePoints<D> points = points_;
  const View<double*> gap = gap_, pressure = pressure_, heat = heat_;
  const View<double * [D - 1]> slip = slip_, shear = shear_;
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
        const double area = points.size(k) * thickness;
        if (points.above.count(k) > 0)
        {
          Vector<D> n;
          for (int d = 0; d < D; ++d)
            n[d] = points.normal(k, d);
          const Vector<D> jump = jumpAt<D>(points.below, points.above, k, velocity);
          const bool wasClosed = gap(k) < 0.0;
          gap(k) += dt * dot(jump, n);
          Vector<D - 1> moved, before, elastic;
          for (int t = 0; t < D - 1; ++t)
          {
            moved[t] = dt * dot(jump, tangentOf(points, k, t));
            before[t] = shear(k, t);
            elastic[t] = slip(k, t);
          }
          const Return<D - 1> now =
              returnMap(law, friction, stiffness(c), gap(k), wasClosed, moved, elastic, before);
          pressure(k) = now.pressure;
          for (int t = 0; t < D - 1; ++t)
          {
            shear(k, t) = now.shear[t];
            slip(k, t) = now.slip[t];
          }
          heat(k) += area * now.heat;
          loss += area * now.heat;
          if (now.pressure > threshold * stiffness(c).normal)
            Kokkos::atomic_add(&closed(c), 1);
          Kokkos::atomic_fetch_max(&peak(c), now.pressure);
        }
        energy += area * 0.5 * (gap(k) < 0.0 ? -gap(k) * pressure(k) : 0.0);
        for (int t = 0; t < D - 1; ++t)
          energy += area * 0.5 * slip(k, t) * shear(k, t);
      },
      stored, lost);
  stored_ = stored;
  dissipated_ += lost;
  note(state);
}

template <int D>
void FaceContact<D>::note(const State<D>& state)
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

template <int D>
double FaceContact<D>::dissipatedIn(const View<int*>& part) const
{
  return sumOverPart(heat_, part);
}

template <int D>
double FaceContact<D>::storedIn(const View<int*>& part) const
{
  const View<double*> gap = gap_, pressure = pressure_, size = points_.size;
  const View<double * [D - 1]> slip = slip_, shear = shear_;
  const double thickness = thickness_;
  double total = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::contact::storedIn", Kokkos::RangePolicy<ExecSpace>(0, part.extent(0)),
      KOKKOS_LAMBDA(const int k, double& sum) {
        if (part(k) == 0)
          return;
        double twice = gap(k) < 0.0 ? -gap(k) * pressure(k) : 0.0;
        for (int t = 0; t < D - 1; ++t)
          twice += slip(k, t) * shear(k, t);
        sum += 0.5 * size(k) * thickness * twice;
      },
      total);
  return total;
}

template class FaceContact<2>;
template class FaceContact<3>;
template void FaceContact<2>::advance(const State<2>&, const View<double * [Nodes<2>::motionWidth]>&);
template void FaceContact<2>::advance(const State<2>&, const View<double * [Nodes<2>::projectionWidth]>&);
template void FaceContact<3>::advance(const State<3>&, const View<double * [Nodes<3>::motionWidth]>&);
template void FaceContact<3>::advance(const State<3>&, const View<double * [Nodes<3>::projectionWidth]>&);

} // namespace Rhegma::contact
