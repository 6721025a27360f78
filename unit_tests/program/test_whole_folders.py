#!/usr/bin/env python3
"""What a run leaves is lost or wrong only where somebody is told.

RHEGMA_SEED in the environment is the seed (else one of the clock; it is printed). RHEGMA_FULL=1 takes 200 flips of bits
in each kind of file in place of 25, and 100,000 bodies in place of 4,000.
test_killed_runs.py kills runs, and test_full_disk.py fills disks; both look at what is left with the same tool.
"""

import fcntl
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import numpy  # noqa: E402
from program import PROGRAM, SOURCE, environment, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT  # noqa: E402
from restart_case import RestartTest, scene  # noqa: E402
from scenes import plate  # noqa: E402

sys.path.insert(0, os.path.join(SOURCE, "tools"))
from rhegma_tools.whole_folder import check_folder  # noqa: E402

FULL = os.environ.get("RHEGMA_FULL") == "1"
FLIPS = 200 if FULL else 25
SEED = int(os.environ.get("RHEGMA_SEED", time.time_ns() % 10**9))
CHECK = os.path.join(SOURCE, "tools", "rhegma-check")
FOREVER = 1e3


def check_tool(folder):
    result = subprocess.run([sys.executable, CHECK, folder], capture_output=True, text=True)
    return result.returncode, result.stdout, result.stderr


class OneRun(RestartTest):
    """One run a folder."""

    def start_long(self, folder):
        path = self.write("scene.xml", plate().set("Time > Final Time", FOREVER).text())
        run = self.start(path, "--output", folder, "--quiet")
        self.addCleanup(run.kill)
        self.wait_for(run, os.path.join(folder, "manifest.json"))
        return path, run

    def test_second_run_is_refused_and_a_dead_one_is_not_waited_for(self):
        folder = self.path("out")
        path, run = self.start_long(folder)
        ranks = {"launcher": (*LAUNCHER, "-np", "2"), **ROOT}
        for again in (rhegma(path, "--output", folder), rhegma(path, "--output", folder, **ranks)):
            self.assertEqual(again.status, 1, again)
            line = [line for line in again.messages.splitlines() if line.startswith("rhegma: ")]
            self.assertEqual(len(line), 1, again)
            for word in ("in use by another run", f"process {run.pid} on ", " UTC", "wait", "--output"):
                self.assertIn(word, line[0])
        self.assertEqual(check_tool(folder)[0], 2)
        self.assertIsNone(run.poll())
        run.kill()
        run.wait(60)
        status, output, _ = check_tool(folder)
        self.assertEqual(status, 2)
        self.assertIn("was cut off", output)
        self.run_to_its_end(self.write("short.xml", scene().text()), folder)
        self.assertEqual(check_tool(folder)[0], 0)
        self.assertFalse(os.path.exists(os.path.join(folder, "run.lock")))

    def test_reader_of_fields_does_not_stop_the_run(self):
        """HDF5 locks a file that is read, as h5py and ParaView have it open."""
        folder = self.path("out")
        content = plate().set("Time > Final Time", 10.0).set("Output", {"Field Interval": 2e-4})
        run = self.start(self.write("scene.xml", content.text()), "--output", folder, "--quiet")
        self.addCleanup(run.kill)
        path = os.path.join(folder, "fields.h5")
        self.wait_for(run, path)
        self.wait_for_size(run, path, 1e6)  # a frame, so that what follows is more than the rest of one
        with open(path, "rb") as file:
            fcntl.flock(file, fcntl.LOCK_SH)
            wanted = 4 * os.path.getsize(path)
            self.wait_for_size(run, path, wanted)
            self.assertIsNone(run.poll(), "the run has ended")
            self.assertGreater(os.path.getsize(path), wanted)

    def wait_for_size(self, run, path, size):
        end = time.monotonic() + 60
        while os.path.getsize(path) <= size and run.poll() is None and time.monotonic() < end:
            time.sleep(0.01)

    def test_run_of_another_machine(self):
        folder = self.path("out")
        path = self.write("scene.xml", scene().text())
        lock = os.path.join(folder, "run.lock")
        os.makedirs(folder)
        with open(lock, "w") as file:
            file.write("host: elsewhere\nprocess: 1\nstarted: 2020-01-01 00:00:00 UTC\n")
        answer = rhegma(path, "--output", folder)
        self.assertEqual(answer.status, 1, answer)
        self.assert_messages(answer.messages, [("", ["process 1 on elsewhere", "remove " + lock, "--output"])])
        os.remove(lock)
        self.run_to_its_end(path, folder)

    def test_reader_that_goes(self):
        path = self.write("scene.xml", scene().text())
        self.run_to_its_end(path, self.path("whole"))
        run = subprocess.Popen([PROGRAM, path, "--output", self.path("out")], stdout=subprocess.PIPE, env=environment())
        run.stdout.readline()
        run.stdout.close()
        self.assertEqual(run.wait(60), 0)
        for name in ("history.csv", "fields.xdmf"):
            self.assertEqual(self.file(self.path("out"), name), self.file(self.path("whole"), name))
        self.assertEqual(check_tool(self.path("out"))[0], 0)

    def test_folder_that_is_not_to_be_written(self):
        path = self.write("scene.xml", scene().text())
        folder = "/proc/rhegma" if os.geteuid() == 0 else self.path("locked")
        if os.geteuid() != 0:
            os.makedirs(folder, mode=0o555)
        answer = rhegma(path, "--output", folder)
        self.assertEqual(answer.status, 1, answer)
        self.assert_messages(answer.messages, [("", [folder, "can't be used", "--output"])])


