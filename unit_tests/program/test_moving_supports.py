#!/usr/bin/env python3
"""Supports that move by several cells: the body stays attached, the energy balance closes, ranks and restarts give the same, and a
grid that moves with the support gives what a support at rest gives in its own frame."""

import json
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT, ROUND_OFF  # noqa: E402
from scenes import Scene  # noqa: E402

CELL = 0.01
SPEED = 1.0  # [m/s], of the support
END = 0.045  # [s]: the support moves by 4.5 cells, waves through the bar and back four times


def bar(motion="Automatic", dimension=2):
    """A soft bar, 16 cells long, whose left end is pushed; plane stress without lateral support."""
    corner = [0.0, 0.0, 0.0][:dimension]
    return Scene({
        "Domain": {"Dimension": dimension, "Lower Corner": [-0.05, -0.03, -0.03][:dimension],
                   "Upper Corner": [0.26, 0.07, 0.05][:dimension], "Cell Size": CELL},
        "Time": {"Final Time": END},
        "Materials": {"Gel": {"Model": "Linear Elastic", "Density": 1000.0, "Young Modulus": 1e6, "Poisson Ratio": 0.3}},
        "Bodies": {"Bar": {"Material": "Gel", "Shape": "Box", "Lower Corner": corner,
                           "Upper Corner": [0.16, 0.04, 0.02][:dimension]}},
        "Boundaries": {"Push": {"Type": "Velocity", "Lower Corner": [-0.05, -1.0, -1.0][:dimension],
                                "Upper Corner": [0.021, 1.0, 1.0][:dimension], "Components": "x",
                                "Value": [SPEED, 0.0, 0.0][:dimension], "History": "0:0, 2e-3:1", "Box Motion": motion}},
        "Measure": {"Stress Alternation": {}},
        "Output": {"History Interval": 1e-3, "Checkpoint Interval": 1e-3},
    })


