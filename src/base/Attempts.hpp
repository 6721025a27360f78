#pragma once
/// All mistakes at once.

#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma
{

/// Goes on after a mistake, so that all mistakes are reported together.
class Attempts
{
public:
  /// Calls `function` and stores the message of the std::invalid_argument that it throws. \return whether it
  /// threw none
  template <class Function>
  bool attempt(const Function& function)
  {
    try
    {
      function();
      return true;
    }
    catch (const std::invalid_argument& mistake)
    {
      messages_ += (messages_.empty() ? "" : "\n") + std::string(mistake.what());
      return false;
    }
  }

  bool succeeded() const { return messages_.empty(); }

  /// Throws std::invalid_argument with all messages, a line each, if there are any. \param warnings follow
  /// them, each in a line that starts with "warning: "
  void throwIfAny(const std::vector<std::string>& warnings = {}) const
  {
    if (succeeded())
      return;
    std::string all = messages_;
    for (const std::string& warning : warnings)
      all += "\nwarning: " + warning;
    throw std::invalid_argument(all);
  }

private:
  std::string messages_;
};

} // namespace Rhegma
