#!/usr/bin/env python3
"""Iterations, time and memory of large static equilibria in 3D: a block under tension with a penny-shaped crack in it.

    large_static.py PROGRAM [SEED] [CELLS...]

With RHEGMA_RANKS=N in the environment the program runs on N MPI ranks. CELLS is the number of cells along an edge of the
block (default 20, 30 and 40; 50 makes a million particles). No support holds the block. The position of the block's surfaces and of the crack in their cells is drawn at random. In the rows `turned`, the block and its crack are turned
by 17 degrees about (1, 1, 1). Prints a row for each run: particles, unknowns, iterations of Newton's method, iterations of the
linear systems (mean over the systems), error of the mean K_I, seconds of the whole process, GB.
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
TURN = math.radians(17.0)

SCENE = """<ParameterList name="Rhegma">
  <ParameterList name="Domain">
    <Parameter name="Dimension" type="int" value="3"/>
    <Parameter name="Lower Corner" type="Array(double)" value="{%(low)r, %(low)r, %(low)r}"/>
    <Parameter name="Upper Corner" type="Array(double)" value="{%(high)r, %(high)r, %(high)r}"/>
    <Parameter name="Cell Size" type="double" value="%(cell)r"/>
    <Parameter name="Shape Functions" type="string" value="GIMP"/>
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
      <Parameter name="Lower Corner" type="Array(double)" value="%(bottom)s"/>
      <Parameter name="Upper Corner" type="Array(double)" value="%(top)s"/>
      <Parameter name="Rotation" type="double" value="%(degrees)r"/>
      <Parameter name="Rotation Centre" type="Array(double)" value="%(centre)s"/>
      <Parameter name="Rotation Axis" type="Array(double)" value="{1, 1, 1}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Boundaries">
%(tractions)s
  </ParameterList>
  <ParameterList name="Cracks">
    <ParameterList name="Penny">
      <Parameter name="Points" type="Array(double)" value="%(points)s"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Energy Release"></ParameterList>
  <ParameterList name="Output">
    <Parameter name="Fields" type="bool" value="false"/>
  </ParameterList>
</ParameterList>
"""

TRACTION = """    <ParameterList name="%s">
      <Parameter name="Type" type="string" value="Traction"/>
      <Parameter name="Body" type="string" value="Block"/>
      <Parameter name="Corner" type="Array(double)" value="%s"/>
      <Parameter name="Edge 1" type="Array(double)" value="%s"/>
      <Parameter name="Edge 2" type="Array(double)" value="%s"/>
      <Parameter name="Stress" type="Array(double)" value="%s"/>
    </ParameterList>"""


def array(numbers):
    return "{" + ", ".join("%.12g" % x for x in numbers) + "}"


def turned(v, angle):
    """Rotates a vector about (1, 1, 1) (Rodrigues)."""
    c, s, mean = math.cos(angle), math.sin(angle), sum(v) / 3
    across = [(v[(i + 2) % 3] - v[(i + 1) % 3]) / math.sqrt(3) for i in range(3)]
    return [v[i] * c + across[i] * s + mean * (1 - c) for i in range(3)]


def scene(cells, turn, pick):
    """A block of edge one and a penny of radius 0.15 in it. Surfaces on rows of nodes only if nothing is drawn at random."""
    cell, half, a = 1e-2 / cells, 5e-3, 1.5e-3
    centre = [cell * pick.uniform(-0.5, 0.5) for _ in range(3)]

    def at(v):
        return [c + x for c, x in zip(centre, turned(v, turn))]

    middle = [cell * pick.uniform(-0.5, 0.5) for _ in range(3)]
    n = 48
    points = []
    for k in range(n):
        t = 2 * math.pi * k / n
        points += at([middle[0] + a * math.cos(t), middle[1] + a * math.sin(t), middle[2]])
    edges = turned([2 * half, 0, 0], turn), turned([0, 2 * half, 0], turn)
    tractions = [TRACTION % (name, array(at([-half, -half, side * half])), array(edges[0]), array(edges[1]),
                             array(turned([0, 0, side * STRESS], turn))) for name, side in (("Top", 1), ("Bottom", -1))]
    reach = math.ceil((1.4 if turn else 1.05) * half / cell + 3) * cell
    return SCENE % dict(low=-reach, high=reach, cell=cell, modulus=MODULUS, poisson=POISSON, degrees=math.degrees(turn),
                        bottom=array([c - half for c in centre]), top=array([c + half for c in centre]), centre=array(centre),
                        tractions="\n".join(tractions), points=array(points)), 2 * STRESS * math.sqrt(a / math.pi)


def measure(program, text):
    with tempfile.TemporaryDirectory() as folder:
        file, out = os.path.join(folder, "scene.xml"), os.path.join(folder, "out")
        with open(file, "w") as stream:
            stream.write(text)
        start = time.perf_counter()
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        ranks = os.environ.get("RHEGMA_RANKS", "1")
        launcher = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", ranks] if ranks != "1" else []
        done = subprocess.run([*launcher, program, file, "--output", out, "--quiet"], capture_output=True, text=True)
        seconds = time.perf_counter() - start
        user = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        if done.returncode != 0:
            raise RuntimeError(done.stderr + done.stdout)
        with open(os.path.join(out, "summary.json")) as stream:
            return json.load(stream), seconds, user


def main():
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 11
    counts = [int(x) for x in sys.argv[3:]] or [20, 30, 40]
    print("seed %d" % seed)
    pick = random.Random(seed)
    print("%5s %-7s %9s %9s %6s %6s %7s %8s %8s %6s  %s" % ("cells", "block", "particles", "unknowns", "Newton", "linear", "K_I %",
                                                            "wall s", "user s", "GB", "solver"))
    for cells in counts:
        for name, turn in (("aligned", 0.0), ("turned", TURN)):
            text, exact = scene(cells, turn, pick)
            found, seconds, user = measure(sys.argv[1], text)
            e = found["equilibrium"]
            print("%5d %-7s %9d %9d %6d %6.1f %+7.2f %8.1f %8.1f %6.2f  %s" % (
                cells, name, found["particles"], e["unknowns"], e["iterations"], e["linear_iterations"] / e["iterations"],
                100 * (found["cracks"][0]["fronts"][0]["K_I"] / exact - 1), seconds, user, found["peak_memory_bytes"] / 1e9,
                e["solver"]), flush=True)


if __name__ == "__main__":
    main()
