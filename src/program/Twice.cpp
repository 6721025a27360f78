#include "program/Twice.hpp"

#include "base/OutputError.hpp"
#include "files/TextFile.hpp"
#include "output/OutputFolder.hpp"
#include "output/RunLock.hpp"
#include "parallel/FirstRank.hpp"
#include "program/CompareRuns.hpp"
#include "program/Options.hpp"
#include "program/RunEnd.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

namespace Rhegma::program
{

namespace
{

constexpr int mostSteps = 2000000000; ///< default of Time > Maximum Steps

RunResults resultsIn(const std::string& folder)
{
  std::ifstream file(folder + "/summary.json");
  const RunResults results{nlohmann::json::parse(file, nullptr, false), readHistory(folder + "/history.csv")};
  if (!results.summary.is_object())
    throw OutputError("there is no comparison: " + folder + "/summary.json can't be read");
  return results;
}

/// The output folder with those of its two runs. Its functions are called on the first rank.
struct Folders
{
  std::string outer, asIs, half, scene;

  /// Throws std::invalid_argument where the files of another run, of the user, or the scene would be
  /// replaced.
  void refuseForeign() const
  {
    refuseForeignComparison(outer, scene);
    for (const std::string& folder : {asIs, half})
    {
      refuseFolderInUse(folder);
      refuseForeignFiles(folder, scene);
    }
  }

  /// Takes the folders and removes what older runs left: no comparison, and no run with half the cells, is to
  /// be found next to a run that it does not belong to.
  std::unique_ptr<RunLock> take() const
  {
    makeOutputFolder(outer);
    auto lock = std::make_unique<RunLock>(outer);
    refuseForeign();
    makeOutputFolder(half);
    const RunLock meanwhile(half);
    removeOldComparison(outer);
    removeOldResults(half);
    return lock;
  }
};

/// Exit codes from the best to the worst.
int worse(int one, int other)
{
  constexpr int order[] = {exitFinished, exitReferenceMissed, exitStopped, exitWrongScene, exitDefect};
  const auto rank = [&](int code) { return std::find(std::begin(order), std::end(order), code); };
  return rank(one) < rank(other) ? other : one;
}

/// Whether a run left something to compare: it came to its end, or stopped by itself.
bool comparable(int code, const std::string& folder)
{
  if (code != exitStopped)
    return code == exitFinished || code == exitReferenceMissed;
  std::ifstream file(folder + "/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  return summary.is_object() && endOf(summary) != RunEnd::Signalled;
}

/// Prints and writes the comparison. Throws OutputError when it can't be read or written.
void compare(const Folders& folders, std::ostream& out)
{
  const nlohmann::json comparison = compareRuns(resultsIn(folders.asIs), resultsIn(folders.half));
  out << "\n" << comparisonAsText(comparison) << std::flush;
  replaceFile(folders.outer + "/" + comparisonName,
              comparison.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

} // namespace

void halveCells(Teuchos::ParameterList& scene)
{
  Teuchos::ParameterList& domain = scene.sublist("Domain");
  domain.set("Cell Size", 0.5 * domain.get<double>("Cell Size"));
  domain.remove("Accuracy", false);
  Teuchos::ParameterList& time = scene.sublist("Time");
  const int steps = time.get<int>("Maximum Steps");
  time.set("Maximum Steps", steps < mostSteps / 2 ? 2 * steps : mostSteps);
}

int runTwice(const Options& options, const Teuchos::RCP<Teuchos::ParameterList>& scene, const Ranks& ranks,
             std::ostream& out, std::ostream& err, const RunOne& runOne)
{
  const std::string folder = options.output.empty() ? defaultOutputFolder(options.scene) : options.output;
  const Folders folders{folder, folder + "/as_is", folder + "/half", options.scene};
  onFirstRank<std::invalid_argument>(ranks,
                                     [&]
                                     {
                                       refuseFolderInUse(folder);
                                       folders.refuseForeign();
                                     });
  std::unique_ptr<RunLock> lock;
  const auto take = [&] { onFirstRank<std::invalid_argument>(ranks, [&] { lock = folders.take(); }); };
  const auto half = Teuchos::rcp(new Teuchos::ParameterList(*scene));
  halveCells(*half);
  int worst = exitFinished;
  for (const bool asIs : {true, false})
  {
    Options one = options;
    one.output = asIs ? folders.asIs : folders.half;
    if (!options.quiet)
      out << (asIs ? "The scene as it is:\n" : "\nThe scene with cells of half the size:\n") << std::flush;
    int code = exitDefect;
    try
    {
      code = runOne(
          one, asIs ? scene : half, asIs ? std::function<void()>(take) : [] {});
    }
    catch (...)
    {
      if (!asIs)
        err << "rhegma: there is no comparison, since the scene with cells of half the size can't be run; "
               "the "
               "results of the scene as it is are in "
            << folders.asIs << "\n";
      throw;
    }
    worst = worse(worst, code);
    if (!asFirstRank(ranks, comparable(code, one.output)))
      return worst;
  }
  try
  {
    onFirstRank<OutputError>(ranks,
                             [&]
                             {
                               if (const std::string loss = lock->loss(); !lock->holds())
                                 throw OutputError("there is no comparison: " + loss);
                               compare(folders, out);
                             });
  }
  catch (const OutputError& error)
  {
    err << "rhegma: " << error.what() << "\n";
    worst = worse(worst, exitStopped);
  }
  return worst;
}

} // namespace Rhegma::program
