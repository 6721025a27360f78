#include "thermal/Start.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "material/ThermoLaw.hpp"
#include "scene/PositionFunction.hpp"
#include "thermal/CellExpansion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Rhegma::thermal
{

namespace
{

PositionFunction fieldOf(const Teuchos::ParameterList& body, const std::string& where)
{
  try
  {
    return PositionFunction::parse(body.get<std::string>("Temperature Field"), 1);
  }
  catch (const std::invalid_argument& wrong)
  {
    throw std::invalid_argument(where + ": " + wrong.what());
  }
}

/// Gradient of a function at x: along each axis the smaller of the differences to both sides, so that a step
/// next to x, as over a crack, does not count. \param by distance of the positions compared [m]
template <int D>
Vector<D> gradientOf(const PositionFunction& function, const Vector<D>& x, double by)
{
  const double here = function.scalar(x);
  Vector<D> gradient;
  for (int d = 0; d < D; ++d)
  {
    Vector<D> before = x, after = x;
    before[d] -= by;
    after[d] += by;
    const double back = (here - function.scalar(before)) / by, on = (function.scalar(after) - here) / by;
    gradient[d] = std::fabs(back) < std::fabs(on) ? back : on;
    if (!std::isfinite(gradient[d]))
      gradient[d] = 0.0;
  }
  return gradient;
}

} // namespace

void warnOfCold(std::vector<std::string>& warnings, const std::string& what, double T)
{
  constexpr double coldest = 77.0;
  if (T < coldest)
    warnings.push_back(
        what + " " + formatShort(T) + " K, which is " + formatShort(T - 273.15) +
        " degrees Celsius, colder than liquid nitrogen (77 K): is it meant in degrees Celsius? "
        "Temperatures are absolute");
  else if (T > 6000.0)
    warnings.push_back(what + " " + formatShort(T) + " K, at which no solid exists; check the exponent");
}

template <int D>
void startTemperature(State<D>& state, const Teuchos::ParameterList& bodies, double initial)
{
  const auto host = [](const auto& view) { return onHost(view); };
  const auto body = host(state.particles.integer(fields::body));
  const auto positions = host(state.particles.template real<D>(fields::position));
  const auto T = host(state.particles.scalar(fields::temperature));
  bool anyInitial = false;
  for (std::size_t b = 0; b < state.bodies.info.size(); ++b)
  {
    const std::string& name = state.bodies.info[b].name;
    const Teuchos::ParameterList& list = bodies.sublist(name);
    const double own = list.isParameter("Temperature") ? list.get<double>("Temperature") : initial;
    const bool varies = list.isParameter("Temperature Field");
    const std::string where = "Bodies > " + name + " > Temperature Field";
    const bool isInitial = !varies && !list.isParameter("Temperature");
    const PositionFunction function = varies ? fieldOf(list, where) : PositionFunction::parse("0", 1);
    double lowest = varies ? std::numeric_limits<double>::infinity() : own;
    for (int p = 0; p < state.particles.size(); ++p)
    {
      if (body(p) != static_cast<int>(b))
        continue;
      T(p) = own;
      if (varies)
      {
        Vector<D> x;
        for (int d = 0; d < D; ++d)
          x[d] = positions(p, d);
        T(p) = function.scalar(x);
      }
      if (!(T(p) > 0.0) || !std::isfinite(T(p)))
        throw std::invalid_argument(
            where + ": it is " + formatReal(T(p)) +
            " K at a particle; temperatures are absolute, write one that is above zero");
      lowest = std::min(lowest, T(p));
    }
    anyInitial = anyInitial || isInitial;
    if (!isInitial)
      warnOfCold(state.warnings, (varies ? where : "Bodies > " + name + " > Temperature") + ": it starts at",
                 lowest);
  }
  if (anyInitial)
    warnOfCold(state.warnings, "Thermal > Initial Temperature: bodies start at", initial);
  Kokkos::deep_copy(state.particles.scalar(fields::temperature), T);
}

template <int D>
void correctStart(State<D>& state, const Teuchos::ParameterList& bodies)
{
  constexpr double part = 1e-3; // of a cell
  const View<double* [D]> gradient("rhegma::thermal::startGradient", state.particles.size());
  const auto body = onHost(state.particles.integer(fields::body));
  const auto positions = onHost(state.particles.template real<D>(fields::position));
  const auto g = Kokkos::create_mirror_view(gradient);
  bool any = false;
  for (std::size_t b = 0; b < state.bodies.info.size(); ++b)
  {
    const std::string& name = state.bodies.info[b].name;
    const Teuchos::ParameterList& list = bodies.sublist(name);
    if (!list.isParameter("Temperature Field"))
      continue;
    any = true;
    const PositionFunction function = fieldOf(list, "Bodies > " + name + " > Temperature Field");
    for (int p = 0; p < state.particles.size(); ++p)
    {
      if (body(p) != static_cast<int>(b))
        continue;
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = positions(p, d);
      const Vector<D> own = gradientOf(function, x, part * state.mesh.smallestSpacing());
      for (int d = 0; d < D; ++d)
        g(p, d) = own[d];
    }
  }
  if (!any)
    return;
  Kokkos::deep_copy(gradient, g);
  correctExpansion(state, gradient);
  // The first step corrects for the change from here.
  const auto kept = state.particles.template real<D>(fields::temperatureGradient);
  Kokkos::parallel_for(
      "rhegma::thermal::startGradients", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        for (int d = 0; d < D; ++d)
          kept(p, d) = gradient(p, d);
      });
}

