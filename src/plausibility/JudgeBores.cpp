#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/Judges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Rhegma
{

template <int D>
Messages judgeBores(const JudgedScene<D>& judged)
{
  const State<D>& state = judged.state;
  const double cell = state.mesh.grid.spacing;
  if (!state.method.axisymmetric || state.mesh.grid.origin[0] > cell)
    return {};
  // Strain energy of Lame's tube under inner pressure, with cells that begin at the axis: 0.01, 0.03, 0.09,
  // 0.93 and 1.007 of the exact one with a bore of 0.01, 0.3, 0.5, 1 and 2.2 cells in radius.
  constexpr double fewest = 1.5, touches = 1e-3, pi = 3.14159265358979;
  const auto position = onHost(state.particles.template real<D>(fields::position));
  const auto volume = onHost(state.particles.scalar(fields::volume));
  const auto body = onHost(state.particles.integer(fields::body));
  std::map<int, double> bores;
  for (int p = 0; p < state.particles.size(); ++p)
  {
    // Of a square box whose ring has this volume.
    const double half = 0.5 * std::sqrt(volume(p) / (2.0 * pi * std::max(position(p, 0), touches * cell)));
    const auto [found, added] = bores.emplace(body(p), std::numeric_limits<double>::infinity());
    found->second = std::min(found->second, position(p, 0) - half);
  }
  Messages messages;
  for (const auto& [number, radius] : bores)
    if (radius > touches * cell && radius < fewest * cell)
      messages.push_back(
          "Bodies > " + state.bodies.info[number].name + ": its bore has a radius of " +
          readableLength(radius) + ", " + formatShort(radius / cell) +
          " cells; below 1.5 cells nodes at the axis hold its wall, which is then up to a hundred times too "
          "stiff: use smaller cells (Domain > Cell Size), or let the cells begin at the bore (Domain > Lower "
          "Corner)");
  return messages;
}

template Messages judgeBores(const JudgedScene<2>&);
template Messages judgeBores(const JudgedScene<3>&);

} // namespace Rhegma
