#!/usr/bin/env python3
"""What --check tells of the cost of a run, the rates that it keeps, and what runs tell of their end. Nothing here is timed."""

import glob
import json
import math
import os
import re
import shutil
import subprocess
import sys
import unittest
import unittest.mock

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import PROGRAM, SOURCE, ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

LINE = re.compile(r"Forecast: (?:([\d.]+) min )?([\d.]+) (s|h)(.*) \(([\d.e+-]+) ms a step, (\w+), (\d+) threads?\), "
                  r"([\d.]+) (MB|GB) of memory")


class Forecast(ProgramTest):
    def setUp(self):
        super().setUp()
        self.scene = self.write("scene.xml", plate().text())

    def check(self, *more):
        answer = rhegma(self.scene, "--check", *more, XDG_CACHE_HOME=self.path("cache"))
        self.assertEqual(answer.status, 0, answer)
        return answer.output

    def kept(self):
        files = glob.glob(self.path("cache", "rhegma", "*"))
        self.assertEqual(len(files), 1, files)
        return files[0]

    def change(self, change):
        with open(self.kept(), encoding="utf-8") as file:
            content = json.load(file)
        change(content)
        with open(self.kept(), "w", encoding="utf-8") as file:
            json.dump(content, file)

    def test_check_tells_the_cost_and_leaves_nothing_next_to_the_scene(self):
        found = LINE.search(self.check())
        self.assertTrue(found)
        self.assertGreater(float(found[5]), 0.0)
        self.assertGreater(float(found[8]), 1.0)
        self.assertEqual(sorted(os.listdir(self.folder)), ["cache", "scene.xml"])

    def test_rates_are_kept_and_used(self):
        first = self.check()
        self.assertIn("from its first", first)
        self.assertRegex(self.check(), r"kept from an earlier measurement, \d{4}-\d\d-\d\d \d\d:\d\d:\d\d UTC\n")

        def slower(content):
            content["scenes"][0]["step"] = 1000.0  # of steps that are left
            content["scenes"][0]["spent"] = 1e6  # by those that were taken
        self.change(slower)
        found = LINE.search(self.check())
        self.assertEqual((found[3], float(found[5])), ("h", 1e6))
        self.assertIn("from its first", self.check("--set", "Time:CFL=0.31"))

    def test_checkpoints_are_part_of_the_cost(self):
        """Of a checkpoint that would take 1000 s, so many as the interval asks for; the last is at the end of the run."""
        end = 1e-3

        def check(interval):
            return self.check("--set", f"Time:Final Time={end}", "--set", f"Output:Checkpoint Interval={interval}")

        def slower(content):
            for kept in content["scenes"]:
                self.assertGreater(kept["checkpoint"], 0.0)
                kept["checkpoint"] = 1000.0
        self.assertNotIn("checkpoint", self.check("--set", f"Time:Final Time={end}"))
        hours = {}
        for number in (4, 8):
            self.assertRegex(check(end / number), rf", {number} checkpoints of [\d.]+ MB \([\d.]+ s\)")
            self.change(lambda content: slower({"scenes": content["scenes"][:1]}))
            found = LINE.search(check(end / number))
            self.assertEqual(found[3], "h")
            hours[number] = float(found[2])
        for number, value in hours.items():  # of three digits; the steps take less than a minute
            self.assertAlmostEqual(value, number * 1000.0 / 3600.0, delta=0.025)

    def test_rates_of_another_machine_are_refused(self):
        self.check()

        def other(content):
            content["machine"] = "another machine"
            content["scenes"][0]["step"] = 1000.0
        self.change(other)
        self.assertIn("from its first", self.check())
        with open(self.kept(), encoding="utf-8") as file:
            self.assertNotIn("another machine", file.read())
        self.assertIn("kept from an earlier measurement", self.check())

    def test_rates_of_another_build_are_not_used(self):
        """A program of another date, as after it was compiled with other flags; it keeps its rates next to those."""
        self.check()
        other = shutil.copy2(PROGRAM, self.path("rhegma"))
        os.utime(other, (1.7e9, 1.7e9))
        with unittest.mock.patch("program.PROGRAM", other):
            self.assertIn("from its first", self.check())
            self.assertIn("kept from an earlier measurement", self.check())
        self.assertIn("kept from an earlier measurement", self.check())

    def test_a_damaged_file_of_rates_is_replaced(self):
        self.check()
        with open(self.kept(), "r+", encoding="utf-8") as file:
            file.truncate(40)
        self.assertIn("from its first", self.check())
        self.assertIn("kept from an earlier measurement", self.check())

    def test_a_cache_that_cannot_be_written_is_done_without(self):
        self.write("file", "")
        answer = rhegma(self.scene, "--check", XDG_CACHE_HOME=self.path("file"))
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)
        self.assertRegex(answer.output, LINE)

    def test_a_quiet_check_measures_nothing(self):
        answer = rhegma(self.scene, "--check", "--quiet", XDG_CACHE_HOME=self.path("cache"))
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)
        self.assertNotIn("Forecast", answer.output)
        self.assertFalse(os.path.exists(self.path("cache")))

    def test_the_forecast_changes_no_result(self):
        """A run after a check and one without it have the same history."""
        histories = []
        for checked in (True, False):
            if checked:
                self.check()
            self.assertEqual(rhegma(self.scene, "--quiet", "--output", self.path("out")).status, 0)
            with open(self.path("out", "history.csv"), "rb") as file:
                histories.append(file.read())
        self.assertEqual(*histories)

    def test_accuracy_tells_what_it_and_others_cost(self):
        with open(os.path.join(SOURCE, "xml_inputs", "examples", "dcb.xml"), encoding="utf-8") as file:
            text = file.read()
        cell = re.search(r'<Parameter name="Cell Size" type="double" value="[^"]*"/>', text)[0]
        accurate = '<Parameter name="Accuracy" type="string" value="3 %"/>'
        text = text.replace(cell, accurate)
        radius = '<Parameter name="Outer Radius" type="double" value="8e-3"/>'
        self.assertIn(radius, text)
        # A cell fits between 5 mm and 5.8 mm where 1 % is asked, which has the smallest cells.
        thin = text.replace(radius, radius.replace("8e-3", "5.8e-3")).replace("3 %", "1 %")
        self.scene = self.write("scene.xml", thin)
        self.assertIn("\n  with 3 %: not possible: Energy Release > Outer Radius: ", self.check())
        self.scene = self.write("scene.xml", text)
        told = self.check()
        own = re.search(r"\nAccuracy 3 %: (\d+) particles, .*\n  with 10 %: (\d+) particles, ", told)
        self.assertTrue(own, told)
        self.assertGreater(int(own[1]), int(own[2]))
        answer = rhegma(self.scene, "--set", "Time:Maximum Steps=2", "--set", "Output:Fields=false",
                        XDG_CACHE_HOME=self.path("cache"))
        self.assertTrue(answer.output.startswith("Accuracy 3 %: "), answer)

    def test_a_large_scene_is_announced(self):
        """1 m by 1 m in cells of 0.8 mm, 2 x 2 particles each."""
        path = self.write("large.xml", plate().set("Domain > Cell Size", 8e-4).text())
        child = subprocess.Popen([PROGRAM, path, "--check"], stdout=subprocess.PIPE, text=True)
        try:
            self.assertEqual(child.stdout.readline(), "Bodies: about 6.2 million particles, which take some 7.5 GB and a minute or "
                                                      "more to set up\n")
        finally:
            child.kill()
            child.wait()
            child.stdout.close()
        self.assertNotIn("million particles", self.check())

    def test_a_rest_that_equilibrium_solves_for_is_named(self):
        hint = "\n  Time > Analysis = Static, without Damping, solves for the static equilibrium directly\n"
        for folder, name, fits in (("examples", "dcb.xml", True), ("verification", "dcb_adaptive_h16.xml", False),
                                   ("examples", "kalthoff.xml", False)):
            with self.subTest(name):
                answer = rhegma(os.path.join(SOURCE, "xml_inputs", folder, name), "--check",
                                XDG_CACHE_HOME=self.path("cache"))
                self.assertEqual(answer.status, 0, answer)
                self.assertEqual(hint in answer.output, fits, answer)

    def test_growth_in_equilibrium_is_said_to_cost_more(self):
        """How far a crack grows under loads that follow time is not known before. A run with the growth takes as many linear
        systems more for each increment as the forecast says, to a factor of two."""
        scene = os.path.join(SOURCE, "xml_inputs", "verification", "dcb_grips_static.xml")
        answer = rhegma(scene, "--check", XDG_CACHE_HOME=self.path("cache"))
        said = re.search(r"a crack that grows takes about (\d+) more linear systems \(\S+ s\) for each increment", answer.output)
        self.assertTrue(said, answer)
        systems, increments = [], 0
        for name, toughness in (("held", "1e6"), ("grows", "100")):
            run = rhegma(scene, "--quiet", "--output", self.path(name), "--set", "Propagation:Toughness=" + toughness)
            self.assertEqual(run.status, 0, run)
            with open(self.path(name, "summary.json"), encoding="utf-8") as file:
                summary = json.load(file)
            systems.append(summary["equilibrium"]["iterations"])
            increments = summary["cracks"][0]["fronts"][0].get("increments", 0)
        self.assertGreater(increments, 20)
        self.assertAlmostEqual(math.log2((systems[1] - systems[0]) / increments / int(said[1])), 0.0, delta=1.0)
        for path in ("dcb_growth_static.xml", "dcb_static.xml"):  # by a load factor, and without growth
            answer = rhegma(os.path.join(SOURCE, "xml_inputs", "verification", path), "--check", XDG_CACHE_HOME=self.path("cache"))
            self.assertNotIn("a crack that grows takes", answer.output)

    def test_a_settled_run_tells_how_far_it_may_still_go(self):
        scene = os.path.join(SOURCE, "xml_inputs", "examples", "dcb.xml")
        answer = rhegma(scene, "--output", self.path("out"))
        self.assertEqual(answer.status, 0, answer)
        said = re.search(r"settled at t = \S+ [mu]?s: .* may still change by at most ([\d.e-]+) %", answer.output)
        self.assertTrue(said, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        self.assertAlmostEqual(float(said[1]) / (100.0 * summary["may_still_change"]), 1.0, delta=1e-3)
        self.assertLess(summary["may_still_change"], 0.01)
        # What a run with a tenth of the drift changes in addition is less than three times what was told.
        more = rhegma(scene, "--quiet", "--output", self.path("more"), "--set", "Damping:Settled Drift=1e-6")
        self.assertEqual(more.status, 0, more)
        with open(self.path("more", "summary.json"), encoding="utf-8") as file:
            later = json.load(file)["cracks"][0]["fronts"][0]["G_J"]
        self.assertLess(abs(summary["cracks"][0]["fronts"][0]["G_J"] / later - 1.0), 3.0 * summary["may_still_change"])


if __name__ == "__main__":
    unittest.main()
