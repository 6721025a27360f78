#pragma once
/// Parameters of a law of friction: Law, Friction Coefficient and Static Friction Coefficient.

#include "material/FrictionLaw.hpp"
#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Adds the parameters to a section; surfaces slide freely by default.
void addFrictionLaw(Section& section);

/// A law of surfaces that is not one of friction.
struct OtherLaw
{
  std::string name;
  std::string meaning; ///< added to that of the laws of friction
};

/// The same for a list whose law is that of its section if it has none of its own. \param more laws that the
/// list may have in addition; their parameters are the caller's
void addFrictionLawOfList(Section& list, const std::vector<OtherLaw>& more = {});

/// Checks them. \param path of the list in the scene
void checkFrictionLaw(const Teuchos::ParameterList& list, const std::string& path,
                      std::vector<SceneError>& errors);

/// \param list validated, with a Law
FrictionLaw readFrictionLaw(const Teuchos::ParameterList& list);

} // namespace Rhegma
