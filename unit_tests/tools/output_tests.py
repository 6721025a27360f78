"""Where tools write: not onto what they read, results of a run or what is no file; through links; all of a file or nothing."""

import os
import shutil
import unittest

from tool import ToolTest, run

import made_up_run
import numpy as np

from rhegma.problem import Problem
from rhegma_tools.output_file import replacing

DRAWING = '<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm" viewBox="0 0 9 9"><rect width="5" height="5"/></svg>'
LAW = "void vumat(void) {}\n"


class Outputs(ToolTest):
    def content(self, *names):
        with open(self.path(*names), "rb") as file:
            return file.read()

    def assert_refused(self, answer, path, words):
        """A message with these words, and the file and what is next to it as they were."""
        before, names = self.content(path), sorted(os.listdir(self.folder))
        self.assert_fails(answer(), words)
        self.assertEqual((self.content(path), sorted(os.listdir(self.folder))), (before, names))

    def test_an_input_is_kept(self):
        drawing = self.write("part.svg", DRAWING)
        os.symlink(drawing, self.path("link.txt"))
        os.link(drawing, self.path("other.txt"))
        for output in ("part.svg", "link.txt", "other.txt", os.path.join("..", os.path.basename(self.folder), "part.svg")):
            with self.subTest(output):
                self.assert_refused(lambda: run("rhegma-mesh", drawing, "-o", self.path(output)), "part.svg", "is a file that is read")

    @unittest.skipUnless(shutil.which("cc"), "there is no compiler")
    def test_the_source_of_a_law_is_kept(self):
        source = self.write("law.c", LAW)
        self.assert_refused(lambda: run("rhegma-law", source, "-o", source), "law.c", "is a file that is read")

    def test_a_picture_is_kept(self):
        from PIL import Image

        Image.fromarray(np.arange(6, dtype=np.uint8).reshape(2, 3)).save(self.path("a.png"))
        self.assert_refused(lambda: run("rhegma-mesh", self.path("a.png"), "-o", self.path("a.png")), "a.png", "is a file that is read")

    def test_files_of_a_run_are_kept(self):
        made_up_run.beam(self.folder)
        self.write("scene.xml", '<ParameterList name="Rhegma"/>')
        made_up_run.write_summary(self.folder, scene=self.write("beam.xml", '<ParameterList name="Rhegma"/>'))
        os.symlink("history.csv", self.path("page.html"))
        for name in ("fields.h5", "history.csv", "summary.json", "scene.xml", "page.html"):
            with self.subTest(name):
                self.assert_refused(lambda: run("rhegma-report", self.folder, "--output", self.path(name)), name, "is a file of a run")
        self.assert_refused(lambda: run("rhegma-report", self.folder, "--output", self.path("beam.xml")), "beam.xml", "is a file that is read")
        os.symlink("fields.h5", self.path("film.gif"))
        self.assert_refused(lambda: run("rhegma-film", self.folder, "-o", self.path("film.gif")), "fields.h5", "is a file of a run")
        drawing = self.write("a.svg", DRAWING)
        self.assert_refused(lambda: run("rhegma-mesh", drawing, "-o", self.path("history.csv")), "history.csv", "is a file of a run")

    def test_the_files_of_a_scene_are_kept(self):
        self.write("part.png", b"a picture")
        scene = self.write("scene.xml", '<ParameterList name="Rhegma"><Parameter name="File" type="string" value="part.png"/></ParameterList>')
        self.assert_refused(lambda: run("rhegma-plot", "--scene", scene, "-o", self.path("part.png")), "part.png", "is a file that is read")

    def test_what_is_no_file_is_kept(self):
        drawing = self.write("part.svg", DRAWING)
        os.mkfifo(self.path("pipe"))
        os.mkdir(self.path("folder"))
        for name, words in (("pipe", "is no regular file"), ("folder", "is a folder")):
            with self.subTest(name):
                kind = os.stat(self.path(name)).st_mode
                self.assert_fails(run("rhegma-mesh", drawing, "-o", self.path(name)), words)
                self.assertEqual(os.stat(self.path(name)).st_mode, kind)

    def test_a_link_leads_to_the_file(self):
        drawing = self.write("part.svg", DRAWING)
        os.mkdir(self.path("far"))
        for there in (True, False):
            with self.subTest(there=there):
                target = os.path.join("far", f"part{there}.txt")
                if there:
                    self.write(target, "older")
                link = self.path(f"link{there}.txt")
                os.symlink(target, link)
                self.assertEqual(run("rhegma-mesh", drawing, "-o", link)[0], 0)
                self.assertTrue(os.path.islink(link))
                self.assertIn(b"polygons of part.svg", self.content(target))
        self.assertEqual(sorted(os.listdir(self.path("far"))), ["partFalse.txt", "partTrue.txt"])

    def test_a_failure_leaves_the_older_file_alone(self):
        self.write("a.txt", "older")
        for failure in (ValueError, OSError(28, "No space left on device")):
            with self.assertRaises((ValueError, Problem)), replacing(self.path("a.txt")) as temporary:
                with open(temporary, "w") as file:
                    file.write("half")
                raise failure
            self.assertEqual((self.content("a.txt"), os.listdir(self.folder)), (b"older", ["a.txt"]))
