#pragma once

#include <csignal>

namespace Rhegma
{

/// What a signal that ends a process means, for a message; takes no memory, so that a handler may use it.
inline const char* signalName(int signal)
{
  switch (signal)
  {
  case SIGSEGV:
    return "segmentation fault";
  case SIGBUS:
    return "bus error, as of a file that is cut short";
  case SIGFPE:
    return "arithmetic";
  case SIGILL:
    return "illegal instruction, as of another kind of processor";
  case SIGABRT:
    return "abort";
  default:
    return "killed";
  }
}

} // namespace Rhegma
