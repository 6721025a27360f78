#!/usr/bin/env python3
"""K_I of an edge crack in a quenched plate over time, in quasi-static equilibrium, against the weight function.

    quench.py PROGRAM [CELL_IN_MM] [LOAD_STEPS]

The scene is xml_inputs/verification/quench_static.xml. The temperature of the plate is the series solution of one dimension, its
stress without a crack that of a long plate free of forces, and K the integral of that stress with the weight function of an edge
crack (Bueckner, Z. Angew. Math. Mech. 51 (1971) 97), which for tension and bending is within 0.5 % of Kaya and Erdogan (Q. Appl.
Math. 45 (1987) 105). The column `depth` is the depth sqrt(4 D t) of the cold layer in cells, D the diffusivity: fewer than
two cells do not resolve the stress of the layer.
"""
import csv
import os
import subprocess
import sys
import tempfile
import time

import numpy

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../xml_inputs/verification/quench_static.xml")
WIDTH, LENGTH, FALL = 10e-3, 2e-3, -100.0
MODULUS, POISSON, EXPANSION, DIFFUSIVITY = 70e9, 0.22, 9e-6, 1.0 / (2500 * 800)
TIMES = (0.2, 0.5, 1.0, 2.0, 3.0, 4.0)


def warming(x, t):
    """Change of temperature [K] at x [m] of a plate with one side held and the other insulated."""
    k = (2 * numpy.arange(400)[:, None] + 1) * numpy.pi / (2 * WIDTH)
    return FALL * (1 - (2 / (WIDTH * k) * numpy.sin(k * x) * numpy.exp(-DIFFUSIVITY * k * k * t)).sum(0))


def stress(x, t):
    """Stress across the crack's line [Pa], plane strain, no resultant force or moment."""
    at = numpy.linspace(0, WIDTH, 20001)
    rise = warming(at, t)
    mean = numpy.trapz(rise, at) / WIDTH
    moment = numpy.trapz(rise * (at - WIDTH / 2), at)
    strained = mean + 12 * (x - WIDTH / 2) * moment / WIDTH**3 - warming(x, t)
    return MODULUS * EXPANSION / (1 - POISSON) * strained


def intensity(t):
    """K_I [Pa m^0.5] at time t [s]."""
    r = LENGTH / WIDTH
    u, weight = numpy.polynomial.legendre.leggauss(200)
    u, weight = (u + 1) / 2, weight / 2  # x = a (1 - u^2), which takes the root singularity away
    m1 = 0.6147 + 17.1844 * r**2 + 8.7822 * r**6
    m2 = 0.2502 + 3.2889 * r**2 + 70.0444 * r**6
    m = (2 / (numpy.pi * LENGTH))**0.5 * (1 + m1 * u**2 + m2 * u**4)
    return float((weight * stress(LENGTH * (1 - u**2), t) * m * 2 * LENGTH).sum())


def main():
    program = sys.argv[1]
    sets, cell = [], 1e-3 * float(sys.argv[2] if len(sys.argv) > 2 else 0.5)
    if len(sys.argv) > 2:
        sets += ["--set", "Domain:Cell Size=%r" % cell]
    if len(sys.argv) > 3:
        sets += ["--set", "Time:Load Steps=%d" % int(sys.argv[3])]
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        done = subprocess.run([program, SCENE, "--output", folder, "--quiet"] + sets, capture_output=True, text=True)
        seconds = time.perf_counter() - start
        if done.returncode not in (0, 4):
            raise RuntimeError(done.stderr)
        with open(os.path.join(folder, "history.csv")) as file:
            rows = [(float(row["time"]), float(row["Notch.0.K_I"])) for row in csv.DictReader(file)]
    print("%8s %8s %14s %8s" % ("t [s]", "depth", "K_I [Pa m^0.5]", "error %"))
    for t in TIMES:
        at, found = min(rows, key=lambda row: abs(row[0] - t))
        exact = intensity(at)
        print("%8.3g %8.1f %14.0f %8.2f" % (at, (4 * DIFFUSIVITY * at)**0.5 / cell, found, 100 * (found / exact - 1)))
    print("%.1f s" % seconds)


if __name__ == "__main__":
    main()
