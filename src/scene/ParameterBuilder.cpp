#include "scene/Schema.hpp"

namespace Rhegma
{

ParameterBuilder& ParameterBuilder::unit(const std::string& u)
{
  p->unit = u;
  return *this;
}

ParameterBuilder& ParameterBuilder::temperatureDifference()
{
  p->temperature = TemperatureKind::Difference;
  return unit("K");
}

ParameterBuilder& ParameterBuilder::meaning(const std::string& m)
{
  p->meaning = m;
  return *this;
}

ParameterBuilder& ParameterBuilder::formerly(const std::string& oldName)
{
  p->formerNames.push_back(oldName);
  return *this;
}

ParameterBuilder& ParameterBuilder::required()
{
  p->required = true;
  return *this;
}

ParameterBuilder& ParameterBuilder::optional()
{
  p->required = false;
  return *this;
}

ParameterBuilder& ParameterBuilder::optional(const std::string& derivedDefault)
{
  p->derivedDefault = derivedDefault;
  return optional();
}

ParameterBuilder& ParameterBuilder::byDefault(double value)
{
  if (p->type == ParameterType::Integer)
    p->byDefault = static_cast<int>(value);
  else
    p->byDefault = value;
  return optional();
}

ParameterBuilder& ParameterBuilder::byDefault(int value)
{
  if (p->type == ParameterType::Real)
    p->byDefault = static_cast<double>(value);
  else
    p->byDefault = value;
  return optional();
}

ParameterBuilder& ParameterBuilder::byDefault(bool value)
{
  p->byDefault = value;
  return optional();
}

ParameterBuilder& ParameterBuilder::byDefault(const char* value)
{
  p->byDefault = std::string(value);
  return optional();
}

ParameterBuilder& ParameterBuilder::byDefault(const char* in2D, const char* in3D)
{
  p->byDefaultIn3D = std::string(in3D);
  return byDefault(in2D);
}

ParameterBuilder& ParameterBuilder::byDefault(std::vector<double> value)
{
  if (p->type == ParameterType::IntegerArray)
    p->byDefault = std::vector<int>(value.begin(), value.end());
  else
    p->byDefault = std::move(value);
  return optional();
}

ParameterBuilder& ParameterBuilder::byDefaultZeros()
{
  const bool rotation = p->length.rule == ArrayLength::Rule::RotationAxes;
  byDefault(std::vector<double>(rotation ? 1 : 2, 0.0));
  p->byDefaultIn3D = p->type == ParameterType::IntegerArray ? ParameterValue(std::vector<int>(3, 0))
                                                            : ParameterValue(std::vector<double>(3, 0.0));
  return *this;
}

ParameterBuilder& ParameterBuilder::atLeast(double bound)
{
  p->lower = bound;
  p->lowerOpen = false;
  return *this;
}

ParameterBuilder& ParameterBuilder::above(double bound)
{
  p->lower = bound;
  p->lowerOpen = true;
  return *this;
}

ParameterBuilder& ParameterBuilder::atMost(double bound)
{
  p->upper = bound;
  p->upperOpen = false;
  return *this;
}

ParameterBuilder& ParameterBuilder::below(double bound)
{
  p->upper = bound;
  p->upperOpen = true;
  return *this;
}

ParameterBuilder& ParameterBuilder::notEmpty()
{
  p->mayBeEmpty = false;
  return *this;
}

ParameterBuilder& ParameterBuilder::length(int n)
{
  p->length = {ArrayLength::Rule::Exactly, n, 0};
  return *this;
}

ParameterBuilder& ParameterBuilder::multipleOf(int n, int fewest)
{
  p->length = {ArrayLength::Rule::MultipleOf, n, fewest};
  return *this;
}

ParameterBuilder& ParameterBuilder::perAxis()
{
  p->length = {ArrayLength::Rule::Axes, 0, 0};
  return *this;
}

ParameterBuilder& ParameterBuilder::perPoint(int fewestPoints)
{
  p->length = {ArrayLength::Rule::MultipleOfAxes, 0, fewestPoints};
  return *this;
}

ParameterBuilder& ParameterBuilder::perRotationAxis()
{
  p->length = {ArrayLength::Rule::RotationAxes, 0, 0};
  return *this;
}

ParameterBuilder& ParameterBuilder::onlyIn(int dimension)
{
  p->onlyDimension = dimension;
  return *this;
}

ParameterBuilder& ParameterBuilder::orTable()
{
  p->mayBeTable = true;
  return *this;
}

ParameterBuilder& ParameterBuilder::scalesRate(const std::string& parameter)
{
  p->scalesRate = parameter;
  return *this;
}

ParameterBuilder& ParameterBuilder::mayChange()
{
  p->changeable = true;
  return *this;
}

} // namespace Rhegma
