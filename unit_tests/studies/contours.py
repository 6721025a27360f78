#!/usr/bin/env python3
"""How far G and K of a crack depend on the radii of the domain integral.

    contours.py PROGRAM [SEED] [NUMBER]     seed 5, 14 cracks

A crack of 8 to 16 cells a half length, anywhere in its cell, along the grid or at up to 69 degrees, in a square of 100 cells under
tension, in static equilibrium. Changes of G_J and K against an outer radius of 8 cells; the inner radius is half of the outer one."""

import collections
import json
import math
import os
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from close_cracks import CELL, scene  # noqa: E402

OUTER = (8, 10, 6, 5, 4, 3, 2)


def fronts(program, crack, outer):
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "scene.xml"), os.path.join(folder, "out")
        made = scene(CELL, {"One": crack})
        made.set("Energy Release", {"Inner Radius": 0.5 * outer * CELL, "Outer Radius": outer * CELL})
        with open(path, "w", encoding="utf-8") as file:
            file.write(made.text())
        subprocess.run([program, path, "--quiet", "--output", out], check=True, stderr=subprocess.DEVNULL)
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            found = json.load(file)["cracks"][0]["fronts"]
    return [(front["G_J"], math.hypot(front["K_I"], front["K_II"])) for front in found]


def main(program, seed=5, number=14):
    rng, changes = random.Random(seed), collections.defaultdict(list)
    for _ in range(number):
        turn, half = rng.choice([0.0, rng.uniform(0.0, 1.2)]), rng.uniform(8, 16) * CELL
        x, y = (rng.uniform(-0.5, 0.5) * CELL for _ in range(2))
        arm = (half * math.cos(turn), half * math.sin(turn))
        crack = [x - arm[0], y - arm[1], x + arm[0], y + arm[1]]
        usual = fronts(program, crack, OUTER[0])
        for outer in OUTER[1:]:
            for now, then in zip(fronts(program, crack, outer), usual):
                changes[outer].append([100 * (a / b - 1) for a, b in zip(now, then)])
    print(f"seed {seed}\n| outer radius [cells] | fronts | G rms % | worst | K rms % | worst |\n|--:|--:|--:|--:|--:|--:|")
    for outer, of in changes.items():
        columns = [value for column in zip(*of) for value in
                   (math.sqrt(sum(c * c for c in column) / len(column)), max(map(abs, column)))]
        print(f"| {outer} | {len(of)} | " + " | ".join(f"{value:.2f}" for value in columns) + " |")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1], *map(int, sys.argv[2:4]))
