#!/usr/bin/env python3
"""Surface cracks that grow in round bars, balls, at the edge of a box and in bars turned off the grid, anywhere in the cells.

    curved_surfaces.py PROGRAM [SEED [CELLS [FOLDER]]]

Each body has a half-width of CELLS cells (10). A disk that lies in part in the body is its crack: at a random position,
angle and size, under tension or bending by grips that are held from a random time on. Prints a row for each: exit status,
mean advance of the front [cells], fraction of the section that is cut, largest distance of the front from the circle that fits it best
[cells], lowest and median angle at which it meets the surface [degrees] over all fields, largest G/Gc of nodes more than a cell below the
surface at the end (- if there are none), the residual of the energy balance over the work of the loads and over the fracture energy
[%], and the front's status. With FOLDER the runs stay there, each with a picture of the crack at the times of its fields.
"""
import json
import math
import os
import random
import subprocess
import sys
import tempfile

try:
    import h5py
    import numpy
except ImportError:
    sys.exit("curved_surfaces.py needs numpy and h5py")

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "program"))
sys.dont_write_bytecode = True

from scenes import Scene  # noqa: E402

RADIUS = 0.01  # half the width of each body [m]
STEEL = {"Model": "Linear Elastic", "Density": 7800.0, "Young Modulus": 2.1e11, "Poisson Ratio": 0.3}
AT_REST = 2700.0  # toughness [J/m2]
TOUGHNESS = "%g*(1 + v/1000)" % AT_REST
TIME, EVERY = 6e-5, 3e-6


class Bar:
    """A round bar along a direction: the part of it between its ends."""

    def __init__(self, axis, half_length):
        self.axis, self.half_length = axis, half_length
        self.reach = half_length * numpy.abs(axis) + RADIUS * numpy.sqrt(1.0 - axis**2)
        self.grip = half_length * axis[2] - RADIUS * math.sqrt(1.0 - axis[2] ** 2)
        ends = [list(s * half_length * axis) for s in (-1, 1)]
        self.shape = {"Shape": "Cylinder", "From": ends[0], "To": ends[1], "Radius": RADIUS}

    def depth(self, x):
        """Depth of positions below the curved surface [m]."""
        return RADIUS - numpy.linalg.norm(x - numpy.outer(x @ self.axis, self.axis), axis=1)

    def section(self):
        return math.pi * RADIUS**2


class Ball:
    axis, reach, grip = numpy.array([0.0, 0.0, 1.0]), numpy.full(3, RADIUS), 0.6 * RADIUS
    shape = {"Shape": "Ball", "Centre": [0.0, 0.0, 0.0], "Radius": RADIUS}

    def depth(self, x):
        return RADIUS - numpy.linalg.norm(x, axis=1)

    def section(self):
        return math.pi * RADIUS**2


class Box:
    """A square bar; its cracks begin next to one of its edges, which their fronts meet."""

    axis, half_length = numpy.array([0.0, 0.0, 1.0]), 1.2 * RADIUS
    reach, grip = numpy.array([RADIUS, RADIUS, half_length]), half_length
    shape = {"Shape": "Box", "Lower Corner": list(-reach), "Upper Corner": list(reach)}

    def depth(self, x):
        return RADIUS - numpy.max(numpy.abs(x[:, :2]), axis=1)

    def section(self):
        return 4.0 * RADIUS**2


def across(axis, angle):
    """A unit vector across an axis, at an angle round it."""
    first = numpy.cross(axis, [0.0, 1.0, 0.0])
    first /= numpy.linalg.norm(first)
    return math.cos(angle) * first + math.sin(angle) * numpy.cross(axis, first)


