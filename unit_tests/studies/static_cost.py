#!/usr/bin/env python3
"""G and time of a beam in static equilibrium next to those of its damped run or of plain finite elements, in one run of this script.

    static_cost.py PROGRAM [CELLS ...]              cells of an arm, 8 and 16 by default
    static_cost.py PROGRAM elements [CELLS ...]     4, 8, 16 and 32 by default

The damped runs are xml_inputs/verification/dcb_h8.xml and dcb_h16.xml, the static ones dcb_static.xml with their cells. Prints, for each,
G_J of both in percent of the reference, wall seconds of both, their ratio, and the seconds of the whole static process.

With "elements": unknowns, error of G and processor seconds on one thread of the static solution as a whole process and of biquadratic finite elements (beam_elements.py: two solutions for G, without the start of Python).
"""
import json
import os
import resource
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
    return 100 * (found["cracks"][0]["fronts"][0]["G_J"] / REFERENCE - 1), found["wall_seconds"], seconds, found.get("equilibrium", {}).get("unknowns", 0)


def compare_with_elements(program, counts):
    os.environ["OMP_NUM_THREADS"] = "1"  # before numpy is loaded
    from beam_elements import release

    print("%-36s %10s %10s %12s" % ("", "unknowns", "error %", "processor s"))
    release(5e-3, 5e-3)  # loads what scipy loads at its first solution
    for largest, smallest in ((5e-3, 5e-3), (5e-3, 1e-3), (5e-3, 5e-4), (2.5e-3, 2.5e-4), (1.25e-3, 1e-4)):
        start = time.process_time()
        found, unknowns = release(largest, smallest)
        print("%-36s %10d %10.3f %12.3f" % ("elements of %g to %g mm" % (1e3 * largest, 1e3 * smallest), unknowns,
                                            100 * (found / REFERENCE - 1), time.process_time() - start), flush=True)
    for cells in counts:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        error, unknowns = run(program, "dcb_static.xml", "--set", "Domain:Cell Size=%r" % (0.01 / cells))[::3]
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        print("%-36s %10d %10.3f %12.3f" % ("%d cells an arm, whole process" % cells, unknowns, error,
                                            after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime), flush=True)


def main():
    if sys.argv[2:3] == ["elements"]:
        return compare_with_elements(sys.argv[1], [int(a) for a in sys.argv[3:]] or [4, 8, 16, 32])
    print("%5s %10s %10s %10s %10s %8s %10s" % ("cells", "damped %", "static %", "damped s", "static s", "ratio", "process s"))
    for cells in [int(a) for a in sys.argv[2:]] or [8, 16]:
        damped, long = run(sys.argv[1], "dcb_h%d.xml" % cells)[:2]
        static, short, process, _ = run(sys.argv[1], "dcb_static.xml", "--set", "Domain:Cell Size=%r" % (0.01 / cells))
        print("%5d %10.3f %10.3f %10.2f %10.3f %8.1f %10.2f" % (cells, damped, static, long, short, long / short, process),
              flush=True)


if __name__ == "__main__":
    main()
