#include "program/LawEnds.hpp"

#include "base/LawInCall.hpp"
#include "base/SignalName.hpp"
#include "output/RunLock.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mpi.h>
#include <unistd.h>

namespace Rhegma::program
{

namespace
{

constexpr int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr int numCrashes = sizeof crashes / sizeof crashes[0];

int statusOfFailure = 0;
struct sigaction handlersBefore[numCrashes];

/// For a handler of signals: no memory is taken.
void say(const char* text)
{
  if (write(STDERR_FILENO, text, std::strlen(text)) < 0)
    return;
}

void sayWhich(const LawInCall& law)
{
  say("rhegma: the law \"");
  say(law.behaviour);
  say("\" of ");
  say(law.file);
}

/// At exit(): within a law it is the law that called it.
void endInLaw()
{
  const LawInCall* const law = lawInCall();
  if (law == nullptr)
    return;
  std::fflush(stdout);
  sayWhich(*law);
  say(" ended the program (by exit or STOP), so that the run has no summary; let the law return a stress "
      "that is not a number (UMAT: PNEWDT below 1) where it can't go on\n");
  removeRunLock();
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  if (size > 1)
    MPI_Abort(MPI_COMM_WORLD, statusOfFailure);
  _exit(statusOfFailure);
}

extern "C" void crash(int signal)
{
  if (const LawInCall* const law = lawInCall())
  {
    sayWhich(*law);
    const char number[] = {static_cast<char>('0' + signal / 10), static_cast<char>('0' + signal % 10), '\0'};
    say(" crashed by signal ");
    say(signal < 10 ? number + 1 : number);
    say(" (");
    say(signalName(signal));
    say("), so that the run has no summary; look for indices beyond its arrays\n");
    _exit(statusOfFailure);
  }
  for (int k = 0; k < numCrashes; ++k)
    if (crashes[k] == signal)
      sigaction(signal, &handlersBefore[k], nullptr);
  raise(signal); // arrives at the handler before when this one returns
}

} // namespace

void sayWhichLawEnds(int status)
{
  statusOfFailure = status;
  std::atexit(endInLaw);
  // A law with large local arrays may have used up the stack.
  static char ownStack[65536];
  stack_t stack = {};
  stack.ss_sp = ownStack;
  stack.ss_size = sizeof ownStack;
  sigaltstack(&stack, nullptr);
  for (int k = 0; k < numCrashes; ++k)
  {
    struct sigaction action = {};
    action.sa_handler = crash;
    action.sa_flags = SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    sigaction(crashes[k], &action, &handlersBefore[k]);
  }
}

} // namespace Rhegma::program
