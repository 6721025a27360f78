#!/usr/bin/env python3
"""Fronts that the cells stop are not arrested: the run ends with status 2 and says what to change, or marks them."""

import csv
import json
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402
from test_running_cracks import pulled_apart  # noqa: E402

CELL = 0.05


def passing(**more):
    """A crack that passes two cells below another, too near for its cells, with G above its toughness."""
    scene = pulled_apart([0.0, 0.52, 0.4, 0.52]).set("Propagation > Direction", "Straight")
    scene.set("Cracks > Other", {"Points": [0.6, 0.52 + 2.0 * CELL, 0.9, 0.52 + 2.0 * CELL], "Fronts": "None"})
    for name, value in more.items():
        scene.set("Propagation > " + name.replace("_", " "), value)
    return scene.set("Output", {"History Interval": 2e-5})


class FrontsThatStop(ProgramTest):
    def run_scene(self, scene, *options):
        """\\return the answer, the summary as text and read, and the rows of the history"""
        answer = rhegma(self.write("scene.xml", scene.text()), *options)
        with open(self.path("scene.out", "summary.json")) as file:
            text = file.read()
        with open(self.path("scene.out", "history.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        return answer, text, json.loads(text), rows

    def test_a_front_that_the_cells_stop_ends_the_run(self):
        answer, text, summary, rows = self.run_scene(passing())
        self.assertEqual(answer.status, 2, answer)
        front = summary["cracks"][0]["fronts"][0]
        self.assertEqual(front["status"], "stopped: less than three cells from crack Other")
        self.assertTrue(front["stopped"])
        self.assertFalse(front["ended"])
        self.assertGreaterEqual(front["stop"]["G"], 0.99 * front["stop"]["toughness"])
        self.assertNotIn("halted", text)
        last = answer.messages.splitlines()[-1]
        for words in ("the run stopped at t = ", "crack Notch, front 0", "less than three cells from crack Other", "not arrested",
                      "G = ", "Gc = ", "Domain > Cell Size", "On Stop = Continue", "--restart"):
            self.assertIn(words, last)
        self.assertNotIn(": arrested", answer.output)
        # It ends with the sample that has the flag.
        self.assertEqual([float(row["Notch.0.stopped"]) for row in rows], [0.0] * (len(rows) - 1) + [1.0])
        self.assertAlmostEqual(float(rows[-1]["time"]), summary["time"], delta=1e-12)
        self.assertLess(summary["time"], 4e-3)
        # The answer comes first.
        self.assertEqual(list(summary)[:3], ["status", "answers", "warnings"])
        self.assertIn("less than three cells", summary["status"])
        self.assertEqual(summary["answers"][0], summary["status"])
        self.assertIn("the cells stopped crack Notch, front 0", summary["answers"][1])

    def test_the_rest_may_go_on_from_there(self):
        """The checkpoint keeps the status; a run that continues from it comes to its end with the flag on."""
        answer, _, _, before = self.run_scene(passing())
        self.assertEqual(answer.status, 2, answer)
        checkpoint = self.path("scene.out", "checkpoint.h5")
        again, _, summary, _ = self.run_scene(passing(), "--restart", checkpoint)
        self.assertEqual(again.status, 2, again)
        answer, _, summary, rows = self.run_scene(passing(On_Stop="Continue"), "--restart", checkpoint)
        self.assertEqual(answer.status, 0, answer)
        self.assertGreater(len(rows), len(before))
        self.assertAlmostEqual(summary["time"], 4e-3)
        front = summary["cracks"][0]["fronts"][0]
        self.assertEqual(front["status"], "stopped: less than three cells from crack Other")
        self.assertEqual({row["Notch.0.stopped"] for row in rows[len(before):]}, {"1"})

    def test_a_scene_may_allow_it(self):
        answer, _, summary, rows = self.run_scene(passing(On_Stop="Continue"))
        self.assertEqual(answer.status, 0, answer)
        self.assertIn("the cells stopped crack Notch, front 0", answer.output)
        self.assertIn("not arrested: G = ", answer.output)
        self.assertEqual(summary["status"], "finished")
        self.assertIn("the cells stopped crack Notch, front 0", summary["answers"][1])
        self.assertEqual(float(rows[-1]["Notch.0.stopped"]), 1.0)

    def test_arrest_has_both_numbers_and_one_line(self):
        """A load that comes and goes: the front starts and stops, and has one line for it."""
        scene = pulled_apart([0.0, 0.52, 0.4, 0.52], toughness="20")
        for name in ("Top", "Bottom"):
            scene.set("Boundaries > " + name + " > History", "0:0, 1e-3:1, 1.4e-3:0, 2e-3:1, 2.4e-3:0")
        answer, _, summary, rows = self.run_scene(scene)
        self.assertEqual(answer.status, 0, answer)
        front = summary["cracks"][0]["fronts"][0]
        self.assertGreater(front["increments"], 0)
        lines = [line for line in answer.output.splitlines() if line.startswith("crack Notch, front 0")]
        self.assertEqual(len(lines), 1, answer.output)
        self.assertIn("extension ", lines[0])
        if not front["ended"]:
            self.assertEqual(front["status"], "arrested", lines)
            self.assertRegex(lines[0], r"arrested at t = .*, G = \S+ J/m2 below Gc = 20 J/m2")
        self.assertEqual({float(row["Notch.0.stopped"]) for row in rows}, {0.0})

    def test_the_answer_is_last(self):
        answer, _, summary, _ = self.run_scene(pulled_apart([0.0, 0.52, 0.4, 0.52]))
        self.assertEqual(answer.status, 0, answer)
        self.assertEqual(answer.output.splitlines()[-len(summary["answers"]):], summary["answers"])
        self.assertRegex(summary["answers"][0], r"the run finished at t = 4 ms after \d+ steps")
        self.assertRegex(summary["answers"][1], r"extension .* to .* m, mean speed .* m/s, reached the surface of its body at")
        self.assertRegex(summary["answers"][2], r"energy balance: .*not accounted for")
        self.assertRegex(summary["answers"][3], r"^\d+ warnings?$|^no warnings$")


class BodiesOutside(ProgramTest):
    def test_a_body_that_does_not_fit_is_told_where_and_what_helps(self):
        scene = plate().set("Domain > Upper Corner", [0.9, 1.2])
        answer = rhegma(self.write("scene.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 1, answer)
        for words in ("Bodies > Plate: lies from 0 to 1 m along x", "domain's", "0.9 m", "Domain > Lower Corner, Upper Corner",
                      "Operation = Cut", "Side (Type = Symmetry)"):
            self.assertIn(words, answer.messages)
        cut = {"Operation": "Cut", "Shape": "Box", "Lower Corner": [0.85, -0.1], "Upper Corner": [1.1, 1.1]}
        scene.set("Bodies > Plate > Operations", {"Rest": cut}).remove("Boundaries").remove("Cracks").remove("Energy Release")
        answer = rhegma(self.write("scene.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 0, answer)
        cut["Lower Corner"] = [0.85, 0.5]
        answer = rhegma(self.write("scene.xml", scene.set("Bodies > Plate > Operations", {"Rest": cut}).text()), "--check")
        self.assertEqual(answer.status, 1, answer)
        self.assertRegex(answer.messages, r"Bodies > Plate: part of the body lies outside the domain, such as at \(0\.9")

    def test_a_body_that_leaves_says_where(self):
        scene = plate().remove("Boundaries").remove("Cracks").remove("Energy Release")
        scene.set("Bodies > Plate > Velocity", [300.0, 0.0]).set("Time > Final Time", 0.1).set("Time > Retries", 0)
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 2, answer)
        for words in ("the body Plate left the domain, to (", "the domain reaches from (", "Domain > Lower Corner, Upper Corner",
                      "Side (Type = Symmetry)", "Final Time"):
            self.assertIn(words, answer.messages)


if __name__ == "__main__":
    unittest.main()
