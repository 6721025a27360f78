#!/usr/bin/env python3
"""Scenes that rhegma --new writes: they are valid, have no warnings, and run."""

import json
import os
import shutil
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import SOURCE, ProgramTest, rhegma  # noqa: E402

TWO_RANKS = ("mpirun", "--oversubscribe", "-np", "2")
# By template, settings of a short run: its cells, steps and end.
SHORT = {
    "3d-part": ["Domain:Cell Size=3 mm"],
    "burning": ["Time:Final Time=20 us"],
    "dcb": ["Time:Load Steps=6", "Domain:Cell Size=2.5 mm"],
    "drop-weight": ["Time:Final Time=60 us", "Domain:Cell Size=2 mm"],
    "plate": ["Time:Final Time=0.1 ms", "Domain:Cell Size=2.5 mm"],
    "quench": ["Time:Load Steps=5"],
}


class Templates(ProgramTest):
    def test_all_are_tested(self):
        folder = os.path.join(SOURCE, "xml_inputs", "templates")
        self.assertEqual(sorted(SHORT), sorted(name[:-len(".xml")] for name in os.listdir(folder)))

    def test_are_valid_without_warnings(self):
        for name in SHORT:
            with self.subTest(name):
                answer = rhegma("--new", name)
                self.assertEqual((answer.status, answer.messages), (0, ""))
                self.assertIn("<!--", answer.output)
                self.assertIn(' unit="', answer.output)
                scene = self.write(f"{name}.xml", answer.output)
                checked = rhegma(scene, "--check", "--strict")
                self.assertEqual((checked.status, checked.messages), (0, ""), checked)
                self.assertIn("is a valid scene", checked.output)

    def test_run(self):
        for name, settings in SHORT.items():
            with self.subTest(name):
                written = rhegma("--new", name, "--output", f"{name}.xml", cwd=self.folder)
                self.assertEqual((written.status, written.messages), (0, ""))
                options = [word for setting in settings for word in ("--set", setting)]
                answer = rhegma(f"{name}.xml", "--quiet", "--output", f"{name}.out", *options, cwd=self.folder)
                self.assertEqual(answer.status, 0, answer)
                with open(self.path(f"{name}.out", "summary.json")) as file:
                    summary = json.load(file)
                self.assertEqual(summary["status"], "finished")
                self.assertGreater(summary["cracks"][0]["fronts"][0]["G_J"], 0.0)

    @unittest.skipUnless(shutil.which("mpirun"), "without mpirun")
    def test_print_on_one_rank(self):
        answer = rhegma("--new", "dcb", launcher=TWO_RANKS)
        self.assertEqual((answer.status, answer.output), (0, rhegma("--new", "dcb").output))
        written = rhegma("--new", "dcb", "--output", "dcb.xml", cwd=self.folder, launcher=TWO_RANKS)
        self.assertEqual(written.status, 0, written)
        with open(self.path("dcb.xml")) as file:
            self.assertEqual(file.read(), answer.output)

    def test_wrong_names(self):
        names = "3d-part, burning, dcb, drop-weight, plate or quench"
        self.assert_refused(["--new", "quensh"], [("", ['"quensh"', names, 'did you mean "quench"'])])
        self.assert_refused(["--new", "bar"], [("", ['"bar"', names])])
        self.assert_refused(["--new"], [("", ["needs the name of a template", names])])
        self.assert_refused(["--new", "dcb", "plate"], [("", ["takes one template", '"plate"'])])

    def test_replaces_no_file(self):
        self.write("scene.xml", "an older scene")
        self.assert_refused(["--new", "dcb", "--output", "scene.xml"], [("", ["scene.xml exists", "another file"])])
        self.assert_refused(["--new", "dcb", "--output", os.path.join("nowhere", "scene.xml")],
                            [("", ["can't be written", "another file"])])


del ProgramTest
if __name__ == "__main__":
    unittest.main()
