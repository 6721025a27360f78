#include "transfer/FacePush.hpp"

#include "state/FaceVelocity.hpp"
#include "transfer/PushNodes.hpp"

namespace Rhegma
{

namespace
{

/// The views of face points that these kernels need: copying all of them would take longer than running a
/// kernel over a few points.
template <int D>
struct Pushed
{
  View<int*> crack;
  View<double*> currentSize;
  View<double*[D]> normal, position;
  StencilTable<D> below, above;

  explicit Pushed(const FacePoints<D>& points)
      : crack(points.crack),
        currentSize(points.currentSize),
        normal(points.normal),
        position(points.position),
        below(points.below),
        above(points.above)
  {
  }

  /// Force on the face of side +1 at point k [N].
  KOKKOS_INLINE_FUNCTION Vector<D> force(int k, double pressure, const Depth& depth) const
  {
    Vector<D> force;
    for (int d = 0; d < D; ++d)
      force[d] = pressure * currentSize(k) * depth.at(position(k, 0)) * normal(k, d);
    return force;
  }
};

} // namespace

namespace
{

/// The same pressure everywhere.
struct Everywhere
{
  double pressure;
  KOKKOS_INLINE_FUNCTION double operator()(int) const { return pressure; }
};

template <int D, class Pressure>
void push(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
          const Pressure& pressure)
{
  const Pushed<D> p(points);
  const StepForces<D> forces{state.mesh.nodes};
  const Depth depth = state.method.depth();
  forEachPushing(
      label, points.count(), KOKKOS_LAMBDA(const int k) {
        if (p.crack(k) == crack)
          addFaceForces<D>(forces, p.below, p.above, k, p.force(k, pressure(k), depth));
      });
}

template <int D>
void makePressures(CrackSet<D>& cracks)
{
  if (cracks.pressure.extent(0) != cracks.simplex.extent(0))
    cracks.pressure = View<double*>("rhegma::crackPressure", cracks.simplex.extent(0));
}

} // namespace

template <int D>
void pushFaces(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
               double pressure)
{
  push(label, state, points, crack, Everywhere{pressure});
}

template <int D>
void pushFaces(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
               const View<double*>& pressure)
{
  push(label, state, points, crack, pressure);
}

template <int D>
void sweptVolumes(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
                  const View<double*>& swept)
{
  const Pushed<D> p(points);
  const FaceVelocity<D> velocity(state);
  const Depth depth = state.method.depth();
  const double dt = state.clock.dt;
  Kokkos::parallel_for(
      label, Kokkos::RangePolicy<ExecSpace>(0, points.count()), KOKKOS_LAMBDA(const int k) {
        if (p.crack(k) == crack)
          swept(k) = dt * dot(p.force(k, 1.0, depth), jumpAt<D>(p.below, p.above, k, velocity));
      });
}

namespace
{

template <int D, class Pressure>
double work(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
            const Pressure& pressure)
{
  const Pushed<D> p(points);
  const WorkVelocity<D> velocity(state);
  const Depth depth = state.method.depth();
  const double dt = state.clock.dt;
  double all = 0.0;
  Kokkos::parallel_reduce(
      label, Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k, double& sum) {
        if (p.crack(k) == crack)
          sum += dt * dot(p.force(k, pressure(k), depth), jumpAt<D>(p.below, p.above, k, velocity));
      },
      all);
  return all;
}

} // namespace

template <int D>
double workOnFaces(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
                   double pressure)
{
  return work(label, state, points, crack, Everywhere{pressure});
}

template <int D>
double workOnFaces(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
                   const View<double*>& pressure)
{
  return work(label, state, points, crack, pressure);
}

template <int D>
void publishPressure(const char* label, CrackSet<D>& cracks, int crack, double pressure)
{
  makePressures(cracks);
  const View<double*> of = cracks.pressure;
  const int first = cracks.cracks[crack].firstSimplex;
  Kokkos::parallel_for(
      label, Kokkos::RangePolicy<ExecSpace>(0, cracks.cracks[crack].numSimplices),
      KOKKOS_LAMBDA(const int s) { of(first + s) = pressure; });
}

template <int D>
void publishPressure(const char* label, CrackSet<D>& cracks, const FacePoints<D>& points, int crack,
                     const View<double*>& pressure)
{
  publishPressure(label, cracks, crack, 0.0);
  const View<int*>&simplex = points.simplex(), &crackOf = points.crack;
  const View<double*>& fraction = points.fraction();
  const View<double*> of = cracks.pressure;
  forEachPushing(
      label, points.count(), KOKKOS_LAMBDA(const int k) {
        if (crackOf(k) == crack)
          Kokkos::atomic_add(&of(simplex(k)), fraction(k) * pressure(k));
      });
}

template void pushFaces(const char*, const State<2>&, const FacePoints<2>&, int, double);
template void pushFaces(const char*, const State<2>&, const FacePoints<2>&, int, const View<double*>&);
template void pushFaces(const char*, const State<3>&, const FacePoints<3>&, int, const View<double*>&);
template void sweptVolumes(const char*, const State<2>&, const FacePoints<2>&, int, const View<double*>&);
template void sweptVolumes(const char*, const State<3>&, const FacePoints<3>&, int, const View<double*>&);
template void publishPressure(const char*, CrackSet<2>&, const FacePoints<2>&, int, const View<double*>&);
template void publishPressure(const char*, CrackSet<3>&, const FacePoints<3>&, int, const View<double*>&);
template void pushFaces(const char*, const State<3>&, const FacePoints<3>&, int, double);
template double workOnFaces(const char*, const State<2>&, const FacePoints<2>&, int, double);
template double workOnFaces(const char*, const State<3>&, const FacePoints<3>&, int, double);
template double workOnFaces(const char*, const State<2>&, const FacePoints<2>&, int, const View<double*>&);
template double workOnFaces(const char*, const State<3>&, const FacePoints<3>&, int, const View<double*>&);
template void publishPressure(const char*, CrackSet<2>&, int, double);
template void publishPressure(const char*, CrackSet<3>&, int, double);

} // namespace Rhegma
