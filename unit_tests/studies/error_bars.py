#!/usr/bin/env python3
"""Whether the error estimates of summary.json hold: random cracks at rest in 2D, on cells of given sizes.

    error_bars.py PROGRAM [--seed N] [--number N] [--families NAME ...] [--write FILE]     needs numpy and scipy

Families (accuracy_at_rest.py has their geometry and references): inclined cracks in a plate (closed form), edge cracks in strips and double
cantilever beams (finite elements). Each in static equilibrium, with linear functions or GIMP and 2 x 2 or 3 x 3 particles a cell, and 0 to 3
levels of finer cells at the fronts. Cells: 4 to 24 of the finest ones in the crack or ligament, the shorter one (in half of the crack with two
fronts); 2 to 16 of the coarsest ones in the arm of a beam.

Prints for each family how many true errors are within the estimate (coverage), the median of the estimate over the true error, and of the true
error. K_I and K_II are compared with those of G: (K_I, 0) for strips and beams.
"""
import argparse
import concurrent.futures
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True
import accuracy_at_rest as at_rest  # noqa: E402

FAMILIES = ("inclined", "strip", "inclined", "beam")
MOST = 80  # of the coarsest cells across a plate or strip


def cells(pick, length, width):
    """\\return (edge of the finest cells for 4 to 24 of them in a length, levels, edge of the coarsest ones)"""
    levels = pick.choice([0, 0, 1, 2, 3])
    finest = length / math.exp(pick.uniform(math.log(4), math.log(24)))
    while finest * 2**levels > width / 6:
        levels -= 1
    coarsest = max(finest * 2**levels, width / MOST)
    while coarsest / 2**levels > length / 4:
        levels += 1
    return coarsest / 2**levels, levels, coarsest


def number(text, name, section):
    """A number of a scene's text, the second of an array."""
    part = text[text.index('name="%s"' % section):]
    return re.search(r'name="%s"[^>]*value="([^"]*)"' % name, part)[1]


def draw(seed, k, families=FAMILIES):
    """\\return (family, text, overrides, G at each front, (K_I, |K_II|) at each front)"""
    pick = random.Random(7000 * seed + k)
    family = families[k % len(families)]
    if family == "inclined":
        n = math.exp(pick.uniform(math.log(4), math.log(24)))
        levels = pick.choice([0, 1, 2, 3])
        widest = max(3.5, min(40.0, 0.5 * MOST * 2**levels / n))
        (text, release), sets = at_rest.inclined(pick, widest), {}
        half = float(number(text, "Upper Corner", "Plate").strip("{}").split(",")[0])
        while 5e-3 / n * 2**levels > half / 3:
            levels -= 1
        coarsest = half / math.ceil(half / (5e-3 / n * 2**levels))  # nodes on the edges, which are held
    elif family == "strip":
        (text, sets), release = at_rest.strip(pick)
        a = float(sets["Cracks:Notch:Points"].strip("{}").split(",")[2])
        width = float(sets["Bodies:Strip:Upper Corner"].strip("{}").split(",")[0])
        _, levels, coarsest = cells(pick, min(a, width - a), width)
    else:
        (text, sets), release = at_rest.beam(pick)
        arm = float(sets["Cracks:Notch:Points"].strip("{}").split(",")[1])
        levels = pick.choice([0, 0, 1, 2, 3])
        coarsest = arm / math.exp(pick.uniform(math.log(2), math.log(16)))
    text, sets = at_rest.with_usual_answers(text, sets, pick)
    sets = dict(sets, **{"Domain:Cell Size": repr(coarsest), "Output:Fields": "false"})
    if levels > 0:
        sets.update({"Adaptivity:Maximum Level": str(levels), "Adaptivity:Front Cells": str(pick.choice([3, 4, 6]))})
    modes = [(math.sqrt(at_rest.MODULUS * release[0]), 0.0)]
    if family == "inclined":
        tension = float(re.search(r"P = ([0-9.e+-]+);", text)[1]), float(re.search(r"T = \(([0-9.e+-]+)\);", text)[1])
        modes = [tuple(abs(stress) * math.sqrt(math.pi * 5e-3) for stress in tension)] * 2
    return family, text, sets, release, modes


def run(program, scene):
    """\\return the summary of a scene, or nothing where it can't be run"""
    _, text, sets, _, _ = scene
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.xml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        command = [program, path, "--output", os.path.join(folder, "out"), "--quiet"]
        for name, value in sets.items():
            command += ["--set", "%s=%s" % (name, value)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            print(" ".join(command) + "\n" + done.stderr, file=sys.stderr, flush=True)
            return None
        with open(os.path.join(folder, "out", "summary.json"), encoding="utf-8") as file:
            return json.load(file)


def rows(k, scene, summary):
    """A row for each front with an estimate."""
    family, _, _, release, modes = scene
    fronts = [front for crack in summary["cracks"] for front in crack["fronts"]] if summary else []
    if len(fronts) != len(release):  # one has broken through
        return []
    found = []
    for front, exact, (one, two) in zip(fronts, release, modes):
        if front["G_J_error_estimate"] is None:
            continue
        found.append({"scene": k, "family": family, "exact": exact, "front": front, "particles": summary["particles"],
                      "G": (abs(front["G_J"] - exact), front["G_J_error_estimate"], exact),
                      "K": (math.hypot(front["K_I"] - one, abs(front["K_II"]) - two) / math.sqrt(2), front["K_I_error_estimate"],
                            math.hypot(one, two)),
                      "K_I": (abs(front["K_I"] - one), front["K_I_error_estimate"], math.hypot(one, two)),
                      "K_II": (abs(abs(front["K_II"]) - two), front["K_II_error_estimate"], math.hypot(one, two))})
    return found


def coverage(found, quantity):
    """\\return (fraction of true errors within their estimates, median of estimate / error, median error relative to the value)"""
    errors = [row[quantity] for row in found]
    median = sorted(bar / max(error, 1e-12 * of) for error, bar, of in errors)[len(errors) // 2]
    return sum(error <= bar for error, bar, _ in errors) / len(errors), median, sorted(e / of for e, _, of in errors)[len(errors) // 2]


def study(program, seed, numbers, families=FAMILIES, workers=None):
    """Rows of random scenes."""
    scenes = [draw(seed, k, families) for k in numbers]
    with concurrent.futures.ThreadPoolExecutor(workers or os.cpu_count()) as pool:
        summaries = list(pool.map(lambda scene: run(program, scene), scenes))
    return [row for k, scene, summary in zip(numbers, scenes, summaries) for row in rows(k, scene, summary)]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--number", type=int, default=100, help="of scenes")
    options.add_argument("--families", nargs="*", default=FAMILIES, choices=sorted(set(FAMILIES)))
    options.add_argument("--write", help="a file for the rows, JSON")
    chosen = options.parse_args()
    print("seed %d" % chosen.seed, flush=True)
    found = study(chosen.program, chosen.seed, range(chosen.number), chosen.families)
    if chosen.write:
        with open(chosen.write, "w", encoding="utf-8") as file:
            json.dump(found, file)
    print("%9s %6s %7s %9s %18s %14s" % ("family", "answer", "fronts", "coverage", "median bar / error", "median error"))
    for family in sorted(set(chosen.families)) + ["all"]:
        of = [row for row in found if family in (row["family"], "all")]
        for quantity in ("G", "K_I", "K_II"):
            if of:
                within, ratio, error = coverage(of, quantity)
                print("%9s %6s %7d %8.1f%% %18.2f %13.3f%%" % (family, quantity, len(of), 100 * within, ratio, 100 * error), flush=True)


if __name__ == "__main__":
    main()
