#include "thermal/HeatBoundaries.hpp"

#include "base/Attempts.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "boundary/Contradictions.hpp"
#include "thermal/Start.hpp"
#include "transfer/PushNodes.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace Rhegma::thermal
{

namespace
{

template <int D>
bool holdsNode(const Grid<D>& grid, const HeldTemperature<D>& box)
{
  for (int d = 0; d < D; ++d)
  {
    const double from = std::max(box.lower[d], grid.lower[d]), to = std::min(box.upper[d], grid.upper[d]);
    if (!(std::ceil(grid.inCells(from, d) - 1e-9) <= grid.inCells(to, d) + 1e-9))
      return false;
  }
  return true;
}

template <int D>
HeldTemperature<D> readHeld(const Teuchos::ParameterList& list, const State<D>& state,
                            const std::string& name)
{
  HeldTemperature<D> held{readVector<D>(list, "Lower Corner"), readVector<D>(list, "Upper Corner"),
                          list.get<double>("Temperature"),
                          TimeFunction::parse(list.get<std::string>("History")), name};
  // Nodes on the boundary of a box belong to it, independent of round-off.
  for (int d = 0; d < D; ++d)
  {
    held.lower[d] -= 1e-9 * state.mesh.grid.spacing;
    held.upper[d] += 1e-9 * state.mesh.grid.spacing;
  }
  if (!holdsNode(state.mesh.grid, held))
    throw std::invalid_argument("Boundaries > " + name +
                                ": the box holds no node of the cells inside the domain, so nothing is "
                                "prescribed; make it a cell thick or move it");
  return held;
}

template <int D>
HeatedSurface<D> readHeated(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list,
                            const State<D>& state, const std::string& name)
{
  HeatedSurface<D> heated{readSurface<D>(scene, list, state, name), 0.0, 0.0, 0.0,
                          TimeFunction::parse(list.get<std::string>("History"))};
  if (list.get<std::string>("Type") == "Heat Flux")
    heated.flux = list.get<double>("Flux");
  else
  {
    heated.coefficient = list.get<double>("Coefficient");
    heated.ambient = list.get<double>("Ambient Temperature");
  }
  return heated;
}

} // namespace

template <int D>
void HeatBoundaries<D>::read(const Teuchos::ParameterList& scene, State<D>& state)
{
  const Teuchos::ParameterList& section = scene.sublist("Boundaries");
  Attempts attempts;
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const std::string type = list.get<std::string>("Type");
    if (type == "Temperature")
      attempts.attempt([&] { held_.push_back(readHeld<D>(list, state, name)); });
    else if (type == "Heat Flux" || type == "Convection")
      attempts.attempt([&] { surfaces_.push_back(readHeated<D>(scene, list, state, name)); });
  }
  attempts.throwIfAny();
  const auto warn = [&](const std::string& name, const char* what, double T)
  { warnOfCold(state.warnings, "Boundaries > " + name + " > " + what + ": it starts at", T); };
  for (const HeldTemperature<D>& held : held_)
    warn(held.name, "Temperature", held.temperature * held.history(state.clock.time));
  for (const HeatedSurface<D>& heated : surfaces_)
    if (heated.coefficient > 0.0)
      warn(heated.surface.points.name(), "Ambient Temperature",
           heated.ambient * heated.history(state.clock.time));
}

template <int D>
std::string HeatBoundaries<D>::asText() const
{
  std::string text;
  const auto add = [&](const std::string& name, const char* parameter, double value, const char* unit)
  {
    text += (text.empty() ? "Boundaries > " : ", Boundaries > ") + name + " > " + parameter + " (" +
            formatShort(value) + " " + unit + ")";
  };
  for (const HeatedSurface<D>& heated : surfaces_)
    if (const std::string& name = heated.surface.points.name(); heated.coefficient > 0.0)
      add(name, "Coefficient", heated.coefficient, "W/(m2 K)");
    else
      add(name, "Flux", heated.flux, "W/m2");
  for (const HeldTemperature<D>& held : held_)
    add(held.name, "Temperature", held.temperature, "K");
  return text;
}

template <int D>
std::string HeatBoundaries<D>::contradictions(const State<D>& state, double finalTime) const
{
  std::vector<TimedConstraint<D>> supports;
  for (const HeldTemperature<D>& held : held_)
  {
    TimedConstraint<D> support{{}, {}, held.history, held.name};
    support.constraint.lower = held.lower;
    support.constraint.upper = held.upper;
    for (int d = 0; d < D; ++d)
    {
      support.constraint.holds[d] = d == 0;
      support.value[d] = d == 0 ? held.temperature : 0.0;
    }
    supports.push_back(support);
  }
  return Rhegma::contradictions(supports, state, finalTime, {"temperature", "K", false});
}

