"""Tests of rhegma-accuracy, with a script in place of rhegma whose errors are known."""

import csv
import os

from tool import ToolTest, picture_size, run

from study_tests import GIMP, HEAD, LINEAR, PROGRAM, TAIL

PAGE = """# Costs
<!-- table beam -->
old
<!-- end -->
between
<!-- table beam cheapest -->
<!-- end -->
"""


class AccuracyPage(ToolTest):
    def setUp(self):
        super().setUp()
        self.write("scene.xml", '<ParameterList name="Rhegma"/>\n')
        os.makedirs(self.path("studies"))
        os.makedirs(self.path("pictures"))
        self.write(os.path.join("studies", "beam.xml"), HEAD.replace("scene.xml", "../scene.xml") + LINEAR + GIMP + TAIL)

    def renew(self, page):
        self.write("page.md", page)
        return run("rhegma-accuracy", "--rhegma", PROGRAM, "--output", self.path("out"), "--page", self.path("page.md"),
                   "--studies", self.path("studies"), "--jobs", "2")

    def test_renews_tables_and_pictures(self):
        status, output, messages = self.renew(PAGE)
        self.assertEqual((status, messages), (0, ""), output)
        with open(self.path("page.md"), encoding="utf-8") as file:
            lines = file.read().splitlines()
        self.assertNotIn("old", lines)
        self.assertIn("between", lines)
        self.assertIn("| | 5 mm | 2.5 mm | 1.25 mm |", lines)
        # Error (cell / 10 mm) for linear and its square for GIMP, which has no run on the smallest cells.
        linear = next(line for line in lines if line.startswith("| linear |"))
        self.assertEqual([entry.split(",")[0].strip() for entry in linear.split("|")[2:5]], ["50 %", "25 %", "12 %"])
        gimp = next(line for line in lines if line.startswith("| GIMP, both |"))
        self.assertEqual(gimp.split("|")[4].strip(), "")
        self.assertTrue(any(line.startswith("| 10 % | GIMP, both | 2.5 mm | 6.2 % |") for line in lines), lines)
        self.assertIn("| 3 % | none of these | | | |", lines)
        self.assertGreater(picture_size(self.path("pictures", "accuracy_beam.png"))[0], 900)

    def test_a_page_without_markers_for_the_table(self):
        status, _, messages = self.renew(PAGE.replace("table beam cheapest", "table beam dearest"))
        self.assertEqual(status, 1)
        self.assertIn("<!-- table beam cheapest -->", messages)


class Jobs(ToolTest):
    def setUp(self):
        super().setUp()
        self.write("scene.xml", '<ParameterList name="Rhegma"/>\n')
        self.write("study.xml", HEAD + LINEAR + GIMP + TAIL)

    def study(self, *more):
        return run("rhegma-study", self.path("study.xml"), "--rhegma", PROGRAM, *more)

    def test_the_same_runs_two_at_a_time(self):
        status, output, messages = self.study("--jobs", "2", "--processor-time")
        self.assertEqual((status, messages), (0, ""))
        self.assertIn("study.csv: 5 runs.", output)
        with open(self.path("study.out", "study.csv"), newline="", encoding="utf-8") as file:
            errors = [float(row["error"]) for row in csv.DictReader(file)]
        for found, error in zip(errors, [0.5, 0.25, 0.125, 0.25, 0.0625]):
            self.assertAlmostEqual(found, error, places=12)

    def test_wall_times_of_runs_that_share_the_machine(self):
        self.assert_fails(self.study("--jobs", "2"), "--jobs", "--processor-time")
        self.assert_fails(self.study("--jobs", "0"), "at least 1")
