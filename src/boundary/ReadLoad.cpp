#include "boundary/ReadLoad.hpp"

#include "base/ReadList.hpp"
#include "geometry/Cross.hpp"

#include <vector>

namespace Rhegma
{

namespace
{

template <int D>
using Points = std::vector<LoadPoint<D>>;

template <int D>
struct PlacedLoad
{
  Points<D> points;
  Vector<D> force;
};

double length(const Vector<2>& a) { return norm(a); }

/// Traction over a segment of unit thickness times the thickness; a pressure pushes against the outward
/// normal, which is to the right of From -> To.
PlacedLoad<2> placeTraction(const Teuchos::ParameterList& list, const Seeds<2>& seeds, double thickness,
                            const std::string& where)
{
  const Vector<2> from = readVector<2>(list, "From"), to = readVector<2>(list, "To");
  const Vector<2> along = to - from;
  Vector<2> force;
  if (list.isParameter("Pressure"))
    force = -list.get<double>("Pressure") * thickness * Vector<2>{along[1], -along[0]};
  else
    force = length(along) * thickness * readVector<2>(list, "Stress");
  return {lineLoad<2>(seeds, from, to, Profile::Uniform, where), force};
}

PlacedLoad<3> placeTraction(const Teuchos::ParameterList& list, const Seeds<3>& seeds, double,
                            const std::string& where)
{
  const Vector<3> corner = readVector<3>(list, "Corner");
  const Vector<3> a = readVector<3>(list, "Edge 1"), b = readVector<3>(list, "Edge 2");
  const Vector<3> area = cross(a, b);
  Vector<3> force;
  if (list.isParameter("Pressure"))
    force = -list.get<double>("Pressure") * area;
  else
    force = norm(area) * readVector<3>(list, "Stress");
  return {faceLoad(seeds, corner, a, b, where), force};
}

template <int D>
PlacedLoad<D> placeLoad(const Teuchos::ParameterList& list, const std::string& type, const Seeds<D>& seeds,
                        double thickness, const std::string& where)
{
  if (type == "Traction")
    return placeTraction(list, seeds, thickness, where);
  const Vector<D> force = readVector<D>(list, "Force");
  if (type == "Point Load")
    return {pointLoad<D>(seeds, readVector<D>(list, "Point"), where), force};
  const Profile profile =
      list.get<std::string>("Profile") == "Parabolic" ? Profile::Parabolic : Profile::Uniform;
  return {lineLoad<D>(seeds, readVector<D>(list, "From"), readVector<D>(list, "To"), profile, where), force};
}

/// A body as its particles lie before the first step, in the order of their ids.
template <int D>
Seeds<D> seedsOf(const State<D>& state, int body, std::vector<int>& ids)
{
  const auto bodies =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::body));
  const auto id =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::id));
  const auto x = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                     state.particles.template real<D>(fields::position));
  const auto edge = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                        state.particles.template real<D>(fields::edge));
  Seeds<D> seeds{};
  for (int p = 0; p < state.particles.size(); ++p)
    if (bodies(p) == body)
    {
      Vector<D> at;
      for (int d = 0; d < D; ++d)
      {
        at[d] = x(p, d);
        seeds.edge[d] = edge(p, d);
      }
      seeds.position.push_back(at);
      ids.push_back(id(p));
    }
  seeds.volume = 1.0;
  for (int d = 0; d < D; ++d)
  {
    seeds.volume *= seeds.edge[d];
    for (int e = 0; e < D; ++e)
      seeds.axes[d][e] = state.bodies.list[body].axes[d][e];
  }
  return seeds;
}

} // namespace

namespace
{

template <int D>
Load<D> onParticles(const PlacedLoad<D>& placed, const Seeds<D>& seeds, const std::vector<int>& ids,
                    const std::string& name, const std::string& history)
{
  std::vector<int> carriers;
  std::vector<Vector<D>> starts;
  for (const LoadPoint<D>& point : placed.points)
  {
    carriers.push_back(ids[point.particle]);
    starts.push_back(seeds.position[point.particle]);
  }
  return {name, placed.points, carriers, starts, placed.force, TimeFunction::parse(history)};
}

} // namespace

template <int D>
Load<D> readLoad(const Teuchos::ParameterList& list, const State<D>& state, const std::string& name)
{
  std::vector<int> ids;
  const Seeds<D> seeds = seedsOf(state, findBody(state, list.get<std::string>("Body")), ids);
  const PlacedLoad<D> placed = placeLoad<D>(list, list.get<std::string>("Type"), seeds,
                                            state.method.thickness, "Boundaries > " + name);
  return onParticles(placed, seeds, ids, name, list.get<std::string>("History"));
}

template <int D>
Surface<D> readSurface(const Teuchos::ParameterList& list, const State<D>& state, const std::string& name)
{
  std::vector<int> ids;
  const Seeds<D> seeds = seedsOf(state, findBody(state, list.get<std::string>("Body")), ids);
  Teuchos::ParameterList unit(list);
  unit.set("Pressure", 1.0);
  const PlacedLoad<D> placed = placeTraction(unit, seeds, state.method.thickness, "Boundaries > " + name);
  return {onParticles(placed, seeds, ids, name, "1"), norm(placed.force)};
}

template Load<2> readLoad(const Teuchos::ParameterList&, const State<2>&, const std::string&);
template Load<3> readLoad(const Teuchos::ParameterList&, const State<3>&, const std::string&);
template Surface<2> readSurface(const Teuchos::ParameterList&, const State<2>&, const std::string&);
template Surface<3> readSurface(const Teuchos::ParameterList&, const State<3>&, const std::string&);

} // namespace Rhegma
