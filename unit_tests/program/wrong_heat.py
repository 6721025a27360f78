"""Scenes with wrong heat and wrong combustion."""

from scenes import ball, plate
from wrong_cracks import PENNY
from wrong_rows import MODULUS, one

POLYMER = "Materials > Polymer > "


def warm(**thermal):
    """The plate with heat, and without what this version can not combine with it."""
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
    ("field_that_is_no_function", warm().set("Bodies > Plate > Temperature Field", "300 + * x"),
     one("Bodies > Plate > Temperature Field", "not a function of position")),
    ("two_temperatures_of_a_node", warm().set("Boundaries > Hot", {"Type": "Temperature", "Temperature": 400.0,
     "Lower Corner": [0.0, 0.0], "Upper Corner": [0.1, 0.1]}).set("Boundaries > Cold", {"Type": "Temperature",
     "Temperature": 300.0, "Lower Corner": [0.1, 0.0], "Upper Corner": [0.2, 0.1]}),
     one("Boundaries > Hot", "Boundaries > Cold both prescribe the node", "400 and 300 K", "one temperature")),
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
     one("Boundaries > Pull", "Mechanics = false")),
    ("rigid_with_motion", warm().remove("Energy Release").set("Materials > Stone", {"Model": "Rigid",
     "Density": 1.0, "Specific Heat": 1.0}), one("Materials > Stone > Model", "heat only")),
    ("expansion_and_crack_closure", warm().set(POLYMER + "Thermal Expansion", 7e-5).set(
        "Energy Release > Crack Closure", True), one("Energy Release > Crack Closure", "set it to false")),
    ("front_heat_of_cracks_that_rest", warm(**{"Front Heat Fraction": 1.0, "Front Radius": 1e-3}),
     one("Thermal > Front Heat Fraction", "needs the section Propagation")),
    ("conduction_in_far_too_short_steps", warm().set(POLYMER + "Conductivity", 1e14),
     one("Thermal", "conduction would need", "Conductivity")),
    ("surface_that_falls_below_absolute_zero", warm().set("Boundaries > Cold", {"Type": "Temperature",
     "Temperature": 300.0, "History": "1 - t/1e-9", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.1, 0.1]}),
     one("Boundaries > Cold > History", "absolute")),
    ("faces_that_conduct_of_no_crack", warm(**{"Crack Faces": {"Slit": {"Conduction": "Always"}}}),
     one("Thermal > Crack Faces > Slit", "no crack of this name", "Notch")),
    ("faces_that_conduct_without_cracks", warm(**{"Crack Faces": {"Notch": {"Conduction": "Always"}}}).remove(
        "Cracks").remove("Energy Release"), one("Thermal > Crack Faces", "there are no cracks")),
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
     "Lower Corner": [0.0, 0.0], "Upper Corner": [0.1, 0.1]}), one("Boundaries > Hot", "needs the section Thermal")),
]

BURNING = {"Burn Law": "Vieille", "Burn Coefficient": 1e-8, "Burn Exponent": 0.9, "Gas Constant": 320.0,
           "Flame Temperature": 2500.0, "Initial Gap": 1e-5}


def burning(**changes):
    """A plate with a crack that reaches its surface and burns."""
    values = {**BURNING, **{name.replace("_", " "): value for name, value in changes.items()}}
    return plate().set("Cracks > Notch > Points", [0.0, 0.01, 0.05, 0.01]).set(
        "Combustion", {"Notch": {name: value for name, value in values.items() if value is not None}})

COMBUSTION = [
    ("combustion_without_cracks", plate().remove("Cracks").remove("Energy Release").set("Combustion", {"Notch": BURNING}),
     one("Combustion", "there are no cracks")),
    ("combustion_of_a_crack_that_is_not_there", burning().set("Combustion > Nutch", BURNING),
     one("Combustion > Nutch", "no crack of this name", "Notch")),
    ("combustion_without_room", burning(Initial_Gap=None),
     one("Combustion > Notch", "no gas volume", "Initial Gap")),
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
    ("combustion_lit_next_to_the_body", burning(Ignition_Point=[-0.15, 0.01], Flame_Speed=10.0).set(
        "Cracks > Notch > Points", [-0.18, 0.01, 0.3, 0.01]),
     one("Combustion > Notch > Ignition Point", "from the crack")),
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
     one("Combustion > Notch > Viscosity", "Gas Model = Flow only", "Gas Model")),
    ("combustion_with_a_flow_and_no_gap", burning(Gas_Model="Flow", Initial_Gap=None, Cavity_Volume=1e-6),
     one("Combustion > Notch > Initial Gap", "gap everywhere")),
    ("combustion_with_a_flow_in_3d", ball().set("Cracks", PENNY).set(
        "Combustion", {next(iter(PENNY)): {**BURNING, "Gas Model": "Flow"}}),
     one("Combustion > " + next(iter(PENNY)) + " > Gas Model", "2D only", "Uniform")),
    ("combustion_with_heat_alone", burning().remove("Energy Release").remove("Boundaries").set("Thermal", {
        "Initial Temperature": 300.0, "Mechanics": False}).set("Materials > Polymer > Specific Heat", 1e3).set(
        "Materials > Polymer > Conductivity", 0.2), one("Combustion", "Mechanics = false")),
    ("combustion_without_a_gas", burning(Gas_Constant=None),
     one("Combustion > Notch > Gas Constant", "is missing")),
]
