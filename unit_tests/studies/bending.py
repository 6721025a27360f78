#!/usr/bin/env python3
"""Bending with few cells, with shear strain at the particles and at the cells' centres (Domain > Shear Strain).

    bending.py PROGRAM dcb     xml_inputs/verification/dcb_static.xml with 2 to 16 cells an arm: error of G over positions of the front
                               in its cell, linear functions and GIMP, 2 x 2 and 3 x 3 particles
    bending.py PROGRAM dU      the same by the change of the strain energy with the crack's length, without a contour
    bending.py PROGRAM turned  bars on three supports, 4 and 8 cells high, at random positions and angles to the cells: error of the
                               strain energy against the same bar along fine cells
    bending.py PROGRAM outline the same bars as polygons, whose particles are in rows along the cells and are cut by the bar's edges
    bending.py PROGRAM period  first period of a cantilever that is let go, 4 cells high, against fine cells; energy
"""
import argparse
import concurrent.futures
import csv
import json
import math
import os
import random
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../program"))

from scenes import Scene  # noqa: E402

DCB = os.path.join(HERE, "../../xml_inputs/verification/dcb_static.xml")
PLACES = ("At Particles", "At Cell Centres")
SEED = 24


def run(program, scene, sets=()):
    """Summary and history of a scene, a path or a Scene."""
    with tempfile.TemporaryDirectory() as folder:
        path = scene
        if isinstance(scene, Scene):
            path = os.path.join(folder, "scene.xml")
            with open(path, "w") as file:
                file.write(scene.text())
        command = [program, path, "--output", os.path.join(folder, "out"), "--quiet"]
        for value in sets:
            command += ["--set", value]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 4):
            raise RuntimeError(done.stderr)
        with open(os.path.join(folder, "out/summary.json")) as file:
            summary = json.load(file)
        with open(os.path.join(folder, "out/history.csv"), newline="") as file:
            head, *rows = csv.reader(file)
        return summary, {name: [float(row[k]) for row in rows] for k, name in enumerate(head)}


def statistics(name, values):
    mean = sum(values) / len(values)
    rms = math.sqrt(sum(v * v for v in values) / len(values))
    print("%s: mean %+.2f, rms %.2f, %+.2f to %+.2f of %d" % (name, mean, rms, min(values), max(values), len(values)),
          flush=True)


def beam_sets(cells, shape, particles, front, place):
    h = 0.01 / cells
    a = 0.05 + front * h
    return h, a, ["Domain:Cell Size=%r" % h, "Domain:Shear Strain=" + place, "Domain:Shape Functions=" + shape,
                  "Bodies:Beam:Particles Per Cell=%d" % particles, "Cracks:Notch:Points={0, 0.01, %r, 0.01}" % a]


def reference(a):
    """G of the beam [J/m2], from that at 50 mm (docs/explanation/verification/beams.md): of P^2 (a + 0.67 h)^2, the beam on its elastic foundation."""
    return 0.12873 * ((a + 0.0067) / 0.0567) ** 2


def dcb(program, pool, by_energy):
    for cells in (2, 4, 8, 16):
        for shape in ("Linear", "GIMP"):
            for particles in (2, 3):
                for place in PLACES:
                    fronts = [k / 10 for k in range(10)] if cells < 16 else [0, 0.3, 0.6]
                    measure = energy_release if by_energy else contour
                    jobs = [(beam_sets(cells, shape, particles, front, place)[1],
                             pool.submit(measure, program, cells, shape, particles, front, place)) for front in fronts]
                    statistics("%d cells an arm, %s, %d x %d particles, %s: error of G, %%"
                               % (cells, shape, particles, particles, place),
                               [100 * (job.result() / reference(a) - 1) for a, job in jobs])


def contour(program, cells, shape, particles, front, place):
    _, _, sets = beam_sets(cells, shape, particles, front, place)
    return run(program, DCB, sets)[0]["cracks"][0]["fronts"][0]["G_J"]


def energy_release(program, cells, shape, particles, front, place):
    """dU/da under the given loads, over two cells."""
    energy = []
    for side in (-1, 1):
        h, _, sets = beam_sets(cells, shape, particles, front + side, place)
        energy.append(run(program, DCB, sets)[0]["energy"]["strain"])
    return (energy[1] - energy[0]) / (2 * h)


