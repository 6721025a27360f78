#include "program/Options.hpp"

#include <Kokkos_Macros.hpp>

#include <limits>
#include <map>
#include <optional>

namespace Rhegma::program
{

namespace
{

bool startsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

std::string kokkosSpelling(const std::string& argument)
{
#if KOKKOS_VERSION < 30700
  const std::string now = "--kokkos-num-threads", before = "--kokkos-threads";
  if (startsWith(argument, now))
    return before + argument.substr(now.size());
#endif
  return argument;
}

/// A path after an option; throws UsageError with a message where there is none, or another option.
std::string pathIn(const std::string& value, const char* missing)
{
  if (value.empty() || startsWith(value, "--"))
    throw UsageError(missing);
  return value;
}

/// Throws UsageError where options do not go together.
void refuseMisfits(const Options& options)
{
  if (options.twice && (options.action != Options::Action::Run || !options.restart.empty()))
    throw UsageError("--twice runs a scene from its start; leave --check, --print-plan and --restart out");
  if (options.action == Options::Action::New && !options.scene.empty())
    throw UsageError("--new takes one template; leave \"" + options.scene +
                     "\" out, or put names with blanks in quotes");
  if (options.watch && options.action != Options::Action::Run)
    throw UsageError("--watch keeps a page of a run; leave it out, or run the scene");
  if (!options.picture.empty() && options.action != Options::Action::Check)
    throw UsageError("--picture draws a scene that is checked; write --check, too, or leave it out");
  if (!options.state.empty() && options.action != Options::Action::Check)
    throw UsageError(
        "--state writes the state of a scene that is checked; write --check, too, or leave it out");
  const bool needsScene = options.action == Options::Action::Run ||
                          options.action == Options::Action::Check ||
                          options.action == Options::Action::PrintPlan;
  if (needsScene && options.scene.empty())
    throw UsageError("no scene was given; usage: rhegma SCENE.xml [options], see rhegma --help");
}

/// The arguments up to the next option, with blanks between them: names of sections have blanks, and may come
/// without quotes. \param k the argument before them; moved to the last of them \param most number of them
std::string namesAfter(const std::vector<std::string>& arguments, std::size_t& k, std::size_t most)
{
  std::string names;
  for (; most > 0 && k + 1 < arguments.size() && !startsWith(arguments[k + 1], "--"); --most)
    names += (names.empty() ? "" : " ") + arguments[++k];
  return names;
}

/// An option that prints a part of what the program knows, without a scene.
struct Printing
{
  Options::Action action;
  std::size_t names; ///< most arguments that name the part
};

std::optional<Printing> printingOf(const std::string& option)
{
  using Action = Options::Action;
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  static const std::map<std::string, Printing> all = {
      {"--describe", {Action::Describe, any}},
      {"--describe-markdown", {Action::DescribeMarkdown, 0}},
      {"--materials", {Action::Materials, any}},
      {"--materials-markdown", {Action::MaterialsMarkdown, 0}},
      {"--new", {Action::New, 1}},
  };
  const auto found = all.find(option);
  return found == all.end() ? std::nullopt : std::optional<Printing>(found->second);
}

/// The option that an argument switches on, or null.
bool* flagOf(const std::string& argument, Options& options)
{
  return argument == "--quiet"    ? &options.quiet
         : argument == "--twice"  ? &options.twice
         : argument == "--strict" ? &options.strict
         : argument == "--watch"  ? &options.watch
                                  : nullptr;
}

} // namespace

Options readOptions(const std::vector<std::string>& arguments, std::vector<std::string>& forKokkos)
{
  Options options;
  const auto valueOf = [&](std::size_t& k)
  {
    if (k + 1 >= arguments.size())
      throw UsageError("the option " + arguments[k] + " needs a value; see rhegma --help");
    return arguments[++k];
  };
  for (std::size_t k = 0; k < arguments.size(); ++k)
  {
    const std::string& a = arguments[k];
    if (startsWith(a, "--kokkos-"))
      forKokkos.push_back(kokkosSpelling(a));
    else if (a == "--output")
    {
      options.output = valueOf(k);
      if (options.output.empty())
        throw UsageError("--output has no folder; write one after it, or leave --output out");
    }
    else if (a == "--set")
      options.overrides.push_back(valueOf(k));
    else if (bool* const flag = flagOf(a, options))
      *flag = true;
    else if (a == "--picture")
      options.picture = pathIn(valueOf(k), "--picture has no file; write one after it, such as scene.png");
    else if (a == "--state")
      options.state = pathIn(valueOf(k), "--state has no folder; write a new one after it");
    else if (a == "--check")
      options.action = Options::Action::Check;
    else if (a == "--print-plan")
      options.action = Options::Action::PrintPlan;
    else if (const auto print = printingOf(a))
    {
      options.action = print->action;
      options.section = namesAfter(arguments, k, print->names);
    }
    else if (a == "--version")
      options.action = Options::Action::Version;
    else if (a == "--help" || a == "-h")
      options.action = Options::Action::Help;
    else if (a == "--restart")
    {
      options.restart = valueOf(k);
      if (options.restart.empty())
        throw UsageError("--restart has no file; write one after it, or leave --restart out");
    }
    else if (startsWith(a, "-"))
      throw UsageError("there is no option " + a + "; see rhegma --help");
    else if (options.scene.empty())
      options.scene = a;
    else
      throw UsageError("only one scene can be run: \"" + options.scene + "\" and \"" + a +
                       "\" were both given");
  }
  refuseMisfits(options);
  return options;
}

std::string usage()
{
  return "rhegma SCENE.xml [--output DIR] [--set 'Section:Sub:Parameter=value']... [--restart FILE] "
         "[--quiet] [--strict] [--watch]\n                        run a scene; results go to DIR (default: "
         "SCENE.out "
         "next to the scene);\n                        --restart: continue from a checkpoint.h5 of the same "
         "scene; --strict: warnings are errors;\n                        --watch: keep DIR/watch.html, a "
         "page "
         "of the run for a browser\nrhegma SCENE.xml --twice        run it as it is and with "
         "cells of half the size, and print how much the results change\nrhegma SCENE.xml --check        "
         "check the scene, list every error, forecast the cost, and stop;\n                        --picture "
         "FILE.png: draw it, too; --state DIR: write its state before any motion\nrhegma SCENE.xml "
         "--print-plan   "
         "list the effects, fields and stages of the scene\nrhegma --describe [Section]     every parameter: "
         "type, unit, default, allowed values, meaning;\n                        of a part: --describe "
         "'Thermal > Sources', --describe Domain:Accuracy;\n                        of a name anywhere: "
         "--describe Toughness\nrhegma --describe-markdown      the same as a "
         "page of Markdown (docs/reference.md)\nrhegma --new TEMPLATE           print a commented scene to "
         "start "
         "from: dcb, plate, drop-weight, quench, burning or 3d-part;\n                        --output FILE: "
         "write it to "
         "a "
         "file\nrhegma --materials [NAME]       the library of materials with its sources; of one "
         "material: XML to paste\nrhegma --version\n\nThreads: OMP_NUM_THREADS or "
         "--kokkos-num-threads=N (OpenMP back end).\nExit: 0 finished, 1 the scene is wrong, 2 the run "
         "failed, 3 a defect of the program,\n      4 finished, but a value of the scene's Reference section "
         "is outside its tolerance,\n        or --strict and a warning during the run (1: before it).\n";
}

} // namespace Rhegma::program
