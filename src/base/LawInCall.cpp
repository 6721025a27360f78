#include "base/LawInCall.hpp"

namespace Rhegma
{

namespace
{

thread_local const LawInCall* ofThisThread = nullptr;

} // namespace

LawInCall::LawInCall(const char* name, const char* path) : behaviour(name), file(path)
{
  ofThisThread = this;
}

LawInCall::~LawInCall() { ofThisThread = nullptr; }

const LawInCall* lawInCall() { return ofThisThread; }

} // namespace Rhegma
