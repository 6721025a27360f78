#pragma once
/// One burning crack and its gas.

#include "combustion/BurnRate.hpp"
#include "combustion/Cavity.hpp"
#include "combustion/CrackFlow.hpp"
#include "combustion/Gas.hpp"
#include "combustion/Ignition.hpp"
#include "plan/RunOptions.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma::combustion
{

/// One crack that burns. All ranks have the same gas in it: what their particles and nodes add to it is
/// summed.
template <int D>
struct Burning
{
  int crack = 0;
  BurnRate rate;
  Gas gas;
  Ignition<D> ignition;
  Quenching quenching;
  double density = 0.0, gap = 0.0, cavity = 0.0;
  double startPressure = 0.0, startTemperature = 0.0, outside = 0.0;
  double wallFraction = 0.0;        ///< of the flame's heat that goes into the faces that burn
  double transfer = 0.0;            ///< between gas and all faces [W/(m2 K)]
  double solidTemperature = 0.0;    ///< from which the heat of what burns counts [K]
  double discharge = 0.0;           ///< of the opening at the surface that flow has; 0: no venting
  double passageCoefficient = 0.0;  ///< of the opening into another crack that flow has
  std::vector<MirrorPlane> mirrors; ///< of the scene

  bool flows = false;   ///< along the crack; else it has one pressure
  CrackFlow<D> flow;    ///< where it flows
  ChannelSupply supply; ///< of its cells in this step

  bool filled = false, spent = false, felt = false;
  bool wide = false;                                ///< it has been reported as open by several cells
  double swept = 0.0;                               ///< volume that the faces have opened [m3]
  double volume = 0.0, pressure = 0.0, slope = 0.0; ///< [m3], [Pa], [Pa/s]
  double burningArea = 0.0, faces = 0.0;            ///< of faces that burn, of all [m2]
  double massRate = 0.0;   ///< largest flow in and out, in this step or expected in the next [kg/s]
  double volumeRate = 0.0; ///< that the faces sweep [m3/s]

  double hottestFace = 0.0; ///< at the start of the step [K]
  double flameReach = 0.0;  ///< from where it started [m]
  double flameTime = 0.0;   ///< at which it had come so far [s]

  bool heatsFaces() const { return wallFraction > 0.0 || transfer > 0.0; }
  bool usesFaces() const { return heatsFaces() || ignition.byTemperature(); }
  void serialize(Archive& archive);
};

/// What a scene says of the burning of a crack. Throws std::invalid_argument, with the path, for what the
/// bodies and the crack show wrong.
template <int D>
Burning<D> readBurning(const State<D>& state, const Teuchos::ParameterList& scene, const RunOptions& options,
                       const std::string& name);

} // namespace Rhegma::combustion
