#pragma once
/// Attributes of the tags of a scene.

#include "scene/XmlReader.hpp"

#include <string>

namespace Rhegma
{

/// What is wrong with the attributes of an opening tag: one that <ParameterList> and <Parameter> do not have,
/// or one that is there twice. Empty: nothing.
std::string mistakeInAttributes(const XmlReader& tag);

} // namespace Rhegma
