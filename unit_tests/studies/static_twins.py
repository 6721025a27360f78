#!/usr/bin/env python3
"""Scenes that are damped until they rest next to the same scenes in static equilibrium: the table of docs/explanation/verification/equilibrium.md.

    unit_tests/studies/static_twins.py build/serial/rhegma
    unit_tests/studies/static_twins.py build/serial/rhegma dcb_h4 penny_tilted

Each xml_inputs/verification/NAME_static.xml that has a damped NAME.xml, in alphabetical order; then scenes of xml_inputs/studies/scenes, which
this script damps: at twice the angular frequency of the block's lowest mode along its length, until G changes by less than a
hundred-thousandth. Prints the errors of both relative to the
references that they have in common, their difference in percentage points, and processor seconds on one thread of both as whole processes."""

import glob
import json
import math
import os
import resource
import shutil
import subprocess
import sys
import tempfile

INPUTS = os.path.join(os.path.dirname(os.path.realpath(__file__)), "../../xml_inputs/verification")
STUDIES = os.path.join(INPUTS, "../studies/scenes")
LENGTHS = {"ellipse": 0.12, "lens": 0.064}  # of the blocks of scenes that this script damps [m]
WAVES = math.sqrt(3e9 / 1200)  # in a bar of their material [m/s]
DAMPED = {"dcb": "dcb_h8"}  # whose name differs
# Final time [s] and drift until which a damped run goes on that its own scene ends before it rests.
UNTIL_REST = {"penny_pressure": ("3e-4", "1e-6")}


DAMPING = """  <ParameterList name="Damping">
    <Parameter name="Mass Rate" type="double" value="%r"/>
    <Parameter name="Stop When Settled" type="bool" value="true"/>
    <Parameter name="Settled Drift" type="double" value="1e-5"/>
  </ParameterList>
  <ParameterList name="Energy Release"""


def damped_scene(name, folder):
    """Path of a scene of STUDIES in motion, without the ending .xml."""
    for file in os.listdir(STUDIES):
        if file.startswith(name):
            shutil.copy(os.path.join(STUDIES, file), folder)
    with open(os.path.join(folder, name + "_static.xml"), encoding="utf-8") as file:
        lines = [line for line in file if '"Analysis"' not in line and '"Rigid Modes"' not in line]
    text = "".join(lines).replace('  <ParameterList name="Energy Release', DAMPING % (2 * math.pi * WAVES / LENGTHS[name]), 1)
    with open(os.path.join(folder, name + ".xml"), "w", encoding="utf-8") as file:
        file.write(text)
    return os.path.join(folder, name)


def until_rest(name):
    """Options of a damped run."""
    if name not in UNTIL_REST:
        return []
    time, drift = UNTIL_REST[name]
    return ["--set", "Time:Final Time=" + time, "--set", "Damping:Settled Drift=" + drift]


def run(program, name, *options):
    """({quantity: (value, reference)}, processor seconds) \\param name a path from INPUTS"""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, os.path.join(INPUTS, name + ".xml"), "--output", folder, "--quiet", *options], stderr=subprocess.DEVNULL,
                              env=dict(os.environ, OMP_NUM_THREADS="1"))
        if done.returncode not in (0, 4):
            sys.exit(f"{name}: exit status {done.returncode}")
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            references = json.load(file)["references"]
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return ({one["quantity"]: (one["value"], one["reference"]) for one in references if one["reference"] != 0.0},
            after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)


def short(quantity):
    """cracks.0.fronts.1.K_I as K_I, front 1"""
    parts = quantity.split(".")
    return parts[-1] + (f", front {parts[3]}" if len(parts) > 3 and parts[3] != "0" else "")


def twins(program, name):
    """What `run` gives, of the damped and of the static scene."""
    if name not in LENGTHS:
        return run(program, DAMPED.get(name, name), *until_rest(name)), run(program, name + "_static")
    with tempfile.TemporaryDirectory() as folder:
        return run(program, damped_scene(name, folder)), run(program, os.path.join(STUDIES, name + "_static"))


def names():
    for path in sorted(glob.glob(os.path.join(INPUTS, "*_static.xml"))):
        name = os.path.basename(path)[:-len("_static.xml")]
        if os.path.exists(os.path.join(INPUTS, DAMPED.get(name, name) + ".xml")):
            yield name
    yield from sorted(LENGTHS)


def main(program, chosen):
    print("| scene | quantity | damped, error % | static, error % | points | damped s | static s | ratio |\n|:--|:--|--:|--:|--:|--:|--:|--:|")
    for name in chosen:
        (damped, slow), (static, fast) = twins(program, name)
        times = f"{slow:.2f} | {fast:.2f} | {slow / fast:.0f}"
        if not static.keys() & damped.keys():
            sys.exit(f"{name}: no common references")
        for quantity in static:
            if quantity not in damped:
                continue
            errors = [100.0 * (value / reference - 1.0) for value, reference in (damped[quantity], static[quantity])]
            print(f"| {name} | {short(quantity)} | {errors[0]:+.2f} | {errors[1]:+.2f} | {errors[1] - errors[0]:+.2f} | {times} |", flush=True)
            name, times = "", " | |"


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:] or list(names()))