def scene_of(body, load, cells, pick):
    """\\return the scene, and what was chosen, as text"""
    cell = RADIUS / cells
    around, off = pick.uniform(-math.pi, math.pi), math.radians(pick.uniform(-20, 20))
    tilt, depth, turn = math.radians(pick.uniform(-8, 8)), pick.uniform(0.25, 0.5) * RADIUS, pick.uniform(-math.pi, math.pi)
    height, held = pick.uniform(-0.5, 0.5) * cell, pick.uniform(2.2e-5, 4e-5)
    towards = across(body.axis, around)
    centre = RADIUS * towards
    if isinstance(body, Box):  # next to an edge
        along = pick.uniform(0.35, 0.9)
        centre = RADIUS * numpy.array([1.0, along, 0.0])
        towards = numpy.array([1.0, 0.0, 0.0])
    centre = centre + height * body.axis
    normal = math.cos(tilt) * body.axis + math.sin(tilt) * across(body.axis, turn)
    low = [pick.uniform(-0.5, 0.5) * cell - r - 3 * cell for r in body.reach]
    high = [l + (math.ceil((2 * r + 6 * cell) / cell) + 1) * cell for l, r in zip(low, body.reach)]
    side = math.cos(off) * towards + math.sin(off) * numpy.cross(body.axis, towards)
    scene = Scene(
        {
            "Domain": {"Dimension": 3, "Lower Corner": low, "Upper Corner": high, "Cell Size": cell},
            "Time": {"Final Time": TIME},
            "Materials": {"Steel": STEEL},
            "Bodies": {"Body": {"Material": "Steel", **body.shape}},
            "Boundaries": {},
            "Cracks": {"Flaw": {"Centre": list(centre), "Normal": list(normal), "Radius": depth}},
            "Energy Release": {},
            "Propagation": {"Toughness": TOUGHNESS},
            "Output": {"History Interval": 1e-6, "Field Interval": EVERY},
        }
    )
    for name, sign in (("Top", 1), ("Bottom", -1)):
        lower, upper = list(low), list(high)
        if sign > 0:
            lower[2] = body.grip - 1.5 * cell
        else:
            upper[2] = 1.5 * cell - body.grip
        factor = "1" if load == "tension" else "(%r*x + %r*y + %r*z)" % tuple(float(s) / RADIUS for s in side)
        scene.set("Boundaries > " + name, {"Type": "Velocity", "Lower Corner": lower, "Upper Corner": upper,
                                          "Field": ", ".join("%r*%s" % (sign * 2.5 * float(a), factor) for a in body.axis),
                                          "History": "0:0, 1.5e-5:1, %r:1, %r:0, 1:0" % (held, held + 5e-6)})
    return scene, "%7.1f deg round, depth %.2f, tilt %5.1f, load off %5.1f deg, held from %.1f us" % (
        math.degrees(around), depth / RADIUS, math.degrees(tilt), math.degrees(off), 1e6 * held)


def borders(points, cells):
    """Edges of one triangle only."""
    count = {}
    for t in cells:
        for i in range(3):
            edge = (int(t[i]), int(t[(i + 1) % 3]))
            count.setdefault(tuple(sorted(edge)), []).append(edge)
    return [edges[0] for edges in count.values() if len(edges) == 1]


def fronts(body, points, cells, cell):
    """Chains of the edges of a crack that lie in the body, longer than two pieces."""
    inner = [e for e in borders(points, cells) if body.depth(points[list(e)]).max() > 0.6 * cell]
    after = dict(inner)
    starts = [a for a in after if a not in after.values()]
    chains = []
    for start in starts:
        chain = [start]
        while chain[-1] in after and len(chain) <= len(after):
            chain.append(after[chain[-1]])
        if len(chain) > 3:
            chains.append(points[chain])
    return chains


def circle_off(chain, axis):
    """Largest distance of a front from the circle that fits it best [m], and its radius."""
    u = across(axis, 0.0)
    flat = numpy.column_stack([chain @ u, chain @ numpy.cross(axis, u)])
    matrix = numpy.column_stack([2 * flat, numpy.ones(len(flat))])
    x, y, c = numpy.linalg.lstsq(matrix, (flat**2).sum(axis=1), rcond=None)[0]
    radius = math.sqrt(max(c + x * x + y * y, 0.0))
    return numpy.abs(numpy.linalg.norm(flat - [x, y], axis=1) - radius).max()


def meets_at(body, chain, cell):
    """Angles between a front and the surface at both ends [degrees], of the pieces within two cells of it."""
    angles = []
    for line in (chain, chain[::-1]):
        far = next((x for x in line if numpy.linalg.norm(x - line[0]) > 2 * cell), line[-1])
        along = far - line[0]
        steps = 1e-4 * cell * numpy.eye(3)
        gradient = numpy.array([body.depth((0.999 * line[0] + s)[None])[0] - body.depth((0.999 * line[0] - s)[None])[0] for s in steps])
        angles.append(math.degrees(math.asin(min(1.0, gradient @ along / numpy.linalg.norm(gradient) / numpy.linalg.norm(along)))))
    return angles


def frames(folder):
    """Points and triangles of the crack at the times of the fields."""
    with h5py.File(os.path.join(folder, "fields.h5"), "r") as file:
        return [(file[name]["cracks/points"][()], file[name]["cracks/cells"][()]) for name in sorted(file) if "cracks" in file[name]]


def area_of(points, cells):
    corner = points[cells]
    return 0.5 * numpy.linalg.norm(numpy.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1).sum()


