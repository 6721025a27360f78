#!/usr/bin/env python3
"""G and K of two cracks next to each other, against cells of a quarter of the size.

    close_cracks.py PROGRAM [SEED] [NUMBER]     seed 1, 10 pairs

A square of 100 cells under tension, in static equilibrium, with a crack of 16 to 28 cells along the grid and another one of 10 to
20 cells, 2 to 8 cells above it, anywhere along it and turned by up to 17 degrees. Pairs closer than three cells are refused by the
program and named. Prints for each front the distance of the centres, the errors of G and K, and the difference of K^2 / E' and G."""

import json
import math
import os
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "program"))
sys.dont_write_bytecode = True

from scenes import plate  # noqa: E402

CELL, HALF = 1e-3, 0.05
YOUNG, POISSON = 3e9, 0.3


def scene(cell, cracks):
    ends = {"Top": (HALF, 1e6), "Bottom": (-HALF, -1e6)}
    made = plate()
    made.set("Domain", {"Dimension": 2, "Lower Corner": [-0.06, -0.06], "Upper Corner": [0.06, 0.06], "Cell Size": cell})
    made.set("Time", {"Analysis": "Static", "Rigid Modes": "Remove", "Final Time": 1.0})
    made.set("Materials > Polymer > Poisson Ratio", POISSON)
    made.set("Bodies > Plate > Lower Corner", [-HALF, -HALF])
    made.set("Bodies > Plate > Upper Corner", [HALF, HALF])
    made.set("Boundaries", {name: {"Type": "Traction", "Body": "Plate", "From": [y, y], "To": [-y, y], "Stress": [0.0, stress]}
                            for name, (y, stress) in ends.items()})
    made.set("Cracks", {name: {"Points": points} for name, points in cracks.items()})
    made.set("Energy Release", {})
    made.set("Output", {"Fields": False})
    return made


def fronts(program, cell, cracks):
    """G, K_I and K_II of all fronts, or why there are none."""
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "scene.xml"), os.path.join(folder, "out")
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene(cell, cracks).text())
        run = subprocess.run([program, path, "--quiet", "--output", out], capture_output=True, text=True, check=False)
        if run.returncode != 0:
            return run.stderr.splitlines()[0]
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            found = json.load(file)["cracks"]
    return [(front["G_J"], front["K_I"], front["K_II"]) for crack in found for front in crack["fronts"]]


def draw(rng):
    y, half = rng.uniform(-0.3, 0.3) * CELL, rng.uniform(8, 14) * CELL
    apart, along = rng.uniform(2, 8) * CELL, rng.uniform(-1.2, 1.2) * half
    other, turn = rng.uniform(5, 10) * CELL, rng.uniform(-0.3, 0.3)
    arm = (other * math.cos(turn), other * math.sin(turn))
    middle = (along, y + apart)
    return apart, {"One": [-half, y, half, 0.7 * y],
                   "Other": [middle[0] - arm[0], middle[1] - arm[1], middle[0] + arm[0], middle[1] + arm[1]]}


def main(program, seed=1, number=10):
    print(f"seed {seed}\n| pair | cells between | error of G % | of K % | K^2 / E' over G % |\n|--:|--:|--:|--:|--:|")
    rng, modulus, worst = random.Random(seed), YOUNG / (1 - POISSON ** 2), [0.0, 0.0]
    for pair in range(number):
        apart, cracks = draw(rng)
        coarse = fronts(program, CELL, cracks)
        if isinstance(coarse, str):
            print(f"| {pair} | {apart / CELL:.1f} | {coarse[:90]} | | |", flush=True)
            continue
        for (G, one, two), (fine, *of) in zip(coarse, fronts(program, CELL / 4, cracks)):
            errors = 100 * (G / fine - 1), 100 * (math.hypot(one, two) / math.hypot(*of) - 1)
            worst = [max(w, abs(e)) for w, e in zip(worst, errors)]
            gap = 100 * ((one * one + two * two) / modulus / G - 1)
            print(f"| {pair} | {apart / CELL:.1f} | {errors[0]:+.1f} | {errors[1]:+.1f} | {gap:+.1f} |", flush=True)
    print(f"largest errors: G {worst[0]:.1f} %, K {worst[1]:.1f} %")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1], *map(int, sys.argv[2:4]))
