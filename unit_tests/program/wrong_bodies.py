"""Scenes with wrong materials, bodies, domains, times and loads."""

from cracked_solid import CrackedSolid
from scenes import ball, plate
from wrong_rows import DENSITY, HISTORY, INF, MODULUS, NAN, RATIO, box, one

CRACKED = CrackedSolid().parameters()


def cracked(parameter, value):
    """A plate of PBX 9501 with another constant."""
    return plate().set("Materials", {"Polymer": {**CRACKED, parameter: value}})


WATER = {"Model": "Fluid", "Density": 1000.0, "Equation Of State": "Tait", "Bulk Modulus": 2.2e9}


def rubber(moduli, exponents):
    return {"Model": "Ogden", "Density": 930.0, "Moduli": moduli, "Exponents": exponents, "Bulk Modulus": 1e9}


def uncracked(material):
    return plate().remove("Cracks").remove("Energy Release").set("Materials > Polymer", material)


MATERIALS = [
    ("negative_modulus", plate().set(MODULUS, -3e9), one(MODULUS, "-3000000000", "above 0")),
    ("static_analysis_of_a_body_that_relaxes",
     plate().set("Time > Analysis", "Static").set("Materials > Polymer > Model", "Viscoelastic")
     .set("Materials > Polymer > Shear Fractions", [0.5]).set("Materials > Polymer > Relaxation Times", [1.0]),
     one("Materials > Polymer > Model", "no time", "Quasi-Static")),
    ("static_analysis_of_a_body_that_relaxes_and_cracks",
     plate().set("Materials", {"Polymer": CRACKED}).set("Time > Analysis", "Static"),
     one("Materials > Polymer > Model", "no time", "Quasi-Static")),
    ("cracks_larger_than_their_scale", cracked("Initial Crack Radius", 1e-3),
     one("Materials > Polymer > Initial Crack Radius", "< Crack Length Scale = 0.001 m")),
    ("toughness_of_cracks_in_wrong_units", cracked("Crack Toughness", 500.0),
     one("Materials > Polymer > Crack Toughness", "J/m2 must be >= 0.001 J/m2", "kPa m^0.5")),
    ("friction_without_a_limit", cracked("Crack Friction", 1.23), one("Materials > Polymer > Crack Friction", "2 mu^2 < 3 must hold")),
    ("cracks_faster_than_waves", cracked("Maximum Crack Speed", 2000.0),
     one("Materials > Polymer > Maximum Crack Speed", "is 2000 m/s; it must be <", "Rayleigh")),
    ("damage_of_a_law_without_damage", plate().set("Output", {"Damage": True}),
     one("Output > Damage", "no material has a damage", "ViscoSCRAM")),
    ("static_analysis_of_a_rate_of_flow",
     plate().set("Time > Analysis", "Static").set("Materials > Polymer > Model", "High-Rate Solid")
     .set("Materials > Polymer > Johnson-Cook A", 1e8).set("Materials > Polymer > Johnson-Cook C", 0.01),
     one("Materials > Polymer > Johnson-Cook C", "no rate", "Quasi-Static")),
    ("zero_modulus", plate().set(MODULUS, 0.0), one(MODULUS, "above 0", "Pa")),
    ("modulus_that_is_no_number", plate().set(MODULUS, NAN), one(MODULUS, "not finite")),
    ("infinite_modulus", plate().set(MODULUS, INF), one(MODULUS, "not finite")),
    ("absurd_modulus", plate().set(MODULUS, 1e308), one("Time > Final Time", "steps", "SI") + one("Materials > Polymer", "wave speed", "Pa")),
    ("incompressible", plate().set(RATIO, 0.5), one(RATIO, "0.5", "below 0.5")),
    ("poisson_ratio_below_minus_one", plate().set(RATIO, -1.2), one(RATIO, "above -1")),
    ("bonded_to_no_body", plate().set("Bodies > Plate > Bonded To", "Plat"),
     one("Bodies > Plate > Bonded To", 'no body "Plat"', '"Plate"')),
    ("density_zero", plate().set(DENSITY, 0.0), one(DENSITY, "above 0")),
    ("density_next_to_nothing", plate().set(DENSITY, 1e-300), one("Materials", "speed", "SI") + one("Materials > Polymer", "wave speed", "not finite")),
    ("negative_bulk_modulus",
     plate().set("Materials > Polymer", {"Model": "Mooney-Rivlin", "Density": 1.0, "C10": 1.0, "C01": 0.0,
     "Bulk Modulus": -1.0}),
     one("Materials > Polymer > Bulk Modulus", "above 0")),
    ("ogden_term_of_the_wrong_sign", plate().set("Materials > Polymer", rubber([1e6, 1e4], [2.0, -2.0])),
     one("Materials > Polymer > Moduli", "term 2", "mu_p alpha_p > 0 fails", "sign of the exponent")),
    ("ogden_terms_of_two_lengths", plate().set("Materials > Polymer", rubber([1e6], [2.0, -2.0])),
     one("Materials > Polymer > Exponents", "has 2 numbers, but Moduli has 1")),
    ("ogden_that_is_compressible", plate().set("Materials > Polymer", rubber([1e10], [2.0])),
     one("Materials > Polymer > Bulk Modulus", "K >= 2/3 mu fails", "6.66667e+09")),
    ("crack_in_a_fluid", plate().set("Materials > Polymer", WATER), one("Materials > Polymer > Model", "not available in one scene", "Cracks")),
    ("fluid_in_equilibrium", uncracked(WATER).set("Time > Analysis", "Static"),
     one("Materials > Polymer > Model", "no strength in shear", "Dynamic")),
    ("fluid_that_starts_in_equilibrium", uncracked(WATER).set("Time > Initial State", "Equilibrium"),
     one("Materials > Polymer > Model", "no strength in shear", "Unloaded")),
    ("fluid_in_refined_cells", uncracked(WATER).set("Adaptivity", {"Maximum Level": 1, "Velocity Change": 1.0}),
     one("Materials > Polymer > Model", "cells of one size")),
    ("fluid_as_a_plate", uncracked(WATER).set("Domain > Plane", "Stress"), one("Materials > Polymer > Model", "no plate", "Strain")),
    ("gas_without_pressure", uncracked({"Model": "Fluid", "Density": 1.2, "Equation Of State": "Ideal Gas", "Heat Capacity Ratio": 1.4}),
     one("Materials > Polymer > Initial Pressure", "pressure of the gas")),
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
     one("Boundaries > Pull", "inside Bodies > Plate", "edge")),
    ("load_that_catches_nothing",
     plate().set("Boundaries > Pull > From", [1.15, 0.0]).set("Boundaries > Pull > To", [1.15, 1.0]),
     one("Boundaries > Pull", "misses the body", "surface")),
    ("load_that_half_misses", plate().set("Boundaries > Pull > To", [1.0, 1.2]),
     one("Boundaries > Pull", "miss the body", "surface")),
    ("load_of_no_length", plate().set("Boundaries > Pull > To", [1.0, 0.0]),
     one("Boundaries > Pull > To", "same point")),
    ("absurdly_long_load", plate().set("Boundaries > Pull > To", [1.0, 1e300]),
     one("Boundaries > Pull", "points", "metres")),
    ("point_load_in_the_air",
     plate().set("Boundaries > Poke", {"Type": "Point Load", "Body": "Plate", "Point": [1.1, 1.1], "Force": [1.0,
     0.0]}), one("Boundaries > Poke", "misses the body")),
    ("stress_and_pressure", plate().set("Boundaries > Pull > Pressure", 1.0),
     one("Boundaries > Pull", "only one of")),
    ("wall_between_nodes",
     plate().set("Boundaries > Wall", {"Type": "Velocity", "Lower Corner": [0.01, 0.01], "Upper Corner": [0.04, 0.04],
     "Value": [0.0, 0.0]}),
     one("Boundaries > Wall", "no grid node", "nearest row of nodes")),
    ("wall_outside_of_the_domain",
     plate().set("Boundaries > Wall", {"Type": "Velocity", "Lower Corner": [3.0, 3.0], "Upper Corner": [4.0, 4.0],
     "Value": [0.0, 0.0]}),
     one("Boundaries > Wall", "no grid node")),
    ("supports_that_disagree",
     plate().set("Boundaries > Wall", {"Type": "Velocity", "Lower Corner": [-0.1, -0.1], "Upper Corner": [0.1, 1.1],
     "Value": [0.0, 0.0]}).set("Boundaries > Grip", {"Type": "Velocity", "Lower Corner": [-0.1, 0.9],
     "Upper Corner": [1.1, 1.1], "Value": [0.0, 0.1], "History": "t"}),
     one("Boundaries > Wall", "Boundaries > Grip", "both prescribe the node", "along y", "one velocity")),
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
