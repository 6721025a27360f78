#pragma once
/// All mistakes at once.

#include <stdexcept>
#include <string>

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

  /// Throws std::invalid_argument with all messages, a line each, if there are any.
  void throwIfAny() const
  {
    if (!succeeded())
      throw std::invalid_argument(messages_);
  }

private:
  std::string messages_;
};

} // namespace Rhegma
