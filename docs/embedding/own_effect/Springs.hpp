#pragma once

#include <plan/Effect.hpp>

/// The effect `Springs`: a bed of springs that pulls all material back to where it was at the start.
Rhegma::EffectEntry springs();
