#!/usr/bin/env python3
"""How far 3D fronts are said to have run: the mean over a front is at most the largest advance, also where parts of it have
reached a surface. RHEGMA_SEED in the environment draws other fronts."""

import json
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "3"))


def millimetres(*values):
    return [1e-3 * value for value in values]


def slab(begin, end, clamped):
    """A slab with a crack from one of its sides, whose straight front goes from `begin` to `end` mm; pulled apart, with a
    clamp at the corner ahead."""
    scene = Scene({
        "Domain": {"Dimension": 3, "Lower Corner": millimetres(-2, -2, -7), "Upper Corner": millimetres(12, 8, 7), "Cell Size": 1e-3},
        "Time": {"Final Time": 3e-5},
        "Materials": {"Polymer": {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": 3e9, "Poisson Ratio": 0.3}},
        "Bodies": {"Slab": {"Material": "Polymer", "Shape": "Box", "Lower Corner": millimetres(0, 0, -5),
                            "Upper Corner": millimetres(10, 6, 5)}},
        "Boundaries": {},
        "Cracks": {"Notch": {"Points": millimetres(-1, -1, 0.3, begin, -1, 0.3, end, 7, 0.3, -1, 7, 0.3)}},
        "Energy Release": {},
        "Propagation": {"Toughness": "8*(1 + v/200)", "Direction": "Straight", "On Stop": "Continue"},
        "Output": {"Fields": False},
    })
    for name, z, stress in (("Top", 5, 8e6), ("Bottom", -5, -8e6)):
        scene.set("Boundaries > " + name, {"Type": "Traction", "Body": "Slab", "Corner": millimetres(0, 0, z),
                                          "Edge 1": millimetres(10, 0, 0), "Edge 2": millimetres(0, 6, 0),
                                          "Stress": [0.0, 0.0, stress]})
    if clamped:
        scene.set("Boundaries > Clamp", {"Type": "Velocity", "Components": "xyz", "Value": [0.0, 0.0, 0.0],
                                         "Lower Corner": millimetres(7, -0.5, -6), "Upper Corner": millimetres(11, 0.5, 6)})
    return scene


class FrontExtension(ProgramTest):
    def test_the_mean_is_at_most_the_largest(self):
        """Each part that runs counts as its own length, not as all of what is left of the front."""
        draw = random.Random(SEED)
        ran = 0
        for clamped in (False, True, False, True):
            scene = slab(draw.uniform(2.0, 6.0), draw.uniform(2.0, 6.0), clamped)
            answer = rhegma(self.write("scene.xml", scene.text()), "--quiet", "--output", self.path("out"))
            self.assertEqual(answer.status, 0, answer)
            with open(self.path("out", "summary.json"), encoding="utf-8") as file:
                front = json.load(file)["cracks"][0]["fronts"][0]
            largest, mean = front["largest_advance"], front["mean_advance"]
            print(f"clamped {clamped}: largest {largest:.6f} m, mean {mean:.6f} m, {front['status']}")
            self.assertGreater(mean, 0.0)
            self.assertLessEqual(mean, largest)
            ran += front["ended"]
        self.assertGreater(ran, 0)  # some fronts have landed


if __name__ == "__main__":
    unittest.main()
