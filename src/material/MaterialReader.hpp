#pragma once
/// Reads one sublist of Materials by the law that it names.

#include "material/Laws.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma
{

/// The parameters of one material, with the names that messages need.
class MaterialReader
{
public:
  MaterialReader(const Teuchos::ParameterList& list, std::string name) : list_(list), name_(std::move(name))
  {
  }

  [[noreturn]] void refuse(const std::string& parameter, const std::string& message) const
  {
    throw std::invalid_argument("Materials > " + name_ + " > " + parameter + ": " + message);
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

  /// An array of numbers; empty where the scene does not have it.
  std::vector<double> numbers(const std::string& parameter) const
  {
    if (!list_.isParameter(parameter))
      return {};
    if (!list_.isType<Teuchos::Array<double>>(parameter))
      refuse(parameter, "must be an array of numbers; write type=\"Array(double)\".");
    const Teuchos::Array<double> values = list_.get<Teuchos::Array<double>>(parameter);
    for (const double value : values)
      if (!std::isfinite(value))
        refuse(parameter, "must have finite numbers only.");
    return {values.begin(), values.end()};
  }

  /// A whole number; the default where the scene does not have it.
  int integer(const std::string& parameter, int byDefault) const
  {
    return list_.isType<int>(parameter) ? list_.get<int>(parameter) : byDefault;
  }

  /// A text; the default where the scene does not have it.
  std::string choice(const std::string& parameter, const std::string& byDefault) const
  {
    return list_.isType<std::string>(parameter) ? list_.get<std::string>(parameter) : byDefault;
  }

  bool has(const std::string& parameter) const { return list_.isParameter(parameter); }

  /// The law by its name; empty where the scene does not say.
  std::string model() const
  {
    return list_.isType<std::string>("Model") ? list_.get<std::string>("Model") : std::string();
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

/// The laws of a list by name, such as "Linear Elastic, Neo-Hookean or J2 Plastic".
template <class... Law>
std::string namesOf(LawList<Law...> /*list*/)
{
  const std::vector<std::string> names = {Law::name...};
  std::string text = names[0];
  for (std::size_t k = 1; k < names.size(); ++k)
    text += (k + 1 < names.size() ? ", " : " or ") + names[k];
  return text;
}

/// Reads the numbers of a law by its name. \return whether the name is in the list
template <class... Law>
bool readByName(const MaterialReader& reader, Properties& m, LawList<Law...> list)
{
  const std::string model = reader.model();
  const auto readIf = [&](auto law)
  {
    using One = decltype(law);
    if (model != One::name)
      return false;
    m.law = indexIn<One>(list);
    One::read(reader, m);
    return true;
  };
  return (readIf(Law{}) || ...);
}

/// makeProperties (MaterialTable.hpp) with the laws of any list.
template <class List>
Properties readMaterial(const Teuchos::ParameterList& material, const std::string& name, Plane plane)
{
  const MaterialReader reader(material, name);
  const std::string model = reader.model();
  if (model.empty())
    reader.refuse("Model", "is missing; write " + namesOf(List{}) + ".");
  Properties m;
  m.plane = plane;
  m.density = reader.positive("Density", "density [kg/m3]");
  if (reader.has("Reference Temperature"))
    m.temperature = reader.positive("Reference Temperature", "temperature [K]");
  if (model == "Rigid")
    return m;
  if (!readByName(reader, m, List{}))
    reader.refuse("Model", "is \"" + model + "\"; write " + namesOf(List{}) + ".");
  setPlaneModuli(m);
  return m;
}

} // namespace Rhegma
