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

/// Runs one scene. The last argument is called on all ranks when nothing of the scene was found wrong and
/// before files are changed. \return the program's exit code
using RunOne = std::function<int(const Options&, const Teuchos::RCP<Teuchos::ParameterList>&,
                                 const std::function<void()>& beforeFiles)>;

/// Runs the scene in as_is and half, folders in the output folder, and compares them: a table on `out`, and
/// twice.json in the output folder. Also runs that stop are compared, unless a signal stopped them.
/// Collective. \param scene validated \param err for what keeps the comparison from being written
/// \return the worse exit code of the runs: finished, a reference missed, stopped, wrong scene; what is not
/// resolved is no failure. Throws std::invalid_argument where a folder is in use, or where the scene or files
/// that no run wrote would be replaced.
int runTwice(const Options& options, const Teuchos::RCP<Teuchos::ParameterList>& scene, const Ranks& ranks,
             std::ostream& out, std::ostream& err, const RunOne& runOne);

} // namespace Rhegma::program
