"""Scenes with wrong cracks, and with what does not go with them, in 2D and 3D."""

from scenes import ball, plate
from wrong_rows import NOTCH, one

CRACKS = [
    ("crack_outside_of_the_body", plate().set(NOTCH, [0.0, 1.1, 0.5, 1.1]).remove("Energy Release"),
     one(NOTCH, "outside of all bodies", "inside")),
    ("crack_of_no_length", plate().set(NOTCH, [0.5, 0.5, 0.5, 0.5]), one(NOTCH, "no length", "remove")),
    ("crack_of_one_point", plate().set(NOTCH, [0.5, 0.5]), one(NOTCH, "at least 2 points")),
    ("crack_of_half_a_point", plate().set(NOTCH, [0.0, 0.5, 0.5]),
     one(NOTCH, "3 numbers", "2 numbers for each point")),
    ("crack_with_a_point_twice", plate().set(NOTCH, [0.0, 0.5, 0.3, 0.5, 0.3, 0.5, 0.5, 0.5]), one(NOTCH, "same")),
    ("crack_that_turns_back", plate().set(NOTCH, [0.0, 0.5, 0.5, 0.5, 0.2, 0.5]), one(NOTCH, "turns back")),
    ("crack_that_crosses_itself", plate().set(NOTCH, [0.2, 0.2, 0.8, 0.8, 0.8, 0.2, 0.2, 0.8]),
     one(NOTCH, "crosses itself")),
    ("cracks_that_cross", plate().set("Cracks > Other", {"Points": [0.3, 0.3, 0.3, 0.7]}),
     one("Cracks > Notch", "crosses Cracks > Other", "not at the start")),
    ("absurdly_long_crack", plate().set(NOTCH, [0.0, 0.5, 1e308, 0.5]), one(NOTCH, "cells long", "metres")),
    ("contour_outside_of_the_body", plate().set("Energy Release > Outer Radius", 0.7),
     one("Energy Release > Outer Radius", "domain integral", "leaves the body", "at most")),
    ("contour_of_no_width", plate().set("Energy Release > Outer Radius", 0.16),
     one("Energy Release > Outer Radius", "one cell", "at least 0.2")),
    ("energy_release_of_nothing",
     plate().set("Energy Release > Contour Integral", False).set("Energy Release > Crack Closure", False),
     one("Energy Release > Contour Integral", "crack closure is not available", "true")),
    ("no_such_closure_recovery", plate().set("Energy Release > Closure Recovery", "Consistant"),
     one("Energy Release > Closure Recovery", "Consistant", '"Consistent"')),
    ("energy_release_without_a_crack", plate().remove("Cracks"), one("Energy Release", "no crack", "Cracks")),
    ("energy_release_without_a_front", plate().set(NOTCH, [0.0, 0.5, 1.0, 0.5]),
     one("Energy Release", "front", "Fronts")),
    ("front_at_a_surface", plate().set("Cracks > Notch > Fronts", "First"),
     one(NOTCH, "no material ahead", "write Last", "leave Fronts out")),
    ("one_of_two_fronts_at_a_surface", plate().set("Cracks > Notch > Fronts", "Both"), one(NOTCH, "no material ahead", "write Last")),
    ("contact_without_a_crack", plate().remove("Cracks").remove("Energy Release").set("Contact", {}),
     one("Contact", "there are no cracks", "Cracks")),
    ("pressure_in_an_unknown_crack", plate().set("Face Pressure", {"Noch": {"Pressure": "1e5"}}),
     one("Face Pressure > Noch", "no crack", "Notch")),
    ("pressure_that_ends_as_no_number",
     plate().set("Face Pressure", {"Notch": {"Pressure": "1e5*sqrt(5e-4-t)"}}),
     one("Face Pressure > Notch > Pressure", "not finite at t = 0.000505 s", "Final Time")),
    ("arrest_above_initiation",
     plate().set("Propagation", {"Toughness": "100", "Initiation Toughness": 100.0, "Arrest Toughness": 120.0}),
     one("Propagation > Arrest Toughness", "120 J/m2", "100 J/m2", "at most")),
    ("friction_without_coulomb", plate().set("Contact", {"Friction Coefficient": 0.3}),
     one("Contact > Friction Coefficient", "Frictionless", "Coulomb")),
    ("visibility_with_two_fields", plate().set("Contact", {"Law": "Visibility"}),
     one("Contact > Law", "Broken Cell")),
]

PENNY = {"Penny": {"Points": [-0.02, -0.02, 0.003, 0.02, -0.02, 0.003, 0.02, 0.02, 0.003, -0.02, 0.02, 0.003]}}
THROUGH = {"Cut": {"Points": [-0.1, -0.1, 0.003, 0.1, -0.1, 0.003, 0.1, 0.1, 0.003, -0.1, 0.1, 0.003]}}

