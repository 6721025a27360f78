"""The table of wrong scenes: what is done to a right one, and what a user must be told.

Each row is a name, a scene, and the sentences that are expected: the path of the section and words of the sentence, by
which it says what is wrong and what to write instead.
"""

from scenes import ball, plate

NAN, INF = float("nan"), float("inf")


def box(lower, upper, **more):
    return dict({"Material": "Polymer", "Shape": "Box", "Lower Corner": lower, "Upper Corner": upper}, **more)


def reference(quantity):
    return {"Wanted": {"Quantity": quantity, "Value": 1.0, "Tolerance": 0.1, "Source": "none"}}


def one(where, *words):
    return [(where, words)]


MODULUS = "Materials > Polymer > Young Modulus"
RATIO = "Materials > Polymer > Poisson Ratio"
DENSITY = "Materials > Polymer > Density"
NOTCH = "Cracks > Notch > Points"
HISTORY = "Boundaries > Pull > History"

NAMES = [
    ("misspelt_section", plate().rename("Bodies", "Bodys"), one("Bodys", '"Bodies"')),
    ("misspelt_effect", plate().rename("Energy Release", "Energy Relase"), one("Energy Relase", '"Energy Release"')),
    ("misspelt_parameter", plate().rename(MODULUS, "Youngs Modulus"),
     one(MODULUS[:-13] + "Youngs Modulus", '"Young Modulus"')),
    ("letters_of_the_wrong_case", plate().rename("Time > Final Time", "final time"),
     one("Time > final time", '"Final Time"')),
    ("unknown_parameter", plate().set("Time > Colour", "red"), one("Time > Colour", "Final Time", "CFL")),
    ("parameter_of_another_law", plate().set("Materials > Polymer > C10", 1e6),
     one("Materials > Polymer > C10", "Mooney-Rivlin")),
    ("misspelt_choice", plate().set("Domain > Shape Functions", "GIMPS"),
     one("Domain > Shape Functions", "GIMPS", '"GIMP"')),
    ("unknown_law", plate().set("Materials > Polymer > Model", "Elastic"),
     one("Materials > Polymer > Model", "Linear Elastic", "Neo-Hookean")),
    ("unknown_material", plate().set("Bodies > Plate > Material", "Polimer"),
     one("Bodies > Plate > Material", '"Polimer"', '"Polymer"')),
    ("unknown_body", plate().set("Boundaries > Pull > Body", "Plat"), one("Boundaries > Pull > Body", '"Plate"')),
    ("two_cracks_of_one_name", plate().again("Cracks > Notch"), one("Cracks > Notch", "twice")),
    ("two_bodies_of_one_name", plate().again("Bodies > Plate"), one("Bodies > Plate", "twice")),
    ("parameter_given_twice", plate().again("Time > Final Time"), one("Time > Final Time", "twice")),
    ("section_as_parameter", plate().set("Damping", 3.0), one("Damping", "section", "ParameterList")),
    ("parameter_as_section", plate().set("Time > CFL", {}), one("Time > CFL", "parameter", "<Parameter")),
    ("parameter_outside_of_sections", plate().set("Dimension", 2), one("Dimension", "only sections")),
]

MISSING = [
    ("without_materials", plate().remove("Materials"), one("Materials", "missing", "ParameterList")),
    ("materials_that_are_empty", plate().set("Materials", {}), one("Materials", "empty", "material")),
    ("without_bodies", plate().remove("Bodies"), one("Bodies", "missing")),
    ("without_a_law", plate().remove("Materials > Polymer > Model"),
     one("Materials > Polymer > Model", "missing", "J2 Plastic")),
    ("without_density", plate().remove(DENSITY), one(DENSITY, "missing", "kg/m3")),
    ("without_final_time", plate().remove("Time > Final Time"), one("Time > Final Time", "missing", "[s]")),
    ("cracks_that_are_empty", plate().set("Cracks", {}), one("Cracks", "no crack")),
    ("coulomb_without_friction", plate().set("Contact", {"Law": "Coulomb"}),
     one("Contact > Friction Coefficient", "0.3")),
]

TYPES = [
    ("text_for_a_number", plate().set(MODULUS, "stiff"), one(MODULUS, '"stiff"', 'type="double"')),
    ("number_with_a_unit", plate().raw(MODULUS, "double", "3 GPa"), one(MODULUS, "3 GPa", "without a unit")),
    ("broken_number_for_a_whole_one", plate().raw("Domain > Dimension", "double", "2.5"),
     one("Domain > Dimension", "2.5", "whole number")),
    ("words_for_an_array", plate().set("Domain > Lower Corner", "0 0"),
     one("Domain > Lower Corner", "Array(double)")),
    ("array_of_a_wrong_length", plate().set("Domain > Lower Corner", [0.0, 0.0, 0.0]),
     one("Domain > Lower Corner", "3 numbers", "2 numbers")),
    ("unknown_type", plate().raw(MODULUS, "dubble", "3e9"), one(MODULUS, "dubble", '"double"')),
    ("number_for_a_truth_value", plate().set("Output", {"Fields": 3}), one("Output > Fields", "true or false")),
]

