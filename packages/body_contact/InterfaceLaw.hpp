#pragma once
/// Law of an interface that joins two bodies elastically: an imperfect bond, such as a thin layer of
/// adhesive.

#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <optional>
#include <string>
#include <vector>

namespace Rhegma::body_contact
{

/// Traction over displacement jump; both directions, in tension as in compression. Source: Nairn, CMES 92
/// (2013) 271.
struct InterfaceLaw
{
  double normal = 0.0; ///< stiffness along the normal [Pa/m]
  double along = 0.0;  ///< stiffness along the faces [Pa/m]
};

/// Name of the law in scenes.
constexpr const char* interfaceLaw = "Interface";

/// Adds the parameters of a pair: a law of friction or of an interface.
void addInterfaceLawOfList(Section& pair);

/// Checks that the stiffness is given with the law, and only with it. \param path of the list in the scene
void checkInterfaceLaw(const Teuchos::ParameterList& list, const std::string& path,
                       std::vector<SceneError>& errors);

/// \param list of a pair, validated \return nothing if its law is another one
std::optional<InterfaceLaw> interfaceLawIf(const Teuchos::ParameterList& list);

/// Whether a pair of a section has this law. \param section Body Contact
bool hasInterfaces(const Teuchos::ParameterList& section);

} // namespace Rhegma::body_contact