NOT_IN_3D = [
    ("crack_closure_in_3d", ball().set("Cracks", PENNY).set("Energy Release", {"Crack Closure": True}),
     one("Energy Release > Crack Closure", "2D", "leave it out")),
    ("tube_outside_of_the_body", ball().set("Cracks", PENNY).set("Energy Release", {"Outer Radius": 0.06}),
     one("Energy Release > Outer Radius", "tube", "crack Penny, front 0", "at most")),
    ("tube_of_no_width",
     ball().set("Cracks", PENNY).set("Energy Release", {"Inner Radius": 0.02, "Outer Radius": 0.03}),
     one("Energy Release > Outer Radius", "one cell", "at least 0.04")),
    ("energy_release_without_a_front_in_3d", ball().set("Cracks", THROUGH).set("Energy Release", {}),
     one("Energy Release", "front", "Front Edges")),
    ("crack_of_two_points_in_3d", ball().set("Cracks", {"Penny": {"Points": [0.0, 0.0, 0.0, 0.05, 0.0, 0.0]}}),
     one("Cracks > Penny > Points", "polygon", "at least three points")),
    ("crack_without_a_shape", ball().set("Cracks", {"Penny": {}}),
     one("Cracks > Penny > Points", "missing", "Radius", "Surface File")),
    ("crack_of_two_shapes",
     ball().set("Cracks", {"Penny": {"Surface File": "a.stl", "Points": [0.0, 0.0, 0.0, 0.05, 0.0, 0.0, 0.0, 0.05, 0.0]}}),
     one("Cracks > Penny", "more than one shape")),
    ("disk_without_a_normal", ball().set("Cracks", {"Penny": {"Centre": [0.0, 0.0, 0.0], "Radius": 0.03}}),
     one("Cracks > Penny > Normal", "missing")),
    ("disk_with_a_normal_of_no_length",
     ball().set("Cracks", {"Penny": {"Centre": [0.0, 0.0, 0.0], "Radius": 0.03, "Normal": [0.0, 0.0, 0.0]}}),
     one("Cracks > Penny > Normal", "no length")),
    ("disk_in_2d", plate().set("Cracks > Notch", {"Centre": [0.5, 0.5, 0.0], "Radius": 0.1, "Normal": [0.0, 0.0, 1.0]}),
     [("Cracks > Notch > Centre", ["3D"]), ("Cracks > Notch > Normal", ["3D"]), ("Cracks > Notch > Radius", ["3D"])]),
    ("surface_that_is_not_there", ball().set("Cracks", {"Penny": {"Surface File": "no_such.stl"}}),
     one("Cracks > Penny > Surface File", "no_such.stl", "no such file")),
    ("surface_of_another_kind", ball().set("Cracks", {"Penny": {"Surface File": "crack.ply"}}),
     one("Cracks > Penny > Surface File", ".stl or .obj")),
    ("crack_that_runs_in_3d_with_a_mass_matrix",
     ball().set("Cracks", {"Penny": {"Centre": [0.0, 0.0, 0.0], "Radius": 0.03, "Normal": [0.0, 0.0, 1.0]}}).set(
         "Energy Release", {}).set("Propagation", {"Toughness": "100"}).set("Mass Matrix", {"Type": "Full"}),
     one("Propagation", "in 3D", "only be combined with Mass Matrix")),
    ("contours_of_a_crack_that_runs_in_3d",
     ball().set("Cracks", {"Penny": {"Centre": [0.0, 0.0, 0.0], "Radius": 0.03, "Normal": [0.0, 0.0, 1.0]}}).set(
         "Energy Release", {}).set("Propagation", {
             "Toughness": "100", "Release Contour": [5.0, 10.0], "Direction Contour": [3.0, 6.0]}),
     [("Propagation > Release Contour", ["only a 2D scene"]), ("Propagation > Direction Contour", ["2D"])]),
    ("cylinder_in_2d",
     plate().set("Bodies > Bar", {"Material": "Polymer", "Shape": "Cylinder", "From": [0.0, 0.0, 0.0], "To": [0.0,
     0.0, 1.0], "Radius": 0.1}),
     one("Bodies > Bar > Shape", "Cylinder", "Box, Ball, Polygon, File or Voxels")),
    ("corners_of_two_numbers_in_3d", ball().set("Domain > Upper Corner", [0.1, 0.1]),
     one("Domain > Upper Corner", "2 numbers", "3 numbers")),
    ("traction_on_a_line_in_3d",
     ball().set("Boundaries > Pull", {"Type": "Traction", "Body": "Ball", "From": [0.0, 0.0], "Corner": [0.0, 0.0,
     0.06], "Edge 1": [0.01, 0.0, 0.0],
     "Edge 2": [0.0, 0.01, 0.0], "Pressure": 1.0}), one("Boundaries > Pull > From", "2D", "leave it out")),
]

RUNNING = "Propagation > Toughness"