MATERIALS = [
    ("negative_modulus", plate().set(MODULUS, -3e9), one(MODULUS, "-3000000000", "above 0")),
    ("zero_modulus", plate().set(MODULUS, 0.0), one(MODULUS, "above 0", "Pa")),
    ("modulus_that_is_no_number", plate().set(MODULUS, NAN), one(MODULUS, "not finite")),
    ("infinite_modulus", plate().set(MODULUS, INF), one(MODULUS, "not finite")),
    ("absurd_modulus", plate().set(MODULUS, 1e308), one("Time > Final Time", "steps", "SI")),
    ("incompressible", plate().set(RATIO, 0.5), one(RATIO, "0.5", "below 0.5")),
    ("poisson_ratio_below_minus_one", plate().set(RATIO, -1.2), one(RATIO, "above -1")),
    ("density_zero", plate().set(DENSITY, 0.0), one(DENSITY, "above 0")),
    ("density_next_to_nothing", plate().set(DENSITY, 1e-300), one("Materials", "speed", "SI")),
    ("negative_bulk_modulus",
     plate().set("Materials > Polymer", {"Model": "Mooney-Rivlin", "Density": 1.0, "C10": 1.0, "C01": 0.0,
     "Bulk Modulus": -1.0}),
     one("Materials > Polymer > Bulk Modulus", "above 0")),
    ("saturation_below_yield",
     plate().set("Materials > Polymer", {"Model": "J2 Plastic", "Density": 1.0, "Young Modulus": 1e9,
     "Poisson Ratio": 0.3, "Yield Stress": 1e6,
     "Saturation Stress": 1e5, "Saturation Rate": 3.0}),
     one("Materials > Polymer > Saturation Stress", "yield stress")),
]

BODIES = [
    ("body_that_catches_no_particle",
     plate().set("Bodies > Crumb", {"Material": "Polymer", "Shape": "Polygon", "Points": [1.1, 1.1, 1.11, 1.118, 1.12,
     1.1, 1.11, 1.12]}),
     one("Bodies > Crumb", "no particle", "larger")),
    ("body_cut_away",
     plate().set("Bodies > Plate > Operations", {"All": {"Operation": "Cut", "Shape": "Box", "Lower Corner": [-0.1,
     -0.1], "Upper Corner": [1.1, 1.1]}}),
     one("Bodies > Plate", "no particle")),
    ("body_outside_of_the_domain", plate().set("Bodies > Plate > Upper Corner", [2.0, 1.0]),
     one("Bodies > Plate", "outside of the domain", "2 m")),
    ("bodies_that_overlap", plate().set("Bodies > Inset", box([0.9, 0.9], [1.1, 1.1])),
     one("Bodies > Inset", "overlaps Bodies > Plate", "Operations")),
    ("body_inside_of_another", plate().set("Bodies > Inset", box([0.4, 0.1], [0.6, 0.2])),
     one("Bodies > Inset", "overlaps Bodies > Plate")),
    ("corners_of_a_body_exchanged", plate().set("Bodies > Plate > Lower Corner", [1.1, 0.0]),
     one("Bodies > Plate > Upper Corner", "Lower Corner")),
    ("radius_zero",
     plate().set("Bodies > Ball", {"Material": "Polymer", "Shape": "Ball", "Centre": [1.1, 1.1], "Radius": 0.0}),
     one("Bodies > Ball > Radius", "above 0")),
    ("polygon_that_crosses_itself",
     plate().set("Bodies > Bow", {"Material": "Polymer", "Shape": "Polygon", "Points": [1.02, 1.02, 1.2, 1.2, 1.2,
     1.02, 1.02, 1.15]}),
     one("Bodies > Bow > Points", "meets")),
    ("absurdly_fast_body", plate().set("Bodies > Plate > Velocity", [1e308, 0.0]),
     one("Materials", "velocity of bodies")),
]

DOMAIN = [
    ("dimension_4", plate().set("Domain > Dimension", 4), one("Domain > Dimension", "4", "from 2 to 3")),
    ("cells_larger_than_the_domain", plate().set("Domain > Cell Size", 5.0),
     one("Domain > Cell Size", "5 m", "1.4 m")),
    ("cell_size_zero", plate().set("Domain > Cell Size", 0.0), one("Domain > Cell Size", "above 0")),
    ("negative_cell_size", plate().set("Domain > Cell Size", -0.1), one("Domain > Cell Size", "above 0")),
    ("absurd_cell_size", plate().set("Domain > Cell Size", 1e308), one("Domain > Cell Size", "1e+308")),
    ("no_cells", plate().remove("Domain > Cell Size"), one("Domain > Cell Size", "missing", "Accuracy")),
    ("accuracy_that_was_not_measured", plate().remove("Domain > Cell Size").set("Domain > Accuracy", "5 %"),
     one("Domain > Accuracy", "5 %", "0.3 %")),
    ("accuracy_without_a_crack",
     plate().remove("Domain > Cell Size").remove("Cracks").remove("Energy Release").set("Domain > Accuracy", "1 %"),
     one("Domain > Accuracy", "neither", "Cell Size")),
    ("accuracy_of_running_cracks",
     plate().remove("Domain > Cell Size").set("Domain > Accuracy", "1 %").set("Propagation", {"Toughness": "100"}),
     one("Domain > Accuracy", "run", "3 %")),
    ("corners_of_the_domain_exchanged", plate().set("Domain > Lower Corner", [-0.2, 2.0]),
     one("Domain > Upper Corner", "y", "Lower Corner")),
    ("absurdly_large_domain", plate().set("Domain > Upper Corner", [1e308, 1e308]),
     one("Domain > Cell Size", "nodes", "larger cells")),
    ("far_too_many_cells", plate().set("Domain > Cell Size", 1e-6),
     one("Domain > Cell Size", "nodes", "larger cells")),
    ("far_too_many_particles", ball().set("Domain > Cell Size", 0.00035).set("Bodies > Ball > Particles Per Cell", 8),
     one("Domain > Cell Size", "particles", "GB", "larger cells")),
    ("plane_stress_in_3d", ball().set("Domain > Plane", "Stress"), one("Domain > Plane", "2D", "leave it out")),
    ("thickness_in_3d", ball().set("Domain > Thickness", 0.1), one("Domain > Thickness", "2D", "leave it out")),
]

