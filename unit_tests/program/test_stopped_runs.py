#!/usr/bin/env python3
"""Runs that can't go on, and runs that are stopped from outside: what they say and what they leave.

RHEGMA_KILLS in the environment is how many runs are killed (8 where it is not set).
"""

import csv
import json
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
from program import NOISE, PATIENCE, PROGRAM, ProgramTest, environment, rhegma  # noqa: E402
from scenes import Scene, plate  # noqa: E402

KILLS = int(os.environ.get("RHEGMA_KILLS", "8"))
FOREVER = 10.0  # [s], of which the plate takes a few 1e-5 a step


def lasting():
    """The plate for a long time, held, so that the load does not throw it away."""
    wall = {"Type": "Symmetry", "Axis": "x", "Position": 0.0}
    return plate().set("Time > Final Time", FOREVER).set("Boundaries > Wall", wall)


def block(**more):
    """A square of rubber in a large domain."""
    return Scene(
        {
            "Domain": {
                "Dimension": 2,
                "Lower Corner": [0.0, 0.0],
                "Upper Corner": [1.0, 1.0],
                "Cell Size": 0.05,
            },
            "Time": {"Final Time": 0.5},
            "Materials": {
                "Rubber": {
                    "Model": "Neo-Hookean",
                    "Density": 1000.0,
                    "Young Modulus": 1e6,
                    "Poisson Ratio": 0.3,
                }
            },
            "Bodies": {
                "Block": {
                    "Material": "Rubber",
                    "Shape": "Box",
                    "Lower Corner": [0.4, 0.4],
                    "Upper Corner": [0.6, 0.6],
                    **more,
                }
            },
            "Output": {"History Interval": 1e-3, "Field Interval": 1e-2},
        }
    )


class LeftFiles(ProgramTest):
    def rows(self, folder):
        """The history, of which every row must be whole and of numbers."""
        with open(os.path.join(folder, "history.csv"), newline="") as file:
            text = file.read()
        if not text:
            return []
        self.assertTrue(text.endswith("\n"), "last row is incomplete: " + text[-80:])
        head, *rows = csv.reader(text.splitlines())
        for row in rows:
            self.assertEqual(len(row), len(head), row)
        table = [[float(value) for value in row] for row in rows]
        times = [row[0] for row in table]
        self.assertEqual(times, sorted(set(times)))
        return [dict(zip(head, row)) for row in table]

    def snapshots(self, folder):
        """Times of the fields, each of which must be readable to its last number; none without a file."""
        path = os.path.join(folder, "fields.h5")
        if not os.path.exists(path):
            return []
        times = []
        with h5py.File(path, "r") as file:
            for name in file:
                particles = file[name]["particles"]
                for data in particles.values():
                    data[()]
                times.append(float(file[name].attrs["time"]))
        return times

    def summary(self, folder):
        with open(os.path.join(folder, "summary.json")) as file:
            return json.load(file)


