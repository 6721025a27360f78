#include "cracks/GrowingCrack.hpp"

#include "cracks/CrackFrames.hpp"
#include "cracks/Layout.hpp"

#include <algorithm>
#include <utility>

namespace Rhegma::cracks
{

namespace
{

using surface::FrontLines;
using surface::FrontPoint;

/// A front as points of its crack.
template <int D>
FrontLines<D> linesOf(const CrackFront<D>& front, int firstVertex, const std::vector<double>& toughness)
{
  FrontLines<D> lines;
  for (std::size_t k = 0; k < front.nodes.size() && !front.ended; ++k)
  {
    const FrontNode<D>& node = front.nodes[k];
    FrontPoint<D> point;
    point.vertex = node.vertex - firstVertex;
    point.name = node.name;
    point.origin = static_cast<int>(k);
    point.joined = D == 3 && node.facet >= 0;
    point.stopped = node.stopped;
    point.landed = node.landed;
    point.toughness = k < toughness.size() ? toughness[k] : 0.0;
    point.direction = node.direction;
    point.normal = node.normal;
    lines.push_back(point);
  }
  return lines;
}

/// Gives a front the nodes of its points, and their toughness.
template <int D>
void putNodes(CrackFront<D>& front, const FrontLines<D>& lines, std::vector<double>& toughness)
{
  front.ended = lines.empty();
  toughness.clear();
  if (front.ended && D == 2) // it keeps its node
  {
    front.nodes[0].speed = 0.0;
    front.nodes[0].driving = {};
    return;
  }
  const std::vector<FrontNode<D>> before = std::exchange(front.nodes, {});
  for (const FrontPoint<D>& point : lines)
  {
    FrontNode<D> node = before[point.origin];
    if (point.stopped && !node.stopped)
      node.speed = 0.0;
    node.vertex = point.vertex;
    node.name = point.name;
    node.from = point.from;
    node.facet = D == 2 || point.joined ? 0 : -1;
    node.landed = point.landed;
    node.stopped = point.stopped || point.landed;
    front.nodes.push_back(node);
    toughness.push_back(point.toughness);
  }
}

/// Takes the displacement of the vertices of undeformed cells off their faces. New vertices, whose faces lie
/// on them, have that of the nearest other one.
template <int D>
void takeOffDisplacement(CrackSet<D>& set, std::vector<GrowingCrack<D>>& cracks)
{
  set.carried = View<double* [D]>("rhegma::crackDisplacement", set.vertex.extent(0));
  const auto carried = Kokkos::create_mirror_view(set.carried);
  for (std::size_t c = 0; c < cracks.size(); ++c)
  {
    auto& mesh = cracks[c].mesh;
    const int first = set.cracks[c].firstVertex, count = static_cast<int>(mesh.faces.size());
    std::vector<int> moved;
    const auto by = [&](int v) { return 0.5 * (mesh.faces[v][0] + mesh.faces[v][1]) - mesh.vertices[v]; };
    for (int v = 0; v < count; ++v)
      if (norm(by(v)) > 0.0)
        moved.push_back(v);
    std::vector<Vector<D>> all(count);
    for (int v = 0; v < count; ++v)
    {
      const auto distance = [&](int of) { return norm(mesh.vertices[of] - mesh.vertices[v]); };
      const auto nearest = std::min_element(moved.begin(), moved.end(),
                                            [&](int a, int b) { return distance(a) < distance(b); });
      all[v] = nearest != moved.end() ? by(*nearest) : Vector<D>{};
    }
    for (int v = 0; v < count; ++v)
    {
      if (norm(by(v)) > 0.0)
        for (Vector<D>& face : mesh.faces[v])
          face = face - all[v];
      for (int d = 0; d < D; ++d)
        carried(first + v, d) = all[v][d];
    }
  }
  Kokkos::deep_copy(set.carried, carried);
}

} // namespace

template <int D>
std::vector<GrowingCrack<D>> readGrowing(const CrackSet<D>& set, const FaceToughness& toughness)
{
  const auto vertex = onHost(set.vertex);
  const auto face = onHost(set.face);
  const auto carried = onHost(set.carried);
  const auto simplex = onHost(set.simplex);
  const auto neighbour = onHost(set.neighbour);
  const auto at = [](const auto& row)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = row(d);
    return x;
  };
  std::vector<GrowingCrack<D>> cracks(set.cracks.size());
  for (std::size_t c = 0; c < cracks.size(); ++c)
  {
    auto& mesh = cracks[c].mesh;
    const int v0 = set.cracks[c].firstVertex, s0 = set.cracks[c].firstSimplex,
              last = s0 + set.cracks[c].numSimplices - 1;
    for (int v = v0; v < v0 + set.cracks[c].numVertices; ++v)
    {
      mesh.vertices.push_back(at([&](int d) { return vertex(v, d); }));
      const auto by = [&](int d) { return carried.extent(0) > 0 ? carried(v, d) : 0.0; };
      mesh.faces.push_back({at([&](int d) { return face(v, 0, d) + by(d); }),
                            at([&](int d) { return face(v, 1, d) + by(d); })});
    }
    if constexpr (D == 2)
      mesh.joined = {neighbour(s0, 1) == facet::joined, neighbour(last, 0) == facet::joined};
    else
      for (int s = s0; s <= last; ++s)
        mesh.triangles.push_back({simplex(s, 0) - v0, simplex(s, 1) - v0, simplex(s, 2) - v0});
    mesh.prepare();
  }
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
  {
    const CrackFront<D>& front = set.fronts[f];
    const int firstVertex = set.cracks[front.crack].firstVertex;
    GrowingCrack<D>& crack = cracks[front.crack];
    crack.fronts.push_back(
        linesOf(front, firstVertex, f < toughness.size() ? toughness[f] : std::vector<double>{}));
    crack.numbers.push_back(static_cast<int>(f));
    FrontPoint<D> end;
    end.vertex = front.vertex - firstVertex;
    crack.ends.push_back(end);
  }
  return cracks;
}