TIME = [
    ("final_time_zero", plate().set("Time > Final Time", 0.0), one("Time > Final Time", "above 0")),
    ("negative_final_time", plate().set("Time > Final Time", -1.0), one("Time > Final Time", "above 0")),
    ("final_time_that_is_no_number", plate().set("Time > Final Time", NAN), one("Time > Final Time", "not finite")),
    ("absurd_final_time", plate().set("Time > Final Time", 1e300), one("Time > Final Time", "steps", "shorter")),
    ("cfl_zero", plate().set("Time > CFL", 0.0), one("Time > CFL", "above 0")),
    ("cfl_above_one", plate().set("Time > CFL", 1.5), one("Time > CFL", "at most 1")),
    ("no_step_at_all", plate().set("Time > Maximum Steps", 0), one("Time > Maximum Steps", "at least 1")),
    ("retries_below_zero", plate().set("Time > Retries", -1), one("Time > Retries", "at least 0")),
    ("pic_fraction_above_one", plate().set("Time > PIC Fraction", 1.1), one("Time > PIC Fraction", "from 0 to 1")),
    ("history_without_end", plate().set("Output", {"History Interval": 1e-300}),
     one("Output > History Interval", "at least")),
    ("checkpoints_without_end", plate().set("Output", {"Checkpoint Interval": 1e-300}),
     one("Output > Checkpoint Interval", "at least")),
    ("checkpoints_at_once", plate().set("Output", {"Checkpoint Interval": 0.0}),
     one("Output > Checkpoint Interval", "above 0")),
    ("checkpoints_before_the_start", plate().set("Output", {"Checkpoint Minutes": -1.0}),
     one("Output > Checkpoint Minutes", "at least 0", "min")),
    ("fields_without_end", plate().set("Output", {"Field Interval": 1e-300}),
     one("Output > Field Interval", "at least")),
]

LOADS = [
    ("traction_inside_of_a_body",
     plate().set("Boundaries > Pull > From", [0.5, 0.1]).set("Boundaries > Pull > To", [0.5, 0.9]),
     one("Boundaries > Pull", "inside of Bodies > Plate", "edge")),
    ("load_that_catches_nothing",
     plate().set("Boundaries > Pull > From", [1.15, 0.0]).set("Boundaries > Pull > To", [1.15, 1.0]),
     one("Boundaries > Pull", "no particle", "surface")),
    ("load_that_half_misses", plate().set("Boundaries > Pull > To", [1.0, 1.2]),
     one("Boundaries > Pull", "miss the body", "surface")),
    ("load_of_no_length", plate().set("Boundaries > Pull > To", [1.0, 0.0]),
     one("Boundaries > Pull > To", "same point")),
    ("absurdly_long_load", plate().set("Boundaries > Pull > To", [1.0, 1e300]),
     one("Boundaries > Pull", "points", "metres")),
    ("point_load_in_the_air",
     plate().set("Boundaries > Poke", {"Type": "Point Load", "Body": "Plate", "Point": [1.1, 1.1], "Force": [1.0,
     0.0]}), one("Boundaries > Poke", "no particle")),
    ("stress_and_pressure", plate().set("Boundaries > Pull > Pressure", 1.0),
     one("Boundaries > Pull", "only one of")),
    ("wall_between_nodes",
     plate().set("Boundaries > Wall", {"Type": "Velocity", "Lower Corner": [0.01, 0.01], "Upper Corner": [0.04, 0.04],
     "Value": [0.0, 0.0]}),
     one("Boundaries > Wall", "no node", "cell thick")),
    ("wall_outside_of_the_domain",
     plate().set("Boundaries > Wall", {"Type": "Velocity", "Lower Corner": [3.0, 3.0], "Upper Corner": [4.0, 4.0],
     "Value": [0.0, 0.0]}),
     one("Boundaries > Wall", "no node")),
    ("symmetry_outside_of_the_domain",
     plate().set("Boundaries > Mirror", {"Type": "Symmetry", "Axis": "y", "Position": 7.0}),
     one("Boundaries > Mirror > Position", "from -0.2 to 1.2")),
    ("symmetry_about_z_in_2d", plate().set("Boundaries > Mirror", {"Type": "Symmetry", "Axis": "z", "Position": 0.0}),
     one("Boundaries > Mirror > Axis", "x or y")),
    ("expression_that_does_not_parse", plate().set(HISTORY, "sin(2*t"), one(HISTORY, "sin(2*t", "expression of t")),
    ("expression_of_an_unknown", plate().set(HISTORY, "2*x"), one(HISTORY, "x", "expression of t")),
    ("expression_that_divides_by_zero", plate().set(HISTORY, "1/t"), one(HISTORY, "not finite at t = 0 s")),
    ("table_that_goes_back_in_time", plate().set(HISTORY, "0:0, 2e-4:1, 1e-4:2"), one(HISTORY, "must increase")),
    ("table_that_is_broken", plate().set(HISTORY, "0:0, 1e-4"), one(HISTORY, "pair of a time and a value")),
]

