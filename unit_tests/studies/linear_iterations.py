#!/usr/bin/env python3
"""Iterations of conjugate gradients in equilibrium: bodies and cracks anywhere in their cells, and their growth with refinement.

    linear_iterations.py PROGRAM [--number N] [--seed N]     random bodies in 2D and as many in 3D (default 40)
    linear_iterations.py PROGRAM --refine [--seed N]         the same bodies in cells of a half and a quarter

A plate or block of 0.02 m with a straight crack of 0.006 m, free and under tension; `Time > Linear Solver` = `Iterative`. Position and turn of the
body, position and turn of the crack in it, and 2 or 3 particles per cell and axis are drawn at random. Iterations are the mean over the linear
systems of a run; the first one is solved to 1e-8 of its right side (1e-3 in 3D from 12,000 unknowns), later ones until Newton's method needs no
more digits. With --refine, bodies are aligned with the cells or turned by 17 degrees.
"""
import argparse
import json
import math
import os
import random
import subprocess
import tempfile

from large_static import MODULUS, POISSON, SCENE, STRESS, array, turned

HALF, CRACK, BOUND = 1e-2, 3e-3, 40


def turned_in_plane(v, angle):
    c, s = math.cos(angle), math.sin(angle)
    return [c * v[0] - s * v[1], s * v[0] + c * v[1]]


def traction(name, corner, edges, stress):
    ends = [corner, [a + b for a, b in zip(corner, edges[0])]]
    lines = ([("From", ends[0]), ("To", ends[1])] if len(corner) == 2 else [("Corner", corner), ("Edge 1", edges[0]), ("Edge 2", edges[1])])
    return "\n".join(['    <ParameterList name="%s">' % name, '      <Parameter name="Type" type="string" value="Traction"/>',
                      '      <Parameter name="Body" type="string" value="Block"/>'] +
                     ['      <Parameter name="%s" type="Array(double)" value="%s"/>' % (key, array(v)) for key, v in lines + [("Stress", stress)]] +
                     ["    </ParameterList>"])


def scene(dimension, cell, turn, turn_of_crack, offset, offset_of_crack, particles):
    """Turns in radians, offsets in m."""
    turn_of = turned_in_plane if dimension == 2 else turned

    def at(v):
        return [a + b for a, b in zip(offset, turn_of(v, turn))]

    up = dimension - 1  # axis of the tension
    unit = [[2 * HALF if a == b else 0.0 for a in range(dimension)] for b in range(dimension)]
    edges = [turn_of(unit[k], turn) for k in range(up)]
    tractions = []
    for name, side in (("Top", 1), ("Bottom", -1)):
        corner = [-HALF] * up + [side * HALF]
        pull = turn_of([0.0] * up + [side * STRESS], turn)
        tractions.append(traction(name, at(corner), edges, pull))
    if dimension == 2:
        along = turned_in_plane([CRACK, 0.0], turn_of_crack)
        points = [x for side in (-1, 1) for x in at([side * a + b for a, b in zip(along, offset_of_crack)])]
    else:
        points = []
        for k in range(24):
            t = 2 * math.pi * k / 24
            rim = turned([CRACK * math.cos(t), CRACK * math.sin(t), 0.0], turn_of_crack)
            points += at([a + b for a, b in zip(rim, offset_of_crack)])
    reach = math.ceil((1.5 if dimension == 2 else 1.75) * HALF / cell + 4) * cell
    text = SCENE % dict(low=-reach, high=reach, cell=cell, modulus=MODULUS, poisson=POISSON, degrees=math.degrees(turn),
                        bottom=array([c - HALF for c in offset]), top=array([c + HALF for c in offset]), centre=array(offset),
                        tractions="\n".join(tractions), points=array(points))
    text = text.replace('name="Rigid Modes"', 'name="Linear Solver" type="string" value="Iterative"/>\n    <Parameter name="Rigid Modes"')
    text = text.replace('value="Box"/>', 'value="Box"/>\n      <Parameter name="Particles Per Cell" type="int" value="%d"/>' % particles)
    if dimension == 2:
        corners = "{%r, %r, %r}", "{%r, %r}"
        for corner in (-reach, reach):
            text = text.replace(corners[0] % (corner, corner, corner), corners[1] % (corner, corner))
        text = text.replace('value="3"/>', 'value="2"/>\n    <Parameter name="Plane" type="string" value="Strain"/>', 1)
        text = "\n".join(line for line in text.split("\n") if "Rotation Axis" not in line)
    return text.replace('  <ParameterList name="Energy Release"></ParameterList>\n', "")


def solve(program, text):
    """The section `equilibrium` of the summary."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.xml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        done = subprocess.run([program, path, "--output", os.path.join(folder, "out"), "--quiet"], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(done.stderr + done.stdout)
        with open(os.path.join(folder, "out", "summary.json"), encoding="utf-8") as file:
            found = json.load(file)["equilibrium"]
    if "conjugate gradients" not in found["solver"]:
        raise RuntimeError("solved by " + found["solver"])
    return found


def mean(found):
    """Iterations of a linear system."""
    return found["linear_iterations"] / found["iterations"]


def random_scene(dimension, pick):
    cell = 2 * HALF / (pick.uniform(20, 60) if dimension == 2 else pick.uniform(9, 16))
    offset = [cell * pick.uniform(-0.5, 0.5) for _ in range(dimension)]
    of_crack = [0.5 * HALF * pick.uniform(-1, 1) for _ in range(dimension)]
    turn, of = (math.radians(pick.uniform(-90, 90)) for _ in range(2))
    return scene(dimension, cell, pick.choice([0.0, turn]), of, offset, of_crack, pick.choice([2, 3]))


def draw(program, seed, number):
    print("| bodies | unknowns | iterations a system: least | median | most | bound |\n|:--|--:|--:|--:|--:|--:|")
    for dimension in (2, 3):
        rows = []
        for k in range(number):
            found = solve(program, random_scene(dimension, random.Random(1000 * seed + 100 * dimension + k)))
            rows.append((mean(found), found["unknowns"]))
        counts, unknowns = sorted(r[0] for r in rows), [r[1] for r in rows]
        print("| %d in %dD | %d to %d | %.1f | %.1f | %.1f | %d |" % (number, dimension, min(unknowns), max(unknowns), counts[0],
                                                                     counts[number // 2], counts[-1], BOUND), flush=True)


def refine(program, seed):
    print("| body | unknowns | iterations a system | growth of the last refinement |\n|:--|--:|--:|--:|")
    for dimension, cells in ((2, (50, 100, 200)), (3, (10, 20, 40))):
        for name, turn in (("aligned", 0.0), ("turned", math.radians(17))):
            pick = random.Random(seed)
            offset, of_crack = ([pick.uniform(-0.5, 0.5) for _ in range(dimension)] for _ in range(2))
            found = []
            for n in cells:
                cell = 2 * HALF / n
                found.append(solve(program, scene(dimension, cell, turn, 0.3, [cell * x for x in offset], [cell * x for x in of_crack], 2)))
            counts = [mean(f) for f in found]
            print("| %s in %dD | %s | %s | %.2f |" % (name, dimension, ", ".join("%d" % f["unknowns"] for f in found),
                                                     ", ".join("%.1f" % c for c in counts), counts[-1] / counts[-2]), flush=True)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--number", type=int, default=40)
    options.add_argument("--refine", action="store_true")
    chosen = options.parse_args()
    print("seed %d\n" % chosen.seed)
    if chosen.refine:
        refine(chosen.program, chosen.seed)
    else:
        draw(chosen.program, chosen.seed, chosen.number)


if __name__ == "__main__":
    main()
