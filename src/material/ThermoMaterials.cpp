#include "material/ThermoMaterials.hpp"

#include "base/ReadList.hpp"
#include "material/MaterialTable.hpp"
#include "material/Materials.hpp"
#include "material/TemperatureTable.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma
{

namespace
{

/// A property as a table; constant where the scene gives a number.
TemperatureTable tableOf(const Teuchos::ParameterList& material, const std::string& name, double absent)
{
  if (material.isType<std::string>(name))
    return TemperatureTable::parse(material.get<std::string>(name));
  return {{1.0}, {material.isType<double>(name) ? material.get<double>(name) : absent}};
}

/// Pieces between two temperatures of a Poisson ratio's table, in which Lame's moduli are taken as linear.
constexpr int poissonPieces = 16;

/// Temperatures at which all properties are tabulated, including the reference.
std::vector<double> knotTemperatures(const Teuchos::ParameterList& material, double reference, bool entropic)
{
  std::vector<double> at = tableTemperatures(material);
  if (material.isType<std::string>("Poisson Ratio"))
  {
    std::vector<double> fine;
    for (std::size_t k = 1; k < at.size(); ++k)
      for (int piece = 1; piece < poissonPieces; ++piece)
        fine.push_back(at[k - 1] + piece * (at[k] - at[k - 1]) / poissonPieces);
    at.insert(at.end(), fine.begin(), fine.end());
  }
  at.push_back(reference);
  if (entropic)
  {
    at.push_back(1e-3 * reference);
    at.push_back(1e3 * reference);
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  return at;
}

struct ScaleShear
{
  Properties& law;
  double factor;
  template <class Law, int, Plane>
  void run() const
  {
    Law::scaleShear(law, factor);
  }
};

/// Makes shear moduli proportional to the absolute temperature; the bulk modulus stays.
void scaleShear(Properties& law, double factor)
{
  law.mu *= factor;
  withLaw<3>(law.law, Plane::Solid, ScaleShear{law, factor});
  law.lambda = law.bulk - 2.0 / 3.0 * law.mu;
  setPlaneModuli(law);
}

/// The tables of one material.
struct MaterialTables
{
  ThermoMaterial material;
  std::vector<ThermoKnot> knots;
  std::vector<Properties> laws;
};

/// Integrals from the reference temperature, which is one of the knots.
void integrate(std::vector<ThermoKnot>& knots, double reference)
{
  std::size_t zero = 0;
  while (knots[zero].temperature < reference)
    ++zero;
  const auto rise = [&](std::size_t k, double ThermoKnot::*value) {
    return 0.5 * (knots[k + 1].temperature - knots[k].temperature) * (knots[k].*value + knots[k + 1].*value);
  };
  for (std::size_t k = zero; k + 1 < knots.size(); ++k)
  {
    knots[k + 1].heat = knots[k].heat + rise(k, &ThermoKnot::capacity);
    knots[k + 1].strain = knots[k].strain + rise(k, &ThermoKnot::expansion);
  }
  for (std::size_t k = zero; k > 0; --k)
  {
    knots[k - 1].heat = knots[k].heat - rise(k - 1, &ThermoKnot::capacity);
    knots[k - 1].strain = knots[k].strain - rise(k - 1, &ThermoKnot::expansion);
  }
}

/// Factors of the conductivity along the axes.
void setRatios(ThermoMaterial& m, const Teuchos::Array<double>& ratios, const std::string& where)
{
  for (int d = 0; d < ratios.size(); ++d)
  {
    if (!(ratios[d] >= 0.0))
      throw std::invalid_argument(where +
                                  "Conductivity Ratios: one is negative; write factors of zero or more");
    m.ratio[d] = ratios[d];
    m.orthotropic = m.orthotropic || ratios[d] != 1.0;
  }
}

MaterialTables tablesOf(const Teuchos::ParameterList& list, const std::string& name, Plane plane,
                        double reference, bool mechanics)
{
  const std::string where = "Materials > " + name + " > ";
  if (!list.isParameter("Specific Heat"))
    throw std::invalid_argument(where + "Specific Heat: the scene has Thermal, which needs it; give the heat "
                                        "capacity at constant strain [J/(kg K)]");
  MaterialTables made;
  ThermoMaterial& m = made.material;
  m.reference =
      list.isParameter("Reference Temperature") ? list.get<double>("Reference Temperature") : reference;
  if (list.isParameter("Plastic Heat Fraction"))
    m.plasticHeat = list.get<double>("Plastic Heat Fraction");
  if (list.isParameter("Conductivity Ratios"))
    setRatios(m, list.get<Teuchos::Array<double>>("Conductivity Ratios"), where);
  const bool entropic = mechanics && list.isParameter("Entropic") && list.get<bool>("Entropic");
  bool varies = entropic;
  for (const std::string& property : tabulatedProperties(list))
  {
    const bool thermal =
        property == "Specific Heat" || property == "Conductivity" || property == "Thermal Expansion";
    if (entropic && !thermal && property != "Bulk Modulus")
      throw std::invalid_argument(where + property +
                                  ": the material is Entropic, so its shear modulus is already proportional "
                                  "to temperature; write a number");
    varies = varies || !thermal || property == "Thermal Expansion";
  }
  const TemperatureTable heat = tableOf(list, "Specific Heat", 0.0),
                         conductivity = tableOf(list, "Conductivity", 0.0),
                         expansion = tableOf(list, "Thermal Expansion", 0.0);
  for (const double k : conductivity.value)
    m.conducts = m.conducts || k > 0.0;
  for (const double alpha : expansion.value)
    m.coupled = m.coupled || (mechanics && alpha != 0.0);
  m.coupled = m.coupled || (mechanics && varies);
  for (const double T : knotTemperatures(list, m.reference, entropic))
  {
    Properties law = makeProperties(materialAt(list, T), name, plane);
    law.heated = true;
    if (const char* reason = refusesHeat(law))
      throw std::invalid_argument(where + "Model: " + reason);
    if (entropic)
      scaleShear(law, T / m.reference);
    made.laws.push_back(law);
    ThermoKnot knot;
    knot.temperature = T;
    knot.capacity = law.density * heat(T);
    knot.conductivity = conductivity(T);
    knot.expansion = mechanics ? expansion(T) : 0.0;
    made.knots.push_back(knot);
    if (T == m.reference)
      m.coupling = 9.0 * law.bulk * knot.expansion * knot.expansion;
  }
  m.count = static_cast<int>(made.knots.size());
  integrate(made.knots, m.reference);
  for (const ThermoKnot& knot : made.knots)
    if (!(knot.strain > -0.5))
      throw std::invalid_argument(
          where + "Thermal Expansion: the material would shrink to less than half at " +
          std::to_string(knot.temperature) + " K; write the linear expansion per kelvin");
  return made;
}

template <class T>
View<T*> onDevice(const std::string& label, const std::vector<T>& values)
{
  View<T*> view(label, values.size());
  const auto host = Kokkos::create_mirror_view(view);
  std::copy(values.begin(), values.end(), host.data());
  Kokkos::deep_copy(view, host);
  return view;
}

} // namespace

std::vector<std::string> tabulatedProperties(const Teuchos::ParameterList& material)
{
  std::vector<std::string> names;
  for (auto entry = material.begin(); entry != material.end(); ++entry)
  {
    const std::string name = material.name(entry);
    if (material.isType<std::string>(name) && material.get<std::string>(name).find(':') != std::string::npos)
      names.push_back(name);
  }
  return names;
}

std::vector<double> tableTemperatures(const Teuchos::ParameterList& material)
{
  std::vector<double> at;
  for (const std::string& name : tabulatedProperties(material))
  {
    const TemperatureTable table = TemperatureTable::parse(material.get<std::string>(name));
    at.insert(at.end(), table.temperature.begin(), table.temperature.end());
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  return at;
}

Teuchos::ParameterList materialAt(const Teuchos::ParameterList& material, double temperature)
{
  Teuchos::ParameterList copy(material);
  for (const std::string& name : tabulatedProperties(material))
  {
    copy.remove(name);
    copy.set(name, TemperatureTable::parse(material.get<std::string>(name))(temperature));
  }
  return copy;
}

ThermoTables makeThermoTables(const Teuchos::ParameterList& materials, Plane plane, double reference,
                              bool mechanics)
{
  std::vector<ThermoMaterial> material;
  std::vector<ThermoKnot> knots;
  std::vector<Properties> laws;
  for (const std::string& name : sublistNames(materials))
  {
    MaterialTables one = tablesOf(materials.sublist(name), name, plane, reference, mechanics);
    one.material.first = static_cast<int>(knots.size());
    material.push_back(one.material);
    knots.insert(knots.end(), one.knots.begin(), one.knots.end());
    laws.insert(laws.end(), one.laws.begin(), one.laws.end());
  }
  return {onDevice("rhegma::thermoMaterials", material), onDevice("rhegma::thermoKnots", knots),
          onDevice("rhegma::thermoLaws", laws)};
}

} // namespace Rhegma
