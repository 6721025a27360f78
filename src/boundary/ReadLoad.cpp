#include "boundary/ReadLoad.hpp"

#include "state/Ancestry.hpp"

#include <cmath>
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
  const auto edge = onHost(state.particles.template real<D>(fields::edge));
  const std::vector<int> level = levelsOfParticles(state);
  Seeds<D> seeds{};
  std::vector<Vector<D>> boxes; // of the lattice that was not divided yet
  for (int p = 0; p < state.particles.size(); ++p)
    if (bodies(p) == body)
    {
      Vector<D> at, box;
      for (int d = 0; d < D; ++d)
      {
        at[d] = x(p, d);
        box[d] = std::ldexp(edge(p, d), level[p]);
      }
      seeds.position.push_back(at);
      boxes.push_back(box);
      ids.push_back(id(p));
    }
  seeds.edge = latticeEdge<D>(std::move(boxes));
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

template Load<2> readLoad(const Teuchos::ParameterList&, const State<2>&, const std::string&,
                          const std::string&, const PlaceLoad<2>&);
template Load<3> readLoad(const Teuchos::ParameterList&, const State<3>&, const std::string&,
                          const std::string&, const PlaceLoad<3>&);

} // namespace Rhegma
