#!/usr/bin/env python3
"""K along the fronts of cracks in a block in static equilibrium, against closed forms: a disk under tension and under pressure,
an ellipse under tension, and a lens (spherical cap) under pressure, which gives the K of an equal tension from all sides.

    cracks_3d.py PROGRAM [SEED] [CELLS] [CASE...]

CELLS is the number of the finest cells in a radius (the shorter semi-axis; default 6 and 12). Cells shrink towards the front. The
centre of each crack in its cell is drawn at random. Prints a row for each case: unknowns, errors of the mean, the least and the
largest K_I along the front in percent, for the lens those of K_II too, iterations of Newton's method and of the linear systems,
seconds and memory of the whole process.
"""
import json
import math
import os
import random
import resource
import subprocess
import sys
import tempfile
import time

STRESS, MODULUS, POISSON = 1e5, 3e9, 0.3
SIDE = 16.0  # of the block, in radii: a free face at 8 radii changes K_I by less than (1 / 8)^3 = 0.2 %

SCENE = """<ParameterList name="Rhegma">
  <ParameterList name="Domain">
    <Parameter name="Dimension" type="int" value="3"/>
    <Parameter name="Lower Corner" type="Array(double)" value="{%(low)r, %(low)r, %(low)r}"/>
    <Parameter name="Upper Corner" type="Array(double)" value="{%(high)r, %(high)r, %(high)r}"/>
    <Parameter name="Cell Size" type="double" value="%(cell)r"/>
    <Parameter name="Shape Functions" type="string" value="%(shape)s"/>
  </ParameterList>
  <ParameterList name="Time">
    <Parameter name="Analysis" type="string" value="Static"/>
    <Parameter name="Rigid Modes" type="string" value="Remove"/>
    <Parameter name="Final Time" type="double" value="1e-3"/>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Polymer">
      <Parameter name="Model" type="string" value="Linear Elastic"/>
      <Parameter name="Density" type="double" value="1200"/>
      <Parameter name="Young Modulus" type="double" value="%(modulus)r"/>
      <Parameter name="Poisson Ratio" type="double" value="%(poisson)r"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Bodies">
    <ParameterList name="Block">
      <Parameter name="Material" type="string" value="Polymer"/>
      <Parameter name="Shape" type="string" value="Box"/>
      <Parameter name="Lower Corner" type="Array(double)" value="{%(bottom)r, %(bottom)r, %(bottom)r}"/>
      <Parameter name="Upper Corner" type="Array(double)" value="{%(top)r, %(top)r, %(top)r}"/>
    </ParameterList>
  </ParameterList>
%(loads)s
  <ParameterList name="Cracks">
    <ParameterList name="Crack">
%(crack)s
    </ParameterList>
  </ParameterList>
  <ParameterList name="Adaptivity">
    <Parameter name="Maximum Level" type="int" value="%(levels)d"/>
    <Parameter name="Front Cells" type="double" value="%(around)r"/>
  </ParameterList>
  <ParameterList name="Energy Release"></ParameterList>
  <ParameterList name="Output">
    <Parameter name="Fields" type="bool" value="false"/>
  </ParameterList>
</ParameterList>
"""

TENSION = """  <ParameterList name="Boundaries">
    <ParameterList name="Top">
      <Parameter name="Type" type="string" value="Traction"/>
      <Parameter name="Body" type="string" value="Block"/>
      <Parameter name="Corner" type="Array(double)" value="{%(bottom)r, %(bottom)r, %(top)r}"/>
      <Parameter name="Edge 1" type="Array(double)" value="{%(side)r, 0, 0}"/>
      <Parameter name="Edge 2" type="Array(double)" value="{0, %(side)r, 0}"/>
      <Parameter name="Stress" type="Array(double)" value="{0, 0, %(stress)r}"/>
    </ParameterList>
    <ParameterList name="Bottom">
      <Parameter name="Type" type="string" value="Traction"/>
      <Parameter name="Body" type="string" value="Block"/>
      <Parameter name="Corner" type="Array(double)" value="{%(bottom)r, %(bottom)r, %(bottom)r}"/>
      <Parameter name="Edge 1" type="Array(double)" value="{%(side)r, 0, 0}"/>
      <Parameter name="Edge 2" type="Array(double)" value="{0, %(side)r, 0}"/>
      <Parameter name="Stress" type="Array(double)" value="{0, 0, -%(stress)r}"/>
    </ParameterList>
  </ParameterList>"""

PRESSURE = """  <ParameterList name="Face Pressure">
    <ParameterList name="Crack">
      <Parameter name="Pressure" type="string" value="%(stress)r"/>
    </ParameterList>
  </ParameterList>"""


def lens(file, centre, a, alpha, edge):
    """An STL of a spherical cap whose rim has radius a in the plane through `centre`; alpha is half its angle at the sphere's centre."""
    radius = a / math.sin(alpha)
    rings = max(3, round(radius * alpha / edge))
    around = max(24, round(2 * math.pi * a / edge))

    def at(i, j):
        t, p = alpha * i / rings, 2 * math.pi * j / around
        return (centre[0] + radius * math.sin(t) * math.cos(p), centre[1] + radius * math.sin(t) * math.sin(p),
                centre[2] + radius * (math.cos(t) - math.cos(alpha)))

    faces = []
    for j in range(around):
        faces.append((at(0, 0), at(1, j), at(1, (j + 1) % around)))
        for i in range(1, rings):
            p, q, r, s = at(i, j), at(i + 1, j), at(i + 1, (j + 1) % around), at(i, (j + 1) % around)
            faces += [(p, q, r), (p, r, s)]
    with open(file, "w") as out:
        out.write("solid lens\n")
        for face in faces:
            out.write("facet normal 0 0 0\nouter loop\n")
            for v in face:
                out.write("vertex %.9e %.9e %.9e\n" % v)
            out.write("endloop\nendfacet\n")
        out.write("endsolid lens\n")


