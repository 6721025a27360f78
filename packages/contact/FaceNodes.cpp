#include "contact/FaceNodes.hpp"

#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

#include <cmath>

namespace Rhegma::contact
{

namespace
{

/// Part of the face of a cell by which the areas of a node's fields may differ inside of a body, where boxes
/// of particles do not tile it.
constexpr double unbalanced = 0.05;

/// Weight of a node in a particle's stencil that is more than rounding.
constexpr double leastWeight = 1e-12;

/// Sums over the particles around the fields of nodes that have two: of volume times slope [m2], and the
/// number of particles that see the field. Rows 2 i of the primary, 2 i + 1 of the enriched field.
template <int D>
struct FieldSums
{
  static constexpr int width = D + 1;
  View<double* [width]> rows;

  explicit FieldSums(const State<D>& state)
      : rows("rhegma::contact::fieldSums", 2 * state.mesh.nodes.numOfCracks)
  {
    const Nodes<D>& nodes = state.mesh.nodes;
    const View<int*> fieldOf("rhegma::contact::fieldOfNode", nodes.sums.extent(0));
    Kokkos::deep_copy(fieldOf, -1);
    for (int i = 0; i < nodes.numOfCracks; ++i)
    {
      fieldOf(nodes.parent(i)) = 2 * i;
      fieldOf(nodes.numLattice + i) = 2 * i + 1;
    }
    const auto volume = state.particles.scalar(fields::volume);
    withConnectivity(state,
                     [&](const auto& connect)
                     {
                       for (int p = 0; p < state.particles.size(); ++p)
                         connect.visit(p,
                                       [&](int node, double weight, const double* slope)
                                       {
                                         const int field = fieldOf(node);
                                         if (field < 0)
                                           return;
                                         rows(field, D) += weight > leastWeight ? 1.0 : 0.0;
                                         for (int d = 0; d < D; ++d)
                                           rows(field, d) += volume(p) * slope[d];
                                       });
                     });
    sumOverRanks(state, rows.data(), width, 0, width, fieldOf);
  }

  bool isSeen(int field) const { return rows(field, D) > 0.0; }
  Vector<D> area(int field) const
  {
    Vector<D> sum;
    for (int d = 0; d < D; ++d)
      sum[d] = rows(field, d);
    return sum;
  }
};

} // namespace

template <int D>
std::vector<FaceNode<D>> findFaceNodes(const State<D>& state)
{
  const Nodes<D>& nodes = state.mesh.nodes;
  const FieldSums<D> sums(state);
  std::vector<FaceNode<D>> found(nodes.numOfCracks);
  const double whole =
      std::pow(state.mesh.smallestSpacing(), D - 1) * (D == 2 ? state.method.thickness : 1.0);
  for (int i = 0; i < nodes.numOfCracks; ++i)
  {
    const bool primaryIsPlus = state.cracks.nodeSide(nodes.parent(i)) > 0;
    const int plus = 2 * i + (primaryIsPlus ? 0 : 1), minus = 2 * i + (primaryIsPlus ? 1 : 0);
    const int primary = nodes.parent(i), enriched = nodes.numLattice + i;
    found[i].plus = primaryIsPlus ? primary : enriched;
    found[i].minus = primaryIsPlus ? enriched : primary;
    found[i].isDouble = sums.isSeen(plus) && sums.isSeen(minus);
    found[i].area = 0.5 * (sums.area(minus) - sums.area(plus));
    found[i].isInside = norm(sums.area(minus) + sums.area(plus)) <= unbalanced * whole;
  }
  return found;
}

template std::vector<FaceNode<2>> findFaceNodes(const State<2>&);
template std::vector<FaceNode<3>> findFaceNodes(const State<3>&);

} // namespace Rhegma::contact
