#!/usr/bin/env python3
"""Cracks that the cells are too coarse for: the run goes on, and warns."""

import csv
import json
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

FORMULATIONS = ("Dual Field", "Broken Cell", "Corrected Broken Cell")


def cracked(points, formulation="Dual Field"):
    """The plate, of cells of 50 mm, with another crack and no contour around its front."""
    scene = plate().remove("Energy Release").set("Cracks > Notch > Points", points)
    return scene.set("Cracks > Formulation", formulation)


def pressed(stress):
    """An inner crack with this stress [Pa] across it, before waves return."""
    scene = cracked([0.25, 0.5, 0.75, 0.5]).set("Time > Final Time", 5e-4).remove("Boundaries > Pull")
    for name, y, sign in (("Top", 1.0, 1.0), ("Bottom", 0.0, -1.0)):
        load = {"Type": "Traction", "Body": "Plate", "From": [0.0, y], "To": [1.0, y], "Stress": [0.0, sign * stress]}
        scene.set("Boundaries > " + name, load)
    return scene


def supported(points, position=0.0):
    """A crack in the plate with a plane of symmetry, by default along its lower edge, which is a plane of nodes."""
    return cracked(points).set("Boundaries > Wall", {"Type": "Symmetry", "Axis": "y", "Position": position})


