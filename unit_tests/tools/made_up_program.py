#!/usr/bin/env python3
"""Stands in for rhegma in tests of the package: what it does follows from the scene.

G is 0.5 + Cell Size / m. A cell of 0.2 m or more is wrong (exit status 1), one of 0.1 m or more stops (2). A title of "defect" is a defect (3),
"killed" ends by a signal, "missed" misses a reference (4).
"""

import json
import os
import signal
import sys
import xml.etree.ElementTree as ElementTree

arguments = sys.argv[1:]
root = ElementTree.parse(arguments[0]).getroot()
values = {f"{section.get('name')} > {entry.get('name')}": entry.get("value") for section in root for entry in section}
cell, title = float(values["Domain > Cell Size"]), values.get("Test > Title")
if cell >= 0.2:
    print("rhegma: warning: the scene has no crack", file=sys.stderr)
    print("rhegma: Domain > Cell Size: is too large.", file=sys.stderr)
    sys.exit(1)
print("rhegma: warning: the cells are coarse", file=sys.stderr)
if "--check" in arguments:
    sys.exit(0)
output = arguments[arguments.index("--output") + 1]
with open(os.path.join(os.path.dirname(output), "runs.txt"), "a") as file:
    file.write(f"{os.environ.get('OMP_NUM_THREADS')}\n")
if title == "defect":
    print("rhegma: a defect of the program", file=sys.stderr)
    sys.exit(3)
if title == "killed":
    os.kill(os.getpid(), signal.SIGKILL)
stopped, release = cell >= 0.1, 0.5 + cell
with open(os.path.join(output, "history.csv"), "w") as file:
    file.write(f"time,Notch.0.G_J\n0,0\n1e-3,{release}\n")
within = title != "missed"
summary = {"end": "stopped" if stopped else "finished", "cracks": [{"name": "Notch", "fronts": [{"G_J": release}]}],
           "references": [{"name": "J", "within": within}], "warnings": ["the cells are coarse"]}
with open(os.path.join(output, "summary.json"), "w") as file:
    json.dump(summary, file)
print("the last line", flush=True)
if stopped:
    print("rhegma: the run stopped at t = 1 ms, step 7: a particle left the grid", file=sys.stderr)
sys.exit(2 if stopped else 0 if within else 4)