template <int D>
void writeGrowing(CrackSet<D>& set, std::vector<GrowingCrack<D>>& cracks, FaceToughness& toughness,
                  double spacing)
{
  std::vector<surface::CrackMesh<D>> meshes;
  std::vector<int> end(set.fronts.size(), 0);
  toughness.resize(set.fronts.size());
  for (GrowingCrack<D>& crack : cracks)
  {
    std::vector<FrontLines<D>*> lines;
    for (FrontLines<D>& front : crack.fronts)
      lines.push_back(&front);
    std::vector<FrontLines<D>*> numbered = lines;
    numbered.push_back(&crack.ends);
    crack.mesh.tidy(numbered);
    meshes.push_back(crack.mesh.mesh({lines.begin(), lines.end()}));
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      end[crack.numbers[i]] = crack.ends[i].vertex;
      putNodes(set.fronts[crack.numbers[i]], *lines[i], toughness[crack.numbers[i]]);
    }
  }
  layOut(set, meshes, spacing);
  if (set.carried.extent(0) > 0)
    takeOffDisplacement(set, cracks);
  const auto face = onHost(set.face);
  for (std::size_t c = 0; c < cracks.size(); ++c)
    for (std::size_t v = 0; v < cracks[c].mesh.faces.size(); ++v)
      for (int side = 0; side < 2; ++side)
        for (int d = 0; d < D; ++d)
          face(set.cracks[c].firstVertex + v, side, d) = cracks[c].mesh.faces[v][side][d];
  Kokkos::deep_copy(set.face, face);
  bool ended = false;
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
    if (set.fronts[f].ended)
    {
      const Crack<D>& crack = set.cracks[set.fronts[f].crack];
      set.fronts[f].vertex = crack.firstVertex + std::clamp(end[f], 0, crack.numVertices - 1);
      ended = true;
    }
  if (ended)
    updateFronts(set);
}

template std::vector<GrowingCrack<2>> readGrowing(const CrackSet<2>&, const FaceToughness&);
template std::vector<GrowingCrack<3>> readGrowing(const CrackSet<3>&, const FaceToughness&);
template void writeGrowing(CrackSet<2>&, std::vector<GrowingCrack<2>>&, FaceToughness&, double);
template void writeGrowing(CrackSet<3>&, std::vector<GrowingCrack<3>>&, FaceToughness&, double);

} // namespace Rhegma::cracks