template <int D>
void startEnergy(State<D>& state)
{
  const ThermoTables tables = state.materials.thermo;
  const auto T = state.particles.scalar(fields::temperature);
  const auto internal = state.particles.scalar(fields::internalEnergy);
  const auto material = state.particles.integer(fields::material);
  if (!state.method.mechanics)
  {
    Kokkos::parallel_for(
        "rhegma::thermal::startHeat", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
        KOKKOS_LAMBDA(const int p) { internal(p) = ThermoPoint(tables, material(p), T(p)).heat(); });
    return;
  }
  const View<Properties*> materials = state.materials.device;
  const auto F = state.particles.template real<gradientSize<D>>(fields::deformation);
  const auto stress = state.particles.template real<symmetricSize<D>>(fields::stress);
  BorrowedView<double**> history;
  if (state.particles.has(fields::history))
    history = state.particles.table(fields::history);
  Kokkos::parallel_for(
      "rhegma::thermal::startStress", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        ThermoState result;
        const Properties& law = materials(material(p));
        const ThermoPoint at(tables, material(p), T(p));
        double before[gradientSize<D>]; // without thermal strain
        for (int k = 0; k < gradientSize<D>; ++k)
          before[k] = F(p, k) / at.stretch();
        withLaw<D>(law.law, law.plane,
                   ThermoStress{{before, 0.0, T(p)},
                                at,
                                T(p),
                                &F(p, 0),
                                &stress(p, 0),
                                history.extent(1) > 0 ? &history(p, 0) : nullptr,
                                result});
        internal(p) = result.internal;
      });
}

template <int D>
void copyGradient(State<D>& state, const SplitParts& parts)
{
  constexpr int number = 1 << D;
  const View<int*> whole = parts.whole;
  const int first = parts.first;
  const ThermoTables tables = state.materials.thermo;
  const auto T = state.particles.scalar(fields::temperature);
  const auto internal = state.particles.scalar(fields::internalEnergy);
  const auto material = state.particles.integer(fields::material);
  const auto x = state.particles.template real<D>(fields::position);
  const auto g = state.particles.template real<D>(fields::temperatureGradient);
  const bool mechanics = state.method.mechanics;
  const auto F = state.particles.template real<gradientSize<D>>(fields::deformation);
  Kokkos::parallel_for(
      "rhegma::thermal::splitByGradient", Kokkos::RangePolicy<ExecSpace>(0, whole.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int w = whole(i);
        const ThermoPoint at(tables, material(w), T(w));
        const double expansion = mechanics ? freeExpansion(at) : 0.0;
        const double capacity = at.capacity() + T(w) * expansion * heatOfExpansion<D>(at);
        double middle[D] = {};
        for (int k = 0; k < number; ++k)
          for (int d = 0; d < D; ++d)
            middle[d] += x(k == 0 ? w : first + i * (number - 1) + k - 1, d) / number;
        for (int k = 0; k < number; ++k)
        {
          const int p = k == 0 ? w : first + i * (number - 1) + k - 1;
          double rise = 0.0;
          for (int d = 0; d < D; ++d)
            rise += g(p, d) * (x(p, d) - middle[d]);
          T(p) += rise;
          internal(p) += capacity * rise;
          for (int c = 0; c < D * D && mechanics; ++c)
            F(p, c) *= 1.0 + expansion * rise;
        }
      });
}

template void startTemperature(State<2>&, const Teuchos::ParameterList&, double);
template void startTemperature(State<3>&, const Teuchos::ParameterList&, double);
template void correctStart(State<2>&, const Teuchos::ParameterList&);
template void correctStart(State<3>&, const Teuchos::ParameterList&);
template void startEnergy(State<2>&);
template void startEnergy(State<3>&);
template void copyGradient(State<2>&, const SplitParts&);
template void copyGradient(State<3>&, const SplitParts&);

} // namespace Rhegma::thermal
