#!/usr/bin/env python3
"""Cracks that do not grow, compared with a toughness: Energy Release > Toughness.

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
from test_shear_at_rest import PULL, WIDTH  # noqa: E402
from test_shear_at_rest import strip as growing_strip  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "11"))
LINE = r"cracks would start at ([\d.e+-]+) times the loads"


def strip(crack, release=None, pull=PULL, material=None, **time):
    """The strip of test_shear_at_rest.py without growth. crack: its points"""
    scene = growing_strip({"Analysis": "Static", **time}, "1", {"Notch": {"Points": crack}}).remove("Propagation")
    scene.set("Energy Release", release or {})
    for name, sign in (("Top", 1.0), ("Bottom", -1.0)):
        scene.set(f"Boundaries > {name} > Stress", [0.0, sign * pull])
    for name, value in (material or {}).items():
        scene.set(f"Materials > Polymer > {name}", value)
    return scene


class ComparedToughness(ProgramTest):
    def setUp(self):
        super().setUp()
        self.draw = random.Random(SEED)
        angle, length = self.draw.uniform(0.3, 0.9), self.draw.uniform(0.013, 0.018)
        self.crack = [WIDTH, 0.027, WIDTH - length * math.cos(angle), 0.027 + length * math.sin(angle)]
        print(f"seed {SEED}, crack of {1e3 * length:.1f} mm at {math.degrees(angle):.1f} degrees")

    def run_scene(self, scene, *more, status=0, out="out"):
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet", "--output", self.path(out), *more)
        self.assertEqual(answer.status, status, answer)
        with open(self.path(out, "summary.json"), encoding="utf-8") as file:
            return answer, json.load(file)

    def test_load_at_which_a_crack_starts(self):
        """Under that load K of the largest hoop stress is that of the toughness, and growth in equilibrium starts at the same load."""
        toughness = self.draw.uniform(300.0, 900.0)
        _, summary = self.run_scene(strip(self.crack, {"Toughness": toughness}))
        start, front = summary["start_of_growth"], summary["cracks"][0]["fronts"][0]
        self.assertEqual(start["toughness"], toughness)
        self.assertAlmostEqual(front["closest_to_initiation"] * toughness, front["G_J"], delta=1e-9 * front["G_J"])
        K, t = math.hypot(front["K_I"], front["K_II"]), math.radians(front["kink_angle"])
        # Without regard to the sign of K_II: the crack turns to the side on which the hoop stress is larger.
        hoop = max(math.cos(t / 2) ** 2 * (front["K_I"] * math.cos(t / 2) - sign * 3.0 * front["K_II"] * math.sin(t / 2)) for sign in (1, -1))
        self.assertAlmostEqual(front["closest_by_hoop_stress"], hoop / K * math.sqrt(front["closest_to_initiation"]), delta=1e-9)
        factor = start["load_factor"]
        self.assertAlmostEqual(factor * front["closest_by_hoop_stress"], 1.0, delta=1e-12)
        said = [re.search(LINE, answer) for answer in summary["answers"]]
        self.assertAlmostEqual(float(next(match for match in said if match).group(1)) / factor, 1.0, delta=5e-4)

        _, summary = self.run_scene(strip(self.crack, {"Toughness": toughness}, factor * PULL))
        # The bodies deflect: G is proportional to the square of the loads up to some strains.
        self.assertAlmostEqual(summary["cracks"][0]["fronts"][0]["closest_by_hoop_stress"], 1.0, delta=10.0 * factor * PULL / 3e9)

        scene = strip(self.crack, Analysis="Quasi-Static", **{"Load Steps": 1})
        scene.set("Propagation", {"Toughness": repr(toughness)})
        _, summary = self.run_scene(scene)
        # Growth has front springs and domains of its own; both are within some percent of G at 8 cells.
        self.assertAlmostEqual(summary["cracks"][0]["fronts"][0]["hoop_stress_factor"] / factor, 1.0, delta=0.02)

    def test_motion_remembers_the_largest(self):
        """A load that comes and goes, with the run interrupted after its peak: what counts is the largest G of all samples."""
        scene = strip(self.crack, {"Toughness": 500.0}, Analysis="Dynamic", **{"Final Time": 3e-4}).remove("Time > Rigid Modes")
        for name in ("Top", "Bottom"):
            scene.set(f"Boundaries > {name} > History", "0:0, 5e-5:1, 1e-4:0, 1:0")
        scene.set("Output > History Interval", 5e-6)
        _, whole = self.run_scene(scene)
        front = whole["cracks"][0]["fronts"][0]
        self.assertLess(front["time_of_largest_G_J"], 2e-4)
        self.assertGreater(front["largest_G_J"], 1.02 * front["G_J"])
        self.assertAlmostEqual(front["closest_to_initiation"] * 500.0, front["largest_G_J"], delta=1e-9 * front["largest_G_J"])
        self.assertIsNone(whole["start_of_growth"]["load_factor"])
        scene.set("Time > Final Time", 2.5e-4).set("Output > Checkpoint Interval", 1e-4)
        self.run_scene(scene, out="part")
        answer = rhegma(self.path("scene.xml"), "--restart", self.path("part", "checkpoint.h5"), "--quiet", "--output", self.path("rest"), "--set", "Time:Final Time=3e-4")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("rest", "summary.json"), encoding="utf-8") as file:
            rest = json.load(file)["cracks"][0]["fronts"][0]
        for name in ("closest_to_initiation", "closest_by_hoop_stress"):
            self.assertAlmostEqual(rest[name] / front[name], 1.0, delta=1e-9)

    def test_a_part_that_yields_first(self):
        """The yield stress of a linear material is compared with the stress at the load at which the crack starts."""
        _, summary = self.run_scene(strip(self.crack, {"Toughness": 500.0}))
        factor = summary["start_of_growth"]["load_factor"]
        for part, warns in ((0.8, True), (20.0, False)):
            scene = strip(self.crack, {"Toughness": 500.0}, material={"Yield Stress": part * factor * PULL})
            _, summary = self.run_scene(scene)
            said = [warning for warning in summary["warnings"] if "the part yields there" in warning]
            self.assertEqual(len(said), int(warns), summary["warnings"])
            self.assertAlmostEqual(summary["start_of_growth"]["load_factor"], factor, delta=1e-12 * factor)
        # Far from the crack the stress is that of the load.
        scene = strip(self.crack, {"Toughness": 500.0}, material={"Yield Stress": 0.8 * factor * PULL})
        warning = next(w for w in self.run_scene(scene)[1]["warnings"] if "the part yields there" in w)
        match = re.search(r"larger in ([\d.]+) % of Bodies > Strip .* at most ([\d.e+]+) Pa", warning)
        self.assertGreater(float(match.group(1)), 30.0)
        self.assertGreater(float(match.group(2)), factor * PULL)

    def test_front_in_3d(self):
        """The node with the largest G of a front decides."""
        scene = os.path.join(os.environ["RHEGMA_SOURCE_DIR"], "xml_inputs", "verification", "penny_tension_static.xml")
        answer = rhegma(scene, "--quiet", "--output", self.path("out"), "--set", "Energy Release:Toughness=0.5")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        front = summary["cracks"][0]["fronts"][0]
        self.assertGreater(front["G_J_max"], 1.0001 * front["G_J"])
        self.assertAlmostEqual(0.5 * front["closest_to_initiation"], front["G_J_max"], delta=1e-9 * front["G_J_max"])
        self.assertAlmostEqual(summary["start_of_growth"]["load_factor"], math.sqrt(0.5 / front["G_J_max"]), delta=1e-9)

    def test_wrong_sections(self):
        scene = strip(self.crack, {"Toughness": 500.0}, Analysis="Quasi-Static")
        scene.set("Propagation", {"Toughness": "500"})
        answer = rhegma("--check", self.write("scene.xml", scene.text()))
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("leave Toughness and Toughness From Library out here", answer.messages)
        answer = rhegma("--check", self.write("scene.xml", strip(self.crack, {"Toughness": 500.0, "Contour Integral": False}).text()))
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("write Contour Integral = true", answer.messages)
        scene = strip(self.crack)
        scene.set("Propagation", {"Toughness": "500"})
        answer = rhegma("--check", self.write("scene.xml", scene.text()))
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("Energy Release > Toughness instead of this section", answer.messages)

    def test_toughness_of_the_library(self):
        _, summary = self.run_scene(strip(self.crack, {"Toughness From Library": "PMMA"}))
        lines = rhegma("--materials", "PMMA").output.splitlines()  # XML to paste, with a table of speeds
        table = next(line for line in lines if '"Toughness"' in line)
        self.assertIn(f'"0:{summary["start_of_growth"]["toughness"]:g},', table)


if __name__ == "__main__":
    unittest.main(verbosity=2)
