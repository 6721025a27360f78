#pragma once
/// Finds the equilibrium in which motion begins because cracks grow unstably (Method::handsOver).

#include "archive/Record.hpp"
#include "step/Run.hpp"

#include <Teuchos_RCP.hpp>

#include <functional>
#include <memory>

namespace Rhegma
{

/// The scene of the motion that follows the equilibrium of a scene.
Teuchos::RCP<Teuchos::ParameterList> sceneOfMotion(const Teuchos::ParameterList& scene);

/// Makes a run of the equilibrium anew, initialised: what a step has changed can't be taken back otherwise.
template <int D>
using MakeRun = std::function<std::unique_ptr<Run<D>>()>;

/// Takes a step of equilibrium, not beyond `until`, or one that ends where motion begins: at rest, with
/// cracks that are about to advance, under loads with which G is a thousandth above the toughness. The load
/// step in which growth is unstable is repeated in shorter ones, and with it stable growth before. Throws
/// RunError as a step does. Collective. \param run is replaced by another if the step is repeated \param
/// sample as of Run::step \return whether motion begins; there is then a sample
template <int D>
bool stepToMotion(std::unique_ptr<Run<D>>& run, double until, bool sample, const MakeRun<D>& make);

} // namespace Rhegma
