#pragma once
/// What the summary says of surfaces that boundaries choose.

#include <Teuchos_ParameterList.hpp>

#include <nlohmann/json.hpp>

namespace Rhegma
{

/// A list for the summary, with an entry for each boundary that acts on a choice of its body's surface
/// (Surface = Body): its name, its body, the area [m2] and some points of it [m] with their outward normals,
/// all over the surface, for pictures. Empty where there is none. \param scene validated
template <int D>
nlohmann::json surfacesOf(const Teuchos::ParameterList& scene);

} // namespace Rhegma
