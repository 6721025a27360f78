#include "combustion/Burning.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "transfer/FacePush.hpp"

#include <stdexcept>

namespace Rhegma::combustion
{

template <int D>
void Burning<D>::serialize(Archive& archive)
{
  gas.serialize(archive);
  archive("filled", filled);
  archive("spent", spent);
  archive("felt", felt);
  archive("wide", wide);
  archive("swept", swept);
  archive("volume", volume);
  archive("pressure", pressure);
  archive("slope", slope);
  archive("burning_area", burningArea);
  archive("mass_rate", massRate);
  archive("volume_rate", volumeRate);
  archive("hottest_face", hottestFace);
  archive("flame_reach", flameReach);
  archive("flame_time", flameTime);
  if (flows)
  {
    const Archive::Group group(archive, "flow");
    flow.serialize(archive);
  }
}

namespace
{

GasLaw readGas(const Teuchos::ParameterList& list)
{
  GasLaw law;
  law.constant = list.get<double>("Gas Constant");
  law.heatRatio = list.get<double>("Heat Capacity Ratio");
  law.covolume = list.get<double>("Covolume");
  law.flameTemperature = list.get<double>("Flame Temperature");
  law.constantTemperature = list.get<std::string>("Gas Temperature") == "Constant";
  return law;
}

template <int D>
Ignition<D> readIgnition(const State<D>& state, int crack, const Teuchos::ParameterList& list,
                         const std::string& path)
{
  Ignition<D> ignition;
  ignition.time = list.get<double>("Ignition Time");
  if (list.isParameter("Ignition Temperature"))
    ignition.temperature = list.get<double>("Ignition Temperature");
  if (list.isParameter("Flame Speed"))
    ignition.flameSpeed = list.get<double>("Flame Speed");
  ignition.speedPressure = list.get<double>("Flame Speed Pressure");
  ignition.speedExponent = list.get<double>("Flame Speed Exponent");
  const bool point = list.isParameter("Ignition Point");
  ignition.inBox = point || list.isParameter("Ignition Lower Corner");
  ignition.everywhere = !ignition.inBox && !ignition.byTemperature();
  if (!ignition.inBox)
    return ignition;
  ignition.lower = readVector<D>(list, point ? "Ignition Point" : "Ignition Lower Corner");
  ignition.upper = readVector<D>(list, point ? "Ignition Point" : "Ignition Upper Corner");
  const double away = distanceFromCrack(state.cracks, crack, ignition.lower, ignition.upper);
  if (away > state.mesh.grid.spacing)
    throw std::invalid_argument(path + (point ? " > Ignition Point" : " > Ignition Lower Corner") +
                                ": it lies " + formatReal(away) +
                                " m from the crack, more than a cell; write a position on its faces");
  return ignition;
}

/// \param density of the solid [kg/m3] \param temperature of it [K]
BurnRate readRate(const Teuchos::ParameterList& list, double density, double temperature)
{
  const auto law = list.get<std::string>("Burn Law");
  if (law == "Table")
    return BurnRate::table(list.get<std::string>("Burn Table"));
  if (law == "Vieille")
    return BurnRate::vieille(list.get<double>("Burn Coefficient"), list.get<double>("Burn Exponent"));
  WardSonBrewster solid;
  solid.prefactor = list.get<double>("Solid Prefactor");
  solid.activation = list.get<double>("Solid Activation Energy");
  solid.gasPrefactor = list.get<double>("Gas Prefactor");
  solid.heatOfSolid = list.get<double>("Solid Heat Release");
  solid.heatOfGas = list.get<double>("Gas Heat Release");
  solid.solidConductivity = list.get<double>("Solid Conductivity");
  solid.gasConductivity = list.get<double>("Gas Conductivity");
  solid.capacity = list.get<double>("Specific Heat");
  solid.molarMass = list.get<double>("Molar Mass");
  solid.temperature =
      list.isParameter("Solid Temperature") ? list.get<double>("Solid Temperature") : temperature;
  solid.density = density;
  return BurnRate::wardSonBrewster(solid);
}

} // namespace

template <int D>
Burning<D> readBurning(const State<D>& state, const Teuchos::ParameterList& scene, const RunOptions& options,
                       const std::string& name)
{
  const Teuchos::ParameterList& list = scene.sublist("Combustion").sublist(name);
  const std::string path = "Combustion > " + name;
  Burning<D> b;
  b.crack = findCrack(state.cracks, name);
  const GasLaw law = readGas(list);
  b.gas = Gas(law);
  b.density = list.isParameter("Solid Density") ? list.get<double>("Solid Density")
                                                : state.materials.properties.front().density;
  b.gap = list.get<double>("Initial Gap");
  b.cavity = list.get<double>("Cavity Volume");
  b.outside = list.get<double>("Outside Pressure");
  b.startPressure = list.isParameter("Initial Pressure") ? list.get<double>("Initial Pressure") : b.outside;
  b.startTemperature =
      law.constantTemperature ? law.flameTemperature : list.get<double>("Initial Temperature");
  b.wallFraction = list.get<double>("Wall Heat Fraction");
  b.transfer = list.get<double>("Heat Transfer Coefficient");
  constexpr double room = 293.0;
  b.rate = readRate(list, b.density, options.initialTemperature.value_or(room));
  b.solidTemperature = options.initialTemperature.value_or(b.solidTemperature);
  if (options.heat() && list.isParameter("Ignition Temperature") &&
      list.get<double>("Ignition Temperature") <= b.solidTemperature)
    throw std::invalid_argument(path +
                                " > Ignition Temperature: is not above Thermal > Initial Temperature, so "
                                "all faces ignite at once; leave it out if this is intended");
  b.ignition = readIgnition<D>(state, b.crack, list, path);
  if (list.isParameter("Quenching Coefficient"))
    b.quenching = {list.get<double>("Quenching Coefficient"), list.get<double>("Quenching Exponent")};
  b.mirrors = mirrorPlanes(scene);
  b.flows = list.get<std::string>("Gas Model") == "Flow";
  b.flow = CrackFlow<D>(law, {list.get<double>("Viscosity"), list.get<double>("Friction Factor")},
                        state.method.thickness);
  b.passageCoefficient = list.get<double>("Discharge Coefficient");
  if (list.get<bool>("Venting"))
  {
    b.discharge = list.get<double>("Discharge Coefficient");
    if (!hasSurfaceEnd(state, b.crack, {}))
      throw std::invalid_argument(path + " > Venting: the crack does not reach the surface of its body, so "
                                         "no gas can flow out; write false");
    if (!hasSurfaceEnd(state, b.crack, b.mirrors))
      throw std::invalid_argument(
          path +
          " > Venting: the crack ends only at a plane of symmetry, so no gas can flow out; write false");
  }
  return b;
}

template struct Burning<2>;
template struct Burning<3>;
template Burning<2> readBurning(const State<2>&, const Teuchos::ParameterList&, const RunOptions&,
                                const std::string&);
template Burning<3> readBurning(const State<3>&, const Teuchos::ParameterList&, const RunOptions&,
                                const std::string&);

} // namespace Rhegma::combustion
