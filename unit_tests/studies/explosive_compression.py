#!/usr/bin/env python3
"""Uniaxial compression of PBX 9501 by the law ViscoSCRAM at three rates: peak stress and the strain there.

    explosive_compression.py                    by the equations of the papers (unit_tests/program/cracked_solid.py), with scipy
    explosive_compression.py PROGRAM            also by the program, in equilibrium: a block in plane stress, free at its side
    explosive_compression.py --picture FILE     draws the curves of the equations (docs/pictures/viscoscram.png)

What was measured is stated from memory and was not verified with the papers: G. T. Gray, D. J. Idar, W. R. Blumenthal, C. M. Cady, P. D. Peterson,
11th International Detonation Symposium, 1998, find some 8 to 10 MPa at 1e-3 1/s and some 55 to 60 MPa at 2000 1/s near 293 K, at strains of 1.5
to 3 %. Bennett, Haberman, Johnson, Asay, Henson (1998) fitted the constants to such tests. No measurement at 1 1/s is known to the author."""

import argparse
import csv
import os
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "program"))
sys.dont_write_bytecode = True

from cracked_solid import CrackedSolid  # noqa: E402
from scenes import Scene  # noqa: E402

RATES = [1e-3, 1.0, 2000.0]  # [1/s]
STRAIN = 0.05
KNOWN = {1e-3: "8 to 10 MPa", 1.0: "not known", 2000.0: "55 to 60 MPa"}


def pressed(solid, rate):
    """A block of one by one cells that its right edge presses at a constant rate of true strain."""
    low, high, end = [-1.0, -1.0], [3.0, 3.0], STRAIN / rate
    return Scene({
        "Domain": {"Dimension": 2, "Plane": "Stress", "Lower Corner": low, "Upper Corner": high, "Cell Size": 0.5},
        "Time": {"Analysis": "Quasi-Static", "Final Time": end, "Load Steps": 500},
        "Materials": {"Explosive": solid.parameters()},
        "Bodies": {"Block": {"Material": "Explosive", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [1.0, 1.0]}},
        "Boundaries": {
            "Left": {"Type": "Symmetry", "Axis": "x", "Position": 0.0, "Side": "Lower"},
            "Below": {"Type": "Symmetry", "Axis": "y", "Position": 0.0, "Side": "Lower"},
            "Right": {"Type": "Velocity", "Nodes": "Outside", "Lower Corner": [-1.0, -1.0], "Upper Corner": [1.0, 3.0], "Components": "x",
                      "Value": [-rate, 0.0], "History": f"exp(-{rate!r}*t)"},
        },
        "Output": {"History Interval": end / 500, "Fields": False, "Checkpoints": False},
    })


def by_program(program, solid, rate):
    """Strains and stresses of the run, as far as it came."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.xml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(pressed(solid, rate).text())
        answer = subprocess.run([program, path, "--quiet", "--output", folder], check=False, capture_output=True, text=True)
        if answer.returncode != 0:
            print(answer.stderr)
        with open(os.path.join(folder, "history.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    # The work per undeformed volume and strain: the Kirchhoff stress, J times the true stress.
    time, work = (numpy.array([float(row[name]) for row in rows]) for name in ("time", "external_work"))
    return rate * 0.5 * (time[1:] + time[:-1]), numpy.diff(work) / numpy.diff(time) / rate


def draw(curves, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 3.6), constrained_layout=True)
    for rate, (strain, stress, radius) in curves.items():
        left.plot(100 * strain, stress / 1e6, label=f"{rate:g} 1/s")
        cube = (radius / CrackedSolid().scale) ** 3
        right.plot(100 * strain, cube / (1 + cube))
    left.set(xlabel="strain [%]", ylabel="stress [MPa]", title="Uniaxial compression of PBX 9501")
    right.set(xlabel="strain [%]", ylabel="damage", title="Damage")
    left.legend()
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.set(xlim=(0, 100 * STRAIN), ylim=(0, None))
    figure.savefig(path, dpi=110)
    print(f"wrote {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?")
    parser.add_argument("--picture")
    given = parser.parse_args()
    solid = CrackedSolid()
    curves = {rate: solid.pressed(rate, STRAIN) for rate in RATES}
    print("| rate [1/s] | peak stress [MPa] | strain there [%] | radius there [mm] | measured (from memory) |\n|--:|--:|--:|--:|:--|")
    for rate, (strain, stress, radius) in curves.items():
        at = stress.argmax()
        print(f"| {rate:g} | {stress[at] / 1e6:.1f} | {100 * strain[at]:.2f} | {1e3 * radius[at]:.3f} | {KNOWN[rate]} |", flush=True)
    if given.picture:
        draw(curves, given.picture)
    if given.program:
        print("\n| rate [1/s] | peak stress of the program [MPa] | strain there [%] |\n|--:|--:|--:|")
        for rate in RATES:
            strain, stress = by_program(os.path.abspath(given.program), solid, rate)
            at = stress.argmax()
            print(f"| {rate:g} | {stress[at] / 1e6:.1f} | {100 * strain[at]:.2f} |", flush=True)


if __name__ == "__main__":
    main()
