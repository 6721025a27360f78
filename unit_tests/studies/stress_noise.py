#!/usr/bin/env python3
"""Noise of stress: how much the stress of particles alternates within the cells.

    stress_noise.py PROGRAM [SCENE.xml ...]
    stress_noise.py PROGRAM --updates

The first form runs all scenes of xml_inputs/examples with mechanics, or those given, with `Measure > Stress Alternation` added, and
prints its ratio and deviation for each body (docs/explanation/verification/method.md): at most 0.05 is wanted. The second form runs examples/kalthoff.xml
with other updates of velocity, shape functions and motions of the held box, and prints what they cost, too: `accounted for` is the
fraction of the supplied energy that the energy balance finds, `turn` the kink angle of the crack."""

import glob
import json
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "program"))
sys.dont_write_bytecode = True

from file_scene import FileScene  # noqa: E402
from program import SOURCE  # noqa: E402

EXAMPLES = os.path.join(SOURCE, "xml_inputs", "examples")
WANTED = 0.05
PATIENCE = 1800  # [s]


def solution(program, scene):
    """The summary of a run; nothing where it did not come to its end."""
    scene.set("Measure > Stress Alternation" if scene.has("Measure") else "Measure",
              {} if scene.has("Measure") else {"Stress Alternation": {}})
    if scene.has("Output > Fields"):
        scene.set("Output > Fields", False)
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "scene.xml"), os.path.join(folder, "out")
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene.text())
        try:
            subprocess.run([program, path, "--quiet", "--output", out], check=False, stderr=subprocess.DEVNULL,
                           stdout=subprocess.DEVNULL, timeout=PATIENCE, cwd=os.path.dirname(scene.path))
            with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
                return json.load(file)
        except (subprocess.TimeoutExpired, FileNotFoundError):
            return None


def examples(program, paths):
    print("| scene | body | ratio | deviation [kPa] | at most 0.05 |\n|:--|:--|--:|--:|:--|")
    for path in paths:
        scene, name = FileScene(path), os.path.splitext(os.path.basename(path))[0]
        if scene.get("Thermal > Mechanics") == "false":
            continue
        summary = solution(program, scene)
        if summary is None:
            print(f"| {name} | | not finished | | |", flush=True)
            continue
        for body in summary["bodies"]:
            found = body["stress_alternation"]
            if found["ratio"] is None:
                continue
            verdict = "yes" if found["ratio"] <= WANTED else "no"
            print(f"| {name} | {body['name']} | {found['ratio']:.4f} | {found['deviation'] / 1e3:.3g} | {verdict} |", flush=True)


def kalthoff(change):
    scene = FileScene(os.path.join(EXAMPLES, "kalthoff.xml")).remove("Contact")
    for place, value in change.items():
        scene.set(place, value)
    return scene


def updates(program):
    update = {"Type": "Lumped", "Velocity Update": "XPIC", "Update Order": 2}
    box = "Boundaries > Impact > Box Motion"
    cases = {
        "box fixed": {box: "Fixed"},
        "box with material": {box: "With Material"},
        "box with grid": {box: "With Grid"},
        "with grid, linear functions": {"Domain > Shape Functions": "Linear"},
        "with grid, PIC fraction 0.001": {"Time > PIC Fraction": 0.001},
        "with grid, PIC fraction 0.01": {"Time > PIC Fraction": 0.01},
        "with grid, XPIC of order 2": {"Mass Matrix": update},
        "with grid, XPIC of order 4": {"Mass Matrix": {**update, "Update Order": 4}},
        "with grid, FMPM of order 2": {"Mass Matrix": {**update, "Velocity Update": "FMPM"}},
        "with grid, FMPM of order 4": {"Mass Matrix": {**update, "Velocity Update": "FMPM", "Update Order": 4}},
        "with grid, partial mass matrix": {"Mass Matrix": {"Type": "Partial"}},
        "with grid, shear at cell centres": {"Domain > Shear Strain": "At Cell Centres"},
        "with grid, 3 x 3 particles a cell": {"Bodies > Upper Half > Particles Per Cell": 3},
    }
    print("| case | ratio | deviation [MPa] | turn [degrees] | dissipated | accounted for |\n|:--|--:|--:|--:|--:|--:|")
    for name, change in cases.items():
        summary = solution(program, kalthoff({box: "With Grid", **change}))
        found, growth = summary["bodies"][0]["stress_alternation"], summary["propagation"]
        print(f"| {name} | {found['ratio']:.4f} | {found['deviation'] / 1e6:.1f} | {summary['cracks'][0]['fronts'][0]['turn']:.2f} | "
              f"{growth['dissipated_fraction']:.4f} | {growth['accounted_for']:.4f} |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    if sys.argv[2:] == ["--updates"]:
        updates(sys.argv[1])
    else:
        examples(sys.argv[1], sys.argv[2:] or sorted(glob.glob(os.path.join(EXAMPLES, "*.xml"))))