CRACKS = [
    ("crack_outside_of_the_body", plate().set(NOTCH, [0.0, 1.1, 0.5, 1.1]).remove("Energy Release"),
     one(NOTCH, "outside of all bodies", "inside")),
    ("crack_of_no_length", plate().set(NOTCH, [0.5, 0.5, 0.5, 0.5]), one(NOTCH, "no length", "leave")),
    ("crack_of_one_point", plate().set(NOTCH, [0.5, 0.5]), one(NOTCH, "at least 2 points")),
    ("crack_of_half_a_point", plate().set(NOTCH, [0.0, 0.5, 0.5]),
     one(NOTCH, "3 numbers", "2 numbers for each point")),
    ("crack_with_a_point_twice", plate().set(NOTCH, [0.0, 0.5, 0.3, 0.5, 0.3, 0.5, 0.5, 0.5]), one(NOTCH, "same")),
    ("crack_that_turns_back", plate().set(NOTCH, [0.0, 0.5, 0.5, 0.5, 0.2, 0.5]), one(NOTCH, "turns back")),
    ("crack_that_crosses_itself", plate().set(NOTCH, [0.2, 0.2, 0.8, 0.8, 0.8, 0.2, 0.2, 0.8]),
     one(NOTCH, "crosses itself")),
    ("cracks_that_cross", plate().set("Cracks > Other", {"Points": [0.3, 0.3, 0.3, 0.7]}),
     one("Cracks > Notch", "Cracks > Other", "smaller cells")),
    ("absurdly_long_crack", plate().set(NOTCH, [0.0, 0.5, 1e308, 0.5]), one(NOTCH, "cells long", "metres")),
    ("contour_outside_of_the_body", plate().set("Energy Release > Outer Radius", 0.7),
     one("Energy Release > Outer Radius", "leaves the body", "at most")),
    ("contour_of_no_width", plate().set("Energy Release > Outer Radius", 0.16),
     one("Energy Release > Outer Radius", "one cell", "at least 0.2")),
    ("energy_release_of_nothing",
     plate().set("Energy Release > Contour Integral", False).set("Energy Release > Crack Closure", False),
     one("Energy Release > Contour Integral", "nothing is left", "true")),
    ("no_such_closure_recovery", plate().set("Energy Release > Closure Recovery", "Consistant"),
     one("Energy Release > Closure Recovery", "Consistant", '"Consistent"')),
    ("energy_release_without_a_crack", plate().remove("Cracks"), one("Energy Release", "no crack", "Cracks")),
    ("energy_release_without_a_front", plate().set(NOTCH, [0.0, 0.5, 1.0, 0.5]),
     one("Energy Release", "front", "Fronts")),
    ("contact_without_a_crack", plate().remove("Cracks").remove("Energy Release").set("Contact", {}),
     one("Contact", "no crack faces", "Cracks")),
    ("pressure_in_an_unknown_crack", plate().set("Face Pressure", {"Noch": {"Pressure": "1e5"}}),
     one("Face Pressure > Noch", "no crack", "Notch")),
    ("pressure_that_ends_as_no_number",
     plate().set("Face Pressure", {"Notch": {"Pressure": "1e5*sqrt(5e-4-t)"}}),
     one("Face Pressure > Notch > Pressure", "not finite at t = 0.000505 s", "Final Time")),
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
     one("Energy Release > Outer Radius", "tube", "Penny.0", "at most")),
    ("tube_of_no_width",
     ball().set("Cracks", PENNY).set("Energy Release", {"Inner Radius": 0.02, "Outer Radius": 0.03}),
     one("Energy Release > Outer Radius", "one cell", "at least 0.04")),
    ("energy_release_of_a_warm_body_in_3d",
     ball().set("Cracks", PENNY).set("Energy Release", {}).set("Thermal", {"Initial Temperature": 300.0})
     .set("Materials > Rubber > Specific Heat", 1400.0).set("Materials > Rubber > Conductivity", 0.2)
     .set("Materials > Rubber > Thermal Expansion", 1e-4), one("Energy Release", "3D", "temperature")),
    ("energy_release_of_pressed_faces_in_3d",
     ball().set("Cracks", PENNY).set("Energy Release", {}).set("Face Pressure", {"Penny": {"Pressure": "1e5"}}),
     one("Energy Release", "3D", "presses", "Face Pressure")),
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
    ("crack_that_runs_in_3d_with_contact",
     ball().set("Cracks", {"Penny": {"Centre": [0.0, 0.0, 0.0], "Radius": 0.03, "Normal": [0.0, 0.0, 1.0]}}).set(
         "Energy Release", {}).set("Propagation", {"Toughness": "100"}).set("Contact", {}),
     one("Propagation", "in 3D", "Contact")),
    ("contours_of_a_crack_that_runs_in_3d",
     ball().set("Cracks", {"Penny": {"Centre": [0.0, 0.0, 0.0], "Radius": 0.03, "Normal": [0.0, 0.0, 1.0]}}).set(
         "Energy Release", {}).set("Propagation", {
             "Toughness": "100", "Release Contour": [5.0, 10.0], "Direction Contour": [3.0, 6.0]}),
     [("Propagation > Release Contour", ["only a 2D scene"]), ("Propagation > Direction Contour", ["2D"])]),
    ("cylinder_in_2d",
     plate().set("Bodies > Bar", {"Material": "Polymer", "Shape": "Cylinder", "From": [0.0, 0.0, 0.0], "To": [0.0,
     0.0, 1.0], "Radius": 0.1}),
     one("Bodies > Bar > Shape", "Cylinder", "Box, Ball or Polygon")),
    ("corners_of_two_numbers_in_3d", ball().set("Domain > Upper Corner", [0.1, 0.1]),
     one("Domain > Upper Corner", "2 numbers", "3 numbers")),
    ("traction_on_a_line_in_3d",
     ball().set("Boundaries > Pull", {"Type": "Traction", "Body": "Ball", "From": [0.0, 0.0], "Corner": [0.0, 0.0,
     0.06], "Edge 1": [0.01, 0.0, 0.0],
     "Edge 2": [0.0, 0.01, 0.0], "Pressure": 1.0}), one("Boundaries > Pull > From", "2D", "leave it out")),
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

