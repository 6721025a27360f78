#!/usr/bin/env python3
"""A surface crack in an axle under bending, off the grid: its front grows into the material without a stop by the cells.

RHEGMA_SEED in the environment chooses other positions of the axle in its cells and another tilt of the crack. Of 1 to 16 the
front folds with 1 and one thread, and a node stops for numerical reasons (docs/explanation/where-growth-ends.md)."""

import json
import math
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "2"))
RADIUS, CELL, DEPTH, HALF_LENGTH = 0.01, 1e-3, 3.5e-3, 0.012


def axle(seed):
    """A round bar of steel along z. A disk of which half lies in the bar is its crack, and the ends turn so that it opens."""
    rng = random.Random(seed)
    off = [rng.uniform(-0.5, 0.5) * CELL for _ in range(3)]
    half = (RADIUS, RADIUS, HALF_LENGTH)
    low = [o - h - 3 * CELL for o, h in zip(off, half)]
    high = [l + (math.ceil((2 * h + 6 * CELL) / CELL) + 1) * CELL for l, h in zip(low, half)]
    tilt = math.radians(rng.uniform(-5, 5))
    scene = Scene(
        {
            "Domain": {"Dimension": 3, "Lower Corner": low, "Upper Corner": high, "Cell Size": CELL},
            "Time": {"Final Time": 2.6e-5},
            "Materials": {"Steel": {"Model": "Linear Elastic", "Density": 7800.0, "Young Modulus": 2.1e11, "Poisson Ratio": 0.3}},
            "Bodies": {"Axle": {"Material": "Steel", "Shape": "Cylinder", "From": [0.0, 0.0, -HALF_LENGTH],
                                "To": [0.0, 0.0, HALF_LENGTH], "Radius": RADIUS}},
            "Boundaries": {},
            "Cracks": {"Flaw": {"Centre": [-RADIUS, 0.0, rng.uniform(-0.5, 0.5) * CELL],
                                "Normal": [0.0, -math.sin(tilt), math.cos(tilt)], "Radius": DEPTH}},
            "Energy Release": {},
            "Propagation": {"Toughness": "2700*(1 + v/1000)"},
            "Output": {"History Interval": 1e-6, "Fields": False},
        }
    )
    for name, side in (("Top", 1), ("Bottom", -1)):
        lower, upper = list(low), list(high)
        if side > 0:
            lower[2] = HALF_LENGTH - 1.5 * CELL
        else:
            upper[2] = 1.5 * CELL - HALF_LENGTH
        scene.set("Boundaries > " + name, {"Type": "Velocity", "Components": "z", "Lower Corner": lower, "Upper Corner": upper,
                                          "Field": f"0, 0, {-side * 2.5 / RADIUS}*x", "History": "0:0, 1.5e-5:1, 1:1"})
    return scene


class Axle(ProgramTest):
    def test_the_front_goes_on_inside(self):
        """Ends that were taken back to the surface had the direction of that move; with it J of nodes far from them was none."""
        self.grows(SEED)

    def test_an_end_that_the_front_has_overtaken(self):
        """It pointed out of the bar; its J integral was negative, and that stopped the run."""
        self.grows(4)

    def grows(self, seed):
        print(f"seed {seed}", flush=True)
        answer = rhegma(self.write("scene.xml", axle(seed).text()), "--quiet")
        with open(self.path("scene.out", "summary.json")) as file:
            front = json.load(file)["cracks"][0]["fronts"][0]
        self.assertEqual(answer.status, 0, answer)
        self.assertFalse(front["stopped"], front["status"])
        self.assertGreater(front["mean_advance"], 2 * CELL)
        # Where the crack is deepest, it has grown by cells, too, and there is material ahead.
        deepest = max(x[0] for x in front["front_nodes"]["position"])
        self.assertGreater(deepest + RADIUS, DEPTH + 2 * CELL)
        self.assertLess(deepest, 0.5 * RADIUS)
        # G is that of a front where its tube is not cut by the surface: positive more than a cell below that.
        nodes = front["front_nodes"]
        inside = [g for g, x in zip(nodes["G_J"], nodes["position"]) if math.hypot(x[0], x[1]) < RADIUS - CELL]
        self.assertGreater(len(inside), 8)
        self.assertGreater(min(inside), 0.0)


if __name__ == "__main__":
    unittest.main()
