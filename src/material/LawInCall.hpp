#pragma once
/// Which law a thread is calling, for whoever must say why the process ends.

namespace Rhegma
{

struct LoadedLaw;

/// Marks a law as called by this thread, for its own lifetime.
class LawInCall
{
public:
  explicit LawInCall(const LoadedLaw& law);
  ~LawInCall();
  LawInCall(const LawInCall&) = delete;
  LawInCall& operator=(const LawInCall&) = delete;
};

/// The law that the calling thread is in; null outside of laws. May be asked by a handler of a signal or of
/// the end of the process.
const LoadedLaw* lawInCall();

} // namespace Rhegma
