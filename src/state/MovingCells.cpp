#include "state/MovingCells.hpp"

#include "archive/Archive.hpp"
#include "state/Subdomain.hpp"

#include <stdexcept>

namespace Rhegma
{

template <int D>
void moveCells(State<D>& state)
{
  const Vector<D> by = state.mesh.ahead;
  if (!(dot(by, by) > 0.0))
    return;
  if (state.mesh.tree.refined())
    throw std::logic_error("refined cells can't move");
  if (!state.mesh.subdomain)
    return state.mesh.grid.translate(by);
  Subdomain<D>& part = *state.mesh.subdomain;
  part.division.lattice.translate(by);
  part.own.lattice.translate(by);
  part.refined.translate(by);
  state.mesh.grid = part.division.window(state.ranks.rank());
}

template <int D>
void archiveCells(State<D>& state, Archive& archive)
{
  const Archive::Group group(archive, "lattice");
  Grid<D> lattice = wholeLattice(state);
  archive("origin", lattice.origin);
  archive("lower", lattice.lower);
  archive("upper", lattice.upper);
  archive("node_0", lattice.whole);
  archive("ahead", state.mesh.ahead);
  if (archive.loads())
    state.mesh.grid = lattice;
}

template void moveCells(State<2>&);
template void moveCells(State<3>&);
template void archiveCells(State<2>&, Archive&);
template void archiveCells(State<3>&, Archive&);

} // namespace Rhegma
