#!/usr/bin/env python3
"""K and G of cracks under pressure in 2D at random angles and positions in the cells, at rest, against the closed form.

A crack of half length a in a square of 6 a, whose rim has the displacement of the infinite plate in closed form (Westergaard, less
the uniform tension), so that no correction for its size is necessary: K_I = p sqrt(pi a), K_II = 0, G = K_I^2 / E'.

    pressed_cracks.py PROGRAM [SEED] [NUMBER] [CELLS]...    errors for CELLS cells in a half length (default 4 8 16)
"""
import json
import math
import os
import random
import subprocess
import sys
import tempfile

A, MODULUS, PRESSURE = 5e-3, 3e9, 1e6

SCENE = """<ParameterList name="Rhegma">
  <ParameterList name="Domain">
    <Parameter name="Dimension" type="int" value="2"/>
    <Parameter name="Plane" type="string" value="%(plane)s"/>
    <Parameter name="Lower Corner" type="Array(double)" value="{%(low)r, %(low)r}"/>
    <Parameter name="Upper Corner" type="Array(double)" value="{%(high)r, %(high)r}"/>
    <Parameter name="Cell Size" type="double" value="%(cell)r"/>
    <Parameter name="Shape Functions" type="string" value="%(shape)s"/>
  </ParameterList>
  <ParameterList name="Time">
    <Parameter name="Analysis" type="string" value="Static"/>
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
    <ParameterList name="Plate">
      <Parameter name="Material" type="string" value="Polymer"/>
      <Parameter name="Shape" type="string" value="Box"/>
      <Parameter name="Particles Per Cell" type="int" value="%(particles)d"/>
      <Parameter name="Lower Corner" type="Array(double)" value="{-%(half)r, -%(half)r}"/>
      <Parameter name="Upper Corner" type="Array(double)" value="{%(half)r, %(half)r}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Boundaries">
    <ParameterList name="Rim">
      <Parameter name="Type" type="string" value="Velocity"/>
      <Parameter name="Nodes" type="string" value="Outside"/>
      <Parameter name="Lower Corner" type="Array(double)" value="{-%(half)r, -%(half)r}"/>
      <Parameter name="Upper Corner" type="Array(double)" value="{%(half)r, %(half)r}"/>
      <Parameter name="Field" type="string" value="
        c = %(c)r; s = %(s)r; a = %(a)r; mu = %(mu)r; k = %(kolosov)r;
        p = c*(x - %(x)r) + s*(y - %(y)r); q = c*(y - %(y)r) - s*(x - %(x)r);
        r = sqrt(sqrt(((p-a)^2 + q^2) * ((p+a)^2 + q^2))); h = (atan2(q, p-a) + atan2(q, p+a))/2;
        f = r*cos(h); g = r*sin(h); m = (p*cos(h) + q*sin(h))/r; n = (q*cos(h) - p*sin(h))/r;
        u = %(pressure)r*((k-1)/2*(f - p) - q*n) / (2*mu);
        v = %(pressure)r*((k+1)/2*g - q*m - (k-1)/2*q) / (2*mu);
        (c*u - s*v)/1e-3, (s*u + c*v)/1e-3"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Cracks">
    <ParameterList name="Notch">
      <Parameter name="Points" type="Array(double)" value="{%(points)s}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Face Pressure">
    <ParameterList name="Notch">
      <Parameter name="Pressure" type="string" value="%(pressure)r"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Energy Release">
    <Parameter name="Crack Closure" type="bool" value="false"/>
  </ParameterList>
  <ParameterList name="Output">
    <Parameter name="Fields" type="bool" value="false"/>
  </ParameterList>
</ParameterList>
"""


def run(program, cells, pick):
    cell = A / cells
    angle = pick.choice([0.0, pick.uniform(0.0, math.pi)])
    c, s = math.cos(angle), math.sin(angle)
    poisson, plane = pick.uniform(0.2, 0.4), pick.choice(["Stress", "Strain"])
    half = 3 * A
    x, y = (cell * pick.uniform(-0.5, 0.5) for _ in range(2))
    values = dict(low=-half - 2 * cell, high=half + 2 * cell, half=half, cell=cell, a=A, c=c, s=s, x=x, y=y, plane=plane, poisson=poisson,
                  modulus=MODULUS, mu=MODULUS / (2 + 2 * poisson), pressure=PRESSURE, shape=pick.choice(["Linear", "GIMP"]),
                  particles=pick.choice([2, 3]),
                  kolosov=(3 - poisson) / (1 + poisson) if plane == "Stress" else 3 - 4 * poisson,
                  points=", ".join(repr(v) for v in (x - A * c, y - A * s, x + A * c, y + A * s)))
    with tempfile.TemporaryDirectory() as folder:
        scene, out = os.path.join(folder, "scene.xml"), os.path.join(folder, "out")
        with open(scene, "w") as file:
            file.write(SCENE % values)
        done = subprocess.run([program, scene, "--output", out, "--quiet"], capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(done.stderr + done.stdout)
        with open(os.path.join(out, "summary.json")) as file:
            fronts = json.load(file)["cracks"][0]["fronts"]
    K = PRESSURE * math.sqrt(math.pi * A)
    G = K * K / MODULUS * (1.0 if plane == "Stress" else 1 - poisson * poisson)
    case = "%-6s %dx%d %s nu %.2f %5.1f deg at %+.2f %+.2f" % (values["shape"], values["particles"], values["particles"], plane, poisson,
                                                              math.degrees(angle), x / cell, y / cell)
    return case, [(100 * (f["K_I"] / K - 1), 100 * f["K_II"] / K, 100 * (f["G_J"] / G - 1), f["tip_offset"] / cell) for f in fronts]


def main():
    program = sys.argv[1]
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 7
    number = int(sys.argv[3]) if len(sys.argv) > 3 else 10
    print("seed %d" % seed)
    for cells in [int(text) for text in sys.argv[4:]] or [4, 8, 16]:
        pick, all = random.Random(seed), []
        print("%d cells in a half length; of each front: K_I, %%; K_II in %% of K_I; G_J, %%; tip offset, cells" % cells)
        for _ in range(number):
            case, errors = run(program, cells, pick)
            print(case, "; ".join("%+.2f %+.2f %+.2f %+.2f" % e for e in errors), flush=True)
            all += errors
        for name, column in (("K_I", 0), ("K_II", 1), ("G_J", 2)):
            values = [e[column] for e in all]
            print("%-5s mean %+.2f rms %.2f from %+.2f to %+.2f %%" % (
                name, sum(values) / len(values), math.sqrt(sum(v * v for v in values) / len(values)), min(values), max(values)))


main()
