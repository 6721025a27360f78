#!/usr/bin/env python3
"""Verified scenes give the same energy release rates on several ranks as on one."""

import os
import sys
import unittest
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import SOURCE, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT, OnRanks  # noqa: E402

FOLDER = os.path.join(SOURCE, "xml_inputs", "verification")

# The number that is asked for.
SAME = 1e-9

# Steps that are taken of each: enough for a wave to run through the cells around a front.
STEPS = 60


def is_compared(column):
    """What drives cracks, and the energies of the motion: other columns may be sums that cancel, or noise as yet."""
    return "G_" in column or ".K_" in column or column in ("kinetic", "strain")


# Where the grips are far from the front: before anything reaches it, G is that of noise.
LONGER = {"dcb_arrest.xml": 1000, "running_start.xml": 600}

# Sections that together work on one rank only.
ON_ONE_RANK = ({"Combustion"}, {"Sub-Cycling", "Mass Matrix"})


def that_work_alone(path):
    sections = {child.get("name") for child in ElementTree.parse(path).getroot()}
    return set().union(*(together for together in ON_ONE_RANK if together <= sections))


class Verified(OnRanks):
    def scenes(self):
        """Path of each scene, and which of its sections keep it on one rank."""
        for name in sorted(os.listdir(FOLDER)):
            if name.endswith(".xml"):
                path = os.path.join(FOLDER, name)
                yield path, that_work_alone(path)

    def test_the_same_on_two_three_and_four_ranks(self):
        tried = 0
        for path, alone in self.scenes():
            if alone:
                continue
            with self.subTest(os.path.basename(path)):
                steps = LONGER.get(os.path.basename(path), STEPS)
                self.agree(path, "--set", f"Time:Maximum Steps={steps}", within=SAME, closure=1.0,
                           columns=is_compared)
                tried += 1
        self.assertGreater(tried, 15)

    def test_what_does_not_work_yet_is_refused_by_name(self):
        burning = os.path.join(SOURCE, "xml_inputs", "examples", "burning_crack.xml")
        refused = [scene for scene in [*self.scenes(), (burning, that_work_alone(burning))] if scene[1]]
        self.assertEqual(len({frozenset(alone) for _, alone in refused}), len(ON_ONE_RANK))
        for path, alone in refused:
            with self.subTest(os.path.basename(path)):
                answer = rhegma(path, "--check", launcher=(*LAUNCHER, "-np", "2"), **ROOT)
                self.assertEqual(answer.status, 1, answer)
                for name in alone:
                    self.assertIn(name, answer.complaint)


if __name__ == "__main__":
    unittest.main()
