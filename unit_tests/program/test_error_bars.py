#!/usr/bin/env python3
"""Error estimates of summary.json against true errors: a few random cracks with a closed form and beams with finite elements as the
reference; studies/error_bars.py has a hundred. And where there is no estimate. RHEGMA_SEED in the environment is the seed."""

import json
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "studies"))
sys.dont_write_bytecode = True

import error_bars  # noqa: E402
from program import PROGRAM, SOURCE, ProgramTest, environment, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "11"))
VERIFICATION = os.path.join(SOURCE, "xml_inputs", "verification")


class ErrorBars(ProgramTest):
    def summary(self, scene, *more):
        answer = rhegma(scene, "--output", self.path("out"), *more)
        self.assertIn(answer.status, (0, 4), answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return answer, json.load(file)

    def test_random_cracks(self):
        """The estimate is made for 90 % of all fronts. Of 20 fronts fewer than 15 are within it by chance once in 100 times (binomial
        distribution), more often as the two fronts of a crack resemble each other. The median of estimate over error is to be 4 at most; studies
        /error_bars.py finds 3.1 for all families and 4.7 for these cracks. Ten cracks say little of a median: with normal errors and a true
        median of 4, theirs is above 12 once in 50 times (five of ten above it; binomial distribution)."""
        os.environ.update(environment())
        found = error_bars.study(PROGRAM, SEED, range(10), ["inclined"])
        within, ratio, error = error_bars.coverage(found, "G")
        print("seed %d: %d fronts, %.0f %% within, median of estimate / error %.1f, median error %.2f %%"
              % (SEED, len(found), 100 * within, ratio, 100 * error))
        self.assertGreaterEqual(len(found), 16)
        self.assertGreaterEqual(within, 0.75)
        self.assertLess(ratio, 3.0 * 4.0)

    def test_beams(self):
        """Quadratic finite elements, 0.1 %: cracks of 30, 50 and 60 mm on 4 and 8 cells an arm."""
        for length, exact in ((0.03, 0.05396), (0.05, 0.12873), (0.06, 0.17811)):
            for cell in ("2.5e-3", "1.25e-3"):
                with self.subTest(f"{1000 * length:g} mm, cells of {cell}"):
                    _, summary = self.summary(os.path.join(VERIFICATION, "dcb_static.xml"), "--quiet", "--set", "Domain:Cell Size=" + cell,
                                              "--set", f"Cracks:Notch:Points={{0, 0.01, {length}, 0.01}}")
                    front = summary["cracks"][0]["fronts"][0]
                    error, estimate = abs(front["G_J"] - exact), front["G_J_error_estimate"]
                    print(f"{1000 * length:g} mm, {cell}: {100 * error / exact:.2f} %, estimate {100 * estimate / exact:.2f} %")
                    self.assertLess(error, estimate + 1e-3 * exact)
                    self.assertLess(estimate, 0.1 * exact)
                    self.assertIn("G_closure_error_estimate", front)

    def test_a_run_in_motion_has_none(self):
        """The plate is not at rest, so waves pass its crack."""
        scene = self.write("scene.xml", plate().text())
        answer, summary = self.summary(scene)
        front = summary["cracks"][0]["fronts"][0]
        self.assertIsNone(front["G_J_error_estimate"])
        self.assertIn("at rest", front["no_error_estimate"])
        self.assertRegex(answer.output, r"no error estimate \(.*at rest.*compare with --twice\) for crack Notch, front 0")

    def test_a_penny_in_3d(self):
        _, summary = self.summary(os.path.join(VERIFICATION, "penny_tension_static.xml"), "--quiet")
        front = summary["cracks"][0]["fronts"][0]
        exact = 87403.9
        self.assertLess(abs(front["K_I"] - exact), front["K_I_error_estimate"])
        for name in ("K_I_min", "K_I_max"):
            self.assertLess(abs(front[name] - exact), front["K_extremes_error_estimate"], name)
        self.assertLess(front["K_extremes_error_estimate"], 0.1 * exact)


if __name__ == "__main__":
    unittest.main()
