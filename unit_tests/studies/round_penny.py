#!/usr/bin/env python3
"""How round a penny-shaped crack stays that grows in equilibrium: by how much its front nodes are off their mean radius.

    round_penny.py PROGRAM [SEED [NUMBER]]

A block of 20 x 20 x 20 cells, of which a plane of symmetry leaves one half. A penny of 4 cells, anywhere in its cells and tilted by up
to 5 degrees, is opened by tractions or by a pressure on its faces, and grows by five load steps of a load factor. Its centre and
normal are those of the scene; a front node counts by its distance from the axis."""

import json
import math
import os
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "program"))
sys.dont_write_bytecode = True

from scenes import Scene  # noqa: E402

CELL, HALF, RADIUS = 1e-3, 10e-3, 4e-3


def penny(rng, pressure):
    centre = [0.0, rng.uniform(-0.5, 0.5) * CELL, rng.uniform(-0.5, 0.5) * CELL]
    tilt = math.radians(rng.uniform(-5.0, 5.0))
    normal = [0.0, math.cos(tilt), math.sin(tilt)]
    low, high = [0.0, -HALF, -HALF], [HALF, HALF, HALF]
    boundaries = {"Mirror": {"Type": "Symmetry", "Axis": "x", "Position": 0.0}}
    for name, y in () if pressure else (("Top", HALF), ("Bottom", -HALF)):
        edges = [0.0, 0.0, 2 * HALF], [HALF, 0.0, 0.0]
        boundaries[name] = {"Type": "Traction", "Body": "Block", "Corner": [0.0, y, -HALF], "Edge 1": edges[y < 0], "Edge 2": edges[y > 0],
                            "Stress": [0.0, math.copysign(1e6, y), 0.0]}
    scene = {
        "Domain": {"Dimension": 3, "Lower Corner": [0.0] + [-HALF - 3 * CELL] * 2, "Upper Corner": [HALF + 3 * CELL] * 3, "Cell Size": CELL},
        "Time": {"Final Time": 1.0, "Analysis": "Quasi-Static", "Load Steps": 6, "Rigid Modes": "Remove"},
        "Materials": {"Glass": {"Model": "Linear Elastic", "Density": 2500.0, "Young Modulus": 7e10, "Poisson Ratio": 0.22}},
        "Bodies": {"Block": {"Material": "Glass", "Shape": "Box", "Lower Corner": low, "Upper Corner": high}},
        "Boundaries": boundaries,
        "Cracks": {"Penny": {"Centre": centre, "Normal": normal, "Radius": RADIUS}},
        "Energy Release": {},
        "Propagation": {"Toughness": 8.0, "Load Control": "Load Factor"},
        "Output": {"Fields": False},
    }
    if pressure:
        scene["Face Pressure"] = {"Penny": {"Pressure": "1e6"}}
    return Scene(scene), centre, normal


def main():
    program = sys.argv[1]
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    number = int(sys.argv[3]) if len(sys.argv) > 3 else 4
    print("seed %d" % seed)
    print(" load      tilt  from   to [cells]  off [%]  above and below [cells]  wall s")
    worst = 0.0
    for k in range(number):
        rng = random.Random(1000 * seed + k)
        scene, centre, normal = penny(rng, k % 2 == 1)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "penny.xml")
            with open(path, "w") as file:
                file.write(scene.text())
            done = subprocess.run([program, path, "--quiet", "--output", os.path.join(folder, "out")], capture_output=True, text=True, check=False)
            if done.returncode != 0:
                sys.exit("exit status %d\n%s" % (done.returncode, done.stderr))
            with open(os.path.join(folder, "out", "summary.json")) as file:
                summary = json.load(file)
        radii, heights = [], []
        for x in summary["cracks"][0]["fronts"][0]["front_nodes"]["position"]:
            away = [a - c for a, c in zip(x, centre)]
            height = sum(a * n for a, n in zip(away, normal))
            radii.append(math.sqrt(sum(a * a for a in away) - height * height))
            heights.append(height / CELL)
        mean = sum(radii) / len(radii)
        off = max(abs(r / mean - 1.0) for r in radii)
        worst = max(worst, off)
        print(" %-8s %5.1f  %.2f  %.2f         %.2f     %5.2f %5.2f              %.0f" % (
            "pressure" if k % 2 else "tension", math.degrees(math.asin(normal[2])), RADIUS / CELL, mean / CELL, 100 * off, max(heights), min(heights),
            summary["wall_seconds"]), flush=True)
    print("largest: %.2f %%" % (100 * worst))


if __name__ == "__main__":
    main()
