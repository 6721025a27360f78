#pragma once
/// A section as a Teuchos list: each entry with its documentation and a validator.

#include "scene/Schema.hpp"

#include <Teuchos_ParameterEntryValidator.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

namespace Rhegma
{

/// The validator of a parameter: a number validator whose open bounds are the next double inside, a string
/// validator of the choices, or one that parses a function of time. Numbers must be finite. Null where any
/// value will do.
Teuchos::RCP<const Teuchos::ParameterEntryValidator> makeValidator(const Parameter& parameter);

/// Meaning, unit, range and default in one text, as Teuchos documents a parameter.
std::string documentation(const Parameter& parameter);

/// The section's own parameters with documentation and validators, its fixed subsections below them. A
/// parameter without a default holds some valid value, since an entry can't be without one. The parameters of
/// a variant are in `validParameters` of that variant.
Teuchos::RCP<const Teuchos::ParameterList> validParameters(const Section& section);

} // namespace Rhegma
