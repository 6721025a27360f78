#pragma once
/// Comparison with the reference values of a scene.

#include <Teuchos_ParameterList.hpp>

#include <nlohmann/json.hpp>
#include <string>

namespace Rhegma
{

/// Compares the summary with the `Reference` section and adds the list `references`.
///
/// A Quantity is a path of names with dots between; an entry of a list is chosen by its position, from 0, or
/// by its `name`: cracks.0.fronts.0.G_J, cracks.Notch.pressure. Tolerance bounds |value - reference| /
/// |reference|; where the reference is 0 it bounds |value|, and relative_error holds that. A quantity that is
/// not there or is not a number is outside of its tolerance and `problem` says why. A time of growth in a run
/// whose loads have a factor is not compared: `within` is null, and `left_out` says why. \param section
/// validated `Reference` section; may be empty \return whether all that are compared are within their
/// tolerances, and at least one is compared if there are any
bool addReferences(const Teuchos::ParameterList& section, nlohmann::json& summary);

/// Throws std::invalid_argument, a line per quantity, for quantities that a summary does not contain, so that
/// misspelt names are reported before the run. \param summary of the run before its first step, with null
/// where there is no value yet
void refuseUnknownQuantities(const Teuchos::ParameterList& section, const nlohmann::json& summary);

/// Warning before a run whose loads have a factor, of which no reference will be compared as all are times of
/// growth; empty where one will, or there are none. \param section `Reference`; may be empty
std::string warningOfReferences(const Teuchos::ParameterList& section);

/// The references of a summary as text, a line each; empty without references.
std::string referencesAsText(const nlohmann::json& summary);

} // namespace Rhegma
