#include "step/OutsideDomain.hpp"

#include "base/PointText.hpp"

namespace Rhegma
{

namespace
{

/// Where, and what helps. \param own what else helps
template <int D>
std::string positionAndHelp(const Vector<D>& x, const Grid<D>& grid, const std::string& own)
{
  return formatPoint(x) + "; the domain reaches from " + formatPoint(grid.lower) + " to " +
         formatPoint(grid.upper) + ": enlarge it (Domain > Lower Corner, Upper Corner), " + own +
         "; if material lies on the wrong side of a plane of symmetry, set Boundaries > * > Side (Type = "
         "Symmetry) to the side without material";
}

} // namespace

template <int D>
std::string textOfOutside(const Vector<D>& position, const Grid<D>& grid)
{
  return "part of the body lies outside the domain, such as at " +
         positionAndHelp(position, grid,
                         "move the body, or cut off what sticks out (Operations, Operation = Cut)");
}

template <int D>
std::string failureOutsideDomain(const State<D>& state, const std::string& otherwise)
{
  const auto position = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, state.particles.template real<D>(fields::position));
  const auto body =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::body));
  for (int p = 0; p < state.particles.size(); ++p)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = position(p, d);
    if (!state.mesh.grid.inside(x))
      return "a particle of the body " + state.bodies.info[body(p)].name + " left the domain, to " +
             positionAndHelp(x, state.mesh.grid,
                             "support the body (Boundaries), or end the run earlier (Time > Final Time)");
  }
  return otherwise;
}

template std::string textOfOutside(const Vector<2>&, const Grid<2>&);
template std::string textOfOutside(const Vector<3>&, const Grid<3>&);
template std::string failureOutsideDomain(const State<2>&, const std::string&);
template std::string failureOutsideDomain(const State<3>&, const std::string&);

} // namespace Rhegma
