#pragma once
/// Gas that flows along a crack.

#include "combustion/Gas.hpp"

#include <vector>

namespace Rhegma::combustion
{

/// What the walls do to the flow between them, the faces of a slot of width w:
///
///     d u / d t = - 12 mu u / (rho w^2) - f |u| u / (4 w)
///
/// the first as of a fully developed laminar flow, the second of a rough slot by Darcy's friction factor
/// (White, Viscous Fluid Flow, 1991, section 3-3 and 6-6).
struct WallFriction
{
  double viscosity = 0.0; ///< mu [Pa s]
  double factor = 0.0;    ///< f [-]
};

/// An end of the channel: closed, or open to the outside.
struct ChannelEnd
{
  double area = 0.0;    ///< of the opening, times its coefficient of discharge; 0: closed [m2]
  double outside = 0.0; ///< pressure [Pa]
};

/// Mass, heat and volume that are added to the cells of a channel over a step, a number for each cell.
struct ChannelSupply
{
  std::vector<double> opened; ///< by the faces [m3]
  std::vector<double> burnt;  ///< [kg]
  std::vector<double> heat;   ///< of the burnt solid beyond that of its flame, less that to the walls [J]
  double work = 0.0;          ///< of the gas on the opening faces [J]
  ChannelEnd first{}, last{}; ///< of the channel
};

/// What left a channel over a step.
struct ChannelLoss
{
  double mass = 0.0;   ///< that flowed out [kg]
  double energy = 0.0; ///< its enthalpy [J]
  double walls = 0.0;  ///< heat to walls that keep the temperature [J]
  int substeps = 0;
  double left = 0.0; ///< of the step, that the most substeps did not reach [s]
};

/// Mass, momentum and energy of gas in a slot whose width changes along it and in time, in finite volumes
/// along its arc: the fluxes of HLLC between states that limited slopes and half a step extrapolate to the
/// faces (Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 2009, sections 10.4 and 14.4).
/// Between cells the gas passes the harmonic mean of their sections, and the walls' pressure on either side
/// of it keeps gas at rest at rest. The channel takes explicit substeps limited by its fastest wave.
///
/// Volume that the faces open cools the gas of its cell adiabatically; the difference to the total work on
/// the faces is distributed in proportion to the energy, so that mass and energy are kept to round-off.
class Channel
{
public:
  Channel() = default;
  Channel(const GasLaw& law, const WallFriction& friction, double width)
      : law_(law), friction_(friction), width_(width)
  {
  }

  /// Creates empty cells of these lengths [m], each with a fixed volume in addition to that between the faces
  /// [m3].
  void setCells(const std::vector<double>& length, const std::vector<double>& fixedCapacity);
  /// Fills all cells.
  void fill(double pressure, double temperature);

  /// Remeshes the channel of a crack that has grown: the old cells lie between `from` and `to` of the arc [m]
  /// of the new ones. Their content is distributed by overlapping length; new cells get the gas of their
  /// neighbours.
  void remesh(const std::vector<double>& length, double from, double to, double gap, double density);
  /// Updates the volumes of the cells from what faces have swept and burnt. \param gap roughness of the faces
  /// [m]
  void updateVolumes(const std::vector<double>& length, double gap, double density);

  ChannelLoss advance(double dt, const ChannelSupply& supply, double density);

  int size() const { return static_cast<int>(length_.size()); }
  double length(int k) const { return length_[k]; }
  double volume(int k) const { return volume_[k]; }
  double mass(int k) const { return mass_[k]; }
  double density(int k) const { return mass_[k] / volume_[k]; }
  double velocity(int k) const { return momentum_[k] / mass_[k]; }
  double internal(int k) const; ///< energy [J]
  double pressure(int k) const;
  double temperature(int k) const;
  /// Sets the state of a cell [Pa, K, m/s].
  void set(int k, double pressure, double temperature, double velocity);

  double allMass() const;
  double allEnergy() const;
  double allVolume() const;

  /// Whether each cell has a volume, gas and energy.
  bool sound() const;

  void serialize(Archive& archive);

private:
  struct State
  {
    double density, velocity, pressure;
  };
  struct Flux
  {
    double mass, momentum, energy;
  };
  State stateOf(int k) const;
  double soundSpeed(const State& s) const;
  double energyDensity(const State& s) const;
  Flux hllc(const State& left, const State& right) const;
  double longestStep() const;
  void reconstruct(double h); ///< the gas at both ends of each cell after half a step
  void flow(double h, const ChannelSupply& supply, ChannelLoss& loss);
  void applyWallFriction(double h);

  GasLaw law_;
  WallFriction friction_;
  double width_ = 1.0; ///< of the slot, at right angles to its opening and to the flow [m]
  std::vector<double> length_, volume_, mass_, momentum_, energy_; ///< [m, m3, kg, kg m/s, J]
  std::vector<double> fixed_, swept_, burnt_;                      ///< [m3, m3, kg]
  std::vector<State> left_, right_;                                ///< at the faces of cells
  std::vector<Flux> flux_;
  std::vector<double> passage_; ///< area between cells [m2]
};

} // namespace Rhegma::combustion
