"""Tests of rhegma-film: number, colours and positions in the frames of films."""

import io
import os
import random
import shutil
import subprocess
import unittest
from unittest import mock

from tool import ToolTest, run  # first, as it finds the Python for all others

import made_up_run
import numpy as np
from PIL import Image
from spatial_tests import DRAWS

from rhegma_tools import film_file, style, vtk_window
from rhegma_tools.film_file import Wanted, draw_frames, write_film
from rhegma_tools.interpreter import Problem

SEED = int(os.environ.get("RHEGMA_SEED", "20261128"))


def growing(folder, levels, edge=0.1, shape=(20, 10, 1), velocity=0.0):
    """A plate, or in 3D a block, with a uniform stress xx of each level [Pa] in frames 1 ms apart, and a displacement y of 1e-4 m per level."""
    start = made_up_run.lattice(*[(np.arange(n) + 0.5) * edge for n in shape])
    if shape[2] == 1:
        start[:, 2] = 0.0
    times = []
    for i, level in enumerate(levels):
        stress, moved = np.zeros((len(start), 6)), np.zeros_like(start)
        stress[:, 0], moved[:, 1] = level, 1e-4 * level / max(levels)
        group = made_up_run.particles(start, moved, stress, edge)
        group["velocity"] = np.tile([velocity * i, 0.0, -1.0], (len(start), 1))
        times.append((1e-3 * i, {"particles": group}))
    made_up_run.write_fields(folder, times)


def pixels_of(png):
    with Image.open(io.BytesIO(png)) as picture:
        return np.asarray(picture.convert("RGB")).astype(int)


