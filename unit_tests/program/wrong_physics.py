"""Errors that make a right scene wrong in its physics, each with the places that a message may name.

Each template changes a scene and gives a regular expression of the places that may be named, or None where the scene has
nothing to which it applies. Its docstring is the error that it makes, for the table of docs/plausibility.md."""

from physics_of_loads import (
    support_away, mirror_away, load_away, no_load, late_load, heavy_loads, nothing_acts,
    gravity_in_millimetres, opposite_load_forgotten, hot_source_away, held_temperature_away, mirror_in_material, wrong_side,
    held_everywhere, held_at_the_load, fast_support,
)
from physics_of_bodies import (
    thin_body, thin_hole, thin_hole_in_a_held_body, hole_beside, fast_bodies, touching_twin, short_crack,
    thin_wall, thin_ring, cut_apart, crack_below_a_surface, crack_that_comes_back,
)
from physics_of_units import (
    all_in_millimetres, one_body_in_millimetres, crack_in_millimetres, cells_in_millimetres,
    thickness_in_millimetres, modulus_in_megapascal, density_in_grams, yield_in_megapascal, nearly_incompressible,
    toughness_in_megajoule, toughness_in_pascal, toughness_in_megapascal,
)
from physics_of_numbers import (
    no_step, endless, heavy_damping, damping_that_never_settles, senseless_number, rare_samples,
)
from physics_of_cracks import (
    limit_above_waves, limit_below_a_cell, speeds_in_kilometres, no_pressure, late_pressure,
)
from physics_of_heat import (
    source_of_nothing, source_too_strong, probe_away, reference_in_celsius, table_in_celsius, strained_by_heat,
)

# A seed draws by the position in this list.
TEMPLATES = [support_away, mirror_away, load_away, no_load, late_load, thin_body, thin_hole, hole_beside,
             all_in_millimetres, one_body_in_millimetres, crack_in_millimetres, cells_in_millimetres,
             modulus_in_megapascal, density_in_grams, no_step, endless, short_crack, toughness_in_megajoule,
             toughness_in_pascal, heavy_damping, heavy_loads, fast_bodies, touching_twin, senseless_number,
             hot_source_away, held_temperature_away,
             toughness_in_megapascal, thin_hole_in_a_held_body, thickness_in_millimetres, yield_in_megapascal,
             nothing_acts, gravity_in_millimetres, opposite_load_forgotten, damping_that_never_settles,
             thin_wall, thin_ring, cut_apart, crack_below_a_surface, crack_that_comes_back,
             mirror_in_material, wrong_side, held_everywhere, fast_support, rare_samples, limit_above_waves,
             limit_below_a_cell, speeds_in_kilometres, no_pressure, late_pressure, source_of_nothing, source_too_strong,
             probe_away, reference_in_celsius, table_in_celsius, strained_by_heat, held_at_the_load, nearly_incompressible]
