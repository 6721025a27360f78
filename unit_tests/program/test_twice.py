#!/usr/bin/env python3
"""rhegma --twice on scenes whose convergence is known."""

import json
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import SOURCE, ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

EXAMPLES = os.path.join(SOURCE, "xml_inputs", "examples")


class Twice(ProgramTest):
    def twice(self, scene, *more):
        answer = rhegma(scene, "--twice", "--output", self.path("out"), *more, timeout=600)
        self.assertIn(answer.status, (0, 4), answer)
        with open(self.path("out", "twice.json"), encoding="utf-8") as file:
            comparison = json.load(file)
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["as_is", "half", "twice.json"])
        return answer, comparison, {one["name"]: one for one in comparison["answers"]}

    def summary(self, folder):
        with open(self.path("out", folder, "summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def test_a_beam_converges_to_the_finite_elements(self):
        """Quadratic finite elements give 0.12873 J/m2. The change bounds the error of the finer cells and of the extrapolation,
        which takes an error of the first order; with front springs along the cells it falls faster."""
        answer, comparison, answers = self.twice(os.path.join(EXAMPLES, "dcb.xml"))
        release = answers["G_J of Notch.0"]
        errors = [abs(release[name] / 0.12873 - 1.0) for name in ("as_is", "half", "extrapolated")]
        self.assertLess(errors[1], errors[0], release)
        self.assertLess(max(errors[1:]), release["change"], release)
        self.assertEqual(release["order"], 1)
        self.assertTrue(comparison["resolved"], comparison)
        self.assertIn("Verdict: resolved", answer.output)
        for folder, cell in (("as_is", comparison["cell"]), ("half", 0.5 * comparison["cell"])):
            self.assertAlmostEqual(self.summary(folder)["cells"]["smallest"] / cell, 1.0, places=9)
        self.assertEqual(self.summary("as_is")["cracks"][0]["fronts"][0]["G_J"], release["as_is"])

    def test_cells_that_are_too_large_are_not_resolved(self):
        """A crack in a strip on half as many cells as resolve it: it runs by another path or to another place."""
        answer, comparison, answers = self.twice(
            os.path.join(EXAMPLES, "kalthoff.xml"), "--set", "Domain:Cell Size=4e-3", "--set", "Output:Fields=false")
        self.assertFalse(comparison["resolved"], comparison)
        self.assertIn("path of Notch.0", answers)
        self.assertRegex(answer.output, r"Verdict: .*: not resolved\. not resolved; use smaller cells")

    def test_levels_are_halved_with_the_coarse_cells(self):
        self.twice(os.path.join(EXAMPLES, "pressurised_crack.xml"), "--set", "Time:Maximum Steps=3",
                   "--set", "Output:Fields=false")
        cells = [self.summary(folder)["cells"] for folder in ("as_is", "half")]
        for size in ("largest", "smallest"):
            self.assertAlmostEqual(cells[0][size] / cells[1][size], 2.0, places=9)
        self.assertEqual([self.summary(folder)["steps"] for folder in ("as_is", "half")], [3, 6])

    def test_a_penny_in_3d(self):
        """Before its front may grow: J of a penny on few cells falls towards that of finer ones."""
        _, comparison, answers = self.twice(
            os.path.join(EXAMPLES, "penny_growth.xml"), "--set", "Domain:Cell Size=2e-3", "--set", "Time:Final Time=4e-5",
            "--set", "Output:Fields=false")
        for name in ("G_J of Penny.0", "K_I of Penny.0"):
            answer = answers[name]
            self.assertGreater(answer["half"], 0.0, answer)
            self.assertGreater(answer["as_is"], answer["half"], answer)
            self.assertAlmostEqual(answer["extrapolated"], 2.0 * answer["half"] - answer["as_is"], delta=1e-9 * answer["half"])
        cells = [self.summary(folder)["cells"]["smallest"] for folder in ("as_is", "half")]
        self.assertAlmostEqual(cells[0] / cells[1], 2.0, places=9)
        self.assertFalse(comparison["resolved"], comparison)

    def test_a_scene_with_nothing_to_compare(self):
        answer, comparison, _ = self.twice(self.write("scene.xml", plate().remove("Cracks").remove("Energy Release").text()))
        self.assertEqual(comparison["answers"], [])
        self.assertIn("nothing to compare", answer.output)

    def test_it_goes_with_no_restart(self):
        scene = self.write("scene.xml", plate().text())
        self.assert_refused([scene, "--twice", "--check"], [("", ["--twice", "--check"])])


if __name__ == "__main__":
    unittest.main()
