"""Tests of what tools do where their output can't be written, or their input can't be read."""

import html
import os
import subprocess
import sys
import unittest
import zlib

from tool import TOOLS, ToolTest, run

import made_up_run

DRAWING = '<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm" viewBox="0 0 9 9"><rect width="5" height="5"/></svg>'
UNREADABLE = "/proc/self/mem"  # a file that can be opened and not be read, by its owner, too


class Streams(ToolTest):
    def to(self, tool, *arguments, redirect, **environment):
        """(exit status, standard error) with a redirection of the shell."""
        result = subprocess.run(["/bin/sh", "-c", f'"$@" {redirect}', "sh", sys.executable, os.path.join(TOOLS, tool), *arguments],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1", **environment))
        return result.returncode, result.stderr

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_output_that_can_not_be_written(self):
        drawing = self.write("part.svg", DRAWING)
        for arguments in (["rhegma-mesh", drawing, "-o", self.path("part.txt")], ["rhegma-mesh", "--help"]):
            for unbuffered in ("", "1"):
                with self.subTest(arguments, unbuffered=unbuffered):
                    status, messages = self.to(*arguments, redirect="> /dev/full", PYTHONUNBUFFERED=unbuffered)
                    self.assertEqual((status, messages), (1, "rhegma-mesh: the standard output can't be written (No space left on device).\n"))

    def test_closed_streams(self):
        """No file of the tool gets the number of the standard output, and with it what is printed."""
        made_up_run.beam(self.folder)
        for redirect in (">&-", "<&-", ">&- <&-"):
            with self.subTest(redirect):
                status, messages = self.to("rhegma-check", self.folder, redirect=redirect)
                self.assertEqual(status, 1)
                self.assertTrue(messages.startswith("rhegma-check: "), messages)
                self.assertNotIn("Traceback", messages)
                drawing = self.write("part.svg", DRAWING)
                self.assertEqual(self.to("rhegma-mesh", drawing, "-o", self.path("part.txt"), redirect=redirect), (0, ""))
                with open(self.path("part.txt"), encoding="utf-8") as file:
                    self.assertNotIn("Wrote", file.read())
        self.assertEqual(self.to("rhegma-mesh", self.path("absent.svg"), redirect="2>&-"), (1, ""))

    @unittest.skipUnless(os.path.exists(UNREADABLE), "there is no file that can't be read")
    def test_a_report_without_a_scene_or_a_manifest_that_can_be_read(self):
        made_up_run.beam(self.folder)
        made_up_run.write_summary(self.folder, scene=UNREADABLE)
        content = b'{"ended": true, "scene": {"path": "%s", "bytes": 3, "crc32": 5},\n' % UNREADABLE.encode()
        self.write("manifest.json", content + b'  "manifest_crc32": %d\n}\n' % zlib.crc32(content))
        self.assert_page(f"{UNREADABLE} can't be read (Input/output error)")
        os.remove(self.path("manifest.json"))
        os.mkdir(self.path("manifest.json"))
        self.assert_page(f"{self.path('manifest.json')} can't be read (Is a directory)")

    def assert_page(self, words):
        status, output, messages = run("rhegma-report", self.folder)
        self.assertEqual((status, messages), (0, ""))
        self.assertIn("Wrote", output)
        with open(self.path("report.html"), encoding="utf-8") as file:
            self.assertIn(words, html.unescape(file.read()))

    def test_a_folder_that_can_not_be_read(self):
        """The folder of the test is its owner's alone; root reads all folders, so that another user asks."""
        owner = os.geteuid() != 0
        if owner:
            os.chmod(self.folder, 0)
            self.addCleanup(os.chmod, self.folder, 0o700)
        for tool in ("rhegma-check", "rhegma-report", "rhegma-plot", "rhegma-film"):
            with self.subTest(tool):
                result = subprocess.run([sys.executable, os.path.join(TOOLS, tool), self.folder], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                        env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1", MPLCONFIGDIR="/nonexistent"), **({} if owner else {"user": 65534}))
                if not owner and "can't open file" in result.stderr:
                    self.skipTest("another user can't read the tools")
                last = (result.stderr.splitlines() or [""])[-1]
                self.assertEqual((result.returncode, last), (1, f"{tool}: the folder {self.folder} can't be read (Permission denied)."))
