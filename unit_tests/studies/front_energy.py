#!/usr/bin/env python3
"""J of a penny-shaped crack in equilibrium against the derivative of the strain energy by its radius.

    front_energy.py PROGRAM [SEED]

A block of 24 cells under tension, and disks of 5 to 7 cells anywhere in their cells. At given loads the strain energy grows by G 2 pi a da. The
derivative is that of a polynomial of the third degree through nine radii; what is left of the lag of the front in its cell varies by
1 to 2 % of G from radius to radius, so compare the means. Prints G_J, the derivative, and their ratio."""
import math
import os
import random
import re
import subprocess
import sys
import tempfile

import numpy as np

sys.dont_write_bytecode = True
from cracks_3d import MODULUS, POISSON, SCENE, STRESS, TENSION, crack_of  # noqa: E402
import json  # noqa: E402

CELL, HALF = 1e-3, 12e-3


def run(program, radius, centre):
    """(J, strain energy)"""
    with tempfile.TemporaryDirectory() as folder:
        crack, _ = crack_of("tension", radius, centre, folder)
        values = dict(low=-HALF - 2 * CELL, high=HALF + 2 * CELL, bottom=-HALF, top=HALF, side=2 * HALF, cell=CELL, shape="Linear", levels=0,
                      modulus=MODULUS, poisson=POISSON, stress=STRESS, around=5.0, crack=crack)
        values["loads"] = TENSION % values
        text = re.sub(r'  <ParameterList name="Adaptivity">.*?</ParameterList>\n', "", SCENE, flags=re.S) % values
        scene, out = os.path.join(folder, "scene.xml"), os.path.join(folder, "out")
        with open(scene, "w", encoding="utf-8") as file:
            file.write(text)
        subprocess.run([program, scene, "--output", out, "--quiet"], check=True, stderr=subprocess.DEVNULL)
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            found = json.load(file)
    return found["cracks"][0]["fronts"][0]["G_J"], found["energy"]["strain"]


def main():
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    pick = random.Random(seed)
    centre = [CELL * pick.uniform(-0.5, 0.5) for _ in range(3)]
    radii = np.linspace(5 * CELL, 7 * CELL, 9)
    found = np.array([run(sys.argv[1], float(a), centre) for a in radii])
    x = radii / radii[-1]
    slope = np.polyval(np.polyder(np.polyfit(x, found[:, 1], 3)), x) / radii[-1] / (2 * math.pi * radii)
    print("seed %d\nradius [cells]   G_J [J/m2]   derivative   ratio" % seed)
    for a, G, derivative in list(zip(radii, found[:, 0], slope))[2:-2]:
        print("%14.2f %12.5f %12.5f %7.4f" % (a / CELL, G, derivative, G / derivative))
    print("mean ratio %.4f" % np.mean((found[:, 0] / slope)[2:-2]))


if __name__ == "__main__":
    main()
