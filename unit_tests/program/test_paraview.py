#!/usr/bin/env python3
"""The state that rhegma-plot --paraview writes: values of fronts, and what ParaView shows with it."""

import os
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import PATIENCE, PROGRAM, SOURCE, ProgramTest  # noqa: E402
from test_bodies_from_files import box, cracked_block  # noqa: E402

TOOLS = os.path.join(SOURCE, "tools")
sys.path.insert(0, TOOLS)
from rhegma_tools import interpreter  # noqa: E402

interpreter.need("numpy", "h5py", "PIL")

import numpy  # noqa: E402
from PIL import Image  # noqa: E402

import rhegma  # noqa: E402
from rhegma_tools.vtk_window import Display  # noqa: E402

HIGHEST = (240, 249, 33)  # colours at the ends of the scale of fronts, which its bar has
LOWEST = (13, 8, 135)
STRESSED, CALM = (180, 4, 38), (59, 76, 192)  # and of the one of stress
NEAR = 12  # of 255, in each colour; the bar is smoothed at its ends


class States(ProgramTest):
    def block(self, name="block"):
        """A block of 12 x 6 x 10 mm with an edge crack, pulled along z."""
        with open(self.path("block.xml"), "w", encoding="utf-8") as file:
            file.write(cracked_block(box()).set("Output", {"Fields": True}).text())
        return rhegma.run(rhegma.Scene.load(self.path("block.xml")), output=self.path(name), program=PROGRAM)

    def strip(self, name="strip"):
        """The strip of the tutorial, with fields at several times."""
        scene = rhegma.Scene.load(os.path.join(SOURCE, "xml_inputs", "examples", "edge_crack.xml"))
        scene.set("Output > Field Interval", 1e-4)
        return rhegma.run(scene, output=self.path(name), program=PROGRAM)

    def plot(self, name, *more, status=0):
        result = subprocess.run([sys.executable, os.path.join(TOOLS, "rhegma-plot"), name, "--paraview", *more], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True, timeout=PATIENCE)
        self.assertEqual(result.returncode, status, result.stdout)
        return result.stdout

    def numbers(self, name, quantity):
        """Values of fronts of each frame in fronts.xdmf."""
        with open(self.path(name, "fronts.xdmf"), encoding="utf-8") as file:
            text = file.read()
        items = re.findall(rf'<Attribute Name="{quantity}"[^>]*><DataItem[^>]*>([^<]*)<', text)
        return [numpy.array(item.split(), dtype=float) for item in items]

    def picture(self, name):
        """What ParaView draws (rows, columns, 3)."""
        if shutil.which("pvpython") is None:
            self.skipTest("pvpython (paraview) is not installed")
        if shutil.which("Xvfb") is None:
            self.skipTest("Xvfb (xvfb), the display on which pvpython draws, is not installed")
        moved = self.path("moved " + name)
        shutil.copytree(self.path(name), moved)
        os.rename(self.path(name), self.path(name + ".old"))  # the state finds the files next to it
        with Display() as environment:
            result = subprocess.run(["pvpython", "paraview_state.py", "picture.png"], cwd=moved, env=environment, stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT, text=True, timeout=PATIENCE)
        self.assertEqual(result.returncode, 0, result.stdout)
        with Image.open(os.path.join(moved, "picture.png")) as image:
            return numpy.asarray(image.convert("RGB")).astype(int)

    def assert_colours(self, picture, colours):
        for colour in colours:
            near = (numpy.abs(picture - colour) <= NEAR).all(axis=2)
            self.assertGreater(near.sum(), 0, f"no pixel has the colour {colour}")

    def test_fronts_of_a_block(self):
        run = self.block()
        self.assertIn("Wrote block/paraview_state.py and block/fronts.xdmf", self.plot("block"))
        (series,) = run.fronts.values()
        (found,) = self.numbers("block", "K_I")
        numpy.testing.assert_array_equal(found, series[-1].K_I)
        picture = self.picture("block")
        self.assert_colours(picture, (HIGHEST, LOWEST, STRESSED, CALM))
        shown = (picture < 250).any(axis=2)
        self.assertGreater(shown.mean(), 0.1)
        self.assertLess(shown.mean(), 0.9)

    def test_fronts_of_a_strip(self):
        run = self.strip()
        self.plot("strip")
        frames = self.numbers("strip", "K_I")
        self.assertEqual(len(frames), len(run.fields().written))
        self.assertEqual([len(values) for values in frames], [1] * len(frames))
        self.assertEqual(frames[-1][0], run.history["Notch.0.K_I"][-1])
        picture = self.picture("strip")
        self.assert_colours(picture, (STRESSED, CALM))
        # The strip is 40 mm wide and 80 mm high, and fills the height: blue nearly everywhere.
        blue = picture[:, :, 2] - picture[:, :, 0] > 40
        rows, columns = numpy.flatnonzero(blue.any(axis=1)), numpy.flatnonzero(blue[:, :1000].any(axis=0))
        self.assertAlmostEqual((columns[-1] - columns[0]) / (rows[-1] - rows[0]), 0.5, delta=0.05)

    def test_a_folder_without_fields(self):
        os.makedirs(self.path("empty"))
        self.assertIn("has no fields.h5", self.plot("empty", status=1))


if __name__ == "__main__":
    unittest.main()
