#!/usr/bin/env python3
"""Two equal elastic cylinders under a normal load and then a tangential one below the friction limit, against Cattaneo and Mindlin.

    partial_slip.py PROGRAM [--number N] [--seed N] [--cells 8 12] [--part 0.5] [--friction 0.3]    tangential load over the friction limit

The cylinders stick in |x| < c with c / a = sqrt(1 - Q / (mu P)); the shear traction is mu p0 (sqrt(1 - (x / a)^2) - c / a sqrt(1 - (x / c)^2)), the last
term for |x| < c only (Cattaneo 1938; Mindlin 1949). c is that of the traction that fits best to the mean shear stress of the cells at the faces, with a and
p0 of the normal stress found.
"""
import argparse
import math
import random
import tempfile

import numpy
from elastic_cylinders import half_width_and_pressure, pressed, profile, run


def shear(x, a, c):
    """Traction over mu p0."""
    return numpy.sqrt(numpy.maximum(1.0 - (x / a) ** 2, 0.0)) - c / a * numpy.sqrt(numpy.maximum(1.0 - (x / c) ** 2, 0.0))


def errors(program, pick, cells, arguments):
    """Of c / a, against that of the forces found, and of the tangential force, which is nearly at rest [%]."""
    scene, meet, radii, load = pressed(pick, cells, 0.05, [1.0, 1.0], [1.0, 1.0], arguments.friction)
    tool = "Rigid Tools > Press"
    before = rest = scene["Time > Final Time"]
    total = arguments.part * arguments.friction * load
    height = scene[tool + " > Lower Corner"][1]
    scene.set("Boundaries > Pull", {"Type": "Traction", "Body": "Upper", "From": [meet[0] - 6.0 * cells, height], "To": [meet[0] + 6.0 * cells, height],
                                    "Stress": [total / (12.0 * cells), 0.0],
                                    "History": f"t < {before} ? 0 : (t < {before + 0.4 * rest} ? sin(pi*(t-{before})/{0.8 * rest})^2 : 1)"})
    scene.set(tool + " > Components", "y").set(tool + " > Law", "Frictionless")
    scene.set("Time > Final Time", before + rest + 0.4 * rest).set("Output > Field Interval", before + rest + 0.4 * rest)
    with tempfile.TemporaryDirectory() as folder:
        history, fields = run(program, scene, folder)
    columns = range(-int(cells) - 1, int(cells) + 2)
    # The mean of both bodies: their faces lean to opposite sides by x / R, which turns a part of the pressure into shear.
    x, pressure, along = sum(numpy.array(list(profile(fields, number, meet, radii, columns))) for number in (0, 1)) / 2.0
    inside = numpy.abs(x) < 0.8 * cells
    a, p0 = half_width_and_pressure(x[inside], pressure[inside])
    tried = numpy.linspace(0.05, 0.99, 941)
    amounts = [((numpy.abs(along) / (arguments.friction * p0) - shear(x, a, part * a))[inside] ** 2).sum() for part in tried]
    forces = [abs(float(history[-1]["Lower - Upper.contact_force_" + axis])) for axis in "xy"]
    exact = math.sqrt(1.0 - forces[0] / (arguments.friction * forces[1]))
    return [100.0 * value for value in (tried[int(numpy.argmin(amounts))] / exact - 1.0, forces[0] / total - 1.0)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--number", type=int, default=2)
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    parser.add_argument("--cells", type=int, nargs="+", default=[8, 12])
    parser.add_argument("--part", type=float, default=0.5)
    parser.add_argument("--friction", type=float, default=0.3)
    arguments = parser.parse_args()
    print(f"seed {arguments.seed}, {arguments.number} runs of each size, friction {arguments.friction}, tangential load {arguments.part} of its limit")
    print("cells in the half width; half width of sticking; tangential force [%]")
    for cells in arguments.cells:
        pick = random.Random(f"{arguments.seed} {cells}")
        for _ in range(arguments.number):
            print(f"{cells:5d} " + " ".join(f"{value:8.2f}" for value in errors(arguments.program, pick, cells, arguments)), flush=True)


if __name__ == "__main__":
    main()
