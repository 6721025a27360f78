#!/usr/bin/env python3
"""The examples of docs/how-to/python.md and the notebooks of docs/notebooks run with the program, and give what their text says."""

import glob
import json
import os
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import PROGRAM, SOURCE, ProgramTest, environment  # noqa: E402

sys.path.insert(0, os.path.join(SOURCE, "tools"))
from rhegma_tools import interpreter  # noqa: E402

interpreter.need("numpy", "h5py", "matplotlib")

import rhegma  # noqa: E402

PAGE = os.path.join(SOURCE, "docs", "how-to", "python.md")
NOTEBOOKS = os.path.join(SOURCE, "docs", "notebooks")
REFERENCE = 0.12873  # quadratic finite elements, as in xml_inputs/verification/dcb_h4_static.xml [J/m2]


class PythonTest(ProgramTest):
    """Runs code in a folder of its own, in which xml_inputs is that of the checkout."""

    def setUp(self):
        super().setUp()
        os.symlink(os.path.join(SOURCE, "xml_inputs"), self.path("xml_inputs"))
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        before = dict(os.environ)
        self.addCleanup(lambda: (os.environ.clear(), os.environ.update(before)))
        os.environ.update(environment({"RHEGMA_PROGRAM": os.path.abspath(PROGRAM)}))

    def execute(self, pieces, where):
        """The names that pieces of code leave, executed one after the other."""
        names = {"__name__": "example"}
        for number, code in enumerate(pieces, start=1):
            exec(compile(code, f"{where}, piece {number}", "exec"), names)
        return names


class Page(PythonTest):
    def test_its_examples_run(self):
        with open(PAGE, encoding="utf-8") as file:
            pieces = re.findall(r"^```python\n(.*?)^```", file.read(), re.MULTILINE | re.DOTALL)
        self.assertEqual(len(pieces), 5)
        names = self.execute(pieces, "docs/how-to/python.md")
        # Tolerances are those of the section Reference of the scenes, which run.references_met compares.
        self.assertTrue(names["run"].references_met)
        self.assertTrue(os.path.exists(self.path("release.png")))
        self.assertGreater(len(names["release"]), 10)
        self.assertTrue(names["sweep"][0].references_met)
        coarse, fine = names["sweep"].values("cracks.Notch.fronts.0.G_J")
        self.assertLess(abs(fine / REFERENCE - 1.0), 0.013)  # as in xml_inputs/verification/dcb_static.xml
        self.assertLess(abs(fine / REFERENCE - 1.0), abs(coarse / REFERENCE - 1.0))
        # The scene of the third example is that of dcb_h4_static.xml with the same radii, in other units.
        self.assertAlmostEqual(names["built"].value("cracks.Notch.fronts.0.G_J") / coarse, 1.0, delta=1e-9)
        self.assertGreater(names["opening"], 0.0)
        self.assertEqual(names["velocity"].shape, names["fields"].position.shape)
        self.assertFalse(os.path.exists(self.path("wrong.out", "summary.json")))


class Notebooks(PythonTest):
    def cells(self, path):
        with open(path, encoding="utf-8") as file:
            return json.load(file)["cells"]

    def test_have_no_outputs(self):
        paths = glob.glob(os.path.join(NOTEBOOKS, "*.ipynb"))
        self.assertTrue(paths)
        for path in paths:
            for cell in self.cells(path):
                self.assertFalse(cell.get("outputs"), path)
                self.assertIsNone(cell.get("execution_count"), path)

    def test_the_beam(self):
        code = ["".join(cell["source"]) for cell in self.cells(os.path.join(NOTEBOOKS, "dcb.ipynb")) if cell["cell_type"] == "code"]
        names = self.execute(code, "dcb.ipynb")
        # The foundation of Williams' correction is a fit: it agrees with finite elements within half a percent for arms of this
        # length and an isotropic material.
        self.assertLess(abs(names["corrected"] / REFERENCE - 1.0), 0.005)
        self.assertAlmostEqual(names["G"], names["releases"][0], delta=1e-12)  # the same scene
        # Tolerances of dcb_h4_static, dcb_static and dcb_h16_static; the error becomes smaller.
        errors = abs(names["errors"])
        self.assertTrue((errors < [0.032, 0.013, 0.013]).all(), errors)
        self.assertTrue((errors[1:] < errors[:-1]).all(), errors)
        # That of 8 cells (0.013) and half a percent of the correction, at each length.
        for ratio in names["ratios"]:
            self.assertAlmostEqual(ratio, 1.0, delta=0.018)


class Package(PythonTest):
    def test_messages_of_the_program(self):
        scene = rhegma.Scene.load("xml_inputs/verification/dcb_h4_static.xml")
        with self.assertRaises(rhegma.SceneError) as caught:
            rhegma.run(scene.varied({"Domain > Cell Size": -1.0, "Bodies > Beam > Shape": "Bocks"}), output=self.path("wrong"))
        self.assertEqual(len(caught.exception.messages), 2)
        self.assertTrue(all(message.startswith(("Domain > Cell Size: ", "Bodies > Beam > Shape: ")) for message in caught.exception.messages))
        self.assertIn("Mass Rate", rhegma.describe("Damping"))
        with self.assertRaises(rhegma.Problem):
            rhegma.describe("Dampness")

    def test_a_run_that_stops_early(self):
        scene = rhegma.Scene.load("xml_inputs/examples/dcb.xml").varied({"Time > Maximum Steps": 20, "Output > Fields": True})
        del scene["Reference"]
        run = rhegma.run(scene, output=self.path("short"))
        self.assertEqual((run.status, run.end), (0, "cut off"))
        self.assertEqual(run.value("steps"), 20)
        unknown = [name for name in run.history.names if run.history.unit(name) is None]
        self.assertEqual(unknown, [])
        fields = run.fields()
        self.assertEqual(fields.position.shape, (run.value("particles"), 3))
        self.assertEqual([name for name in ("velocity", "stress", "mass", "material") if name not in fields.names], [])

    def test_numbers_of_any_type_are_accepted(self):
        scene = rhegma.Scene.load("xml_inputs/verification/dcb_h4_static.xml")
        scene["Domain > Thickness"] = 1  # an int where the program wants a double
        scene["Cracks > Notch > Points"] = rhegma.Quantity([0, 10, 50, 10], "mm")
        self.assertEqual(scene["Domain > Thickness"], 1)
        rhegma.check(scene)


if __name__ == "__main__":
    unittest.main()
