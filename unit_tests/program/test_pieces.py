#!/usr/bin/env python3
"""Pieces of bodies: their number, masses and centres, against the areas of polygons that random lines cut."""

import csv
import json
import math
import os
import random
import shutil
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from program import ProgramTest, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT  # noqa: E402
from scenes import plate  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "20261129"))
CELL = 0.05  # of the plate, which is a square of edge 1


def cut(polygon, point, direction):
    """The part of a convex polygon to the left of a line, as corners."""
    side = [direction[0] * (y - point[1]) - direction[1] * (x - point[0]) for x, y in polygon]
    part = []
    for k, (a, b) in enumerate(zip(polygon, polygon[1:] + polygon[:1])):
        s, t = side[k], side[(k + 1) % len(polygon)]
        if s >= 0.0:
            part.append(a)
        if (s >= 0.0) != (t >= 0.0):
            part.append(tuple(u + s / (s - t) * (v - u) for u, v in zip(a, b)))
    return part


def area(polygon):
    return 0.5 * sum(x * v - u * y for (x, y), (u, v) in zip(polygon, polygon[1:] + polygon[:1]))


def measured(scene):
    return scene.set("Measure", {"Pieces": {}})


class Pieces(ProgramTest):
    def outcome(self, scene, folder="out", **options):
        """summary.json, rows of history.csv and the numbers of the particles' pieces at the end, with their masses."""
        answer = rhegma(self.write("scene.xml", scene.text()), "--output", self.path(folder), "--quiet", **options)
        self.assertEqual(answer.status, 0, answer)
        with open(self.path(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        with open(self.path(folder, "history.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        with h5py.File(self.path(folder, "fields.h5"), "r") as file:
            last = file[sorted(file)[-1]]["particles"]
            return summary, rows, last["piece"][()], last["mass"][()]

    def agree(self, summary, rows, piece, mass):
        """The field, the history and the summary say the same."""
        pieces = summary["pieces"]
        self.assertEqual(int(float(rows[-1]["pieces"])), pieces["number"])
        self.assertEqual(set(piece.ravel()), set(range(pieces["number"])))
        for k, one in enumerate(pieces["largest"]):
            self.assertAlmostEqual(mass[piece == k].sum(), one["mass"], delta=1e-12 * mass.sum())
        self.assertAlmostEqual(float(rows[-1]["largest_piece"]), pieces["largest"][0]["mass"], delta=1e-12 * mass.sum())
        masses = [one["mass"] for one in pieces["largest"]]
        self.assertEqual(masses, sorted(masses, reverse=True))

    def test_a_line_through_the_plate(self):
        """Anywhere and at any angle, in motion and in equilibrium; areas are those of the polygons, as the cut divides the particles on it. Ended
        within the plate the crack leaves it whole."""
        print(f"seed {SEED}")
        draw = random.Random(SEED)
        for case in range(6):
            point, angle = (draw.uniform(0.3, 0.7), draw.uniform(0.3, 0.7)), draw.uniform(0.0, math.pi)
            direction = (math.cos(angle), math.sin(angle))
            left = area(cut([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], point, direction))
            ends = [p + sign * 1.0 * d for sign in (-1.0, 1.0) for p, d in zip(point, direction)]
            for through in (True, False):
                with self.subTest(case=case, point=point, angle=angle, through=through):
                    scene = measured(plate()).remove("Energy Release")
                    scene.set("Cracks", {"Cut": {"Points": ends[:2] + (ends[2:] if through else list(point))}}).set("Domain > Lower Corner", [-1.0, -1.0])
                    scene.set("Domain > Upper Corner", [2.0, 2.0]).set("Domain > Cell Size", CELL)
                    if case % 2:
                        scene.remove("Boundaries").set("Time > Analysis", "Static").set("Time > Rigid Modes", "Remove")
                    found = self.outcome(scene)
                    self.agree(*found)
                    pieces = found[0]["pieces"]
                    self.assertEqual(pieces["number"], 2 if through else 1)
                    if not through:
                        continue
                    larger = max(left, 1.0 - left)
                    print(f"fraction of the larger piece {pieces['largest'][0]['fraction']:.4f}, area {larger:.4f}")
                    self.assertAlmostEqual(pieces["largest"][0]["fraction"], larger, delta=1e-3)

    def test_bodies_that_touch_do_not_and_are_bonded(self):
        """Two boxes a cell and a half apart are two pieces; without a gap they share nodes and are one."""
        for gap, number in ((1.5 * CELL, 2), (0.0, 1)):
            scene = measured(plate()).remove("Energy Release").remove("Cracks").remove("Boundaries").set("Domain > Upper Corner", [2.0, 1.2])
            scene.set("Bodies > Small", {"Material": "Polymer", "Shape": "Box", "Lower Corner": [1.0 + gap, 0.2], "Upper Corner": [1.5 + gap, 0.7]})
            if gap == 0.0:
                scene.set("Bodies > Small > Bonded To", "Plate")
            found = self.outcome(scene)
            self.agree(*found)
            pieces = found[0]["pieces"]
            self.assertEqual(pieces["number"], number)
            self.assertEqual([one["bodies"] for one in pieces["largest"]], [["Plate"], ["Small"]] if number == 2 else [["Plate", "Small"]])
            for axis, middle in enumerate((1.25 + gap, 0.45)[:2]):
                if number == 2:
                    self.assertAlmostEqual(pieces["largest"][1]["centre"][axis], middle, delta=1e-12)

    def test_a_crack_that_runs_through(self):
        """A strip that is torn from its edge: one piece, then two; the columns of the history and the field keep up, before the first step nothing is known."""
        strip = measured(plate()).remove("Energy Release").set("Domain", {"Dimension": 2, "Lower Corner": [-0.2, -0.2], "Upper Corner": [0.8, 1.2],
                                                                           "Cell Size": 0.025})
        strip.set("Bodies > Plate > Upper Corner", [0.3, 1.0]).set("Cracks > Notch > Points", [-0.01, 0.507, 0.1, 0.507])
        pull = {"Type": "Velocity", "Lower Corner": [-1.0, 0.98], "Upper Corner": [1.0, 1.02], "Value": [0.0, 8.0], "Components": "y"}
        strip.set("Boundaries", {"Up": pull, "Down": {**pull, "Lower Corner": [-1.0, -0.02], "Upper Corner": [1.0, 0.02], "Value": [0.0, -8.0]}})
        strip.set("Energy Release", {}).set("Propagation", {"Toughness": "20"}).set("Time > Final Time", 2e-3)
        strip.set("Output", {"History Interval": 2e-5, "Field Interval": 5e-4})
        found = self.outcome(strip)
        self.agree(*found)
        numbers = [int(float(row["pieces"])) for row in found[1] if row["pieces"]]
        print("pieces over time:", numbers)
        self.assertEqual((numbers[1], numbers[-1]), (1, 2))
        self.assertEqual(numbers, sorted(numbers))
        self.assertAlmostEqual(found[0]["pieces"]["largest"][0]["fraction"], 0.5, delta=0.05)
        self.assertTrue(any("2 pieces" in answer for answer in found[0]["answers"]), found[0]["answers"])
        with h5py.File(self.path("out", "fields.h5"), "r") as file:
            self.assertEqual(set(numpy.ravel(file[sorted(file)[0]]["particles"]["piece"][()])), {-1})

    def test_a_run_that_continues_knows_its_pieces(self):
        """From the checkpoint at its end, without another sample."""
        scene = measured(plate()).remove("Energy Release").set("Cracks > Notch > Points", [-0.1, 0.62, 1.1, 0.41])
        scene.set("Output", {"Checkpoint Interval": 5e-4})
        first = self.outcome(scene, "first")[0]
        answer = rhegma(self.path("scene.xml"), "--restart", self.path("first", "checkpoint.h5"), "--quiet", "--output", self.path("rest"))
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("rest", "summary.json"), encoding="utf-8") as file:
            rest = json.load(file)
        self.assertEqual(rest["pieces"], first["pieces"])
        self.assertIn("pieces: at the end there are 2 pieces", " ".join(rest["answers"]))

    @unittest.skipUnless(shutil.which("mpirun"), "without mpirun")
    def test_ranks_find_the_same(self):
        scene = measured(plate()).remove("Energy Release").set("Cracks > Notch > Points", [-0.1, 0.62, 1.1, 0.41])
        one = self.outcome(scene, "one")
        two = self.outcome(scene, "two", launcher=(*LAUNCHER, "-np", "2"), **ROOT)
        self.agree(*two)
        for mine, theirs in zip(one[0]["pieces"]["largest"], two[0]["pieces"]["largest"]):
            self.assertAlmostEqual(mine["mass"], theirs["mass"], delta=1e-12 * mine["mass"])
            for a, b in zip(mine["centre"], theirs["centre"]):
                self.assertAlmostEqual(a, b, delta=1e-9)
        self.assertEqual(one[0]["pieces"]["number"], two[0]["pieces"]["number"])

    def test_a_block_cut_by_a_plane(self):
        """In 3D, by a facet that is larger than the block, off the rows of its cells."""
        scene = measured(plate()).remove("Energy Release").remove("Boundaries")
        scene.set("Domain", {"Dimension": 3, "Lower Corner": [-0.4] * 3, "Upper Corner": [1.4] * 3, "Cell Size": 0.1})
        scene.set("Bodies > Plate", {"Material": "Polymer", "Shape": "Box", "Lower Corner": [0.0] * 3, "Upper Corner": [1.0] * 3})
        scene.set("Cracks", {"Cut": {"Centre": [0.5, 0.5, 0.37], "Normal": [0.1, -0.2, 1.0], "Radius": 0.85}})
        scene.set("Time > Maximum Steps", 3)
        found = self.outcome(scene)
        self.agree(*found)
        # The plane meets the axis of the block, x = y = 0.5, at z = 0.37.
        self.assertEqual(found[0]["pieces"]["number"], 2)
        self.assertAlmostEqual(found[0]["pieces"]["largest"][0]["fraction"], 0.63, delta=1e-3)

    def test_without_mechanics(self):
        scene = measured(plate()).remove("Cracks").remove("Energy Release").remove("Boundaries")
        scene.set("Thermal", {"Mechanics": False, "Initial Temperature": 300.0})
        answer = rhegma(self.write("scene.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("Measure > Pieces", answer.messages)
        self.assertIn("without mechanics no body comes apart", answer.messages)


if __name__ == "__main__":
    unittest.main()
