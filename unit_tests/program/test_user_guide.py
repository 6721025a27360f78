#!/usr/bin/env python3
"""The scene that a tutorial has its reader write, and what it says of it."""

import json
import os
import re
import shlex
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import SOURCE, ProgramTest, rhegma  # noqa: E402

GUIDE = os.path.join(SOURCE, "docs", "tutorials", "your-own-crack.md")


class OwnCrack(ProgramTest):
    def setUp(self):
        super().setUp()
        with open(GUIDE, encoding="utf-8") as file:
            self.text = file.read()
        lines = self.text.splitlines()
        first = lines.index('    <ParameterList name="Rhegma">')
        last = lines.index("    </ParameterList>", first)
        self.scene = self.write("my_crack.xml", "\n".join(line[4:] for line in lines[first : last + 1]))

    def stated(self, pattern):
        """The number that the guide has at the group of a pattern."""
        return float(re.search(pattern, self.text).group(1))

    def test_runs_as_the_guide_says(self):
        check = rhegma(self.scene, "--check")
        self.assertEqual(check.status, 0, check)
        self.assertNotIn("set out", check.messages)  # nothing has run yet
        answer = rhegma(self.scene, "--quiet")
        self.assertEqual(answer.status, 0, answer)
        self.assertIn("reached the surface", answer.messages)
        with open(self.path("my_crack.out", "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        front = summary["cracks"][0]["fronts"][0]
        self.assertTrue(front["ended"])
        self.assertEqual(summary["propagation"]["initiation_toughness"], 403.0)
        self.assertEqual(front["increments"], self.stated(r"ran (\d+) cells"))
        # Of the last digits that the guide has.
        self.assertAlmostEqual(1e6 * front["initiated"], self.stated(r"`initiated` after (\d+) us"), delta=0.5)
        self.assertAlmostEqual(front["settled_speed"], self.stated(r"cells at (\d+) m/s"), delta=5.0)
        self.assertAlmostEqual(summary["energy"]["fracture"], self.stated(r"`energy > fracture`,\s+([0-9.]+) J"), delta=5e-4)

    def test_stays_under_a_smaller_load(self):
        command = re.search(r"^ +rhegma (my_crack.xml --output calm.out .*)$", self.text, re.M).group(1)
        answer = rhegma(*shlex.split(command), "--quiet", cwd=self.folder)
        self.assertEqual(answer.status, 0, answer)
        self.assertIn(re.search(r"`(crack Notch, front 0: not initiated; [^`]*)`", self.text).group(1), answer.messages)


if __name__ == "__main__":
    unittest.main()
