#pragma once
/// The section `Bodies`, and the parameters of shapes.

#include "scene/Schema.hpp"

namespace Rhegma
{

Section bodies();

/// Adds the parameters of a shape, as makeShape reads them (geometry/Shape.hpp).
void describeShape(Section& section);

} // namespace Rhegma
