/// Laws are loaded and tried in a process of their own first.

#include "base/SignalName.hpp"
#include "material/LawTrial.hpp"
#include "material/LibraryFile.hpp"
#include "material/SharedLibrary.hpp"

#include <array>
#include <exception>
#include <set>

namespace Rhegma
{

namespace
{

/// What the results of a trial depend on, in addition to the law.
using TriedAs = std::pair<int, std::array<double, 6>>;

std::set<TriedAs>& tried()
{
  static std::set<TriedAs> all;
  return all;
}

TriedAs triedAs(int number, const Properties& m)
{
  return {number, {m.density, m.temperature, m.cellSize, m.lambda, m.mu, m.own[SharedLawNumber::speed]}};
}

/// Runs in the other process. The answer is empty, or the parameter and, on a second line, what is wrong.
void tryInChild(const LawRequest& request, const Properties& m, ChildTalk& talk)
{
  constexpr int seconds = 60;
  std::string wrong;
  try
  {
    talk.stage(LawStage::load, seconds);
    const int number = loadLaw(request);
    tryLaw(loadedLaw(number), m, &talk);
  }
  catch (const LawRefused& refused)
  {
    wrong = refused.parameter + "\n" + refused.what();
  }
  catch (const std::exception& error)
  {
    wrong = "Behaviour\n\"" + request.behaviour + "\" throws an exception (" + error.what() +
            ") before the run; a law must not.";
  }
  talk.answer(wrong);
}

/// "ends the program by signal 11 (Segmentation fault)".
std::string howItEnded(const ChildEnd& end)
{
  std::string how;
  if (end.how == ChildEnd::How::Killed)
    how = "ends the program by signal " + std::to_string(end.signal) + " (" + signalName(end.signal) + ")";
  else if (end.how == ChildEnd::How::Exited)
    how = "ends the program (by exit or STOP)";
  else
    how = "does not return";
  return how + (end.said.empty() ? "" : ", with the message \"" + end.said + "\",");
}

[[noreturn]] void refuse(const LawRequest& request, const ChildEnd& end)
{
  const std::string how = howItEnded(end), law = "\"" + request.behaviour + "\"";
  const std::string given = std::to_string(request.constants.size());
  if (end.stage == LawStage::load)
    throw LawRefused("Library File", request.file + " " + how +
                                         " when it is loaded; compile it again with rhegma-law, and look at "
                                         "what it does at its start.");
  if (end.stage == LawStage::constants)
    throw LawRefused("Constants", "has " + given + (given == "1" ? " number" : " numbers") + ", but " + law +
                                      " uses more: it " + how +
                                      " when there are other numbers than zero behind them; give all "
                                      "constants of the law, in its order.");
  if (end.stage == LawStage::states)
    throw LawRefused("State Variables",
                     "is less than " + law + " uses: it " + how +
                         " when there are other numbers than zero behind them; give as many as the law has.");
  throw LawRefused("Behaviour",
                   law + " of " + request.file + " " + how +
                       " when it is called for a strain of 1e-6 of the undeformed material; check "
                       "Constants, State Variables and Interface, or look at the law.");
}

/// \return whether the law is tried \throws LawRefused
bool isRightInChild(const LawRequest& request, const Properties& m)
{
  const ChildEnd end = inChild([&](ChildTalk& talk) { tryInChild(request, m, talk); });
  if (end.how == ChildEnd::How::NotStarted)
    return false;
  if (end.how != ChildEnd::How::Answered && end.stage != LawStage::large)
    refuse(request, end);
  if (const std::size_t line = end.answer.find('\n'); line != std::string::npos)
    throw LawRefused(end.answer.substr(0, line), end.answer.substr(line + 1));
  return true;
}

} // namespace

int loadAndTry(const LawRequest& request, const Properties& m)
{
  checkLibraryFile(request.file);
  const int before = foundLaw(request);
  if (before >= 0 && tried().count(triedAs(before, m)) > 0)
    return before;
  const bool isRight = isRightInChild(request, m);
  const int number = loadLaw(request);
  if (!isRight)
    tryLaw(loadedLaw(number), m, nullptr);
  tried().insert(triedAs(number, m));
  return number;
}

} // namespace Rhegma