def bar(cells, degrees, offset, place, shape="GIMP", particles=2, length=10.0):
    """A bar of unit height on three supports: parabolic shear at its ends and its middle."""
    h = 1.0 / cells
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def at(x, y):
        return [offset[0] * h + c * x - s * y, offset[1] * h + s * x + c * y]

    loads = {}
    for name, x, force in (("Left", -0.5 * length + 0.5, 0.5e-6), ("Middle", 0.0, -1e-6),
                           ("Right", 0.5 * length - 0.5, 0.5e-6)):
        loads[name] = {"Type": "Line Load", "Body": "Bar", "From": at(x, -0.5), "To": at(x, 0.5), "Profile": "Parabolic",
                       "Force": [-s * force, c * force]}
    r = 0.5 * length + 1
    return Scene({
        "Domain": {"Dimension": 2, "Plane": "Stress", "Lower Corner": [-r, -r], "Upper Corner": [r, r], "Cell Size": h,
                   "Shape Functions": shape, "Shear Strain": place},
        "Time": {"Analysis": "Static", "Rigid Modes": "Remove", "Final Time": 1.0},
        "Materials": {"Solid": {"Model": "Linear Elastic", "Density": 1.0, "Young Modulus": 1.0, "Poisson Ratio": 0.33}},
        "Bodies": {"Bar": {"Material": "Solid", "Shape": "Box",
                           "Lower Corner": [offset[0] * h - 0.5 * length, offset[1] * h - 0.5],
                           "Upper Corner": [offset[0] * h + 0.5 * length, offset[1] * h + 0.5],
                           "Rotation": float(degrees), "Particles Per Cell": particles}},
        "Boundaries": loads,
        "Output": {},
    })


