#!/usr/bin/env python3
"""Temperatures next to an insulating crack whose shape functions are extrapolated, where the crack meets the edge of a body.

RHEGMA_SEED draws the same bodies and cracks again; RHEGMA_CRACKS sets how many."""

import csv
import math
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from combinations import Reference, factors, scene_of  # noqa: E402
from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))
CRACKS = int(os.environ.get("RHEGMA_CRACKS", "16"))


class HeatBesideCracks(ProgramTest):
    def test_gradients_do_not_grow(self):
        """The scenes' loads of 2 MPa change temperatures by alpha T s / (rho c) = 0.025 K. Waves that meet and the front of the crack have
        some twenty times as much; where gradients grew with each step, temperatures were 10 K off after 80 steps and then fell below 0 K."""
        print(f"seed {SEED} (RHEGMA_SEED)", flush=True)
        levels = factors(Reference())
        plainest = {name: choices[0] for name, choices in levels.items()}
        numbers, number = random.Random(SEED), 0
        while number < CRACKS:
            drawn = {**plainest, "Cracks": "Corrected Broken Cell", "Thermal": numbers.choice(("Explicit", "Implicit"))}
            # USL fails at nodes with little mass (docs/explanation/method.md).
            for name in ("Shape Functions", "Update Scheme"):
                drawn[name] = numbers.choice([level for level in levels[name] if level != "USL"])
            path = self.write("scene.xml", scene_of(drawn, numbers).text())
            # Extrapolation next to what holds both faces is unstable without heat, too (docs/explanation/broken-cells.md).
            if "both" in rhegma(path, "--check").messages:
                continue
            number += 1
            with self.subTest(number=number, drawn={k: v for k, v in drawn.items() if v != plainest[k]}):
                answer = rhegma(path, "--output", self.path("out"), "--quiet")
                self.assertEqual(answer.status, 0, answer)
                with open(self.path("out", "history.csv"), encoding="utf-8") as file:
                    rows = list(csv.DictReader(file))
                self.assertLess(max(float(row["temperature_highest"]) for row in rows), 301.0)
                self.assertGreater(min(float(row["temperature_lowest"]) for row in rows), 299.0)

    def test_heat_stays_in_an_insulated_body(self):
        """Conduction without motion from a temperature that rises along a direction: the heat stays to rounding of the sums over particles and
        steps, and no particle leaves the range at the start by more than 3 % of it: the nodes' means extrapolate by half a cell."""
        numbers, cell = random.Random(SEED + 1), 1e-3
        for number in range(CRACKS // 2):
            low = [numbers.uniform(0.0, cell) for _ in range(2)]
            high = [x + numbers.uniform(14.0, 18.0) * cell for x in low]
            y, slope = 0.5 * (low[1] + high[1]) + numbers.uniform(-1.0, 1.0) * cell, numbers.uniform(-0.35, 0.35)
            angle = numbers.uniform(0.0, 2.0 * math.pi)
            along = f"{math.cos(angle)!r} * x + {math.sin(angle)!r} * y"
            method = numbers.choice(("Explicit", "Implicit", "Super Time Stepping"))
            shape, formulation = numbers.choice(("Linear", "GIMP")), numbers.choice(("Corrected Broken Cell", "Broken Cell", "Dual Field"))
            formulation = "Corrected Broken Cell" if number % 2 == 0 else formulation
            half = numbers.uniform(0.4, 0.6) * (high[0] - low[0])
            scene = Scene({
                "Domain": {"Dimension": 2, "Lower Corner": [-4 * cell] * 2, "Upper Corner": [24 * cell] * 2, "Cell Size": cell, "Shape Functions": shape},
                "Time": {"Final Time": 2.0},
                "Materials": {"Solid": {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": 3e9, "Poisson Ratio": 0.33,
                                        "Specific Heat": 1400.0, "Conductivity": 0.5}},
                "Bodies": {"Block": {"Material": "Solid", "Shape": "Box", "Lower Corner": low, "Upper Corner": high,
                                     "Temperature Field": f"300 + 2500 * ({along})"}},
                "Cracks": {"Formulation": formulation, "Notch": {"Points": [low[0] - 0.3 * cell, y, low[0] + half, y + slope * half]}},
                "Thermal": {"Initial Temperature": 300.0, "Mechanics": False, "Conduction": method},
                "Output": {"History Interval": 0.2, "Fields": False, "Checkpoints": False},
            })
            with self.subTest(number=number, method=method, shape=shape, formulation=formulation):
                answer = rhegma(self.write("scene.xml", scene.text()), "--output", self.path("out"), "--quiet")
                self.assertEqual(answer.status, 0, answer)
                with open(self.path("out", "history.csv"), encoding="utf-8") as file:
                    rows = list(csv.DictReader(file))
                first, last = rows[0], rows[-1]
                span = float(first["temperature_highest"]) - float(first["temperature_lowest"])
                heat = 1200.0 * 1400.0 * (high[0] - low[0]) * (high[1] - low[1]) * span
                self.assertLess(abs(float(last["thermal"])), 1e-10 * heat)
                self.assertLess(float(last["temperature_highest"]), float(first["temperature_highest"]) + 0.03 * span)
                self.assertGreater(float(last["temperature_lowest"]), float(first["temperature_lowest"]) - 0.03 * span)


if __name__ == "__main__":
    unittest.main()