class Frames(ToolTest):
    def test_colours_are_those_of_one_scale(self):
        """In each frame as many pixels as the body is large have the colour of its stress on the scale of all frames."""
        print(f"seed {SEED}")
        rng = random.Random(SEED)
        levels = [1e6 * rng.uniform(1.0, 2.0) * (i + 1) for i in range(4)]
        growing(self.folder, levels)
        film = draw_frames(self.folder, Wanted())
        self.assertEqual([time for time, _ in film.frames], [0.0, 1e-3, 2e-3, 3e-3])
        self.assertEqual((film.unit, film.label, film.magnification), ("MPa", "largest principal stress", 1000.0))
        self.assertAlmostEqual(film.high, max(levels) / 1e6, places=6)
        self.assertEqual(film.low, 0.0)
        for (_, png), level in zip(film.frames, levels):
            colour = np.round(255 * np.array(style.plt.get_cmap(film.colours)(level / 1e6 / film.high)[:3]))
            same = np.abs(pixels_of(png) - colour).max(axis=2) <= 2
            self.assertGreater(same.sum(), 0.2 * same.size)

    def test_the_body_moves_by_the_magnified_displacement(self):
        """1 mm on a plate 1 m high, 10 times: the upper edge of the body is one hundredth higher in the last frame than in the first."""
        growing(self.folder, [1.0, 10.0])
        film = draw_frames(self.folder, Wanted(magnification=1000.0))
        rows = []
        for (_, png), level in zip(film.frames, (1.0, 10.0)):
            colour = np.round(255 * np.array(style.plt.get_cmap(film.colours)(film.norm(level))[:3]))
            found = np.argwhere(np.abs(pixels_of(png) - colour).max(axis=2) <= 2)
            row, column = np.unique(found[:, 0], return_counts=True)
            rows.append(row[column > 0.8 * column.max()])
        height = rows[0].max() - rows[0].min()
        self.assertAlmostEqual((rows[0].min() - rows[1].min()) / height, 0.09, delta=0.01)  # 0.9e-4 m times 1000 of 1 m

    def test_any_field(self):
        growing(self.folder, [1e6, 2e6], velocity=3.0)
        film = draw_frames(self.folder, Wanted("velocity:x"))
        self.assertEqual((film.label, film.unit, film.high), ("velocity x", "m/s", 3.0))
        film = draw_frames(self.folder, Wanted("velocity"))
        self.assertAlmostEqual(film.high, np.hypot(3.0, 1.0))
        film = draw_frames(self.folder, Wanted("stress:xx"))
        self.assertEqual((film.label, film.unit), ("stress xx", "MPa"))
        for quantity, words in (("stress", "xx, yy, zz"), ("velocity:w", "x, y, z"), ("colour", "von_mises"), ("temperature", "temperature")):
            with self.assertRaisesRegex(Problem, words):
                draw_frames(self.folder, Wanted(quantity))

    def test_fewer_frames_of_many(self):
        growing(self.folder, [1.0] * 9)
        film = draw_frames(self.folder, Wanted(most=4))
        self.assertEqual([round(1e3 * time) for time, _ in film.frames], [0, 3, 5, 8])

    @unittest.skipUnless(DRAWS, "needs VTK for Python and a display such as Xvfb")
    def test_a_block_in_3d(self):
        growing(self.folder, [1e6, 4e6], edge=0.1, shape=(6, 6, 6))
        film = draw_frames(self.folder, Wanted("stress:xx"))
        self.assertTrue(film.solid)
        coloured = []
        for _, png in film.frames:
            picture = pixels_of(png)
            coloured.append((picture.max(axis=2) - picture.min(axis=2) > 40).mean())
        self.assertGreater(min(coloured), 0.1)
        one, other = (pixels_of(png) for _, png in film.frames)
        self.assertGreater((np.abs(one - other).max(axis=2) > 40).mean(), 0.1)  # other colours of another stress
        self.assertFalse(draw_frames(self.folder, Wanted(solid=False)).solid)

    @unittest.skipUnless(DRAWS, "needs VTK for Python and a display such as Xvfb")
    def test_one_process_draws_all_frames(self):
        """The frame of a stress is the same, whether it is the only one of its process or follows others."""
        growing(self.folder, [4e6, 1e6, 2e6, 4e6], edge=0.1, shape=(6, 6, 6))
        started, popen = [], subprocess.Popen
        with mock.patch.object(subprocess, "Popen", lambda *a, **more: started.append(a[0]) or popen(*a, **more)):
            film = draw_frames(self.folder, Wanted("stress:xx", magnification=1.0))
        self.assertEqual(len([command for command in started if vtk_window.CHILD in command]), 1)
        first, last = (pixels_of(film.frames[i][1])[60:] for i in (0, -1))  # below the title, which has the time
        np.testing.assert_array_equal(first[:, : first.shape[1] * 3 // 4], last[:, : last.shape[1] * 3 // 4])


class Files(ToolTest):
    def test_a_gif_has_all_frames(self):
        growing(self.folder, [1e6, 2e6, 3e6])
        path = self.path("film.gif")
        status, output, messages = run("rhegma-film", self.folder, "--output", path, "--rate", "5")
        self.assertEqual((status, messages), (0, ""))
        self.assertIn(f"Wrote {path}: 3 frames from 0 to 0.002 s, displacement times 1000, largest principal stress from 1 to 3 MPa.", output)
        with Image.open(path) as film:
            self.assertEqual(film.n_frames, 3)
            durations, means = [], []
            for i in range(3):
                film.seek(i)
                durations.append(film.info["duration"])
                means.append(np.asarray(film.convert("RGB")).astype(float).mean(axis=(0, 1)))
        self.assertEqual(durations, [200, 200, 200])
        self.assertGreater(np.abs(means[2] - means[0]).max(), 10.0)

    @unittest.skipUnless(shutil.which("ffmpeg"), "needs ffmpeg")
    def test_videos_have_all_frames(self):
        growing(self.folder, [1e6, 2e6, 3e6, 4e6])
        film = draw_frames(self.folder, Wanted())
        first = pixels_of(film.frames[0][1])
        for name in ("film.webm", "film.mp4"):
            path = self.path(name)
            write_film(film.frames, path, 10.0)
            os.makedirs(self.path(name + ".d"))
            subprocess.run(["ffmpeg", "-loglevel", "error", "-i", path, os.path.join(self.path(name + ".d"), "%03d.png")], check=True)
            self.assertEqual(len(os.listdir(self.path(name + ".d"))), 4)
            with Image.open(os.path.join(self.path(name + ".d"), "001.png")) as picture:
                shown = np.asarray(picture.convert("RGB")).astype(int)
            self.assertEqual([n % 2 for n in shown.shape[:2]], [0, 0])
            shown = shown[:first.shape[0], :first.shape[1]]
            self.assertLess(np.abs(shown - first[:shown.shape[0], :shown.shape[1]]).mean(), 6.0)

    def test_refuses_what_can_not_be(self):
        self.assert_fails(run("rhegma-film", self.path("none")), "is no folder")
        self.assert_fails(run("rhegma-film", self.folder), "no fields.h5")
        growing(self.folder, [1e6])
        self.assert_fails(run("rhegma-film", self.folder), "Output > Field Interval")
        growing(self.folder, [1e6, 2e6])
        self.assert_fails(run("rhegma-film", self.folder, "--output", self.path("film.avi")), ".webm, .mp4 or .gif")
        self.assert_fails(run("rhegma-film", self.folder, "--rate", "0"), "--rate")
        self.assert_fails(run("rhegma-film", self.folder, "--magnify", "-1"), "--magnify")
        self.assert_fails(run("rhegma-film", self.folder, "--output", self.path("none", "film.gif")), "can't be written")

    def test_a_full_disk_is_no_matter_of_the_format(self):
        """A program in place of ffmpeg fails; the older film stays, and nothing is left."""
        frames = [(0.0, b"a picture")]
        for why, words, other in (("part.webm: No space left on device", "can't be written (No space left on device).", "gif"),
                                  ("Unknown encoder", "(Unknown encoder); a name that ends with .gif needs no ffmpeg.", None)):
            with self.subTest(why):
                os.chmod(self.write("ffmpeg", f"#!/bin/sh\necho half > $(eval echo \\${{$#}})\necho '{why}' >&2\nexit 1\n"), 0o755)
                film = self.write("film.webm", "older")
                with mock.patch.dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}"), self.assertRaises(Problem) as caught:
                    write_film(frames, film, 10.0)
                self.assertIn(words, str(caught.exception))
                self.assertNotIn(other or "No space", str(caught.exception).replace(self.folder, ""))
                with open(film, encoding="utf-8") as file:
                    self.assertEqual(file.read(), "older")
                self.assertEqual(sorted(os.listdir(self.folder)), ["ffmpeg", "film.webm"])

    def test_without_ffmpeg_it_is_a_gif(self):
        growing(self.folder, [1e6, 2e6])
        status, output, _ = run("rhegma-film", self.folder, PATH=self.folder)
        self.assertEqual(status, 0)
        self.assertIn(f"Wrote {self.path('film.gif')}: 2 frames", output)
        self.assert_fails(run("rhegma-film", self.folder, "--output", self.path("film.webm"), PATH=self.folder), "need ffmpeg", "apt-get install ffmpeg")
        self.assertEqual(film_file.default_path("a")[:6], "a/film")
