#pragma once

#include <plan/BoundaryType.hpp>

/// Boundaries of type Sponge: material in a box is slowed.
Rhegma::BoundaryType sponge();
