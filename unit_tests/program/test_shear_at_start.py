#!/usr/bin/env python3
"""A front that turns as it starts: the answer says what shear does to the load of its start.

RHEGMA_SEED in the environment draws other cracks.
"""

import json
import math
import os
import random
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "7"))


def fraction_of_load(turn):
    """Load at which K_I cos^3(t/2) - 3/2 K_II cos(t/2) sin(t) is K_Ic over that at which K_I^2 + K_II^2 is its square, with the
    K_II / K_I whose largest hoop stress is at this angle (Erdogan and Sih, J. Basic Eng. 85 (1963) 519)."""
    t = -abs(turn)
    shear = -math.sin(t) / (3.0 * math.cos(t) - 1.0)
    hoop = math.cos(t / 2) ** 3 - 1.5 * shear * math.cos(t / 2) * math.sin(t)
    return math.hypot(1.0, shear) / hoop


class ShearAtStart(ProgramTest):
    def front_after(self, angle):
        """\\return line and entry of the front of an edge crack at this angle to the direction across the load"""
        scene = plate().remove("Energy Release").set("Energy Release", {}).set("Domain > Cell Size", 0.025)
        tip = [0.5 - 0.3 * math.sin(angle), 0.3 * math.cos(angle)]
        scene.set("Cracks", {"Notch": {"Points": [0.5, 0.0, *tip]}})
        pull = {"Type": "Traction", "Body": "Plate", "Stress": [1e5, 0.0]}
        scene.set("Boundaries", {"Right": {**pull, "From": [1.0, 0.0], "To": [1.0, 1.0]},
                                 "Left": {**pull, "From": [0.0, 1.0], "To": [0.0, 0.0], "Stress": [-1e5, 0.0]}})
        scene.set("Time > Final Time", 2.5e-3).set("Propagation", {"Toughness": "2"})
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet", "--output", self.path("out"))
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        line = [text for text in summary["answers"] if text.startswith("crack Notch")]
        self.assertEqual(len(line), 1, summary["answers"])
        return line[0], summary["cracks"][0]["fronts"][0]

    def test_a_crack_at_an_angle(self):
        angle = random.Random(SEED).uniform(0.5, 0.8)
        line, front = self.front_after(angle)
        turn = math.radians(front["first_turn"])
        self.assertGreater(abs(turn), 0.3, line)  # the stress waves of the load are not those of its rest
        said = re.search(r"it turned by (\d+) degrees as it started, for which the largest hoop stress needs about ([\d.]+) of the load", line)
        self.assertIsNotNone(said, line)
        self.assertAlmostEqual(float(said.group(1)), abs(front["first_turn"]), delta=0.5)
        self.assertAlmostEqual(float(said.group(2)), fraction_of_load(turn), delta=5.1e-3)

    def test_a_crack_across_the_load(self):
        line, _ = self.front_after(0.0)
        self.assertIn("initiated at t = ", line)
        self.assertNotIn("hoop stress", line)


if __name__ == "__main__":
    unittest.main()
