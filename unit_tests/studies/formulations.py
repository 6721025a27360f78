#!/usr/bin/env python3
"""Scenes with their cells in the deformed and in the undeformed body: the tables of docs/explanation/total-lagrangian.md.

    unit_tests/studies/formulations.py build/serial/rhegma                      all scenes of xml_inputs/verification
    unit_tests/studies/formulations.py build/serial/rhegma dcb_h8 penny         some of them
    unit_tests/studies/formulations.py build/serial/rhegma --drift              an edge crack in a body that flies through the cells

The first prints the errors of both relative to the references of the scene, and processor seconds on one thread of both as whole processes;
a scene that one of them refuses has its sentence. The second prints G over its value in a body at rest, by the distance flown."""

import argparse
import csv
import glob
import json
import math
import os
import resource
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.realpath(__file__))
INPUTS = os.path.join(HERE, "../../xml_inputs")
KINDS = ("Updated Lagrangian", "Total Lagrangian")


def run(program, scene, kind, *settings):
    """(summary, rows of the history, processor seconds), or the program's message."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        more = [word for setting in (f"Domain:Formulation={kind}", *settings) for word in ("--set", setting)]
        done = subprocess.run([program, scene, "--output", folder, "--quiet", *more], stderr=subprocess.PIPE, stdout=subprocess.DEVNULL,
                              env=dict(os.environ, OMP_NUM_THREADS="1"), check=False)
        if done.returncode not in (0, 4):
            return done.stderr.decode().strip().replace("\n", " ")[:160]
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        with open(os.path.join(folder, "history.csv"), newline="", encoding="utf-8") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return summary, rows, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def short(quantity):
    parts = quantity.split(".")
    return parts[-1] + (f", front {parts[3]}" if len(parts) > 3 and parts[3] != "0" else "")


def compare(program, names):
    print("| scene | quantity | updated, % | total, % | tolerance, % | updated s | total s |\n|:--|:--|--:|--:|--:|--:|--:|")
    for name in names:
        results = [run(program, os.path.join(INPUTS, "verification", name + ".xml"), kind) for kind in KINDS]
        wrong = [result for result in results if isinstance(result, str)]
        if wrong:
            print(f"| {name} | {wrong[0]} | | | | | |", flush=True)
            continue
        found = [{one["quantity"]: one for one in result[0].get("references", [])} for result in results]
        times = f"{results[0][2]:.2f} | {results[1][2]:.2f}"
        for quantity, one in found[0].items():
            other = found[1].get(quantity)
            if other is None or None in (one["value"], other["value"]) or one["reference"] == 0.0:
                continue
            errors = [100.0 * (value / one["reference"] - 1.0) for value in (one["value"], other["value"])]
            print(f"| {name} | {short(quantity)} | {errors[0]:+.2f} | {errors[1]:+.2f} | {100 * one['tolerance']:.2f} | {times} |", flush=True)
            name, times = "", " | "


def drift(program):
    """The strip of examples/edge_crack.xml without damping, thrown along 30 degrees, at the time of the first wave."""
    scene = os.path.join(INPUTS, "examples", "edge_crack.xml")
    duration = 1e-4
    base = ("Time:Final Time=1e-4", "Damping:Mass Rate=0", "Damping:Stop When Settled=false", "Output:History Interval=1e-5")
    print("| flown, cells | updated | total |\n|--:|--:|--:|")
    still = None
    for cells in (0.0, 0.1, 0.3, 1.0, 3.0):
        speed = cells * 1.25e-3 / duration
        velocity = f"Bodies:Strip:Velocity={{{speed * math.cos(math.pi / 6)!r}, {speed * math.sin(math.pi / 6)!r}}}"
        results = [run(program, scene, kind, *base, velocity) for kind in KINDS]
        for result in results:
            if isinstance(result, str):
                sys.exit(result)
        ends = [result[1][-1]["Notch.0.G_J"] for result in results]
        still = still or ends
        print(f"| {cells:g} | {ends[0] / still[0]:.4f} | {ends[1] / still[1]:.4f} |", flush=True)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("scenes", nargs="*")
    options.add_argument("--drift", action="store_true", help="the second table")
    given = options.parse_args()
    if given.drift:
        drift(given.program)
    else:
        every = sorted(os.path.basename(path)[:-4] for path in glob.glob(os.path.join(INPUTS, "verification", "*.xml")))
        compare(given.program, given.scenes or every)


if __name__ == "__main__":
    main()
