#pragma once
/// Where there is material at the start.

#include "geometry/NearBoxes.hpp"
#include "geometry/NearestPoint.hpp"
#include "state/State.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
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
        whole_(wholeEdges(bodies_.size(), body_, edge_)),
        nearest_(centres_, reach())
  {
  }

  /// Whether x is within half a particle's diagonal of a particle's centre, or in its box, as every point
  /// inside a body is.
  bool isNear(const Vector<D>& x) const { return nearest_.find(x) >= 0 || contains(x); }

  /// Whether x is in the box of a particle, which for a part of a lattice cell is large enough to hold it.
  bool contains(const Vector<D>& x) const
  {
    if (!boxes_)
      boxes_ = std::make_unique<Geometry::NearBoxes<D>>(boundsOfParticles());
    const std::vector<int> near = boxes_->near({x, x}, 0.0);
    return std::any_of(near.begin(), near.end(), [&](int p) { return isInBox(x, p); });
  }

private:
  /// How far a particle reaches from its centroid along an axis, with some rounding: half its edge, or of a
  /// part up to D / (D + 1) of a whole edge, as in any convex shape.
  double half(int p, int axis) const
  {
    const double whole = whole_[body_[p]][axis];
    const bool isPart = norm(edge_[p] - whole_[body_[p]]) > 1e-6 * whole;
    return std::max(0.5 * edge_[p][axis], isPart ? D / (D + 1.0) * whole : 0.0) * (1.0 + 1e-6);
  }

  bool isInBox(const Vector<D>& x, int p) const
  {
    for (int i = 0; i < D; ++i)
    {
      double along = 0.0;
      for (int d = 0; d < D; ++d)
        along += bodies_[body_[p]].axes[i][d] * (x[d] - centres_[p][d]);
      if (std::abs(along) > half(p, i))
        return false;
    }
    return true;
  }

  std::vector<Geometry::Bounds<D>> boundsOfParticles() const
  {
    std::vector<Geometry::Bounds<D>> bounds;
    bounds.reserve(centres_.size());
    for (std::size_t p = 0; p < centres_.size(); ++p)
    {
      Vector<D> reach{};
      for (int d = 0; d < D; ++d)
        for (int i = 0; i < D; ++i)
          reach[d] += std::abs(bodies_[body_[p]].axes[i][d]) * half(static_cast<int>(p), i);
      bounds.push_back({centres_[p] - reach, centres_[p] + reach});
    }
    return bounds;
  }

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

  /// The median edges of the particles of each body.
  static std::vector<Vector<D>> wholeEdges(std::size_t bodies, const std::vector<int>& body,
                                           const std::vector<Vector<D>>& edge)
  {
    std::vector<Vector<D>> whole(bodies);
    for (int d = 0; d < D; ++d)
    {
      std::vector<std::vector<double>> edges(bodies);
      for (std::size_t p = 0; p < edge.size(); ++p)
        edges[body[p]].push_back(edge[p][d]);
      for (std::size_t b = 0; b < bodies; ++b)
      {
        const auto middle = edges[b].begin() + static_cast<std::ptrdiff_t>(edges[b].size() / 2);
        std::nth_element(edges[b].begin(), middle, edges[b].end());
        whole[b][d] = edges[b].empty() ? 0.0 : *middle;
      }
    }
    return whole;
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
  std::vector<Vector<D>> whole_; ///< edges of whole particles of each body [m]
  NearestPoint<D> nearest_;
  mutable std::unique_ptr<Geometry::NearBoxes<D>> boxes_; ///< of the particles, made when first needed
};

} // namespace Rhegma::cracks
