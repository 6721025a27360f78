"""Numbers in wrong units. See wrong_physics.py for what a template is."""

import math
import re

from file_scene import LENGTHS, where


def all_in_millimetres(scene, rng):
    """all lengths are in millimetres"""
    if any(element.get("type") == "string" and re.search(r"\b[xy]\b", element.get("value"))
           for element in scene.root.iter("Parameter") if element.get("name") in ("Field", "Temperature Field")):
        return None  # lengths in formulas
    if not scene.moves() and not set(scene.types()) - {"Traction", "Symmetry", "Temperature"}:
        return None  # equilibrium under stresses, pressures or temperatures: a body a thousand times as large is a right scene
    scene.scale(LENGTHS, 1000.0)
    return r"Bodies > |Time > Final Time|Damping > Mass Rate|Energy Release > "


def one_body_in_millimetres(scene, rng):
    """the lengths of one body are in millimetres"""
    names = scene.boxes()
    if not names:
        return None
    name = rng.choice(names)
    scene.scale(LENGTHS, 1000.0, f"Bodies > {name}")
    return where("Bodies", name)


def crack_in_millimetres(scene, rng):
    """a crack is in millimetres"""
    names = [n for n in scene.lists("Cracks")]
    if not names:
        return None
    name = rng.choice(names)
    scene.scale(LENGTHS, 1000.0, f"Cracks > {name}")
    return where("Cracks", name) + "|no crack has a front"


def cells_in_millimetres(scene, rng):
    """the cell size is in millimetres"""
    if not scene.cell:
        return None
    scene.scale({"Cell Size"}, 1000.0)
    return where("Domain", "Cell Size")


def thickness_in_millimetres(scene, rng):
    """the thickness is in millimetres"""
    sizes = [max(h - l for l, h in zip(*scene.corners(n))) for n in scene.boxes()]
    if not sizes or scene.get("Domain > Plane") != "Stress":
        return None
    scene.set("Domain > Thickness", max(sizes) * rng.uniform(2.1, 40))
    return where("Domain", "Thickness")


def modulus_in_megapascal(scene, rng):
    """Young's modulus is in MPa or GPa"""
    name = rng.choice(scene.lists("Materials"))
    place = f"Materials > {name} > Young Modulus"
    if not scene.moves() or not isinstance(scene.get(place), float):
        return None
    scene.set(place, scene.get(place) * rng.choice([1e-6, 1e-9]))
    return where("Materials", name)


def loads_in_megapascal(scene, rng):
    """all stresses are in MPa, all forces in MN, and there is no toughness to compare them with"""
    if any(scene.has(section) for section in ("Propagation", "Combustion", "Thermal", "Face Pressure")):
        return None
    names = scene.boundaries("Traction", "Point Load", "Line Load")
    others = set(scene.lists("Boundaries")) - set(names) - set(scene.boundaries("Symmetry"))
    if not names or any(scene.get(f"Boundaries > {n} > Type") != "Velocity" or scene.has(f"Boundaries > {n} > Field") or
                        any(scene.get(f"Boundaries > {n} > Value", [])) for n in others) or any(
            scene.has(f"Bodies > {n} > Velocity") for n in scene.lists("Bodies")):
        return None
    if any(abs(x) > 0.01 * scene.get(f"Materials > {m} > Young Modulus", 0.0) for n in names for m in scene.lists("Materials")
           for x in scene.get(f"Boundaries > {n} > Stress", [])):
        return None  # soft: it is strained noticeably all the same
    scene.scale({"Stress", "Force"}, 1e-6, "Boundaries")
    return "|".join(where("Boundaries", n) for n in names)


def nearly_incompressible(scene, rng):
    """the material hardly changes its volume, in a cracked body of few cells"""
    names = [n for n in scene.lists("Materials") if scene.get(f"Materials > {n} > Model") == "Linear Elastic"]
    if not names or len(names) != len(scene.lists("Materials")) or not scene.has("Cracks") or not scene.cell or (
            scene.dimension == 2 and scene.get("Domain > Plane") == "Stress") or scene.get("Thermal > Mechanics") == "false":
        return None
    for name in names:
        scene.set(f"Materials > {name} > Poisson Ratio", rng.uniform(0.4999, 0.499999))
    return r"Materials > .*: its bulk modulus is"


def density_in_grams(scene, rng):
    """the density is in g/cm3"""
    name = rng.choice(scene.lists("Materials"))
    if not scene.moves() or scene.get(f"Materials > {name} > Density") > 3e4:
        return None
    scene.scale({"Density"}, 1e-3, f"Materials > {name}")
    return where("Materials", name)


def yield_in_megapascal(scene, rng):
    """the yield stress is in MPa"""
    names = [n for n in scene.lists("Materials") if scene.get(f"Materials > {n} > Model") == "Linear Elastic"]
    if not scene.has("Energy Release") or not scene.moves() or scene.has("Thermal") or len(names) != len(
            scene.lists("Materials")) or not scene.boundaries("Traction", "Point Load", "Line Load"):
        return None
    for name in names:
        scene.set(f"Materials > {name} > Model", "J2 Plastic")
        scene.set(f"Materials > {name} > Yield Stress", rng.uniform(50, 400))
    return "(" + "|".join(where("Materials", name, "Yield Stress") for name in names) + ") is"


def toughness(scene):
    text = scene.get("Propagation > Toughness", "")
    numbers = re.findall(r"[\d.]+(?:e[-+]?\d+)?", text)
    if not numbers or ":" in text or not scene.boundaries("Traction", "Point Load", "Line Load", "Velocity"):
        return None
    # Where faces are pressed or heated, that may load the crack as much as the boundaries.
    return None if any(scene.has(s) for s in ("Thermal", "Face Pressure", "Combustion")) else float(numbers[0])


def toughness_in_megajoule(scene, rng):
    """the toughness is in MJ/m2 or less"""
    Gc = toughness(scene)
    if Gc is None:
        return None
    scene.set("Propagation > Toughness", repr(Gc * 10 ** rng.uniform(-6.5, -5)))
    if scene.get("Propagation > Initiation Toughness", None) is not None:
        scene.remove("Propagation > Initiation Toughness")
    return where("Propagation", "Toughness")


def toughness_in_pascal(scene, rng):
    """K_Ic in Pa m^0.5 instead of the toughness"""
    Gc = toughness(scene)
    name = scene.lists("Materials")[0]
    E = scene.get(f"Materials > {name} > Young Modulus")
    if Gc is None or not isinstance(E, float):
        return None
    scene.set("Propagation > Toughness", repr(math.sqrt(E * Gc)))
    return where("Propagation", "Toughness")


def toughness_in_megapascal(scene, rng):
    """K_Ic in MPa m^0.5 instead of the toughness"""
    Gc = toughness(scene)
    E = scene.get(f"Materials > {scene.lists('Materials')[0]} > Young Modulus")
    if Gc is None or not isinstance(E, float) or scene.has("Propagation > Initiation Toughness"):  # which is that of the start
        return None
    scene.set("Propagation > Toughness", repr(1e-6 * math.sqrt(E * Gc)))
    return where("Propagation", "Toughness")
