"""Tests of rhegma-check on made-up folders."""

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

    def write_manifest(self, ended):
        files = {}
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
        self.assertTrue(output.endswith("is whole.\n"), output)
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

    def test_what_is_no_checkpoint(self):
        with open(os.path.join(self.out, "checkpoint.h5"), "wb") as file:
            file.write(b"x" * 600)
        self.assert_fault("checkpoint.h5 is not a checkpoint")

    def test_run_that_was_cut_off(self):
        self.write_manifest(False)
        status, output, messages = run("rhegma-check", self.out)
        self.assertEqual((status, messages), (2, ""))
        self.assertIn("was cut off", output)

    def test_no_run(self):
        os.remove(os.path.join(self.out, "manifest.json"))
        self.assert_fault("has no manifest.json")
        self.assert_fails(run("rhegma-check", self.path("nowhere")), "there is no folder")
