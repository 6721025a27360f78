"""Tests of rhegma-check on made-up folders."""

import fcntl
import json
import os
import zlib

from made_up_run import write_fields, write_history, write_summary
from tool import ToolTest, run


class Check(ToolTest):
    def setUp(self):
        super().setUp()
        self.out = self.path("out")
        os.makedirs(self.out)
        write_history(self.out, {"time": [0.0, 1.0, 2.0], "mass": [3.0, 3.0, 3.0]})
        write_summary(self.out, time=2.0)
        write_fields(self.out, [(0.0, {"particles": {"mass": [1.0, 2.0]}}), (2.0, {"particles": {"mass": [1.0, 2.0]}})])
        self.write_manifest(True)

    def write_manifest(self, ended, more=None):
        files = dict(more or {})
        for name in ("history.csv", "summary.json"):
            with open(os.path.join(self.out, name), "rb") as file:
                content = file.read()
            files[name] = {"bytes": len(content), "crc32": zlib.crc32(content)}
        lines = json.dumps({"ended": ended, "files": files}, indent=2)[:-2] + ",\n"
        with open(os.path.join(self.out, "manifest.json"), "w") as file:
            file.write(f'{lines}  "manifest_crc32": {zlib.crc32(lines.encode())}\n}}\n')

    def change(self, name, old, new):
        path = os.path.join(self.out, name)
        with open(path, "rb") as file:
            content = file.read()
        self.assertIn(old, content)
        with open(path, "wb") as file:
            file.write(content.replace(old, new, 1))

    def assert_fault(self, *words):
        status, _, messages = run("rhegma-check", self.out)
        self.assertEqual(status, 1, messages)
        for word in words:
            self.assertIn(word, messages)

    def test_whole_folder(self):
        status, output, messages = run("rhegma-check", self.out)
        self.assertEqual((status, messages), (0, ""))
        self.assertIn("2 whole frames", output)
        self.assertIn("3 rows", output)
        self.assertTrue(output.startswith("The run finished at t = 2 s.\n"), output)
        self.assertTrue(output.endswith("are complete and undamaged.\n"), output)
        self.assertEqual(run("rhegma-check", self.out, "--quiet"), (0, "", ""))

    def test_changed_history(self):
        self.change("history.csv", b"1.0,3.0", b"1.0,3.5")
        self.assert_fault("history.csv has changed", "checksum")

    def test_times_that_do_not_grow(self):
        self.change("history.csv", b"1.0,3.0", b"2.5,3.0")
        self.write_manifest(True)
        self.assert_fault("the times of its rows do not grow")

    def test_missing_file(self):
        os.remove(os.path.join(self.out, "summary.json"))
        self.assert_fault("summary.json is missing")

    def test_damaged_manifest(self):
        self.change("manifest.json", b'"ended": true', b'"ended": True')
        self.assert_fault("manifest.json is damaged")

    def test_missing_frame(self):
        import h5py

        with h5py.File(os.path.join(self.out, "fields.h5"), "a") as file:
            file.move("t00001", "t00002")
        self.assert_fault("missing: t00001", "of 3 frames")

    def test_history_beyond_the_summary(self):
        write_summary(self.out, time=1.5)
        self.write_manifest(True)
        self.assert_fault("goes to 2 s, but the summary to 1.5 s")

    def end_of_run(self, time, **more):
        """Nine steps after the rows at 0, 1 and 2 s, and no frame; the answer."""
        write_fields(self.out, [(0.0, {"particles": {"mass": [1.0]}})])
        write_summary(self.out, time=time, steps=9, **more)
        self.write_manifest(True)
        return run("rhegma-check", self.out)

    def test_history_that_ends_early(self):
        """A failure may come one interval and one step, 0.3 s, after the last row."""
        self.assertEqual(self.end_of_run(3.1, history_interval=1.0)[0], 0)
        status, _, messages = self.end_of_run(3.5, history_interval=1.0)
        self.assertEqual(status, 1)
        self.assertIn("the history ends at 2 s, but the run at 3.5 s: its last rows are missing", messages)
        self.assertEqual(self.end_of_run(3.5, history_interval=2.0)[0], 0)
        self.assertEqual(self.end_of_run(3.5)[0], 1, "the interval is that of the rows")

    def test_status_of_a_file_that_was_not_written(self):
        status, _, messages = self.end_of_run(2.0, status="the run stopped at t = 2 s, step 9: out/history.csv can't be written: why")
        self.assertEqual(status, 1)
        self.assertIn("not all could be written: the run stopped at t = 2 s", messages)

    def test_end_of_a_run_that_stopped(self):
        """Its files are whole, and its exit status was 2: nobody should take them for those of a finished run."""
        unstable = "the run stopped at t = 2 s, step 9: it is unstable"
        for end in ({"end": "stopped"}, {}):  # older versions wrote no end
            status, output, messages = self.end_of_run(2.0, status=unstable, **end)
            self.assertEqual((status, messages), (2, ""))
            self.assertEqual(output.splitlines()[0], f"T{unstable[1:]}.")
            self.assertNotIn("complete and undamaged", output)
        status, output, _ = self.end_of_run(2.0, status="a particle left the domain", end="stopped")
        self.assertEqual((status, output.splitlines()[0]), (2, "The run did not come to its end: a particle left the domain."))
        status, output, _ = self.end_of_run(2.0, status="finished", end="no known word")
        self.assertEqual(status, 2)

    def test_end_of_a_run_that_nothing_stopped(self):
        for end, status, words in (("finished", "finished", "The run finished at t = 2 s after 9 steps."),
                                   ("cut off", "finished at Time > Maximum Steps",
                                    "The run finished at Time > Maximum Steps at t = 2 s after 9 steps, before Time > Final Time."),
                                   ("not at rest", "finished",
                                    "The run finished at t = 2 s after 9 steps, before the bodies were at rest.")):
            code, output, _ = self.end_of_run(2.0, status=status, end=end)
            self.assertEqual((code, output.splitlines()[0]), (0, words))

    def test_end_of_a_run_with_a_fault(self):
        """The first line says it all the same; where the summary is lost, that it is not known."""
        self.change("history.csv", b"1.0,3.0", b"1.0,3.5")
        self.assertTrue(run("rhegma-check", self.out)[1].startswith("The run finished at t = 2 s.\n"))
        os.remove(os.path.join(self.out, "summary.json"))
        self.assertTrue(run("rhegma-check", self.out)[1].startswith(f"How the run in {self.out} ended is not known"))

    def test_what_is_no_checkpoint(self):
        with open(os.path.join(self.out, "checkpoint.h5"), "wb") as file:
            file.write(b"x" * 600)
        self.assert_fault("checkpoint.h5 is not a checkpoint")

    def test_run_that_was_cut_off(self):
        self.write_manifest(False)
        status, output, messages = run("rhegma-check", self.out)
        self.assertEqual((status, messages), (2, ""))
        self.assertIn("was cut off", output)

    def test_exit_status_is_that_of_the_help(self):
        """0: finished and whole; 1: damaged, missing, or no folder of a run; 2: going on, killed or stopped."""
        help_text = " ".join(run("rhegma-check", "--help")[1].split())
        for words in ("0: the run finished, and its files are complete and undamaged", "1: a file is missing, damaged or unreadable, or could not be written by the run, or DIR is not",
                      "2: the run is active, was killed, or stopped before its end"):
            self.assertIn(words, help_text)
        self.assertEqual(run("rhegma-check", self.out)[0], 0)
        for name in ("history.csv", "summary.json", "manifest.json"):
            path = os.path.join(self.out, name)
            with open(path, "rb") as file:
                content = file.read()
            os.remove(path)
            self.assertEqual(run("rhegma-check", self.out)[0], 1, f"{name} is missing")
            os.mkdir(path)
            self.assertEqual(run("rhegma-check", self.out)[0], 1, f"{name} is a folder")
            os.rmdir(path)
            for damaged in (b"", content[:-1], content + b"\n", b"?" + content[1:]):
                with open(path, "wb") as file:
                    file.write(damaged)
                self.assertEqual(run("rhegma-check", self.out)[0], 1, f"{name}: {damaged[-40:]}")
            with open(path, "wb") as file:
                file.write(content)
        self.assertEqual(run("rhegma-check", self.out)[0], 0)
        self.write_manifest(False)
        self.assertEqual(run("rhegma-check", self.out)[0], 2)
        self.assertEqual(run("rhegma-check", self.path("nowhere"))[0], 1)
        self.assertEqual(run("rhegma-check")[0], 1)

    def test_what_can_not_be_read(self):
        path = os.path.join(self.out, "summary.json")
        os.remove(path)
        os.mkdir(path)
        self.assert_fault("summary.json can't be read (Is a directory)")

    def test_fields_of_another_size(self):
        path = os.path.join(self.out, "fields.h5")
        size = os.path.getsize(path)
        self.write_manifest(True, {"fields.h5": {"bytes": size}})
        self.assertEqual(run("rhegma-check", self.out)[0], 0)
        with open(path, "ab") as file:
            file.write(b"more")
        self.assert_fault(f"fields.h5 has {size + 4} bytes, but the run wrote {size}")

    def test_fields_that_hdf5_does_not_open(self):
        with open(os.path.join(self.out, "fields.h5"), "r+b") as file:
            file.truncate(os.path.getsize(file.name) // 2)
        self.assert_fault("fields.h5 can't be read by HDF5")

    def test_folder_of_two_runs(self):
        for name in ("as_is", "half"):
            os.makedirs(self.path("twice", name))
        with open(self.path("twice", "twice.json"), "w") as file:
            file.write("{}")
        status, _, messages = run("rhegma-check", self.path("twice"))
        self.assertEqual(status, 1)
        self.assertIn("whose runs are in as_is and half", messages)

    def lock(self, host):
        path = os.path.join(self.out, "run.lock")
        with open(path, "w") as file:
            file.write(f"host: {host}\nprocess: 1\nstarted: 2020-01-01 00:00:00 UTC\n")
        return path

    def test_run_that_goes_on(self):
        self.write_manifest(False)
        with open(self.lock(os.uname().nodename), "rb") as file:
            # Whoever asks at the same time is no run.
            fcntl.flock(file, fcntl.LOCK_SH)
            self.assertIn("was cut off", run("rhegma-check", self.out)[1])
            fcntl.flock(file, fcntl.LOCK_EX)
            status, output, messages = run("rhegma-check", self.out)
        self.assertEqual((status, messages), (2, ""))
        self.assertIn("A run is going on", output)

    def test_run_of_another_machine(self):
        self.write_manifest(False)
        self.lock("elsewhere")
        status, output, messages = run("rhegma-check", self.out)
        self.assertEqual((status, messages), (2, ""))
        self.assertIn("A run of another machine may be going on", output)

    def test_no_run(self):
        os.remove(os.path.join(self.out, "manifest.json"))
        self.assert_fault("has no manifest.json")
        self.assert_fails(run("rhegma-check", self.path("nowhere")), "there is no folder")
