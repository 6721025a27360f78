#!/usr/bin/env python3
"""Error of G over positions of a crack and its front in their cells, by a program: cases that front_cell.py does not know.

    front_positions.py PROGRAM edge      xml_inputs/examples/edge_crack.xml with 4 and 8 cells in the crack, the front at 10 positions
                                         in its cell and the crack at 5 in its row; a hundredth of its load, so that its deflection does
                                         not count
    front_positions.py PROGRAM inclined  random cracks in an infinite plate at 4 and 8 cells a half length, both tips
    front_positions.py PROGRAM static    edge cracks at rest: random positions of the front and the crack, 4 to 12 cells, linear
                                         and GIMP, 2 x 2 and 3 x 3 particles
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

INPUTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../xml_inputs")


def run(program, scene, sets=()):
    with tempfile.TemporaryDirectory() as folder:
        command = [program, scene, "--output", folder, "--quiet"]
        for value in sets:
            command += ["--set", value]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 4):
            raise RuntimeError(done.stderr)
        with open(os.path.join(folder, "summary.json")) as file:
            return json.load(file)


STRESS = 5e4
LOAD = ["Boundaries:Top:Stress={0, %r}" % STRESS, "Boundaries:Bottom:Stress={0, %r}" % -STRESS]
SHORT = 1.0058  # what the length of the strip adds, and the handbook's formula lacks: references/edge_crack.py 5e4


def strip(a):
    """G of an edge crack in the strip [J/m2], Tada, Paris and Irwin, 2.11."""
    x = a / 0.04
    t = math.pi * x / 2
    shape = math.sqrt(math.tan(t) / t) * (0.752 + 2.02 * x + 0.37 * (1 - math.sin(t)) ** 3) / math.cos(t)
    return SHORT * STRESS**2 * math.pi * a * shape**2 / 3e9


def edge(program, cell, front, row):
    """Error of G_J [%]."""
    a, y = 0.01 + front * cell, 0.04 + row * cell
    sets = ["Domain:Cell Size=%r" % cell, "Cracks:Notch:Points={0, %r, %r, %r}" % (y, a, y)] + LOAD
    found = run(program, os.path.join(INPUTS, "examples/edge_crack.xml"), sets)
    return [100 * (found["cracks"][0]["fronts"][0]["G_J"] / strip(a) - 1)]


def inclined(program, cells, seed):
    """Errors of G_J [%] at both tips of a random crack."""
    pick = random.Random(1000 + seed)
    angle, turn, h = pick.uniform(0, math.pi), pick.uniform(-math.pi / 3, math.pi / 3), 5e-3 / cells
    x, y = h * pick.uniform(-0.5, 0.5), h * pick.uniform(-0.5, 0.5)
    c, s = math.cos(turn), math.sin(turn)
    dx, dy, rim = 5e-3 * math.cos(angle), 5e-3 * math.sin(angle), 0.015 + 2 * h
    text = open(os.path.join(INPUTS, "verification/inclined_crack.xml")).read()
    for old, new in (("c = cos(45*pi/180); s = sin(45*pi/180)", "c = %r; s = %r" % (math.cos(angle), math.sin(angle))),
                     ("P = 1e6*c*c; T = 1e6*s*c; N = 1e6*(s*s - c*c);",
                      "P = %r; T = (%r); N = (%r); X = x - (%r); Y = y - (%r);"
                      % (1e6 * c * c, -1e6 * s * c, 1e6 * (s * s - c * c), x, y)),
                     ("p = c*x + s*y; q = c*y - s*x;", "p = c*X + s*Y; q = c*Y - s*X;"),
                     ("{-0.01625, -0.01625}", "{%r, %r}" % (-rim, -rim)), ("{0.01625, 0.01625}", "{%r, %r}" % (rim, rim)),
                     ("0.000625", repr(h))):
        assert old in text, old
        text = text.replace(old, new)
    text = re.sub(r"\{-0.003535[^}]*\}", "{%r, %r, %r, %r}" % (x - dx, y - dy, x + dx, y + dy), text)
    with tempfile.NamedTemporaryFile("w", suffix=".xml") as scene:
        scene.write(text)
        scene.flush()
        found = run(program, scene.name)
    exact = math.pi * 5e-3 * 1e12 * c * c / 3e9
    return [100 * (f["G_J"] / exact - 1) for f in found["cracks"][0]["fronts"]]


def solve(program, text, cell, points, pick):
    """What a scene gives at rest with random functions and particles."""
    for old, new in ((r'<ParameterList name="Damping">.*?</ParameterList>', ""),
                     (r'(<ParameterList name="Time">).*?</ParameterList>',
                      r'\1<Parameter name="Analysis" type="string" value="Static"/><Parameter name="Final Time" type="double" value="1e-3"/>'
                      r'<Parameter name="Rigid Modes" type="string" value="Remove"/></ParameterList>')):
        text = re.sub(old, new, text, flags=re.S)
    with tempfile.NamedTemporaryFile("w", suffix=".xml") as scene:
        scene.write(text)
        scene.flush()
        return run(program, scene.name, ["Domain:Cell Size=%r" % cell, "Cracks:Notch:Points={%r, %r, %r, %r}" % points,
                                         "Domain:Shape Functions=" + pick.choice(["Linear", "GIMP"]),
                                         "Bodies:Strip:Particles Per Cell=%d" % pick.choice([2, 3])] + LOAD)


def at_rest(program, seed):
    """Error of G_J [%] of a random edge crack."""
    pick = random.Random(5000 + seed)
    cell = 0.01 / pick.choice([4, 5, 6, 8, 10, 12])
    cell = 0.04 / round(0.04 / cell)
    a, y = 0.01 + cell * pick.uniform(-0.5, 0.5), 0.04 + cell * pick.uniform(-0.5, 0.5)
    text = open(os.path.join(INPUTS, "examples/edge_crack.xml")).read()
    found = solve(program, text, cell, (0.0, y, a, y), pick)
    return cell, 100 * (found["cracks"][0]["fronts"][0]["G_J"] / strip(a) - 1)


def report(name, values):
    mean = sum(values) / len(values)
    rms = math.sqrt(sum(v * v for v in values) / len(values))
    print("%s: error of G, %%: mean %+.2f, rms %.2f, %+.2f to %+.2f of %d"
          % (name, mean, rms, min(values), max(values), len(values)), flush=True)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("case", choices=["edge", "inclined", "static"])
    options.add_argument("--number", type=int, default=20, help="of random cracks")
    chosen = options.parse_args()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        if chosen.case == "static":
            found = list(pool.map(lambda k: at_rest(chosen.program, k), range(chosen.number)))
            for name, fits in (("less than 6 cells", lambda h: h > 0.01 / 5.9), ("6 to 12 cells", lambda h: h < 0.01 / 5.9)):
                report(name, [v for h, v in found if fits(h)])
            return
        for cells in (4, 8):
            if chosen.case == "edge":
                jobs = [pool.submit(edge, chosen.program, 0.01 / cells, k / 10, row)
                        for row in (0, 0.15, 0.3, 0.5, 0.8) for k in range(10)]
            else:
                jobs = [pool.submit(inclined, chosen.program, cells, k) for k in range(chosen.number)]
            report("%s, %d cells" % (chosen.case, cells), [v for job in jobs for v in job.result()])


if __name__ == "__main__":
    main()
