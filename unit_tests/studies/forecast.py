#!/usr/bin/env python3
"""What --check says that scenes cost, compared with what they then take: the table of docs/explanation/forecasts.md.

    unit_tests/studies/forecast.py build/serial/rhegma xml_inputs/examples/*.xml

Times are of the processor, so that other work on the machine counts little; the last column is what the clock says over
that, 1 on a machine that is not shared. The forecast is made without rates of earlier ones."""

import json
import os
import re
import subprocess
import sys
import tempfile
import time

UNITS = {"s": 1.0, "min": 60.0, "h": 3600.0}


def seconds(text):
    """Of "1 min 20 s", "0.56 s" or "1.5 h"."""
    return sum(float(number) * UNITS[unit] for number, unit in re.findall(r"([\d.e+]+) (min|s|h)\b", text))


def forecast(program, scene, folder):
    """(to rest or to the end, at most to the end) in seconds, and memory in MB."""
    answer = subprocess.run([program, scene, "--check"], capture_output=True, text=True, check=True,
                            env=dict(os.environ, XDG_CACHE_HOME=os.path.join(folder, "cache"), OMP_NUM_THREADS="1"))
    line = re.search(r"Forecast: (.*?) \(.*?\), ([\d.]+) (MB|GB) of memory", answer.stdout)
    times = [seconds(part) for part in line[1].split(" to rest by Damping, at most ")]
    return times[0], times[-1], float(line[2]) * (1000.0 if line[3] == "GB" else 1.0)


def run(program, scene, folder):
    """(processor seconds, seconds by the clock, summary)"""
    start = time.perf_counter()
    child = subprocess.Popen([program, scene, "--output", os.path.join(folder, "out"), "--quiet"],
                             stderr=subprocess.DEVNULL, env=dict(os.environ, OMP_NUM_THREADS="1"))
    _, status, usage = os.wait4(child.pid, 0)
    wall = time.perf_counter() - start
    child.returncode = os.waitstatus_to_exitcode(status)
    with open(os.path.join(folder, "out", "summary.json"), encoding="utf-8") as file:
        return usage.ru_utime + usage.ru_stime, wall, json.load(file)


def main(program, *scenes):
    print("| scene | steps | forecast | measured | ratio | memory | measured | clock / processor |")
    print("|:--|--:|--:|--:|--:|--:|--:|--:|")
    for scene in scenes:
        with tempfile.TemporaryDirectory() as folder:
            rest, end, memory = forecast(program, scene, folder)
            taken, wall, summary = run(program, scene, folder)
        said = f"{end:.3g} s" if rest == end else f"{rest:.3g} s to rest, at most {end:.3g} s"
        ratio = (rest if summary["settled"] else end) / taken
        print(f"| {os.path.splitext(os.path.basename(scene))[0]} | {summary['steps']:,} | {said} | {taken:.3g} s | {ratio:.2f} "
              f"| {memory:.0f} MB | {summary['peak_memory_bytes'] / 1e6:.0f} MB | {wall / taken:.1f} |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
