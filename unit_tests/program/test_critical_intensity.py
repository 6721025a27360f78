#!/usr/bin/env python3
"""K_Ic instead of Toughness: the same as the toughness that follows from it by hand."""

import json
import os
import random
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))
YOUNG, POISSON = 3e9, 0.33  # of the plate


def modulus(plane):
    return YOUNG if plane == "Stress" else YOUNG / (1.0 - POISSON**2)


class CriticalIntensity(ProgramTest):
    def run_scene(self, scene, name):
        answer = rhegma(self.write(name + ".xml", scene.text()), "--output", self.path(name))
        self.assertEqual(answer.status, 0, answer)
        with open(self.path(name, "summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def held(self, plane, value):
        """A crack that can't grow, with a toughness in the form of a parameter and its value."""
        scene = plate().set("Domain > Plane", plane)
        scene.set("Time", {"Analysis": "Static", "Final Time": 1.0, "Rigid Modes": "Remove"})
        scene.set("Boundaries > Back", {"Type": "Traction", "Body": "Plate", "From": [0.0, 1.0], "To": [0.0, 0.0],
                                        "Stress": [-1e5, 0.0]})
        scene.set("Cracks > Notch > Points", [0.3, 0.3, 0.6, 0.7])
        return scene.set(f"Energy Release > {value[0]}", value[1])

    def test_held_cracks(self):
        draw = random.Random(SEED)
        for plane in ("Strain", "Stress"):
            K = draw.uniform(1e4, 1e6)
            with self.subTest(plane, K=K, seed=SEED):
                toughness = K**2 / modulus(plane)
                by_energy = self.run_scene(self.held(plane, ("Toughness", toughness)), plane + "_energy")
                by_intensity = self.run_scene(self.held(plane, ("K_Ic", K)), plane + "_intensity")
                fronts = [s["cracks"][0]["fronts"][0] for s in (by_energy, by_intensity)]
                self.assertGreater(fronts[0]["G_J"], 0.0)
                self.assertAlmostEqual(fronts[0]["G_J"], fronts[1]["G_J"], delta=1e-12 * fronts[0]["G_J"])
                self.assertEqual(fronts[0].keys(), fronts[1].keys())
                given = [s["start_of_growth"]["toughness"] for s in (by_energy, by_intensity)]
                self.assertAlmostEqual(given[1] / toughness, 1.0, delta=1e-12)
                self.assertEqual(given[0], toughness)

    def test_the_answer_has_intensities_and_forces(self):
        """K of G over K_Ic is the root of G over the toughness. Forces at the start of growth are those of the loads, by the length of the edges and the
        thickness of 1 m, times the factor. The mode ratio is that of the entries."""
        K = random.Random(SEED).uniform(1e4, 1e6)
        summary = self.run_scene(self.held("Strain", ("K_Ic", K)), "answer")
        front, start = summary["cracks"][0]["fronts"][0], summary["start_of_growth"]
        self.assertEqual(start["K_Ic"], K)
        said = next(line for line in summary["answers"] if "of the toughness" in line)
        self.assertAlmostEqual(float(re.search(r"\(K of G = [\d.e+-]+ [MkPa]+ m\^0\.5, ([\d.e+-]+) of K_Ic", said)[1]) / front["closest_to_initiation"] ** 0.5, 1.0,
                               delta=1e-3)
        ratio = front["K_II"] / front["K_I"]
        self.assertAlmostEqual(front["K_II_over_K_I"], ratio, delta=1e-12)
        self.assertGreater(abs(ratio), 0.05)  # the crack is inclined
        self.assertIn(f"K_II is {round(100.0 * abs(ratio), 1):.4g} % of K_I", said)
        force = 1e5 * start["load_factor"]
        for name, sign in (("Pull", 1.0), ("Back", -1.0)):
            found = summary["forces_at_start"][name]
            self.assertAlmostEqual(found[0] / (sign * force), 1.0, delta=1e-9)
        self.assertTrue(any(line.startswith("forces as the first crack starts: ") for line in summary["answers"]), summary["answers"])
        balance = summary["energy_balance"]
        self.assertAlmostEqual(balance["fraction"], abs(balance["residual"]) / balance["energy"], delta=1e-15)
        self.assertEqual(balance["residual"], summary["energy"]["residual"])

    def test_growth(self):
        """The crack of a strip that runs: the same length at the same times."""
        K = random.Random(SEED).uniform(1e4, 2e4)
        runs = []
        for name, value in (("energy", ("Toughness", repr(K**2 / modulus("Strain")))), ("intensity", ("K_Ic", K))):
            scene = plate().set("Time > Final Time", 1.5e-3).set("Propagation", {value[0]: value[1]}).set("Energy Release", {})
            scene.set("Cracks > Notch > Points", [0.5, 0.0, 0.5, 0.4])
            scene.set("Boundaries > Left", {"Type": "Traction", "Body": "Plate", "From": [0.0, 1.0], "To": [0.0, 0.0],
                                            "Stress": [-1e5, 0.0]})
            runs.append(self.run_scene(scene, name)["cracks"][0]["fronts"][0])
        self.assertGreater(runs[0]["increments"], 3)
        for quantity in ("length", "initiated", "last_advance"):
            self.assertAlmostEqual(runs[0][quantity] / runs[1][quantity], 1.0, delta=1e-9)

    def refused(self, changes, *pieces):
        scene = plate()
        for place, value in changes.items():
            scene.set(place, value)
        answer = rhegma(self.write("wrong.xml", scene.text()), "--check", "--quiet")
        self.assertEqual(answer.status, 1, answer)
        for piece in pieces:
            self.assertIn(piece, answer.messages)

    def test_mistakes(self):
        K = {"Energy Release > K_Ic": 1e6}
        self.refused({**K, "Energy Release > Toughness": 100.0}, "Energy Release > K_Ic", "keep one of the two")
        self.refused({**K, "Energy Release > Toughness From Library": "PMMA"}, "Energy Release > K_Ic", "keep one of the two")
        self.refused({"Energy Release > K_Ic": -1e6}, "Energy Release > K_Ic: is -1000000", "above 0")
        steel = {"Model": "Linear Elastic", "Density": 7800.0, "Young Modulus": 2e11, "Poisson Ratio": 0.3}
        self.refused({**K, "Materials > Steel": steel}, "Materials > Polymer (E' = ", "and Steel", "write Toughness")
        warm = {"Thermal": {"Initial Temperature": 300.0}, "Materials > Polymer > Specific Heat": 1400.0,
                "Materials > Polymer > Young Modulus": "300:3e9, 400:2e9"}
        self.refused({**K, **warm}, "Materials > Polymer", "depend on temperature", "write Toughness")
        fibres = {"Model": "Orthotropic", "Density": 1600.0, "Young Moduli": [140e9, 10e9, 10e9], "Poisson Ratios": [0.3, 0.4, 0.3],
                  "Shear Moduli": [5e9, 3.6e9, 5e9]}
        self.refused({**K, "Materials > Polymer": fibres}, "Materials > Polymer is anisotropic", "write Toughness")
        # An error of a material is the only one that is reported.
        self.refused({**K, "Materials > Polymer > Poisson Ratio": 0.7}, "Materials > Polymer > Poisson Ratio")


if __name__ == "__main__":
    unittest.main(verbosity=2)
