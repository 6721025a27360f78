#include "combustion/Channel.hpp"

#include "archive/Archive.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Rhegma::combustion
{

namespace
{

/// Passages to neighbours are up to twice as large as a cell's own section.
constexpr double courant = 0.4;

double minmod(double a, double b) { return a * b <= 0.0 ? 0.0 : std::fabs(a) < std::fabs(b) ? a : b; }

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

} // namespace

void Channel::setCells(const std::vector<double>& length, const std::vector<double>& fixedCapacity)
{
  length_ = length;
  fixed_ = fixedCapacity;
  const std::size_t n = length.size();
  for (std::vector<double>* field : {&volume_, &mass_, &momentum_, &energy_, &swept_, &burnt_})
    field->assign(n, 0.0);
}

void Channel::fill(double pressure, double temperature)
{
  for (int k = 0; k < size(); ++k)
    set(k, pressure, temperature, 0.0);
}

void Channel::set(int k, double pressure, double temperature, double velocity)
{
  mass_[k] = pressure * volume_[k] / (law_.constant * temperature + pressure * law_.covolume);
  momentum_[k] = mass_[k] * velocity;
  energy_[k] = mass_[k] * (law_.heatCapacity() * temperature + 0.5 * velocity * velocity);
}

void Channel::updateVolumes(const std::vector<double>& length, double gap, double density)
{
  length_ = length;
  for (int k = 0; k < size(); ++k)
    // Faces that overlap by the cells' own error keep their roughness.
    volume_[k] = fixed_[k] + gap * length[k] * width_ + std::max(swept_[k] + burnt_[k] / density, 0.0);
}

void Channel::remesh(const std::vector<double>& length, double from, double to, double gap, double density)
{
  const std::size_t n = length.size(), old = length_.size();
  std::vector<double> edge(n + 1, 0.0);
  for (std::size_t k = 0; k < n; ++k)
    edge[k + 1] = edge[k] + length[k];
  const double stretch = (to - from) / sum(length_);
  std::vector<double>* const fields[] = {&mass_, &momentum_, &energy_, &fixed_, &swept_, &burnt_};
  std::vector<double> next[6];
  for (std::vector<double>& field : next)
    field.assign(n, 0.0);
  double begin = from;
  for (std::size_t o = 0; o < old; ++o)
  {
    const double end = begin + stretch * length_[o];
    // The first and the last cell reach to infinity, so that rounding at the ends loses no gas.
    std::size_t first = std::upper_bound(edge.begin(), edge.end(), begin) - edge.begin();
    first = std::clamp<std::size_t>(first, 1, n) - 1;
    double left = 1.0;
    for (std::size_t k = first; k < n && left > 0.0; ++k)
    {
      const bool whole = k + 1 == n || edge[k + 1] >= end;
      const double part =
          whole ? left : std::clamp((edge[k + 1] - std::max(begin, edge[k])) / (end - begin), 0.0, left);
      for (int f = 0; f < 6; ++f)
        next[f][k] += part * (*fields[f])[o];
      left = whole ? 0.0 : left - part;
    }
    begin = end;
  }
  for (int f = 0; f < 6; ++f)
    *fields[f] = next[f];
  volume_.assign(n, 0.0);
  updateVolumes(length, gap, density);
  // New cells take gas from the nearest cell that has some, all at one density.
  std::vector<int> with;
  for (std::size_t k = 0; k < n; ++k)
    if (mass_[k] > 0.0)
      with.push_back(static_cast<int>(k));
  const auto spread = [&](int source, int first, int last) // cells first .. last, of which source has gas
  {
    double capacity = 0.0;
    for (int k = first; k <= last; ++k)
      capacity += volume_[k];
    const double m = mass_[source], P = momentum_[source], E = energy_[source];
    for (int k = first; k <= last; ++k)
    {
      mass_[k] = m * volume_[k] / capacity;
      momentum_[k] = P * volume_[k] / capacity;
      energy_[k] = E * volume_[k] / capacity;
    }
  };
  if (with.empty())
    return;
  if (with.back() + 1 < static_cast<int>(n))
    spread(with.back(), with.back(), static_cast<int>(n) - 1);
  if (with.front() > 0)
    spread(with.front(), 0, with.front());
}

double Channel::internal(int k) const { return energy_[k] - 0.5 * momentum_[k] * momentum_[k] / mass_[k]; }

double Channel::pressure(int k) const
{
  return (law_.heatRatio - 1.0) * internal(k) / (volume_[k] - law_.covolume * mass_[k]);
}

double Channel::temperature(int k) const { return internal(k) / (mass_[k] * law_.heatCapacity()); }

double Channel::allMass() const { return sum(mass_); }
double Channel::allEnergy() const { return sum(energy_); }
double Channel::allVolume() const { return sum(volume_); }

bool Channel::sound() const
{
  for (int k = 0; k < size(); ++k)
    if (!(mass_[k] > 0.0) || !(volume_[k] > law_.covolume * mass_[k]) || !(internal(k) > 0.0) ||
        !std::isfinite(energy_[k]))
      return false;
  return true;
}

Channel::State Channel::stateOf(int k) const { return {density(k), velocity(k), pressure(k)}; }

double Channel::soundSpeed(const State& s) const
{
  return std::sqrt(law_.heatRatio * s.pressure / (s.density * (1.0 - law_.covolume * s.density)));
}

/// Of a volume [J/m3].
double Channel::energyDensity(const State& s) const
{
  return s.pressure * (1.0 - law_.covolume * s.density) / (law_.heatRatio - 1.0) +
         0.5 * s.density * s.velocity * s.velocity;
}

Channel::Flux Channel::hllc(const State& l, const State& r) const
{
  const double cl = soundSpeed(l), cr = soundSpeed(r);
  const double sl = std::min(l.velocity - cl, r.velocity - cr);
  const double sr = std::max(l.velocity + cl, r.velocity + cr);
  const double ml = l.density * (sl - l.velocity), mr = r.density * (sr - r.velocity);
  const double middle =
      (r.pressure - l.pressure + l.velocity * ml - r.velocity * mr) / (ml - mr); // of the contact
  // Of one side: beyond its wave as it is, between wave and contact as the wave leaves it.
  const auto of = [&](const State& s, double wave, bool within) -> Flux
  {
    const double e = energyDensity(s);
    Flux f{s.density * s.velocity, s.density * s.velocity * s.velocity + s.pressure,
           s.velocity * (e + s.pressure)};
    if (!within)
      return f;
    const double density = s.density * (wave - s.velocity) / (wave - middle);
    const double energy =
        density *
        (e / s.density + (middle - s.velocity) * (middle + s.pressure / (s.density * (wave - s.velocity))));
    f.mass += wave * (density - s.density);
    f.momentum += wave * (density * middle - s.density * s.velocity);
    f.energy += wave * (energy - e);
    return f;
  };
  return middle >= 0.0 ? of(l, sl, sl < 0.0) : of(r, sr, sr > 0.0);
}

double Channel::longestStep() const
{
  double limit = 1e300;
  for (int k = 0; k < size(); ++k)
  {
    const State s = stateOf(k);
    limit = std::min(limit, length_[k] / (std::fabs(s.velocity) + soundSpeed(s)));
  }
  return courant * limit;
}

void Channel::applyWallFriction(double h)
{
  for (int k = 0; k < size(); ++k)
  {
    const double w = volume_[k] / (length_[k] * width_), u = std::fabs(velocity(k));
    const double rate = 12.0 * friction_.viscosity / (density(k) * w * w) + friction_.factor * u / (4.0 * w);
    momentum_[k] /= 1.0 + h * rate; // kinetic energy that is lost becomes heat
  }
}

void Channel::reconstruct(double h)
{
  const int n = size();
  left_.resize(n);
  right_.resize(n);
  for (int k = 0; k < n; ++k)
  {
    const State s = stateOf(k);
    left_[k] = right_[k] = s;
    if (k == 0 || k == n - 1)
      continue;
    const State a = stateOf(k - 1), b = stateOf(k + 1);
    const State d{minmod(s.density - a.density, b.density - s.density),
                  minmod(s.velocity - a.velocity, b.velocity - s.velocity),
                  minmod(s.pressure - a.pressure, b.pressure - s.pressure)};
    const double c = soundSpeed(s), half = 0.5 * h / length_[k];
    const State m{s.density - half * (s.velocity * d.density + s.density * d.velocity),
                  s.velocity - half * (s.velocity * d.velocity + d.pressure / s.density),
                  s.pressure - half * (s.velocity * d.pressure + s.density * c * c * d.velocity)};
    const State l{m.density - 0.5 * d.density, m.velocity - 0.5 * d.velocity, m.pressure - 0.5 * d.pressure};
    const State r{m.density + 0.5 * d.density, m.velocity + 0.5 * d.velocity, m.pressure + 0.5 * d.pressure};
    const double least = 0.2;
    if (std::min(l.density, r.density) > least * s.density &&
        std::min(l.pressure, r.pressure) > least * s.pressure &&
        law_.covolume * std::max(l.density, r.density) < 1.0)
    {
      left_[k] = l;
      right_[k] = r;
    }
  }
}

void Channel::flow(double h, const ChannelSupply& supply, ChannelLoss& loss)
{
  const int n = size();
  reconstruct(h);
  flux_.resize(n + 1);
  passage_.resize(n + 1);
  const auto section = [&](int k) { return volume_[k] / length_[k]; };
  for (int f = 1; f < n; ++f)
  {
    const double a = section(f - 1), b = section(f);
    passage_[f] = 2.0 * a * b / (a + b);
    flux_[f] = hllc(right_[f - 1], left_[f]);
  }
  const auto wall = [&](int k, double outward, const ChannelEnd& end, int f)
  {
    const State s = stateOf(k);
    const State mirror{s.density, -s.velocity, s.pressure};
    passage_[f] = section(k);
    flux_[f] = outward > 0.0 ? hllc(s, mirror) : hllc(mirror, s);
    flux_[f].mass = flux_[f].energy = 0.0;
    if (!(end.area > 0.0))
      return;
    // As from a reservoir in which the gas of the cell would be stagnant.
    double p = s.pressure, rest = temperature(k);
    law_.stagnate(p, rest, std::max(outward * s.velocity, 0.0));
    const double gone = std::min(law_.outflow(end.area, p, rest, end.outside), 0.5 * mass_[k] / h);
    const double out = outward / passage_[f];
    const double enthalpy = gone / mass_[k] * (energy_[k] + s.pressure * volume_[k]);
    flux_[f].mass = out * gone;
    flux_[f].momentum = s.pressure + out * gone * s.velocity;
    flux_[f].energy = out * enthalpy;
    loss.mass += h * gone;
    loss.energy += h * enthalpy;
  };
  wall(0, -1.0, supply.first, 0);
  wall(n - 1, 1.0, supply.last, n);
  for (int k = 0; k < n; ++k)
    left_[k].pressure = pressure(k); // pressure of the walls next to the passages
  for (int k = 0; k < n; ++k)
  {
    const double a = passage_[k], b = passage_[k + 1];
    mass_[k] += h * (a * flux_[k].mass - b * flux_[k + 1].mass);
    momentum_[k] += h * (a * flux_[k].momentum - b * flux_[k + 1].momentum + left_[k].pressure * (b - a));
    energy_[k] += h * (a * flux_[k].energy - b * flux_[k + 1].energy);
  }
}

ChannelLoss Channel::advance(double dt, const ChannelSupply& supply, double density)
{
  ChannelLoss loss;
  const double flame = law_.heatCapacity() * law_.flameTemperature;
  double cooled = 0.0, done = 0.0;
  constexpr int mostSubsteps = 100000;
  while (done < dt && loss.substeps < mostSubsteps && sound())
  {
    double h = longestStep();
    const double rest = dt - done;
    h = rest <= h ? rest : std::min(h, 0.5 * rest);
    const double part = h / dt;
    for (int k = 0; k < size(); ++k)
    {
      mass_[k] += part * supply.burnt[k];
      energy_[k] += part * (flame * supply.burnt[k] + supply.heat[k]);
      burnt_[k] += part * supply.burnt[k];
      volume_[k] += part * supply.burnt[k] / density;
      const double before = volume_[k] - law_.covolume * mass_[k];
      const double floor = 0.5 * volume_[k];
      const double opened = std::max(part * supply.opened[k], -floor);
      const double energy = internal(k);
      const double left = energy * std::pow(before / (before + opened), law_.heatRatio - 1.0);
      volume_[k] += opened;
      energy_[k] += left - energy;
      cooled += energy - left;
    }
    flow(h, supply, loss);
    applyWallFriction(h);
    if (law_.constantTemperature)
      for (int k = 0; k < size(); ++k)
      {
        const double kept = mass_[k] * law_.heatCapacity() * law_.flameTemperature, now = internal(k);
        energy_[k] += kept - now;
        loss.walls += now - kept;
      }
    done = h == rest ? dt : done + h;
    ++loss.substeps;
  }
  loss.left = dt - done;
  for (int k = 0; k < size(); ++k)
    swept_[k] += supply.opened[k];
  double all = 0.0;
  for (int k = 0; k < size(); ++k)
    all += internal(k);
  for (int k = 0; k < size(); ++k)
    energy_[k] += (cooled - supply.work) * internal(k) / all;
  if (law_.constantTemperature)
    for (int k = 0; k < size(); ++k)
    {
      const double kept = mass_[k] * law_.heatCapacity() * law_.flameTemperature, now = internal(k);
      energy_[k] += kept - now;
      loss.walls += now - kept;
    }
  return loss;
}

void Channel::serialize(Archive& archive)
{
  archive("length", length_);
  archive("volume", volume_);
  archive("mass", mass_);
  archive("momentum", momentum_);
  archive("energy", energy_);
  archive("fixed", fixed_);
  archive("swept", swept_);
  archive("burnt", burnt_);
}

} // namespace Rhegma::combustion
