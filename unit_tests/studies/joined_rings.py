#!/usr/bin/env python3
"""Pressure between two rings of different stiffness that an interface joins, under a slow pressure in the bore, against Lamé's solution.

    joined_rings.py PROGRAM [--number N] [--seed N] [--cells 12 20]     cells in the radius of the interface, drawn up to a fifth more

The middle lies anywhere in its cell. The rings are in plane strain; u is the displacement at the interface of either ring. With the pressure p in
the bore and q between the rings, u of the outer ring less u of the inner ring is -q / D, with D the stiffness of the interface.
"""
import argparse
import json
import math
import os
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "tools"))

from rhegma.scene import Scene  # noqa: E402

YOUNG, POISSON, DENSITY, PRESSURE, CELL = 1e9, 0.3, 1000.0, 1e6, 1e-3


def radial(young, inner, outer, inside, outside, r):
    """Displacement of a ring under a pressure inside and one outside [m]."""
    return (1 + POISSON) / young / (outer**2 - inner**2) * (
        (1 - 2 * POISSON) * (inside * inner**2 - outside * outer**2) * r + (inside - outside) * inner**2 * outer**2 / r)


def between(bore, joint, outer, young, stiffness):
    """Pressure between the rings [Pa]: everything is linear in it."""
    def mismatch(q):
        return radial(young, joint, outer, q, 0.0, joint) - radial(YOUNG, bore, joint, PRESSURE, q, joint) + q / stiffness
    return -mismatch(0.0) / (mismatch(1.0) - mismatch(0.0))


def error(program, pick, cells):
    joint = CELL * cells * pick.uniform(1.0, 1.2)
    bore, outer, middle = 0.6 * joint, 1.5 * joint, [CELL * pick.uniform(-0.5, 0.5) for _ in range(2)]
    young, stiffness = YOUNG * pick.uniform(0.5, 3.0), YOUNG / CELL * 10.0 ** pick.uniform(-1.5, 1.0)
    time = 30.0 * outer / (YOUNG / DENSITY) ** 0.5

    def solid(modulus):
        return {"Model": "Linear Elastic", "Density": DENSITY, "Young Modulus": modulus, "Poisson Ratio": POISSON}

    def ring(material, outside, inside):
        return {"Material": material, "Shape": "Ball", "Centre": middle, "Radius": outside,
                "Operations": {"Bore": {"Operation": "Cut", "Shape": "Ball", "Centre": middle, "Radius": inside}}}

    scene = Scene({
        "Domain": {"Dimension": 2, "Plane": "Strain", "Lower Corner": [-1.25 * outer] * 2, "Upper Corner": [1.25 * outer] * 2, "Cell Size": CELL},
        "Time": {"Final Time": 1.3 * time},
        "Materials": {"Inner": solid(YOUNG), "Outer": solid(young)},
        "Bodies": {"Inner": ring("Inner", joint, bore), "Outer": ring("Outer", outer, joint)},
        "Boundaries": {"Gas": {"Type": "Traction", "Body": "Inner", "Surface": "Body", "Part": "Bore", "Pressure": PRESSURE,
                               "History": f"t < {time} ? sin(pi*t/{2.0 * time})^2 : 1"}},
        "Damping": {"Mass Rate": 30.0 / time},
        "Body Contact": {"Fit": {"Bodies": "Inner, Outer", "Law": "Interface", "Normal Stiffness": stiffness, "Tangential Stiffness": stiffness}},
        "Output": {"Fields": False, "Checkpoints": False, "History Interval": time / 20.0},
    })
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "rings.xml"), os.path.join(folder, "out")
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene.text())
        subprocess.run([program, path, "--output", out, "--quiet"], check=True)
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            stored = json.load(file)["energy"]["interfaces"]
    # The energy of the springs is q^2 / (2 D) times their area.
    return 100 * (math.sqrt(2.0 * stored * stiffness / (2.0 * math.pi * joint)) / between(bore, joint, outer, young, stiffness) - 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--number", type=int, default=4)
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    parser.add_argument("--cells", type=int, nargs="+", default=[12, 20])
    arguments = parser.parse_args()
    print(f"seed {arguments.seed}, {arguments.number} pairs of rings of each size")
    print("cells in the radius; pressure between the rings, least and largest error [%]")
    for cells in arguments.cells:
        pick = random.Random(f"{arguments.seed} {cells}")
        found = [error(arguments.program, pick, cells) for _ in range(arguments.number)]
        print(f"{cells:5d} {min(found):8.2f} {max(found):8.2f}", flush=True)


if __name__ == "__main__":
    main()