def picture(body, states, cell, title, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    u = across(body.axis, 0.0)
    v = numpy.cross(body.axis, u)
    figure, (plan, side) = pyplot.subplots(1, 2, figsize=(13, 7))
    for k, (points, cells) in enumerate(states):
        colour = pyplot.cm.viridis(k / max(1, len(states) - 1))
        for a, b in borders(points, cells):
            ends = points[[a, b]]
            plan.plot(1e3 * ends @ u, 1e3 * ends @ v, "-", color=colour, lw=1)
            side.plot(1e3 * ends @ u, 1e3 * ends @ body.axis, "-", color=colour, lw=1)
    if isinstance(body, Box):
        plan.plot(*(1e3 * RADIUS * numpy.array([[1, 1, -1, -1, 1], [1, -1, -1, 1, 1]])), "k-", lw=0.7)
    else:
        t = numpy.linspace(0, 2 * math.pi, 200)
        plan.plot(1e3 * RADIUS * numpy.cos(t), 1e3 * RADIUS * numpy.sin(t), "k-", lw=0.7)
    for axes in (plan, side):
        axes.set_aspect("equal")
    figure.suptitle(title, fontsize=9)
    figure.savefig(path, dpi=70)
    pyplot.close(figure)


def measure(program, body, scene, cell, folder):
    file = os.path.join(folder, "scene.xml")
    with open(file, "w") as out:
        out.write(scene.text())
    done = subprocess.run([program, file, "--quiet", "--output", os.path.join(folder, "out")], capture_output=True, text=True,
                          env=dict(os.environ, OMP_NUM_THREADS=os.environ.get("OMP_NUM_THREADS", "1")))
    with open(os.path.join(folder, "out", "summary.json")) as text:
        summary = json.load(text)
    states = frames(os.path.join(folder, "out"))
    chains = [c for state in states for c in fronts(body, *state, cell)[:1]]
    grown = [c for c in chains if body.depth(c).max() < 1.2 * RADIUS]
    front = summary["cracks"][0]["fronts"][0]
    energy, growth = summary["energy"], summary["propagation"]
    angles = [a for c in grown for a in meets_at(body, c, cell)]
    nodes = front.get("front_nodes", {"G_J": [], "position": []})
    inside = [g for g, x in zip(nodes["G_J"], nodes["position"]) if body.depth(numpy.array([x]))[0] > cell]
    last = states[-1]
    return summary, states, {
        "exit": done.returncode, "status": front["status"], "advance": front["mean_advance"] / cell, "cut": area_of(*last) / body.section(),
        "off": max((circle_off(c, body.axis) for c in grown), default=0.0) / cell,
        "low": min(angles, default=float("nan")), "median": numpy.median(angles) if angles else float("nan"),
        "drive": "%.2f" % (max(inside) / AT_REST) if inside else "-",
        "of_work": 100 * energy["residual"] / energy["external_work"] if energy["external_work"] else 0.0,
        "of_fracture": 100 * energy["residual"] / energy["fracture"] if energy["fracture"] else 0.0,
        "messages": done.stderr,
    }


def bodies(pick):
    for k in range(6):
        yield "axle", Bar(numpy.array([0.0, 0.0, 1.0]), 1.2 * RADIUS), ("bending", "tension")[k % 2]
    for load in ("tension", "bending"):
        yield "ball", Ball(), load
        yield "corner", Box(), load
        lean, round_z = math.radians(pick.uniform(10, 25)), pick.uniform(-math.pi, math.pi)
        axis = numpy.array([math.sin(lean) * math.cos(round_z), math.sin(lean) * math.sin(round_z), math.cos(lean)])
        yield "turned bar", Bar(axis, 1.7 * RADIUS), load


def main():
    arguments = sys.argv[1:]
    seed = int(arguments[1]) if len(arguments) > 1 else 5
    cells = int(arguments[2]) if len(arguments) > 2 else 10
    keep = arguments[3] if len(arguments) > 3 else None
    pick = random.Random(seed)
    print("seed %d, %d cells a radius" % (seed, cells))
    print("%2s %-10s %-7s %4s %8s %5s %6s %5s %6s %5s %7s %8s %7s  %s" % (
        "", "body", "load", "exit", "cells", "cut", "circle", "low", "median", "G/Gc", "of work", "of fract", "wall s", "status"))
    for k, (name, body, load) in enumerate(bodies(pick)):
        scene, chosen = scene_of(body, load, cells, pick)
        with tempfile.TemporaryDirectory() as scratch:
            folder = os.path.join(keep, "%02d" % k) if keep else scratch
            os.makedirs(folder, exist_ok=True)
            summary, states, row = measure(arguments[0], body, scene, RADIUS / cells, folder)
            if keep:
                picture(body, states, RADIUS / cells, "%s, %s, %s: %s" % (name, load, chosen, row["status"]),
                        os.path.join(keep, "%02d.png" % k))
        print("%2d %-10s %-7s %4d %8.2f %5.2f %6.2f %5.0f %6.0f %5s %7.2f %8.1f %7.1f  %s\n   %s" % (
            k, name, load, row["exit"], row["advance"], row["cut"], row["off"], row["low"], row["median"], row["drive"], row["of_work"],
            row["of_fracture"], summary["wall_seconds"], row["status"], chosen), flush=True)
        for line in row["messages"].splitlines():
            if "stopped" in line:
                print("   " + line[:300], flush=True)


if __name__ == "__main__":
    main()