def elliptic_integral(m):
    """Complete elliptic integral of the second kind by its arithmetic-geometric mean."""
    a, b, c, total, power = 1.0, math.sqrt(1 - m), math.sqrt(m), 0.0, 0.5
    while abs(c) > 1e-15:
        total += power * c * c
        a, b, c, power = (a + b) / 2, math.sqrt(a * b), (a - b) / 2, 2 * power
    total += power * c * c
    return math.pi / (2 * a) * (1 - total)


def crack_of(case, a, centre, folder):
    """The crack's parameters and the closed form: {quantity: (mean, least, largest)} [Pa m^0.5]."""
    penny = 2 * STRESS * math.sqrt(a / math.pi)
    array = "      <Parameter name=\"%s\" type=\"Array(double)\" value=\"{%r, %r, %r}\"/>\n"
    number = "      <Parameter name=\"%s\" type=\"double\" value=\"%r\"/>\n"
    if case == "lens":
        file = os.path.join(folder, "lens.stl")
        lens(file, centre, a, math.pi / 4, 0.15 * a)
        return ("      <Parameter name=\"Surface File\" type=\"string\" value=\"%s\"/>" % file,
                {"K_I": (0.8656 * penny,) * 3, "K_II": (0.2712 * penny,) * 3})  # xml_inputs/references/cap_crack.py
    text = array % (("Centre",) + tuple(centre)) + array % ("Normal", 0.0, 0.0, 1.0) + number % ("Radius", a)
    if case != "ellipse":
        return text, {"K_I": (penny,) * 3}
    long = 2 * a  # Irwin (1962): K_I = s sqrt(pi b) / E(k) (sin^2 t + (b / a)^2 cos^2 t)^(1/4)
    text += number % ("Second Radius", long) + array % ("Radius Direction", 1.0, 0.0, 0.0)
    top = STRESS * math.sqrt(math.pi * a) / elliptic_integral(1 - (a / long)**2)
    # The mean along the front, by arc length.
    n, total, length = 100000, 0.0, 0.0
    for i in range(n):
        t = 2 * math.pi * (i + 0.5) / n
        ds = math.hypot(long * math.sin(t), a * math.cos(t))
        total += ds * top * (math.sin(t)**2 + (a / long)**2 * math.cos(t)**2)**0.25
        length += ds
    return text, {"K_I": (total / length, top * math.sqrt(a / long), top)}


def run(program, case, cells, pick, shape="Linear"):
    a = 1e-3
    levels = 4
    cell = a / cells * 2**levels
    half = math.ceil(SIDE * a / 2 / cell) * cell
    centre = [cell * pick.uniform(-0.5, 0.5) for _ in range(3)]
    with tempfile.TemporaryDirectory() as folder:
        crack, closed = crack_of(case, a, centre, folder)
        values = dict(low=-half - 2 * cell, high=half + 2 * cell, bottom=-half, top=half, side=2 * half, cell=cell, shape=shape, levels=levels,
                      modulus=MODULUS, poisson=POISSON, stress=STRESS, around=5.0, crack=crack)
        values["loads"] = (PRESSURE if case in ("pressure", "lens") else TENSION) % values
        scene, out = os.path.join(folder, "scene.xml"), os.path.join(folder, "out")
        with open(scene, "w") as file:
            file.write(SCENE % values)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        start = time.perf_counter()
        done = subprocess.run([program, scene, "--output", out, "--quiet"], capture_output=True, text=True)
        seconds = time.perf_counter() - start
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode != 0:
            raise RuntimeError(done.stderr + done.stdout)
        with open(os.path.join(out, "summary.json")) as file:
            found = json.load(file)
    return found, closed, seconds, used.ru_utime - before.ru_utime, used.ru_maxrss / 1048576


def main():
    program = sys.argv[1]
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 7
    counts = [int(sys.argv[3])] if len(sys.argv) > 3 else [6, 12]
    cases = sys.argv[4:] or ["tension", "pressure", "ellipse", "lens"]
    print("seed %d" % seed)
    pick = random.Random(seed)
    print("%-9s %5s %9s %22s %22s %6s %6s %8s %8s %6s  %s" % (
        "case", "cells", "unknowns", "K_I mean least most %", "K_II mean least most %", "Newton", "linear", "wall s", "user s",
        "GiB", "solver"))
    for cells in counts:
        for case in cases:
            found, closed, seconds, user, memory = run(program, case, cells, pick)
            front = found["cracks"][0]["fronts"][0]
            errors = {}
            for name, (mean, least, most) in closed.items():
                sign = math.copysign(1, front[name])
                low, high = sorted([sign * front[name + "_min"], sign * front[name + "_max"]])
                errors[name] = tuple(100 * (f / c - 1) for f, c in ((abs(front[name]), mean), (low, least), (high, most)))
            text = ["%6.2f %6.2f %6.2f" % errors[name] if name in errors else "" for name in ("K_I", "K_II")]
            e = found["equilibrium"]
            print("%-9s %5d %9d %22s %22s %6d %6d %8.2f %8.2f %6.2f  %s" % (
                case, cells, e["unknowns"], text[0], text[1], e["iterations"], e["linear_iterations"], seconds, user, memory,
                e["solver"]), flush=True)


if __name__ == "__main__":
    main()
