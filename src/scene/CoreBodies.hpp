#pragma once
/// The section `Bodies`.

#include "scene/Schema.hpp"

namespace Rhegma
{

Section bodies();

} // namespace Rhegma