RUNNING = "Propagation > Toughness"


def running(toughness="100", **more):
    """The plate with a crack that may run."""
    return plate().set("Energy Release", {}).set("Propagation", dict({"Toughness": toughness}, **more))


PROPAGATION = [
    ("toughness_of_zero", running("0"), one(RUNNING, "is 0 J/m2 at v = 0", "positive")),
    ("toughness_below_zero", running("-3"), one(RUNNING, "is -3 J/m2", "positive")),
    ("toughness_that_falls_to_zero", running("0:100, 500:0"), one(RUNNING, "is 0 J/m2 at v = 50", "positive")),
    ("toughness_of_an_unknown_name", running("100*(1 + speed)"), one(RUNNING, '"speed"', "expression of the speed v")),
    ("toughness_of_temperature", running("100*(1 - T/900)"), one(RUNNING, "temperature T", "without T")),
    ("toughness_that_is_no_expression", running("100*("), one(RUNNING, "no toughness", "a number")),
    ("toughness_that_is_missing", running().remove(RUNNING), one(RUNNING, "missing")),
    ("table_of_toughness_that_goes_back", running("0:100, 300:120, 200:130"), one(RUNNING, "must increase")),
    ("cracks_that_run_nowhere", running().remove("Cracks").remove("Energy Release"),
     [("Propagation", ["no cracks", "Cracks"]), ("Propagation", ["Energy Release"])]),
    ("cracks_that_run_without_a_measure", running().remove("Energy Release"),
     one("Propagation", "what drives the fronts", "Energy Release")),
    ("broken_cells_that_run", running().set("Cracks > Formulation", "Broken Cell"),
     one("Propagation", "Dual Field alone")),
    ("cracks_that_run_without_ties", running().set("Cracks > Front Ties", False),
     one("Propagation", "Front Ties")),
    ("contour_the_wrong_way_round", running(**{"Release Contour": [10.0, 5.0]}),
     one("Propagation > Release Contour", "the inner one first")),
    ("front_that_is_none", running().set(NOTCH, [0.0, 0.5, 1.0, 0.5]), one("Energy Release", "front", "Fronts")),
    ("running_cracks_with_a_mass_matrix", running().set("Mass Matrix", {"Type": "Full"}),
     one("Propagation", "Mass Matrix", "take one of the two out")),
]

POLYMER = "Materials > Polymer > "


def warm(**thermal):
    """The plate with heat, and without what this version does not have beside it."""
    return (plate().set("Thermal", dict({"Initial Temperature": 300.0}, **thermal))
            .set(POLYMER + "Specific Heat", 1400.0).set(POLYMER + "Conductivity", 0.2))


