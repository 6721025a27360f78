#!/usr/bin/env python3
"""Propagation > Start Time in equilibrium and in motion, quantities of growth as References, and Final Time on restart."""

import json
import os
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from file_scene import FileScene  # noqa: E402
from test_shear_at_rest import PULL, ShearTest, inclined, strip  # noqa: E402
from program import SOURCE, rhegma  # noqa: E402


class GrowthTest(ShearTest):
    def growth(self, scene):
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet", "--output", self.path("out"))
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return answer, json.load(file)


class StartTime(GrowthTest):
    def scene(self, start, history="t", final=1.0):
        scene = strip({"Analysis": "Quasi-Static", "Load Steps": 4, "Final Time": final, "Maximum Steps": 60}, "150",
                      {"Notch": inclined(0.0, 0.012)}, history, **{"Load Control": "Functions of Time", "Start Time": start})
        return scene.set("Propagation > Increment", 1.0)

    def test_growth_counts_at_the_end_of_a_load_step(self):
        summary = self.growth(self.scene(0.0))[1]
        free = summary["propagation"]["initiation"]["time"]
        self.assertIsNotNone(free)
        for start in (0.9, 1.0):  # in the last load step, from 0.75 s on, and at its end
            summary = self.growth(self.scene(start))[1]
            initiation = summary["propagation"]["initiation"]
            self.assertIsNotNone(initiation["time"], summary["warnings"])
            self.assertEqual(initiation["from"], 0.75)
            self.assertAlmostEqual(initiation["time"], max(free, start), delta=1e-3 if free < start else 0.05)

    def test_is_named_where_it_delays_growth(self):
        """G follows the square of the loads, so that at the start time it is that of the load, as long as nothing has grown."""
        free, summary = self.growth(self.scene(0.0))
        self.assertNotIn("held by", " ".join(summary["answers"]), free)
        self.assertFalse(summary["cracks"][0]["fronts"][0]["held_until_start_time"])
        began = summary["propagation"]["initiation"]["time"]
        for start in (0.9, 1.0):
            answer, summary = self.growth(self.scene(start))
            front = summary["cracks"][0]["fronts"][0]
            self.assertTrue(front["held_until_start_time"], answer)
            until = f"{start * 1e3:g} ms" if start < 1.0 else "1 s"
            self.assertIn(f"held by Propagation > Start Time until {until}: it started at ", " ".join(summary["answers"]))
            # A load step ends at the start time; began is found to within a few thousandths of it.
            self.assertAlmostEqual(front["start_release"], (start / began) ** 2, delta=0.02 * (start / began) ** 2)

    def test_is_named_where_it_delays_growth_in_motion(self):
        def scene(start):
            return strip({"Final Time": 4e-4}, "20", {"Notch": inclined(0.0, 0.012)}, "0:0, 1e-4:1", **{"Start Time": start}).remove("Time > Rigid Modes")
        free, summary = self.growth(scene(0.0))
        self.assertNotIn("held by", " ".join(summary["answers"]), free)
        began = summary["cracks"][0]["fronts"][0]["initiated"]
        self.assertIsNotNone(began, free)
        answer, summary = self.growth(scene(1.5 * began))
        front = summary["cracks"][0]["fronts"][0]
        self.assertTrue(front["held_until_start_time"], answer)
        self.assertAlmostEqual(front["initiated"], 1.5 * began, delta=1e-9 * began)
        said = re.search(r"held by Propagation > Start Time until [\d.]+ us: it started at ([\d.]+) times", " ".join(summary["answers"]))
        self.assertIsNotNone(said, answer)
        self.assertGreater(float(said.group(1)), 1.0)

    def test_holds_no_growth_by_a_later_load(self):
        """A first load takes G above the toughness before the start time, is taken off, and a second one makes the crack grow."""
        answer, summary = self.growth(self.scene(0.7, "0:0, 0.5:1, 0.75:0.1, 1:0.7"))
        front = summary["cracks"][0]["fronts"][0]
        self.assertAlmostEqual(front["initiated"], 1.0, delta=1e-6, msg=answer)  # up to rounding of load steps
        self.assertFalse(front["held_until_start_time"], answer)
        before = front["release_before_start_time"]
        self.assertGreater(before, 1.0)
        # The square of the loads, but for what the body turns and stretches under them.
        self.assertAlmostEqual(front["start_release"] / before, 0.7**2, delta=0.01)
        said = " ".join(summary["answers"])
        self.assertNotIn("held by", said)
        found = re.search(r"\(before Propagation > Start Time = 700 ms G had reached ([\d.]+) times the initiation toughness\)", said)
        self.assertIsNotNone(found, said)
        self.assertAlmostEqual(float(found.group(1)), before, delta=5e-4 * before)  # four digits

    def test_is_named_where_it_prevents_growth(self):
        answer, _ = self.growth(self.scene(0.7, "0:0, 0.5:1, 0.75:0.1, 1:0.1"))
        said = re.search(r"not initiated; G reached at most 0\.\d+ of the initiation toughness\. Before Propagation > Start Time = 700 ms "
                         r"G reached ([\d.]+) of the initiation toughness, but no crack may advance then", answer.messages)
        self.assertIsNotNone(said, answer)
        self.assertGreater(float(said.group(1)), 1.0)
        answer, _ = self.growth(self.scene(2.0))
        self.assertRegex(answer.messages, "no crack may advance before 2 s .*ended at 1 s. Before Propagation > Start Time = 2 s G reached")

    def test_in_motion(self):
        scene = strip({"Final Time": 4e-4}, "20", {"Notch": inclined(0.0, 0.012)}, "t<2e-4 ? sin(pi*t/2e-4)^2 : 0",
                      **{"Start Time": 3.9e-4}).remove("Time > Rigid Modes")
        scene.set("Damping", {"Mass Rate": 2e4})
        answer, summary = self.growth(scene)
        self.assertEqual(summary["cracks"][0]["fronts"][0]["status"], "not initiated", answer)
        self.assertIn("Before Propagation > Start Time = 390 us G reached ", answer.messages)


