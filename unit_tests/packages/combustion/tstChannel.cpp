/// Gas that flows along a slot: a shock tube, friction, what is conserved, and what stays at rest.

#include "combustion/Channel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace Rhegma
{
namespace Test
{
namespace
{

using combustion::Channel;
using combustion::ChannelLoss;
using combustion::ChannelSupply;
using combustion::GasLaw;

GasLaw air(double covolume = 0.0)
{
  GasLaw law;
  law.constant = 1.0;
  law.heatRatio = 1.4;
  law.covolume = covolume;
  law.flameTemperature = 4.0;
  return law;
}

/// A slot of length 1 whose section is 1, or changes by half along it.
Channel slot(int cells, const GasLaw& law, bool bulging = false, double viscosity = 0.0, double factor = 0.0)
{
  Channel channel(law, {viscosity, factor}, 1.0);
  std::vector<double> length(cells, 1.0 / cells), capacity(cells);
  for (int k = 0; k < cells; ++k)
    capacity[k] = length[k] * (bulging ? 1.0 + 0.5 * std::sin(7.0 * (k + 0.5) / cells) : 1.0);
  channel.setCells(length, capacity);
  channel.updateVolumes(length, 0.0, 1.0);
  return channel;
}

ChannelSupply nothing(int cells)
{
  ChannelSupply supply;
  supply.opened.assign(cells, 0.0);
  supply.burnt = supply.heat = supply.opened;
  return supply;
}

/// Mean error of the density in Sod's tube at time 0.2. The states next to the contact are Toro's (Riemann
/// Solvers and Numerical Methods for Fluid Dynamics, 2009, table 4.3, test 1).
double sodError(int cells)
{
  Channel tube = slot(cells, air());
  for (int k = 0; k < cells; ++k)
    k < cells / 2 ? tube.set(k, 1.0, 1.0, 0.0) : tube.set(k, 0.1, 0.8, 0.0);
  const double t = 0.2;
  tube.advance(t, nothing(cells), 1.0);
  const double p = 0.30313, u = 0.92745, behind = 0.42632, ahead = 0.26557, c = std::sqrt(1.4);
  const double shock = std::sqrt(1.4 * 0.1 / 0.125) * std::sqrt(6.0 / 7.0 * p / 0.1 + 1.0 / 7.0);
  const double tail = u - c * std::pow(p, 1.0 / 7.0);
  double error = 0.0;
  for (int k = 0; k < cells; ++k)
  {
    const double s = ((k + 0.5) / cells - 0.5) / t;
    const double exact = s < -c      ? 1.0
                         : s < tail  ? std::pow(5.0 / 6.0 - s / (6.0 * c), 5.0)
                         : s < u     ? behind
                         : s < shock ? ahead
                                     : 0.125;
    error += std::fabs(tube.density(k) - exact) / cells;
  }
  return error;
}

} // namespace

/// Shocks and contacts are of first order at best: the mean error falls as the cells do, or nearly so.
TEST(Channel, SolvesSodsShockTube)
{
  const double coarse = sodError(100), middle = sodError(200), fine = sodError(400);
  std::printf("mean error of the density with 100, 200, 400 cells: %.5f, %.5f, %.5f\n", coarse, middle, fine);
  EXPECT_LT(coarse, 0.01);
  EXPECT_LT(middle, coarse / 1.6);
  EXPECT_LT(fine, middle / 1.6);
}

/// Far from the ends a uniform flow feels the walls alone: u falls as exp(-12 mu t / (rho w^2)) where it is
/// laminar and as 1 / (1 + f u0 t / 4 w) where it is rough.
TEST(Channel, HasWallFriction)
{
  const int cells = 100;
  const double t = 0.2, u = 0.5;
  for (const bool laminar : {true, false})
  {
    Channel channel = slot(cells, air(), false, laminar ? 0.4 : 0.0, laminar ? 0.0 : 20.0);
    for (int k = 0; k < cells; ++k)
      channel.set(k, 1.0, 1.0, u);
    const double energy = channel.allEnergy();
    channel.advance(t, nothing(cells), 1.0);
    const double exact = laminar ? u * std::exp(-12.0 * 0.4 * t) : u / (1.0 + 20.0 * u * t / 4.0);
    std::printf("speed %.5f, closed form %.5f\n", channel.velocity(cells / 2), exact);
    EXPECT_NEAR(channel.velocity(cells / 2), exact, 0.01 * exact); // steps of the first order in time
    EXPECT_NEAR(channel.allEnergy(), energy, 1e-13 * energy);
  }
}

/// Gas at rest under one pressure stays at rest where the slot is wide and where it is narrow.
TEST(Channel, StaysAtRestInASlotOfVaryingWidth)
{
  const int cells = 40;
  for (const double covolume : {0.0, 0.2})
  {
    Channel channel = slot(cells, air(covolume), true);
    channel.fill(2.0, 1.5);
    channel.advance(10.0, nothing(cells), 1.0);
    for (int k = 0; k < cells; ++k)
    {
      EXPECT_NEAR(channel.velocity(k), 0.0, 1e-12);
      EXPECT_NEAR(channel.pressure(k), 2.0, 1e-11);
    }
  }
}

/// What burns evenly in a rigid slot has the pressure and the temperature of the uniform gas.
TEST(Channel, BurnsInARigidSlotAsTheUniformGasDoes)
{
  const int cells = 20;
  for (const double covolume : {0.0, 0.2})
  {
    Channel channel = slot(cells, air(covolume), true);
    channel.fill(1.0, 1.0);
    combustion::Gas gas(air(covolume));
    const double capacity = channel.allVolume();
    gas.fill(1.0, 1.0, capacity);
    for (int step = 0; step < 50; ++step)
    {
      ChannelSupply supply = nothing(cells);
      for (int k = 0; k < cells; ++k)
        supply.burnt[k] = 0.02 * channel.volume(k);
      // Of a solid so dense that its volume vanishes.
      channel.advance(0.05, supply, 1e30);
      gas.burn(0.02 * capacity, 0.0);
    }
    for (int k = 0; k < cells; ++k)
    {
      EXPECT_NEAR(channel.temperature(k), gas.temperature(), 1e-10);
      EXPECT_NEAR(channel.pressure(k), gas.pressure(capacity), 1e-10 * gas.pressure(capacity));
    }
  }
}

/// Mass and energy through burning on one side, faces that move, walls that take heat, an open end, and cells
/// that are remeshed as the slot grows.
TEST(Channel, KeepsMassAndEnergy)
{
  int cells = 30;
  Channel channel = slot(cells, air(0.05), true, 1e-3, 0.05);
  channel.fill(1.0, 1.0);
  double mass = channel.allMass(), energy = channel.allEnergy(), out = 0.0;
  for (int step = 0; step < 200; ++step)
  {
    ChannelSupply supply = nothing(cells);
    supply.last = {0.3, 0.1};
    for (int k = 0; k < cells; ++k)
    {
      supply.burnt[k] = k < cells / 3 ? 1e-3 : 0.0;
      supply.heat[k] = -1e-4 * channel.internal(k);
      supply.opened[k] = 1e-2 * channel.volume(k) * std::sin(0.3 * k + 0.1 * step);
      supply.work += channel.pressure(k) * supply.opened[k];
      mass += supply.burnt[k];
      energy += supply.burnt[k] * air().heatCapacity() * 4.0 + supply.heat[k];
    }
    energy -= supply.work;
    const ChannelLoss loss = channel.advance(0.01, supply, 1e3);
    mass -= loss.mass;
    energy -= loss.energy;
    out += loss.mass;
    ASSERT_TRUE(channel.sound()) << step;
    if (step % 50 == 49)
    {
      cells += 7;
      const double whole = 1.0 + 0.1 * (step + 1) / 50;
      channel.remesh(std::vector<double>(cells, whole / cells), 0.05, whole - 0.05, 0.2, 1e3);
    }
    EXPECT_NEAR(channel.allMass(), mass, 1e-12 * mass);
    EXPECT_NEAR(channel.allEnergy(), energy, 1e-12 * energy);
  }
  EXPECT_GT(out, 0.0);
}

/// The outflow at an end is that of the stagnant gas, also with a covolume.
TEST(Channel, VentsStagnantGasAtItsEnd)
{
  const GasLaw law = air(0.3);
  const int cells = 10;
  Channel channel = slot(cells, law);
  for (int k = 0; k < cells; ++k)
    channel.set(k, 1.0, 1.0, 0.4);
  ChannelSupply supply = nothing(cells);
  supply.last = {0.2, 0.1};
  const double dt = 1e-4;
  const ChannelLoss loss = channel.advance(dt, supply, 1.0);
  ASSERT_EQ(loss.substeps, 1);
  double p = 1.0, T = 1.0;
  law.stagnate(p, T, 0.4);
  const double gone = dt * law.outflow(0.2, p, T, 0.1);
  EXPECT_NEAR(loss.mass, gone, 1e-12 * gone);
  // each kilogram has the enthalpy c_p T + b p.
  EXPECT_NEAR(loss.energy, gone * (1.4 * law.heatCapacity() * T + 0.3 * p), 1e-12 * gone);
}

/// Remeshing with cells of the same length changes nothing.
TEST(Channel, IsUnchangedByTheSameMesh)
{
  const int cells = 25;
  Channel channel = slot(cells, air(), true);
  for (int k = 0; k < cells; ++k)
    channel.set(k, 1.0 + 0.3 * std::sin(k), 1.0 + 0.2 * std::cos(k), 0.1 * k);
  const Channel before = channel;
  channel.remesh(std::vector<double>(cells, 1.0 / cells), 0.0, 1.0, 0.0, 1.0);
  for (int k = 0; k < cells; ++k)
  {
    EXPECT_NEAR(channel.pressure(k), before.pressure(k), 1e-11);
    EXPECT_NEAR(channel.velocity(k), before.velocity(k), 1e-11);
  }
}

} // namespace Test
} // namespace Rhegma
