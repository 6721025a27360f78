#include "program/ContinueOutput.hpp"

#include "base/OutputError.hpp"
#include "output/OutputFolder.hpp"
#include "parallel/FirstRank.hpp"
#include "program/Intervals.hpp"

#include <filesystem>

namespace Rhegma::program
{

namespace
{

/// Renames a file if it is there. \return its new path, on all ranks; empty: it is not there
std::string moveAside(const std::string& path, const Ranks& ranks)
{
  std::string aside;
  onFirstRank<OutputError>(ranks,
                           [&]
                           {
                             std::error_code none;
                             if (std::filesystem::exists(path, none))
                               aside = setAside(path);
                           });
  return ranks.firstText(aside);
}

/// Renames a file that can't be continued. \param content what it holds \param why it can't \return a warning
std::string setFileAside(const std::string& data, const std::string& content, const std::string& why,
                         const Ranks& ranks)
{
  const std::string aside = moveAside(data, ranks);
  const std::string anew = "new " + content + " are written from here on";
  return aside.empty()
             ? "there is no " + data + " with the " + content + " of the run up to the checkpoint; " + anew
             : data + " does not hold the " + content + " of the run up to the checkpoint: " + why +
                   "; it is renamed to " + aside + ", and " + anew;
}

} // namespace

std::vector<std::string> continueOutput(const Teuchos::ParameterList& scene, Simulation& simulation,
                                        const std::string& folder, const Ranks& ranks)
{
  std::vector<std::string> warnings;
  std::string why;
  if (scene.sublist("Output").get<bool>("Fields") && !simulation.continueFields(folder, &why))
    warnings.push_back(setFileAside(folder + "/fields.h5", "fields", why, ranks));
  if ((writesFronts(scene, "With Fields") || writesFronts(scene, "With History")) &&
      !simulation.continueFronts(folder, &why))
  {
    warnings.push_back(setFileAside(folder + "/fronts.h5", "values along fronts", why, ranks));
    moveAside(folder + "/fronts.csv", ranks); // which has the same samples
  }
  return warnings;
}

} // namespace Rhegma::program
