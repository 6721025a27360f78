#!/usr/bin/env python3
"""Errors of G, K_I, K_II and the kink angle of random cracks at random angles at rest, against those of the endless plate.

    turned_cracks.py PROGRAM [--number N] [--seed N] [--cells 4 8] [--moving]     cells in half of a crack's length

The crack lies anywhere in its cell, under tension at a random angle to it; the edges of the square move as in the endless plate
(verification/inclined_crack_static.xml). With --moving, the plates are damped until they rest. Linear functions and GIMP, 2 x 2 and 3 x 3 particles a cell, in turns by chance.
"""
import argparse
import concurrent.futures
import json
import math
import os
import random
import re
import subprocess
import tempfile

from accuracy_at_rest import MODULUS, read, replaced

HALF_LENGTH, STRESS = 5e-3, 1e6


def scene(pick, cells):
    """Text of a scene, cosine and sine of the angle of the load to the crack's normal."""
    cell = HALF_LENGTH / cells
    half = cell * round(cells * pick.uniform(3.5, 4.5))
    angle, load = math.radians(pick.uniform(-90, 90)), math.radians(pick.uniform(-55, 55))
    x, y = (cell * pick.uniform(-0.5, 0.5) for _ in range(2))
    c, s = math.cos(load), math.sin(load)
    dx, dy = HALF_LENGTH * math.cos(angle), HALF_LENGTH * math.sin(angle)
    text = replaced(read("verification/inclined_crack_static.xml"),
                    ("0.01625", "@domain@"), ("0.015", "@edge@"), ("0.00019", "(@x@)"), ("0.00013", "(@y@)"),
                    ("cos(30*pi/180)", "cos(%r)" % angle), ("sin(30*pi/180)", "sin(%r)" % angle),
                    ("P = 1e6*c*c; T = 1e6*s*c; N = 1e6*(s*s - c*c);",
                     "P = %r; T = (%r); N = (%r);" % (STRESS * c * c, -STRESS * s * c, STRESS * (s * s - c * c))))
    text = re.sub(r"\{-0\.00414[^}]*\}", "{%r, %r, %r, %r}" % (x - dx, y - dy, x + dx, y + dy), text)
    rim = text.index('name="Rim"')  # nodes on the edge of the square are held
    text = text[:rim].replace("@edge@", repr(half)) + text[rim:].replace("@edge@", repr(half * (1 - 1e-7)))
    text = replaced(text, ("@domain@", repr(half + 2 * cell)), ("@x@", repr(x)), ("@y@", repr(y)))
    text = re.sub(r'<ParameterList name="Reference">.*?\n  </ParameterList>', "", text, flags=re.S)
    text = re.sub(r'<ParameterList name="Energy Release">.*?</ParameterList>', '<ParameterList name="Energy Release"/>', text, flags=re.S)
    return re.sub(r'(name="Cell Size" type="double" value=")[^"]*', r"\g<1>%r" % cell, text), c, s


def kink(first, second):
    """Direction of the largest hoop stress [degrees] for K_II > 0."""
    return math.degrees(2 * math.atan2(-2 * second, first + math.sqrt(first**2 + 8 * second**2)))


def damped(text):
    """The scene in motion: the edge of the square moves within a time, and damping ends the motion."""
    text = replaced(text, ('<Parameter name="Analysis" type="string" value="Static"/>', '<Parameter name="CFL" type="double" value="0.8"/>'))
    damping = re.search(r'  <ParameterList name="Damping">.*?</ParameterList>\n', read("verification/inclined_crack_30.xml"), flags=re.S)
    return text.replace('  <ParameterList name="Energy Release"/>', damping.group(0) + '  <ParameterList name="Energy Release"/>')


def errors(program, seed, cells, moving):
    """Of both fronts: G [%], K_I and K_II [% of sqrt(K_I^2 + K_II^2)], kink [degrees]."""
    pick = random.Random(seed)
    text, c, s = scene(pick, cells)
    if moving:
        text = damped(text)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.xml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        subprocess.run([program, path, "--output", os.path.join(folder, "out"), "--quiet",
                        "--set", "Domain:Shape Functions=" + pick.choice(["Linear", "GIMP"]),
                        "--set", "Bodies:Plate:Particles Per Cell=%d" % pick.choice([2, 3])], check=True, stderr=subprocess.DEVNULL)
        with open(os.path.join(folder, "out", "summary.json"), encoding="utf-8") as file:
            fronts = json.load(file)["cracks"][0]["fronts"]
    scale = STRESS * math.sqrt(math.pi * HALF_LENGTH)
    first, second = scale * c * c, scale * c * abs(s)
    both = math.hypot(first, second)
    return [(100 * (f["G_J"] * MODULUS / both**2 - 1), 100 * (f["K_I"] - first) / both, 100 * (abs(f["K_II"]) - second) / both,
             kink(f["K_I"], abs(f["K_II"])) - kink(first, second)) for f in fronts]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--number", type=int, default=30, help="of cracks")
    options.add_argument("--moving", action="store_true")
    options.add_argument("--cells", type=int, nargs="*", default=[4, 8])
    chosen = options.parse_args()
    print("seed %d" % chosen.seed)
    for cells in chosen.cells:
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            jobs = pool.map(lambda k: errors(chosen.program, 1000 * chosen.seed + k, cells, chosen.moving), range(chosen.number))
            found = [row for rows in jobs for row in rows]
        for i, name in enumerate(("G, %", "K_I, % of K", "K_II, % of K", "kink, degrees")):
            values = [row[i] for row in found]
            rms = math.sqrt(sum(v * v for v in values) / len(values))
            print("%2d cells, %d fronts, error of %-14s mean %+.2f, rms %.2f, %+.2f to %+.2f"
                  % (cells, len(values), name, sum(values) / len(values), rms, min(values), max(values)), flush=True)


if __name__ == "__main__":
    main()
