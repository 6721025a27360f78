#include "cracks/CrackMemory.hpp"

#include "archive/Archive.hpp"
#include "cracks/CrackFrames.hpp"
#include "cracks/Layout.hpp"

#include <string>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

/// Vertices and simplices of all cracks, one after another, as numbers of a crack of its own.
template <int D>
struct Meshes
{
  std::vector<int> sizes; ///< of each crack, vertices and simplices
  std::vector<int> simplices, beyond;
  std::vector<double> positions;

  explicit Meshes(const CrackSet<D>& set)
  {
    const auto vertex = onHost(set.vertex);
    const auto simplex = onHost(set.simplex);
    const auto neighbour = onHost(set.neighbour);
    for (const Crack<D>& crack : set.cracks)
    {
      sizes.insert(sizes.end(), {crack.numVertices, crack.numSimplices});
      for (int v = crack.firstVertex; v < crack.firstVertex + crack.numVertices; ++v)
        for (int d = 0; d < D; ++d)
          positions.push_back(vertex(v, d));
      for (int s = crack.firstSimplex; s < crack.firstSimplex + crack.numSimplices; ++s)
        for (int i = 0; i < D; ++i)
        {
          simplices.push_back(simplex(s, i) - crack.firstVertex);
          beyond.push_back(neighbour(s, i) < 0 ? neighbour(s, i) : neighbour(s, i) - crack.firstSimplex);
        }
    }
  }

  void serialize(Archive& archive)
  {
    archive("sizes", sizes, 2);
    archive("simplices", simplices, D);
    archive("beyond", beyond, D);
    archive("positions", positions, D);
  }

  std::vector<surface::CrackMesh<D>> meshes() const
  {
    std::vector<surface::CrackMesh<D>> all(sizes.size() / 2);
    std::size_t v = 0, s = 0;
    for (std::size_t c = 0; c < all.size(); ++c)
    {
      all[c].vertices.resize(sizes[2 * c]);
      all[c].simplices.resize(sizes[2 * c + 1]);
      all[c].beyond.resize(sizes[2 * c + 1]);
      for (Vector<D>& x : all[c].vertices)
        for (int d = 0; d < D; ++d)
          x[d] = positions.at(v++);
      for (std::size_t k = 0; k < all[c].simplices.size(); ++k)
        for (int i = 0; i < D; ++i, ++s)
        {
          all[c].simplices[k][i] = simplices.at(s);
          all[c].beyond[k][i] = beyond.at(s);
        }
    }
    return all;
  }
};

template <int D>
void storeNodes(CrackFront<D>& front, int firstVertex, Archive& archive)
{
  constexpr std::size_t whole = 7, real = 8; // numbers of a node
  std::vector<int> integers;
  std::vector<double> reals;
  for (const FrontNode<D>& n : front.nodes)
  {
    integers.insert(integers.end(), {n.vertex - firstVertex, n.facet >= 0 ? 0 : -1, n.name, n.from,
                                     n.stopped ? 1 : 0, n.advances ? 1 : 0, n.landed ? 1 : 0});
    reals.insert(reals.end(), {n.speed, n.temperature, n.driving.release, n.driving.modeI, n.driving.modeII,
                               n.driving.modeIII, n.driving.hoopAngle, n.advance});
  }
  archive("nodes", integers, whole);
  archive("node_values", reals, real);
  if (!archive.loads())
    return;
  front.nodes.assign(integers.size() / whole, {});
  for (std::size_t k = 0; k < front.nodes.size(); ++k)
  {
    FrontNode<D>& n = front.nodes[k];
    const int* of = &integers[whole * k];
    const double* value = &reals.at(real * k);
    n.vertex = of[0];
    n.facet = of[1];
    n.name = of[2];
    n.from = of[3];
    n.stopped = of[4] != 0;
    n.advances = of[5] != 0;
    n.landed = of[6] != 0;
    n.speed = value[0];
    n.temperature = value[1];
    n.driving = {value[2], value[3], value[4], value[5], value[6]};
    n.advance = value[7];
  }
}

} // namespace

template <int D>
void storeCracks(State<D>& state, Archive& archive)
{
  CrackSet<D>& set = state.cracks;
  Meshes<D> all(set);
  all.serialize(archive);
  std::vector<int> vertices;
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
  {
    CrackFront<D>& front = set.fronts[f];
    const Archive::Group group(archive, "front " + std::to_string(f));
    archive("vertex", front.vertex);
    archive("direction", front.direction); // of a front that has ended, as it is no longer computed
    archive("normal", front.normal);
    archive("grown", front.grown);
    archive("ended", front.ended);
    archive("required", front.budget.required);
    archive("pending", front.budget.pending);
    archive("released", front.budget.released);
    archive("carried_over", front.budget.carriedOver);
    archive("over_dissipated", front.budget.overDissipated);
    archive("advected", front.budget.advected);
    archive("toughness", front.budget.toughness);
    archive("largest_advance", front.extension.largest);
    archive("mean_advance", front.extension.mean);
    archive("new_area", front.extension.area);
    for (FrontEvent<D>* event : {&front.stop, &front.arrival})
    {
      const Archive::Group what(archive, event == &front.stop ? "stop" : "arrival");
      event->serialize(archive);
    }
    storeNodes(front, set.cracks[front.crack].firstVertex, archive);
    vertices.push_back(front.vertex);
  }
  if (archive.loads())
  {
    layOut(set, all.meshes(), state.mesh.grid.spacing);
    for (std::size_t f = 0; f < vertices.size(); ++f)
      set.fronts[f].vertex = vertices[f];
  }
  archive("face", set.face);
  if (state.method.totalLagrangian)
  {
    if (set.carried.extent(0) != set.vertex.extent(0))
      set.carried = View<double* [D]>("rhegma::crackDisplacement", set.vertex.extent(0));
    archive("carried", set.carried);
  }
  archive("near_front", set.nearFront);
  if (!archive.loads())
    return;
  updateNormals(set);
  updateFronts(set);
}

template void storeCracks(State<2>&, Archive&);
template void storeCracks(State<3>&, Archive&);

} // namespace Rhegma::cracks
