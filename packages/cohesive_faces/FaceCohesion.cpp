#include "cohesive_faces/FaceCohesion.hpp"

#include "archive/Archive.hpp"
#include "base/RowOrder.hpp"
#include "transfer/FaceTractions.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace Rhegma::cohesive_faces
{

namespace
{

/// Part of the segment that a point stands for, in 2D: an end of what holds is found by bisection, to
/// rounding, where it lies between two of a few positions. In 3D a part of a triangle is in or out with its
/// middle.
template <int D>
double partThatHolds(const HoldsAt<D>& holdsAt, int crack, const Vector<D>& middle, const Vector<D>& along,
                     double length)
{
  constexpr int pieces = 8, halvings = 40;
  if (D == 3)
    return holdsAt(crack, middle) ? 1.0 : 0.0;
  const auto holds = [&](double at) { return holdsAt(crack, middle + ((at - 0.5) * length) * along); };
  double part = 0.0;
  for (int k = 0; k < pieces; ++k)
  {
    double low = static_cast<double>(k) / pieces, high = (k + 1.0) / pieces;
    const double from = low, to = high;
    const bool atLow = holds(low), atHigh = holds(high);
    for (int h = 0; h < halvings && atLow != atHigh; ++h)
    {
      const double between = 0.5 * (low + high);
      (holds(between) == atLow ? low : high) = between;
    }
    part += atLow == atHigh ? (atLow ? to - from : 0.0) : (atLow ? low - from : to - low);
  }
  return part;
}

template <class Views>
Vector<Views::static_extent(1)> rowOf(const Views& view, int k)
{
  Vector<Views::static_extent(1)> row;
  for (int d = 0; d < static_cast<int>(Views::static_extent(1)); ++d)
    row[d] = view(k, d);
  return row;
}

} // namespace

template <int D>
void FaceCohesion<D>::setLaws(const std::vector<TractionLaw>& laws, HoldsAt<D> holdsAt)
{
  const int cracks = static_cast<int>(laws.size());
  laws_ = View<TractionLaw*>("rhegma::cohesiveLaws", cracks);
  const auto host = Kokkos::create_mirror_view(laws_);
  for (int c = 0; c < cracks; ++c)
    host(c) = laws[c];
  Kokkos::deep_copy(laws_, host);
  holdsAt_ = std::move(holdsAt);
  records_.resize(cracks);
  largest_ = View<double* [2]>("rhegma::cohesiveLargest", cracks);
  damaged_ = View<int*>("rhegma::cohesiveDamaged", cracks);
}

template <int D>
double FaceCohesion<D>::prepare(const State<D>& state)
{
  const View<double*> size = points_.size;
  thickness_ = state.method.thickness;
  if (!points_.update(state))
    return 0.0;
  storeHistory(size);
  const double before = stored_;
  stored_ = storedNow();
  return stored_ - before;
}

template <int D>
void FaceCohesion<D>::storeHistory(const View<double*>& size)
{
  const View<double*> earlierBonded = inOrder(bonded_, points_.before);
  gap_ = inOrder(gap_, points_.before);
  slip_ = inOrder(slip_, points_.before);
  secant_ = inOrder(secant_, points_.before);
  spent_ = inOrder(spent_, points_.before);
  pressure_ = inOrder(pressure_, points_.before);
  shear_ = inOrder(shear_, points_.before);
  for (int mode = 0; mode < 2; ++mode)
    heat_[mode] = inheritBySize("rhegma::cohesiveHeat", heat_[mode], size, points_);
  bond(earlierBonded);
}

/// Points without an earlier one hold where the undeformed body does.
template <int D>
void FaceCohesion<D>::bond(const View<double*>& earlier)
{
  bonded_ = View<double*>("rhegma::cohesiveBonded", points_.count());
  const auto bonded = Kokkos::create_mirror_view(bonded_);
  const auto was = onHost(earlier), secant = onHost(secant_), size = onHost(points_.size);
  const auto before = onHost(points_.before), crack = onHost(points_.crack);
  const auto position = onHost(points_.position), edge = onHost(points_.edge);
  for (int k = 0; k < points_.count(); ++k)
  {
    bonded(k) = before(k) >= 0
                    ? was(k)
                    : partThatHolds<D>(holdsAt_, crack(k), rowOf(position, k), rowOf(edge, k), size(k));
    secant(k) = before(k) >= 0 ? secant(k) : 1.0;
  }
  Kokkos::deep_copy(bonded_, bonded);
  Kokkos::deep_copy(secant_, secant);
}

template <int D>
void FaceCohesion<D>::addForces(const State<D>& state) const
{
  scatterTractions<D>("rhegma::cohesive_faces::addForces", StepForces<D>{state.mesh.nodes}, points_,
                      pressure_, shear_, thickness_);
}

template <int D>
void FaceCohesion<D>::addForces(const View<double * [D + 1]>& force) const
{
  scatterTractions<D>("rhegma::cohesive_faces::addForces", force, points_, pressure_, shear_, thickness_);
}

template <int D>
template <class Velocity>
void FaceCohesion<D>::advance(const State<D>& state, const Velocity& velocity)
{
  findFaceJumps("rhegma::cohesive_faces::findJumps", state, points_, velocity, jump_);
  takeJumps(state.clock.dt);
  noteStart(state.clock.time + state.clock.dt);
}

/// Views of the points' history, for kernels.
template <int D>
struct PointHistory
{
  View<double*> gap, secant, spent, pressure, opened, slid;
  View<double * [D - 1]> slip, shear;
  View<double* [2]> largest;
  View<int*> damaged;

  /// Gives point k what is found of it. \param stored,lost get its energies per size [J/m2]
  KOKKOS_INLINE_FUNCTION void take(int k, int crack, const TractionLaw& law, double bonded, double newGap,
                                   const Vector<D - 1>& newSlip, const Cohesion<D>& now, double& stored,
                                   double& lost) const
  {
    const Cohesion<D> mean = meanOf(now, bonded);
    lost = 0.5 *
           ((mean.tension - pressure(k)) * (newGap - gap(k)) - mean.tension * newGap - pressure(k) * gap(k));
    for (int t = 0; t < D - 1; ++t)
      lost += 0.5 * ((mean.shear[t] + shear(k, t)) * (newSlip[t] - slip(k, t)) - mean.shear[t] * newSlip[t] +
                     shear(k, t) * slip(k, t));
    stored = 0.5 * (mean.tension * newGap + dot(mean.shear, newSlip));
    opened(k) += bonded * now.lost[0];
    slid(k) += bonded * now.lost[1];
    gap(k) = newGap;
    secant(k) = now.secant;
    spent(k) = now.spent;
    pressure(k) = -mean.tension;
    for (int t = 0; t < D - 1; ++t)
    {
      slip(k, t) = newSlip[t];
      shear(k, t) = mean.shear[t];
    }
    if (!(bonded > 0.0))
      return;
    Kokkos::atomic_fetch_max(&largest(crack, 0), newGap);
    Kokkos::atomic_fetch_max(&largest(crack, 1), norm(newSlip));
    if (law.isDamaged(now.secant))
      Kokkos::atomic_add(&damaged(crack), 1);
  }
};

template <int D>
void FaceCohesion<D>::takeJumps(double dt)
{
  const View<double*> jumps = jump_, bonded = bonded_;
  const FacePoints<D> points = points_;
  const View<TractionLaw*> laws = laws_;
  const PointHistory<D> history{gap_,     secant_, spent_, pressure_, heat_[0],
                                heat_[1], slip_,   shear_, largest_,  damaged_};
  const double thickness = thickness_;
  Kokkos::deep_copy(damaged_, 0);
  double stored = 0.0, dissipated = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::cohesive_faces::advance", Kokkos::RangePolicy<ExecSpace>(0, points_.count()),
      KOKKOS_LAMBDA(const int k, double& energy, double& loss) {
        const TractionLaw& law = laws(points.crack(k));
        if (!law.holds)
          return;
        const double area = points.size(k) * thickness;
        Vector<D> n, jump;
        for (int d = 0; d < D; ++d)
        {
          n[d] = points.normal(k, d);
          jump[d] = (points.acts(k) != 0 ? dt : 0.0) * jumps(D * k + d);
        }
        Vector<D - 1> slip;
        for (int t = 0; t < D - 1; ++t)
          slip[t] = history.slip(k, t) + dot(jump, tangentOf(points, k, t));
        const double gap = history.gap(k) + dot(jump, n);
        const Cohesion<D> now = cohesionAt<D>(law, gap, slip, history.secant(k), history.spent(k));
        double held, lost;
        history.take(k, points.crack(k), law, bonded(k), gap, slip, now, held, lost);
        energy += area * held;
        loss += area * lost;
      },
      stored, dissipated);
  stored_ = stored;
  lost_ += dissipated;
}

