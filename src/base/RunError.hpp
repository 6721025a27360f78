#pragma once
/// Why a run can't go on.

#include <stdexcept>

namespace Rhegma
{

/// Thrown by a run that can't go on; the program's exit 2.
class RunError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace Rhegma
