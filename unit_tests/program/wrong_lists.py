"""Scenes that are wrong as lists: names, what is missing, types, references; and several mistakes at once."""

from scenes import plate
from wrong_rows import DENSITY, MODULUS, NOTCH, RATIO, box, one, reference

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
    ("number_with_a_unit", plate().raw(MODULUS, "double", "3 GPa"), one(MODULUS, "3 GPa", 'value="3" unit="GPa"')),
    ("broken_number_for_a_whole_one", plate().raw("Domain > Dimension", "double", "2.5"),
     one("Domain > Dimension", "2.5", "whole number")),
    ("words_for_an_array", plate().set("Domain > Lower Corner", "0 0"),
     one("Domain > Lower Corner", "Array(double)")),
    ("array_of_a_wrong_length", plate().set("Domain > Lower Corner", [0.0, 0.0, 0.0]),
     one("Domain > Lower Corner", "3 numbers", "2 numbers")),
    ("unknown_type", plate().raw(MODULUS, "dubble", "3e9"), one(MODULUS, "dubble", '"double"')),
    ("number_for_a_truth_value", plate().set("Output", {"Fields": 3}), one("Output > Fields", "true or false")),
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
            ("Boundaries > Poke", ["misses the body"]),
            (NOTCH, ["outside of all bodies"]),
            ("Cracks > Other > Points", ["no length"]),
        ],
    ),
    (
        "contours_all_at_once",
        plate().set("Domain > Cell Size", 0.02).set(NOTCH, [0.2, 0.5, 0.8, 0.5]).set("Energy Release > Inner Radius",
        0.06),
        [("Energy Release > Outer Radius", ["crack Notch, front 0"]), ("Energy Release > Outer Radius", ["crack Notch, front 1"])],
    ),
]
