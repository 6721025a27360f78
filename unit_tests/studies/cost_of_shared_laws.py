#!/usr/bin/env python3
"""What laws of shared libraries cost: the table of docs/how-to/law-of-your-own.md.

    unit_tests/studies/cost_of_shared_laws.py build/serial/rhegma [--runs 5] [--cells 64]

A bar that flows on impact, with the built-in `J2 Plastic` and with laws of the same equations (unit_tests/laws), which rhegma-law compiles: VUMAT in C
and in Fortran, a behaviour of MFront's interface, a UMAT. Each run is of one thread; runs of all laws alternate. Prints the processor time of a whole
run per particle and step of each law as a multiple of the built-in one's: the median of the ratios of each round, with the smallest and largest."""

import argparse
import json
import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "program"))
sys.dont_write_bytecode = True
os.environ.setdefault("RHEGMA_PROGRAM", "rhegma")
os.environ.setdefault("RHEGMA_SOURCE_DIR", os.path.join(HERE, "..", ".."))

from test_shared_laws import BUILT_IN, LAWS, law, struck  # noqa: E402

SOURCES = {"VUMAT in C": ("j2_vumat.c", "VUMAT", {}), "VUMAT in Fortran": ("j2_vumat.f90", "VUMAT", {}),
           "MFront": ("j2_generic.c", "MFront", {"Behaviour": "J2"}), "UMAT in C": ("j2_umat.c", "UMAT", {"State_Variables": 1})}


def libraries(folder):
    """{name: material} of the laws that can be compiled here."""
    built = {"J2 Plastic": BUILT_IN}
    for name, (source, interface, more) in SOURCES.items():
        if source.endswith("90") and shutil.which("gfortran") is None:
            continue
        path = os.path.join(folder, source + ".so")
        subprocess.run([sys.executable, os.path.join(HERE, "..", "..", "tools", "rhegma-law"), os.path.join(LAWS, source), "-o", path], check=True,
                       stdout=subprocess.DEVNULL)
        built[name] = law(path, interface, **more)
    return built


def scene_of(material, dimension, cells):
    """The struck bar with as many cells along it, for 60 steps or so."""
    scene = struck(material, dimension)
    edge = 0.8 / cells
    scene.set("Domain > Cell Size", edge)
    return scene.set("Time > Final Time", 20.0 * edge / 5200.0)  # of waves of 5200 m/s over 20 cells


def seconds_per_particle_step(program, scene, folder):
    path = os.path.join(folder, "scene.xml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(scene.text())
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, path, "--output", os.path.join(folder, "out"), "--quiet"], check=True, stdout=subprocess.DEVNULL,
                   env=dict(os.environ, OMP_NUM_THREADS="1"))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(os.path.join(folder, "out", "summary.json"), encoding="utf-8") as file:
        steps = json.load(file)["particle_steps"]
    return (after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime) / steps


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--runs", type=int, default=5, help="rounds (5)")
    parser.add_argument("--cells", type=int, nargs=2, default=(160, 36), metavar=("IN2D", "IN3D"), help="cells along the bar (160 36)")
    chosen = parser.parse_args()
    print("| law | 2D | 3D |\n|:--|--:|--:|")
    with tempfile.TemporaryDirectory() as folder:
        materials = libraries(folder)
        ratios = {name: [] for name in materials}
        for dimension, cells in zip((2, 3), chosen.cells):
            rounds = [{name: seconds_per_particle_step(os.path.abspath(chosen.program), scene_of(material, dimension, cells), folder)
                       for name, material in materials.items()} for _ in range(chosen.runs)]
            for name in materials:
                found = sorted(one[name] / one["J2 Plastic"] for one in rounds)
                ratios[name].append(f"{statistics.median(found):.2f} ({found[0]:.2f} to {found[-1]:.2f})")
        for name in materials:
            print(f"| {name} | {ratios[name][0]} | {ratios[name][1]} |")


if __name__ == "__main__":
    main()
