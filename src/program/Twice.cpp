#include "program/Twice.hpp"

#include "base/OutputError.hpp"
#include "files/TextFile.hpp"
#include "output/OutputFolder.hpp"
#include "parallel/FirstRank.hpp"
#include "program/CompareRuns.hpp"

#include <algorithm>
#include <fstream>

namespace Rhegma::program
{

namespace
{

constexpr int mostSteps = 2000000000; ///< default of Time > Maximum Steps

RunResults resultsIn(const std::string& folder)
{
  std::ifstream file(folder + "/summary.json");
  return {nlohmann::json::parse(file, nullptr, false), readHistory(folder + "/history.csv")};
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
             std::ostream& out, const RunOne& runOne)
{
  const std::string folder = options.output.empty() ? defaultOutputFolder(options.scene) : options.output;
  const auto half = Teuchos::rcp(new Teuchos::ParameterList(*scene));
  halveCells(*half);
  int worst = exitFinished;
  for (const bool asIs : {true, false})
  {
    Options one = options;
    one.output = folder + (asIs ? "/as_is" : "/half");
    if (!options.quiet)
      out << (asIs ? "The scene as it is:\n" : "\nThe scene with cells of half the size:\n") << std::flush;
    const int code = runOne(one, asIs ? scene : half);
    // A reference missed by one of them is told, and no reason to end.
    if (code != exitFinished && code != exitReferenceMissed)
      return code;
    worst = std::max(worst, code);
  }
  onFirstRank<OutputError>(ranks,
                           [&]
                           {
                             const nlohmann::json comparison =
                                 compareRuns(resultsIn(folder + "/as_is"), resultsIn(folder + "/half"));
                             out << "\n" << comparisonAsText(comparison);
                             replaceFile(folder + "/twice.json", comparison.dump(2) + "\n");
                           });
  return worst;
}

} // namespace Rhegma::program
