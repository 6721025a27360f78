"""Wrong loads and supports, heat sources among them. See wrong_physics.py for what a template is."""

import math
import re

from file_scene import value_of, where

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


def farthest(scene):
    """How far supports move bodies at most: to where there may be another boundary [m]."""
    values = [scene.get(f"Boundaries > {n} > Value", [0.0]) for n in scene.boundaries("Velocity")]
    return scene.get("Time > Final Time", 0.0) * max((abs(x) for v in values for x in v), default=0.0)


def mirror_away(scene, rng):
    """a plane of symmetry lies next to the body"""
    names = scene.boundaries("Symmetry")
    if not names or not scene.cell or farthest(scene) > 5 * scene.cell:
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


def heavy_loads(scene, rng):
    """loads are a million times too large"""
    names = scene.boundaries("Traction", "Point Load", "Line Load")
    if not names:
        return None
    for name in names:
        scene.scale({"Force", "Stress", "Pressure"}, 10 ** rng.uniform(6.0, 9.0), f"Boundaries > {name}")
    return r"Boundaries > (" + "|".join(map(re.escape, names)) + ")"


def nothing_acts(scene, rng):
    """nothing loads or moves the bodies"""
    if not scene.moves() or any(scene.has(s) for s in ("Thermal", "Combustion", "Face Pressure", "Rigid Tools")):
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
    return where("Boundaries", kept) + ".* so it moves by"


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


def mirror_in_material(scene, rng):
    """a plane of symmetry lies inside a body"""
    names = scene.boxes()
    if not names or not scene.cell or scene.get("Thermal > Mechanics") == "false":
        return None
    low, high = scene.corners(rng.choice(names))
    axis = rng.randrange(scene.dimension)
    start = scene.get("Domain > Lower Corner")[axis]
    first, last = (round((x[axis] - start) / scene.cell) for x in (low, high))
    if last - first < 4:
        return None
    plane = {"Type": "Symmetry", "Axis": "xyz"[axis], "Position": start + rng.randrange(first + 2, last - 1) * scene.cell}
    if rng.random() < 0.5:
        plane["Side"] = rng.choice(["Lower", "Upper"])
    scene.set(*("Boundaries > Mirror", plane) if scene.has("Boundaries") else ("Boundaries", {"Mirror": plane}))
    return where("Boundaries", "Mirror")


def wrong_side(scene, rng):
    """the side of a plane of symmetry is that of the body"""
    names = scene.boundaries("Symmetry")
    if not names or not scene.cell:
        return None
    scene.enlarge(0)  # writes Side
    name = rng.choice(names)
    place = f"Boundaries > {name} > Side"
    scene.set(place, "Lower" if scene.get(place) == "Upper" else "Upper")
    return where("Boundaries", name)


def held_everywhere(scene, rng):
    """a support holds all of a body that is loaded"""
    names = scene.boundaries("Traction", "Point Load", "Line Load")
    if not names or not scene.moves():
        return None
    low, high = scene.get("Domain > Lower Corner"), scene.get("Domain > Upper Corner")
    scene.set("Boundaries > Everywhere", {"Type": "Velocity", "Components": "xyz"[: scene.dimension], "Lower Corner": low,
                                          "Upper Corner": high, "Value": [0.0] * scene.dimension})
    return where("Boundaries", "Everywhere") + "(: it prescribes the motion of all| both prescribe)"


def held_at_the_load(scene, rng):
    """a support holds what a load pulls"""
    names = [n for n in scene.boundaries("Traction", "Point Load", "Line Load")
             if scene.has(f"Boundaries > {n} > From") or scene.has(f"Boundaries > {n} > Point")]
    if not names or not scene.moves() or not scene.cell:
        return None
    name = rng.choice(names)
    ends = [scene.get(f"Boundaries > {name} > {end}") for end in ("From", "To", "Point")
            if scene.has(f"Boundaries > {name} > {end}")]
    gap = rng.uniform(0.1, 2.0) * scene.cell
    corners = [[side(x) + sign * gap for x in zip(*ends)] for side, sign in ((min, -1), (max, 1))]
    scene.set("Boundaries > There", {"Type": "Velocity", "Components": "xyz"[: scene.dimension], "Lower Corner": corners[0],
                                     "Upper Corner": corners[1], "Value": [0.0] * scene.dimension})
    return where("Boundaries", name) + ": it acts where|both prescribe|prescribes the motion of all"


def fast_support(scene, rng):
    """a support is faster than waves"""
    names = [n for n in scene.boundaries("Velocity") if any(scene.get(f"Boundaries > {n} > Value", [0.0]))]
    if not names or not scene.moves():
        return None
    name = rng.choice(names)
    value = scene.get(f"Boundaries > {name} > Value")
    factor = 10 ** rng.uniform(4.5, 6) / max(map(abs, value))
    scene.set(f"Boundaries > {name} > Value", [x * factor for x in value])
    return where("Boundaries", name) + ": it (moves|strains)"
