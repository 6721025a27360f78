#!/usr/bin/env python3
"""Two elastic cylinders that are pressed on each other slowly, against Hertz's pressure and half width in plane strain.

    elastic_cylinders.py PROGRAM [--number N] [--seed N] [--cells 8 16] [--ratio 0.05] [--moduli 1 3] [--radii 1 2] [--friction 0.3]

Half width over radius is that of the equivalent cylinder on a plane, 1 / R = 1 / R1 + 1 / R2, with 1 / E* = (1 - nu^2) (1 / E1 + 1 / E2).
P = pi a^2 E* / (4 R), and the pressure is p0 sqrt(1 - (x / a)^2), p0 = 2 P / (pi a). It is compared with the mean stress of the cells at the
faces of both bodies. The point at which they meet lies anywhere in its cell.
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


def segment(material, meet, radius, wide, deep, side):
    """The part of a disk next to its lowest (side 1) or highest point, `deep` high and `wide` wide."""
    x, y = meet
    low, high = (y - 1.0, y + deep) if side > 0 else (y - deep, y + 1.0)
    cut = 2.0 * radius
    middle = y + side * radius
    outside = {
        "Left": ([x - cut, middle - cut], [x - 0.5 * wide, middle + cut]),
        "Right": ([x + 0.5 * wide, middle - cut], [x + cut, middle + cut]),
        "Far": ([x - cut, high if side > 0 else middle - cut], [x + cut, middle + cut if side > 0 else low]),
    }
    return {
        "Material": material, "Shape": "Ball", "Centre": [x, middle], "Radius": radius,
        "Operations": {name: {"Operation": "Cut", "Shape": "Box", "Lower Corner": a, "Upper Corner": b} for name, (a, b) in outside.items()},
    }


def pressed(pick, cells, ratio, moduli, radii, friction):
    """Scene in cells of 1 m; radii and load are such that the half width is `cells`."""
    radius = cells / ratio
    scale = radius * (1.0 / radii[0] + 1.0 / radii[1])
    radii = [scale * value for value in radii]
    young = [YOUNG * value for value in moduli]
    star = 1.0 / ((1.0 - POISSON**2) * (1.0 / young[0] + 1.0 / young[1]))
    load = math.pi * cells**2 * star / (4.0 * radius)
    wide, deep = 12.0 * cells, 6.0 * cells
    meet = [pick.uniform(0.0, 1.0), pick.uniform(0.0, 1.0)]
    # The upper body swings on a contact of about the stiffness E*; twice its frequency is critical damping.
    swing = math.sqrt(star / (DENSITY * wide * deep))
    rise, rest = 2.0 / swing, 9.0 / swing
    side = math.ceil(0.5 * wide + 5.0)
    contact = {"Law": "Coulomb", "Friction Coefficient": friction} if friction else {"Law": "Frictionless"}
    materials = {name: {"Model": "Linear Elastic", "Density": DENSITY, "Young Modulus": e, "Poisson Ratio": POISSON} for name, e in zip("AB", young)}
    scene = Scene({
        "Domain": {"Dimension": 2, "Plane": "Strain", "Cell Size": 1.0, "Lower Corner": [-side, -math.ceil(deep) - 4.0], "Upper Corner": [side + 1.0, math.ceil(deep) + 6.0]},
        "Time": {"Final Time": rise + rest},
        "Materials": materials,
        "Bodies": {"Lower": segment("A", meet, radii[0], wide, deep, -1), "Upper": segment("B", meet, radii[1], wide, deep, 1)},
        "Boundaries": {"Base": {"Type": "Velocity", "Components": "xy", "Value": [0.0, 0.0], "Lower Corner": [meet[0] - 99 * side, meet[1] - deep - 9.0],
                                "Upper Corner": [meet[0] + 99 * side, meet[1] - deep + 1.0]}},
        "Damping": {"Mass Rate": 1.8 * swing},
        "Body Contact": contact,
        "Rigid Tools": {"Press": {"Shape": "Box", "Lower Corner": [meet[0] - side, meet[1] + deep], "Upper Corner": [meet[0] + side, meet[1] + deep + 5.0],
                                  "Mass": 0.02 * DENSITY * deep * wide, "Components": "y", "Force": [0.0, -load], "Bodies": "Upper", "Law": "Stick",
                                  "Force History": f"t < {rise} ? sin(pi*t/{2.0 * rise})^2 : 1"}},
        "Output": {"Checkpoints": False, "History Interval": rise / 50.0, "Field Interval": rise + rest},
    })
    return scene, meet, radii, load


def run(program, scene, folder):
    path, out = os.path.join(folder, "pressed.xml"), os.path.join(folder, "out")
    with open(path, "w", encoding="utf-8") as file:
        file.write(scene.text())
    subprocess.run([program, path, "--output", out, "--quiet"], check=True)
    with open(os.path.join(out, "history.csv"), encoding="utf-8") as file:
        history = list(csv.DictReader(file))
    with h5py.File(os.path.join(out, "fields.h5"), "r") as file:
        last = file[sorted(group for group in file if "particles" in file[group])[-1]]["particles"]
        fields = {name: last[name][()] for name in ("position", "displacement", "stress", "body", "mass")}
    return history, fields


def profile(fields, number, meet, radii, columns):
    """Middles of columns of cells at the face of a body, from where the bodies meet, and the mean pressure and shear stress there."""
    side = 1.0 if number == 1 else -1.0
    start = (fields["position"] - fields["displacement"])[:, :2] - meet
    depth = radii[number] - numpy.hypot(start[:, 0], start[:, 1] - side * radii[number])
    row = (fields["body"] == number) & (depth < 1.0)
    x, stress, weight = fields["position"][row, 0] - meet[0], fields["stress"][row], fields["mass"][row]
    chosen = [numpy.round(x).astype(int) == k for k in columns]
    return (numpy.array([numpy.average(values[c], weights=weight[c]) for c in chosen]) for values in (x, -stress[:, 1], stress[:, 3]))


def half_width_and_pressure(x, pressure):
    """Of the ellipse that fits best: p^2 = p0^2 - (p0 / a)^2 x^2."""
    slope, square = numpy.polyfit(x**2, pressure**2, 1)
    return math.sqrt(max(-square / slope, 0.0)), math.sqrt(max(square, 0.0))


def errors(program, pick, cells, arguments):
    """For the two bodies: errors of the half width and p0 of the ellipse through the pressure over the middle 80 %, and the largest deviation
    there over p0; then the error of the force and the residual over the strain energy [%]."""
    scene, meet, radii, load = pressed(pick, cells, arguments.ratio, arguments.moduli, arguments.radii, arguments.friction)
    with tempfile.TemporaryDirectory() as folder:
        history, fields = run(program, scene, folder)
    highest = 2.0 * load / (math.pi * cells)
    found = []
    for number in (0, 1):
        x, pressure, _ = profile(fields, number, meet, radii, range(-int(0.8 * cells), int(0.8 * cells) + 1))
        a, p0 = half_width_and_pressure(x, pressure)
        exact = highest * numpy.sqrt(1.0 - (x / cells) ** 2)
        found += [a / cells - 1.0, p0 / highest - 1.0, numpy.abs(pressure - exact).max() / highest]
    residual = max(abs(float(row["residual"])) / float(row["strain"] or 1) for row in history[-20:])
    force = float(history[-1]["Lower - Upper.contact_force_y"]) / load - 1.0
    return [100 * value for value in found + [force, residual]]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--number", type=int, default=3)
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    parser.add_argument("--cells", type=int, nargs="+", default=[8, 16])
    parser.add_argument("--ratio", type=float, default=0.05)
    parser.add_argument("--moduli", type=float, nargs=2, default=[1.0, 1.0])
    parser.add_argument("--radii", type=float, nargs=2, default=[1.0, 1.0])
    parser.add_argument("--friction", type=float, default=0.3)
    arguments = parser.parse_args()
    print(f"seed {arguments.seed}, {arguments.number} runs of each size, half width over radius {arguments.ratio}, moduli {arguments.moduli}, "
          f"radii {arguments.radii}, friction {arguments.friction}")
    print("cells in the half width; lower and upper body: half width, largest pressure, largest deviation of the curve; force; residual over strain energy [%]")
    for cells in arguments.cells:
        pick = random.Random(f"{arguments.seed} {cells}")
        for _ in range(arguments.number):
            print(f"{cells:5d} " + " ".join(f"{value:8.2f}" for value in errors(arguments.program, pick, cells, arguments)), flush=True)


if __name__ == "__main__":
    main()
