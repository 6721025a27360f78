"""Errors that make a right scene wrong in its physics, each with the places that a message may name."""

import math
import re

from file_scene import LENGTHS, value_of, where

# Each template changes a scene and gives a regular expression of the places that may be named, or None where the scene has
# nothing to which it applies. Its docstring is the error that it makes, for the table of docs/plausibility.md.


FREE = r"|Bodies > .* can (move|turn)"  # in equilibrium a body that nothing holds is an error of its own


def support_away(scene, rng):
    """a support lies next to the body instead of on it"""
    names = scene.boundaries("Velocity")
    if not names or not scene.cell:
        return None
    name = rng.choice(names)
    scene.enlarge(12)
    low = scene.get("Domain > Lower Corner")
    place = f"Boundaries > {name}"
    scene.set(place + " > Lower Corner", [x for x in low]).set(place + " > Nodes", "Inside")
    scene.set(place + " > Upper Corner", [x + 5 * scene.cell for x in low])
    return where("Boundaries", name) + FREE


def mirror_away(scene, rng):
    """a plane of symmetry lies next to the body"""
    names = scene.boundaries("Symmetry")
    if not names or not scene.cell:
        return None
    scene.enlarge(12)
    name = rng.choice(names)
    axis = "xyz".index(scene.get(f"Boundaries > {name} > Axis"))
    side = scene.get(f"Boundaries > {name} > Side")
    end = scene.get("Domain > Lower Corner" if side == "Lower" else "Domain > Upper Corner")[axis]
    scene.set(f"Boundaries > {name} > Position", end + (3 if side == "Lower" else -3) * scene.cell)
    return where("Boundaries", name) + r"|touches the domain's edge" + FREE


def load_away(scene, rng):
    """a load lies 100 cells away from its body"""
    names = scene.boundaries("Traction", "Point Load", "Line Load")
    if not names:
        return None
    name = rng.choice(names)
    for parameter in ("From", "To", "Point", "Corner"):
        if scene.has(f"Boundaries > {name} > {parameter}"):
            old = scene.get(f"Boundaries > {name} > {parameter}")
            scene.set(f"Boundaries > {name} > {parameter}", [x + 100 * scene.cell for x in old])
    return where("Boundaries", name)


def no_load(scene, rng):
    """a load is zero"""
    names = scene.boundaries("Traction", "Point Load", "Line Load")
    if not names:
        return None
    name = rng.choice(names)
    for parameter in ("Force", "Stress", "Pressure"):
        if scene.has(f"Boundaries > {name} > {parameter}"):
            old = scene.get(f"Boundaries > {name} > {parameter}")
            scene.set(f"Boundaries > {name} > {parameter}", [0.0 for x in old] if isinstance(old, list) else 0.0)
    return where("Boundaries", name)


def late_load(scene, rng):
    """a load starts long after the end"""
    names = scene.boundaries("Traction", "Point Load", "Line Load")
    if not names:
        return None
    name = rng.choice(names)
    scene.set(f"Boundaries > {name} > History", f"0:0, {10 ** rng.uniform(1, 4)}:1")
    return where("Boundaries", name)


def free_body(scene, rng, extents, name):
    """A box in a corner of the enlarged domain, in cells, which no support holds."""
    bodies = scene.lists("Bodies")
    if not bodies or not scene.cell or any(scene.get(f"Boundaries > {n} > Nodes") == "Outside" for n in scene.lists("Boundaries")):
        return None
    scene.enlarge(14)
    corner = rng.choice(["Lower Corner", "Upper Corner"])
    middle = [x + (5.3 if corner == "Lower Corner" else -5.3) * scene.cell for x in scene.get(f"Domain > {corner}")]
    scene.set(f"Bodies > {name}", {
        "Material": scene.get(f"Bodies > {bodies[0]} > Material"), "Shape": "Box",
        "Lower Corner": [x - 0.5 * e * scene.cell for x, e in zip(middle, extents)],
        "Upper Corner": [x + 0.5 * e * scene.cell for x, e in zip(middle, extents)]})
    return where("Bodies", name)


def thin_body(scene, rng):
    """a body is thinner than two cells"""
    extents = [4.0] * scene.dimension
    extents[rng.randrange(scene.dimension)] = rng.uniform(0.6, 1.9)
    return free_body(scene, rng, extents, "Sliver")


