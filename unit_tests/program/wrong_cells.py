"""Scenes with wrong mass matrices and wrong refined cells."""

from scenes import ball, plate
from wrong_heat import warm
from wrong_rows import NOTCH, one


def accurate(scene, accuracy="1 %"):
    """The scene with cells that Domain > Accuracy is to choose."""
    return scene.remove("Domain > Cell Size").set("Domain > Accuracy", accuracy)


def torch(**changes):
    """The plate with a source of heat in place of its crack."""
    source = {"Type": "Ball", "Centre": [0.5, 0.5], "Radius": 0.1, "Power": 1.0, **changes}
    return accurate(warm(Sources={"Torch": source}).remove("Cracks").remove("Energy Release"))


ACCURACY = [
    ("accuracy_that_was_not_measured", accurate(plate(), "5 %"), one("Domain > Accuracy", "5 %", "0.3 %")),
    ("accuracy_without_a_crack", accurate(plate().remove("Cracks").remove("Energy Release")),
     one("Domain > Accuracy", "neither", "Cell Size")),
    ("accuracy_of_running_cracks", accurate(plate().set("Propagation", {"Toughness": "100"})),
     one("Domain > Accuracy", "run", "3 %")),
    ("accuracy_of_a_crack_outside_of_the_body", accurate(plate().set(NOTCH, [0.0, 1.1, 0.5, 1.1])),
     one(NOTCH, "outside of all bodies", "inside")),
    ("accuracy_of_a_crack_of_no_length", accurate(plate().set(NOTCH, [0.5, 0.5, 0.5, 0.5])),
     one(NOTCH, "no length", "remove")),
    ("accuracy_of_a_crack_with_a_point_twice", accurate(plate().set(NOTCH, [0.0, 0.5, 0.3, 0.5, 0.3, 0.5, 0.5, 0.5])),
     one(NOTCH, "no length", "remove")),
    ("accuracy_of_a_tiny_crack", accurate(plate().set(NOTCH, [0.5, 0.5, 0.5 + 1e-6, 0.5])),
     one("Domain > Accuracy", "Cracks > Notch", "5e-07 m", "too many for this domain")),
    ("accuracy_of_a_tiny_crack_at_the_edge", accurate(plate().set(NOTCH, [0.0, 0.5, 1e-6, 0.5])),
     one("Domain > Accuracy", "Cracks > Notch", "too many for this domain")),
    ("accuracy_of_a_crack_that_parts_the_body",
     accurate(plate().set(NOTCH, [-0.1, 0.5, 1.1, 0.5]).remove("Energy Release")),
     one("Domain > Accuracy", "front in material", "neither")),
    ("accuracy_of_cells_too_large_far_from_fronts",
     plate().set("Domain > Accuracy", "0.3 %").set(NOTCH, [0.5, 0.5, 0.501, 0.5]).remove("Energy Release"),
     one("Domain > Accuracy", "everywhere", "smaller Cell Size")),
    ("accuracy_of_a_disk_outside_of_the_body",
     accurate(ball().set("Cracks", {"Penny": {"Centre": [0.1, 0.1, 0.1], "Normal": [0.0, 0.0, 1.0], "Radius": 0.01}})),
     one("Cracks > Penny", "outside of all bodies")),
    ("accuracy_of_a_disk_without_a_normal",
     accurate(ball().set("Cracks", {"Penny": {"Centre": [0.0, 0.0, 0.0], "Normal": [0.0, 0.0, 0.0], "Radius": 0.01}})),
     one("Cracks > Penny", "Normal has no length")),
    ("accuracy_of_a_source_that_meets_nothing", torch(Centre=[1.15, 1.15], Radius=0.02),
     one("Thermal > Sources > Torch > Centre", "meets no body", "Cell Size")),
    ("accuracy_of_a_source_that_flies_away", torch(Centre=[1.15, 0.5], Radius=0.02, Velocity=[10.0, 0.0]),
     one("Thermal > Sources > Torch > Centre", "meets no body")),
    ("accuracy_of_a_tiny_source", torch(Radius=1e-7),
     one("Domain > Accuracy", "Thermal > Sources > Torch", "a radius of 1e-07 m")),
    ("accuracy_of_an_even_source",
     accurate(warm(Sources={"Oven": {"Type": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [1.0, 1.0],
                                     "Power Density": 1.0}}).remove("Cracks").remove("Energy Release")),
     one("Domain > Accuracy", "round heat sources", "neither")),
]

MASS = [
    ("mass_matrix_of_a_negative_radius", plate().set("Mass Matrix", {"Type": "Partial", "Radius": -1.0}),
     one("Mass Matrix > Radius", "above 0")),
    ("mass_matrix_of_order_0", plate().set("Mass Matrix", {"Type": "FMPM", "Order": 0}),
     one("Mass Matrix > Order", "at least 1")),
    ("partial_mass_matrix_without_cracks",
     plate().remove("Cracks").remove("Energy Release").set("Mass Matrix", {"Type": "Partial"}),
     one("Mass Matrix > Type", "no cracks")),
    ("mass_matrix_and_a_series", plate().set("Mass Matrix", {"Type": "Full", "Velocity Update": "XPIC"}),
     one("Mass Matrix > Velocity Update", "FLIP or PIC")),
    ("mass_matrix_of_no_type", plate().set("Mass Matrix", {}), one("Mass Matrix > Type", "missing", "Full")),
]

BOX = {"Lower Corner": [0.0, 0.0], "Upper Corner": [0.02, 0.02], "Level": 1}

