#pragma once
/// Where there is material at the start.

#include "geometry/NearestPoint.hpp"
#include "state/State.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

/// Where the undeformed bodies are, by their particles.
template <int D>
class BodyRegion
{
public:
  explicit BodyRegion(const State<D>& state)
      : bodies_(state.bodies.info),
        centres_(readVectors(state, fields::position)),
        edge_(readVectors(state, fields::edge)),
        body_(readBodies(state)),
        nearest_(centres_, reach())
  {
  }

  /// Whether x is within half a particle's diagonal of a particle's centre, as every point inside a body is.
  bool isNear(const Vector<D>& x) const { return nearest_.find(x) >= 0; }

  /// Whether x is in the box of the nearest particle.
  bool contains(const Vector<D>& x) const
  {
    const int p = nearest_.find(x);
    if (p < 0)
      return false;
    const BodyInfo<D>& body = bodies_[body_[p]];
    for (int i = 0; i < D; ++i)
    {
      double along = 0.0;
      for (int d = 0; d < D; ++d)
        along += body.axes[i][d] * (x[d] - centres_[p][d]);
      if (std::abs(along) > 0.5 * edge_[p][i] * (1.0 + 1e-6))
        return false;
    }
    return true;
  }

private:
  static std::vector<Vector<D>> readVectors(const State<D>& state, const std::string& field)
  {
    const auto values = onHost(state.particles.template real<D>(field));
    std::vector<Vector<D>> vectors(state.particles.size());
    for (int p = 0; p < state.particles.size(); ++p)
      for (int d = 0; d < D; ++d)
        vectors[p][d] = values(p, d);
    return vectors;
  }

  static std::vector<int> readBodies(const State<D>& state)
  {
    const auto body = onHost(state.particles.integer(fields::body));
    return std::vector<int>(body.data(), body.data() + state.particles.size());
  }

  double reach() const
  {
    double reach = 0.0;
    for (const Vector<D>& edge : edge_)
      reach = std::max(reach, 0.5 * norm(edge));
    return reach * (1.0 + 1e-9); // a point midway between centres is inside whatever the rounding
  }

  const std::vector<BodyInfo<D>>& bodies_;
  std::vector<Vector<D>> centres_, edge_;
  std::vector<int> body_;
  NearestPoint<D> nearest_;
};

} // namespace Rhegma::cracks
