#pragma once
/// A file of results that can't be written.

#include <stdexcept>

namespace Rhegma
{

/// The message says which file and why: a full disk, a folder that is gone, missing rights.
class OutputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace Rhegma
