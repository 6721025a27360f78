#!/usr/bin/env python3
"""Large arrays of the program are in huge pages where the system gives them on request, and results do not depend on it."""

import glob
import json
import os
import re
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import PROGRAM, ProgramTest, environment, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

MODE = "/sys/kernel/mm/transparent_hugepage/enabled"
ALLOCATORS = sorted(glob.glob("/usr/lib/*/libjemalloc.so.2") + glob.glob("/usr/lib/*/libtcmalloc_minimal.so.4"))
ENOUGH = 4 << 20  # kB of free memory with which the system has huge pages to give


def first(pattern, path):
    """The number in a text of the system, or 0."""
    try:
        with open(path, encoding="utf-8") as file:
            found = re.search(pattern, file.read(), re.MULTILINE)
    except OSError:  # the process has ended
        return 0
    return int(found[1]) if found else 0


def on_request():
    try:
        with open(MODE, encoding="utf-8") as file:
            return "[madvise]" in file.read()
    except OSError:
        return False


class HugePages(ProgramTest):
    def outcome(self, name, **variables):
        """summary.json, and the most memory in huge pages [kB] during a run of 200,000 particles."""
        scene = plate().remove("Energy Release").set("Domain > Cell Size", 0.0045).set("Time > Maximum Steps", 12)
        command = [PROGRAM, self.write("scene.xml", scene.text()), "--quiet", "--output", self.path(name)]
        most = 0
        with subprocess.Popen(command, env=environment(variables), stderr=subprocess.DEVNULL) as run:
            while run.poll() is None:
                most = max(most, first(r"^AnonHugePages: +(\d+) kB", f"/proc/{run.pid}/smaps_rollup"))
                time.sleep(0.05)
        self.assertEqual(run.returncode, 0)
        with open(self.path(name, "summary.json"), encoding="utf-8") as file:
            return json.load(file), most

    @unittest.skipUnless(on_request(), "the system gives huge pages always or never")
    @unittest.skipIf(first(r"^MemAvailable: +(\d+) kB", "/proc/meminfo") < ENOUGH, "hardly any memory is free")
    def test_arrays_are_in_huge_pages_and_results_are_the_same(self):
        on, with_huge = self.outcome("on")
        off, without = self.outcome("off", RHEGMA_HUGE_PAGES="0")
        print(f"{with_huge / 1024:.0f} MB of {on['peak_memory_bytes'] / 1e6:.0f} MB are in huge pages, {without / 1024:.0f} MB without them")
        self.assertEqual(on["energy"], off["energy"])
        self.assertEqual(without, 0)
        # Fields of 200,000 particles; ten of at least 2 x 8 bytes.
        self.assertGreater(1024 * with_huge, 10 * 16 * 200000)

    @unittest.skipUnless(ALLOCATORS, "no other allocator is installed")
    def test_another_allocator_is_used_as_a_whole(self):
        """One that is loaded before the C library gets all requests, and frees what it gave."""
        for library in ALLOCATORS:
            with self.subTest(library=library):
                answer = rhegma(self.write("scene.xml", plate().set("Time > Maximum Steps", 2).text()), "--quiet", "--output", self.path("out"), LD_PRELOAD=library)
                self.assertEqual(answer.status, 0, answer)


if __name__ == "__main__":
    unittest.main()