class UnstableRuns(LeftFiles):
    def stops(self, scene, *words):
        """Exit status 2; the reason, the time and the step on stderr and in the summary; readable files."""
        path = self.write("scene.xml", scene.set("Time > Retries", 0).text())
        answer = rhegma(path, "--quiet")
        self.assertEqual(answer.status, 2, answer)
        self.assertEqual(answer.output, "")
        # These scenes are wrong on purpose, so that some also get a warning.
        reason = "".join(l for l in answer.messages.splitlines(True) if not l.startswith("rhegma: warning"))
        self.assert_messages(reason, [("", words)])
        found = re.match(r"rhegma: the run stopped at t = (\S+) ([mun]?)s, step (\d+): (.+)\n\Z", reason)
        self.assertTrue(found, answer.messages)
        summary = self.summary(self.path("scene.out"))
        self.assertEqual(summary["status"], reason[len("rhegma: ") :].strip())
        time = float(found.group(1)) * {"": 1.0, "m": 1e-3, "u": 1e-6, "n": 1e-9}[found.group(2)]
        self.assertAlmostEqual(summary["time"], time, delta=1e-3 * abs(summary["time"]) + 1e-12)
        self.assertEqual(summary["steps"], int(found.group(3)))
        self.assertLess(summary["time"], scene_end(scene))
        rows = self.rows(self.path("scene.out"))
        for row in rows:
            self.assertLessEqual(row["time"], summary["time"])
            self.assertTrue(all(math.isfinite(value) for value in row.values()), row)
        self.assertGreater(len(rows), 0)
        self.assertGreater(len(self.snapshots(self.path("scene.out"))), 0)

    def test_particle_that_leaves_the_domain(self):
        self.stops(block(Velocity=[3.0, 0.0]), "left the domain", "Domain > Lower Corner")

    def test_body_force_that_blows_up(self):
        scene = block().set(
            "Boundaries",
            {"Blast": {"Type": "Gravity", "Acceleration": [1.0, 0.3], "History": "exp(1e3 * t) * sin(4e2 * t)"}},
        )
        self.stops(scene, "a particle")  # inverted or gone, whichever comes first

    def test_rubber_that_is_turned_inside_out(self):
        """Two walls that shut at once, further in a step than they are apart."""
        scene = block().set("Boundaries", {"Left": wall(0.0, 0.45, 1.0), "Right": wall(0.55, 1.0, -1.0)})
        self.stops(scene, "negative volume", "Time > CFL")

    def test_a_body_that_is_cooled_below_absolute_zero(self):
        scene = block().set("Materials > Rubber > Specific Heat", 1000.0)
        drain = {"Type": "Box", "Lower Corner": [0.4, 0.4], "Upper Corner": [0.5, 0.5], "Power Density": -1e10}
        scene.set("Thermal", {"Initial Temperature": 300.0, "Sources": {"Drain": drain}})
        scene.set("Output > History Interval", 0.25)
        self.stops(scene, "K, and it is absolute", "sources")

    def test_small_steps_are_named_where_they_may_be_the_cause(self):
        scene = block().set("Boundaries", {"Left": wall(0.0, 0.45, 1.0), "Right": wall(0.55, 1.0, -1.0)})
        scene.set("Adaptivity", {"Velocity Change": 1.0}).set("Sub-Cycling", {"Levels": 1})
        self.stops(scene, "negative volume", "Time > CFL", "Sub-Cycling > Levels")

    def test_step_at_the_limit_with_stresses_updated_last(self):
        """CFL 1 is allowed; with USL, which is unstable where nodes are light, a loaded plate does not bear it."""
        scene = plate().remove("Cracks").remove("Energy Release")
        scene.set("Domain > Shape Functions", "Linear").set("Time > CFL", 1.0).set("Time > Update Scheme", "USL")
        scene.set("Bodies > Plate > Lower Corner", [0.02, 0.02]).set("Bodies > Plate > Rotation", 20.0)
        scene.remove("Boundaries").set("Bodies > Plate > Velocity", [5.0, 3.0])
        scene.set("Bodies > Plate > Angular Velocity", [40.0]).set("Domain > Upper Corner", [1.6, 1.6])
        scene.set("Domain > Lower Corner", [-0.6, -0.6]).set("Time > Final Time", 0.05)
        scene.set("Output", {"History Interval": 1e-5, "Field Interval": 1e-4})
        self.stops(scene, "step")

    def test_mass_matrix_that_is_not_solved(self):
        """It stops in the first step, before any sample."""
        path = self.write("scene.xml", plate().set("Mass Matrix", {"Type": "Full", "Maximum Iterations": 1}).text())
        answer = rhegma(path, "--quiet")
        self.assertEqual(answer.status, 2, answer)
        self.assertRegex(answer.messages, r"mass matrix could not be solved .* residual")

    def test_mass_matrix_that_is_singular(self):
        """Boxes of GIMP in rows along the cells give fewer equations than there are nodes."""
        scene = plate().set("Domain > Shape Functions", "GIMP")
        scene.set("Mass Matrix", {"Type": "Full", "Lumped Fraction": 0.0, "Minimum Node Mass": 0.0})
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 2, answer)
        self.assertRegex(answer.messages, r"mass matrix could not be solved .* it is singular.* Lumped Fraction")

    def test_load_that_loses_its_body(self):
        """A point load tears its particle off."""
        scene = block().set(
            "Boundaries",
            {"Tear": {"Type": "Point Load", "Body": "Block", "Point": [0.6, 0.6], "Force": [3e5, 2e5]}},
        )
        self.stops(scene.set("Output", {"History Interval": 1e-5, "Field Interval": 1e-4}), "")


