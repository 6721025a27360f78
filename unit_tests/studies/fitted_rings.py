#!/usr/bin/env python3
"""Pressure between a ring and what it is fitted on, and its hoop stress, against Lamé's solution in plane strain.

    fitted_rings.py PROGRAM [--number N] [--seed N] [--cells 12 24] [--mandrel] [--friction 0.2]    cells in the radius of the interface

Two rings, or with --mandrel a ring on a rigid mandrel, touch without a gap and are pressed together by a slow pressure on the outer wall. The pressure between
them is that of a fit with the interference that this pressure would close. The middle lies anywhere in its cell, and radii and moduli are drawn. The pressure
is that of the mean radial stress between the interface and a tenth of its radius beyond, and the hoop stress the mean there.
"""
import argparse
import math
import os
import random
import tempfile

import numpy
from elastic_cylinders import POISSON, run
from rhegma.scene import Scene

YOUNG, DENSITY, LOAD = 1e9, 1000.0, 1e6


def of_radius(values, r):
    """Radial and hoop stress A - B / r^2 and A + B / r^2."""
    a, b = values
    return a - b / r**2, a + b / r**2


def lame(radii, young, mandrel):
    """A and B in the outer ring under LOAD on its outer wall. Radii of the bore, the interface and the outer wall."""
    bore, face, wall = radii
    young = [value / (1.0 - POISSON**2) for value in young]
    ratio = POISSON / (1.0 - POISSON)

    def displacement(values, r, modulus):
        radial, hoop = of_radius(values, r)
        return r * (hoop - ratio * radial) / modulus

    def ring(inside, outside, inner, outer):
        """A and B of a ring between two radii under pressures on both."""
        b = (inside - outside) / (1.0 / inner**2 - 1.0 / outer**2)
        return -inside + b / inner**2, b

    # The gap at the interface is linear in its pressure.
    gaps = []
    for pressure in (0.0, 1.0):
        inner = 0.0 if mandrel else displacement(ring(0.0, pressure, bore, face), face, young[0])
        gaps.append(displacement(ring(pressure, LOAD, face, wall), face, young[1]) - inner)
    pressure = gaps[0] / (gaps[0] - gaps[1])
    return ring(pressure, LOAD, face, wall), pressure


def ring_scene(pick, cells, mandrel, friction):
    middle = [pick.uniform(0.0, 1.0) for _ in range(2)]
    radii = [cells * pick.uniform(0.4, 0.6), float(cells), cells * pick.uniform(1.5, 1.8)]
    young = [YOUNG, YOUNG * pick.uniform(0.5, 2.0)]
    speed = math.sqrt(max(young) / DENSITY)
    rise = 30.0 * radii[2] / speed
    side = math.ceil(radii[2]) + 5.0

    def ring(material, inner, outer):
        return {"Material": material, "Shape": "Ball", "Centre": middle, "Radius": outer,
                "Operations": {"Bore": {"Operation": "Cut", "Shape": "Ball", "Centre": middle, "Radius": inner}}}

    law = {"Law": "Coulomb", "Friction Coefficient": friction} if friction else {"Law": "Frictionless"}
    bodies = {"Outer": ring("B", *radii[1:])}
    if not mandrel:
        bodies = {"Inner": ring("A", *radii[:2]), **bodies}
    scene = Scene({
        "Domain": {"Dimension": 2, "Plane": "Strain", "Cell Size": 1.0, "Lower Corner": [-side] * 2, "Upper Corner": [side + 1.0] * 2},
        "Time": {"Final Time": 1.5 * rise},
        "Materials": {name: {"Model": "Linear Elastic", "Density": DENSITY, "Young Modulus": e, "Poisson Ratio": POISSON} for name, e in zip("AB", young)},
        "Bodies": bodies,
        "Boundaries": {"Outside": {"Type": "Traction", "Body": "Outer", "Surface": "Body", "Part": "Base", "Pressure": LOAD,
                                   "History": f"t < {rise} ? sin(pi*t/{2.0 * rise})^2 : 1"}},
        "Damping": {"Mass Rate": 0.5 * speed / radii[2]},
        "Output": {"Checkpoints": False, "History Interval": rise / 20.0, "Field Interval": 1.5 * rise},
    })
    if mandrel:
        scene.set("Rigid Tools", {"Mandrel": {"Shape": "Ball", "Centre": middle, "Radius": radii[1], **law}})
    else:
        scene.set("Body Contact", law)
    return scene, middle, radii, young


def errors(program, pick, cells, arguments):
    """Of the pressure between the two, and of the hoop stress in the outer ring next to it [%]."""
    scene, middle, radii, young = ring_scene(pick, cells, arguments.mandrel, arguments.friction)
    with tempfile.TemporaryDirectory() as folder:
        _, fields = run(program, scene, folder)
    values, pressure = lame(radii, young, arguments.mandrel)
    start = (fields["position"] - fields["displacement"])[:, :2] - middle
    r = numpy.linalg.norm(start, axis=1)
    n = start / r[:, None]
    stress = fields["stress"]
    across = [stress[:, 0] * n[:, 0] ** 2 + stress[:, 1] * n[:, 1] ** 2 + 2.0 * stress[:, 3] * n[:, 0] * n[:, 1]]
    across.append(stress[:, 0] + stress[:, 1] - across[0])
    near = (fields["body"] == (0 if arguments.mandrel else 1)) & (r < 1.2 * radii[1])
    weight = fields["mass"][near]
    # A and B by least squares over the ring next to the interface.
    rows = numpy.concatenate([numpy.stack([0.0 * r[near] + 1.0, sign / r[near] ** 2], axis=1) for sign in (-1.0, 1.0)])
    right = numpy.concatenate([part[near] for part in across])
    scale = numpy.sqrt(numpy.concatenate([weight, weight]))
    found = numpy.linalg.lstsq(rows * scale[:, None], right * scale, rcond=None)[0]
    exact = of_radius(values, radii[1])
    return [100.0 * (a / b - 1.0) for a, b in zip(of_radius(found, radii[1]), exact)] + [pressure / LOAD]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--number", type=int, default=3)
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    parser.add_argument("--cells", type=int, nargs="+", default=[12, 24])
    parser.add_argument("--mandrel", action="store_true")
    parser.add_argument("--friction", type=float, default=0.2)
    arguments = parser.parse_args()
    print(f"seed {arguments.seed}, {arguments.number} runs of each size, friction {arguments.friction}, {'rigid mandrel' if arguments.mandrel else 'two rings'}")
    print("cells in the radius of the interface; pressure and hoop stress at it [%]; pressure at it over that outside")
    for cells in arguments.cells:
        pick = random.Random(f"{arguments.seed} {cells}")
        for _ in range(arguments.number):
            print(f"{cells:5d} " + " ".join(f"{value:8.2f}" for value in errors(arguments.program, pick, cells, arguments)), flush=True)


if __name__ == "__main__":
    main()
