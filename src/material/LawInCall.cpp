#include "material/LawInCall.hpp"

namespace Rhegma
{

namespace
{

thread_local const LoadedLaw* calledByThisThread = nullptr;

} // namespace

LawInCall::LawInCall(const LoadedLaw& law) { calledByThisThread = &law; }

LawInCall::~LawInCall() { calledByThisThread = nullptr; }

const LoadedLaw* lawInCall() { return calledByThisThread; }

} // namespace Rhegma