ADAPTIVITY = [
    ("adaptivity_without_a_criterion", plate().set("Adaptivity", {"Front Cells": 0.0}),
     one("Adaptivity", "no refinement criterion", "Velocity Change")),
    ("adaptivity_that_starts_before_the_run", plate().set("Adaptivity", {"Start Time": -1.0}),
     one("Adaptivity > Start Time", "0")),
    ("levels_that_come_backwards", plate().set("Adaptivity", {"Level Time": -1.0}),
     one("Adaptivity > Level Time", "0")),
    ("adaptivity_of_more_cells_than_have_numbers", plate().remove("Cracks").remove("Energy Release")
     .set("Domain > Upper Corner", [2000.0, 1.2]).set("Adaptivity", {"Velocity Change": 1.0, "Maximum Level": 6}),
     one("Adaptivity > Maximum Level", "along an axis")),
    ("adaptivity_of_level_0", plate().set("Adaptivity", {"Maximum Level": 0}),
     one("Adaptivity > Maximum Level", "1")),
    ("adaptivity_that_never_coarsens", plate().set("Adaptivity", {"Velocity Change": 1.0, "Coarsening": 1.0}),
     one("Adaptivity > Coarsening", "below 1")),
    ("adaptivity_of_a_negative_threshold", plate().set("Adaptivity", {"Velocity Change": -1.0}),
     one("Adaptivity > Velocity Change", "above 0")),
    ("adaptivity_of_no_change", plate().set("Adaptivity", {"Velocity Change": 0.0}),
     one("Adaptivity > Velocity Change", "above 0")),
    ("adaptivity_of_level_7", plate().set("Adaptivity", {"Maximum Level": 7}),
     one("Adaptivity > Maximum Level", "from 1 to 6")),
    ("adaptivity_that_coarsens_at_nothing", plate().set("Adaptivity", {"Velocity Change": 1.0, "Coarsening": 0.0}),
     one("Adaptivity > Coarsening", "above 0")),
    ("adaptivity_at_no_interval", plate().set("Adaptivity", {"Interval": 0}), one("Adaptivity > Interval", "1")),
    ("adaptivity_of_negative_rings", plate().set("Adaptivity", {"Buffer Cells": -1}),
     one("Adaptivity > Buffer Cells", "from 0 to 16")),
    ("adaptivity_of_negative_distance", plate().set("Adaptivity", {"Front Cells": -1.0}),
     one("Adaptivity > Front Cells", "from 0 to 64")),
    ("adaptivity_that_may_lose_all_and_more", plate().set("Adaptivity", {"Merge Loss": 1.5}),
     one("Adaptivity > Merge Loss", "1")),
    ("region_deeper_than_the_cells", plate().set("Adaptivity", {"Maximum Level": 1, "Corner": {**BOX, "Level": 2}}),
     one("Adaptivity > Corner > Level", "Maximum Level")),
    ("region_without_a_size", plate().set("Adaptivity", {"Corner": {**BOX, "Upper Corner": [0.0, 0.02]}}),
     one("Adaptivity > Corner > Upper Corner", "must exceed Lower Corner along x")),
    ("region_outside_of_the_domain",
     plate().set("Adaptivity", {"Corner": {**BOX, "Lower Corner": [5.0, 5.0], "Upper Corner": [6.0, 6.0]}}),
     one("Adaptivity > Corner", "outside of the domain")),
    ("sub_cycling_and_a_mass_matrix",
     plate().set("Adaptivity", {}).set("Sub-Cycling", {}).set("Mass Matrix", {"Type": "Full"}),
     one("Sub-Cycling", "Mass Matrix", "Lumped or Partial")),
    ("sub_cycling_and_a_matrix_that_may_be_singular",
     plate().set("Adaptivity", {}).set("Sub-Cycling", {}).set("Mass Matrix", {"Type": "Partial", "Lumped Fraction": 0.01}),
     one("Mass Matrix > Lumped Fraction", "at least 0.05")),
    ("parameter_by_its_former_name", plate().set("Mass Matrix", {"Type": "Full", "Lumped Share": 0.1}),
     one("Mass Matrix > Lumped Share", "now named", "Lumped Fraction")),
    ("sub_cycling_of_cells_of_one_size", plate().set("Sub-Cycling", {}),
     one("Sub-Cycling", "one size", "Adaptivity")),
    ("sub_cycling_of_usl",
     plate().set("Adaptivity", {}).set("Sub-Cycling", {}).set("Time > Update Scheme", "USL"),
     one("Sub-Cycling", "Update Scheme", "MUSL")),
    ("sub_cycling_of_no_level", plate().set("Adaptivity", {}).set("Sub-Cycling", {"Levels": 0}),
     one("Sub-Cycling > Levels", "from 1 to 6")),
    ("projected_velocities_of_corrected_broken_cells",
     plate().set("Mass Matrix", {"Type": "Lumped", "Velocity Update": "PIC"}).set("Cracks > Formulation", "Corrected Broken Cell"),
     one("Cracks > Formulation", "negative", "Velocity Update = FLIP")),
    ("adaptivity_of_corrected_broken_cells",
     plate().set("Adaptivity", {}).set("Cracks > Formulation", "Corrected Broken Cell"),
     one("Adaptivity", "Corrected Broken Cell", "cells of one size")),
    ("adaptivity_of_contact_by_visibility",
     plate().set("Adaptivity", {}).set("Cracks > Formulation", "Broken Cell").set("Contact", {"Law": "Visibility"}),
     one("Adaptivity", "Visibility", "another contact law")),
]
