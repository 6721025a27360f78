#pragma once
/// From XML text to a parameter list; reports every error in the text.

#include "scene/SceneError.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// The list that the XML describes, without invalid entries: duplicate names, names with control characters,
/// missing attributes, unknown types, values that are not of their type. Teuchos itself would merge
/// duplicates and read "1.5Pa" as 1.5 and "abc" as 0. A parameter with the attribute `unit` is a
/// ValueWithUnit (scene/ConvertUnits.hpp). Null if the text is no XML, no scene or not UTF-8.
Teuchos::RCP<Teuchos::ParameterList> parseXml(const std::string& xml, const std::string& topName,
                                              std::vector<SceneError>& errors);

} // namespace Rhegma
