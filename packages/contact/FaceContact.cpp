#include "contact/FaceContact.hpp"

#include "archive/Archive.hpp"
#include "base/RowOrder.hpp"
#include "material/MaterialTable.hpp"
#include "state/Subdomain.hpp"
#include "transfer/FaceTractions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace Rhegma::contact
{

namespace
{

/// Pressure as a fraction of the modulus below which a touch is only round-off.
constexpr double noticeable = 1e-9;

} // namespace

template <int D>
double FaceContact<D>::prepare(const State<D>& state)
{
  const View<double*> size = points_.size;
  double change = 0.0;
  replaced_ = points_.update(state);
  if (replaced_)
  {
    storeHistory(size);
    const View<int*> everywhere("rhegma::contact::everywhere", points_.count());
    Kokkos::deep_copy(everywhere, 1);
    change = storedIn(everywhere) - stored_;
    stored_ += change;
  }
  if (stiffness_.extent(0) != state.cracks.cracks.size())
    findStiffness(state);
  thickness_ = state.method.thickness;
  return change;
}

template <int D>
void FaceContact<D>::findStiffness(const State<D>& state)
{
  const int cracks = static_cast<int>(state.cracks.cracks.size());
  stiffness_ = View<Stiffness*>("rhegma::contactStiffness", cracks);
  closed_ = View<int*>("rhegma::contactClosed", cracks);
  peak_ = View<double*>("rhegma::contactPeak", cracks);
  cracks_.resize(cracks);
  const auto side = onHost(state.particles.integer(fields::side));
  const auto material = onHost(state.particles.integer(fields::material));
  const auto stiffness = Kokkos::create_mirror_view(stiffness_);
  // The softer of the materials that meet: a stiff layer on a soft body would ask for a smaller step.
  const double infinity = std::numeric_limits<double>::infinity();
  for (int c = 0; c < cracks; ++c)
    stiffness(c) = {infinity, infinity};
  const double factor = alpha_ / state.mesh.grid.spacing;
  for (int p = 0; p < state.particles.size(); ++p)
    if (side(p) != 0)
    {
      const Elasticity e = elasticity(state.materials.properties[material(p)]);
      Stiffness& s = stiffness(std::abs(side(p)) - 1);
      s.normal = std::min(s.normal, factor * e.constrainedModulus);
      s.tangential = std::min(s.tangential, factor * e.shear);
    }
  std::vector<double> softest; // negative, so that the largest is looked for
  for (int c = 0; c < cracks; ++c)
    softest.insert(softest.end(), {-stiffness(c).normal, -stiffness(c).tangential});
  maxParts(state, softest.data(), 2 * cracks);
  for (int c = 0; c < cracks; ++c)
    stiffness(c) = {-softest[2 * c], -softest[2 * c + 1]};
  // A crack shorter than a cell may have no particle next to it yet; later it may meet any of the materials.
  for (int c = 0; c < cracks; ++c)
    if (stiffness(c).normal == infinity)
      for (const Properties& any : state.materials.properties)
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
  scatterTractions<D>("rhegma::contact::addForces", StepForces<D>{state.mesh.nodes}, points_, pressure_,
                      shear_, thickness_);
}

template <int D>
void FaceContact<D>::addForces(const View<double * [D + 1]>& force) const
{
  scatterTractions<D>("rhegma::contact::addForces", force, points_, pressure_, shear_, thickness_);
}

template <int D>
std::vector<FaceTraction<D>> FaceContact<D>::tractions(int crack) const
{
  const auto of = onHost(points_.crack);
  const auto size = onHost(points_.currentSize);
  const auto position = onHost(points_.position), normal = onHost(points_.normal),
             edge = onHost(points_.edge);
  const auto pressure = onHost(pressure_);
  const auto shear = onHost(shear_);
  std::vector<FaceTraction<D>> all;
  for (int k = 0; k < points_.count(); ++k)
    if (of(k) == crack)
    {
      FaceTraction<D> one;
      Vector<D> n;
      for (int d = 0; d < D; ++d)
      {
        one.position[d] = position(k, d);
        one.edge[d] = edge(k, d);
        n[d] = normal(k, d);
      }
      one.traction = pressure(k) * n;
      for (int t = 0; t < D - 1; ++t)
        one.traction = one.traction - shear(k, t) * faceTangent(n, one.edge, t);
      one.size = size(k);
      all.push_back(one);
    }
  return all;
}

template <int D>
template <class Velocity>
void FaceContact<D>::advance(const State<D>& state, const Velocity& velocity)
{
  findFaceJumps("rhegma::contact::findJumps", state, points_, velocity, jump_);
  const View<double*> jumps = jump_;
  const FacePoints<D> points = points_;
  const View<double*> gap = gap_, pressure = pressure_, heat = heat_;
  const View<double * [D - 1]> slip = slip_, shear = shear_;
  const View<double*> peak = peak_;
  const View<int*> closed = closed_;
  const View<Stiffness*> stiffness = stiffness_;
  const Law law = law_;
  const double friction = friction_, dt = state.clock.dt, thickness = thickness_;
  const double threshold = noticeable * state.mesh.grid.spacing / alpha_;
  Kokkos::deep_copy(closed_, 0);
  double stored = 0.0, lost = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::contact::advance", Kokkos::RangePolicy<ExecSpace>(0, points_.count()),
      KOKKOS_LAMBDA(const int k, double& energy, double& loss) {
        const int c = points.crack(k);
        const double area = points.size(k) * thickness;
        if (points.acts(k) != 0)
        {
          Vector<D> n, jump;
          for (int d = 0; d < D; ++d)
          {
            n[d] = points.normal(k, d);
            jump[d] = jumps(D * k + d);
          }
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
          heat(k) += now.heat;
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
void FaceContact<D>::accept(const State<D>& state, const std::vector<PointContact<D>>& found, double stored,
                            double lost)
{
  const auto gap = onHost(gap_), pressure = onHost(pressure_), heat = onHost(heat_), peak = onHost(peak_);
  const auto slip = onHost(slip_), shear = onHost(shear_);
  const auto stiffness = onHost(stiffness_);
  const auto crack = onHost(points_.crack), closed = onHost(closed_);
  const double threshold = noticeable * state.mesh.grid.spacing / alpha_;
  Kokkos::deep_copy(closed, 0);
  for (std::size_t k = 0; k < found.size(); ++k)
    if (found[k].acts)
    {
      const int c = crack(k);
      gap(k) = found[k].gap;
      pressure(k) = found[k].pressure;
      heat(k) += found[k].heat;
      for (int t = 0; t < D - 1; ++t)
      {
        shear(k, t) = found[k].shear[t];
        slip(k, t) = 0.0; // nothing of it is elastic
      }
      closed(c) += pressure(k) > threshold * stiffness(c).normal ? 1 : 0;
      peak(c) = std::max(peak(c), pressure(k));
    }
  Kokkos::deep_copy(gap_, gap);
  Kokkos::deep_copy(pressure_, pressure);
  Kokkos::deep_copy(heat_, heat);
  Kokkos::deep_copy(slip_, slip);
  Kokkos::deep_copy(shear_, shear);
  Kokkos::deep_copy(closed_, closed);
  Kokkos::deep_copy(peak_, peak);
  stored_ += stored;
  dissipated_ += lost;
  note(state);
}

template <int D>
void FaceContact<D>::note(const State<D>& state)
{
  const auto closed = onHost(closed_);
  const auto peak = onHost(peak_);
  for (std::size_t c = 0; c < cracks_.size(); ++c)
  {
    if (closed(c) > 0 && cracks_[c].closedPoints == 0)
    {
      if (cracks_[c].touches++ == 0)
        cracks_[c].firstTouch = state.clock.time + state.clock.dt;
    }
    cracks_[c].closedPoints = closed(c);
    cracks_[c].largestPressure = peak(c);
  }
}

template <int D>
double FaceContact<D>::dissipatedIn(const View<int*>& part) const
{
  const View<double*> heat = heat_, size = points_.size;
  double total = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::contact::dissipatedIn", Kokkos::RangePolicy<ExecSpace>(0, part.extent(0)),
      KOKKOS_LAMBDA(const int k, double& sum) { sum += part(k) != 0 ? heat(k) * size(k) : 0.0; }, total);
  return thickness_ * total;
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

template <int D>
void FaceContact<D>::storeHistory(const View<double*>& size)
{
  gap_ = inOrder(gap_, points_.before);
  slip_ = inOrder(slip_, points_.before);
  pressure_ = inOrder(pressure_, points_.before);
  shear_ = inOrder(shear_, points_.before);
  heat_ = inheritBySize("rhegma::contactHeat", heat_, size, points_);
}

template <int D>
void FaceContact<D>::serialize(Archive& archive)
{
  {
    const Archive::Group group(archive, "points");
    points_.serialize(archive);
  }
  archive("gap", gap_);
  archive("slip", slip_);
  archive("pressure", pressure_);
  archive("shear", shear_);
  archive("heat", heat_);
  archive("closed", closed_);
  archive("peak", peak_);
  archive("thickness", thickness_);
  archive("stored", stored_);
  archive("dissipated", dissipated_);
  storeCracks(archive);
}

template <int D>
void FaceContact<D>::storeCracks(Archive& archive)
{
  int cracks = static_cast<int>(cracks_.size());
  archive("cracks", cracks);
  cracks_.resize(cracks);
  if (static_cast<int>(stiffness_.extent(0)) != cracks)
    stiffness_ = View<Stiffness*>("rhegma::contactStiffness", cracks);
  const auto stiffness = onHost(stiffness_);
  for (int c = 0; c < cracks; ++c)
  {
    const Archive::Group group(archive, "crack " + std::to_string(c));
    archive("stiffness_normal", stiffness(c).normal);
    archive("stiffness_tangential", stiffness(c).tangential);
    archive("closed_points", cracks_[c].closedPoints);
    archive("touches", cracks_[c].touches);
    archive("first_touch", cracks_[c].firstTouch);
    archive("largest_pressure", cracks_[c].largestPressure);
  }
  Kokkos::deep_copy(stiffness_, stiffness);
}

template class FaceContact<2>;
template class FaceContact<3>;
template void FaceContact<2>::advance(const State<2>&, const View<double * [Nodes<2>::motionWidth]>&);
template void FaceContact<2>::advance(const State<2>&, const View<double * [Nodes<2>::projectionWidth]>&);
template void FaceContact<3>::advance(const State<3>&, const View<double * [Nodes<3>::motionWidth]>&);
template void FaceContact<3>::advance(const State<3>&, const View<double * [Nodes<3>::projectionWidth]>&);

} // namespace Rhegma::contact
