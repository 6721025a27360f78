#pragma once
/// The section `Boundaries`.

#include "scene/Schema.hpp"

namespace Rhegma
{

Section boundaries();

} // namespace Rhegma
