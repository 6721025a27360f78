#!/usr/bin/env python3
"""rhegma SCENE --watch: a page of a run that goes on, and the progress line."""

import os
import re
import signal
import sys
import threading
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import PATIENCE, SOURCE, rhegma  # noqa: E402
from restart_case import RestartTest, damped, scene  # noqa: E402

sys.path.insert(0, os.path.join(SOURCE, "tools"))
from rhegma_tools.whole_folder import check_folder  # noqa: E402

STRIP = os.path.join(SOURCE, "xml_inputs", "examples", "edge_crack.xml")


class Watched(RestartTest):
    def page(self, folder):
        return self.file(folder, "watch.html").decode()

    def test_a_page_on_request_only(self):
        path = self.write("scene.xml", scene().text())
        self.run_to_its_end(path, self.path("without"))
        self.assertFalse(os.path.exists(self.path("without", "watch.html")))
        self.run_to_its_end(path, self.path("with"), "--watch")
        page = self.page(self.path("with"))
        self.assertIn("The run has ended.", page)
        self.assertNotIn("refresh", page)
        self.assertEqual(page.count("<svg"), 2)
        self.assertEqual(self.file(self.path("with"), "history.csv"), self.file(self.path("without"), "history.csv"))
        self.assertEqual(check_folder(self.path("with")).faults, [])

    def test_the_page_of_a_run_that_goes_on_is_always_whole(self):
        """Read as often as possible, it is never half a page; it says how far the run is, and changes at most every two seconds."""
        folder, seen, stop = self.path("out"), [], threading.Event()

        def read():
            while not stop.is_set():
                try:
                    seen.append((time.monotonic(), self.page(folder)))
                except FileNotFoundError:
                    pass
                time.sleep(0.002)

        run = self.start(STRIP, "--output", folder, "--quiet", "--watch", "--set", "Domain:Cell Size=4e-4")
        reader = threading.Thread(target=read)
        reader.start()
        try:
            time.sleep(7.0)
            self.assertIsNone(run.poll(), "the run is too short for this test")
            run.send_signal(signal.SIGTERM)
            run.wait(PATIENCE)
        finally:
            stop.set()
            reader.join()
        self.assertGreater(len(seen), 50)
        for _, page in seen:
            self.assertTrue(page.startswith("<!DOCTYPE html>") and page.endswith("</html>\n"), page[-200:])
        pages = [page for _, page in seen if "refresh" in page]
        self.assertGreaterEqual(len(set(pages)), 2)
        changes = [when for (when, page), (_, before) in zip(seen[1:], seen) if page != before and "refresh" in page]
        for earlier, later in zip(changes, changes[1:]):
            self.assertGreater(later - earlier, 1.9)
        self.assertRegex(pages[-1], r"<p> *\d+ %, [^<]*(left|to rest), step \d+, G ")
        last = self.page(folder)
        self.assertNotIn("refresh", last)
        self.assertIn("stopped by SIGTERM", last)

    def test_a_run_that_continues_has_all_of_the_plots(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        scene_file = self.write("scene.xml", damped().text())
        whole = self.path("whole")
        self.run_to_its_end(scene_file, whole, "--watch")
        self.run_to_its_end(scene_file, self.path("out"), "--restart", checkpoint, "--watch")
        plots = [re.findall(r"<path [^>]*stroke-width[^>]*>", self.page(folder)) for folder in (whole, self.path("out"))]
        self.assertGreater(len(plots[0]), 2)
        self.assertEqual(*plots)

    def test_a_later_run_without_it_leaves_no_old_page(self):
        path = self.write("scene.xml", scene().text())
        self.run_to_its_end(path, self.path("out"), "--watch")
        self.run_to_its_end(path, self.path("out"))
        self.assertFalse(os.path.exists(self.path("out", "watch.html")))

    def test_a_page_of_someone_else_is_not_replaced(self):
        os.makedirs(self.path("out"))
        self.write("out/watch.html", "<html>mine</html>")
        answer = rhegma(self.write("scene.xml", scene().text()), "--output", self.path("out"), "--watch")
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("watch.html", answer.messages)
        self.assertIn("no run wrote", answer.messages)

    def test_the_progress_line(self):
        answer = rhegma(STRIP, "--output", self.path("out"))
        self.assertIn(answer.status, (0, 4), answer)
        lines = [line for line in answer.output.splitlines() if re.match(r" *\d+ %,", line)]
        self.assertGreaterEqual(len(lines), 2)
        for line in lines[:-1]:
            self.assertRegex(line, r"^ *\d+ %, .*(left|to rest), step \d+, G [0-9.e+-]+(, [0-9.e+-]+)* J/m2, residual [0-9.e+-]+ %$")
            self.assertLess(len(line), 80)

    def test_the_progress_line_of_a_crack_that_may_grow(self):
        answer = rhegma(os.path.join(SOURCE, "xml_inputs", "examples", "penny_growth.xml"), "--output", self.path("out"), "--set", "Domain:Cell Size=2e-3",
                        "--set", "Time:Final Time=4e-5")
        self.assertRegex(answer.output, r"(?m)^ *\d+ %, .*, G/Gc [0-9.e+-]+(, [0-9.e+-]+)*, residual [0-9.e+-]+ %$")


if __name__ == "__main__":
    unittest.main()
