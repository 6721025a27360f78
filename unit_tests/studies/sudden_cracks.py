#!/usr/bin/env python3
"""The largest K_I of a crack that appears suddenly in a plate in equilibrium, against xml_inputs/references/sudden_crack.py.

    sudden_cracks.py PROGRAM [SEED [NUMBER [CELLS ...]]]        cells along half the crack; 4, 8 and 16 by default

A square plate of 8 half lengths of the crack is in equilibrium under tension before (Initial State = Equilibrium Without Cracks). The
crack is anywhere in its cells; every second plate is turned, too. Prints the error of the largest K_I of both fronts in percent of the
reference's largest, and the largest error of K_I(t) from the arrival of the first waves of the other tip on, in percent of the same."""

import csv
import json
import math
import os
import random
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "program"), os.path.join(HERE, "../../xml_inputs/references")]

import numpy  # noqa: E402
from scenes import Scene  # noqa: E402
from sudden_crack import SIZE, UNTIL, curves  # noqa: E402

YOUNG, POISSON, DENSITY, STRESS, HALF = 7e10, 0.22, 2500.0, 1e6, 4e-3
WAVES = math.sqrt(YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON)) / DENSITY)


def plate(rng, cells, turned):
    cell = HALF / cells
    angle = rng.uniform(0.0, math.pi / 2) if turned else 0.0
    c, s = math.cos(angle), math.sin(angle)
    shift = [rng.uniform(0.0, cell), rng.uniform(0.0, cell)]

    def at(x, y):
        return [shift[0] + c * x - s * y, shift[1] + s * x + c * y]

    edge = SIZE * HALF
    corners = [at(-edge, -edge), at(edge, -edge), at(edge, edge), at(-edge, edge)]
    span = edge * (abs(c) + abs(s)) + 4 * cell
    boundaries = {}
    for name, (a, b), sign in (("Bottom", (0, 1), -1), ("Top", (2, 3), 1)):
        boundaries[name] = {"Type": "Traction", "Body": "Plate", "From": corners[a], "To": corners[b],
                            "Stress": [-s * sign * STRESS, c * sign * STRESS]}
    return Scene({
        "Domain": {"Dimension": 2, "Plane": "Strain", "Cell Size": cell,
                   "Lower Corner": [-cell * math.ceil(span / cell)] * 2, "Upper Corner": [cell * math.ceil(span / cell)] * 2},
        "Time": {"Final Time": (UNTIL - 0.05) * HALF / WAVES, "Initial State": "Equilibrium Without Cracks", "Rigid Modes": "Remove"},
        "Materials": {"Glass": {"Model": "Linear Elastic", "Density": DENSITY, "Young Modulus": YOUNG, "Poisson Ratio": POISSON}},
        "Bodies": {"Plate": {"Material": "Glass", "Shape": "Polygon", "Points": [x for corner in corners for x in corner]}},
        "Boundaries": boundaries,
        "Cracks": {"Cut": {"Points": at(-HALF, 0.0) + at(HALF, 0.0)}},
        "Energy Release": {},
        "Output": {"Fields": False, "History Interval": 0.02 * HALF / WAVES},
    })


def run(program, scene):
    """(times [half length / speed of waves], K_I of both fronts [stress sqrt(pi a)])"""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "plate.xml")
        with open(path, "w") as file:
            file.write(scene.text())
        done = subprocess.run([program, path, "--quiet", "--output", os.path.join(folder, "out")], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit("exit status %d\n%s" % (done.returncode, done.stderr))
        with open(os.path.join(folder, "out", "history.csv")) as file:
            rows = list(csv.DictReader(file))
    columns = [key for key in rows[0] if key.endswith("K_I")]
    time = next(key for key in rows[0] if key.startswith("time"))
    unit = STRESS * math.sqrt(math.pi * HALF)
    return ([float(row[time]) * WAVES / HALF for row in rows],
            [[float(row[key] or "nan") / unit for row in rows] for key in columns])


def main():
    program = sys.argv[1]
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    number = int(sys.argv[3]) if len(sys.argv) > 3 else 4
    sizes = [int(n) for n in sys.argv[4:]] or [4, 8, 16]
    times, found, rest = curves(POISSON, [32, 64])
    right = found[-1]
    print("seed %d; reference: largest K_I %.4f, at rest %.4f" % (seed, right.max(), rest))
    print(" cells  turned   largest K_I: error of both fronts [%]   K_I(t) from 1.0 on, largest error [%]")
    for cells in sizes:
        worst = 0.0
        for k in range(number):
            t, fronts = run(program, plate(random.Random(1000 * seed + k), cells, k % 2 == 1))
            peaks = [100.0 * (max(one) / right.max() - 1.0) for one in fronts]
            later = times >= 1.0
            off = max(100.0 * numpy.nanmax(abs(numpy.interp(times, t, one) - right)[later]) / right.max() for one in fronts)
            worst = max(worst, *(abs(p) for p in peaks))
            print("  %3d    %-5s   %s      %.2f" % (cells, "yes" if k % 2 else "no", "  ".join("%+.2f" % p for p in peaks), off), flush=True)
        print("  %3d    worst of the largest: %.2f %%" % (cells, worst))


if __name__ == "__main__":
    main()
