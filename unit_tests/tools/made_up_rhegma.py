#!/usr/bin/env python3
"""Stands in for rhegma: answers G = 0.5 (1 + (cell / 10 mm)^order), takes (10 mm / cell)^3 / 100 s, and counts its runs.

A cell larger than 9 mm is unstable and exits with 2. With --check it knows no setting but the cell size, the shape
functions and the kind of history.
"""

import json
import os
import sys

settings = {"Domain:Cell Size": "5e-3", "Domain:Shape Functions": "Linear"}
arguments = sys.argv[1:]
for i, argument in enumerate(arguments):
    if argument == "--set":
        path, value = arguments[i + 1].split("=", 1)
        settings[path] = value
if "--check" in arguments:
    for path in settings:
        if path not in ("Domain:Cell Size", "Domain:Shape Functions", "Output:History"):
            print(f"rhegma: {path.replace(':', ' > ')}: is no parameter.", file=sys.stderr)
            sys.exit(1)
    sys.exit(0)
output = arguments[arguments.index("--output") + 1]
with open(os.path.join(os.path.dirname(arguments[0]), "runs.txt"), "a") as runs:
    runs.write(output + "\n")
cell = float(settings["Domain:Cell Size"]) / 1.0e-2
if cell > 0.9:
    print("The step is unstable at 1e-5 s.", file=sys.stderr)
    sys.exit(2)
order = 2 if settings["Domain:Shape Functions"] == "GIMP" else 1
seconds = (0.02 if order == 2 else 0.01) / cell**3
summary = {
    "status": "finished",
    "wall_seconds": seconds,
    "particle_steps": round(1000 / cell**3),
    "residual": None,
    "one": 3.0 * (1.0 + cell**order),
    "two": 4.0 * (1.0 - cell**order),
    "cracks": [{"name": "Notch", "fronts": [{"G_J": 0.5 * (1.0 + cell**order)}]}],
}
with open(os.path.join(output, "summary.json"), "w") as file:
    json.dump(summary, file)
if settings.get("Output:History") != "none":
    with open(os.path.join(output, "history.csv"), "w") as file:
        file.write("time,Notch.0.G_J\n0,0\n" + f"1e-3,{0.5 * (1.0 + cell**order)}\n")
