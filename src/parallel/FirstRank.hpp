#pragma once
/// Functions that one rank runs for all, such as writing files.

#include "parallel/Ranks.hpp"

#include <exception>
#include <stdexcept>

namespace Rhegma
{

/// Runs function() on rank 0. If it throws, all ranks throw, the others `Error` with the same message.
/// Collective. \tparam Error made from a text
template <class Error, class Function>
void onFirstRank(const Ranks& ranks, const Function& function)
{
  std::exception_ptr own;
  std::string message;
  if (ranks.rank() == 0)
    try
    {
      function();
    }
    catch (const std::exception& error)
    {
      own = std::current_exception();
      message = error.what();
    }
  message = ranks.firstText(message);
  if (own)
    std::rethrow_exception(own);
  if (!message.empty())
    throw Error(message);
}

/// The value of the first rank, on all ranks. Collective.
inline bool asFirstRank(const Ranks& ranks, bool own)
{
  return ranks.max(ranks.rank() == 0 && own ? 1.0 : 0.0) > 0.0;
}

/// Runs function() on all ranks; where it throws std::invalid_argument on some, all throw it, with the
/// message of the lowest of them. Collective.
template <class Function>
void onEachRank(const Ranks& ranks, const Function& function)
{
  if (!ranks.many())
    return function();
  std::string message;
  try
  {
    function();
  }
  catch (const std::invalid_argument& error)
  {
    message = error.what();
  }
  message = ranks.firstText(message);
  if (!message.empty())
    throw std::invalid_argument(message);
}

} // namespace Rhegma