def wall(lower, upper, direction):
    """Nodes that move at 0.1 m/s, and from 10 ms on at 300 m/s."""
    return {
        "Type": "Velocity", "Box Motion": "Fixed",
        "Lower Corner": [lower, 0.0],
        "Upper Corner": [upper, 1.0],
        "Components": "x",
        "Value": [direction, 0.0],
        "History": "t > 1e-2 ? 300 : 0.1",
    }


def scene_end(scene):
    return float(scene.find("Time > Final Time").get("value"))


class StoppedFromOutside(LeftFiles):
    def scene(self):
        """The plate for so long that nobody waits for its end, with fields all the time."""
        scene = lasting()
        return scene.set("Output", {"History Interval": 1e-4, "Field Interval": 2e-4})

    def start(self, folder):
        path = self.write("scene.xml", self.scene().text())
        self.begun = os.stat(path).st_mtime_ns
        run = subprocess.Popen(
            [PROGRAM, path, "--output", folder],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=environment(),
        )
        self.addCleanup(run.stdout.close)
        self.addCleanup(run.stderr.close)
        return run

    def wait_for_fields(self, run, folder, seconds=PATIENCE):
        """Until the run has written a few fields, which no older run has."""
        guide = os.path.join(folder, "fields.xdmf")
        end = time.monotonic() + seconds
        while time.monotonic() < end and run.poll() is None:
            if os.path.exists(guide) and os.stat(guide).st_mtime_ns > self.begun and os.path.getsize(guide) > 2000:
                return
            time.sleep(0.02)
        run.kill()
        self.fail("no fields: " + run.stderr.read().decode())

    def run_again(self, folder):
        """A second run into the same folder leaves what one into a new folder does."""
        path = self.write("short.xml", plate().text())
        for target in (folder, self.path("new")):
            answer = rhegma(path, "--output", target, "--quiet")
            self.assertEqual((answer.status, answer.messages), (0, ""), answer)
        self.assertEqual(sorted(os.listdir(folder)), sorted(os.listdir(self.path("new"))))
        self.assertEqual(self.rows(folder), self.rows(self.path("new")))
        self.assertEqual(self.snapshots(folder), self.snapshots(self.path("new")))
        self.assertEqual(self.summary(folder)["status"], "finished")

    def asked(self, number, name):
        folder = self.path("out")
        run = self.start(folder)
        self.wait_for_fields(run, folder)
        run.send_signal(number)
        run.wait(PATIENCE)
        messages = run.stderr.read().decode()
        self.assertEqual(run.returncode, 2, messages)
        self.assert_messages(messages, [("", ["stopped by " + name, "at t =", "step"])])
        self.assertIn("Results up to then are in " + folder, run.stdout.read().decode())
        summary = self.summary(folder)
        self.assertIn("stopped by " + name, summary["status"])
        self.assertLess(summary["time"], FOREVER)
        self.assertGreater(len(self.rows(folder)), 0)
        # The last fields are those of the moment at which it stopped.
        self.assertEqual(max(self.snapshots(folder)), summary["time"])
        self.run_again(folder)

    def test_terminate(self):
        self.asked(signal.SIGTERM, "SIGTERM")

    def test_interrupt(self):
        self.asked(signal.SIGINT, "SIGINT")

    def test_hang_up(self):
        self.asked(signal.SIGHUP, "SIGHUP")

    def test_kill_at_any_time(self):
        """No handler sees SIGKILL, and it may come in the middle of a file."""
        for k in range(KILLS):
            with self.subTest(k=k):
                folder = self.path(f"out{k % 8}")
                run = self.start(folder)
                self.wait_for_fields(run, folder)
                time.sleep(0.013 * (k % 8) + 0.0013 * (k // 8 % 10))
                run.kill()
                run.wait(PATIENCE)
                self.assertEqual(run.returncode, -signal.SIGKILL)
                self.rows(folder)
                self.assertGreater(len(self.snapshots(folder)), 0)
                self.assertFalse(os.path.exists(os.path.join(folder, "summary.json")), "there was no end to sum up")
        self.run_again(self.path("out0"))

    def test_an_older_summary_does_not_outlive_a_killed_run(self):
        folder = self.path("out")
        answer = rhegma(self.write("short.xml", plate().text()), "--output", folder, "--quiet")
        self.assertEqual(answer.status, 0, answer)
        self.assertTrue(os.path.exists(os.path.join(folder, "summary.json")))
        run = self.start(folder)
        self.wait_for_fields(run, folder)
        run.kill()
        run.wait(PATIENCE)
        self.assertFalse(os.path.exists(os.path.join(folder, "summary.json")))


def small_files():
    """The program may write no file larger than this; it gets the error of a full disk."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (200_000, 200_000))


class FullDisk(LeftFiles):
    def scene(self):
        scene = lasting()
        return self.write("scene.xml", scene.set("Output", {"History Interval": 1e-4, "Field Interval": 1e-3}).text())

    def reports(self, answer, folder):
        self.assertEqual(answer.status, 2, answer)
        self.assert_messages(answer.messages, [("", ["at t =", "step", "can't be written", folder])])

    def test_file_that_may_not_grow(self):
        answer = rhegma(self.scene(), "--output", self.path("out"), "--quiet", preexec=small_files)
        self.reports(answer, self.path("out"))
        self.rows(self.path("out"))
        self.assertIn("can't be written", self.summary(self.path("out"))["status"])
        for noise in NOISE:
            self.assertNotIn(noise, answer.messages)

    def test_history_that_may_not_grow(self):
        path = self.write(
            "scene.xml",
            # Without its crack, whose faces may overlap when the run stops, of which there is a warning too.
            lasting().remove("Cracks").remove("Energy Release")
            .set("Output", {"History Interval": 1e-6, "Fields": False}).text(),
        )
        answer = rhegma(path, "--output", self.path("out"), "--quiet", preexec=small_files)
        self.reports(answer, self.path("out"))
        self.assertIn("history.csv", answer.messages)
        self.assertGreater(len(self.rows(self.path("out"))), 100)

    def test_full_disk(self):
        disk = self.path("disk")
        os.mkdir(disk)
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1m", "rhegma-test", disk], capture_output=True)
        if mounted.returncode != 0:
            self.skipTest("only root can mount a small disk here: " + mounted.stderr.decode().strip())
        self.addCleanup(subprocess.run, ["umount", disk], check=True)
        answer = rhegma(self.scene(), "--output", os.path.join(disk, "out"), "--quiet")
        self.reports(answer, disk)
        self.rows(os.path.join(disk, "out"))
        for leftover in os.listdir(os.path.join(disk, "out")):
            self.assertFalse(leftover.endswith(".part"), leftover)


if __name__ == "__main__":
    assert shutil.which(PROGRAM) or os.path.exists(PROGRAM), PROGRAM
    unittest.main()
