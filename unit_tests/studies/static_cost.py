#!/usr/bin/env python3
"""G and time of a beam in static equilibrium next to those of its damped run, in one run of this script.

    static_cost.py PROGRAM [CELLS ...]     cells of an arm, 8 and 16 by default

The damped runs are xml_inputs/verification/dcb_h8.xml and dcb_h16.xml, the static ones dcb_static.xml with their cells. Prints, for each,
G_J of both in percent of the reference, wall seconds of both, their ratio, and the seconds of the whole static process.
"""
import json
import os
import subprocess
import sys
import tempfile
import time

INPUTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../xml_inputs/verification")
REFERENCE = 0.12873  # J/m2, xml_inputs/verification/dcb_static.xml


def run(program, scene, *sets):
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        done = subprocess.run([program, os.path.join(INPUTS, scene), "--output", folder, "--quiet", *sets],
                              capture_output=True, text=True)
        seconds = time.perf_counter() - start
        if done.returncode not in (0, 4):
            raise RuntimeError(done.stderr)
        with open(os.path.join(folder, "summary.json")) as file:
            found = json.load(file)
    return 100 * (found["cracks"][0]["fronts"][0]["G_J"] / REFERENCE - 1), found["wall_seconds"], seconds


def main():
    print("%5s %10s %10s %10s %10s %8s %10s" % ("cells", "damped %", "static %", "damped s", "static s", "ratio", "process s"))
    for cells in [int(a) for a in sys.argv[2:]] or [8, 16]:
        damped, long, _ = run(sys.argv[1], "dcb_h%d.xml" % cells)
        static, short, process = run(sys.argv[1], "dcb_static.xml", "--set", "Domain:Cell Size=%r" % (0.01 / cells))
        print("%5d %10.3f %10.3f %10.2f %10.3f %8.1f %10.2f" % (cells, damped, static, long, short, long / short, process),
              flush=True)


if __name__ == "__main__":
    main()
