#include "material/MaterialTable.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{

namespace
{

/// The parameters of one material, with the names that messages need.
class Reader
{
public:
  Reader(const Teuchos::ParameterList& list, std::string name) : list_(list), name_(std::move(name)) {}

  [[noreturn]] void refuse(const std::string& parameter, const std::string& sentence) const
  {
    throw std::invalid_argument("Materials > " + name_ + " > " + parameter + ": " + sentence);
  }

  double number(const std::string& parameter, const std::string& meaning) const
  {
    if (!list_.isParameter(parameter))
      refuse(parameter, "a " + model() + " material needs it; give the " + meaning + ".");
    if (!list_.isType<double>(parameter))
      refuse(parameter, "must be a number; write type=\"double\".");
    const double value = list_.get<double>(parameter);
    if (!std::isfinite(value))
      refuse(parameter, "must be a finite number.");
    return value;
  }

  double positive(const std::string& parameter, const std::string& meaning) const
  {
    const double value = number(parameter, meaning);
    if (!(value > 0.0))
      refuse(parameter, "is " + text(value) + "; give a positive " + meaning + ".");
    return value;
  }

  double zeroOrMore(const std::string& parameter, const std::string& meaning) const
  {
    const double value = number(parameter, meaning);
    if (!(value >= 0.0))
      refuse(parameter, "is " + text(value) + "; give a " + meaning + " of zero or more.");
    return value;
  }

  double optional(const std::string& parameter, const std::string& meaning) const
  {
    return list_.isParameter(parameter) ? zeroOrMore(parameter, meaning) : 0.0;
  }

  std::string model() const
  {
    if (!list_.isParameter("Model") || !list_.isType<std::string>("Model"))
      refuse("Model", "is missing; write Linear Elastic, Neo-Hookean, Mooney-Rivlin or J2 Plastic.");
    return list_.get<std::string>("Model");
  }

  static std::string text(double value)
  {
    std::ostringstream out;
    out << value;
    return out.str();
  }

private:
  const Teuchos::ParameterList& list_;
  std::string name_;
};

void readHooke(const Reader& reader, double leastPoisson, Properties& m)
{
  const double young = reader.positive("Young Modulus", "Young modulus [Pa]");
  const double poisson = reader.number("Poisson Ratio", "Poisson ratio");
  if (!(poisson > leastPoisson || poisson == 0.0) || !(poisson < 0.5))
    reader.refuse("Poisson Ratio", "is " + Reader::text(poisson) + "; give a number " +
                                       (leastPoisson < 0.0 ? "above -1" : "from 0") +
                                       " and below 0.5 (0.5 is incompressible; use for example 0.49).");
  m.mu = young / (2.0 * (1.0 + poisson));
  m.lambda = 2.0 * m.mu * poisson / (1.0 - 2.0 * poisson);
  m.bulk = young / (3.0 * (1.0 - 2.0 * poisson));
}

void readMooneyRivlin(const Reader& reader, Properties& m)
{
  m.c10 = reader.zeroOrMore("C10", "constant [Pa]");
  m.c01 = reader.zeroOrMore("C01", "constant [Pa]");
  m.bulk = reader.positive("Bulk Modulus", "bulk modulus [Pa]");
  m.mu = 2.0 * (m.c10 + m.c01);
  if (!(m.mu > 0.0))
    reader.refuse("C10", "and C01 are both zero, which is a fluid; make at least one of them positive.");
  m.lambda = m.bulk - 2.0 / 3.0 * m.mu;
  if (m.lambda < 0.0)
    reader.refuse("Bulk Modulus",
                  "is " + Reader::text(m.bulk) + "; this law is for nearly incompressible material, " +
                      "give at least 4/3 (C10 + C01) = " + Reader::text(2.0 / 3.0 * m.mu) + ".");
}

void readPlastic(const Reader& reader, Properties& m)
{
  m.yield = reader.positive("Yield Stress", "yield stress [Pa]");
  m.hardening = reader.optional("Hardening Modulus", "hardening modulus [Pa]");
  const double saturation = reader.optional("Saturation Stress", "saturation yield stress [Pa]");
  m.saturationRate = reader.optional("Saturation Rate", "rate of saturation");
  if ((saturation > 0.0) != (m.saturationRate > 0.0))
    reader.refuse(saturation > 0.0 ? "Saturation Rate" : "Saturation Stress",
                  "is missing; give both Saturation Stress and Saturation Rate, or neither.");
  if (saturation > 0.0 && saturation < m.yield)
    reader.refuse("Saturation Stress", "is " + Reader::text(saturation) + ", below the yield stress " +
                                           Reader::text(m.yield) + "; give at least the yield stress.");
  m.saturation = saturation > 0.0 ? saturation - m.yield : 0.0;
}

} // namespace

Properties makeProperties(const Teuchos::ParameterList& material, const std::string& name, Plane plane)
{
  const Reader reader(material, name);
  const std::string model = reader.model();
  Properties m;
  m.plane = plane;
  m.density = reader.positive("Density", "density [kg/m3]");
  if (model == "Linear Elastic")
  {
    m.kind = LawKind::LinearElastic;
    readHooke(reader, -1.0, m);
  }
  else if (model == "Neo-Hookean")
  {
    m.kind = LawKind::NeoHookean;
    readHooke(reader, 0.0, m);
  }
  else if (model == "Mooney-Rivlin")
  {
    m.kind = LawKind::MooneyRivlin;
    readMooneyRivlin(reader, m);
  }
  else if (model == "J2 Plastic")
  {
    m.kind = LawKind::J2Plastic;
    readHooke(reader, -1.0, m);
    readPlastic(reader, m);
  }
  else if (model == "Rigid")
    return m;
  else
    reader.refuse("Model",
                  "is \"" + model + "\"; write Linear Elastic, Neo-Hookean, Mooney-Rivlin or J2 Plastic.");
  m.thicknessRatio = m.lambda / (m.lambda + 2.0 * m.mu);
  m.planeLambda = plane == Plane::Stress ? 2.0 * m.mu * m.thicknessRatio : m.lambda;
  return m;
}

} // namespace Rhegma
