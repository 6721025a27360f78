#include "program/Templates.hpp"

#include "base/OutputError.hpp"
#include "files/TextFile.hpp"
#include "parallel/FirstRank.hpp"
#include "scene/NearestName.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>
#include <filesystem>

namespace Rhegma::program
{

const SceneTemplate& findTemplate(const std::string& name)
{
  const std::vector<SceneTemplate>& all = sceneTemplates();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const SceneTemplate& one) { return name == one.name; });
  if (found != all.end())
    return *found;
  std::vector<std::string> names;
  for (const SceneTemplate& one : all)
    names.emplace_back(one.name);
  const std::string nearest = nearestName(name, names);
  throw UsageError(
      (name.empty() ? "--new needs the name of a template" : "--new: there is no template \"" + name + "\"") +
      "; write " + Rhegma::asText(names) + (nearest.empty() ? "" : " (did you mean \"" + nearest + "\"?)"));
}

int writeTemplate(const Options& options, std::ostream& out, std::ostream& err)
{
  const SceneTemplate& found = findTemplate(options.section);
  if (options.output.empty())
  {
    out << found.text;
    return exitFinished;
  }
  try
  {
    const Ranks ranks(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)));
    onFirstRank<OutputError>(
        ranks,
        [&]
        {
          std::error_code none;
          if (std::filesystem::exists(std::filesystem::symlink_status(options.output, none)))
            throw OutputError(options.output + " exists; it is not replaced");
          replaceFile(options.output, found.text);
        });
  }
  catch (const OutputError& error)
  {
    err << "rhegma: " << error.what() << "; choose another file with --output\n";
    return exitWrongScene;
  }
  out << "The scene is in " << options.output << "; rhegma " << options.output << " --check checks it\n";
  return exitFinished;
}

} // namespace Rhegma::program
