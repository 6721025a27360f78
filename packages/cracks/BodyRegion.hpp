#pragma once
/// Where there is material at the start.

#include "geometry/NearestPoint.hpp"
#include "scene/SceneBodies.hpp"
#include "state/State.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

/// Where the undeformed bodies are: by their shapes, and at their surfaces by the nearest particle.
template <int D>
class BodyRegion
{
public:
  /// \param shapes of the scene's bodies; must outlive this \param state with their particles; without any,
  /// bodies end at the surfaces of their shapes \param holds whether particles of each body belong to these
  /// shapes; empty: all do
  BodyRegion(const SceneBodies<D>& shapes, const State<D>& state, const std::vector<bool>& holds = {})
      : shapes_(shapes),
        centres_(readCentres(state, holds)),
        reach_(reachOf(state)),
        nearest_(centres_, reach_.fromCentre)
  {
  }

  /// Whether x lies in a body.
  bool contains(const Vector<D>& x) const { return shapes_.contain(x); }

  /// The same of bodies that reach as far as the balls round their particles: half a particle's diagonal from
  /// a centre, which is up to 0.21 (2D) or 0.37 (3D) of an edge beyond the surface.
  bool isNear(const Vector<D>& x) const
  {
    return contains(x) ||
           (!centres_.empty() && shapes_.contain(x, reach_.beyondSurface) && nearest_.find(x) >= 0);
  }

private:
  static std::vector<Vector<D>> readCentres(const State<D>& state, const std::vector<bool>& holds)
  {
    const auto position = onHost(state.particles.template real<D>(fields::position));
    const auto body = onHost(state.particles.integer(fields::body));
    std::vector<Vector<D>> centres;
    for (int p = 0; p < state.particles.size(); ++p)
    {
      if (!holds.empty() && !holds[body(p)])
        continue;
      centres.emplace_back();
      for (int d = 0; d < D; ++d)
        centres.back()[d] = position(p, d);
    }
    return centres;
  }

  /// How far the ball round a particle reaches [m].
  struct Reach
  {
    double fromCentre = 0.0;
    double beyondSurface = 0.0;
  };

  /// The largest of all bodies, of cells of their lattices: boxes of thin parts may be longer.
  static Reach reachOf(const State<D>& state)
  {
    constexpr double rounding = 1.0 + 1e-9; // a point midway between centres is inside
    Reach largest;
    for (const BodyInfo<D>& body : state.bodies.info)
    {
      Vector<D> edge = body.edge;
      for (int d = 0; d < D; ++d)
        edge[d] = std::min(edge[d], state.mesh.grid.spacing);
      const double half = 0.5 * norm(edge) * rounding;
      largest.fromCentre = std::max(largest.fromCentre, half);
      largest.beyondSurface =
          std::max(largest.beyondSurface, half - 0.5 * *std::min_element(edge.c, edge.c + D));
    }
    return largest;
  }

  const SceneBodies<D>& shapes_;
  std::vector<Vector<D>> centres_;
  Reach reach_;
  NearestPoint<D> nearest_;
};

} // namespace Rhegma::cracks