template <int D>
void FaceCohesion<D>::accept(const State<D>& state, const std::vector<FoundPoint<D>>& found)
{
  const PointHistory<D> history{gap_,     secant_, spent_, pressure_, heat_[0],
                                heat_[1], slip_,   shear_, largest_,  damaged_};
  Kokkos::deep_copy(damaged_, 0);
  stored_ = 0.0;
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    const int crack = points_.crack(k);
    if (!laws_(crack).holds)
      continue;
    const double area = points_.size(k) * thickness_;
    double held, lost;
    history.take(static_cast<int>(k), crack, laws_(crack), bonded_(k), found[k].gap, found[k].slip,
                 found[k].now, held, lost);
    stored_ += area * held;
    lost_ += area * lost;
  }
  noteStart(state.clock.time + state.clock.dt);
}

template <int D>
void FaceCohesion<D>::noteStart(double time)
{
  const auto damaged = onHost(damaged_);
  const auto largest = onHost(largest_);
  for (std::size_t c = 0; c < records_.size(); ++c)
  {
    CohesionRecord<D>& record = records_[c];
    record.largestOpening = std::max(record.largestOpening, largest(c, 0));
    record.largestSlip = std::max(record.largestSlip, largest(c, 1));
    if (damaged(c) == 0 || record.initiated >= 0.0)
      continue;
    record.initiated = time;
    const auto spent = onHost(spent_), bonded = onHost(bonded_);
    const auto crack = onHost(points_.crack);
    const auto position = onHost(points_.position);
    double most = -1.0;
    for (int k = 0; k < points_.count(); ++k)
      if (crack(k) == static_cast<int>(c) && bonded(k) > 0.0 && spent(k) > most)
      {
        most = spent(k);
        record.first = rowOf(position, k);
      }
  }
}