class GrowthUpToTheEnd(GrowthTest):
    """A beam whose ends are moved apart: while they are, the crack grows; it stops where they stop."""

    def said(self, history):
        scene = FileScene(os.path.join(SOURCE, "xml_inputs", "verification", "dcb_grips_static.xml"))
        for arm in ("Upper", "Lower"):
            scene.set(f"Boundaries > {arm} Arm > History", history)
        answer, summary = self.growth(scene.set("Time > Load Steps", 8))
        self.assertGreater(summary["cracks"][0]["fronts"][0]["increments"], 0, answer)
        return summary, [line for line in summary["answers"] if "has not stopped" in line]

    def test_is_said(self):
        summary, lines = self.said("1")
        self.assertEqual(summary["cracks"][0]["fronts"][0]["status"], "growing")
        self.assertEqual(lines, ["crack Notch, front 0: the crack has not stopped: its growth is that of the loads up to t = 1 s"])
        self.assertEqual(summary["propagation"]["not_stopped"], ["crack Notch, front 0"])

    def test_is_not_said_of_a_crack_that_stops(self):
        summary, lines = self.said("0:1, 0.8:1, 0.801:0, 1:0")
        self.assertEqual((lines, summary["propagation"]["not_stopped"]), ([], []))
        self.assertIn(summary["cracks"][0]["fronts"][0]["status"], ("arrested", "at rest"))


class FacesThatPress(GrowthTest):
    """The notch of a plate that is struck: the first wave presses its faces together while it shears them."""

    def test_are_said_with_the_overlap_and_with_K(self):
        scene = FileScene(os.path.join(SOURCE, "xml_inputs", "verification", "kalthoff.xml")).set("Time > Final Time", 4e-5)
        answer, summary = self.growth(scene)
        said = " ".join(summary["answers"])
        found = re.search(r"its faces pressed together as it started \(K_I = (-[\d.]+), K_II = (-[\d.]+) MPa m\^0\.5\)", said)
        self.assertIsNotNone(found, said)
        front = summary["cracks"][0]["fronts"][0]
        self.assertAlmostEqual(float(found.group(1)) * 1e6, front["start_K_I"], delta=1e-3 * abs(front["start_K_I"]))
        self.assertRegex(answer.messages, r"crack Notch: its faces overlapped by up to [\d.]+ um \([\d.]+ cells.*\) at t = .* us, because the scene has no "
                                          "contact; .* add a section Contact")
        answer, summary = self.growth(scene.set("Contact", {}))
        self.assertNotIn("overlap", answer.messages)
        self.assertNotIn("pressed together", " ".join(summary["answers"]))
        # What is left of K_I is the penalty layer's: an overlap of hundredths of a cell.
        self.assertLess(summary["cracks"][0]["largest_overlap"], 0.01 * 2e-3)


