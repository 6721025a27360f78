#pragma once
/// Command lines of benchmarks.

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace Rhegma::benchmarks
{

/// The command line of a benchmark: flags, options with a positive number after each, and at most one scene.
class CommandLine
{
public:
  CommandLine& flag(const std::string& name, bool& value);
  CommandLine& number(const std::string& name, int& value);
  CommandLine& number(const std::string& name, double& value);
  /// Requires the file of a scene. \param example one, for the usage message
  CommandLine& scene(std::string& file, const std::string& example);

  /// Sets what the arguments name; the first of them is the program. Throws std::invalid_argument for unknown
  /// options and for values that are not positive numbers.
  void read(const std::vector<std::string>& arguments) const;

private:
  std::map<std::string, bool*> flags_;
  std::map<std::string, std::function<void(const std::string&)>> numbers_;
  std::string* scene_ = nullptr;
  std::string example_;

  std::string usage() const;
};

} // namespace Rhegma::benchmarks
