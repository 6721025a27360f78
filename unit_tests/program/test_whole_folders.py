#!/usr/bin/env python3
"""What a run leaves is lost or wrong only where somebody is told.

RHEGMA_BODIES in the environment is how many bodies and cracks large scenes have (4000 where it is not set).
test_killed_runs.py kills runs, test_flipped_bits.py flips bits, and test_full_disk.py fills disks; all look at what is left
with the same tool.
"""

import csv
import fcntl
import json
import os
import signal
import subprocess
import sys
import time
import unittest
from xml.etree import ElementTree

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
from program import PATIENCE, PROGRAM, SOURCE, environment, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT  # noqa: E402
from restart_case import RestartTest, scene  # noqa: E402
from scenes import many_bodies, many_cracks, plate  # noqa: E402

sys.path.insert(0, os.path.join(SOURCE, "tools"))
from rhegma_tools.whole_folder import is_running  # noqa: E402

BODIES = int(os.environ.get("RHEGMA_BODIES", "4000"))
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
        run.wait(PATIENCE)
        status, output, _ = check_tool(folder)
        self.assertEqual(status, 2)
        self.assertIn("was cut off", output)
        self.run_to_its_end(self.write("short.xml", scene().text()), folder)
        status, output, _ = check_tool(folder)
        self.assertEqual(status, 0)
        self.assertRegex(output, r"^The run finished at t = \S+ s after \d+ steps\.\n")
        self.assertFalse(os.path.exists(os.path.join(folder, "run.lock")))

    def test_a_run_that_a_signal_stops_is_whole_and_not_at_its_end(self):
        """Its last row, frame and summary are of one time; what goes on from its checkpoint is the run that was not stopped. A load step
        is stopped before its end, so that its summary is of its begin, and the last row is earlier."""
        static = plate().set("Time > Final Time", FOREVER).set("Time > Analysis", "Quasi-Static").set("Time > Load Steps", 10**6)
        wall = {"Type": "Symmetry", "Axis": "x", "Position": 0.0}
        static.set("Time > Rigid Modes", "Remove").set("Boundaries > Wall", wall)
        for name, content in (("moving", plate().set("Time > Final Time", FOREVER)), ("static", static)):
            with self.subTest(name):
                folder = self.path(name)
                run = self.start(self.write(f"{name}.xml", content.text()), "--output", folder, "--quiet")
                self.addCleanup(run.kill)
                self.wait_for(run, os.path.join(folder, "manifest.json"))
                if name == "static":
                    time.sleep(3.0)  # of which load steps take tens of milliseconds
                run.send_signal(signal.SIGINT)
                self.assertEqual(run.wait(PATIENCE), 2)
                status, output, messages = check_tool(folder)
                self.assertEqual(status, 2, output + messages)
                self.assertRegex(output, "^The run was stopped by SIGINT " + ("at" if name == "moving" else r"(at|within .* from)") + " t = ")
                self.assertIn(f"All files in {folder} are undamaged so far.", output)
                self.assertIn(f"--output {folder} --restart {folder}/checkpoint.h5 continues from", output)
                with open(os.path.join(folder, "history.csv"), encoding="utf-8") as file:
                    rows = file.read().splitlines()[1:]
                if name == "static":
                    continue
                last = float(rows[-1].split(",")[0])
                with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
                    self.assertEqual(last, json.load(file)["time"])
                with h5py.File(os.path.join(folder, "fields.h5")) as fields:
                    self.assertEqual(float(fields[max(fields)].attrs["time"]), last)

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
            largest = self.wait_for_size(run, path, wanted)
            self.assertIsNone(run.poll(), "the run has ended")
            self.assertGreater(largest, wanted)

    def wait_for_size(self, run, path, size):
        """The first size beyond `size` that is seen: HDF5 cuts the file again to what is in it when a frame is whole."""
        end = time.monotonic() + PATIENCE
        while (now := os.path.getsize(path)) <= size and run.poll() is None and time.monotonic() < end:
            time.sleep(0.01)
        return now

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

    def message_of(self, run):
        self.assertEqual(run.wait(PATIENCE), 2)
        lines = [line for line in run.stderr.read().decode().splitlines() if not line.startswith("rhegma: warning: ")]
        self.assertEqual(len(lines), 1, lines)
        return lines[0]

    def test_a_run_leaves_a_folder_that_another_has_taken(self):
        folder = self.path("out")
        path, first = self.start_long(folder)
        first.send_signal(signal.SIGSTOP)  # so that it does not look while there is no lock
        os.remove(os.path.join(folder, "run.lock"))
        second = self.start(path, "--output", folder, "--quiet")
        self.addCleanup(second.kill)
        self.wait_for(second, os.path.join(folder, "run.lock"))
        first.send_signal(signal.SIGCONT)
        message = self.message_of(first)
        for word in (f"process {first.pid} on ", f"process {second.pid} on ", "another run", folder):
            self.assertIn(word, message)
        self.assertNotIn("--restart", message)
        self.assertIsNone(second.poll())
        self.assertIs(is_running(folder), True)
        self.assertFalse(os.path.exists(os.path.join(folder, "summary.json")))
        second.send_signal(signal.SIGTERM)
        self.assertIn("continues from", self.message_of(second))
        self.assertEqual(check_tool(folder)[0], 2)
        self.assertFalse(os.path.exists(os.path.join(folder, "run.lock")))

    def test_a_run_whose_lock_is_removed_stops_with_its_files(self):
        folder = self.path("out")
        _, run = self.start_long(folder)
        os.remove(os.path.join(folder, "run.lock"))
        message = self.message_of(run)
        for word in (f"process {run.pid} on ", "run.lock", "was removed during the run", f"--restart {folder}/checkpoint.h5"):
            self.assertIn(word, message)
        status, output, messages = check_tool(folder)
        self.assertEqual((status, messages), (2, ""))
        self.assertTrue(output.startswith("The run stopped at t = "), output)
        self.assertFalse(os.path.exists(os.path.join(folder, "run.lock")))

    def test_a_history_that_another_program_touches_is_reported(self):
        def append(path):
            with open(path, "a", encoding="utf-8") as file:
                file.write("0\n" * 10**6)  # more than the rows to come, which replace what is appended

        for name, change, word in (("removed", os.remove, "removed"), ("changed", append, "changed")):
            folder = self.path(name)
            _, run = self.start_long(folder)
            change(os.path.join(folder, "history.csv"))
            run.send_signal(signal.SIGTERM)
            message = self.message_of(run)
            self.assertIn(f"history.csv was {word} by another program during the run, so rows are missing", message)

    def test_no_comparison_in_a_folder_that_another_has_taken(self):
        folder, other = self.path("out"), "host: elsewhere\nprocess: 7\nstarted: 2020-01-01 00:00:00 UTC\n"
        run = self.start(self.write("scene.xml", scene().text()), "--output", folder, "--quiet", "--twice")
        self.addCleanup(run.kill)
        self.wait_for(run, os.path.join(folder, "as_is", "manifest.json"))
        os.remove(os.path.join(folder, "run.lock"))
        self.write(os.path.join(folder, "run.lock"), other)
        message = self.message_of(run)
        for word in ("there is no comparison: ", "process 7 on elsewhere", f"process {run.pid} on "):
            self.assertIn(word, message)
        self.assertFalse(os.path.exists(os.path.join(folder, "twice.json")))
        self.assertEqual(self.file(folder, "run.lock").decode(), other)

    def test_who_asks_refuses_no_run(self):
        """rhegma-check, and a run that looks whether its folder is free, share the lock for a moment."""
        folder = self.path("out")
        os.makedirs(folder)
        with open(os.path.join(folder, "run.lock"), "w+") as file:
            fcntl.flock(file, fcntl.LOCK_SH)
            self.assertIs(is_running(folder), False)
            path = self.write("scene.xml", scene().text())
            run = self.start(path, "--output", folder, "--quiet")
            self.addCleanup(run.kill)
            time.sleep(0.5)  # it is there by then, and waits for this
            fcntl.flock(file, fcntl.LOCK_UN)
        self.assertEqual(run.wait(PATIENCE), 0, run.stderr.read().decode())
        self.assertIsNone(is_running(folder))

    def test_a_run_starts_while_many_ask(self):
        """Starts of runs among looks without a pause."""
        folder = self.path("out")
        path = self.write("scene.xml", plate().set("Time > Final Time", 1e-5).text())
        looks = 0
        for _ in range(5):
            run = self.start(path, "--output", folder, "--quiet")
            self.addCleanup(run.kill)
            while run.poll() is None:
                looks += is_running(folder) is not None
            self.assertEqual(run.returncode, 0, run.stderr.read().decode())
        self.assertGreater(looks, 0)

    def test_reader_that_goes(self):
        path = self.write("scene.xml", scene().text())
        self.run_to_its_end(path, self.path("whole"))
        run = subprocess.Popen([PROGRAM, path, "--output", self.path("out")], stdout=subprocess.PIPE, env=environment())
        run.stdout.readline()
        run.stdout.close()
        self.assertEqual(run.wait(PATIENCE), 0)
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

    def test_table_of_the_user(self):
        """It begins with the time, as a history does."""
        self.refuses("history.csv", "time,temperature\n0,293\n", "no run wrote")

    def test_hdf5_of_the_user(self):
        """With other content, or such as HDF5 does not open."""
        path = self.path("users.h5")
        with h5py.File(path, "w") as file:
            file["temperature"] = [293.0]
        with open(path, "rb") as file:
            content = file.read()
        os.remove(path)
        self.refuses("fields.h5", content, "no run wrote")
        self.refuses("fields.h5", content[:40], "no run wrote")

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