def running(toughness="100", **more):
    """The plate with a crack that may run."""
    return plate().set("Energy Release", {}).set("Propagation", dict({"Toughness": toughness}, **more))


def at_rest(toughness="100", **more):
    """The same in equilibrium."""
    return running(toughness, **more).set("Time > Analysis", "Quasi-Static")


PROPAGATION = [
    ("growth_in_a_static_analysis", running().set("Time > Analysis", "Static"),
     one("Propagation", "quasi-static", "Quasi-Static")),
    ("short_increments_in_motion", running(**{"Increment": 0.25}),
     one("Propagation > Increment", "equilibrium only", "at least 0.5")),
    ("loads_in_time_of_a_dynamic_crack", running(**{"Load Control": "Functions of Time"}),
     one("Propagation > Load Control", "quasi-static")),
    ("speed_limit_in_equilibrium", at_rest(**{"Speed Limit": 100.0}), one("Propagation > Speed Limit", "no speed")),
    ("arrest_in_equilibrium", at_rest(**{"Arrest Toughness": 90.0}),
     one("Propagation > Arrest Toughness", "not arrested")),
    ("start_time_of_a_load_factor", at_rest(**{"Start Time": 1e-5}), one("Propagation > Start Time", "no physical time")),
    ("load_factor_of_a_plastic_body",
     at_rest().set("Materials > Polymer > Model", "J2 Plastic").set("Materials > Polymer > Yield Stress", 1e8),
     one("Propagation > Load Control", "relaxed strain", "Functions of Time")),
    ("load_factor_of_a_body_that_relaxes",
     at_rest().set("Materials > Polymer > Model", "Viscoelastic").set("Materials > Polymer > Shear Fractions", [0.5])
     .set("Materials > Polymer > Relaxation Times", [1.0]),
     one("Propagation > Load Control", "relaxed strain", "Functions of Time")),
    ("load_factor_of_a_metal_that_flows",
     at_rest().set("Materials > Polymer > Model", "High-Rate Solid").set("Materials > Polymer > Johnson-Cook A", 1e8),
     one("Propagation > Load Control", "relaxed strain", "Functions of Time")),
    ("cells_that_a_crack_at_rest_grows_out_of", at_rest().set("Adaptivity", {"Maximum Level": 1}),
     one("Propagation", "Front Cells = 0")),
    ("toughness_of_zero", running("0"), one(RUNNING, "is 0 J/m2 at v = 0", "positive")),
    ("toughness_below_zero", running("-3"), one(RUNNING, "is -3 J/m2", "positive")),
    ("toughness_that_falls_to_zero", running("0:100, 500:0"), one(RUNNING, "is 0 J/m2 at v = 50", "positive")),
    ("toughness_of_an_unknown_name", running("100*(1 + speed)"), one(RUNNING, '"speed"', "expression of the speed v")),
    ("toughness_of_temperature", running("100*(1 - T/900)"), one(RUNNING, "temperature T", "without T")),
    ("toughness_that_is_no_expression", running("100*("), one(RUNNING, "not a valid toughness", "a number")),
    ("toughness_that_is_missing", running().remove(RUNNING), one(RUNNING, "missing")),
    ("table_of_toughness_that_goes_back", running("0:100, 300:120, 200:130"), one(RUNNING, "must increase")),
    ("cracks_that_run_nowhere", running().remove("Cracks").remove("Energy Release"),
     [("Propagation", ["no cracks", "Cracks"]), ("Propagation", ["Energy Release"])]),
    ("cracks_that_run_without_a_measure", running().remove("Energy Release"),
     one("Propagation", "needs the section Energy Release", "Energy Release")),
    ("broken_cells_that_run", running().set("Cracks > Formulation", "Broken Cell"),
     one("Propagation", "needs Cracks > Formulation = Dual Field")),
    ("cracks_that_run_without_ties", running().set("Cracks > Front Springs", False),
     one("Propagation", "Front Springs")),
    ("contour_the_wrong_way_round", running(**{"Release Contour": [10.0, 5.0]}),
     one("Propagation > Release Contour", "the inner one first")),
    ("front_that_is_none", running().set(NOTCH, [0.0, 0.5, 1.0, 0.5]), one("Energy Release", "front", "Fronts")),
    ("faces_that_touch_on_cells_that_follow_a_front_in_3d",
     ball().set("Cracks", {"Penny": {"Centre": [0.0, 0.0, 0.0], "Radius": 0.03, "Normal": [0.0, 0.0, 1.0]}}).set(
         "Energy Release", {}).set("Propagation", {"Toughness": "100"}).set("Contact", {}).set("Adaptivity", {"Maximum Level": 1}),
     one("Propagation", "both Contact and Adaptivity")),
    ("running_cracks_with_a_series_for_the_mass", running().set("Mass Matrix", {"Type": "FMPM"}),
     one("Propagation", "FMPM", "Partial or Full")),
]
