#!/usr/bin/env python3
"""Verified scenes, and those of cracks with gas, give the same energy release rates on several ranks as on one."""

import os
import sys
import unittest
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import SOURCE, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT, OnRanks  # noqa: E402

FOLDER = os.path.join(SOURCE, "xml_inputs", "verification")

# With gas between the faces.
BURNING = ("burning_crack.xml", "closed_bomb.xml", "gas_driven.xml", "pressurised_crack.xml")

# The number that is asked for.
SAME = 1e-9

# Steps that are taken of each: enough for a wave to run through the cells around a front.
STEPS = 60


def is_compared(column):
    """What drives cracks, and the energies of the motion: other columns may be sums that cancel, or noise as yet."""
    return ("G_" in column or ".K_" in column or column in ("kinetic", "strain", "combustion")
            or column.endswith((".pressure", ".burnt_mass", ".gas_temperature")))


# Where the grips are far from the front: before anything reaches it, G is that of noise.
LONGER = {"dcb_arrest.xml": 1000, "dcb_arrest_short_steps.xml": 2000, "running_start.xml": 300, "running_start_fast.xml": 300, "dcb_adaptive_partial.xml": 200,
          "dcb_turned.xml": 300, "gas_driven.xml": 200, "gas_driven_flow.xml": 200}

# Of the usual size these two take as long as all others together.
LARGER_CELLS = {"running_start.xml": 5e-4, "running_start_fast.xml": 5e-4}

# Of an equilibrium.
LOAD_STEPS = 3

# Sections whose scenes run on one rank only.
ALONE = ("Body Contact", "Rigid Tools")


class Verified(OnRanks):
    def scenes(self):
        for name in sorted(os.listdir(FOLDER)):
            if name.endswith(".xml"):
                yield os.path.join(FOLDER, name)
        for name in BURNING:
            yield os.path.join(SOURCE, "xml_inputs", "examples", name)

    def test_the_same_on_two_three_and_four_ranks(self):
        tried = 0
        for path in self.scenes():
            name = os.path.basename(path)
            with self.subTest(name):
                top = ElementTree.parse(path)
                alone = next((section for section in ALONE if top.find(f"ParameterList[@name='{section}']") is not None), None)
                if alone is not None:
                    answer = rhegma(path, "--output", os.path.join(self.folder, name), launcher=(*LAUNCHER, "-np", "2"), **ROOT)
                    self.assertEqual(answer.status, 1, answer)
                    self.assertIn(f"{alone}: such scenes run on one rank only", answer.messages)
                    continue
                static = name.endswith(("_static.xml", "_steady.xml"))
                steps = LOAD_STEPS if static else LONGER.get(name, STEPS)
                settings = ["--set", f"Time:Maximum Steps={steps}"]
                if name in LARGER_CELLS:
                    settings += ["--set", f"Domain:Cell Size={LARGER_CELLS[name]}"]
                ranks = (3,) if static else (2, 3, 4)  # test_equilibrium_on_ranks has the others
                self.agree(path, *settings, ranks=ranks, within=SAME, closure=1.0, columns=is_compared)
                tried += 1
        self.assertGreater(tried, 40)


if __name__ == "__main__":
    unittest.main()