class Yield(GrowthTest):
    """A linear law with a yield stress: what yields in the run is said, also where its loads or its growth have fallen by the end."""

    def said(self, scene, part):
        summary = self.growth(scene.set("Materials > Polymer > Yield Stress", part * PULL))[1]
        return summary, [line for line in summary["warnings"] if "the von Mises stress is larger in" in line]

    def test_loads_that_have_fallen(self):
        scene = strip({"Analysis": "Quasi-Static", "Load Steps": 4}, "1e6", {"Notch": inclined(0.0, 0.012)}, "0:0, 0.5:1, 1:0.1",
                      **{"Load Control": "Functions of Time"})
        _, (line,) = self.said(scene, 0.5)
        found = re.search(r"at t = 500 ms, the von Mises stress is larger in ([\d.]+) % of Bodies > Strip outside of the contours of the fronts, "
                          r"at most ([\d.e+]+) Pa", line)
        self.assertIsNotNone(found, line)
        self.assertGreater(float(found.group(1)), 50.0)  # above twice the yield stress wherever the crack does not unload it
        self.assertGreater(float(found.group(2)), PULL)
        self.assertEqual(self.said(scene, 20.0)[1], [])

    def test_the_load_factor_at_which_the_crack_starts(self):
        scene = strip({"Analysis": "Quasi-Static", "Load Steps": 3}, "150", {"Notch": inclined(0.0, 0.012)})
        summary, none = self.said(scene, 1e3)
        self.assertEqual(none, [])
        factor = summary["propagation"]["largest_load"]["load_factor"]
        _, (line,) = self.said(scene, 0.5 * factor)
        self.assertRegex(line, r"at [\d.e+-]+ times the loads of Time > Final Time, the von Mises stress is larger in")


class References(ShearTest):
    def refused(self, control, *quantities):
        scene = strip({"Analysis": "Quasi-Static", "Load Steps": 2}, "150", {"Notch": inclined(0.0, 0.012)}, "t", **{"Load Control": control})
        scene.set("Reference", {f"R{k}": {"Quantity": quantity, "Value": 1.0, "Tolerance": 0.1, "Source": "a test"}
                                for k, quantity in enumerate(quantities)})
        answer = rhegma(self.write("scene.xml", scene.text()), "--check", "--quiet")
        self.assertEqual(answer.status, 0, answer)

    def test_documented_quantities_exist(self):
        front = [f"cracks.Notch.fronts.0.{name}" for name in
                 ("closest_to_initiation", "hoop_stress_load", "first_turn", "turn", "initiated", "last_advance", "increments",
                  "energy_of_new_faces", "arrival.time", "arrival.position.0")]
        states = [f"propagation.{state}.{name}" for state in ("initiation", "largest_load", "unstable_from", "unstable_to", "snap_back_from")
                  for name in ("load_factor", "new_area")]
        self.refused("Load Factor", "propagation.load_factor", "cracks.Notch.fronts.0.hoop_stress_factor", *states, *front)
        self.refused("Functions of Time", "propagation.initiation.time", "propagation.unstable_from.time", "propagation.unstable_from.new_area",
                     "cracks.Notch.fronts.0.closest_by_hoop_stress", *front)


class Restart(ShearTest):
    def restarted(self, control):
        scene = strip({"Analysis": "Quasi-Static", "Load Steps": 2}, "2000", {"Notch": inclined(0.0, 0.012)}, "t", **{"Load Control": control})
        scene.set("Output > Checkpoint Interval", 1.0)
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet", "--output", self.path("out"))
        self.assertEqual(answer.status, 0, answer)
        return rhegma(self.path("scene.xml"), "--quiet", "--output", self.path("other"), "--restart", self.path("out", "checkpoint.h5"),
                      "--set", "Time:Final Time=1.5")

    def test_final_time_of_a_factor_must_stay(self):
        answer = self.restarted("Load Factor")
        self.assertEqual(answer.status, 1, answer)
        self.assertEqual(len(answer.messages.splitlines()), 1, answer)
        for words in ('Time > Final Time is "1.5" in the scene and "1" in the checkpoint', "Load Control = Load Factor", "start anew"):
            self.assertIn(words, answer.messages)
        self.assertFalse(os.path.exists(self.path("other")))

    def test_final_time_of_given_loads_may_change(self):
        self.assertEqual(self.restarted("Functions of Time").status, 0)


if __name__ == "__main__":
    unittest.main()
