#!/usr/bin/env python3
"""Cracks that do not grow, compared with a toughness: Energy Release > Toughness.

RHEGMA_SEED in the environment draws other cracks.
"""

import csv
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

    def columns(self, folder, *names):
        with open(self.path(folder, "history.csv"), encoding="utf-8") as file:
            rows = [row for row in csv.DictReader(line for line in file if not line.startswith("#"))]
        return [[float(row[name]) for row in rows] for name in names]

    def test_when_the_toughness_is_reached_at_rest(self):
        """Loads in proportion to time: G is in proportion to its square, so that the root is exact between samples, but for strains."""
        final, part = self.draw.uniform(1.0, 5.0), self.draw.uniform(0.3, 0.9)
        scene = strip(self.crack, {"Toughness": 500.0}, Analysis="Quasi-Static", **{"Load Steps": 4, "Final Time": final})
        for name in ("Top", "Bottom"):
            scene.set(f"Boundaries > {name} > History", f"0:0, {final!r}:1")
        _, whole = self.run_scene(scene)
        largest = whole["cracks"][0]["fronts"][0]["closest_to_initiation"] * 500.0
        _, summary = self.run_scene(scene.set("Energy Release > Toughness", largest * part**2))
        front = summary["cracks"][0]["fronts"][0]
        self.assertAlmostEqual(front["time_of_toughness"], part * final, delta=10.0 * PULL / 3e9 * final)
        said = re.search(r"G came to the toughness at about t = ([\d.]+) (m?)s", " ".join(summary["answers"]))
        self.assertIsNotNone(said, summary["answers"])
        self.assertAlmostEqual(float(said.group(1)) * (1e-3 if said.group(2) else 1.0), front["time_of_toughness"], delta=1e-3 * final)
        _, summary = self.run_scene(scene.set("Energy Release > Toughness", 1.01 * largest))
        self.assertIsNone(summary["cracks"][0]["fronts"][0]["time_of_toughness"])
        self.assertNotIn("came to the toughness", " ".join(summary["answers"]))

    def test_when_the_toughness_is_reached_in_motion(self):
        """The first time, by the root of G between samples; a run that goes on from a checkpoint knows it."""
        scene = strip(self.crack, {"Toughness": 500.0}, Analysis="Dynamic", **{"Final Time": 1.5e-4}).remove("Time > Rigid Modes")
        for name in ("Top", "Bottom"):
            scene.set(f"Boundaries > {name} > History", "0:0, 5e-5:1, 1e-4:0, 1:0")
        scene.set("Output > History Interval", 5e-6)
        _, whole = self.run_scene(scene)
        part = self.draw.uniform(0.4, 0.9)
        toughness = part * whole["cracks"][0]["fronts"][0]["closest_to_initiation"] * 500.0
        scene.set("Energy Release > Toughness", toughness)
        _, summary = self.run_scene(scene)
        found = summary["cracks"][0]["fronts"][0]["time_of_toughness"]
        time, release = self.columns("out", "time", "Notch.0.G_J")
        k = next(k for k, value in enumerate(release) if value >= toughness)
        roots = [math.sqrt(max(value, 0.0)) for value in release[k - 1:k + 1]]
        # G that drives the crack is that of J while mode I opens it.
        expected = time[k - 1] + (time[k] - time[k - 1]) * (math.sqrt(toughness) - roots[0]) / (roots[1] - roots[0])
        self.assertAlmostEqual(found, expected, delta=1e-6 * found)
        scene.set("Time > Final Time", 1.3e-4).set("Output > Checkpoint Interval", 1.2e-4)
        self.run_scene(scene, out="part")
        answer = rhegma(self.path("scene.xml"), "--restart", self.path("part", "checkpoint.h5"), "--quiet", "--output", self.path("rest"), "--set", "Time:Final Time=1.5e-4")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("rest", "summary.json"), encoding="utf-8") as file:
            self.assertAlmostEqual(json.load(file)["cracks"][0]["fronts"][0]["time_of_toughness"], found, delta=1e-9 * found)

    def test_a_part_that_yields_first(self):
        """The yield stress of a linear material is compared with the stress at the load at which the crack starts."""
        _, summary = self.run_scene(strip(self.crack, {"Toughness": 500.0}))
        factor = summary["start_of_growth"]["load_factor"]
        for part, warns in ((0.8, True), (20.0, False)):
            scene = strip(self.crack, {"Toughness": 500.0}, material={"Yield Stress": part * factor * PULL})
            _, summary = self.run_scene(scene)
            said = [warning for warning in summary["warnings"] if "the part yields there" in warning]
            self.assertEqual(len(said), int(warns), summary["warnings"])
            begin = re.search(r"largest von Mises stress outside of the contours of the fronts is ([\d.e+-]+) Pa at .* begins there at ([\d.e+-]+) times",
                              " ".join(summary["answers"]))
            self.assertEqual(begin is None, warns, summary["answers"])
            if begin:
                self.assertAlmostEqual(float(begin.group(2)) * float(begin.group(1)) / (20.0 * factor * PULL * factor), 1.0, delta=2e-3)
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

    def test_front_that_meets_the_surface(self):
        """A half-round flaw in a face of a block: nodes less than two cells from the face are left out and named; at a plane of symmetry, through the
        middle of the flaw, nodes stay."""
        cell, radius = 1e-3, 4e-3
        middle = [self.draw.uniform(-0.3, 0.3) * cell for _ in range(2)]
        block = {"Material": "Polymer", "Shape": "Box", "Lower Corner": [-0.012, 0.0, -0.012], "Upper Corner": [0.012, 0.012, 0.012]}
        pull = {name: {"Type": "Traction", "Body": "Block", "Corner": [-0.012, 0.0, z], "Edge 1": [0.024, 0.0, 0.0], "Edge 2": [0.0, 0.012, 0.0],
                       "Stress": [0.0, 0.0, sign * 1e6]} for name, z, sign in (("Top", 0.012, 1.0), ("Bottom", -0.012, -1.0))}
        for halved in (False, True):
            scene = strip(self.crack, {"Toughness": 30.0}).set("Bodies", {"Block": block}).set("Boundaries", pull)
            scene.set("Domain", {"Dimension": 3, "Lower Corner": [-0.015] * 3, "Upper Corner": [0.015] * 3, "Cell Size": cell})
            scene.set("Cracks", {"Flaw": {"Centre": [middle[0], 0.0, middle[1]], "Normal": [0.0, 0.0, 1.0], "Radius": radius}})
            if halved:
                scene.set("Domain > Lower Corner", [middle[0], -0.015, -0.015]).set("Bodies > Block > Lower Corner", [middle[0], 0.0, -0.012])
                scene.set("Domain > Upper Corner", [middle[0] + 0.03, 0.015, 0.015])
                scene.set("Boundaries > Middle", {"Type": "Symmetry", "Axis": "x", "Position": middle[0]})
                for name in pull:
                    scene.set(f"Boundaries > {name} > Corner", [middle[0], 0.0, pull[name]["Corner"][2]])
                    scene.set(f"Boundaries > {name} > Edge 1", [0.012 - middle[0], 0.0, 0.0])
            _, summary = self.run_scene(scene, out=f"halved_{halved}")
            front = summary["cracks"][0]["fronts"][0]
            nodes = front["front_nodes"]
            length = max(nodes["arc_length"])
            depths = [point[1] for point in nodes["position"]]
            self.assertLess(min(depths), 0.5 * cell)
            surfaces = [arc for arc, depth in zip(nodes["arc_length"], depths) if depth < 0.6 * cell]  # ends that are not at the plane
            near = [min(abs(arc - end) for end in surfaces) < 2.0 * cell for arc in nodes["arc_length"]]
            self.assertTrue(any(near) and not all(near))
            self.assertFalse(halved and near[depths.index(max(depths))], "the deepest node is at the plane of symmetry")
            self.assertEqual(nodes["at_surface"], near)
            inside, at_surface = (max(J for J, is_near in zip(nodes["G_J"], near) if is_near == which and J is not None) for which in (False, True))
            print(f"halved {halved}: {len(near)} nodes on {1e3 * length:.2f} mm, G {inside:.3f} inside, {at_surface:.3f} at the surface")
            start = summary["start_of_growth"]
            # Modes II and III are rounding here, mode I opens: G is that which drives the crack.
            self.assertAlmostEqual(30.0 * front["closest_to_initiation"], inside, delta=1e-3 * inside)
            self.assertAlmostEqual(30.0 * front["closest_at_surface"], at_surface, delta=1e-3 * at_surface)
            self.assertAlmostEqual(start["load_factor"], math.sqrt(30.0 / inside), delta=1e-3 * start["load_factor"])
            self.assertAlmostEqual(start["load_factor_at_surface"], math.sqrt(30.0 / at_surface), delta=1e-3 * start["load_factor"])
            named = any("nodes at the surface, which are left out" in answer for answer in summary["answers"])
            self.assertEqual(named, math.sqrt(at_surface / inside) > 1.005)

    def test_a_run_that_stops_early(self):
        """At half of the loads, or all of them: the factor is that on the loads of the scene."""
        scene = strip(self.crack, {"Toughness": 500.0}).set("Time > Load Steps", 4).set("Materials > Polymer > Yield Stress", 20.0 * PULL)
        _, whole = self.run_scene(scene)
        _, part = self.run_scene(scene.set("Time > Maximum Steps", 2), out="part")
        self.assertEqual((part["time"], whole["time"]), (0.5 * whole["time"], 2.0 * part["time"]))
        factors = [summary["start_of_growth"]["load_factor"] for summary in (whole, part)]
        self.assertAlmostEqual(factors[1] / factors[0], 1.0, delta=10.0 * PULL / 3e9)  # strains
        self.assertTrue(any("of which it applied 50 %" in answer for answer in part["answers"]), part["answers"])
        begin = [re.search(r"begins there at ([\d.e+-]+) times the loads", " ".join(summary["answers"])) for summary in (whole, part)]
        self.assertAlmostEqual(float(begin[1].group(1)) / float(begin[0].group(1)), 1.0, delta=2e-3)  # four digits

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
