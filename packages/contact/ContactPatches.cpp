#include "contact/ContactPatches.hpp"

#include "archive/Archive.hpp"
#include "contact/FacePatches.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::contact
{

namespace
{

/// Most by which the area of a node differs from that of the crack next to it: nodes that the crack or the
/// particles hardly touch would have areas of any size and sign.
constexpr double mostScale = 10.0;

} // namespace

template <int D>
Vector<D> ContactPatches<D>::tangent(int point, int which) const
{
  Vector<D> n;
  for (int d = 0; d < D; ++d)
    n[d] = contact_.points().normal(point, d);
  const Vector<D> along = reference_[point] - dot(reference_[point], n) * n;
  return faceTangent(n, (1.0 / norm(along)) * along, which);
}

template <int D>
void ContactPatches<D>::divide(const State<D>& state)
{
  const FacePoints<D>& points = contact_.points();
  const int count = points.count();
  if (contact_.pointsReplaced() || static_cast<int>(patchOf_.extent(0)) != count)
  {
    const std::vector<int> patch = findPatches(state, points);
    patchOf_ = View<int*>("rhegma::contactPatches", count);
    std::copy(patch.begin(), patch.end(), patchOf_.data());
  }
  patches_.clear();
  for (int k = 0; k < count; ++k)
  {
    patches_.resize(std::max(patches_.size(), static_cast<std::size_t>(patchOf_(k) + 1)));
    if (points.acts(k) != 0)
    {
      patches_[patchOf_(k)].points.push_back(k);
      patches_[patchOf_(k)].size += points.size(k) * state.method.thickness;
    }
  }
  reference_.assign(count, Vector<D>{});
  for (ContactPatch<D>& patch : patches_)
    for (const int k : patch.points)
    {
      patch.crack = points.crack(k);
      for (int d = 0; d < D; ++d)
        reference_[k][d] = points.edge(patch.points.front(), d);
    }
}

template <int D>
PatchFrames<D> ContactPatches<D>::framesOf(const State<D>& state, const std::vector<FaceNode<D>>& nodes) const
{
  const FacePoints<D>& points = contact_.points();
  std::vector<int> pairOf(state.mesh.nodes.sums.extent(0), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].isDouble)
      pairOf[nodes[i].plus] = pairOf[nodes[i].minus] = static_cast<int>(i);
  PatchFrames<D> frames(patches_.size());
  for (std::size_t m = 0; m < patches_.size(); ++m)
    for (const int k : patches_[m].points)
    {
      Vector<D> axes[D];
      for (int d = 0; d < D; ++d)
        axes[0][d] = points.normal(k, d);
      for (int t = 1; t < D; ++t)
        axes[t] = tangent(k, t - 1);
      for (const StencilTable<D>* const face : {&points.above, &points.below})
        for (int e = 0; e < face->count(k); ++e)
          if (const int i = pairOf[face->node(k, e)]; i >= 0)
            frames[m][i].add(0.5 * face->weight(k, e) * points.size(k) * state.method.thickness, axes);
    }
  addFramesOfRanks(state, nodes, frames);
  return frames;
}

template <int D>
void ContactPatches<D>::sumAreas(const State<D>& state, const PatchFrames<D>& frames,
                                 const std::vector<FaceNode<D>>& nodes, const std::vector<double>& scale)
{
  std::vector<double> sums(2 * patches_.size(), 0.0);
  for (std::size_t m = 0; m < patches_.size(); ++m)
    for (const auto& [i, frame] : frames[m])
      if (isOwnedByThisRank(state.mesh.nodes, nodes[i].plus))
      {
        sums[2 * m] += scale[i] * frame.area;
        sums[2 * m + 1] += std::fabs(scale[i]) * frame.area;
      }
  ranks_.sum(sums.data(), static_cast<int>(sums.size()));
  for (std::size_t m = 0; m < patches_.size(); ++m)
  {
    patches_[m].area = sums[2 * m];
    patches_[m].weights = sums[2 * m + 1];
  }
}

