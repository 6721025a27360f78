#pragma once
/// Has cells refined in boxes.

#include "../../src/step/Bodies.hpp"

#include <string>

namespace Rhegma
{
namespace Test
{

/// Has cells refined in a box.
template <int D>
void refine(Teuchos::ParameterList& scene, const Vector<D>& lower, const Vector<D>& upper, int level,
            const std::string& name = "Box")
{
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  if (!adaptivity.isParameter("Maximum Level") || adaptivity.get<int>("Maximum Level") < level)
    adaptivity.set("Maximum Level", level);
  Teuchos::ParameterList& box = adaptivity.sublist(name);
  box.set("Lower Corner", array(lower));
  box.set("Upper Corner", array(upper));
  box.set("Level", level);
}

} // namespace Test
} // namespace Rhegma