def as_polygon(scene):
    """The bar of bar() as a polygon: the rows of its particles lie along the axes."""
    box = {name: scene.find("Bodies > Bar > " + name).get("value") for name in ("Lower Corner", "Upper Corner", "Rotation")}
    (x0, y0), (x1, y1) = ([float(v) for v in box[name].strip("{}").split(",")] for name in ("Lower Corner", "Upper Corner"))
    turn = complex(math.cos(math.radians(float(box["Rotation"]))), math.sin(math.radians(float(box["Rotation"]))))
    middle = complex(x0 + x1, y0 + y1) / 2
    points = [middle + turn * (complex(*corner) - middle) for corner in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
    scene.set("Bodies > Bar > Shape", "Polygon")
    scene.set("Bodies > Bar > Points", [v for point in points for v in (point.real, point.imag)])
    for name in box:
        scene.remove("Bodies > Bar > " + name)
    return scene


def turned(program, pool, number, change=lambda scene: scene, places=PLACES):
    exact = run(program, bar(32, 0.0, [0.0, 0.0], "At Particles"))[0]["energy"]["strain"]
    coarser = run(program, bar(16, 0.0, [0.0, 0.0], "At Particles"))[0]["energy"]["strain"]
    print("strain energy of the bar with 16 and 32 cells: %.6e, %.6e" % (coarser, exact))
    exact += (exact - coarser) / 3
    pick = random.Random(SEED)
    for cells in (4, 8):
        for low, high in ((0, 0), (0, 5), (5, 10), (10, 20), (20, 45)):
            cases = [(pick.uniform(low, high), [pick.random(), pick.random()]) for _ in range(number)]
            for shape in ("Linear", "GIMP"):
                for particles in (2, 3):
                    for place in places:
                        jobs = [pool.submit(run, program, change(bar(cells, degrees, offset, place, shape, particles)))
                                for degrees, offset in cases]
                        statistics("%d cells, %d to %d degrees, %s, %d x %d particles, %s: error of the strain energy, %%"
                                   % (cells, low, high, shape, particles, particles, place),
                                   [100 * (job.result()[0]["energy"]["strain"] / exact - 1) for job in jobs])


def cantilever(cells, place, shape, particles, scheme):
    """Eight times as long as high; the load is taken off at the start."""
    h, length = 1.0 / cells, 8.0
    periods = 6 * 2 * math.pi / (1.875104**2 * math.sqrt(1 / 12.0) / length**2)
    return Scene({
        "Domain": {"Dimension": 2, "Plane": "Stress", "Lower Corner": [-2.0, -3.0], "Upper Corner": [10.0, 4.0], "Cell Size": h,
                   "Shape Functions": shape, "Shear Strain": place},
        "Time": {"Final Time": periods, "Update Scheme": scheme, "Initial State": "Equilibrium"},
        "Materials": {"Solid": {"Model": "Neo-Hookean", "Density": 1.0, "Young Modulus": 1.0, "Poisson Ratio": 0.33}},
        "Bodies": {"Bar": {"Material": "Solid", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [length, 1.0],
                           "Particles Per Cell": particles}},
        "Boundaries": {
            "Clamp": {"Type": "Velocity", "Lower Corner": [-1.0, -1.0], "Upper Corner": [1e-6, 2.0], "Value": [0.0, 0.0]},
            "Load": {"Type": "Line Load", "Body": "Bar", "From": [length, 0.0], "To": [length, 1.0], "Profile": "Parabolic",
                     "Force": [0.0, 1e-6], "History": "0:1, 1e-3:0, 1e9:0"}},
        "Output": {"History Interval": periods / 600},
    }), periods / 6


def fitted_period(times, values, guess):
    """Of the harmonic that fits best, by least squares."""

    def left(period):
        w = 2 * math.pi / period
        cc = sum(math.cos(w * t) ** 2 for t in times)
        ss = sum(math.sin(w * t) ** 2 for t in times)
        cs = sum(math.sin(w * t) * math.cos(w * t) for t in times)
        yc = sum(y * math.cos(w * t) for t, y in zip(times, values))
        ys = sum(y * math.sin(w * t) for t, y in zip(times, values))
        det = cc * ss - cs * cs
        return -(ss * yc * yc - 2 * cs * yc * ys + cc * ys * ys) / det

    low, high = 0.9 * guess, 1.2 * guess
    grid = [low + (high - low) * k / 200 for k in range(201)]
    best = min(range(201), key=lambda k: left(grid[k]))
    low, high = grid[max(best - 1, 0)], grid[min(best + 1, 200)]
    for _ in range(60):
        third = (high - low) / 3
        if left(low + third) < left(high - third):
            high -= third
        else:
            low += third
    return 0.5 * (low + high)


def released(program, cells, place, shape, particles, scheme):
    """Period of the first mode, and energy at the end against that at the start."""
    scene, guess = cantilever(cells, place, shape, particles, scheme)
    _, history = run(program, scene)
    energy = [k + e for k, e in zip(history["kinetic"], history["strain"])]
    return fitted_period(history["time"], history["momentum_y"], guess), energy[-1] / energy[1]


def period(program, pool):
    cases = [(cells, place, shape, particles, scheme) for cells in (4, 8) for shape in ("Linear", "GIMP")
             for particles in (2, 3) for scheme in ("MUSL", "USAVG") for place in PLACES]
    jobs = [pool.submit(released, program, *case) for case in cases]
    # Both places converge with the square of the cells, from both sides: 8 and 16 cells, 3 x 3 particles.
    ends = [[released(program, cells, place, "GIMP", 3, "MUSL")[0] for cells in (8, 16)] for place in PLACES]
    limits = [fine + (fine - coarse) / 3 for coarse, fine in ends]
    print("period, extrapolated from both places: %.3f, %.3f" % tuple(limits))
    converged = sum(limits) / 2
    for case, job in zip(cases, jobs):
        length, kept = job.result()
        print("%d cells, shear %s, %s, %d particles, %s: period %+.2f %%, energy kept over six periods %.4f"
              % (*case, 100 * (length / converged - 1), kept), flush=True)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("case", choices=["dcb", "dU", "turned", "outline", "period"])
    options.add_argument("--number", type=int, default=8, help="of random bars for each range of angles")
    chosen = options.parse_args()
    print("seed %d" % SEED)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        if chosen.case in ("dcb", "dU"):
            dcb(chosen.program, pool, chosen.case == "dU")
        elif chosen.case == "turned":
            turned(chosen.program, pool, chosen.number)
        elif chosen.case == "outline":
            turned(chosen.program, pool, chosen.number, as_polygon, PLACES[:1])
        else:
            period(chosen.program, pool)


if __name__ == "__main__":
    main()
