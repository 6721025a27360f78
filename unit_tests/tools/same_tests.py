"""Tests of rhegma-same, with scripts in place of rhegma that give known histories."""

import json
import os

from tool import ToolTest, run

# A column that is 1 + SHIFT at the end, one of its kind that is a rounding error, and a summary of both.
PROGRAM = """#!/usr/bin/env python3
import json, os, signal, sys, time
folder = sys.argv[sys.argv.index("--output") + 1]
open({runs!r}, "a").write(sys.argv[1] + "\\n")
stop = []
signal.signal(signal.SIGTERM, lambda *_: stop.append(1))
with open(os.path.join(folder, "history.csv"), "w") as file:
    file.write("time,Notch.0.K_I,Notch.0.K_II,{column}\\n0,0,0,7\\n1,1,{noise},7\\n2,{last!r},0,7\\n")
    file.flush()
    while {hangs} and not stop:
        pass
with open(os.path.join(folder, "summary.json"), "w") as file:
    json.dump({{"status": "finished", "wall_seconds": time.time(), "energy": {{"strain": 2.0, "kinetic": {noise}}}}}, file)
sys.exit({status})
"""


class Same(ToolTest):
    def setUp(self):
        super().setUp()
        for name in ("examples/beam", "examples/notch", "verification/notch"):
            os.makedirs(os.path.dirname(self.path("xml_inputs", name)), exist_ok=True)
            self.write(os.path.join("xml_inputs", name + ".xml"), '<ParameterList name="Rhegma"/>\n')
        self.program("before")

    def program(self, name, last=1.0, noise=0.0, column="mass", hangs=False, status=0):
        self.write(name, PROGRAM.format(runs=self.path(name + ".runs"), last=last, noise=noise, column=column, hangs=hangs,
                                        status=status))
        os.chmod(self.path(name), 0o755)

    def compare(self, *more):
        return run("rhegma-same", "--before", self.path("before"), "--after", self.path("after"), *more)

    def test_the_same(self):
        self.program("after")
        status, output, messages = self.compare()
        self.assertEqual((status, messages), (0, ""), output)
        self.assertIn("verification/notch  same (3 rows)", output)
        self.assertIn("3 of 3 scenes are the same, bit for bit.", output)

    def test_scenes_by_name(self):
        self.program("after")
        self.assertIn("2 of 2 scenes", self.compare("notch")[1])
        self.assertIn("1 of 1 scenes", self.compare("examples/n*")[1])
        self.assert_fails(self.compare("slit"), "slit")

    def test_a_difference_is_relative_to_its_kind(self):
        self.program("after", last=1.0 + 2.0**-20, noise=2.0**-22)
        status, output, _ = self.compare("beam")
        self.assertEqual(status, 2)
        self.assertIn("DIFFERS by 9.5e-07 in Notch.0.K_I ", output)
        self.assertEqual(self.compare("beam", "--tolerance", "1e-6")[0], 0)
        # K_II, which is 0, counts by K_I; the kinetic energy by the strain energy.
        status, output, _ = self.compare("beam", "--ignore", "*.K_I")
        self.assertEqual(status, 2)
        self.assertIn("DIFFERS by 1 in Notch.0.K_II", output)
        self.program("after", noise=2.0**-22)
        self.assertEqual(self.compare("beam", "--tolerance", "3e-7")[0], 0)

    def test_columns_of_one_program_only(self):
        self.program("after", column="weight")
        status, output, _ = self.compare("beam")
        self.assertEqual(status, 2)
        self.assertIn("lost mass new weight", output)
        self.assertEqual(self.compare("beam", "--ignore", "mass", "--ignore", "weight")[0], 0)

    def test_columns_that_were_renamed(self):
        self.program("after", column="weight")
        self.assertEqual(self.compare("beam", "--renamed", "mass=weight")[0], 0)

    def test_a_run_that_fails(self):
        self.program("after", status=2)
        status, output, _ = self.compare("beam")
        self.assertEqual(status, 2)
        self.assertIn("FAILED after with status 2", output)

    def test_long_runs_are_compared_in_part(self):
        self.program("after", last=3.0, hangs=True, status=2)
        status, output, _ = self.compare("beam", "--seconds", "0.3")
        self.assertEqual(status, 0, output)
        self.assertIn("same (2 rows before one was stopped)", output)

    def test_runs_of_the_program_before_are_kept(self):
        self.program("after")
        for _ in range(2):
            self.assertEqual(self.compare("beam", "--cache", self.path("cache"), "--keep", self.path("keep"))[0], 0)
        with open(self.path("before.runs"), encoding="utf-8") as file:
            self.assertEqual(len(file.readlines()), 1)
        with open(self.path("keep", "whole", "examples", "beam", "run.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["status"], 0)
        # Another program in its place, or other settings, are other runs.
        self.program("before", last=2.0)
        self.assertEqual(self.compare("beam", "--cache", self.path("cache"))[0], 2)
        self.assertEqual(self.compare("beam", "--cache", self.path("cache"), "--set", "Time:Maximum Steps=3")[0], 2)

    def test_the_cache_alone(self):
        status, output, _ = run("rhegma-same", "--before", self.path("before"), "--cache", self.path("cache"), "beam")
        self.assertEqual(status, 0)
        self.assertTrue(os.path.exists(self.path("cache", "whole", "examples", "beam", "history.csv")))
        self.assert_fails(run("rhegma-same", "--before", self.path("before")), "--cache")

    def test_a_program_that_is_not_there(self):
        self.assert_fails(self.compare(), "there is no program")
