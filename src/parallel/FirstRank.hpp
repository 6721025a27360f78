#pragma once
/// Work that one rank does for all, such as writing files.

#include "parallel/Ranks.hpp"

#include <exception>
#include <stdexcept>

namespace Rhegma
{

/// Runs work() on rank 0. Where it throws there, so do all ranks, the others `Error` with the same words.
/// Collective. \tparam Error made from a text
template <class Error, class Work>
void onFirstRank(const Ranks& ranks, const Work& work)
{
  std::exception_ptr own;
  std::string words;
  if (ranks.rank() == 0)
    try
    {
      work();
    }
    catch (const std::exception& error)
    {
      own = std::current_exception();
      words = error.what();
    }
  words = ranks.firstText(words);
  if (own)
    std::rethrow_exception(own);
  if (!words.empty())
    throw Error(words);
}

} // namespace Rhegma