HEAT = [
    ("heat_without_a_capacity", warm().remove(POLYMER + "Specific Heat"), one(POLYMER + "Specific Heat", "needs it")),
    ("temperature_of_zero", warm().set("Thermal > Initial Temperature", 0.0),
     one("Thermal > Initial Temperature", "above 0")),
    ("body_below_absolute_zero", warm().set("Bodies > Plate > Temperature", -10.0),
     one("Bodies > Plate > Temperature", "above 0")),
    ("field_below_absolute_zero", warm().set("Bodies > Plate > Temperature Field", "x - 10"),
     one("Bodies > Plate > Temperature Field", "absolute")),
    ("table_that_is_not_monotone", warm().set(POLYMER + "Conductivity", "300:0.2, 300:0.3"),
     one(POLYMER + "Conductivity", "must increase")),
    ("table_below_absolute_zero", warm().set(POLYMER + "Conductivity", "-3:0.2, 300:0.3"),
     one(POLYMER + "Conductivity", "absolute")),
    ("table_of_a_wrong_value", warm().set(MODULUS, "300:3e9, 400:-1").remove("Energy Release"),
     one(MODULUS, "above 0")),
    ("table_that_is_none", warm().set(MODULUS, "300:3e9; 400:2e9").remove("Energy Release"), one(MODULUS, "293:3e9")),
    ("table_without_heat", plate().set(MODULUS, "300:3e9, 400:2e9"),
     one("Materials > Polymer", "table of temperature", "Thermal")),
    ("heat_alone_with_a_load", warm(Mechanics=False).remove("Energy Release"),
     one("Boundaries > Pull", "nothing moves")),
    ("rigid_with_motion", warm().remove("Energy Release").set("Materials > Stone", {"Model": "Rigid",
     "Density": 1.0, "Specific Heat": 1.0}), one("Materials > Stone > Model", "heat alone")),
    ("expansion_and_crack_closure", warm().set(POLYMER + "Thermal Expansion", 7e-5).set(
        "Energy Release > Crack Closure", True), one("Energy Release > Crack Closure", "set it to false")),
    ("front_heat_of_cracks_that_rest", warm(**{"Front Heat Fraction": 1.0, "Front Radius": 1e-3}),
     one("Thermal > Front Heat Fraction", "no crack grows")),
    ("conduction_in_far_too_short_steps", warm().set(POLYMER + "Conductivity", 1e14),
     one("Thermal", "conduction would need", "Conductivity")),
    ("surface_that_falls_below_absolute_zero", warm().set("Boundaries > Cold", {"Type": "Temperature",
     "Temperature": 300.0, "History": "1 - t/1e-9", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.1, 0.1]}),
     one("Boundaries > Cold > History", "temperatures are absolute")),
    ("faces_that_conduct_of_no_crack", warm(**{"Crack Faces": {"Slit": {"Conduction": "Always"}}}),
     one("Thermal > Crack Faces > Slit", "no crack of this name", "Notch")),
    ("faces_that_conduct_without_cracks", warm(**{"Crack Faces": {"Notch": {"Conduction": "Always"}}}).remove(
        "Cracks").remove("Energy Release"), one("Thermal > Crack Faces", "no crack faces")),
    ("conductance_of_insulating_faces", warm(**{"Crack Faces": {"Notch": {"Conductance": 5.0}}}),
     one("Thermal > Crack Faces > Notch > Conductance", "insulate")),
    ("conductance_below_zero", warm(**{"Crack Faces": {"Notch": {"Conduction": "Always", "Conductance": -5.0}}}),
     one("Thermal > Crack Faces > Notch > Conductance", "above 0")),
    ("conduction_through_broken_cells", warm(**{"Crack Faces": {"Notch": {"Conduction": "Always"}}}).set(
        "Cracks > Formulation", "Broken Cell").remove("Energy Release"),
     one("Thermal > Crack Faces > Notch > Conduction", "Dual Field")),
    ("stages_with_faces_that_conduct", warm(**{"Conduction": "Super Time Stepping",
     "Crack Faces": {"Notch": {"Conduction": "Always"}}}),
     one("Thermal > Crack Faces > Notch > Conduction", "Implicit or Explicit")),
    ("conduction_by_no_method", warm(Conduction="Crank-Nicolson"), one("Thermal > Conduction", "Implicit")),
    ("steps_shorter_than_explicit_ones", warm(**{"Conduction": "Implicit", "Step Ratio": 0.5}),
     one("Thermal > Step Ratio", "1")),
    ("boundary_of_heat_without_it", plate().set("Boundaries > Hot", {"Type": "Temperature", "Temperature": 400.0,
     "Lower Corner": [0.0, 0.0], "Upper Corner": [0.1, 0.1]}), one("Boundaries > Hot", "boundary of heat")),
]

BOX = {"Lower Corner": [0.0, 0.0], "Upper Corner": [0.02, 0.02], "Level": 1}

