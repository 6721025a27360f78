#pragma once
/// A law is called before the run, to see what it does.

#include "material/InChild.hpp"
#include "material/LoadedLaw.hpp"

namespace Rhegma
{

/// Stages of a trial, in this order; those of guards repeat after large strains.
namespace LawStage
{
constexpr char load = 'l', call = 'c', constants = 'k', states = 's', large = 'L';
}

/// The number of a law that loadLaw has loaded; -1 if it has not.
int foundLaw(const LawRequest& request);

/// Calls a law for strains of 1e-6 and, if the process may end in it, for large ones.
///
/// It is refused where it uses numbers behind its constants or state variables: its results then depend on
/// what is there, or it writes there. So are results of the strains of 1e-6 that are not finite, stiffer than
/// the elastic constants say, or not stiff at all, and dissipation that is negative.
///
/// \param talk gets the stages; null: large strains are left out \throws LawRefused
void tryLaw(const LoadedLaw& law, const Properties& m, ChildTalk* talk);

} // namespace Rhegma
