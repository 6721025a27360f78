#!/usr/bin/env python3
"""Domain > Formulation = Total Lagrangian on ranks, after restarts, and next to cells in the deformed body under small loads.

Its stencils and the lists of its substeps are made once and kept: a run that continues makes them anew, and ranks make their own."""

import os
import signal
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import numpy  # noqa: E402
from program import PATIENCE  # noqa: E402
from ranks import WITH_SPRINGS, OnRanks  # noqa: E402
from restart_case import RestartTest  # noqa: E402
from scenes import plate  # noqa: E402
from test_ranks_of_effects import block, turned_plate  # noqa: E402


def total(scene):
    return scene.set("Domain > Formulation", "Total Lagrangian")


def refined(scene, levels=2):
    return scene.set("Adaptivity", {"Maximum Level": levels}).set("Sub-Cycling", {"Levels": levels})


def growing():
    """The notch runs while cells around its front follow it."""
    scene = refined(total(plate()), 1).set("Boundaries > Pull > Stress", [6e5, 0.0])
    scene.set("Cracks > Notch > Points", [0.5, 0.0, 0.5, 0.43])
    scene.set("Propagation", {"Toughness": 50.0, "Speed Limit": 600.0})
    scene.set("Adaptivity > Front Cells", 4)
    return scene.set("Time > Final Time", 1e-3)


class TotalLagrangianOnRanks(OnRanks):
    def test_a_notch(self):
        self.agree(self.write(total(plate()).set("Energy Release > Crack Closure", True)), ranks=(3,))

    def test_a_plate_that_flies_and_turns(self):
        fields = self.agree(self.write(total(turned_plate())), ranks=(4,))
        self.assertGreater(numpy.min(fields["displacement"][:, 0]), 0.2, "the plate has not flown")

    def test_cells_of_three_sizes_with_substeps(self):
        self.agree(self.write(refined(total(plate()))), ranks=(3,), within=WITH_SPRINGS)

    def test_ranks_that_change(self):
        scene = total(turned_plate()).set("Load Balance", {"Threshold": 1.01, "Interval": 5})
        self.agree(self.write(scene), ranks=(4,))

    def test_three_dimensions(self):
        self.agree(self.write(total(block())), ranks=(2,))


class TotalLagrangianGoesOn(RestartTest):
    def test_a_crack_that_runs_through_cells_that_follow_it(self):
        scene = growing().set("Output", {"History Interval": 2e-5, "Field Interval": 2e-4, "Checkpoint Interval": 1e-4})
        path = self.write("scene.xml", scene.text())
        whole, broken = self.path("whole"), self.path("broken")
        self.run_to_its_end(path, whole)
        front = self.summary(whole)["cracks"][0]["fronts"][0]
        self.assertGreater(front["length"], 0.44, "the crack has not run")
        run = self.start(path, "--output", broken, "--quiet")
        self.wait_for(run, os.path.join(broken, "checkpoint.h5"))
        run.send_signal(signal.SIGTERM)
        run.wait(PATIENCE)
        self.assertEqual(run.returncode, 2)
        self.run_to_its_end(path, broken, "--restart", os.path.join(broken, "checkpoint.h5"))
        self.assert_same_run(broken, whole)


class NextToDeformedCells(OnRanks):
    """Under 1 kPa the strain is 1e-6 and cells are where the body is. What differs is where particles next to the crack lie in them: evenly in the
    cells where they stay, which changes the energy of a wave of a few cells by 1e-3 of the largest, and more of it at the front."""

    def compare_formulations(self, scene, *columns):
        ends = []
        for formulation in ("Updated Lagrangian", "Total Lagrangian"):
            path = self.write(scene.set("Domain > Formulation", formulation))
            ends.append(self.run_on(1, path, into=formulation.split()[0], with_fields=False)[1])
        for column in columns:
            largest = numpy.max(numpy.abs(ends[0][column]))
            self.assertGreater(largest, 0.0, column)
            numpy.testing.assert_allclose(ends[1][column] / largest, ends[0][column] / largest, atol=3e-3, err_msg=column)

    def test_a_notch(self):
        self.compare_formulations(plate().set("Boundaries > Pull > Stress", [300.0, 1e3]), "strain", "kinetic", "Notch.0.G_J")

    def test_a_notch_in_cells_of_three_sizes_with_substeps(self):
        scene = refined(plate()).set("Boundaries > Pull > Stress", [300.0, 1e3])
        self.compare_formulations(scene, "strain", "kinetic")

    def test_a_notch_in_three_dimensions(self):
        scene = block().set("Bodies > Plate > Angular Velocity", [0.0, 0.0, 0.01]).set("Energy Release", {})
        scene.set("Domain > Cell Size", 0.05)
        self.compare_formulations(scene, "strain", "kinetic")


if __name__ == "__main__":
    unittest.main()
