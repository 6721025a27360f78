#pragma once
/// A folder for files that are of use only while the program runs.

#include "parallel/Ranks.hpp"

#include <filesystem>
#include <stdlib.h>
#include <string>
#include <system_error>

namespace Rhegma::program
{

/// A folder of its own, one for all ranks, that is removed with all that is in it.
class ScratchFolder
{
public:
  /// Collective.
  explicit ScratchFolder(const Ranks& ranks)
  {
    std::error_code none;
    std::string pattern = (std::filesystem::temp_directory_path(none) / "rhegma-XXXXXX").string();
    if (ranks.rank() == 0 && mkdtemp(pattern.data()) != nullptr)
      path_ = pattern;
    path_ = ranks.firstText(path_);
  }
  ~ScratchFolder()
  {
    std::error_code none;
    if (!path_.empty())
      std::filesystem::remove_all(path_, none);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// Empty where none can be made.
  const std::string& path() const { return path_; }

  double bytes() const ///< of its files
  {
    double sum = 0.0;
    std::error_code none;
    for (const auto& file : std::filesystem::directory_iterator(path_, none))
      sum += static_cast<double>(file.file_size(none));
    return sum;
  }

private:
  std::string path_;
};

} // namespace Rhegma::program