template <int D>
void HeatBoundaries<D>::hold(const State<D>& state, const HeatNodes<D>& heat, double time) const
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  for (const HeldTemperature<D>& held : held_)
  {
    const Vector<D> lower = held.lower, upper = held.upper;
    const double temperature = held.temperature * held.history(time);
    Kokkos::parallel_for(
        "rhegma::thermal::holdTemperature", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
        KOKKOS_LAMBDA(const int i) {
          const int n = activeNode(nodes, i);
          const Vector<D> x = positions(latticeNode(nodes, n));
          for (int d = 0; d < D; ++d)
            if (x[d] < lower[d] || x[d] > upper[d])
              return;
          if (heat.held(n) != 0 || !(heat.sums(n, HeatNodes<D>::capacityAt) > 0.0))
            return;
          heat.held(n) = 1;
          heat.value(n, 1) = temperature - heat.value(n, 0);
          heat.value(n, 0) = temperature;
        });
  }
}

template <int D>
double HeatBoundaries<D>::addFlux(State<D>& state, const HeatNodes<D>& heat, double begin, double dt)
{
  double power = 0.0;
  for (HeatedSurface<D>& heated : surfaces_)
  {
    Load<D>& points = heated.surface.points;
    points.place(state);
    const StencilTable<D> stencils = points.nodesAround();
    const View<double*> fraction = points.fractions();
    const double area = heated.surface.area, now = heated.history.overStep(begin, begin + dt);
    const double flux = now * heated.flux, coefficient = heated.coefficient, ambient = now * heated.ambient;
    const View<double> sum("rhegma::thermal::powerOfSurface");
    forEachPushing(
        "rhegma::thermal::addFlux", points.points(), KOKKOS_LAMBDA(const int k) {
          double T = 0.0;
          for (int e = 0; e < stencils.count(k); ++e)
            T += stencils.weight(k, e) * heat.value(stencils.node(k, e), 0);
          const double inflow = fraction(k) * area * (coefficient > 0.0 ? coefficient * (ambient - T) : flux);
          Kokkos::atomic_add(&sum(), inflow);
          for (int e = 0; e < stencils.count(k); ++e)
            Kokkos::atomic_add(&heat.rate(stencils.node(k, e), 0), stencils.weight(k, e) * inflow);
        });
    double added = 0.0;
    Kokkos::deep_copy(added, sum);
    power += added;
  }
  return power;
}

template <int D>
double HeatBoundaries<D>::addResponse(const View<double* [2]>& change, const View<double* [2]>& flow) const
{
  double power = 0.0;
  for (const HeatedSurface<D>& heated : surfaces_)
  {
    if (!(heated.coefficient > 0.0))
      continue;
    const Load<D>& points = heated.surface.points;
    const StencilTable<D> stencils = points.nodesAround();
    const View<double*> fraction = points.fractions();
    const double perKelvin = heated.surface.area * heated.coefficient;
    const View<double> sum("rhegma::thermal::changeOfPower");
    forEachPushing(
        "rhegma::thermal::addResponse", points.points(), KOKKOS_LAMBDA(const int k) {
          double T = 0.0;
          for (int e = 0; e < stencils.count(k); ++e)
            T += stencils.weight(k, e) * change(stencils.node(k, e), 0);
          const double inflow = -fraction(k) * perKelvin * T;
          Kokkos::atomic_add(&sum(), inflow);
          for (int e = 0; e < stencils.count(k); ++e)
            Kokkos::atomic_add(&flow(stencils.node(k, e), 0), stencils.weight(k, e) * inflow);
        });
    double added = 0.0;
    Kokkos::deep_copy(added, sum);
    power += added;
  }
  return power;
}

template <int D>
void HeatBoundaries<D>::addDiagonal(const View<double*>& diagonal) const
{
  for (const HeatedSurface<D>& heated : surfaces_)
  {
    const Load<D>& points = heated.surface.points;
    const StencilTable<D> stencils = points.nodesAround();
    const View<double*> fraction = points.fractions();
    const double perKelvin = heated.surface.area * heated.coefficient;
    forEachPushing(
        "rhegma::thermal::addDiagonal", perKelvin > 0.0 ? points.points() : 0, KOKKOS_LAMBDA(const int k) {
          // The sum over the row, an upper bound of its diagonal.
          for (int e = 0; e < stencils.count(k); ++e)
            Kokkos::atomic_add(&diagonal(stencils.node(k, e)),
                               stencils.weight(k, e) * fraction(k) * perKelvin);
        });
  }
}

template <int D>
double HeatBoundaries<D>::stepLimit(double capacity, double spacing) const
{
  double limit = std::numeric_limits<double>::infinity();
  for (const HeatedSurface<D>& heated : surfaces_)
    if (heated.coefficient > 0.0)
      limit = std::min(limit, 0.25 * capacity * spacing / heated.coefficient);
  return limit;
}

template class HeatBoundaries<2>;
template class HeatBoundaries<3>;

} // namespace Rhegma::thermal
