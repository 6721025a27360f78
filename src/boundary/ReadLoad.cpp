#include "boundary/ReadLoad.hpp"

#include "base/ReadList.hpp"
#include "plan/Axis.hpp"

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
  const PlacedLoad<D> placed = place(list, seeds, "Boundaries > " + name);
  std::vector<int> carriers;
  std::vector<Vector<D>> starts;
  for (const LoadPoint<D>& point : placed.points)
  {
    carriers.push_back(ids[point.particle]);
    starts.push_back(seeds.position[point.particle]);
  }
  return {name,
          placed.points,
          carriers,
          starts,
          {placed.force, placed.alongNormals},
          TimeFunction::parse(history)};
}

template <int D>
PlacedSurface<D> placeSurface(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list,
                              const Seeds<D>& seeds, const std::string& where)
{
  const Depth depth = depthOf<D>(scene);
  if (choosesSurface(list))
  {
    const std::vector<Geometry::SurfacePoint<D>> surface = chosenSurface<D>(scene, list, where);
    return {surfaceLoad<D>(seeds, surface, where, depth.around), measureSurface(surface, depth), false};
  }
  const SurfaceMeasure<D> measure = measureSurface<D>(scene, list, where);
  if constexpr (D == 2)
    return {lineLoad<D>(seeds, readVector<D>(list, "From"), readVector<D>(list, "To"), Profile::Uniform,
                        where, depth.around),
            measure, true};
  else
    return {faceLoad(seeds, readVector<D>(list, "Corner"), readVector<D>(list, "Edge 1"),
                     readVector<D>(list, "Edge 2"), where),
            measure, true};
}

template <int D>
Surface<D> readSurface(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list,
                       const State<D>& state, const std::string& name)
{
  double area = 0.0;
  const auto place = [&](const Teuchos::ParameterList& of, const Seeds<D>& seeds, const std::string& where)
  {
    const PlacedSurface<D> placed = placeSurface<D>(scene, of, seeds, where);
    area = placed.measure.area;
    return PlacedLoad<D>{placed.points, {}};
  };
  Load<D> points = readLoad<D>(list, state, name, "1", place);
  return {std::move(points), area};
}

#define RHEGMA_INSTANTIATE(D)                                                                                \
  template PlacedSurface<D> placeSurface(const Teuchos::ParameterList&, const Teuchos::ParameterList&,       \
                                         const Seeds<D>&, const std::string&);                               \
  template Surface<D> readSurface(const Teuchos::ParameterList&, const Teuchos::ParameterList&,              \
                                  const State<D>&, const std::string&);
RHEGMA_INSTANTIATE(2)
RHEGMA_INSTANTIATE(3)
#undef RHEGMA_INSTANTIATE

template Load<2> readLoad(const Teuchos::ParameterList&, const State<2>&, const std::string&,
                          const std::string&, const PlaceLoad<2>&);
template Load<3> readLoad(const Teuchos::ParameterList&, const State<3>&, const std::string&,
                          const std::string&, const PlaceLoad<3>&);

} // namespace Rhegma
