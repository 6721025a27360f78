#pragma once
/// A scene as it is and with cells of half the size.

#include "parallel/Ranks.hpp"
#include "program/Options.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <functional>
#include <ostream>

namespace Rhegma::program
{

/// Halves the coarsest cells of a validated scene, and with them all levels below; what Domain > Accuracy
/// chose is kept. A limit of Maximum Steps is doubled, since steps are halved too.
void halveCells(Teuchos::ParameterList& scene);

/// Runs one scene. \return the program's exit code
using RunOne = std::function<int(const Options&, const Teuchos::RCP<Teuchos::ParameterList>&)>;

/// Runs the scene in as_is and half, folders in the output folder, and compares them: a table on `out`, and
/// twice.json in the output folder. Collective. \param scene validated
/// \return the exit code of the runs, the first one's that failed; what is not resolved is no failure
/// Throws OutputError when twice.json can't be written.
int runTwice(const Options& options, const Teuchos::RCP<Teuchos::ParameterList>& scene, const Ranks& ranks,
             std::ostream& out, const RunOne& runOne);

} // namespace Rhegma::program