ADAPTIVITY = [
    ("adaptivity_without_a_criterion", plate().set("Adaptivity", {"Front Cells": 0.0}),
     one("Adaptivity", "nothing tells where", "Velocity Change")),
    ("adaptivity_that_starts_before_the_run", plate().set("Adaptivity", {"Start Time": -1.0}),
     one("Adaptivity > Start Time", "0")),
    ("levels_that_come_backwards", plate().set("Adaptivity", {"Level Time": -1.0}),
     one("Adaptivity > Level Time", "0")),
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
     one("Adaptivity > Corner > Upper Corner", "not above Lower Corner along x")),
    ("region_outside_of_the_domain",
     plate().set("Adaptivity", {"Corner": {**BOX, "Lower Corner": [5.0, 5.0], "Upper Corner": [6.0, 6.0]}}),
     one("Adaptivity > Corner", "outside of the domain")),
    ("sub_cycling_and_a_mass_matrix",
     plate().set("Adaptivity", {}).set("Sub-Cycling", {}).set("Mass Matrix", {"Type": "Full"}),
     one("Sub-Cycling", "Mass Matrix", "Lumped or Partial")),
    ("sub_cycling_and_a_matrix_that_may_be_singular",
     plate().set("Adaptivity", {}).set("Sub-Cycling", {}).set("Mass Matrix", {"Type": "Partial", "Lumped Share": 0.01}),
     one("Mass Matrix > Lumped Share", "at least 0.05")),
    ("sub_cycling_of_cells_of_one_size", plate().set("Sub-Cycling", {}),
     one("Sub-Cycling", "one size", "Adaptivity")),
    ("sub_cycling_of_usl",
     plate().set("Adaptivity", {}).set("Sub-Cycling", {}).set("Time > Update Scheme", "USL"),
     one("Sub-Cycling", "Update Scheme", "MUSL")),
    ("sub_cycling_of_no_level", plate().set("Adaptivity", {}).set("Sub-Cycling", {"Levels": 0}),
     one("Sub-Cycling > Levels", "from 1 to 6")),
    ("adaptivity_of_corrected_broken_cells",
     plate().set("Adaptivity", {}).set("Cracks > Formulation", "Corrected Broken Cell"),
     one("Adaptivity", "Corrected Broken Cell", "equal cells")),
    ("adaptivity_of_contact_by_visibility",
     plate().set("Adaptivity", {}).set("Cracks > Formulation", "Broken Cell").set("Contact", {"Law": "Visibility"}),
     one("Adaptivity", "Visibility", "another law")),
]

REFERENCES = [
    ("unknown_quantity", plate().set("Reference", reference("energy.kinetik")),
     one("Reference > Wanted > Quantity", "kinetik", '"kinetic"')),
    ("quantity_of_an_unknown_front", plate().set("Reference", reference("cracks.Notch.fronts.3.G_J")),
     one("Reference > Wanted > Quantity", "cracks.Notch.fronts", '"3"', "list of 1")),
    ("quantity_of_an_effect_that_is_absent", plate().set("Reference", reference("temperature.peak")),
     one("Reference > Wanted > Quantity", "temperature")),
    ("quantity_that_is_no_number", plate().set("Reference", reference("energy")),
     one("Reference > Wanted > Quantity", "not a number")),
    ("reference_without_tolerance",
     plate().set("Reference", {"Wanted": {"Quantity": "time", "Value": 1.0, "Tolerance": 0.0, "Source": "none"}}),
     one("Reference > Wanted > Tolerance", "above 0")),
    ("reference_without_source",
     plate().set("Reference", {"Wanted": {"Quantity": "time", "Value": 1.0, "Tolerance": 0.1, "Source": ""}}),
     one("Reference > Wanted > Source", "empty")),
]

SEVERAL = [
    (
        "mistakes_of_the_list_all_at_once",
        plate().set(MODULUS, -1.0).set(RATIO, 0.5).set("Time > Final Time", 0.0).set("Bodies > Plate > Material",
        "Steel").rename("Domain > Cell Size", "Cell Sise").set("Thermal", {}),
        [
            (MODULUS, ["above 0"]),
            (RATIO, ["below 0.5"]),
            ("Time > Final Time", ["above 0"]),
            ("Bodies > Plate > Material", ["Polymer"]),
            ("Domain > Cell Sise", ['"Cell Size"']),
            ("Thermal > Initial Temperature", ["missing"]),
        ],
    ),
    (
        "mistakes_of_the_bodies_all_at_once",
        plate().set("Bodies > Inset", box([0.4, 0.1], [0.6, 0.2])).set("Bodies > Crumb", {"Material": "Polymer",
        "Shape": "Polygon", "Points": [1.1, 1.1, 1.11, 1.118, 1.12, 1.1, 1.11, 1.12]}),
        [("Bodies > Inset", ["overlaps"]), ("Bodies > Crumb", ["no particle"])],
    ),
    (
        "mistakes_of_loads_and_cracks_all_at_once",
        plate()
        .set("Boundaries > Pull > To", [1.0, 1.2])
        .set("Boundaries > Poke", {"Type": "Point Load", "Body": "Plate", "Point": [1.1, 1.1], "Force": [1.0, 0.0]})
        .set(NOTCH, [0.0, 1.1, 0.5, 1.1])
        .set("Cracks > Other", {"Points": [0.2, 0.2, 0.2, 0.2]}),
        [
            ("Boundaries > Pull", ["miss the body"]),
            ("Boundaries > Poke", ["no particle"]),
            (NOTCH, ["outside of all bodies"]),
            ("Cracks > Other > Points", ["no length"]),
        ],
    ),
    (
        "contours_all_at_once",
        plate().set("Domain > Cell Size", 0.02).set(NOTCH, [0.2, 0.5, 0.8, 0.5]).set("Energy Release > Inner Radius",
        0.06),
        [("Energy Release > Outer Radius", ["Notch.0"]), ("Energy Release > Outer Radius", ["Notch.1"])],
    ),
]

