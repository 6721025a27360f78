#!/usr/bin/env python3
"""What Body Contact costs: processor time per particle and step, with the section over without it.

    cost_of_body_contact.py PROGRAM [--runs 5] [--size 30] [--steps 100]    cells along a body; steps that count

Sixteen blocks in a square: far apart, three cells apart, or half a cell apart, so that about a tenth of the nodes are shared. Without the section the
near blocks are joined. Runs of both alternate, with one thread each; the time of half as many steps is taken off, so that the start does not count.
Prints the median of the ratios of each round, with the smallest and the largest.
"""
import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "tools"))

from rhegma.scene import Scene  # noqa: E402

SIDE = 4  # blocks along the square


def blocks(size, gap, steps, contact):
    pitch = size + gap
    bodies = {}
    for i in range(SIDE):
        for j in range(SIDE):
            low = [0.25 + pitch * i, 0.25 + pitch * j]
            bodies[f"Block {i} {j}"] = {"Material": "Solid", "Shape": "Box", "Lower Corner": low, "Upper Corner": [x + size for x in low],
                                        "Velocity": [0.1 * (1.5 - i), 0.1 * (1.5 - j)]}
    scene = Scene({
        "Domain": {"Dimension": 2, "Cell Size": 1.0, "Lower Corner": [-4.0] * 2, "Upper Corner": [SIDE * pitch + 4.0] * 2},
        "Time": {"Final Time": 1e9, "Maximum Steps": steps},
        "Materials": {"Solid": {"Model": "Linear Elastic", "Density": 1000.0, "Young Modulus": 1e9, "Poisson Ratio": 0.3}},
        "Bodies": bodies,
        "Output": {"Fields": False, "Checkpoints": False, "History Interval": 1e9},
    })
    return scene.set("Body Contact", {"Law": "Coulomb", "Friction Coefficient": 0.3}) if contact else scene


def seconds(program, scene, folder):
    path = os.path.join(folder, "scene.xml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(scene.text())
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([program, path, "--output", os.path.join(folder, "out"), "--quiet"], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL, env=dict(os.environ, OMP_NUM_THREADS="1"))
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--size", type=int, default=30)
    parser.add_argument("--steps", type=int, default=100)
    arguments = parser.parse_args()
    particles = 4 * (SIDE * arguments.size) ** 2
    for name, gap in (("40 cells apart", 40.0), ("3 cells apart", 3.0), ("half a cell apart", 0.5)):
        ratios, added = [], []
        for _ in range(arguments.runs):
            times = []
            with tempfile.TemporaryDirectory() as folder:
                for contact in (False, True):
                    many, few = (seconds(arguments.program, blocks(arguments.size, gap, n * arguments.steps, contact), folder) for n in (2, 1))
                    times.append((many - few) / (particles * arguments.steps))
            ratios.append(times[1] / times[0])
            added.append(1e9 * (times[1] - times[0]))
        print(f"blocks {name}: {statistics.median(ratios):.3f} times ({min(ratios):.3f} to {max(ratios):.3f}), "
              f"{statistics.median(added):+.1f} ns per particle and step", flush=True)


if __name__ == "__main__":
    main()
