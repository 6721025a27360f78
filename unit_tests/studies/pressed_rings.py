#!/usr/bin/env python3
"""Errors of the radial displacement of rings under pressure on the wall of their hole, against Lamé's solution in plane strain.

    pressed_rings.py PROGRAM [--number N] [--seed N] [--cells 5 11 22]     cells in the outer radius, drawn up to a fifth more

The middle of each ring lies anywhere in its cell, and the inner radius is 0.4 to 0.6 of the outer one.
"""
import argparse
import os
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "tools"))

import h5py  # noqa: E402
import numpy  # noqa: E402
from rhegma.scene import Scene  # noqa: E402

YOUNG, POISSON, PRESSURE, CELL = 3e9, 0.3, 1e6, 1e-3


def ring(middle, outer, inner):
    return Scene({
        "Domain": {"Dimension": 2, "Plane": "Strain", "Lower Corner": [-1.25 * outer] * 2, "Upper Corner": [1.25 * outer] * 2, "Cell Size": CELL},
        "Time": {"Analysis": "Static", "Final Time": 1.0, "Rigid Modes": "Remove"},
        "Materials": {"Polymer": {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": YOUNG, "Poisson Ratio": POISSON}},
        "Bodies": {"Ring": {"Material": "Polymer", "Shape": "Ball", "Centre": middle, "Radius": outer,
                            "Operations": {"Bore": {"Operation": "Cut", "Shape": "Ball", "Centre": middle, "Radius": inner}}}},
        "Boundaries": {"Gas": {"Type": "Traction", "Body": "Ring", "Surface": "Body", "Part": "Bore", "Pressure": PRESSURE}},
    })


def errors(program, pick, cells):
    """Of the mean radial displacement, and the largest of a particle, over the largest displacement [%]."""
    outer = CELL * cells * pick.uniform(1.0, 1.2)
    inner, middle = outer * pick.uniform(0.4, 0.6), [CELL * pick.uniform(-0.5, 0.5) for _ in range(2)]
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "ring.xml"), os.path.join(folder, "out")
        with open(path, "w", encoding="utf-8") as file:
            file.write(ring(middle, outer, inner).text())
        subprocess.run([program, path, "--output", out, "--quiet"], check=True)
        with h5py.File(os.path.join(out, "fields.h5"), "r") as file:
            last = file[sorted(group for group in file if "particles" in file[group])[-1]]["particles"]
            position, displacement, mass = (last[name][()] for name in ("position", "displacement", "mass"))
    start = (position - displacement)[:, :2] - middle
    radius = numpy.linalg.norm(start, axis=1)
    found = (displacement[:, :2] * start).sum(axis=1) / radius
    factor = (1 + POISSON) / YOUNG * PRESSURE * inner**2 / (outer**2 - inner**2)
    exact = factor * ((1 - 2 * POISSON) * radius + outer**2 / radius)
    return 100 * ((mass @ found) / (mass @ exact) - 1), 100 * numpy.abs(found - exact).max() / exact.max()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--number", type=int, default=8)
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    parser.add_argument("--cells", type=int, nargs="+", default=[5, 11, 22])
    arguments = parser.parse_args()
    print(f"seed {arguments.seed}, {arguments.number} rings of each size")
    print("cells in the outer radius; mean displacement, least and largest error [%]; worst particle [%]")
    for cells in arguments.cells:
        pick = random.Random(f"{arguments.seed} {cells}")
        found = [errors(arguments.program, pick, cells) for _ in range(arguments.number)]
        means = [mean for mean, _ in found]
        print(f"{cells:5d} {min(means):8.2f} {max(means):8.2f} {max(worst for _, worst in found):8.2f}", flush=True)


if __name__ == "__main__":
    main()
