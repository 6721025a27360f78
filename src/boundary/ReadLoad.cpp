#include "boundary/ReadLoad.hpp"

#include "base/ReadList.hpp"
#include "geometry/Cross.hpp"

#include <utility>

namespace Rhegma
{

namespace
{

/// A body as its particles lie before the first step, in the order of their ids.
template <int D>
Seeds<D> seedsOf(const State<D>& state, int body, std::vector<int>& ids)
{
  const auto bodies = onHost(state.particles.integer(fields::body));
  const auto id = onHost(state.particles.integer(fields::id));
  const auto x = onHost(state.particles.template real<D>(fields::position));
  Seeds<D> seeds{};
  for (int p = 0; p < state.particles.size(); ++p)
    if (bodies(p) == body)
    {
      Vector<D> at;
      for (int d = 0; d < D; ++d)
        at[d] = x(p, d);
      seeds.position.push_back(at);
      ids.push_back(id(p));
    }
  seeds.edge = state.bodies.info[body].edge;
  for (int d = 0; d < D; ++d)
    for (int e = 0; e < D; ++e)
      seeds.axes[d][e] = state.bodies.info[body].axes[d][e];
  return seeds;
}

} // namespace

template <int D>
Load<D> readLoad(const Teuchos::ParameterList& list, const State<D>& state, const std::string& name,
                 const std::string& history, const PlaceLoad<D>& place)
{
  std::vector<int> ids;
  const Seeds<D> seeds = seedsOf(state, findBody(state, list.get<std::string>("Body")), ids);
  const PlacedLoad<D> placed = place(list, seeds, state.method.thickness, "Boundaries > " + name);
  std::vector<int> carriers;
  std::vector<Vector<D>> starts;
  for (const LoadPoint<D>& point : placed.points)
  {
    carriers.push_back(ids[point.particle]);
    starts.push_back(seeds.position[point.particle]);
  }
  return {name, placed.points, carriers, starts, placed.force, TimeFunction::parse(history)};
}

template <int D>
PlacedSurface<D> placeSurface(const Teuchos::ParameterList& list, const Seeds<D>& seeds, double thickness,
                              const std::string& where)
{
  if constexpr (D == 2)
  {
    const Vector<2> from = readVector<2>(list, "From"), to = readVector<2>(list, "To"), along = to - from;
    return {lineLoad<2>(seeds, from, to, Profile::Uniform, where),
            thickness * Vector<2>{along[1], -along[0]}};
  }
  else
  {
    const Vector<3> a = readVector<3>(list, "Edge 1"), b = readVector<3>(list, "Edge 2");
    return {faceLoad(seeds, readVector<3>(list, "Corner"), a, b, where), cross(a, b)};
  }
}

template <int D>
Surface<D> readSurface(const Teuchos::ParameterList& list, const State<D>& state, const std::string& name)
{
  double area = 0.0;
  const auto place = [&](const auto&... of)
  {
    const PlacedSurface<D> placed = placeSurface<D>(of...);
    area = norm(placed.area);
    return PlacedLoad<D>{placed.points, {}};
  };
  Load<D> points = readLoad<D>(list, state, name, "1", place);
  return {std::move(points), area};
}

template PlacedSurface<2> placeSurface(const Teuchos::ParameterList&, const Seeds<2>&, double,
                                       const std::string&);
template PlacedSurface<3> placeSurface(const Teuchos::ParameterList&, const Seeds<3>&, double,
                                       const std::string&);
template Surface<2> readSurface(const Teuchos::ParameterList&, const State<2>&, const std::string&);
template Surface<3> readSurface(const Teuchos::ParameterList&, const State<3>&, const std::string&);
template Load<2> readLoad(const Teuchos::ParameterList&, const State<2>&, const std::string&,
                          const std::string&, const PlaceLoad<2>&);
template Load<3> readLoad(const Teuchos::ParameterList&, const State<3>&, const std::string&,
                          const std::string&, const PlaceLoad<3>&);

} // namespace Rhegma
