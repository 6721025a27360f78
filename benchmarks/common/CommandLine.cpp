#include "common/CommandLine.hpp"

#include <stdexcept>
#include <type_traits>

namespace Rhegma::benchmarks
{

namespace
{

template <class Number>
Number positiveNumber(const std::string& option, const std::string& text)
{
  constexpr bool whole = std::is_same_v<Number, int>;
  std::size_t used = 0;
  Number value = 0;
  try
  {
    if constexpr (whole)
      value = std::stoi(text, &used);
    else
      value = std::stod(text, &used);
  }
  catch (const std::logic_error&)
  {
  }
  if (!(value > 0) || used != text.size())
    throw std::invalid_argument(option + " needs a positive " + (whole ? "whole " : "") + "number, not \"" +
                                text + "\"");
  return value;
}

} // namespace

CommandLine& CommandLine::flag(const std::string& name, bool& value)
{
  flags_[name] = &value;
  return *this;
}

CommandLine& CommandLine::number(const std::string& name, int& value)
{
  numbers_[name] = [name, &value](const std::string& text) { value = positiveNumber<int>(name, text); };
  return *this;
}

CommandLine& CommandLine::number(const std::string& name, double& value)
{
  numbers_[name] = [name, &value](const std::string& text) { value = positiveNumber<double>(name, text); };
  return *this;
}

CommandLine& CommandLine::scene(std::string& file, const std::string& example)
{
  scene_ = &file;
  example_ = example;
  return *this;
}

std::string CommandLine::usage() const
{
  std::string text = scene_ != nullptr ? " SCENE.xml" : "";
  for (const auto& [name, value] : flags_)
    text += " [" + name + "]";
  for (const auto& [name, set] : numbers_)
    text += " [" + name + " N]";
  return text;
}

void CommandLine::read(const std::vector<std::string>& arguments) const
{
  for (std::size_t k = 1; k < arguments.size(); ++k)
  {
    const std::string& name = arguments[k];
    if (const auto flag = flags_.find(name); flag != flags_.end())
      *flag->second = true;
    else if (const auto number = numbers_.find(name); number != numbers_.end())
      number->second(++k < arguments.size() ? arguments[k] : std::string());
    else if (scene_ != nullptr && scene_->empty() && name.rfind("--", 0) != 0)
      *scene_ = name;
    else
      throw std::invalid_argument("\"" + name + "\" is not known here; write" + usage());
  }
  if (scene_ != nullptr && scene_->empty())
    throw std::invalid_argument("write the scene that shall be timed, as " + example_);
}

} // namespace Rhegma::benchmarks
