#include "plausibility/BodyMeasures.hpp"

#include "material/LawStiffness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma
{

namespace
{

/// Bounds of a body along some axes.
template <int D>
struct Extent
{
  Vector<D> lower, upper;
  Extent()
  {
    for (int d = 0; d < D; ++d)
    {
      lower[d] = std::numeric_limits<double>::infinity();
      upper[d] = -lower[d];
    }
  }
  void include(int d, double middle, double half)
  {
    lower[d] = std::min(lower[d], middle - half);
    upper[d] = std::max(upper[d], middle + half);
  }
};

template <int D>
void setMaterial(const State<D>& state, int material, BodyMeasure<D>& body)
{
  const Properties& properties = state.materials.properties[material];
  body.material = state.materials.names[material];
  body.density = properties.density;
  body.moduli = elasticity(properties);
  // A fluid resists a change of its volume only, by which loads on it are judged.
  if (properties.mu == 0.0)
    body.moduli.young = body.moduli.effectiveModulus = properties.bulk;
  body.speed = std::sqrt(body.moduli.constrainedModulus / body.density);
  body.linear = isLinear(properties);
  body.anisotropic = isAnisotropic(properties);
  body.yield = firstYield(properties);
}

} // namespace

template <int D>
std::vector<BodyMeasure<D>> measureBodies(const State<D>& state)
{
  const auto host = [](const auto& view)
  { return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view); };
  const auto number = host(state.particles.integer(fields::body));
  const auto x = host(state.particles.template real<D>(fields::position));
  const auto edge = host(state.particles.template real<D>(fields::edge));
  const auto mass = host(state.particles.scalar(fields::mass));
  const auto volume = host(state.particles.scalar(fields::volume));
  const bool moves = state.method.mechanics;
  const auto v = host(state.particles.template real<D>(moves ? fields::velocity : fields::position));
  const std::size_t count = state.bodies.info.size();
  std::vector<BodyMeasure<D>> bodies(count);
  std::vector<Extent<D>> inSpace(count), own(count);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    const int b = number(p);
    bodies[b].mass += mass(p);
    bodies[b].volume += volume(p);
    const auto& axes = state.bodies.info[b].axes;
    for (int d = 0; d < D; ++d)
    {
      bodies[b].velocity[d] += moves ? mass(p) * v(p, d) : 0.0;
      double along = 0.0, half = 0.0;
      for (int e = 0; e < D; ++e)
      {
        along += axes[d][e] * x(p, e);
        half += 0.5 * std::fabs(axes[e][d]) * edge(p, e);
      }
      own[b].include(d, along, 0.5 * edge(p, d));
      inSpace[b].include(d, x(p, d), half);
    }
  }
  for (std::size_t b = 0; b < count; ++b)
  {
    BodyMeasure<D>& body = bodies[b];
    body.name = state.bodies.info[b].name;
    body.velocity = (1.0 / std::max(body.mass, std::numeric_limits<double>::min())) * body.velocity;
    body.lower = inSpace[b].lower;
    body.upper = inSpace[b].upper;
    body.ownLower = own[b].lower;
    body.ownUpper = own[b].upper;
    for (int d = 0; d < D; ++d)
      std::copy_n(state.bodies.info[b].axes[d], D, body.axes[d]);
    const Vector<D> extents = own[b].upper - own[b].lower;
    body.shortest = *std::min_element(extents.c, extents.c + D);
    body.longest = *std::max_element(extents.c, extents.c + D);
    const double depth = state.method.depth().at(0.5 * (body.lower[0] + body.upper[0]));
    double box = depth;
    for (int d = 0; d < D; ++d)
      box *= extents[d];
    body.fill = box > 0.0 ? std::min(1.0, body.volume / box) : 1.0;
    body.size = std::pow(body.volume / depth, 1.0 / D);
    setMaterial(state, state.bodies.info[b].material, body);
  }
  return bodies;
}

template std::vector<BodyMeasure<2>> measureBodies(const State<2>&);
template std::vector<BodyMeasure<3>> measureBodies(const State<3>&);

} // namespace Rhegma
