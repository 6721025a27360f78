#!/usr/bin/env python3
"""Processor time of --check for scenes with many bodies and with many cracks.

    unit_tests/studies/many_parts.py build/serial/rhegma              1,000, 10,000 and 100,000 of each
    unit_tests/studies/many_parts.py build/serial/rhegma 1000 4000    other numbers
    unit_tests/studies/many_parts.py --write FOLDER 1000              only the scenes

The forecast, which runs first steps of the scene for about a second, is left out (--quiet): what remains is to read the scene,
to check it and to set it up. The time per body or crack should not grow with their number."""

import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "program"))
sys.dont_write_bytecode = True

from scenes import many_bodies, many_cracks  # noqa: E402

NUMBERS = (1000, 10000, 100000)


def write(folder, name, count):
    path = os.path.join(folder, f"{name}_{count}.xml")
    with open(path, "w", encoding="utf-8") as file:
        file.write({"bodies": many_bodies, "cracks": many_cracks}[name](count).text())
    return path


def seconds(program, path):
    child = subprocess.Popen([program, path, "--check", "--quiet"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                             env=dict(os.environ, OMP_NUM_THREADS="1"))
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{path}: exit status {child.returncode}")
    return usage.ru_utime + usage.ru_stime


def main(program, numbers):
    print("| number | bodies [s] | cracks [s] |\n|--:|--:|--:|")
    for number in numbers:
        with tempfile.TemporaryDirectory() as folder:
            times = [seconds(program, write(folder, name, number)) for name in ("bodies", "cracks")]
        print(f"| {number:,} | {times[0]:.2f} | {times[1]:.2f} |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if sys.argv[1] == "--write":
        for chosen in sys.argv[3:]:
            for kind in ("bodies", "cracks"):
                print(write(sys.argv[2], kind, int(chosen)))
    else:
        main(sys.argv[1], [int(number) for number in sys.argv[2:]] or NUMBERS)
