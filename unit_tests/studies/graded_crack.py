#!/usr/bin/env python3
"""Error and time of K_I of a crack in static equilibrium, in cells whose size follows the distance to the fronts.

    graded_crack.py PROGRAM [SEED]

The scene is xml_inputs/verification/central_crack_static.xml; the position of the crack in its cell is drawn at random.
Prints a row for each mesh: width of the plate in half lengths, unknowns, worst error of K_I and G_J, seconds of the solution and
of the whole process. A mesh is a largest cell, a number of levels and a number of cells around a front.
"""
import json
import math
import os
import random
import subprocess
import sys
import tempfile
import time

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../xml_inputs/verification/central_crack_static.xml")
A, STRESS, MODULUS, POISSON = 1e-3, 1e5, 3e9, 0.3
# (width in half lengths, largest cell in half lengths, levels, cells around a front, positions)
MESHES = [(20, 1, 5, 3.5, 5), (20, 1, 6, 9, 5), (20, 0.5, 6, 14, 3), (100, 4, 6, 4, 3), (1000, 8, 6, 4, 1)]


def exact(width):
    """K_I of a plate under tension [Pa m^0.5]: Tada, Paris and Irwin, good to 0.1 %."""
    q = 2 / width
    return STRESS * math.sqrt(math.pi * A) * (1 - 0.025 * q**2 + 0.06 * q**4) / math.sqrt(math.cos(math.pi * q / 2))


def run(program, width, cell, levels, around, x, y):
    w, h = width * A / 2, width * A
    sets = {
        "Domain:Lower Corner": "{%r, %r}" % (-w - 2 * cell * A, -h - 2 * cell * A),
        "Domain:Upper Corner": "{%r, %r}" % (w + 2 * cell * A, h + 2 * cell * A),
        "Domain:Cell Size": cell * A,
        "Bodies:Plate:Lower Corner": "{%r, %r}" % (-w, -h),
        "Bodies:Plate:Upper Corner": "{%r, %r}" % (w, h),
        "Boundaries:Top:From": "{%r, %r}" % (w, h),
        "Boundaries:Top:To": "{%r, %r}" % (-w, h),
        "Boundaries:Bottom:From": "{%r, %r}" % (-w, -h),
        "Boundaries:Bottom:To": "{%r, %r}" % (w, -h),
        "Cracks:Slit:Points": "{%r, %r, %r, %r}" % (x - A, y, x + A, y),
        "Adaptivity:Maximum Level": levels,
        "Adaptivity:Front Cells": float(around),
    }
    with tempfile.TemporaryDirectory() as folder:
        command = [program, SCENE, "--output", folder, "--quiet"]
        for name, value in sets.items():
            command += ["--set", "%s=%s" % (name, value)]
        start = time.perf_counter()
        done = subprocess.run(command, capture_output=True, text=True)
        seconds = time.perf_counter() - start
        if done.returncode not in (0, 4):
            raise RuntimeError(done.stderr)
        with open(os.path.join(folder, "summary.json")) as file:
            return json.load(file), seconds


def measure(program, mesh, pick):
    width, cell, levels, around, positions = mesh
    k = exact(width)
    g = k * k * (1 - POISSON**2) / MODULUS
    row = {"width": width, "unknowns": 0, "K_I": 0.0, "G_J": 0.0, "solution": 0.0, "process": 0.0}
    for _ in range(positions):
        found, seconds = run(program, width, cell, levels, around, A * pick.uniform(-1, 1), A * pick.uniform(-1, 1))
        row["unknowns"] = max(row["unknowns"], found["equilibrium"]["unknowns"])
        for front in found["cracks"][0]["fronts"]:
            row["K_I"] = max(row["K_I"], abs(front["K_I"] / k - 1))
            row["G_J"] = max(row["G_J"], abs(front["G_J"] / g - 1))
        row["solution"] = max(row["solution"], found["wall_seconds"])
        row["process"] = max(row["process"], seconds)
    return row


def main():
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    print("seed %d" % seed)
    pick = random.Random(seed)
    print("%8s %9s %8s %8s %9s %9s" % ("width/a", "unknowns", "K_I %", "G_J %", "wall s", "process s"))
    for mesh in MESHES:
        row = measure(sys.argv[1], mesh, pick)
        print("%8d %9d %8.3f %8.3f %9.2f %9.2f" % (row["width"], row["unknowns"], 100 * row["K_I"], 100 * row["G_J"],
                                                  row["solution"], row["process"]), flush=True)


if __name__ == "__main__":
    main()
