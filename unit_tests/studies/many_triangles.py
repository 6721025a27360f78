#!/usr/bin/env python3
"""What a body of many triangles costs before its first step, and how exact its volume is.

    many_triangles.py PROGRAM [TRIANGLES ...]

A torus with radii of 20 and 6 mm, turned and moved at random (the seed is printed; RHEGMA_SEED sets it), as a binary STL file of the given
numbers of triangles (default: 1e4, 1e5, 1e6), in cells of 1.5 mm: 8 across the tube. The columns: processor time of `rhegma --check` and
of a run of one step, and the error of the mass against the volume that the triangles enclose and against that of the torus, 2 pi^2 R r^2.
The first row is a block of about the same volume with 12 triangles: what the program does in any case.
"""
import json
import os
import resource
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "program"))
sys.dont_write_bytecode = True

from part_files import binary_stl, brick  # noqa: E402
from scenes import Scene  # noqa: E402

LARGE, SMALL, CELL, DENSITY = 20e-3, 6e-3, 1.5e-3, 2700.0


def torus(count):
    """About so many triangles, counter-clockwise seen from outside."""
    around = int(round((0.5 * count * LARGE / SMALL) ** 0.5))
    across = int(round(0.5 * count / around))
    u, v = numpy.meshgrid(2 * numpy.pi * numpy.arange(around) / around, 2 * numpy.pi * numpy.arange(across) / across, indexing="ij")
    radius = LARGE + SMALL * numpy.cos(v)
    at = numpy.stack([radius * numpy.cos(u), radius * numpy.sin(u), SMALL * numpy.sin(v)], axis=-1)
    a, b = at, numpy.roll(at, -1, axis=0)
    c, d = numpy.roll(b, -1, axis=1), numpy.roll(at, -1, axis=1)
    return numpy.concatenate([numpy.stack([a, b, c], axis=2), numpy.stack([a, c, d], axis=2)]).reshape(-1, 3, 3)


def volume(triangles):
    return float((triangles[:, 0] * numpy.cross(triangles[:, 1], triangles[:, 2])).sum() / 6.0)


def processor_time(*command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measure(program, triangles, name, exact):
    # As the file has them: its numbers have 24 bits.
    triangles = triangles.astype(numpy.float32).astype(float)
    low, high = triangles.min((0, 1)) - 4 * CELL, triangles.max((0, 1)) + 4 * CELL
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "part.stl"), "wb") as file:
            file.write(binary_stl(triangles))
        scene = Scene({
            "Domain": {"Dimension": 3, "Lower Corner": list(low), "Upper Corner": list(high), "Cell Size": CELL},
            "Time": {"Final Time": 1e-6, "Maximum Steps": 1},
            "Materials": {"Metal": {"Model": "Linear Elastic", "Density": DENSITY, "Young Modulus": 7e10, "Poisson Ratio": 0.3}},
            "Bodies": {"Part": {"Material": "Metal", "Shape": "File", "File": "part.stl", "Velocity": [1.0, 0.0, 0.0]}},
            "Output": {"Fields": False, "Checkpoints": False}})
        path, out = os.path.join(folder, "scene.xml"), os.path.join(folder, "out")
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene.text())
        check = processor_time(program, path, "--check", "--quiet")
        run = processor_time(program, path, "--quiet", "--output", out)
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
    found = summary["bodies"][0]["mass"] / DENSITY
    print(f"{name:8} {len(triangles):9} {summary['particles']:9} {check:9.2f} s {run:9.2f} s {100 * (found / volume(triangles) - 1):+9.4f} % "
          f"{100 * (found / exact - 1):+9.4f} %", flush=True)


def main():
    program = sys.argv[1]
    counts = [int(float(text)) for text in sys.argv[2:]] or [10**4, 10**5, 10**6]
    seed = int(os.environ.get("RHEGMA_SEED", numpy.random.randint(1 << 30)))
    print(f"seed {seed}")
    draw = numpy.random.RandomState(seed)
    print(f"{'body':8} {'triangles':>9} {'particles':>9} {'check':>11} {'one step':>11} {'of triangles':>11} {'of the torus':>11}")
    exact = 2 * numpy.pi**2 * LARGE * SMALL**2
    edge = exact ** (1 / 3)
    measure(program, brick([0.0] * 3, [edge] * 3), "block", exact)
    turn, _ = numpy.linalg.qr(draw.normal(size=(3, 3)))
    turn *= numpy.linalg.det(turn)  # no mirror
    shift = CELL * draw.uniform(size=3)
    for count in counts:
        measure(program, torus(count) @ turn.T + shift, "torus", exact)


if __name__ == "__main__":
    main()
