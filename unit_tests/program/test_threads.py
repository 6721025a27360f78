#!/usr/bin/env python3
"""The motion is the same to the last digit whatever the number of threads, loads and crack faces included."""

import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from program import SOURCE, rhegma  # noqa: E402

STEPS = 60


def last_particles(scene, threads):
    """All fields of the particles after a few steps, in their order in memory."""
    with tempfile.TemporaryDirectory() as folder:
        answer = rhegma(
            os.path.join(SOURCE, "xml_inputs", scene),
            *("--output", folder, "--quiet", f"--kokkos-num-threads={threads}"),
            *("--set", f"Time:Maximum Steps={STEPS}", "--set", "Output:Fields=true"),
        )
        # 60 steps are too few for the reference of the scene (exit status 4).
        if answer.status not in (0, 4):
            raise AssertionError(str(answer))
        with h5py.File(os.path.join(folder, "fields.h5"), "r") as file:
            last = file[sorted(file)[-1]]["particles"]
            return {name: last[name][()] for name in last}


class Threads(unittest.TestCase):
    def agree(self, scene):
        one, two = last_particles(scene, 1), last_particles(scene, 2)
        self.assertEqual(sorted(one), sorted(two))
        self.assertTrue(numpy.any(one["velocity"] != 0.0), "nothing moved")
        for name in one:
            self.assertTrue(numpy.array_equal(one[name], two[name]), f"{name} in {scene}")

    def test_load(self):
        self.agree("verification/dcb_h4.xml")

    def test_pressure_on_faces(self):
        self.agree("verification/sudden_pressure.xml")

    def test_contact_of_faces(self):
        self.agree("verification/contact_coulomb.xml")


if __name__ == "__main__":
    unittest.main()