template <int D>
void ContactPatches<D>::addJumps(const State<D>& state, ContactPatch<D>& patch,
                                 const std::map<int, PatchFrame<D>>& frames,
                                 const std::vector<FaceNode<D>>& nodes,
                                 const std::vector<double>& scale) const
{
  const NodePositions<D> positions = nodePositions(state);
  for (const auto& [i, frame] : frames)
  {
    PatchNode<D> part;
    part.plus = nodes[i].plus;
    part.minus = nodes[i].minus;
    part.ofThisRank = isOwnedByThisRank(state.mesh.nodes, part.plus);
    part.position = positions(latticeNode(state.mesh.nodes, part.plus));
    for (int c = 0; c < D; ++c)
      for (int d = 0; d < D; ++d)
      {
        part.jump[c][d] = scale[i] / patch.area * frame.axes[c][d];
        part.axes[c][d] = frame.axes[c][d] / frame.area;
      }
    part.weight = std::fabs(scale[i]) * frame.area;
    patch.parts.push_back(part);
  }
  for (int d = 0; d < D && ranks_.many() && !patch.parts.empty(); ++d)
  {
    const auto isBelow = [d](const PatchNode<D>& a, const PatchNode<D>& b)
    { return a.position[d] < b.position[d]; };
    const auto [low, high] = std::minmax_element(patch.parts.begin(), patch.parts.end(), isBelow);
    patch.isWide = patch.isWide || high->position[d] - low->position[d] > mostApart_;
  }
}

template <int D>
void ContactPatches<D>::addHistory(const State<D>& state, ContactPatch<D>& patch) const
{
  const FacePoints<D>& points = contact_.points();
  for (const int k : patch.points)
  {
    const double weight = points.size(k) * state.method.thickness / patch.size;
    patch.gap += weight * contact_.gap()(k);
    patch.pressure += weight * contact_.pressure()(k);
    for (int s = 0; s < D - 1; ++s)
      for (int t = 0; t < D - 1; ++t)
        patch.shear[t] += weight * contact_.shear()(k, s) * dot(tangentOf(points, k, s), tangent(k, t));
  }
}

template <int D>
void ContactPatches<D>::collect(const State<D>& state)
{
  divide(state);
  ranks_ = ranksOf(state);
  mostApart_ = mostNodesApart * (1.0 + 1e-9) * state.mesh.grid.spacing;
  const std::vector<FaceNode<D>> nodes = findFaceNodes(state);
  const PatchFrames<D> frames = framesOf(state, nodes);
  std::vector<PatchFrame<D>> all(nodes.size()); // of all patches
  for (const auto& ofPatch : frames)
    for (const auto& [i, frame] : ofPatch)
      all[i].add(frame);
  std::vector<double> scale(nodes.size(), 1.0);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    Vector<D> normal;
    for (int d = 0; d < D; ++d)
      normal[d] = all[i].axes[0][d];
    if (const double square = dot(normal, normal); nodes[i].isInside && square > 0.0)
      scale[i] = std::clamp(dot(nodes[i].area, normal) / square, 1.0 / mostScale, mostScale);
  }
  sumAreas(state, frames, nodes, scale);
  for (std::size_t m = 0; m < patches_.size(); ++m)
  {
    addJumps(state, patches_[m], frames[m], nodes, scale);
    addHistory(state, patches_[m]);
  }
}

template <int D>
bool ContactPatches<D>::areCoupled(const ContactPatch<D>& patch, const PatchNode<D>& a,
                                   const PatchNode<D>& b) const
{
  bool near = true;
  for (int d = 0; d < D && patch.isWide; ++d)
    near = near && std::fabs(a.position[d] - b.position[d]) <= mostApart_;
  return near;
}

template <int D>
void ContactPatches<D>::serialize(Archive& archive)
{
  archive("patches", patchOf_);
}

template class ContactPatches<2>;
template class ContactPatches<3>;

} // namespace Rhegma::contact