class Names(RestartTest):
    """Names in UTF-8 are the same in all that a run leaves, and in what the tools make of it."""

    def test_names_beyond_ascii(self):
        body, crack, load = "Tr\u00e4ger \u00b5", "\u88c2\u7f1d", "Zug \u2192 \U0001f600"
        text = plate().set("Time > Maximum Steps", 20).text()
        for old, new in (("Plate", body), ("Notch", crack), ("Pull", load)):
            text = text.replace(f'"{old}"', f'"{new}"')
        folder = self.path("out")
        answer = rhegma(self.write("scene.xml", text), "--output", folder)
        self.assertEqual(answer.status, 0, answer)
        self.assertIn(f"crack {crack}, front 0", answer.output)
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        self.assertEqual([entry["name"] for kind in ("bodies", "cracks", "boundaries") for entry in summary[kind]],
                         [body, crack, load])
        with open(os.path.join(folder, "history.csv"), encoding="utf-8", newline="") as file:
            columns = next(csv.reader(file))
        for column in (f"{crack}.0.G_J", f"{crack}.opening", f"{load}.force_x"):
            self.assertIn(column, columns)
        with open(os.path.join(folder, "fields.xdmf"), encoding="utf-8") as file:
            ElementTree.parse(file)
        status, output, messages = check_tool(folder)
        self.assertEqual((status, messages), (0, ""), output)
        plain = dict(os.environ, LC_ALL="C", PYTHONIOENCODING="")
        for tool in ("rhegma-check", "rhegma-plot"):
            result = subprocess.run([sys.executable, os.path.join(SOURCE, "tools", tool), folder], capture_output=True, env=plain)
            self.assertEqual(result.returncode, 0, result.stderr.decode(errors="replace"))
        checked = rhegma(self.path("scene.xml"), "--check")
        self.assertEqual(checked.status, 0, checked)
        self.assertIn(f"Bodies > {body}: mass", checked.output)
        wrong = rhegma(self.path("scene.xml"), "--check", "--set", f"Bodies:{body}:Material=none")
        self.assertEqual(wrong.status, 1, wrong)
        self.assert_messages(wrong.messages, [(f"Bodies > {body} > Material", ["none"])])
        halves = rhegma(self.path("scene.xml"), "--output", self.path("twice"), "--twice", "--quiet")
        self.assertEqual(halves.status, 0, halves)
        self.assertIn(f"G_J of {crack}.0", halves.output)


class Many(RestartTest):
    """Scenes with many things."""

    def test_many_bodies(self):
        """How long they take is printed by studies/many_parts.py, and how it grows is tested in src/scene."""
        count = BODIES
        answer = rhegma(self.write("many.xml", many_bodies(count).text()), "--check", "--quiet")
        self.assertEqual((answer.status, answer.messages), (0, ""), answer.messages[:2000])
        self.assertIn(f": {4 * count} particles in cells of 250 mm", answer.output)

    def test_many_cracks(self):
        count = BODIES
        answer = rhegma(self.write("many.xml", many_cracks(count).text()), "--check", "--quiet")
        self.assertEqual(answer.status, 0, answer.messages[:2000])
        self.assertIn(f": {16 * (int(count**0.5) + 1)**2} particles in cells of 250 mm", answer.output)
        self.assertIn(f"and {count - 10} more like: Cracks > Crack 0: ", answer.messages)

    def test_a_thousand_errors(self):
        answer = rhegma(self.write("many.xml", many_bodies(1000, Material="Polymr").text()), "--check")
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
