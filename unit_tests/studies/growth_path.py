#!/usr/bin/env python3
"""Path of equilibrium of a double cantilever beam whose crack grows at constant toughness, anywhere in the cells.

    growth_path.py PROGRAM [SEED [CELLS [INCREMENT]]]

The scene is xml_inputs/verification/dcb_growth_static.xml with CELLS an arm (8) and increments of INCREMENT cells (0.1). The
beam lies at random positions and angles in its cells. Prints a row for each: largest error of the force and of the
displacement of the loads over the path against quadratic finite elements (good to 0.1 %), the largest deviation of the force and the largest
jump of G at fixed load between two increments from a smooth curve (a cubic of the logarithms), rises of the force, and the
residual of the energy balance over the energy of the new faces.
"""
import csv
import json
import math
import os
import random
import subprocess
import sys
import tempfile

try:
    import numpy
except ImportError:
    sys.exit("growth_path.py needs numpy")

SCENE = os.environ.get("SCENE") or os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../xml_inputs/verification/dcb_growth_static.xml")
DEPTH, LENGTH, START, GROWN = 0.01, 0.1, 0.04, 0.008
# Length of the crack [m]: force on each arm [N] and displacement of each [m] at G = 100 J/m2, by elements of eight nodes, P C(a)
# and dC/da of a spline through C, extrapolated from 8 and 16 elements an arm.
EXACT = {0.036: (3700.46, 0.000384862), 0.042: (3244.54, 0.000500516), 0.048: (2888.88, 0.000631419),
         0.054: (2603.56, 0.000777491), 0.06: (2369.41, 0.000938708), 0.066: (2173.93, 0.00111512)}


def smooth(x, y):
    """The cubic of the logarithms through points, as a function."""
    fit = numpy.polyfit(numpy.log(x), numpy.log(y), 3)
    return lambda at: numpy.exp(numpy.polyval(fit, numpy.log(at)))


def turned(points, angle, shift):
    """Points of the beam [m], turned about its middle and shifted, as the scene writes them."""
    c, s = math.cos(angle), math.sin(angle)
    middle = (0.5 * LENGTH, DEPTH)
    placed = []
    for x, y in points:
        dx, dy = x - middle[0], y - middle[1]
        placed += [middle[0] + c * dx - s * dy + shift[0], middle[1] + s * dx + c * dy + shift[1]]
    return "{%s}" % ", ".join("%.15g" % value for value in placed)


def settings(cells, increment, angle, along, up):
    """The parameters of a beam at `along` and `up` of a cell, turned by an angle [rad]."""
    cell = DEPTH / cells
    reach = [0.5 * (LENGTH * abs(math.cos(angle)) + 2 * DEPTH * abs(math.sin(angle))) + 4 * cell,
             0.5 * (LENGTH * abs(math.sin(angle)) + 2 * DEPTH * abs(math.cos(angle))) + 4 * cell]
    reach = [cell * math.ceil(r / cell) for r in reach]
    shift = (along * cell, up * cell)
    force = 1000.0
    sets = {
        "Domain:Cell Size": "%.15g" % cell,
        "Domain:Lower Corner": "{%.15g, %.15g}" % (0.5 * LENGTH - reach[0], DEPTH - reach[1]),
        "Domain:Upper Corner": "{%.15g, %.15g}" % (0.5 * LENGTH + reach[0] + cell, DEPTH + reach[1] + cell),
        "Bodies:Beam:Lower Corner": "{%.15g, %.15g}" % shift,
        "Bodies:Beam:Upper Corner": "{%.15g, %.15g}" % (LENGTH + shift[0], 2 * DEPTH + shift[1]),
        "Bodies:Beam:Rotation": "%.15g" % math.degrees(angle),
        "Cracks:Notch:Points": turned([(0, DEPTH), (START, DEPTH)], angle, shift),
        "Propagation:Increment": repr(increment),
        "Time:Load Steps": str(1 + round(GROWN / (increment * cell))),
    }
    for arm, low, sign in (("Upper", DEPTH, 1), ("Lower", 0.0, -1)):
        sets["Boundaries:%s Arm:From" % arm] = turned([(0, low)], angle, shift)
        sets["Boundaries:%s Arm:To" % arm] = turned([(0, low + DEPTH)], angle, shift)
        sets["Boundaries:%s Arm:Force" % arm] = "{%.15g, %.15g}" % (-sign * force * math.sin(angle), sign * force * math.cos(angle))
    return sets


def run(program, sets):
    with tempfile.TemporaryDirectory() as folder:
        command = [program, SCENE, "--output", folder, "--quiet"]
        for name, value in sets.items():
            command += ["--set", "%s=%s" % (name, value)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 4):
            raise RuntimeError(done.stderr)
        with open(os.path.join(folder, "history.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        with open(os.path.join(folder, "summary.json")) as file:
            return {name: numpy.array([float(row[name]) for row in rows]) for name in rows[0]}, json.load(file)


def measure(column, summary):
    a, force = column["Notch.0.length"], 1000.0 * column["load_factor"]
    moved = 0.5 * (column["Upper Arm.displacement"] + column["Lower Arm.displacement"])
    lengths = numpy.array(sorted(EXACT))
    exact = [smooth(lengths, numpy.array([EXACT[x][k] for x in lengths])) for k in (0, 1)]
    off = numpy.log(force / smooth(a, force)(a))  # G at fixed load is as the inverse square of the force
    fracture = column["fracture"][-1]
    return {"force": 100 * numpy.max(numpy.abs(force / exact[0](a) - 1)), "moved": 100 * numpy.max(numpy.abs(moved / exact[1](a) - 1)),
            "saw": 100 * numpy.max(numpy.abs(off)), "jump": 200 * numpy.max(numpy.abs(numpy.diff(off))),
            "rises": int(numpy.sum(numpy.diff(force) > 0)),
            "residual": 100 * (column["residual"][-1] - column["residual"][0]) / fracture, "seconds": summary["wall_seconds"],
            "steps": len(a)}


def main():
    arguments = sys.argv[1:]
    seed = int(arguments[1]) if len(arguments) > 1 else 11
    cells = int(arguments[2]) if len(arguments) > 2 else 8
    increment = float(arguments[3]) if len(arguments) > 3 else 0.1
    pick = random.Random(seed)
    print("seed %d, %d cells an arm, increments of %g cells" % (seed, cells, increment))
    cases = [(0.0, 0.0, 0.0), (0.0, pick.random(), 0.0)]
    cases += [(0.0, pick.random(), pick.random()) for _ in range(3)]
    cases += [(math.radians(pick.uniform(1, 45)), pick.random(), pick.random()) for _ in range(3)]
    print("%7s %6s %6s %8s %8s %8s %8s %6s %10s %6s %8s" % ("degrees", "along", "up", "force %", "displ. %", "saw %", "jump G %",
                                                           "rises", "residual %", "steps", "wall s"))
    for angle, along, up in cases:
        row = measure(*run(arguments[0], settings(cells, increment, angle, along, up)))
        print("%7.2f %6.3f %6.3f %8.2f %8.2f %8.3f %8.3f %6d %10.2f %6d %8.1f" %
              (math.degrees(angle), along, up, row["force"], row["moved"], row["saw"], row["jump"], row["rises"], row["residual"], row["steps"],
               row["seconds"]), flush=True)


if __name__ == "__main__":
    main()