class MovingSupports(ProgramTest):
    def result(self, scene, name, *more, **options):
        path = self.write(name + ".xml", scene.text())
        answer = rhegma(path, "--output", self.path(name), "--quiet", *more, **options)
        self.assertEqual(answer.status, 0, answer)
        with open(self.path(name, "summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def balance(self, summary):
        energy = summary["energy"]
        return abs(energy["residual"]) / summary["largest_energy_supplied"]

    def test_the_body_stays_attached(self):
        """Its centre follows the support up to its strain: v / c of its length is the largest, 3 % or half a cell. The error of
        the energy balance is of first order in the step (0.6 % with CFL = 0.4, 0.14 % with 0.1)."""
        moved = SPEED * (END - 1e-3)
        for dimension in (2, 3):
            for motion in ("Automatic", "With Grid"):
                with self.subTest(motion, dimension=dimension):
                    scene = bar(motion, dimension).set("Time > CFL", 0.1)
                    summary = self.result(scene, f"{motion} {dimension}".replace(" ", "_"))
                    self.assertAlmostEqual(summary["bodies"][0]["centre"][0], 0.08 + moved, delta=0.5 * CELL)
                    self.assertLess(self.balance(summary), 2e-3)

    def test_impulse_of_the_support_is_the_momentum(self):
        """The mean force over each history interval times its length adds up to the momentum of the body."""
        for motion in ("Automatic", "With Grid"):
            with self.subTest(motion):
                summary = self.result(bar(motion), motion.replace(" ", "_"))
                with open(self.path(motion.replace(" ", "_"), "history.csv"), encoding="utf-8") as file:
                    names = file.readline().strip().split(",")
                    rows = [[float(x) if x else math.nan for x in line.split(",")] for line in file]
                time, force = (next(k for k, n in enumerate(names) if n.split(" ")[0] == wanted)
                               for wanted in ("time", "Push.force_x"))
                impulse = rows[0][time] * rows[0][force] + sum((b[time] - a[time]) * b[force] for a, b in zip(rows, rows[1:]))
                body = summary["bodies"][0]
                self.assertAlmostEqual(impulse / (body["mass"] * body["velocity"][0]), 1.0, delta=1e-8)

    def test_a_moving_grid_is_the_frame_of_the_support(self):
        """In that frame the bar flies onto a support that brakes; both runs differ by their steps, as the fastest particle has
        another speed, by some percent of the 5 % that it adds to that of waves."""
        twin = bar("Fixed")
        twin.set("Bodies > Bar > Velocity", [-SPEED, 0.0])
        twin.set("Boundaries > Push > Value", [-SPEED, 0.0]).set("Boundaries > Push > History", "0:1, 2e-3:0")
        frame, lab = self.result(twin, "frame"), self.result(bar("With Grid"), "lab")
        stress = [s["bodies"][0]["stress"]["xx"] for s in (frame, lab)]
        moved = SPEED * END
        self.assertAlmostEqual(lab["bodies"][0]["centre"][0] - frame["bodies"][0]["centre"][0], moved, delta=0.02 * CELL)
        scale = SPEED * math.sqrt(1e6 * 1000.0)  # rho c v
        self.assertAlmostEqual(stress[1] / scale, stress[0] / scale, delta=0.02)

    def test_a_moving_grid_has_less_alternation(self):
        boxes = [self.result(bar(m), m.replace(" ", "_"))["bodies"][0]["stress_alternation"]["deviation"]
                 for m in ("With Material", "With Grid")]
        self.assertLess(boxes[1], 0.5 * boxes[0])

    def test_nodes_on_a_trailing_edge_stay_held(self):
        """Up to half a cell: until then a box that moves holds what a fixed one holds, whose edge lies on the same nodes."""
        results = []
        for motion in ("Fixed", "With Material"):
            scene = bar(motion).set("Time > Final Time", 0.004).set("Boundaries > Push > Value", [-SPEED, 0.0])
            scene.set("Boundaries > Push > Upper Corner", [0.02, 1.0])
            results.append(self.result(scene, motion.replace(" ", "_"))["energy"])
        self.assertEqual(results[0], results[1])

    def test_ranks_are_alike(self):
        for motion in ("Automatic", "With Grid"):
            with self.subTest(motion):
                one = self.result(bar(motion), "one")
                two = self.result(bar(motion), "two", launcher=(*LAUNCHER, "-n", "2"), **ROOT)
                for name in ("kinetic", "strain", "external_work"):
                    self.assertAlmostEqual(two["energy"][name] / one["energy"][name], 1.0, delta=1e2 * ROUND_OFF)

    def test_a_restart_goes_on_alike(self):
        for motion in ("Automatic", "With Grid"):
            with self.subTest(motion):
                whole = self.result(bar(motion), "whole")
                first = bar(motion).set("Time > Maximum Steps", whole["steps"] // 2)
                self.result(first, "first")
                later = self.result(bar(motion), "later", "--restart", self.path("first", "checkpoint.h5"))
                self.assertEqual(later["energy"], whole["energy"])
                self.assertEqual(later["bodies"], whole["bodies"])

    def test_a_box_without_particles_loses_the_body(self):
        """A bar is pushed at its end. A wave of force rho c v A runs to its free end and comes back, and then the support pulls with
        that force. A box that starts at the end of the bar stays where it is, so that the bar leaves it and nothing pulls."""
        push, words = "Boundaries > Push", "Boundaries > Push: its box contains nodes at the surface of a body, but no particle"
        forces = {}
        for upper in (0.0, 0.021):
            scene = bar().set(push + " > Upper Corner", [upper, 1.0]).set("Time > Final Time", 0.016)
            warnings = self.result(scene, f"ends_at_{upper}")["warnings"]
            said = [text for text in warnings if words in text]
            self.assertEqual(len(said), 1 if upper == 0.0 else 0, warnings)
            if said:
                self.assertIn("15 mm (1.5 cells)", said[0])
                fixed = self.result(scene.set(push + " > Box Motion", "Fixed"), "fixed")["warnings"]
                self.assertEqual([text for text in fixed if words in text], [])
            with open(self.path(f"ends_at_{upper}", "history.csv"), encoding="utf-8") as file:
                names = [name.split(" ")[0] for name in file.readline().strip().split(",")]
                rows = [line.strip().split(",") for line in file]
            forces[upper] = float(rows[-1][names.index("Push.force_x")])
        expected = -math.sqrt(1e6 * 1000.0) * SPEED * 0.04  # of a bar in plane stress
        self.assertAlmostEqual(forces[0.021] / expected, 1.0, delta=0.2)
        self.assertAlmostEqual(forces[0.0] / expected, 0.0, delta=0.01)

    def test_wrong_scenes_get_a_message(self):
        push = "Boundaries > Push"
        cases = (
            (bar("With Grid").set("Boundaries > Wall", {"Type": "Symmetry", "Axis": "x", "Position": 0.0}), push + " > Box Motion",
             ["can't move along x past Boundaries > Wall"]),
            (bar("With Grid").set("Time > Analysis", "Static"), push + " > Box Motion", ["only in dynamic analyses"]),
            (bar("With Grid").set("Adaptivity", {"Maximum Level": 1, "Velocity Change": 0.1}), push + " > Box Motion", ["refined cells can't move"]),
            (bar("With Grid").again(push, "More"), "Boundaries > More > Box Motion", ["the grid moves with Boundaries > Push already"]),
            (bar("With Material").remove(push + " > Value").set(push + " > Field", "y, 0"), push + " > Box Motion",
             ["can't follow a Field"]),
            (bar("With Material").set(push + " > Upper Corner", [-0.02, 1.0]), push, ["no particle is in the box"]),
            (bar("With Material").set("Boundaries > Stop", {
                "Type": "Velocity", "Lower Corner": [0.038, -1.0], "Upper Corner": [0.052, 1.0], "Components": "x",
                "Value": [0.0, 0.0]}), push, ["both prescribe the node"]),
        )
        for k, (scene, where, words) in enumerate(cases):
            with self.subTest(words[0]):
                self.write(f"wrong{k}.xml", scene.text())
                answer = rhegma(self.path(f"wrong{k}.xml"), "--quiet", cwd=self.folder)
                self.assertEqual(answer.status, 1, answer)
                lines = [line for line in answer.messages.splitlines() if line.startswith(f"rhegma: {where}: ")]
                self.assertTrue(any(all(w in line for w in words) for line in lines), answer)


if __name__ == "__main__":
    unittest.main()
