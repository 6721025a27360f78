#!/usr/bin/env python3
"""rhegma --twice on scenes whose convergence is known, and what it leaves of older runs.

RHEGMA_KILLS in the environment is how many runs are killed (6 where it is not set), RHEGMA_SEED the seed of their moments.
"""

import json
import os
import random
import signal
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import PATIENCE, SOURCE, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT  # noqa: E402
from restart_case import RestartTest  # noqa: E402
from scenes import plate  # noqa: E402
from test_fronts_that_stop import passing  # noqa: E402

EXAMPLES = os.path.join(SOURCE, "xml_inputs", "examples")
KILLS = int(os.environ.get("RHEGMA_KILLS", "6"))
SEED = int(os.environ.get("RHEGMA_SEED", KILLS))


class TwiceTest(RestartTest):
    def comparison(self, folder="out"):
        with open(self.path(folder, "twice.json"), encoding="utf-8") as file:
            return json.load(file)

    def status_of(self, *names):
        with open(self.path(*names, "summary.json"), encoding="utf-8") as file:
            return json.load(file)["status"]

    def has(self, *names):
        return os.path.exists(self.path(*names))


class Twice(TwiceTest):
    def twice(self, scene, *more):
        answer = rhegma(scene, "--twice", "--output", self.path("out"), *more)
        self.assertIn(answer.status, (0, 4), answer)
        comparison = self.comparison()
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["as_is", "half", "twice.json"])
        return answer, comparison, {one["name"]: one for one in comparison["answers"]}

    def summary(self, folder):
        with open(self.path("out", folder, "summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def test_a_beam_converges_to_the_finite_elements(self):
        """Quadratic finite elements give 0.12873 J/m2. The change bounds the error of the finer cells and of the extrapolation,
        which takes an error of the first order; with front springs along the cells it falls faster."""
        answer, comparison, answers = self.twice(os.path.join(EXAMPLES, "dcb.xml"))
        release = answers["G_J of Notch.0"]
        errors = [abs(release[name] / 0.12873 - 1.0) for name in ("as_is", "half", "extrapolated")]
        self.assertLess(errors[1], errors[0], release)
        self.assertLess(max(errors[1:]), release["change"], release)
        self.assertEqual(release["order"], 1)
        self.assertTrue(comparison["resolved"], comparison)
        self.assertIn("Verdict: resolved", answer.output)
        for folder, cell in (("as_is", comparison["cell"]), ("half", 0.5 * comparison["cell"])):
            self.assertAlmostEqual(self.summary(folder)["cells"]["smallest"] / cell, 1.0, places=9)
        self.assertEqual(self.summary("as_is")["cracks"][0]["fronts"][0]["G_J"], release["as_is"])

    def test_cells_that_are_too_large_are_not_resolved(self):
        """A crack in a strip on half as many cells as resolve it: it runs by another path or to another place."""
        answer, comparison, answers = self.twice(
            os.path.join(EXAMPLES, "kalthoff.xml"), "--set", "Domain:Cell Size=4e-3", "--set", "Output:Fields=false")
        self.assertFalse(comparison["resolved"], comparison)
        self.assertIn("path of Notch.0", answers)
        self.assertRegex(answer.output, r"Verdict: not resolved: .*\([^()]*\); use smaller cells\n")
        self.assertEqual(answer.output.splitlines()[-1].count("not resolved"), 1, answer.output)

    def test_levels_are_halved_with_the_coarse_cells(self):
        self.twice(os.path.join(EXAMPLES, "pressurised_crack.xml"), "--set", "Time:Maximum Steps=3",
                   "--set", "Output:Fields=false")
        cells = [self.summary(folder)["cells"] for folder in ("as_is", "half")]
        for size in ("largest", "smallest"):
            self.assertAlmostEqual(cells[0][size] / cells[1][size], 2.0, places=9)
        self.assertEqual([self.summary(folder)["steps"] for folder in ("as_is", "half")], [3, 6])

    def test_a_penny_in_3d(self):
        """Before its front may grow: J of a penny on few cells falls towards that of finer ones."""
        _, comparison, answers = self.twice(
            os.path.join(EXAMPLES, "penny_growth.xml"), "--set", "Domain:Cell Size=2e-3", "--set", "Time:Final Time=4e-5",
            "--set", "Output:Fields=false")
        for name in ("G_J of Penny.0", "K_I of Penny.0"):
            answer = answers[name]
            self.assertGreater(answer["half"], 0.0, answer)
            self.assertGreater(answer["as_is"], answer["half"], answer)
            self.assertAlmostEqual(answer["extrapolated"], 2.0 * answer["half"] - answer["as_is"], delta=1e-9 * answer["half"])
        cells = [self.summary(folder)["cells"]["smallest"] for folder in ("as_is", "half")]
        self.assertAlmostEqual(cells[0] / cells[1], 2.0, places=9)
        self.assertFalse(comparison["resolved"], comparison)

    def test_a_scene_with_nothing_to_compare(self):
        answer, comparison, _ = self.twice(self.write("scene.xml", plate().remove("Cracks").remove("Energy Release").text()))
        self.assertEqual(comparison["answers"], [])
        self.assertIn("nothing to compare", answer.output)

    def test_it_goes_with_no_restart(self):
        scene = self.write("scene.xml", plate().text())
        self.assert_refused([scene, "--twice", "--check"], [("", ["--twice", "--check"])])


class RunsThatStop(TwiceTest):
    """Half the cells may do what the cells of the scene can't."""

    def test_a_front_that_the_cells_of_the_scene_stop(self):
        answer = rhegma(self.write("scene.xml", passing().text()), "--twice", "--output", self.path("out"))
        self.assertEqual(answer.status, 2, answer)
        comparison = self.comparison()
        answers = {one["name"]: one for one in comparison["answers"]}
        end = answers["end of the run"]
        self.assertEqual((end["as_is"], end["half"], end["resolved"]), ("stopped", "finished", False))
        self.assertLess(answers["time reached"]["as_is"], answers["time reached"]["half"])
        self.assertFalse(comparison["resolved"])
        for run in ("as_is", "half"):
            self.assertEqual(comparison["runs"][run]["status"], self.status_of("out", run))
        self.assertIn("As it is: the run stopped at t = ", answer.output)
        self.assertIn("less than three cells from crack Other", answer.output)
        self.assertRegex(answer.output.splitlines()[-1], "^Verdict: not resolved: end of the run .*the run finishes with half the cell size")

    def test_on_two_ranks(self):
        """All ranks agree on whether the second run is made, and on the exit status."""
        ranks = {"launcher": (*LAUNCHER, "-np", "2"), **ROOT}
        scene = self.write("scene.xml", passing().text())
        answer = rhegma(scene, "--twice", "--quiet", "--output", self.path("out"), **ranks)
        self.assertEqual(answer.status, 2, answer)
        self.assertEqual(self.comparison()["runs"]["half"]["status"], self.status_of("out", "half"))
        self.assertFalse(self.has("out", "run.lock"))
        self.write(os.path.join("out", "twice.json"), "notes of my own")
        answer = rhegma(scene, "--twice", "--quiet", "--output", self.path("out"), **ranks)
        self.assertEqual(answer.status, 1, answer)
        self.assertEqual(len([line for line in answer.messages.splitlines() if "no run wrote" in line]), 1, answer)
        self.assertTrue(self.has("out", "half", "summary.json"))

    def test_the_worse_exit_status_counts(self):
        """The first run stops, and the second misses its reference: 2, though 4 is the greater number."""
        wrong = {"End": {"Quantity": "time", "Value": 1.0, "Tolerance": 1e-3, "Source": "none"}}
        scene = self.write("scene.xml", passing().set("Reference", wrong).text())
        answer = rhegma(scene, "--twice", "--output", self.path("out"), "--quiet")
        self.assertEqual(answer.status, 2, answer)
        self.assertTrue(self.has("out", "twice.json"))
        scene = self.write("scene.xml", passing(On_Stop="Continue").set("Reference", wrong).text())
        answer = rhegma(scene, "--twice", "--output", self.path("out"), "--quiet")
        self.assertEqual(answer.status, 4, answer)

    def test_a_signal_ends_both(self):
        """Whoever stops the first run does not want the second one."""
        scene = self.write("scene.xml", plate().set("Time > Final Time", 10.0).text())
        run = self.start(scene, "--twice", "--output", self.path("out"), "--quiet")
        self.addCleanup(run.kill)
        self.wait_for(run, self.path("out", "as_is", "manifest.json"))
        run.send_signal(signal.SIGTERM)
        self.assertEqual(run.wait(PATIENCE), 2)
        self.assertIn("stopped by SIGTERM", self.status_of("out", "as_is"))
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["as_is", "half"])
        self.assertEqual(os.listdir(self.path("out", "half")), [])


class OlderRuns(TwiceTest):
    """Nothing of an older pair is left next to new runs, and nothing else is replaced."""

    def pair(self):
        path = self.write("short.xml", plate().text())
        answer = rhegma(path, "--twice", "--output", self.path("out"), "--quiet")
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)
        return path

    def test_no_stale_comparison(self):
        self.pair()
        scene = self.write("scene.xml", plate().set("Time > Final Time", 10.0).text())
        run = self.start(scene, "--twice", "--output", self.path("out"), "--quiet")
        self.addCleanup(run.kill)
        end = time.monotonic() + PATIENCE
        while self.has("out", "as_is", "summary.json") and run.poll() is None and time.monotonic() < end:
            time.sleep(0.005)
        self.assertFalse(self.has("out", "twice.json"))
        self.assertEqual(os.listdir(self.path("out", "half")), [])
        run.kill()
        run.wait(PATIENCE)
        self.assertEqual(run.returncode, -signal.SIGKILL)

    def test_kill_at_any_moment(self):
        """A comparison is that of the runs next to it, whenever the program is killed."""
        generator = random.Random(SEED)
        path = self.pair()
        begin = time.monotonic()
        self.pair()
        duration = time.monotonic() - begin
        killed = 0
        while killed < KILLS:
            final = generator.choice((1e-3, 7e-4))
            run = self.start(path, "--twice", "--output", self.path("out"), "--quiet", "--set", f"Time:Final Time={final!r}")
            time.sleep(generator.uniform(0.0, duration))
            run.kill()
            run.wait(PATIENCE)
            self.assertIn(run.returncode, (0, -signal.SIGKILL))
            killed += run.returncode != 0
            if self.has("out", "twice.json"):
                for name, of_run in self.comparison()["runs"].items():
                    with open(self.path("out", name, "summary.json"), encoding="utf-8") as file:
                        summary = json.load(file)
                    self.assertEqual({key: summary[key] for key in of_run}, of_run, f"seed {SEED}, kill {killed}")
        self.pair()
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["as_is", "half", "twice.json"])

    def test_a_wrong_scene_leaves_the_older_pair(self):
        self.pair()
        self.write("scene.xml", plate().set("Bodies > Plate > Material", "Stone").text())
        self.assert_refused(["scene.xml", "--twice", "--output", "out"], [("Bodies > Plate > Material", ["Stone"])])

    def test_a_warning_with_strict_leaves_the_older_pair(self):
        self.pair()
        before = self.file(self.path("out"), "twice.json")
        scene = plate().set("Boundaries > Nothing", {"Type": "Velocity", "Lower Corner": [1.1, 1.1], "Upper Corner": [1.2, 1.2],
                                                     "Components": "x", "Value": [0.0, 0.0]})
        answer = rhegma(self.write("scene.xml", scene.text()), "--twice", "--strict", "--quiet", "--output", self.path("out"))
        self.assertEqual(answer.status, 1, answer)
        self.assertEqual(self.file(self.path("out"), "twice.json"), before)
        self.assertTrue(self.has("out", "half", "summary.json"))

    def test_files_of_the_user(self):
        self.write("scene.xml", plate().text())
        for names in (("twice.json",), ("run.lock",), ("as_is", "history.csv"), ("half", "history.csv"), ("half", "summary.json")):
            folder = self.path("out", *names[:-1])
            os.makedirs(folder, exist_ok=True)
            path = self.write(os.path.join("out", *names), "time,temperature\n0,293\n")
            self.assert_refused(["scene.xml", "--twice", "--output", "out"], [("", [names[-1], "no run wrote", "--output"])])
            os.remove(path)

    def test_scene_among_the_results(self):
        """By the name of a result it is refused; by another one it stays."""
        for names in (("twice.json",), ("as_is", "summary.json"), ("half", "history.csv")):
            os.makedirs(self.path("out", *names[:-1]), exist_ok=True)
            path = self.write(os.path.join("out", *names), plate().text())
            self.assert_refused([path, "--twice", "--output", self.path("out")], [("", ["own scene", names[-1], "--output"])])
            os.remove(path)
        path = self.write(os.path.join("out", "scene.xml"), plate().text())
        answer = rhegma(path, "--twice", "--output", self.path("out"), "--quiet")
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)
        self.assertEqual(self.file(self.path("out"), "scene.xml").decode(), plate().text())

    def test_one_pair_a_folder(self):
        scene = self.write("scene.xml", plate().set("Time > Final Time", 10.0).text())
        run = self.start(scene, "--twice", "--output", self.path("out"), "--quiet")
        self.addCleanup(run.kill)
        self.wait_for(run, self.path("out", "as_is", "manifest.json"))
        self.assertIn(f"process: {run.pid}\n", self.file(self.path("out"), "run.lock").decode())
        for more in (("--twice",), ()):
            answer = rhegma(scene, *more, "--quiet", "--output", self.path("out"))
            self.assertEqual(answer.status, 1, answer)
            self.assert_messages(answer.messages, [("", ["in use by another run", f"process {run.pid} on ", " UTC", "--output"])])
        self.assertIsNone(run.poll())
        run.kill()
        run.wait(PATIENCE)
        # The lock of a dead run does not count.
        self.pair()
        self.assertFalse(self.has("out", "run.lock"))

    def test_a_run_in_the_folder_of_half_the_cells(self):
        scene = self.write("scene.xml", plate().set("Time > Final Time", 10.0).text())
        run = self.start(scene, "--output", self.path("out", "half"), "--quiet")
        self.addCleanup(run.kill)
        self.wait_for(run, self.path("out", "half", "manifest.json"))
        answer = rhegma(scene, "--twice", "--quiet", "--output", self.path("out"))
        self.assertEqual(answer.status, 1, answer)
        self.assert_messages(answer.messages, [("", ["out/half is in use by another run", f"process {run.pid} on "])])
        self.assertFalse(self.has("out", "as_is"))
        self.assertIsNone(run.poll())
        run.kill()
        run.wait(PATIENCE)


if __name__ == "__main__":
    unittest.main()
