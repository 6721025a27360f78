#!/usr/bin/env python3
"""G of a double cantilever beam in plane strain as its material becomes incompressible.

    locking.py PROGRAM

The beam of xml_inputs/examples/dcb.xml in static equilibrium with 4, 8 and 16 cells an arm. G E / (1 - nu^2) of the beam hardly
depends on Poisson's ratio nu; printed is its error against 16 cells with nu = 0.3, and that error times n^2 over the ratio K / G
of bulk and shear modulus, which the warning of locking takes for a constant (docs/reference/warnings.md)."""

import json
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "program"))
sys.dont_write_bytecode = True

from file_scene import FileScene  # noqa: E402
from program import SOURCE  # noqa: E402

HEIGHT = 0.01


def release(program, poisson, cells):
    scene = FileScene(os.path.join(SOURCE, "xml_inputs", "examples", "dcb.xml"))
    scene.remove("Damping").remove("Reference").set("Domain > Plane", "Strain").set("Domain > Cell Size", HEIGHT / cells)
    scene.set("Time", {"Analysis": "Static", "Rigid Modes": "Remove", "Final Time": 1.0}).set("Output", {"Fields": False})
    scene.set("Materials > Polymer > Poisson Ratio", poisson).set("Energy Release", {"Crack Closure": False})
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "scene.xml"), os.path.join(folder, "out")
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene.text())
        subprocess.run([program, path, "--quiet", "--output", out], check=True, stderr=subprocess.DEVNULL)
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            return json.load(file)["cracks"][0]["fronts"][0]["G_J"] / (1 - poisson ** 2)


def main(program):
    limit = release(program, 0.3, 16)
    print("| nu | K / G | cells an arm | error of G % | times n^2 / (K / G) |\n|--:|--:|--:|--:|--:|")
    for poisson in (0.3, 0.4, 0.45, 0.47, 0.49, 0.495):
        ratio = 2 * (1 + poisson) / (3 * (1 - 2 * poisson))
        for cells in (4, 8, 16):
            error = 100 * (release(program, poisson, cells) / limit - 1)
            print(f"| {poisson} | {ratio:.1f} | {cells} | {error:+.1f} | {error * cells ** 2 / ratio:+.1f} |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