class OddCracks(ProgramTest):
    def reports(self, scene, *words, where="Cracks > Notch"):
        """Finishes with finite numbers and warnings with these words, one for each."""
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        lines = answer.messages.splitlines()
        self.assertEqual(len(lines), len(words), answer)
        for line, word in zip(lines, words):
            self.assertTrue(line.startswith("rhegma: warning: " + where), line)
            self.assertIn(word, line)
        with open(self.path("scene.out", "summary.json")) as file:
            self.assertEqual(len(json.load(file)["warnings"]), len(words))
        with open(self.path("scene.out", "history.csv"), newline="") as file:
            rows = [[float(value) for value in row] for row in list(csv.reader(file))[1:]]
        self.assertGreater(len(rows), 10)
        self.assertTrue(all(math.isfinite(value) for row in rows for value in row))

    def test_crack_shorter_than_a_cell(self):
        for formulation in FORMULATIONS:
            with self.subTest(formulation=formulation):
                # With front springs, nodes open a quarter of a cell ahead of both fronts.
                held = [] if formulation == "Dual Field" else ["separates nothing"]
                self.reports(cracked([0.51, 0.52, 0.53, 0.52], formulation), "extends over", *held)

    def test_faces_without_particles_that_stick(self):
        for formulation in FORMULATIONS:
            with self.subTest(formulation=formulation):
                scene = cracked([0.5, 0.5, 0.51, 0.5], formulation).set("Contact", {"Law": "Stick"})
                self.reports(scene, "extends over", "separates nothing")

    def test_crack_beyond_the_last_particles(self):
        whole = cracked([0.0, 0.002, 0.5, 0.002]).set("Cracks > Front Springs", False)  # else it divides particles
        self.reports(whole, "a surface of the body is 2 mm away", "separates nothing")

    def test_crack_through_the_last_particles(self):
        scene = cracked([0.0, 0.002, 0.5, 0.002])
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        self.assertIn("is cut in 2 pieces", answer.messages)
        self.assertIn("its faces overlap", answer.messages)

    def test_crack_that_leaves_a_bridge_thinner_than_a_cell(self):
        self.reports(cracked([0.03, 0.5, 0.97, 0.5]), "0.03, 0.5", "0.97, 0.5")

    def test_crack_along_the_diagonal_of_the_cells(self):
        """Pulled across: a burst of energy would stop the run, and a gain of a tenth would be reported."""
        for formulation in FORMULATIONS:
            with self.subTest(formulation=formulation):
                scene = cracked([-0.1, -0.1, 0.5, 0.5], formulation).set("Time > Final Time", 6e-3)
                scene.set("Boundaries > Pull > Stress", [1e5, -1e5])
                self.reports(scene)

    def test_contour_through_the_cells_of_the_front(self):
        scene = plate().set("Energy Release", {"Inner Radius": 0.06, "Outer Radius": 0.2})
        self.reports(scene, "Inner Radius is 1.2 cells: below two cells", where="Energy Release")

    def wedged(self, behind, kind="Point Load"):
        """The plate with its notch opened by two forces this far behind the front. J is of the ring from 0.15 to 0.3 m."""
        scene = plate().remove("Boundaries > Pull").set("Domain > Thickness", 1.0)
        for name, sign in (("Up", 1.0), ("Down", -1.0)):
            point = [0.5 - behind, 0.5 + sign * 0.02]
            where = {"Point": point} if kind == "Point Load" else {"From": [0.0, point[1]], "To": point}
            scene.set("Boundaries > " + name, {"Type": kind, "Body": "Plate", "Force": [0.0, sign * 1e3]} | where)
        return scene

    def test_forces_in_the_ring_of_the_contour(self):
        where = "Energy Release: Boundaries > "
        self.reports(self.wedged(0.2), "acts in the domain integral from 150 mm to 300 mm around crack Notch, front 0",
                     "acts in the domain integral", where="Energy Release: ")
        self.reports(self.wedged(0.05), where=where)  # within the ring: their work is in the integral
        self.reports(self.wedged(0.4), where=where)
        self.reports(self.wedged(0.0, "Line Load"), "acts in the domain integral", "acts in the domain integral", where=where)
        self.reports(self.wedged(0.4, "Line Load"), where=where)
        never = self.wedged(0.2)
        for name in ("Up", "Down"):
            never.set("Boundaries > " + name + " > History", "0")
        self.reports(never, "does next to nothing", "does next to nothing", where="Boundaries > ")

    def test_supports_in_the_ring_of_the_contour(self):
        """The notch ends in the middle of the plate; J is of the ring from 0.15 to 0.3 m."""
        for lower, upper, words in (
            ([0.69, 0.69], [0.71, 0.71],
             ["Boundaries > Pin prescribes nodes in the domain integral from 150 mm to 300 mm around crack Notch, front 0"]),
            ([0.49, 0.59], [0.51, 0.61], []),  # within the ring
            ([0.79, 0.79], [0.81, 0.81], []),
        ):
            pin = {"Type": "Velocity", "Lower Corner": lower, "Upper Corner": upper, "Value": [0.0, 0.0]}
            self.reports(plate().set("Boundaries > Pin", pin), *words, where="Energy Release: ")
        frame = {"Type": "Velocity", "Nodes": "Outside", "Lower Corner": [-0.2, 0.25], "Upper Corner": [0.85, 0.85],
                 "Value": [0.0, 0.0]}
        self.reports(plate().set("Boundaries > Frame", frame), "Energy Release: Boundaries > Frame prescribes nodes",
                     "Boundaries > Pull: it acts where Boundaries > Frame prescribes", where="")

    def test_run_that_ends_before_it_rests(self):
        scene = plate().set("Damping", {"Mass Rate": 1.0, "Stop When Settled": True})
        # That it will is said before the run, that it did after it.
        self.reports(scene, "Damping > Mass Rate", "the run ended before it had settled", where="")

    def test_faces_that_pass_through_each_other(self):
        self.reports(pressed(-1e5), "overlap", where="crack Notch")

    def test_faces_that_do_not(self):
        self.reports(pressed(1e5))
        self.reports(pressed(-1e5).set("Contact", {"Law": "Stick"}))

    def test_crack_whose_faces_are_both_held(self):
        self.reports(supported([0.25, 0.02, 0.75, 0.02]), "along a support")
        box = {"Type": "Velocity", "Lower Corner": [-0.1, -0.1], "Upper Corner": [1.1, 0.0], "Value": [0.0, 0.0]}
        self.reports(cracked([0.25, 0.02, 0.75, 0.02]).set("Boundaries > Clamp", box), "along a support")

    def test_cracks_next_to_supports_that_hold_one_face_or_rightly_both(self):
        self.reports(supported([0.25, 0.07, 0.75, 0.07]))
        self.reports(supported([0.51, 0.0, 0.51, 0.5]))

    def test_mirror_between_planes_of_nodes(self):
        self.reports(supported([0.25, 0.5, 0.75, 0.5], 0.02), "0.4 cells", "2.5 %", where="Boundaries > Wall > Position")

    def test_cracks_that_the_cells_see(self):
        for points in ([0.0, 0.5, 0.5, 0.5], [0.3, 0.31, 0.6, 0.72]):
            with self.subTest(points=points):
                self.reports(cracked(points))

    def test_cracks_that_cut_the_plate(self):
        for points in ([0.0, 0.5, 1.0, 0.5], [-3.0, 0.47, 7.0, 0.49]):
            with self.subTest(points=points):
                self.reports(cracked(points), "is cut in 2 pieces")


if __name__ == "__main__":
    unittest.main()
