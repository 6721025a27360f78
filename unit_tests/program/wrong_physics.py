"""Errors that make a right scene wrong in its physics, each with the places that a message may name.

Each template changes a scene and gives a regular expression of the places that may be named, or None where the scene has
nothing to which it applies. A message counts only if it has the place and the reason, REASONS. Its docstring is the error that it makes, for the table of docs/explanation/verification/warnings.md."""

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
    thickness_in_millimetres, modulus_in_megapascal, density_in_grams, yield_in_megapascal, nearly_incompressible, loads_in_megapascal,
    toughness_in_megajoule, toughness_in_pascal, toughness_in_megapascal,
)
from physics_of_numbers import (
    no_step, endless, heavy_damping, damping_that_never_settles, senseless_number, rare_samples, damping_by_pic,
)
from physics_of_cracks import (
    limit_above_waves, limit_below_a_cell, speeds_in_kilometres, no_pressure, late_pressure,
)
from physics_of_heat import (
    source_of_nothing, source_too_strong, probe_away, reference_in_celsius, table_in_celsius, strained_by_heat,
    conductivity_of_nothing, burns_at_once, impossible_flame,
)
from physics_of_supports import (
    support_across_a_crack, value_along_a_free_axis, grips_that_move_alike, pin_in_the_contour, crack_from_side_to_side,
    bonded_from_afar,
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
             probe_away, reference_in_celsius, table_in_celsius, strained_by_heat, held_at_the_load, nearly_incompressible,
             support_across_a_crack, value_along_a_free_axis, grips_that_move_alike, pin_in_the_contour,
             crack_from_side_to_side, bonded_from_afar, conductivity_of_nothing, burns_at_once, impossible_flame, damping_by_pic,
             loads_in_megapascal]

TOO_STRAINED = "strains the body by about .* (linear law|more than a solid withstands)"

# What must be said of the place, for each template: words of the reason, as a regular expression.
REASONS = {
    support_away: "contains no node of any body|no particle is in the box|can (move|turn)",
    mirror_away: "contains no node of any body|touches the domain's edge|can (move|turn)",
    load_away: "the load misses the body",
    no_load: "is zero, so this boundary does nothing",
    late_load: "so this boundary does next to nothing; times are in seconds",
    thin_body: "the body is .* thin, .* cells",
    thin_hole: "the hole is .* thin, .* cells",
    hole_beside: "it cuts nothing",
    all_in_millimetres: "are lengths in metres|domain integral|no load balances it",
    one_body_in_millimetres: "outside of the domain",
    crack_in_millimetres: "outside of all bodies|no crack has a front inside a body|write its points in metres",
    cells_in_millimetres: "more than the domain's",
    modulus_in_megapascal: "wave speed is .*, lower than in almost any solid",
    density_in_grams: "less than of foams|higher than in diamond",
    no_step: "so nothing happens; times are in seconds",
    endless: "the run would take about .* steps",
    short_crack: "below (?:three|one) cells?|outside of all bodies",
    toughness_in_megajoule: "less than (the surface energy of any solid|an atom.s distance|of any stiff solid)",
    toughness_in_pascal: "more than that of any solid of this stiffness",
    heavy_damping: "a body loses its velocity in each step",
    heavy_loads: TOO_STRAINED,
    fast_bodies: TOO_STRAINED,
    touching_twin: "both share one motion there",
    senseless_number: "implausible|must|more than|less than|no solid|lower than|higher than|would|outside",
    hot_source_away: "so it heats nothing",
    held_temperature_away: "contains no node of any body",
    toughness_in_megapascal: "is a K_Ic of .*, less than of any stiff solid|a flaw of .* would run .*, and 1 MPa m.0.5 is 1e6",
    thin_hole_in_a_held_body: "the hole is .* thin, .* cells",
    thickness_in_millimetres: "plane stress assumes a body thinner than it is wide",
    yield_in_megapascal: "so that it yields as a whole",
    nothing_acts: "so all stays at rest",
    gravity_in_millimetres: "times that of the Earth",
    opposite_load_forgotten: "no load balances it.* a mean acceleration of .* m/s2",
    damping_that_never_settles: "of an oscillation is left",
    thin_wall: "less than two cells wide",
    thin_ring: "less than two cells wide",
    cut_apart: "pieces that do not touch",
    crack_below_a_surface: "fewer than two cells of material",
    crack_that_comes_back: "cells can't separate faces closer than three cells",
    mirror_in_material: "that of the mirror image|both prescribe",
    wrong_side: "that of the mirror image.*write Side",
    held_everywhere: "does not strain the body|both prescribe",
    fast_support: "waves in the bodies|strains the body",
    rare_samples: "so the run does not end at rest",
    limit_above_waves: "times the speed of Rayleigh waves",
    limit_below_a_cell: "less than a cell .*no crack grows",
    speeds_in_kilometres: "it rises to .*speeds are in m/s",
    no_pressure: "so this pressure does nothing",
    late_pressure: "so this pressure does next to nothing; times are in seconds",
    source_of_nothing: "so this source does next to nothing",
    source_too_strong: "at which no solid exists",
    probe_away: "no body is closer",
    reference_in_celsius: "colder than liquid nitrogen",
    table_in_celsius: "beyond which its last value is used",
    strained_by_heat: "more than of any solid|by thermal expansion|strains",
    held_at_the_load: "the support takes it|both prescribe|prescribes the motion of all",
    support_across_a_crack: "so that the crack can't open there",
    value_along_a_free_axis: "has no effect, because Components",
    grips_that_move_alike: "so that only its inertia strains it",
    pin_in_the_contour: "prescribes nodes in the domain integral",
    crack_from_side_to_side: "is cut in 2 pieces, .* moves freely",
    bonded_from_afar: "have no node in common",
    conductivity_of_nothing: "less than of any solid",
    burns_at_once: "faster than any solid",
    impossible_flame: "than any flame|below Initial Temperature, so burning would cool",
    damping_by_pic: "of the energy of the longest wave",
    nearly_incompressible: "too few cells make bending too stiff",
    loads_in_megapascal: "stresses are in Pa",
}
