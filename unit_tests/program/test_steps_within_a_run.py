#!/usr/bin/env python3
"""Equilibrium at each load step, not only at the last: G in the history, the time at which cracks start, and load factors.

RHEGMA_SEED in the environment chooses the crack and the load; it is printed."""

import csv
import json
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "48"))
# A load step may leave 1e-3 of the forces out of balance (EquilibriumSteps.cpp), half of it in G, which goes with the square of the stress.
SAME = 1e-3


def strip(rng, steps, history, **more):
    """A notched strip of acrylic whose rows of particles move by a tenth of a cell."""
    height, length, stress = 0.03 + rng.uniform(0.0, 2e-3), rng.uniform(0.009, 0.012), rng.uniform(3e6, 6e6)

    def end(y, x, sign):
        return {"Type": "Traction", "Body": "Strip", "From": [x, y], "To": [0.04 - x, y], "Stress": [0.0, sign * stress],
                "History": history}

    return Scene(
        {
            "Domain": {"Dimension": 2, "Plane": "Stress", "Thickness": 0.003, "Cell Size": 0.002,
                       "Lower Corner": [-0.01, -0.01], "Upper Corner": [0.05, 0.07]},
            "Time": {"Final Time": 1.0, "Analysis": "Quasi-Static", "Load Steps": steps, "Rigid Modes": "Remove"},
            "Materials": {"Acrylic": {"Model": "Linear Elastic", "Density": 1190.0, "Young Modulus": 3e9, "Poisson Ratio": 0.35}},
            "Bodies": {"Strip": {"Material": "Acrylic", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.04, 0.06]}},
            "Boundaries": {"Top": end(0.06, 0.04, 1.0), "Bottom": end(0.0, 0.0, -1.0)},
            "Cracks": {"Notch": {"Points": [0.0, height, length, height]}},
            "Energy Release": {},
            "Output": {"Fields": False, "History Interval": 1e-6},
            **more,
        }
    )


class StepsWithinARun(ProgramTest):
    def setUp(self):
        super().setUp()
        print(f"seed {SEED}", flush=True)

    def run_scene(self, scene, name="scene", status=0):
        """The summary, and the rows (time, G)."""
        answer = rhegma(self.write(name + ".xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, status, answer)
        with open(self.path(name + ".out", "summary.json")) as file:
            summary = json.load(file)
        with open(self.path(name + ".out", "history.csv"), newline="") as file:
            return summary, [(float(row["time"]), float(row["Notch.0.G_J"])) for row in csv.DictReader(file)]

    def test_G_does_not_change_under_a_constant_load(self):
        for steps in (2, 8):
            _, rows = self.run_scene(strip(random.Random(SEED), steps, "0:0, 0.5:1, 1:1"), f"steps_{steps}")
            held = [G for time, G in rows if time >= 0.5 - 1e-9]
            self.assertGreaterEqual(len(held), 2)
            for G in held:
                self.assertAlmostEqual(G / held[-1], 1.0, delta=SAME, msg=f"{steps} load steps")

    def test_cracks_start_while_the_load_rises(self):
        """At 0.99 of the largest G, which is reached at the end of the ramp: at the root of that of its time."""
        _, rows = self.run_scene(strip(random.Random(SEED), 2, "0:0, 0.5:1, 1:1"), "still")
        toughness = 0.99 * rows[-1][1]
        growing = {"Propagation": {"Toughness": toughness, "Load Control": "Functions of Time", "Increment": 1.0}}
        scene = strip(random.Random(SEED), 2, "0:0, 0.5:1, 1:1", **growing).set("Time > Maximum Steps", 2)  # before it breaks
        summary, _ = self.run_scene(scene, "growing", status=2)
        start = summary["propagation"]["initiation"]
        self.assertEqual((start["from"], start["to"]), (0.0, 0.5))
        self.assertAlmostEqual(start["time"], 0.5 * 0.99**0.5, delta=0.5 * SAME)

    def test_load_factors_do_not_depend_on_the_loads_of_the_scene(self):
        """G at the factor is the toughness, in equilibrium where the particles lie, however large the last change of the factor was."""
        _, rows = self.run_scene(strip(random.Random(SEED), 1, "1"), "whole")
        factors = []
        for part in (1.0, 0.013, 7e-4):
            searching = {"Propagation": {"Toughness": rows[-1][1], "Load Control": "Load Factor"}}
            summary, _ = self.run_scene(strip(random.Random(SEED), 1, str(part), **searching), f"part_{part:g}")
            factors.append(part * summary["propagation"]["initiation"]["load_factor"])
        for factor in factors:
            self.assertAlmostEqual(factor, 1.0, delta=2.0 * SAME, msg=str(factors))


if __name__ == "__main__":
    unittest.main()
