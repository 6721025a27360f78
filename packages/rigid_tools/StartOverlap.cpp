#include "rigid_tools/StartOverlap.hpp"

#include "base/Numbers.hpp"
#include "base/PointText.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma::rigid_tools
{

namespace
{

/// Overlap that is accepted [cells]: curved surfaces of files are known to about this.
constexpr double acceptedOverlap = 0.03;

/// Points of a domain along each axis, from one side to the other.
constexpr int pointsAlong = 5;

/// The point that lies deepest in a tool.
template <int D>
struct Deepest
{
  double depth = 0.0; ///< [m]
  Vector<D> at{};     ///< [m]
  int body = -1;      ///< its number
};

/// Takes into account the points of a domain that lie in its body.
template <int D>
void addDomain(const Shape<D>& tool, const Shape<D>& body, const Vector<D>& centre,
               const Vector<D> (&edge)[D], Deepest<D>& deepest)
{
  const double margin = 1e-6 * norm(edge[0]); // for points on the body's surface
  int points = 1;
  for (int d = 0; d < D; ++d)
    points *= pointsAlong;
  for (int k = 0; k < points; ++k)
  {
    Vector<D> x = centre;
    for (int e = 0, rest = k; e < D; ++e, rest /= pointsAlong)
      x = x + (double(rest % pointsAlong) / (pointsAlong - 1) - 0.5) * edge[e];
    const double depth = tool.depth(x);
    if (depth > deepest.depth && body.depth(x) >= -margin)
    {
      deepest.depth = depth;
      deepest.at = x;
    }
  }
}

template <int D>
Deepest<D> deepestPoint(const State<D>& state, const Shape<D>& tool, const std::vector<char>& touches,
                        const std::vector<Shape<D>>& shapes)
{
  const auto position = onHost(state.particles.template real<D>(fields::position));
  const auto edge = onHost(state.particles.template real<D>(fields::edge));
  const auto body = onHost(state.particles.integer(fields::body));
  const auto bounds = tool.bounds();
  Deepest<D> deepest;
  for (int p = 0; p < state.particles.size(); ++p)
  {
    if (touches[body(p)] == 0)
      continue;
    Vector<D> x, edges[D];
    double reach = 0.0;
    for (int e = 0; e < D; ++e)
    {
      x[e] = position(p, e);
      for (int d = 0; d < D; ++d)
        edges[e][d] = edge(p, e) * state.bodies.info[body(p)].axes[e][d];
      reach += 0.5 * norm(edges[e]);
    }
    bool near = true;
    for (int d = 0; d < D; ++d)
      near = near && x[d] > bounds.lower[d] - reach && x[d] < bounds.upper[d] + reach;
    if (!near || tool.depth(x) < -reach)
      continue;
    const double before = deepest.depth;
    addDomain(tool, shapes[body(p)], x, edges, deepest);
    deepest.body = deepest.depth > before ? body(p) : deepest.body;
  }
  return deepest;
}

} // namespace

template <int D>
void refuseOverlap(const State<D>& state, const Tool<D>& tool, const std::vector<char>& touches,
                   const Teuchos::ParameterList& bodies)
{
  std::vector<Shape<D>> shapes;
  for (const BodyInfo<D>& body : state.bodies.info)
    shapes.push_back(makeShape<D>(bodies.sublist(body.name)));
  const Deepest<D> found = deepestPoint(state, tool.shape(), touches, shapes);
  if (!(found.depth > acceptedOverlap * state.mesh.smallestSpacing()))
    return;
  throw std::invalid_argument(
      "Rigid Tools > " + tool.name() + ": overlaps Bodies > " + state.bodies.info[found.body].name +
      " by up to " + readableLength(found.depth) + " at the start, such as at " + formatPoint<D>(found.at) +
      "; move one of them, or name in Rigid Tools > " + tool.name() + " > Bodies the bodies that it touches");
}

template void refuseOverlap(const State<2>&, const Tool<2>&, const std::vector<char>&,
                            const Teuchos::ParameterList&);
template void refuseOverlap(const State<3>&, const Tool<3>&, const std::vector<char>&,
                            const Teuchos::ParameterList&);

} // namespace Rhegma::rigid_tools