def thin_hole(scene, rng):
    """a hole is thinner than two cells"""
    names = scene.boxes()
    if not names or not scene.cell or scene.has("Adaptivity") or scene.has("Domain > Accuracy"):
        return None
    name = rng.choice(names)
    low, high = scene.corners(name)
    middle = [l + rng.uniform(0.3, 0.7) * (h - l) for l, h in zip(low, high)]
    half = rng.uniform(0.2, 0.95) * scene.cell
    hole = {"Operation": "Cut", "Shape": "Ball", "Centre": middle, "Radius": half}
    if rng.random() < 0.5:
        hole = {"Operation": "Cut", "Shape": "Box", "Lower Corner": [x - half for x in middle],
                "Upper Corner": [x + (half if k == 0 else 3 * scene.cell) for k, x in enumerate(middle)]}
    scene.set(f"Bodies > {name} > Operations", {"Bore": hole})
    return where("Bodies", name, "Operations", "Bore")


def hole_beside(scene, rng):
    """a hole lies next to its body"""
    names = scene.boxes()
    if not names or not scene.cell:
        return None
    name = rng.choice(names)
    low, high = scene.corners(name)
    away = [h + (h - l) * rng.uniform(1, 3) for l, h in zip(low, high)]
    scene.set(f"Bodies > {name} > Operations",
              {"Bore": {"Operation": "Cut", "Shape": "Ball", "Centre": away, "Radius": 4 * scene.cell}})
    return where("Bodies", name, "Operations", "Bore")


def all_in_millimetres(scene, rng):
    """all lengths are in millimetres"""
    if any(element.get("type") == "string" and re.search(r"\b[xy]\b", element.get("value"))
           for element in scene.root.iter("Parameter") if element.get("name") in ("Field", "Temperature Field")):
        return None  # lengths in formulas
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


def modulus_in_megapascal(scene, rng):
    """Young's modulus is in MPa or GPa"""
    name = rng.choice(scene.lists("Materials"))
    place = f"Materials > {name} > Young Modulus"
    if not scene.moves() or not isinstance(scene.get(place), float):
        return None
    scene.set(place, scene.get(place) * rng.choice([1e-6, 1e-9]))
    return where("Materials", name)


def density_in_grams(scene, rng):
    """the density is in g/cm3"""
    name = rng.choice(scene.lists("Materials"))
    if not scene.moves() or scene.get(f"Materials > {name} > Density") > 3e4:
        return None
    scene.scale({"Density"}, 1e-3, f"Materials > {name}")
    return where("Materials", name)


def no_step(scene, rng):
    """the final time is shorter than a step"""
    if not scene.moves() or not scene.has("Time > Final Time"):
        return None
    factor = 10 ** rng.uniform(-12, -7)
    scene.scale({"Final Time", "History Interval", "Field Interval", "Checkpoint Interval"}, factor)
    return where("Time", "Final Time")


def endless(scene, rng):
    """the final time is millions of times too long"""
    if not scene.moves() or scene.has("Time > Maximum Steps"):
        return None
    factor = 10 ** rng.uniform(6.5, 12)
    scene.scale({"Final Time", "History Interval", "Field Interval", "Checkpoint Interval"}, factor)
    return where("Time", "Final Time")


def short_crack(scene, rng):
    """a crack is shorter than three cells"""
    names = [n for n in scene.lists("Cracks") if scene.has(f"Cracks > {n} > Points")] if scene.dimension == 2 else [
        n for n in scene.lists("Cracks") if scene.has(f"Cracks > {n} > Radius")]
    if not names or not scene.cell or not scene.moves():
        return None
    name = rng.choice(names)
    fine = scene.cell / 2 ** 4 if scene.has("Adaptivity") else scene.cell
    if scene.dimension == 3:
        scene.set(f"Cracks > {name} > Radius", rng.uniform(0.3, 1.0) * fine)
    else:
        points = scene.get(f"Cracks > {name} > Points")
        end, before = points[-2:], points[-4:-2]
        length = math.dist(end, before)
        reach = rng.uniform(0.5, 2.8) * fine
        scene.set(f"Cracks > {name} > Points", [e - (e - b) * reach / length for e, b in zip(end, before)] + end)
    return where("Cracks", name) + "|" + re.escape(f"crack {name}, front")


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


def heavy_damping(scene, rng):
    """the damping is in other units"""
    if not scene.moves() or not scene.lists("Bodies"):
        return None
    scene.set("Damping", {"Mass Rate": 10 ** rng.uniform(12, 16)} if not scene.has("Damping") else {
        "Mass Rate": max(scene.get("Damping > Mass Rate", 1e5), 1e5) * 10 ** rng.uniform(6, 8)})
    return where("Damping", "Mass Rate")


def heavy_loads(scene, rng):
    """loads are a million times too large"""
    names = scene.boundaries("Traction", "Point Load", "Line Load")
    if not names:
        return None
    for name in names:
        scene.scale({"Force", "Stress", "Pressure"}, 10 ** rng.uniform(6.0, 9.0), f"Boundaries > {name}")
    return r"Boundaries > (" + "|".join(map(re.escape, names)) + ")"


