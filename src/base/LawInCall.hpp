#pragma once
/// Which law a thread is calling, for whoever must say why the process ends.

namespace Rhegma
{

/// Marks a law of a shared library as called by this thread, for its own lifetime. Both texts must live as
/// long.
class LawInCall
{
public:
  LawInCall(const char* behaviour, const char* file);
  ~LawInCall();
  LawInCall(const LawInCall&) = delete;
  LawInCall& operator=(const LawInCall&) = delete;

  const char* const behaviour; ///< name of the function
  const char* const file;      ///< path of the library
};

/// The law that the calling thread is in; null outside of laws. May be asked by a handler of a signal or of
/// the end of the process.
const LawInCall* lawInCall();

} // namespace Rhegma
