#include "cracks/SpringsInEquilibrium.hpp"

namespace Rhegma::cracks
{

template <int D>
typename SpringsInEquilibrium<D>::Groups SpringsInEquilibrium<D>::begin(const State<D>& state,
                                                                        const View<int*>& rowOf)
{
  springs_.clear();
  Groups groups;
  const Nodes<D>& nodes = state.mesh.nodes;
  for (int i = 0; i < nodes.numOfCracks && state.cracks.spring.extent(0) > 0; ++i)
  {
    const int n = nodes.parent(i), a = rowOf(n), b = rowOf(nodes.numLattice + i);
    if (a >= 0 && b >= 0 && state.cracks.spring(n, D) > 0.0 && isOwnedByThisRank(nodes, n))
    {
      springs_.push_back({{a, b}, state.cracks.spring(n, D)});
      groups.push_back({a, b});
    }
  }
  return groups;
}

template <int D>
void SpringsInEquilibrium<D>::add(const Values& displacement, const Values& force)
{
  for (const Spring& spring : springs_)
    for (int d = 0; d < D; ++d)
    {
      const int a = D * spring.row[0] + d, b = D * spring.row[1] + d;
      const double pull = spring.stiffness * (displacement(a) - displacement(b));
      force(a) -= pull;
      force(b) += pull;
    }
}

template <int D>
bool SpringsInEquilibrium<D>::addStiffness(bool, const AddBlock& addBlock)
{
  for (const Spring& spring : springs_)
  {
    double same[D * D] = {}, other[D * D] = {};
    for (int d = 0; d < D; ++d)
    {
      same[d * D + d] = spring.stiffness;
      other[d * D + d] = -spring.stiffness;
    }
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        addBlock(spring.row[a], spring.row[b], a == b ? same : other);
  }
  return true;
}

template class SpringsInEquilibrium<2>;
template class SpringsInEquilibrium<3>;

} // namespace Rhegma::cracks
