#pragma once
/// All mistakes at once.

#include <stdexcept>
#include <string>

namespace Rhegma
{

/// Goes on after a mistake, so that a user hears of every one of several things that can't be made.
class Attempts
{
public:
  /// Calls `work` and keeps the sentence of the std::invalid_argument that it throws. \return whether it
  /// threw none
  template <class Work>
  bool attempt(const Work& work)
  {
    try
    {
      work();
      return true;
    }
    catch (const std::invalid_argument& mistake)
    {
      sentences_ += (sentences_.empty() ? "" : "\n") + std::string(mistake.what());
      return false;
    }
  }

  bool allWell() const { return sentences_.empty(); }

  /// Throws std::invalid_argument with all sentences, a line each, if there are any.
  void throwIfAny() const
  {
    if (!allWell())
      throw std::invalid_argument(sentences_);
  }

private:
  std::string sentences_;
};

} // namespace Rhegma
