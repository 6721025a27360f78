#!/usr/bin/env python3
"""A rigid cylinder that is pressed slowly on an elastic block, against Hertz's pressure and half width.

    pressed_cylinders.py PROGRAM [--number N] [--seed N] [--cells 8 16] [--ratio 0.05]
                                                                  cells in the half width; half width over radius

The face of the block lies anywhere in its cell. The load per length is that of a half width a on a half space with E* = E / (1 - nu^2):
P = pi a^2 E* / (4 R), and the pressure is p0 sqrt(1 - (x / a)^2), p0 = 2 P / (pi a). It is compared with the mean stress of the cells at the face.
"""
import argparse
import csv
import math
import os
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "tools"))

import h5py  # noqa: E402
import numpy  # noqa: E402
from rhegma.scene import Scene  # noqa: E402

YOUNG, POISSON, DENSITY = 1e9, 0.3, 1000.0


def pressed(pick, cells, ratio):
    """Scene in cells of 1 m; radius and load are such that the half width is `cells`."""
    radius, wide, deep = cells / ratio, round(12 * cells), round(6 * cells)
    load = math.pi * cells**2 * YOUNG / (1.0 - POISSON**2) / (4.0 * radius)
    left, face = pick.uniform(0.0, 1.0), pick.uniform(0.0, 1.0)
    middle = left + 0.5 * wide + pick.uniform(-0.5, 0.5)
    speed = math.sqrt(YOUNG * (1.0 - POISSON) / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON)) / DENSITY)
    rise = 6.0 * deep / speed
    scene = Scene({
        "Domain": {"Dimension": 2, "Plane": "Strain", "Cell Size": 1.0, "Lower Corner": [-4.0, -deep - 4.0], "Upper Corner": [wide + 6.0, 8.0]},
        "Time": {"Final Time": 1.6 * rise},
        "Materials": {"Solid": {"Model": "Linear Elastic", "Density": DENSITY, "Young Modulus": YOUNG, "Poisson Ratio": POISSON}},
        "Bodies": {"Block": {"Material": "Solid", "Shape": "Box", "Lower Corner": [left, face - deep], "Upper Corner": [left + wide, face]}},
        "Boundaries": {"Base": {"Type": "Velocity", "Components": "xy", "Value": [0.0, 0.0], "Lower Corner": [-9.0, -deep - 9.0],
                                "Upper Corner": [wide + 9.0, face - deep + 1.0]}},
        "Damping": {"Mass Rate": 6.0 / rise},
        "Rigid Tools": {"Roller": {"Shape": "Ball", "Centre": [middle, face + radius + 1e-3], "Radius": radius, "Mass": 0.2 * DENSITY * deep**2,
                                   "Components": "y", "Force": [0.0, -load],
                                   "Force History": f"t < {rise} ? sin(pi*t/{2.0 * rise})^2 : 1"}},
        "Output": {"Checkpoints": False, "History Interval": rise / 50.0, "Field Interval": 1.6 * rise},
    })
    return scene, middle, face, 2.0 * load / (math.pi * cells)


def errors(program, pick, cells, ratio):
    """Of the half width and p0 of the ellipse through the pressure over the middle 80 %, and the largest deviation there over p0 [%]."""
    scene, middle, face, highest = pressed(pick, cells, ratio)
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "pressed.xml"), os.path.join(folder, "out")
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene.text())
        subprocess.run([program, path, "--output", out, "--quiet"], check=True)
        with open(os.path.join(out, "history.csv"), encoding="utf-8") as file:
            residual = max(abs(float(row["residual"])) / float(row["strain"] or 1) for row in list(csv.DictReader(file))[-20:])
        with h5py.File(os.path.join(out, "fields.h5"), "r") as file:
            last = file[sorted(group for group in file if "particles" in file[group])[-1]]["particles"]
            position, displacement, stress = (last[name][()] for name in ("position", "displacement", "stress"))
    row = face - (position - displacement)[:, 1] < 1.0
    x, pressure = position[row, 0] - middle, -stress[row, 1]
    column = numpy.round(x).astype(int)
    columns = [column == number for number in range(int(-0.8 * cells), int(0.8 * cells) + 1)]
    x, pressure = (numpy.array([values[chosen].mean() for chosen in columns]) for values in (x, pressure))
    slope, square = numpy.polyfit(x**2, pressure**2, 1)  # p^2 = p0^2 - (p0 / a)^2 x^2
    exact = highest * numpy.sqrt(1.0 - (x / cells) ** 2)
    return [100 * value for value in (math.sqrt(-square / slope) / cells - 1, math.sqrt(square) / highest - 1,
                                      numpy.abs(pressure - exact).max() / highest, residual)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--number", type=int, default=3)
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    parser.add_argument("--cells", type=int, nargs="+", default=[8, 16])
    parser.add_argument("--ratio", type=float, default=0.05)
    arguments = parser.parse_args()
    print(f"seed {arguments.seed}, {arguments.number} runs of each size, half width over radius {arguments.ratio}")
    print("cells in the half width; half width; largest pressure; largest deviation of the curve; residual over strain energy [%]")
    for cells in arguments.cells:
        pick = random.Random(f"{arguments.seed} {cells}")
        for _ in range(arguments.number):
            print(f"{cells:5d} " + " ".join(f"{value:8.2f}" for value in errors(arguments.program, pick, cells, arguments.ratio)), flush=True)


if __name__ == "__main__":
    main()
