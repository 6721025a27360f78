#!/usr/bin/env python3
"""The watch in the step: a failure is found, an earlier state is restored, and smaller steps help or not."""

import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from hard_case import HardCase, rhegma  # noqa: E402
from scenes import too_long_a_step  # noqa: E402
from test_bodies import flying  # noqa: E402


class Watch(HardCase):
    def test_shorter_steps_help(self):
        outcome = self.survives(too_long_a_step(), energy=0.2, gain=0.05)
        said = [warning for warning in outcome.summary["warnings"] if "the run returned to t =" in warning]
        self.assertGreaterEqual(len(said), 1, outcome.summary["warnings"])
        times = outcome.history["time"]
        self.assertTrue((times[1:] > times[:-1]).all())
        self.assertEqual(outcome.summary["status"], "finished")

    def test_without_retries_the_run_stops(self):
        path = self.write("scene.xml", too_long_a_step().set("Time > Retries", 0).text())
        answer = rhegma(path, "--quiet")
        self.assertEqual(answer.status, 2, answer)
        self.assertNotIn("returned to", answer.messages)

    def test_body_that_leaves_the_domain_stops_after_two_attempts(self):
        scene = flying([0.0, 0.0], [0.4, 0.4], velocity=(1.0, 0.0), time=2.0).set("Domain > Upper Corner", [1.0, 2.0])
        path = self.write("scene.xml", scene.text())
        answer = rhegma(path, "--quiet")
        self.assertEqual(answer.status, 2, answer)
        self.assertIn("did not help", answer.messages)


if __name__ == "__main__":
    unittest.main()
