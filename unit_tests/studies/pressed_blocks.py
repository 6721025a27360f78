#!/usr/bin/env python3
"""Stiffness of a block that two rigid tools press slowly by 0.3 %, against its modulus.

    pressed_blocks.py PROGRAM [--number N] [--seed N] [--cells 8 16 32] [--bodies]

The lower face lies anywhere in its cell, and the height is a whole number of cells and a fraction. With --bodies the block is cut in half at a
random height, and the halves are bodies in contact.
"""
import argparse
import csv
import os
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "tools"))

from rhegma.scene import Scene  # noqa: E402

YOUNG, DENSITY, STRAIN, PERIODS = 1e9, 1000.0, 3e-3, 12.0


def block(pick, cells, bodies):
    """Scene, and the force of the block at the end [N]. Poisson's ratio is zero: the block is a bar."""
    low, width = pick.uniform(0.0, 1.0), 4.0
    high = low + cells + 0.5 * pick.randrange(2)
    height, side = high - low, pick.uniform(0.0, 1.0)
    time = PERIODS * 2.0 * height / (YOUNG / DENSITY) ** 0.5
    speed = STRAIN * height / time
    wall = {"Shape": "Box"}

    def part(bottom, top):
        return {"Material": "Solid", "Shape": "Box", "Lower Corner": [side, bottom], "Upper Corner": [side + width, top]}

    scene = {
        "Domain": {"Dimension": 2, "Cell Size": 1.0, "Lower Corner": [-4.0, -4.0], "Upper Corner": [10.0, high + 6.0]},
        "Time": {"Final Time": 1.25 * time},
        "Materials": {"Solid": {"Model": "Linear Elastic", "Density": DENSITY, "Young Modulus": YOUNG, "Poisson Ratio": 0.0}},
        "Bodies": {"Block": part(low, high)},
        "Damping": {"Mass Rate": 3.0 * PERIODS / time},
        "Rigid Tools": {
            "Floor": {**wall, "Lower Corner": [-3.0, low - 3.0], "Upper Corner": [9.0, low]},
            # Raised and stopped smoothly: 2 sin^2 has the mean 1.
            "Press": {**wall, "Lower Corner": [-3.0, high], "Upper Corner": [9.0, high + 3.0], "Velocity": [0.0, -speed],
                      "History": f"t < {time} ? 2*sin(pi*t/{time})^2 : 0"},
        },
        "Output": {"Fields": False, "Checkpoints": False, "History Interval": time / 40.0},
    }
    if bodies:
        cut = low + 0.5 * round(2.0 * height * pick.uniform(0.3, 0.7))
        scene["Bodies"] = {"Block": part(low, cut), "Upper": part(cut, high)}
        scene["Body Contact"] = {}
    return Scene(scene), YOUNG * STRAIN * width


def error(program, pick, cells, bodies):
    """Of the force, and the largest residual of the energy balance over the work [%]."""
    scene, exact = block(pick, cells, bodies)
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "block.xml"), os.path.join(folder, "out")
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene.text())
        subprocess.run([program, path, "--output", out, "--quiet"], check=True)
        with open(os.path.join(out, "history.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    forces = [0.5 * (float(row["Floor.force_y"]) - float(row["Press.force_y"])) for row in rows[-5:]]
    residual = max(abs(float(row["residual"])) for row in rows) / float(rows[-1]["external_work"])
    return 100 * (sum(forces) / len(forces) / exact - 1), 100 * residual


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--number", type=int, default=8)
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    parser.add_argument("--cells", type=int, nargs="+", default=[8, 16, 32])
    parser.add_argument("--bodies", action="store_true")
    arguments = parser.parse_args()
    print(f"seed {arguments.seed}, {arguments.number} blocks of each height")
    print("cells in the height; stiffness, least and largest error [%]; largest residual over the work [%]")
    for cells in arguments.cells:
        pick = random.Random(f"{arguments.seed} {cells}")
        found = [error(arguments.program, pick, cells, arguments.bodies) for _ in range(arguments.number)]
        errors = [stiffness for stiffness, _ in found]
        print(f"{cells:5d} {min(errors):8.2f} {max(errors):8.2f} {max(residual for _, residual in found):8.2f}", flush=True)


if __name__ == "__main__":
    main()
