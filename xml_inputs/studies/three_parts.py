#!/usr/bin/env python3
"""Three parts as STL files, turned against the axes of the cells as parts from a drawing are, each with its scene: an axle with a flaw in its
fillet, a bracket on two bolts with a flaw in its corner, and a ring of glass whose outside is quenched. docs/tutorials/three-parts.md is on them.

    xml_inputs/studies/three_parts.py FOLDER      (needs NumPy and Matplotlib)
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "tools"))
from rhegma_tools import interpreter  # noqa: E402

interpreter.need("numpy", "matplotlib")  # goes on with the Python of the system where this one lacks them

import numpy as np  # noqa: E402
from matplotlib.tri import Triangulation  # noqa: E402


def turned(seed):
    """A rotation (3, 3) and an origin [mm] at random."""
    chance = np.random.default_rng(seed)
    q = chance.normal(size=4)
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]), chance.uniform(-30, 30, 3)


def revolved(profile, count, closed=False):
    """Triangles (k, 3, 3) of points (r, z) turned about z. closed: whether the last one is joined to the first"""
    angle = 2 * np.pi * np.arange(count + 1) / count
    rings = [np.c_[r * np.cos(angle), r * np.sin(angle), np.full(count + 1, z)] for r, z in profile]
    rings = [np.r_[ring[:-1], ring[:1]] for ring in rings]  # the last point is the first one to the last bit
    found = []
    for one, other in zip(rings, rings[1:] + (rings[:1] if closed else [])):
        for i in range(count):
            found += [(one[i], one[i + 1], other[i + 1])] if one[0, 0] > 0 else []
            found += [(one[i], other[i + 1], other[i])] if other[0, 0] > 0 else []
    return np.array(found)


def facing(triangle, outward):
    """The triangle with its corners counter-clockwise, seen from outside."""
    a, b, c = (np.asarray(point, dtype=float) for point in triangle)
    return (a, b, c) if np.cross(b - a, c - a) @ np.asarray(outward, dtype=float) > 0 else (a, c, b)


def write_stl(path, triangles):
    with open(path, "w", encoding="utf-8") as file:
        file.write("solid part\n")
        for corners in triangles:
            points = "".join("vertex %.6f %.6f %.6f\n" % tuple(point) for point in corners)
            file.write(f"facet normal 0 0 0\nouter loop\n{points}endloop\nendfacet\n")
        file.write("endsolid part\n")


def mm(values, digits=6):
    """Lengths as the value and the unit of a parameter."""
    return array(values, digits), "mm"


def array(values, digits=6):
    return "{" + ", ".join(f"{value:.{digits}g}" for value in values) + "}"


def xml(name, values, indent=""):
    """A list of parameters: numbers, texts, arrays, pairs (value, unit) and lists."""
    lines = [f'{indent}<ParameterList name="{name}">']
    for key, value in values.items():
        if isinstance(value, dict):
            lines.append(xml(key, value, indent + "  "))
            continue
        value, unit = value if isinstance(value, tuple) else (value, "")
        kind = {int: "int", float: "double", str: "Array(double)" if str(value).startswith("{") else "string"}[type(value)]
        unit = f' unit="{unit}"' if unit else ""
        lines.append(f'{indent}  <Parameter name="{key}" type="{kind}" value="{value}"{unit}/>')
    return "\n".join([*lines, f"{indent}</ParameterList>"])


def write_part(folder, name, triangles, cell, margin, scene):
    """Writes NAME.stl and NAME.xml. triangles: in mm; cell, margin: of the domain around the part [mm]; scene: the other sections"""
    write_stl(os.path.join(folder, f"{name}.stl"), triangles)
    points = triangles.reshape(-1, 3)
    domain = {"Dimension": 3, "Lower Corner": mm(points.min(axis=0) - margin), "Upper Corner": mm(points.max(axis=0) + margin), "Cell Size": (cell, "mm")}
    with open(os.path.join(folder, f"{name}.xml"), "w", encoding="utf-8") as file:
        file.write(xml("Rhegma", {"Domain": domain, **scene}) + "\n")


def body(material, name, **more):
    return {"Material": material, "Shape": "File", "File": f"{name}.stl", "Scale": (1.0, "mm"), **more}


STATIC = {"Analysis": "Static", "Final Time": (1.0, "s")}
FINE = {"Maximum Level": 2, "Front Cells": 4.0}


def axle(folder):
    """Shafts of 30 and 20 mm with a fillet of 4 mm, held at the thick end, a force of 5 kN across the thin one, 57 mm from the flaw."""
    turn, origin = turned(11)
    fillet = [(14 - 4 * np.cos(t), 39 - 4 * np.sin(t)) for t in np.linspace(np.pi / 2, 0, 13)]
    triangles = revolved([(0, 0), (15, 0), (15, 35), *fillet, (10, 95), (0, 95)], 72) @ turn.T + origin
    along, across, end = turn @ [0, 0, 1], turn @ [1, 0, 0], origin + turn @ [0, 0, 95]
    low, high = triangles.reshape(-1, 3).min(axis=0) - 4, triangles.reshape(-1, 3).max(axis=0) + 4
    axis = int(np.argmax(np.abs(along)))  # of the grid, the nearest to that of the axle
    (high if along[axis] > 0 else low)[axis] = (origin + turn @ [0, 0, 16])[axis]
    write_part(folder, "axle", triangles, 2.0, 4, {
        "Time": STATIC, "Materials": {"Steel": {"Material From Library": "4340 Steel Hard", "Model": "Linear Elastic"}},
        "Bodies": {"Axle": body("Steel", "axle")},
        "Boundaries": {
            "Seat": {"Type": "Velocity", "Lower Corner": mm(low), "Upper Corner": mm(high), "Value": "{0, 0, 0}"},
            "End": {"Type": "Traction", "Body": "Axle", "Surface": "Body", "Facing": array(along), "Largest Angle": 10.0,
                    "Lower Corner": mm(end - 11), "Upper Corner": mm(end + 11), "Stress": (array(5000 / (100 * np.pi) * across), "MPa")}},
        "Cracks": {"Flaw": {"Centre": mm(origin + turn @ [np.sqrt(15) - 14, 0, 38]), "Normal": array(along), "Radius": (3.0, "mm")}},
        "Adaptivity": FINE, "Energy Release": {"Toughness From Library": "4340 Steel Hard"}})


def bracket_triangles():
    """An angle of two plates, 10 mm thick, 60 mm long and 30 mm wide, with two holes of 6.6 mm along x in the upright one."""
    outline = [(10, 10), (10, 60), (0, 60), (0, 0), (60, 0), (60, 10)]  # (x, z), a fan from the first
    found = [facing([(x, y, z) for x, z in (outline[0], one, other)], (0, y - 15, 0)) for one, other in zip(outline[1:], outline[2:]) for y in (0, 30)]
    for (a, b), (c, d), outward in (((0, 0), (60, 0), (0, 0, -1)), ((60, 0), (60, 10), (1, 0, 0)), ((60, 10), (10, 10), (0, 0, 1)), ((10, 60), (0, 60), (0, 0, 1))):
        found += [facing(three, outward) for three in (((a, 0, b), (c, 0, d), (c, 30, d)), ((a, 0, b), (c, 30, d), (a, 30, b)))]
    angle = 2 * np.pi * np.arange(32) / 32
    rims = [np.c_[y + 3.3 * np.cos(angle), 45 + 3.3 * np.sin(angle)] for y in (8, 22)]
    for x, bottom, outward in ((0, 0, (-1, 0, 0)), (10, 10, (1, 0, 0))):
        points = np.concatenate([[(0, bottom), (30, bottom), (30, 60), (0, 60)], *rims])
        for corners in Triangulation(*points.T).triangles:
            if min(corners) < 4 or len({(corner - 4) // 32 for corner in corners}) > 1:  # not one within a hole
                found.append(facing([(x, *points[corner]) for corner in corners], outward))
    for rim in rims:
        for one, other in zip(rim, np.roll(rim, -1, axis=0)):
            inward = (0, *(rim.mean(axis=0) - one))
            found += [facing(three, inward) for three in (((0, *one), (0, *other), (10, *other)), ((0, *one), (10, *other), (10, *one)))]
    return np.array(found)


def bracket(folder):
    """The bracket on two bolts, with 2 kN on 8 x 20 mm of its shelf."""
    turn, origin = turned(23)
    triangles = bracket_triangles() @ turn.T + origin
    reach = 4.0 * np.sqrt(1 - turn[:, 0] ** 2)  # of a disk of 4 mm across the bolt, along each axis
    bolts = {}
    for number, y in ((1, 8), (2, 22)):
        ends = np.array([origin + turn @ [x, y, 45] for x in (0, 10)])
        bolts[f"Bolt {number}"] = {"Type": "Velocity", "Lower Corner": mm(ends.min(axis=0) - reach), "Upper Corner": mm(ends.max(axis=0) + reach),
                                   "Value": "{0, 0, 0}"}
    load = {"Type": "Traction", "Body": "Bracket", "Corner": mm(origin + turn @ [50, 5, 10], 9), "Edge 1": mm(turn @ [8, 0, 0], 9),
            "Edge 2": mm(turn @ [0, 20, 0], 9), "Stress": (array(12.5 * turn @ [0, 0, -1]), "MPa")}
    write_part(folder, "bracket", triangles, 1.5, 5, {
        "Time": STATIC, "Materials": {"Aluminium": {"Material From Library": "Aluminium 6061-T6", "Model": "Linear Elastic"}},
        "Bodies": {"Bracket": body("Aluminium", "bracket")}, "Boundaries": {**bolts, "Load": load},
        "Cracks": {"Flaw": {"Centre": mm(origin + turn @ [10, 15, 10]), "Normal": array(turn @ [1, 0, -1]), "Radius": (3.0, "mm")}},
        "Adaptivity": FINE, "Energy Release": {"Toughness From Library": "Aluminium 6061-T6"},
        "Measure": {"Extremes": {"Mises": {"Field": "Von Mises Stress"}}}})


def ring(folder):
    """A ring of 44 mm, with a bore of 28 mm, 8 mm high; 400 degC hot, and water of 20 degC on its outside."""
    turn, origin = turned(5)
    triangles = revolved([(14, 8), (14, 0), (22, 0), (22, 8)], 120, True) @ turn.T + origin
    path = np.array([origin + turn @ [x, y, z] for x in (13.7, 22.3) for y in (-2, 2) for z in (0, 8)])
    bore = {"Operation": "Cut", "Shape": "Cylinder", "From": mm(origin + turn @ [0, 0, -1]), "To": mm(origin + turn @ [0, 0, 9]), "Radius": (14.05, "mm")}
    write_part(folder, "ring", triangles, 1.2, 3, {
        "Time": {"Analysis": "Quasi-Static", "Rigid Modes": "Remove", "Final Time": (3.0, "s"), "Load Steps": 10},
        "Materials": {"Glass": {"Material From Library": "Soda-Lime Glass", "Reference Temperature": (400.0, "degC")}},
        "Bodies": {"Ring": body("Glass", "ring", Operations={"Bore": bore})},
        "Thermal": {"Initial Temperature": (400.0, "degC"), "Conduction": "Implicit"},
        "Boundaries": {"Water": {"Type": "Convection", "Body": "Ring", "Surface": "Body", "Part": "Base", "Around": array(turn @ [0, 0, 1]), "Largest Angle": 10.0,
                                 "Coefficient": 400.0, "Ambient Temperature": (20.0, "degC")}},
        "Cracks": {"Flaw": {"Centre": mm(origin + turn @ [22, 0, 4]), "Normal": array(turn @ [0, 1, 0]), "Radius": (2.4, "mm")}},
        "Adaptivity": {"Maximum Level": 1, "Front Cells": 0.0, "Path": {"Lower Corner": mm(path.min(axis=0)), "Upper Corner": mm(path.max(axis=0)), "Level": 1}},
        "Energy Release": {},
        "Propagation": {"Toughness From Library": "Soda-Lime Glass", "Load Control": "Functions of Time", "Increment": 1.0},
        "Measure": {"Pieces": {}, "Extremes": {"Heat": {"Field": "Temperature"}}}, "Output": {"Field Interval": (0.3, "s")}})


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    os.makedirs(sys.argv[1], exist_ok=True)
    for part in (axle, bracket, ring):
        part(sys.argv[1])
        print(f"Wrote {part.__name__}.stl and {part.__name__}.xml.")