def fast_bodies(scene, rng):
    """bodies are thousands of times too fast"""
    names = [n for n in scene.lists("Bodies") if any(scene.get(f"Bodies > {n} > Velocity", [0]))]
    if not names:
        return None
    scene.scale({"Velocity"}, 10 ** rng.uniform(3, 5), "Bodies")
    return r"Bodies > (" + "|".join(map(re.escape, names)) + ")"


def touching_twin(scene, rng):
    """a second body touches the first"""
    names = scene.boxes()
    if not names or not scene.cell or not scene.moves():
        return None
    name = rng.choice(names)
    scene.enlarge(14)
    low, high = scene.corners(name)
    gap = rng.choice([0.0, rng.uniform(0.0, 0.9)]) * scene.cell
    axis = rng.randrange(scene.dimension)
    lower = [h + gap if d == axis else l for d, (l, h) in enumerate(zip(low, high))]
    upper = [h + gap + 4 * scene.cell if d == axis else h for d, (l, h) in enumerate(zip(low, high))]
    scene.set("Bodies > Twin", {"Material": scene.get(f"Bodies > {name} > Material"), "Shape": "Box",
                                "Lower Corner": lower, "Upper Corner": upper})
    return where("Bodies", "Twin") + ".*" + re.escape(name)


NUMBERS = [("Domain > Thickness", [1e308, 1e-12]), ("Density", [1e30, 1e-30, -1200.0, 1e6]),
           ("Young Modulus", [1e40, -3e9, 1e-3]), ("Time > Final Time", [1e300, -1.0, 1e-100]),
           ("Value", [1e30, 1e200]), ("Force", [1e60]), ("Stress", [1e60]), ("Radius", [1e-40, 1e300, -1.0]),
           ("Poisson Ratio", [0.7, -2.0]), ("Specific Heat", [1e-20, 1e30, -5.0]), ("Conductivity", [1e20, -1.0]),
           ("Initial Temperature", [1e9, 20.0, -100.0]), ("Mass Rate", [1e200, -1.0]), ("Cell Size", [1e-80, 1e300]),
           ("Flame Temperature", [1e30, -4.0]), ("Acceleration", [1e40]), ("Velocity", [1e60]), ("CFL", [1e6, -1.0])]


def senseless_number(scene, rng):
    """a number that no quantity has"""
    found = []
    for section in scene.root:
        for element in section.iter("Parameter"):
            for name, values in NUMBERS:
                last = name.rsplit(" > ", 1)[-1]
                if element.get("name") == last and (" > " not in name or name.startswith(section.get("name"))):
                    if element.get("type") in ("double", "Array(double)") and section.get("name") != "Reference":
                        if scene.moves() or last not in ("Young Modulus", "Poisson Ratio", "Density"):
                            found.append((section.get("name"), element, values))
    if not found:
        return None
    section, element, values = rng.choice(found)
    value = rng.choice(values)
    old = value_of(element)
    scene.put(element, [value for x in old] if isinstance(old, list) else value)
    return re.escape(element.get("name")) + "|" + re.escape(section)


def hot_source_away(scene, rng):
    """a heat source is nowhere near a body"""
    names = scene.lists("Thermal > Sources")
    if not names:
        return None
    name = rng.choice(names)
    for element in scene.find(f"Thermal > Sources > {name}").iter("Parameter"):
        if element.get("name") in ("Centre", "Lower Corner", "Upper Corner"):
            scene.put(element, [x + 1e4 * (1 + abs(x)) for x in value_of(element)])
    return where("Thermal", "Sources", name)


def held_temperature_away(scene, rng):
    """a held temperature is nowhere near a body"""
    names = scene.boundaries("Temperature")
    if not names:
        return None
    name = rng.choice(names)
    scene.enlarge(12)
    low = scene.get("Domain > Lower Corner")
    scene.set(f"Boundaries > {name} > Lower Corner", low)
    scene.set(f"Boundaries > {name} > Upper Corner", [x + 5 * scene.cell for x in low])
    return where("Boundaries", name)


def toughness_in_megapascal(scene, rng):
    """K_Ic in MPa m^0.5 instead of the toughness"""
    Gc = toughness(scene)
    E = scene.get(f"Materials > {scene.lists('Materials')[0]} > Young Modulus")
    if Gc is None or not isinstance(E, float):
        return None
    scene.set("Propagation > Toughness", repr(1e-6 * math.sqrt(E * Gc)))
    return where("Propagation", "Toughness")


