#pragma once
/// Files of the output that a run continues after a checkpoint.

#include "archive/Archive.hpp"
#include "base/OutputError.hpp"

#include <memory>
#include <string>

namespace Rhegma
{

/// Continues files as a checkpoint left them. Collective.
/// \param folder of the output \param ranks of the run \param group of the checkpoint
/// \param before what the checkpoint holds of them; then empty \param files that are continued, if they can
/// be \return why they can't; empty: they are, or there were none
template <class Files>
std::string continueFiles(const std::string& folder, const Ranks& ranks, const std::string& group,
                          Record& before, std::unique_ptr<Files>& files)
{
  if (before.empty())
    return {};
  std::string why;
  Archive archive = Archive::loading(before, ranks);
  const Archive::Group inside(archive, group);
  try
  {
    files = std::make_unique<Files>(folder, archive);
  }
  catch (const OutputError& error)
  {
    why = error.what();
  }
  before.clear();
  return why;
}

/// Saves how far files go, or, until they are continued, what the checkpoint before holds of them.
/// \param archive saves to `record` \param group, before, files as for continueFiles(); `files` may be empty
template <class Files>
void saveFiles(Archive& archive, Record& record, const std::string& group, const Record& before,
               const std::unique_ptr<Files>& files)
{
  if (!files)
    return record.insert(before.begin(), before.end());
  const Archive::Group inside(archive, group);
  files->serialize(archive);
}

/// The tables of a record whose paths start so.
inline Record partOf(const Record& record, const std::string& start)
{
  Record part;
  for (const auto& [path, table] : record)
    if (path.rfind(start, 0) == 0)
      part[path] = table;
  return part;
}

} // namespace Rhegma
