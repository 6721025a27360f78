#!/usr/bin/env python3
"""What judgement, error estimates, progress, locks and copies of the state take of a run, in per cent of its processor time.

    unit_tests/studies/cost_of_checks.py build/serial/rhegma xml_inputs/examples/dcb.xml xml_inputs/examples/edge_crack.xml

Samples the run's call stacks with perf (Linux), three runs a scene, and counts those that pass through the functions below. A part p
of n samples is known to about sqrt(p / n); the table has n. Two builds, one with and one without these functions, differ by more
than this from run to run on a machine that is shared."""

import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

PARTS = {
    "judges of the scene": r"Rhegma::judge\w+<",
    "error estimates": r"rrorEstimate|estimateErrors",
    "copies of the state": r"program::Checkpoints::afterSample",
    "progress": r"Rhegma::Progress::|program::Progress",
    "lock, manifest": r"Rhegma::RunLock|Rhegma::Manifest",
    "signals": r"stopIfRequested",
}
RUNS = 3


def stacks(program, scene, folder):
    """Call stacks of a run, each as one text."""
    data = os.path.join(folder, "perf.data")
    run = [program, scene, "--quiet", "--output", os.path.join(folder, "out")]
    subprocess.run(["perf", "record", "--call-graph", "dwarf,8192", "-F", "499", "-o", data, *run],
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True, env=dict(os.environ, OMP_NUM_THREADS="1"))
    script = subprocess.run(["perf", "script", "-i", data, "-F", "ip,sym", "--no-inline"], capture_output=True, text=True,
                            errors="replace", check=True)
    return [stack for stack in script.stdout.split("\n\n") if stack.strip()]


def main(program, *scenes):
    if shutil.which("perf") is None:
        sys.exit("cost_of_checks.py needs perf (Debian: linux-perf)")
    print("| scene | samples | all of these | " + " | ".join(PARTS) + " |\n|:--" + "|--:" * (len(PARTS) + 2) + "|")
    for scene in scenes:
        with tempfile.TemporaryDirectory() as folder:
            samples = [stack for _ in range(RUNS) for stack in stacks(program, scene, folder)]

        def part(pattern, samples=samples):
            count = sum(1 for stack in samples if re.search(pattern, stack))
            return f"{100 * count / len(samples):.2f}", 100 * math.sqrt(count) / len(samples)

        together, uncertain = part("|".join(PARTS.values()))
        print(f"| {os.path.splitext(os.path.basename(scene))[0]} | {len(samples):,} | {together} +- {uncertain:.2f} % | "
              + " | ".join(f"{part(pattern)[0]} %" for pattern in PARTS.values()) + " |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