template <int D>
CohesionSums<D> FaceCohesion<D>::sumsOf(int crack) const
{
  CohesionSums<D> sums;
  sums.reach = records_[crack].first;
  const TractionLaw law = onHost(laws_)(crack);
  const auto of = onHost(points_.crack);
  const auto size = onHost(points_.size), bonded = onHost(bonded_), secant = onHost(secant_),
             spent = onHost(spent_), gap = onHost(gap_), pressure = onHost(pressure_),
             opened = onHost(heat_[0]), slid = onHost(heat_[1]);
  const auto slip = onHost(slip_), shear = onHost(shear_);
  const auto position = onHost(points_.position);
  double farthest = 0.0;
  for (int k = 0; k < points_.count(); ++k)
  {
    if (of(k) != crack)
      continue;
    const double length = size(k) * bonded(k), area = size(k) * thickness_;
    sums.bonded += length;
    sums.damaged += law.isDamaged(secant(k)) ? length : 0.0;
    sums.stored += 0.5 * area * (dot(rowOf(shear, k), rowOf(slip, k)) - pressure(k) * gap(k));
    sums.lost[0] += area * opened(k);
    sums.lost[1] += area * slid(k);
    if (!(spent(k) >= failedFraction) || !(length > 0.0))
      continue;
    sums.failed += length;
    const Vector<D> at = rowOf(position, k);
    if (const double away = norm(at - records_[crack].first); away > farthest)
    {
      farthest = away;
      sums.reach = at;
    }
  }
  return sums;
}

template <int D>
double FaceCohesion<D>::storedNow() const
{
  double total = 0.0;
  for (std::size_t c = 0; c < records_.size(); ++c)
    total += sumsOf(static_cast<int>(c)).stored;
  return total;
}

template <int D>
void FaceCohesion<D>::serialize(Archive& archive)
{
  {
    const Archive::Group group(archive, "points");
    points_.serialize(archive);
  }
  archive("gap", gap_);
  archive("slip", slip_);
  archive("secant", secant_);
  archive("spent", spent_);
  archive("bonded", bonded_);
  archive("pressure", pressure_);
  archive("shear", shear_);
  archive("opened", heat_[0]);
  archive("slid", heat_[1]);
  archive("largest", largest_);
  archive("damaged", damaged_);
  archive("thickness", thickness_);
  archive("stored", stored_);
  archive("dissipated", lost_);
  for (std::size_t c = 0; c < records_.size(); ++c)
  {
    const Archive::Group group(archive, "crack " + std::to_string(c));
    archive("initiated", records_[c].initiated);
    archive("first", records_[c].first);
    archive("largest_opening", records_[c].largestOpening);
    archive("largest_slip", records_[c].largestSlip);
  }
}

template class FaceCohesion<2>;
template class FaceCohesion<3>;
template void FaceCohesion<2>::advance(const State<2>&, const View<double * [Nodes<2>::motionWidth]>&);
template void FaceCohesion<2>::advance(const State<2>&, const View<double * [Nodes<2>::projectionWidth]>&);
template void FaceCohesion<3>::advance(const State<3>&, const View<double * [Nodes<3>::motionWidth]>&);
template void FaceCohesion<3>::advance(const State<3>&, const View<double * [Nodes<3>::projectionWidth]>&);

} // namespace Rhegma::cohesive_faces
