#!/usr/bin/env python3
"""A drawing becomes the body of a scene: rhegma-mesh writes its polygons, and the program fills them with particles."""

import math
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import PROGRAM, SOURCE, ProgramTest  # noqa: E402

TOOLS = os.path.join(SOURCE, "tools")
sys.path.insert(0, TOOLS)
from rhegma_tools import interpreter  # noqa: E402

interpreter.need("numpy", "h5py")

import rhegma  # noqa: E402

# A plate of 60 x 30 mm with corners of 5 mm, and a hole of radius 5 mm in it, on a page in mm.
DRAWING = """<svg xmlns="http://www.w3.org/2000/svg" width="80mm" height="50mm" viewBox="0 0 80 50">
  <g fill="none" stroke="black"><rect x="10" y="10" width="60" height="30" rx="5"/><circle cx="40" cy="25" r="5"/></g>
</svg>
"""
AREA = 1e-6 * (60.0 * 30.0 - (4.0 - math.pi) * 25.0 - 25.0 * math.pi)  # [m2]


class Drawings(ProgramTest):
    def test_a_plate_with_a_hole(self):
        drawing, part = self.write("plate.svg", DRAWING), self.path("plate.txt")
        subprocess.run([sys.executable, os.path.join(TOOLS, "rhegma-mesh"), drawing, "-o", part, "--tolerance", "0.01 mm"], check=True,
                       stdout=subprocess.DEVNULL)
        scene = rhegma.Scene({
            "Domain": {"Dimension": 2, "Thickness": 2e-3, "Cell Size": 1e-3, "Lower Corner": [0, 0], "Upper Corner": [0.08, 0.05]},
            "Time": {"Final Time": 1e-3, "Maximum Steps": 1},
            "Materials": {"Polymer": {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": 3e9, "Poisson Ratio": 0.33}},
            "Bodies": {"Plate": {"Material": "Polymer", "Shape": "File", "File": "plate.txt"}},
            "Output": {"Fields": True},
        }, self.folder)
        self.assertFalse([text for text in rhegma.check(scene, program=PROGRAM) if "plate.txt" in text])  # nothing had to be mended
        run = rhegma.run(scene, output=self.path("out"), program=PROGRAM)
        # Particles represent the polygons within 0.1 % (docs/how-to/part-from-a-file.md), which have the area within the tolerance times the length of
        # the outline: 0.01 mm x 203 mm.
        mass = 1200.0 * 2e-3 * AREA
        self.assertAlmostEqual(run.value("bodies.Plate.mass") / mass, 1.0, delta=0.001 + 0.01e-3 * 0.203 / AREA)
        # The page's y points downwards, but the part is symmetric: its middle is that of the page.
        self.assertAlmostEqual(run.summary["bodies"][0]["centre"][0], 0.040, delta=1e-5)
        self.assertAlmostEqual(run.summary["bodies"][0]["centre"][1], 0.025, delta=1e-5)
        # No particle is in the hole: all centres are outside of it by less than half a particle at most.
        x, y, _ = run.fields().position.T
        self.assertGreater(((x - 0.04) ** 2 + (y - 0.025) ** 2).min() ** 0.5, 5e-3 - 0.5e-3)


if __name__ == "__main__":
    unittest.main()
