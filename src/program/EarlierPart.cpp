#include "program/EarlierPart.hpp"

#include "base/OutputError.hpp"
#include "output/OutputFolder.hpp"

#include <filesystem>
#include <stdexcept>

namespace Rhegma::program
{

namespace fs = std::filesystem;

namespace
{

bool same(const std::string& a, const std::string& b)
{
  std::error_code none;
  return fs::equivalent(a, b, none);
}

bool isThere(const std::string& path)
{
  std::error_code none;
  return fs::exists(path, none);
}

void copy(const std::string& from, const std::string& to)
{
  std::error_code error;
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  if (error)
    throw OutputError(to + " can't be written: " + error.message());
}

} // namespace

EarlierPart::EarlierPart(const std::string& checkpoint, const std::string& folder, const HistorySoFar& soFar)
    : exists_(true), folder_(folder), soFar_(soFar)
{
  const std::string adjacent = fs::path(checkpoint).parent_path().string();
  source_ = adjacent.empty() ? "." : adjacent;
  if (soFar.bytes == 0)
    return;
  std::string other;
  for (const std::string& position : {source_, folder_})
  {
    const std::string history = position + "/history.csv";
    if (beginsWith(history, soFar))
    {
      source_ = position;
      return;
    }
    if (other.empty() && isThere(history))
      other = history;
  }
  if (!other.empty())
    throw std::invalid_argument(other + " is not the history that belongs to the checkpoint " + checkpoint +
                                "; restore that one, or remove this one to continue without it");
  soFar_ = HistorySoFar();
  warnings_.push_back("there is no history.csv next to the checkpoint " + checkpoint +
                      ", so the history of this run begins there");
}

void EarlierPart::bring() const
{
  if (same(source_, folder_))
  {
    removeOldSummary(folder_);
    return;
  }
  removeOldResults(folder_);
  if (soFar_.bytes > 0)
    copy(source_ + "/history.csv", folder_ + "/history.csv");
  for (const char* name : {"/fields.h5", "/fronts.h5", "/fronts.csv"})
    if (isThere(source_ + name))
      copy(source_ + name, folder_ + name);
}

} // namespace Rhegma::program