def thin_hole_in_a_held_body(scene, rng):
    """a hole is thinner than two cells, in a body that a support holds everywhere"""
    place = thin_hole(scene, rng)
    if place is None or not scene.moves():
        return None
    low, high = scene.get("Domain > Lower Corner"), scene.get("Domain > Upper Corner")
    everywhere = {"Type": "Velocity", "Components": "xyz"[: scene.dimension], "Lower Corner": low, "Upper Corner": high,
                  "Value": [0.0] * scene.dimension}
    scene.set(*("Boundaries > Everywhere", everywhere) if scene.has("Boundaries") else ("Boundaries", {"Everywhere": everywhere}))
    return place


def thickness_in_millimetres(scene, rng):
    """the thickness is in millimetres"""
    sizes = [max(h - l for l, h in zip(*scene.corners(n))) for n in scene.boxes()]
    if not sizes or scene.get("Domain > Plane") != "Stress":
        return None
    scene.set("Domain > Thickness", max(sizes) * rng.uniform(2.1, 40))
    return where("Domain", "Thickness")


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


def nothing_acts(scene, rng):
    """nothing loads or moves the bodies"""
    if not scene.moves() or any(scene.has(s) for s in ("Thermal", "Combustion", "Face Pressure")):
        return None
    for name in scene.lists("Boundaries"):
        if scene.get(f"Boundaries > {name} > Type") != "Symmetry":
            scene.remove(f"Boundaries > {name}")
    for body in scene.lists("Bodies"):
        for motion in ("Velocity", "Angular Velocity"):
            if scene.has(f"Bodies > {body} > {motion}"):
                scene.remove(f"Bodies > {body} > {motion}")
    return "Boundaries: nothing loads or moves"


def gravity_in_millimetres(scene, rng):
    """gravity is in mm/s2"""
    if not scene.moves():
        return None
    weight = {"Type": "Gravity", "Acceleration": [0.0] * (scene.dimension - 1) + [-9810.0]}
    scene.set(*("Boundaries > Weight", weight) if scene.has("Boundaries") else ("Boundaries", {"Weight": weight}))
    return where("Boundaries", "Weight", "Acceleration")


def opposite_load_forgotten(scene, rng):
    """a load is not balanced, and nothing supports its body"""
    names = scene.boundaries("Traction", "Point Load", "Line Load")
    bodies = scene.boxes()
    if not names or not scene.moves() or scene.lists("Bodies") != bodies or len(bodies) != 1:
        return None
    kept = rng.choice(names)
    if not scene.has(f"Boundaries > {kept} > Force") and not scene.has(f"Boundaries > {kept} > Stress"):
        return None
    if scene.has(f"Boundaries > {kept} > History"):
        return None
    for name in scene.lists("Boundaries"):
        if name != kept:
            scene.remove(f"Boundaries > {name}")
    # As far as ten times its length: in kN, if that takes more than the force has.
    low, high = scene.corners(bodies[0])
    sizes = [h - l for l, h in zip(low, high)]
    density = scene.get(f"Materials > {scene.get(f'Bodies > {bodies[0]} > Material')} > Density")
    thickness = scene.get("Domain > Thickness", 1.0) if scene.dimension == 2 else 1.0
    force = 20 * density * math.prod(sizes) * thickness * max(sizes) / scene.get("Time > Final Time") ** 2
    place = f"Boundaries > {kept} > " + ("Force" if scene.has(f"Boundaries > {kept} > Force") else "Stress")
    now = math.hypot(*scene.get(place)) * (1.0 if place.endswith("Force") else thickness * min(sizes))
    factor = max(1.0, force / now)
    scene.set(place, [x * factor for x in scene.get(place)])
    return where("Boundaries", kept) + ".* flies"


def damping_that_never_settles(scene, rng):
    """Mass Rate is far below what brings the body to rest"""
    if not scene.get("Damping > Stop When Settled") == "true" or any(
            scene.has(f"Damping > {v} Viscosity") for v in ("Shear", "Bulk")):
        return None
    scene.set("Damping > Mass Rate", rng.uniform(1, 10))
    return where("Damping", "Mass Rate") + ".* settled"


TEMPLATES = [support_away, mirror_away, load_away, no_load, late_load, thin_body, thin_hole, hole_beside,
             all_in_millimetres, one_body_in_millimetres, crack_in_millimetres, cells_in_millimetres,
             modulus_in_megapascal, density_in_grams, no_step, endless, short_crack, toughness_in_megajoule,
             toughness_in_pascal, heavy_damping, heavy_loads, fast_bodies, touching_twin, senseless_number,
             hot_source_away, held_temperature_away,
             toughness_in_megapascal, thin_hole_in_a_held_body, thickness_in_millimetres, yield_in_megapascal,
             nothing_acts, gravity_in_millimetres, opposite_load_forgotten, damping_that_never_settles]
