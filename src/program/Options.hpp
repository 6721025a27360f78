#pragma once
/// The command line.

#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma::program
{

constexpr int exitFinished = 0;
constexpr int exitWrongScene = 1;
constexpr int exitStopped = 2;
constexpr int exitDefect = 3;
constexpr int exitReferenceMissed = 4;

/// An invalid command line.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

struct Options
{
  enum class Action
  {
    Run,
    Check,
    PrintPlan,
    Describe,
    DescribeMarkdown,
    New,
    Materials,
    MaterialsMarkdown,
    Version,
    Help
  };
  Action action = Action::Run;
  std::string scene;
  std::string output;  ///< folder; empty: next to the scene; of --new a file, empty: standard output
  std::string section; ///< of --describe, the template of --new, or the material of --materials
  std::string restart; ///< checkpoint to continue from; empty: start of the scene
  std::string picture; ///< file of --check --picture; empty: none
  std::string state;   ///< folder of --check --state; empty: none
  std::vector<std::string> overrides;
  bool quiet = false;
  bool twice = false;  ///< run as it is and with cells of half the size
  bool strict = false; ///< warnings are errors
  bool watch = false;  ///< keep a page of the run in its folder
};

/// Reads the arguments after the program's name. Those that are Kokkos' own (--kokkos-...) are put aside,
/// with
/// --kokkos-num-threads in the spelling of the installed Kokkos.
Options readOptions(const std::vector<std::string>& arguments, std::vector<std::string>& forKokkos);

/// What --help prints.
std::string usage();

} // namespace Rhegma::program
