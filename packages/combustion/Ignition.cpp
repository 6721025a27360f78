#include "combustion/Ignition.hpp"

#include "archive/Archive.hpp"
#include "base/RowOrder.hpp"

namespace Rhegma::combustion
{

template <int D>
void Fire<D>::update(const FacePoints<D>& points, bool anew)
{
  if (anew || static_cast<int>(lit_.extent(0)) != points.count())
    lit_ = inOrder(lit_, points.before);
  if (burning_.extent(0) != lit_.extent(0)) // also after a restart, with the marks of the checkpoint
    burning_ = View<int*>("rhegma::combustion::burning", lit_.extent(0));
}

template <int D>
void Fire<D>::spread(const State<D>& state, const FacePoints<D>& points, int crack,
                     const Ignition<D>& ignition, double reach, const View<double* [2]>& temperature) const
{
  if (state.clock.time < ignition.time)
    return;
  const View<int*> of = points.crack;
  const View<double* [D]> position = points.position;
  const Ignition<D> what = ignition;
  const View<int*> lit = lit_;
  const bool hot = ignition.byTemperature() && temperature.extent(0) > 0;
  Kokkos::parallel_for(
      "rhegma::combustion::spread", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k) {
        if (of(k) != crack || lit(k) != 0)
          return;
        Vector<D> x;
        for (int d = 0; d < D; ++d)
          x[d] = position(k, d);
        const bool reached = what.everywhere || (what.inBox && what.distance(x) <= reach);
        const bool heated =
            hot && (temperature(k, 0) >= what.temperature || temperature(k, 1) >= what.temperature);
        lit(k) = reached || heated ? 1 : 0;
      });
}

template <int D>
void Fire<D>::quench(const FacePoints<D>& points, int crack, const Quenching& law, double gap,
                     double pressure, const View<double*>& ofPoints) const
{
  const FacePoints<D> p = points;
  const View<int*> lit = lit_, burning = burning_;
  const bool each = ofPoints.extent(0) > 0;
  Kokkos::parallel_for(
      "rhegma::combustion::quench", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k) {
        if (p.crack(k) == crack)
          burning(k) = lit(k) != 0 && !law.quenches(std::fmax(p.separation(k), 0.0) + gap,
                                                    pressure + (each ? ofPoints(k) : 0.0))
                           ? 1
                           : 0;
      });
}

template <int D>
void Fire<D>::serialize(Archive& archive)
{
  archive("lit", lit_);
}

template class Fire<2>;
template class Fire<3>;

} // namespace Rhegma::combustion
