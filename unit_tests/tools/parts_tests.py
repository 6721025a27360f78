"""Tests of the parts of docs/tutorials/three-parts.md: their surfaces are closed and have the volume of the parts, and the program reads their scenes."""

import collections
import os
import subprocess
import sys
import unittest

from tool import TOOLS, ToolTest  # first, as it finds the Python for all others

import numpy as np

SCRIPT = os.path.join(TOOLS, "..", "xml_inputs", "studies", "three_parts.py")
PROGRAM = os.environ.get("RHEGMA_PROGRAM")


def read_stl(path):
    with open(path, encoding="utf-8") as file:
        return np.array([[float(x) for x in line.split()[1:]] for line in file if line.startswith("vertex")]).reshape(-1, 3, 3)


class Parts(ToolTest):
    def write_parts(self):
        result = subprocess.run([sys.executable, SCRIPT, self.folder], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(result.stdout.count("Wrote"), 3)

    def test_without_numpy_one_line_says_what_is_missing(self):
        """A NumPy that can't be imported, for this Python and for the system's."""
        os.makedirs(self.path("numpy"))
        self.write(os.path.join("numpy", "__init__.py"), "raise ImportError")
        result = subprocess.run([sys.executable, SCRIPT, self.path("parts")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                                env=dict(os.environ, PYTHONPATH=self.folder, PYTHONDONTWRITEBYTECODE="1"))
        self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (1, "", 1), result.stderr)
        self.assertRegex(result.stderr, "^three_parts.py: needs the Python packages numpy, matplotlib, and .*; install them, .* apt-get install python3-numpy")

    def test_surfaces_are_closed_and_have_the_volume(self):
        self.write_parts()

        def polygon(count, radius):  # area of a regular one with its corners on a circle
            return 0.5 * count * radius**2 * np.sin(2 * np.pi / count)

        exact = {"bracket": 30 * (60 * 10 + 50 * 10) - 2 * polygon(32, 3.3) * 10, "ring": (polygon(120, 22) - polygon(120, 14)) * 8}
        for name in ("axle", "bracket", "ring"):
            triangles = read_stl(self.path(f"{name}.stl"))
            edges = collections.Counter()
            for corners in triangles.tolist():
                for one, other in zip(corners, corners[1:] + corners[:1]):
                    edges[tuple(one), tuple(other)] += 1
            self.assertTrue(all(edges[other, one] == count == 1 for (one, other), count in edges.items()), name)
            volume = np.einsum("ij,ij->", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])) / 6
            if name in exact:  # six decimals of coordinates of some 50 mm
                self.assertAlmostEqual(volume / exact[name], 1.0, places=5)

    @unittest.skipUnless(PROGRAM, "RHEGMA_PROGRAM names no program")
    def test_the_program_reads_their_scenes(self):
        """With coarse cells; the water is on the outer wall of the ring alone, of 2 pi 22 mm 8 mm."""
        self.write_parts()
        for name, words in (("axle", "kN along"), ("bracket", "Load: 2 kN along"), ("ring", "Water: on 11.06 cm2")):
            result = subprocess.run([PROGRAM, self.path(f"{name}.xml"), "--check", "--output", self.path("out"), "--set", "Adaptivity:Maximum Level=1",
                                     "--set", "Domain:Cell Size=3 mm"],
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
            self.assertEqual(result.returncode, 0, result.stdout)
            self.assertIn(f"{name}.xml is a valid scene", result.stdout)
            self.assertIn(words, result.stdout)


del ToolTest  # so that importing this module's names brings tests only
if __name__ == "__main__":
    unittest.main()
