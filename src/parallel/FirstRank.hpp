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

/// What the first rank thinks, on all ranks. Collective.
inline bool asFirstRank(const Ranks& ranks, bool own)
{
  return ranks.max(ranks.rank() == 0 && own ? 1.0 : 0.0) > 0.0;
}

/// Runs work() on all ranks; where it throws std::invalid_argument on some, all throw it, with the words of
/// the lowest of them. Collective.
template <class Work>
void onEachRank(const Ranks& ranks, const Work& work)
{
  if (!ranks.many())
    return work();
  std::string words;
  try
  {
    work();
  }
  catch (const std::invalid_argument& error)
  {
    words = error.what();
  }
  words = ranks.firstText(words);
  if (!words.empty())
    throw std::invalid_argument(words);
}

} // namespace Rhegma
