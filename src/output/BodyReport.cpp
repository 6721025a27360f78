#include "output/BodyReport.hpp"

#include "material/Tensors.hpp"
#include "state/ParticlePlace.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace Rhegma
{

namespace
{

/// Sums over the particles of one body: mass, undeformed and present volume, then mass times position and
/// velocity, and undeformed volume times deformation gradient and Kirchhoff stress.
template <int D>
struct BodySums
{
  using value_type = double[];
  using size_type = int;
  using execution_space = ExecSpace;

  static constexpr int positionAt = 3, velocityAt = positionAt + D, deformationAt = velocityAt + D;
  static constexpr int stressAt = deformationAt + gradientSize<D>, size = stressAt + symmetricSize<D>;

  int value_count = size;
  int which;
  BorrowedView<int*> body;
  BorrowedView<double*> mass, volume;
  ParticlePlace<D> place;
  BorrowedView<double* [D]> velocity;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<double * [symmetricSize<D>]> stress;
  bool mechanics;

  BodySums(const State<D>& state, int number)
      : which(number),
        body(state.particles.integer(fields::body)),
        mass(state.particles.scalar(fields::mass)),
        volume(state.particles.scalar(fields::volume)),
        place(state.particles),
        deformation(state.particles.template real<gradientSize<D>>(fields::deformation)),
        mechanics(state.method.mechanics)
  {
    if (!mechanics)
      return;
    velocity = state.particles.template real<D>(fields::velocity);
    stress = state.particles.template real<symmetricSize<D>>(fields::stress);
  }

  KOKKOS_INLINE_FUNCTION void operator()(const int p, double* sum) const
  {
    if (body(p) != which)
      return;
    sum[0] += mass(p);
    sum[1] += volume(p);
    sum[2] += volume(p) * determinant<D>(&deformation(p, 0));
    for (int d = 0; d < D; ++d)
    {
      sum[positionAt + d] += mass(p) * place.now(p, d);
      sum[velocityAt + d] += mechanics ? mass(p) * velocity(p, d) : 0.0;
    }
    for (int k = 0; k < gradientSize<D>; ++k)
      sum[deformationAt + k] += volume(p) * deformation(p, k);
    for (int k = 0; k < symmetricSize<D> && mechanics; ++k)
      sum[stressAt + k] += volume(p) * stress(p, k);
  }
};

nlohmann::json named(const std::vector<const char*>& names, const double* sum, double fraction)
{
  nlohmann::json components;
  for (std::size_t k = 0; k < names.size(); ++k)
    components[names[k]] = fraction * sum[k];
  return components;
}

nlohmann::json listed(const double* sum, int count, double fraction)
{
  nlohmann::json list = nlohmann::json::array();
  for (int d = 0; d < count; ++d)
    list.push_back(fraction * sum[d]);
  return list;
}

} // namespace

namespace
{

/// The sums of all bodies one after another. Of many bodies each particle is looked at once.
template <int D>
std::vector<double> sumsOfBodies(const State<D>& state)
{
  using Sums = BodySums<D>;
  constexpr std::size_t many = 64;
  const std::size_t count = state.bodies.info.size();
  std::vector<double> sums(count * Sums::size, 0.0);
  if (count > many && Kokkos::SpaceAccessibility<Kokkos::HostSpace, MemorySpace>::accessible)
  {
    Sums one(state, 0);
    for (int p = 0; p < state.particles.size(); ++p)
    {
      one.which = one.body(p);
      one(p, sums.data() + static_cast<std::size_t>(one.which) * Sums::size);
    }
  }
  else
    for (std::size_t b = 0; b < count; ++b)
    {
      double sum[Sums::size] = {};
      Kokkos::parallel_reduce("rhegma::bodyReport", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
                              Sums(state, static_cast<int>(b)), sum);
      std::copy(sum, sum + Sums::size, sums.data() + b * Sums::size);
    }
  state.ranks.sum(sums.data(), static_cast<int>(sums.size()));
  return sums;
}

} // namespace

template <int D>
void bodyReport(const State<D>& state, nlohmann::json& summary, std::size_t most)
{
  using Sums = BodySums<D>;
  const std::vector<const char*> gradient =
      D == 2 ? std::vector<const char*>{"xx", "xy", "yx", "yy", "zz"}
             : std::vector<const char*>{"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
  const std::vector<const char*> symmetric =
      D == 2 ? std::vector<const char*>{"xx", "yy", "xy", "zz"}
             : std::vector<const char*>{"xx", "yy", "zz", "xy", "yz", "xz"};
  const std::vector<double> sums = sumsOfBodies(state);
  nlohmann::json& bodies = summary["bodies"];
  bodies = nlohmann::json::array();
  for (std::size_t b = 0; b < std::min(most, state.bodies.info.size()); ++b)
  {
    const double* const sum = sums.data() + b * Sums::size;
    nlohmann::json body;
    body["name"] = state.bodies.info[b].name;
    body["mass"] = sum[0];
    body["centre"] = listed(sum + Sums::positionAt, D, 1.0 / sum[0]);
    if (state.method.mechanics)
      body["velocity"] = listed(sum + Sums::velocityAt, D, 1.0 / sum[0]);
    if (state.method.mechanics)
      body["stress"] = named(symmetric, sum + Sums::stressAt, 1.0 / sum[2]);
    body["deformation"] = named(gradient, sum + Sums::deformationAt, 1.0 / sum[1]);
    bodies.push_back(std::move(body));
  }
}

template void bodyReport(const State<2>&, nlohmann::json&, std::size_t);
template void bodyReport(const State<3>&, nlohmann::json&, std::size_t);

} // namespace Rhegma
