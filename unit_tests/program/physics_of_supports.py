"""Wrong supports of cracked and pulled bodies. See wrong_physics.py for what a template is."""

import re

from file_scene import where
from physics_of_bodies import cracked_box


# Sections that move bodies, or hold pieces of them together.
DRIVEN = ("Thermal", "Combustion", "Face Pressure", "Contact", "Body Contact", "Rigid Tools")


def alone(scene):
    """The corners of the only body of a scene of one box that only its boundaries move, or None."""
    names = scene.boxes()
    if scene.lists("Bodies") != names or len(names) != 1 or not scene.moves() or not scene.cell:
        return None
    thrown = any(any(scene.get(f"Bodies > {names[0]} > {m}", [0.0])) for m in ("Velocity", "Angular Velocity"))
    return None if thrown or any(scene.has(s) for s in DRIVEN) else scene.corners(names[0])


def add_boundary(scene, name, values):
    scene.set(*(f"Boundaries > {name}", values) if scene.has("Boundaries") else ("Boundaries", {name: values}))


def support_across_a_crack(scene, rng):
    """a support lies across a crack where it meets the surface"""
    found = cracked_box(scene, 12)
    if found is None or not scene.moves() or scene.boundaries("Velocity", "Symmetry"):
        return None
    name, low, high = found
    along, axes = rng.randrange(2), "xy"
    mouth = [0.5 * (l + h) for l, h in zip(low, high)]
    mouth[along] = low[along]
    front = list(mouth)
    front[along] += 0.4 * (high[along] - low[along])
    scene.set(f"Cracks > {name} > Points", mouth + front)
    reach = rng.uniform(1.1, 3.0) * scene.cell
    velocity = [0.0, 0.0]
    velocity[1 - along] = rng.choice([0.0, 0.1 * scene.cell / scene.get("Time > Final Time")])
    add_boundary(scene, "Clamp", {"Type": "Velocity", "Components": rng.choice(["xy", axes[1 - along]]), "Value": velocity,
                                  "Lower Corner": [x - reach for x in mouth], "Upper Corner": [x + reach for x in mouth]})
    return where("Boundaries", "Clamp") + f".*Cracks > {re.escape(name)}"


def value_along_a_free_axis(scene, rng):
    """a support has a velocity along an axis that it leaves free"""
    names = [n for n in scene.boundaries("Velocity") if scene.has(f"Boundaries > {n} > Value")]
    if not names or scene.get("Thermal > Mechanics") == "false":
        return None
    name, axes = rng.choice(names), "xyz"[:scene.dimension]
    held, free = rng.sample(range(scene.dimension), 2)
    value = [0.0] * scene.dimension
    value[free] = rng.uniform(-1.0, 1.0)
    scene.set(f"Boundaries > {name} > Components", axes[held]).set(f"Boundaries > {name} > Value", value)
    return where("Boundaries", name, "Value") + f": its {axes[free]} component"


def grips_that_move_alike(scene, rng):
    """both grips of a pulled body move the same way"""
    corners = alone(scene)
    if corners is None or scene.has("Adaptivity"):
        return None
    low, high = corners
    axis = rng.randrange(scene.dimension)
    if high[axis] - low[axis] < 12 * scene.cell:
        return None
    for name in scene.lists("Boundaries"):
        scene.remove(f"Boundaries > {name}")
    scene.enlarge(3)
    value = [0.0] * scene.dimension
    value[axis] = rng.choice([-1.0, 1.0]) * rng.uniform(0.2, 1.0) * scene.cell / scene.get("Time > Final Time")
    depth = rng.uniform(1.1, 2.0) * scene.cell
    for name, upper in (("One Grip", False), ("Other Grip", True)):
        lower_corner, upper_corner = [x - scene.cell for x in low], [x + scene.cell for x in high]
        if upper:
            lower_corner[axis] = high[axis] - depth
        else:
            upper_corner[axis] = low[axis] + depth
        add_boundary(scene, name, {"Type": "Velocity", "Components": "xyz"[axis], "Value": value,
                                   "Lower Corner": lower_corner, "Upper Corner": upper_corner})
    return where("Boundaries", "One Grip") + ": it and Boundaries > Other Grip"


def pin_in_the_contour(scene, rng):
    """a support lies in the contour of the J integral, in 3D in the tube around the front"""
    names = scene.lists("Cracks")
    if not scene.has("Energy Release") or len(names) != 1 or not scene.cell or scene.has("Adaptivity") or not scene.moves():
        return None
    if scene.has("Domain > Accuracy") or scene.boundaries("Velocity", "Symmetry"):
        return None
    if any(scene.has(f"Energy Release > {p}") for p in ("Inner Radius", "Outer Radius", "Contour Integral")):
        return None
    crack = f"Cracks > {names[0]}"
    if scene.dimension == 2:
        found = cracked_box(scene, 16)
        if found is None:
            return None
        _, low, high = found
        centre = [0.5 * (l + h) for l, h in zip(low, high)]
        scene.set(crack + " > Points", [low[0], centre[1]] + centre)
        away = 4.5
    else:
        if not scene.has(crack + " > Radius") or scene.has(crack + " > Normal"):
            return None
        centre = scene.get(crack + " > Centre")
        centre[0] += scene.get(crack + " > Radius")
        away = 3.5
    middle = [x + (away * scene.cell if d == 0 else 0.0) for d, x in enumerate(centre)]
    half = rng.uniform(0.55, 0.7) * scene.cell
    add_boundary(scene, "Pin", {"Type": "Velocity", "Components": "xyz"[:scene.dimension], "Value": [0.0] * scene.dimension,
                                "Lower Corner": [x - half for x in middle], "Upper Corner": [x + half for x in middle]})
    return "Energy Release: " + where("Boundaries", "Pin")


def crack_from_side_to_side(scene, rng):
    """a crack cuts a free body in two at the start"""
    found = cracked_box(scene, 12)
    if found is None or not scene.moves() or any(scene.has(s) for s in DRIVEN) or scene.boundaries("Velocity", "Symmetry"):
        return None
    name, low, high = found
    along = rng.randrange(2)
    ends = [[0.5 * (l + h) for l, h in zip(low, high)] for _ in range(2)]
    for end, side in zip(ends, (low, high)):
        end[along] = side[along]
        end[1 - along] += rng.uniform(-3.0, 3.0) * scene.cell
    for section in ("Energy Release", "Propagation", "Reference"):  # of fronts
        if scene.has(section):
            scene.remove(section)
    scene.set(f"Cracks > {name} > Points", ends[0] + ends[1])
    return where("Cracks", name) + ": at the start"


def bonded_from_afar(scene, rng):
    """bodies that are to be bonded do not touch"""
    names = scene.boxes()
    if not names or not scene.cell or scene.get("Thermal > Mechanics") == "false":
        return None
    name = rng.choice(names)
    scene.enlarge(18)
    low, high = scene.corners(name)
    axis = rng.randrange(scene.dimension)
    gap = rng.uniform(2.5, 8.0) * scene.cell
    lower = [h + gap if d == axis else l for d, (l, h) in enumerate(zip(low, high))]
    upper = [h + gap + 4 * scene.cell if d == axis else h for d, (l, h) in enumerate(zip(low, high))]
    scene.set("Bodies > Twin", {"Material": scene.get(f"Bodies > {name} > Material"), "Shape": "Box", "Lower Corner": lower,
                                "Upper Corner": upper, "Bonded To": name})
    return where("Bodies", "Twin") + ": it and " + where("Bodies", name)