class Foreign(RestartTest):
    """Files that no run wrote are not replaced."""

    def refuses(self, name, content, word):
        path = self.write("scene.xml", scene().text())
        os.makedirs(self.path("out"), exist_ok=True)
        self.write(os.path.join("out", name), content)
        self.assert_refused([path, "--output", self.path("out")], [("", [name, word, "--output"])])
        os.remove(self.path("out", name))

    def test_files_of_the_user(self):
        for name in ("history.csv", "summary.json", "fields.h5", "fields.xdmf", "checkpoint.h5", "manifest.json", "run.lock"):
            self.refuses(name, "notes of my own\n", "no run wrote")

    def test_scene_in_the_place_of_a_result(self):
        path = self.write("summary.json", scene().text())
        self.assert_refused([path, "--output", self.folder], [("", ["own scene", "summary.json", "--output"])])


class Flips(RestartTest):
    """A flip of one bit that changes a number is found."""

    def whole_run(self):
        path = self.write("scene.xml", scene(**{"Checkpoint Interval": 1e-3}).text())
        self.run_to_its_end(path, self.path("out"))
        self.assertEqual(check_tool(self.path("out")), (0, *check_tool(self.path("out"))[1:2], ""))
        return path

    def contents(self, folder):
        try:
            return self.fields(folder)
        except (OSError, RuntimeError, KeyError, ValueError, TypeError):
            return None

    def same(self, found, before):
        return found is not None and sorted(found) == sorted(before) and all(
            numpy.array_equal(table, before[name]) for name, table in found.items()
        )

    def test_flips(self):
        print(f"seed {SEED}", file=sys.stderr)
        generator = random.Random(SEED)
        scene_path = self.whole_run()
        folder = self.path("out")
        before = self.fields(folder)
        counts = {}
        for name in ("fields.h5", "checkpoint.h5", "history.csv", "summary.json", "fields.xdmf", "manifest.json", "scene"):
            path = scene_path if name == "scene" else os.path.join(folder, name)
            with open(path, "rb") as file:
                content = file.read()
            found = idle = 0
            for _ in range(FLIPS):
                bit = generator.randrange(8 * len(content))
                damaged = bytearray(content)
                damaged[bit // 8] ^= 1 << bit % 8
                with open(path, "wb") as file:
                    file.write(damaged)
                if check_folder(folder).faults:
                    found += 1
                else:
                    idle += 1
                    self.assertEqual(name, "fields.h5", f"seed {SEED}: bit {bit} of {name} is missed")
                    # Room between tables, which nobody reads.
                    self.assertTrue(self.same(self.contents(folder), before), f"seed {SEED}: bit {bit} of {name}")
            with open(path, "wb") as file:
                file.write(content)
            counts[name] = (found, idle)
        self.assertEqual(check_folder(folder).faults, [])
        self.assertGreater(counts["fields.h5"][0], FLIPS // 2, counts)
        print(f"flips found, without effect: {counts}", file=sys.stderr)

    def test_restart_names_the_frame(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        path = os.path.join(self.path("out"), "fields.h5")
        tables = self.fields(self.path("out"))
        content = bytearray(self.file(self.path("out"), "fields.h5"))
        at = content.find(tables["t00000/particles/position"].tobytes()[:64])
        self.assertGreater(at, 0)
        content[at + 8] ^= 1
        with open(path, "wb") as file:
            file.write(content)
        self.assertIn("t00000", check_tool(self.path("out"))[2])
        answer = rhegma(self.path("scene.xml"), "--output", self.path("out"), "--quiet", "--restart", checkpoint)
        self.assertEqual(answer.status, 0, answer)
        self.assert_messages(answer.messages, [("warning", ["fields.h5", "damage in t00000", "fields.unread.h5"])])

    def test_missing_files(self):
        self.whole_run()
        for name in ("fields.h5", "history.csv", "summary.json", "fields.xdmf", "checkpoint.h5"):
            aside = self.path("aside")
            shutil.move(self.path("out", name), aside)
            self.assertIn(f"{name} is missing", check_tool(self.path("out"))[2])
            shutil.move(aside, self.path("out", name))


class Many(RestartTest):
    """Scenes with many things."""

    def many(self, count, **different):
        side = int(count**0.5) + 1
        big = plate().remove("Cracks").remove("Energy Release").remove("Boundaries").remove("Bodies")
        big.set("Domain > Lower Corner", [-1.0, -1.0]).set("Domain > Upper Corner", [side + 1.0, side + 1.0])
        big.set("Domain > Cell Size", 0.5).set("Domain > Shape Functions", "Linear")
        body = {"Material": "Polymer", "Shape": "Box", "Particles Per Cell": 1, **different}
        big.set("Bodies", {
            f"Body {k}": {"Lower Corner": [k % side + 0.0, k // side + 0.0],
                          "Upper Corner": [k % side + 0.5, k // side + 0.5], **body}
            for k in range(count)
        })
        return self.write("many.xml", big.text())

    def test_many_bodies(self):
        count = 100_000 if FULL else 4_000
        path = self.many(count)
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        answer = rhegma(path, "--check", timeout=600)
        now = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = now.ru_utime + now.ru_stime - used.ru_utime - used.ru_stime
        self.assertEqual(answer.status, 0, answer.messages[:2000])
        print(f"{count} bodies: {seconds:.2f} s of the processor", file=sys.stderr)
        self.assertLess(seconds, 1e-3 * count)  # a look at all pairs takes 2.5e-3 a body at 4,000

    def test_a_thousand_errors(self):
        answer = rhegma(self.many(1000, Material="Polymr"), "--check", timeout=600)
        self.assertEqual(answer.status, 1)
        lines = answer.messages.splitlines()
        self.assertEqual(len(lines), 11, answer.messages[:2000])
        self.assertIn("and 990 more like: Bodies > Body 0 > Material: ", lines[-1])

    def test_unknown_attributes(self):
        text = plate().text().replace('<Parameter name="Final Time"', '<Parameter nmae="x" name="Final Time"')
        self.write("scene.xml", text.replace('<ParameterList name="Time"', '<ParameterList name="Time" when="now"'))
        self.assert_refused(["scene.xml"], [("Time", ["line 1", '"when"']),
                                            ("Time > Final Time", ["line 1", '"nmae"', 'did you mean "name"?'])])
        again = plate().text().replace('name="Final Time"', 'name="Final Time" type="int"')
        self.write("scene.xml", again)
        answer = rhegma("scene.xml", "--check", cwd=self.folder)
        self.assertEqual(answer.status, 1, answer)

    def test_number_in_the_place_of_a_function(self):
        changed = plate().set("Boundaries > Pull > History", 0.5)
        self.assertEqual(rhegma(self.write("scene.xml", changed.text()), "--check").status, 0)


if __name__ == "__main__":
    assert signal.SIGKILL and os.path.exists(PROGRAM), PROGRAM
    unittest.main()