TABLE = NAMES + MISSING + TYPES + MATERIALS + BODIES + DOMAIN + TIME + LOADS + CRACKS
BURNING = {"Burn Law": "Vieille", "Burn Coefficient": 1e-8, "Burn Exponent": 0.9, "Gas Constant": 320.0,
           "Flame Temperature": 2500.0, "Initial Gap": 1e-5}


def burning(**changes):
    """A plate with a crack that reaches its surface and burns."""
    values = {**BURNING, **{name.replace("_", " "): value for name, value in changes.items()}}
    return plate().set("Cracks > Notch > Points", [0.0, 0.01, 0.05, 0.01]).set(
        "Combustion", {"Notch": {name: value for name, value in values.items() if value is not None}})


COMBUSTION = [
    ("combustion_without_cracks", plate().remove("Cracks").remove("Energy Release").set("Combustion", {"Notch": BURNING}),
     one("Combustion", "no crack faces")),
    ("combustion_of_a_crack_that_is_not_there", burning().set("Combustion > Nutch", BURNING),
     one("Combustion > Nutch", "no crack of this name", "Notch")),
    ("combustion_without_room", burning(Initial_Gap=None),
     one("Combustion > Notch", "no room for gas", "Initial Gap")),
    ("combustion_with_a_cold_flame", burning(Flame_Temperature=200.0),
     one("Combustion > Notch > Flame Temperature", "below Initial Temperature")),
    ("combustion_with_a_table_that_is_none", burning(Burn_Law="Table", Burn_Coefficient=None, Burn_Exponent=None,
                                                    Burn_Table="1e5 1e-3"),
     one("Combustion > Notch > Burn Table", "pressure:rate")),
    ("combustion_and_a_given_pressure", burning().set("Face Pressure", {"Notch": {"Pressure": "1e5"}}),
     one("Combustion > Notch", "Face Pressure")),
    ("combustion_that_spreads_from_nowhere", burning(Flame_Speed=10.0),
     one("Combustion > Notch", "Ignition Point")),
    ("combustion_from_a_point_without_a_flame", burning(Ignition_Point=[0.02, 0.01]),
     one("Combustion > Notch", "Flame Speed")),
    ("combustion_from_a_point_and_a_box", burning(Ignition_Point=[0.02, 0.01], Flame_Speed=10.0,
                                                  Ignition_Lower_Corner=[0.0, 0.0], Ignition_Upper_Corner=[0.02, 0.02]),
     one("Combustion > Notch", "Ignition Point", "Ignition Lower Corner")),
    ("combustion_far_from_the_crack", burning(Ignition_Point=[0.5, 0.5], Flame_Speed=10.0),
     one("Combustion > Notch > Ignition Point", "from the crack")),
    ("combustion_in_a_box_far_from_the_crack", burning(Ignition_Lower_Corner=[0.5, 0.5], Ignition_Upper_Corner=[0.6, 0.6]),
     one("Combustion > Notch > Ignition Lower Corner", "from the crack")),
    ("combustion_of_a_density_that_nothing_has", burning(Solid_Density=123.0),
     one("Combustion > Notch > Solid Density", "no material", "kg/m3")),
    ("combustion_lit_by_a_temperature_that_is_not_there", burning(Ignition_Temperature=600.0),
     one("Combustion > Notch > Ignition Temperature", "Thermal")),
    ("combustion_that_heats_faces_without_heat", burning(Wall_Heat_Fraction=0.1),
     one("Combustion > Notch > Wall Heat Fraction", "Thermal")),
    ("combustion_with_convection_without_heat", burning(Heat_Transfer_Coefficient=10.0),
     one("Combustion > Notch > Heat Transfer Coefficient", "Thermal")),
    ("combustion_that_vents_at_a_plane_of_symmetry", burning(Venting=True).set(
        "Boundaries > Mirror", {"Type": "Symmetry", "Axis": "x", "Position": 0.0}),
     one("Combustion > Notch > Venting", "plane of symmetry")),
    ("combustion_with_friction_and_no_flow", burning(Viscosity=1e-5),
     one("Combustion > Notch > Viscosity", "does not flow", "Gas Model")),
    ("combustion_with_a_flow_and_no_gap", burning(Gas_Model="Flow", Initial_Gap=None, Cavity_Volume=1e-6),
     one("Combustion > Notch > Initial Gap", "room everywhere")),
    ("combustion_with_a_flow_in_3d", ball().set("Cracks", PENNY).set(
        "Combustion", {next(iter(PENNY)): {**BURNING, "Gas Model": "Flow"}}),
     one("Combustion > " + next(iter(PENNY)) + " > Gas Model", "2D only", "Uniform")),
    ("combustion_with_heat_alone", burning().remove("Energy Release").remove("Boundaries").set("Thermal", {
        "Initial Temperature": 300.0, "Mechanics": False}).set("Materials > Polymer > Specific Heat", 1e3).set(
        "Materials > Polymer > Conductivity", 0.2), one("Combustion", "nothing moves")),
    ("combustion_without_a_gas", burning(Gas_Constant=None),
     one("Combustion > Notch > Gas Constant", "is missing")),
]
TABLE += COMBUSTION + HEAT + NOT_IN_3D + MASS + ADAPTIVITY + PROPAGATION + REFERENCES + SEVERAL
