#!/usr/bin/env python3
"""Two elastic spheres that are pressed on each other slowly, against Hertz's pressure and contact radius.

    elastic_spheres.py PROGRAM [--number N] [--seed N] [--cells 4] [--ratio 0.1] [--radii 1 2] [--friction 0.3] [--wide 3.5] [--deep 3]

A quarter between two planes of symmetry, of blocks with round faces; their size is in contact radii. The contact radius over the equivalent radius is
`ratio`. a^3 = 3 P R / (4 E*), p = p0 sqrt(1 - (r / a)^2), p0 = 3 P / (2 pi a^2), compared with the mean stress of rings of cells at the faces. The height at
which the spheres meet lies anywhere in its cell. The approach is not compared: in blocks this small it is that of the blocks.
"""
import argparse
import math
import random
import tempfile

import numpy
from elastic_cylinders import DENSITY, POISSON, YOUNG, half_width_and_pressure, run
from rhegma.scene import Scene


def cap(meet, radius, wide, deep, side):
    """The part of a ball above (side 1) or below the height `meet` that lies in the quarter."""
    centre = [0.0, 0.0, meet + side * radius]
    far, edge = sorted((meet + side * deep, meet + side * 3.0 * radius)), 2.0 * radius
    cuts = {"Far": ([-edge, -edge, far[0]], [edge, edge, far[1]])}
    for d, name in enumerate("XY"):
        low, high = [-edge, -edge, meet - edge], [edge, edge, meet + edge]
        for which, a, b in (("Back ", -edge, 0.0), ("Front ", wide, edge)):
            cuts[which + name] = ([a if k == d else x for k, x in enumerate(low)], [b if k == d else x for k, x in enumerate(high)])
    return {"Material": "Solid", "Shape": "Ball", "Centre": centre, "Radius": radius,
            "Operations": {name: {"Operation": "Cut", "Shape": "Box", "Lower Corner": a, "Upper Corner": b} for name, (a, b) in cuts.items()}}


def pressed(pick, cells, arguments):
    """Scene in cells of 1 m; radii and load are such that the contact radius is `cells`."""
    radius, star = cells / arguments.ratio, 0.5 * YOUNG / (1.0 - POISSON**2)
    scale = radius * sum(1.0 / value for value in arguments.radii)
    radii = [scale * value for value in arguments.radii]
    load = 4.0 * star * cells**3 / (3.0 * radius)
    wide, deep = arguments.wide * cells, arguments.deep * cells
    meet = pick.uniform(0.0, 1.0)
    swing = math.sqrt(2.0 * star * cells / (DENSITY * 4.0 * wide**2 * deep))
    rise, rest = 2.0 / swing, 7.0 / swing
    side, end = math.ceil(wide) + 3.0, math.ceil(deep) + 4.0
    law = {"Law": "Coulomb", "Friction Coefficient": arguments.friction} if arguments.friction else {"Law": "Frictionless"}
    scene = Scene({
        "Domain": {"Dimension": 3, "Cell Size": 1.0, "Lower Corner": [0.0, 0.0, -end], "Upper Corner": [side, side, end + 1.0]},
        "Time": {"Final Time": rise + rest},
        "Materials": {"Solid": {"Model": "Linear Elastic", "Density": DENSITY, "Young Modulus": YOUNG, "Poisson Ratio": POISSON}},
        "Bodies": {"Lower": cap(meet, radii[0], wide, deep, -1.0), "Upper": cap(meet, radii[1], wide, deep, 1.0)},
        "Boundaries": {
            "Base": {"Type": "Velocity", "Components": "xyz", "Value": [0.0] * 3, "Lower Corner": [-1.0, -1.0, -2.0 * end], "Upper Corner": [side, side, meet - deep + 1.0]},
            "Left": {"Type": "Symmetry", "Axis": "x", "Position": 0.0},
            "Front": {"Type": "Symmetry", "Axis": "y", "Position": 0.0},
        },
        "Damping": {"Mass Rate": 1.8 * swing},
        "Body Contact": law,
        "Rigid Tools": {"Press": {"Shape": "Box", "Lower Corner": [-1.0, -1.0, meet + deep], "Upper Corner": [side, side, meet + deep + 3.0],
                                  "Mass": 0.02 * DENSITY * deep * wide**2, "Components": "z", "Force": [0.0, 0.0, -0.25 * load], "Bodies": "Upper",
                                  "Law": "Stick", "Force History": f"t < {rise} ? sin(pi*t/{2.0 * rise})^2 : 1"}},
        "Output": {"Checkpoints": False, "History Interval": rise / 20.0, "Field Interval": rise + rest},
    })
    return scene, meet, radii, load


def errors(program, pick, cells, arguments):
    """For the two bodies: errors of the contact radius and p0 of the pressure over the middle 80 %, and the largest deviation there over p0; then of the
    force and of the mean pressure over the contact, and the residual over the strain energy [%]."""
    scene, meet, radii, load = pressed(pick, cells, arguments)
    with tempfile.TemporaryDirectory() as folder:
        history, fields = run(program, scene, folder)
    highest, found = 1.5 * load / (math.pi * cells**2), []
    for number, side in ((0, -1.0), (1, 1.0)):
        centre = numpy.array([0.0, 0.0, meet + side * radii[number]])
        start = fields["position"] - fields["displacement"] - centre
        row = (fields["body"] == number) & (radii[number] - numpy.linalg.norm(start, axis=1) < 1.0)
        r, pressure, weight = numpy.hypot(*fields["position"][row, :2].T), -fields["stress"][row, 2], fields["mass"][row]
        ring = numpy.floor(r).astype(int)
        rings = [ring == k for k in range(int(0.8 * cells) + 1)]
        r, pressure = (numpy.array([numpy.average(values[chosen], weights=weight[chosen]) for chosen in rings]) for values in (r, pressure))
        a, p0 = half_width_and_pressure(r, pressure)
        exact = highest * numpy.sqrt(numpy.maximum(1.0 - (r / cells) ** 2, 0.0))
        found += [a / cells - 1.0, p0 / highest - 1.0, numpy.abs(pressure - exact).max() / highest]
    residual = max(abs(float(row["residual"])) / float(row["strain"] or 1) for row in history[-20:])
    force = float(history[-1]["Lower - Upper.contact_force_z"]) / (0.25 * load) - 1.0
    return [100 * value for value in found + [force, residual]]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--number", type=int, default=1)
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    parser.add_argument("--cells", type=int, nargs="+", default=[4])
    parser.add_argument("--ratio", type=float, default=0.1)
    parser.add_argument("--radii", type=float, nargs=2, default=[1.0, 2.0])
    parser.add_argument("--friction", type=float, default=0.3)
    parser.add_argument("--wide", type=float, default=3.5)
    parser.add_argument("--deep", type=float, default=3.0)
    arguments = parser.parse_args()
    print(f"seed {arguments.seed}, {arguments.number} runs of each size, contact radius over radius {arguments.ratio}, radii {arguments.radii}, "
          f"friction {arguments.friction}, blocks {2 * arguments.wide} a wide and {arguments.deep} a high")
    print("cells in the contact radius; lower and upper body: contact radius, largest pressure, largest deviation of the curve; force; residual [%]")
    for cells in arguments.cells:
        pick = random.Random(f"{arguments.seed} {cells}")
        for _ in range(arguments.number):
            print(f"{cells:5d} " + " ".join(f"{value:8.2f}" for value in errors(arguments.program, pick, cells, arguments)), flush=True)


if __name__ == "__main__":
    main()
