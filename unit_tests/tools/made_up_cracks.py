#!/usr/bin/env python3
"""Stands in for rhegma with a body whose compliance is 1e-3 a^3 m/N, a the length of its crack [m], or the radius of its disk.

A file load.xml has a force of 10 N, grips.xml an opening of 2 mm, pressure.xml a pressure whose work is that of 10 N; disk.xml the force
and a disk, a quarter of which is in the body. Cells have 0.1 m. A crack longer than 2.5 m exits with 2."""

import json
import math
import os
import sys

arguments = sys.argv[1:]
if "--check" in arguments:
    sys.exit(0)
case = os.path.basename(arguments[0]).split(".")[0]
length = 2.0
for i, argument in enumerate(arguments):
    if argument == "--set":
        path, value = arguments[i + 1].split("=", 1)
        if path == "Cracks:Notch:Points":
            x = [float(text) for text in value.strip("{}").split(",")]
            length = math.dist(x[:2], x[2:4]) + math.dist(x[2:4], x[4:])
        elif path == "Cracks:Disk:Radius":
            length = float(value)
if length > 2.5:
    print("There is no material so far away.", file=sys.stderr)
    sys.exit(2)
force = 2e-3 / (1e-3 * length**3) if case == "grips" else 10.0
opening = force * 1e-3 * length**3
thickness = math.pi * length / 2 if case == "disk" else 0.5  # of the front, a quarter of a circle
front = {"G_J": 0.5 * force**2 * 3e-3 * length**2 / thickness * 1.01, "position": [0.6, length - 0.2] if case == "load" else [0.0, length]}
crack = {"name": "Notch", "fronts": [dict(front, position=[0.0, 0.0]), front]}
if case == "disk":
    crack = {"name": "Disk", "area": math.pi * length**2 / 4, "fronts": [front]}
summary = {"status": "finished", "wall_seconds": 0.1, "particle_steps": 1, "energy": {"external_work": 0.5 * force * opening},
           "cells": {"largest": 0.1, "smallest": 0.1}, "cracks": [crack],
           "boundaries": [{"name": "Grip", "force": [None, force]}] if case == "grips" else [] if case == "pressure" else
           [{"name": "Load", "force": [0.0, force], "displacement": 0.75 * opening}, {"name": "Other", "force": [-force, 0.0], "displacement": 0.25 * opening}]}
with open(os.path.join(arguments[arguments.index("--output") + 1], "summary.json"), "w") as file:
    json.dump(summary, file)
