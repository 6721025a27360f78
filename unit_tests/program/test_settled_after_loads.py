#!/usr/bin/env python3
"""Runs that end when they have settled, under loads that change late.

RHEGMA_SEED in the environment chooses the loads; each failure names it.
"""

import json
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))
END = 5e-3  # [s]

# Run to 1e-7 of drift, G after a ramp and after a sudden load differ by 0.2 %: what waves leave in strains that nodes do not see.
SAME = 4e-3


def strip(**more):
    """A notched strip of acrylic that settles within 0.5 ms."""
    return Scene(
        {
            "Domain": {"Dimension": 2, "Plane": "Stress", "Thickness": 0.003, "Cell Size": 0.002,
                       "Lower Corner": [-0.01, -0.01], "Upper Corner": [0.05, 0.07]},
            "Time": {"Final Time": END},
            "Materials": {"Acrylic": {"Model": "Linear Elastic", "Density": 1190.0, "Young Modulus": 3e9, "Poisson Ratio": 0.35}},
            "Bodies": {"Strip": {"Material": "Acrylic", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.04, 0.06]}},
            "Cracks": {"Notch": {"Points": [0.0, 0.0301, 0.0123, 0.0301]}},
            "Energy Release": {},
            "Damping": {"Mass Rate": 2e4, "Stop When Settled": True},
            "Output": {"Fields": False},
            **more,
        }
    )


def pulled(history):
    def end(y, x, stress):
        return {"Type": "Traction", "Body": "Strip", "From": [x, y], "To": [0.04 - x, y], "Stress": [0.0, stress],
                "History": history}

    return strip(Boundaries={"Top": end(0.06, 0.04, 5e6), "Bottom": end(0.0, 0.0, -5e6)})


def pressed(pressure):
    return strip(**{"Face Pressure": {"Notch": {"Pressure": pressure}}})


class SettledAfterLoads(ProgramTest):
    def setUp(self):
        super().setUp()
        self.random = random.Random(f"{SEED} {self.id()}")

    def run_scene(self, scene):
        """G, the summary and the messages."""
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("scene.out", "summary.json")) as file:
            summary = json.load(file)
        return summary["cracks"][0]["fronts"][0]["G_J"], summary, answer.messages

    def assert_waits(self, scene, history, at_once, last):
        release, summary, messages = self.run_scene(scene(history))
        why = f"{history!r}, seed {SEED}"
        self.assertLess(abs(release / at_once - 1.0), SAME, why)
        self.assertGreater(summary["time"], last, why)
        self.assertLess(summary["time"], END, why)
        self.assertEqual(summary["end"], "finished", why)
        self.assertNotIn("still changes", messages, why)

    def history(self):
        """A plateau and then the whole load, as an expression or a table, and the last change."""
        low, begin, ramp = self.random.uniform(0.005, 0.95), self.random.uniform(0.8e-3, 3e-3), self.random.uniform(1e-5, 4e-4)
        low, begin, ramp = float(f"{low:.3g}"), float(f"{begin:.4g}"), float(f"{ramp:.3g}")
        if self.random.random() < 0.5:
            return f"t < {begin!r} ? {low!r} : 1", begin
        return f"0:0, 1e-4:{low!r}, {begin!r}:{low!r}, {begin + ramp!r}:1", begin + 0.9 * ramp

    def test_tractions_with_a_plateau(self):
        at_once, summary, _ = self.run_scene(pulled("1"))
        self.assertEqual(summary["end"], "finished")
        self.assertLess(summary["time"], 0.5 * END)
        for history, last in [("t < 1.5e-3 ? 0.01 : 1", 1.5e-3), ("0:0, 3e-4:0.7, 2e-3:0.7, 2.2e-3:1", 2.19e-3), self.history(),
                              self.history()]:
            with self.subTest(history=history):
                self.assert_waits(pulled, history, at_once, last)

    def test_pressures_with_a_plateau(self):
        at_once, _, _ = self.run_scene(pressed("1e6"))
        begin = float(f"{self.random.uniform(1e-3, 3e-3):.4g}")
        self.assert_waits(pressed, f"t < {begin!r} ? 2e5 : 1e6", at_once, begin)

    def test_a_load_that_never_rests_is_warned_of(self):
        """A slow rise by a tenth on top of a constant load."""
        scene = pulled(f"1 + 0.1 * sin(2 * pi * t / {16.0 * END!r})")
        _, summary, messages = self.run_scene(scene.set("Damping > Settled Drift", 5e-3))
        self.assertEqual(summary["end"], "finished")
        self.assertLess(summary["time"], END)
        self.assertRegex(messages, r"Damping > Stop When Settled: the run settled at t = .*, but Boundaries > \w+ > History still "
                                   r"changes by [0-9.]+ % of its largest value")


if __name__ == "__main__":
    print("RHEGMA_SEED =", SEED)
    unittest.main()
