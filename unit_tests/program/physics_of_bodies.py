"""Wrong bodies, holes and cracks. See wrong_physics.py for what a template is."""

import math
import re

from file_scene import where


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


def thin_wall(scene, rng):
    """two holes leave a wall thinner than two cells between them"""
    names = scene.boxes()
    if not names or not scene.cell or scene.has("Adaptivity") or scene.has("Domain > Accuracy"):
        return None
    name = rng.choice(names)
    low, high = scene.corners(name)
    across, along = rng.sample(range(scene.dimension), 2)
    if high[across] - low[across] < 16 * scene.cell or high[along] - low[along] < 16 * scene.cell:
        return None
    half = 0.5 * rng.uniform(0.3, 1.9) * scene.cell
    middle = [l + rng.uniform(0.45, 0.55) * (h - l) for l, h in zip(low, high)]
    holes = {}
    for hole, sign in (("Left", -1), ("Right", 1)):
        near, far = middle[across] + sign * half, middle[across] + sign * (half + 3 * scene.cell)
        lower, upper = list(low), list(high)
        lower[across], upper[across] = min(near, far), max(near, far)
        lower[along], upper[along] = middle[along] - 4 * scene.cell, middle[along] + 4 * scene.cell
        holes[hole] = {"Operation": "Cut", "Shape": "Box", "Lower Corner": lower, "Upper Corner": upper}
    scene.set(f"Bodies > {name} > Operations", holes)
    return where("Bodies", name) + ": a wall"


def thin_ring(scene, rng):
    """a ring is thinner than two cells"""
    if scene.has("Adaptivity") or scene.has("Domain > Accuracy"):
        return None
    place = free_body(scene, rng, [8.0] * scene.dimension, "Ring")
    if place is None:
        return None
    low, high = scene.corners("Ring")
    middle = [0.5 * (l + h) for l, h in zip(low, high)]
    scene.remove("Bodies > Ring > Lower Corner").remove("Bodies > Ring > Upper Corner")
    scene.set("Bodies > Ring > Shape", "Ball").set("Bodies > Ring > Centre", middle)
    scene.set("Bodies > Ring > Radius", 4 * scene.cell)
    scene.set("Bodies > Ring > Operations", {"Bore": {
        "Operation": "Cut", "Shape": "Ball", "Centre": middle, "Radius": (4 - rng.uniform(0.6, 1.9)) * scene.cell}})
    return place + ": a wall"


def cut_apart(scene, rng):
    """a hole cuts a body in two"""
    names = scene.boxes()
    if not names or not scene.cell or scene.has("Adaptivity") or scene.has("Domain > Accuracy"):
        return None
    name = rng.choice(names)
    low, high = scene.corners(name)
    axis = rng.randrange(scene.dimension)
    if high[axis] - low[axis] < 14 * scene.cell or scene.boundaries("Velocity", "Symmetry"):
        return None
    at = low[axis] + rng.uniform(0.35, 0.65) * (high[axis] - low[axis])
    half = rng.uniform(0.8, 1.5) * scene.cell
    lower, upper = [l - scene.cell for l in low], [h + scene.cell for h in high]
    lower[axis], upper[axis] = at - half, at + half
    scene.set(f"Bodies > {name} > Operations", {"Slot": {
        "Operation": "Cut", "Shape": "Box", "Lower Corner": lower, "Upper Corner": upper}})
    return where("Bodies", name, "Operations") + ": they leave"


def cracked_box(scene, cells):
    """The only crack of a plane scene of one box, which is so many cells wide, and the box's corners. All cells are equal."""
    names, cracks = scene.boxes(), scene.lists("Cracks")
    if scene.dimension != 2 or scene.lists("Bodies") != names or len(names) != 1 or len(cracks) != 1 or not scene.cell:
        return None
    if scene.has("Adaptivity") or scene.has("Domain > Accuracy") or not scene.has(f"Cracks > {cracks[0]} > Points"):
        return None
    low, high = scene.corners(names[0])
    return (cracks[0], low, high) if min(h - l for l, h in zip(low, high)) > cells * scene.cell else None


def crack_below_a_surface(scene, rng):
    """a crack runs less than two cells below a surface"""
    found = cracked_box(scene, 12)
    if found is None or scene.boundaries("Velocity", "Symmetry"):  # a side that is held as by a mirror is no surface
        return None
    name, low, high = found
    along = rng.randrange(2)
    depth = rng.uniform(0.2, 1.8) * scene.cell
    across = rng.choice([low[1 - along] + depth, high[1 - along] - depth])
    points = []
    for x in (low[along] + 2 * scene.cell, low[along] + 10 * scene.cell):
        points += [x, across] if along == 0 else [across, x]
    scene.set(f"Cracks > {name} > Points", points)
    return where("Cracks", name) + ": a surface of the body is"


def crack_that_comes_back(scene, rng):
    """a crack turns back and runs less than three cells from itself"""
    found = cracked_box(scene, 14)
    if found is None:
        return None
    name, low, high = found
    middle = [0.5 * (l + h) for l, h in zip(low, high)]
    gap, half = rng.uniform(0.5, 2.8) * scene.cell, 4 * scene.cell
    points = [(-half, 0.0), (half, 0.0), (half, gap), (0.25 * half, gap)]
    turn = rng.uniform(0.0, 2.0 * math.pi)
    cosine, sine = math.cos(turn), math.sin(turn)
    scene.set(f"Cracks > {name} > Points", [c for x, y in points for c in (
        middle[0] + cosine * x - sine * y, middle[1] + sine * x + cosine * y)])
    return where("Cracks", name) + ": it comes back"


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
    if not names or not scene.cell or not scene.moves() or scene.has("Body Contact"):  # with which they share no motion
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
