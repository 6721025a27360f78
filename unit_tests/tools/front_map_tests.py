"""Tests of maps of values along fronts over time, and of the checks of their files."""

import os
import unittest

from tool import ToolTest, picture_size, run  # first, as it finds the Python for all others

import made_up_run
import numpy as np
from PIL import Image

from rhegma_tools.front_map import SMALL, draw_maps, edges_between, map_of, quantities_of
from rhegma.fronts import read_series
from rhegma_tools.whole_folder import check_folder

GC = {"propagation": {"initiation_toughness": 10.0}}


def growing(samples=6, ratio=0.0):
    """Samples of a front that gets longer, with more nodes each time. ratio: K_II over K_I"""
    found = []
    for i in range(samples):
        s = np.linspace(0.0, 1e-2 * (1 + 0.2 * i), 4 + i)
        found.append((1e-6 * (i + 1), {"Penny.0": {"s": s, "G": 10.0 + s * 100, "K_I": 1e6 + s, "K_II": ratio * 1e6 + 0 * s, "K_III": 0 * s,
                                                   "speed": 0 * s + i}}))
    return found


def labels(series, toughness=None):
    return [quantity.label for quantity in quantities_of(list(series.values()), toughness)]


class MapsOfFronts(ToolTest):
    def series(self, samples):
        made_up_run.write_fronts(self.folder, samples)
        return read_series(self.folder)

    def test_the_file_is_read_in_the_order_of_time(self):
        samples = self.series(growing(12))["Penny.0"]
        self.assertEqual([sample.time for sample in samples], [1e-6 * (i + 1) for i in range(12)])
        self.assertEqual([len(sample.s) for sample in samples], [4 + i for i in range(12)])
        self.assertEqual(read_series(self.path("nowhere")), {})

    def test_what_is_drawn(self):
        self.assertEqual(labels(self.series(growing())), ["G [J/m²]", r"$K_\mathrm{I}$ [MPa √m]", "speed [m/s]"])
        self.assertEqual(labels(self.series(growing()), 10.0)[0], "G / Gc")
        self.assertEqual(len(labels(self.series(growing(ratio=2 * SMALL)))), 4)
        self.assertEqual(len(labels(self.series(growing(ratio=-2 * SMALL)))), 4)

    def test_rectangles_cover_the_front_in_each_sample(self):
        """The areas of the rectangles of a sample add up to its length times its interval of time; their corners are the middles."""
        samples = self.series(growing())["Penny.0"]
        rectangles, values = map_of(samples, "G")
        self.assertEqual(len(values), sum(4 + i for i in range(6)))
        times = edges_between(np.array([sample.time for sample in samples]))
        area = np.ptp(rectangles[:, :, 0], axis=1) * np.ptp(rectangles[:, :, 1], axis=1)
        at = 0
        for i, sample in enumerate(samples):
            count = len(sample.s)
            self.assertAlmostEqual(area[at:at + count].sum(), sample.s[-1] * (times[i + 1] - times[i]), delta=1e-12 * sample.s[-1] * times[-1])
            np.testing.assert_array_equal(values[at:at + count], sample.G)
            at += count
        np.testing.assert_allclose(edges_between(np.array([0.0, 1.0, 3.0])), [0.0, 0.5, 2.0, 3.0])

    def test_lines_of_a_divided_front_are_one_after_the_other(self):
        tables = {"s": [0.0, 1.0, 0.0, 2.0], "line": [0, 0, 1, 1], "G": [1.0, 2.0, 3.0, 4.0]}
        samples = self.series([(1.0, {"A.0": tables}), (2.0, {"A.0": tables})])["A.0"]
        rectangles, _ = map_of(samples, "G")
        self.assertEqual(sorted(set(rectangles[:, :, 0].ravel())), [0.0, 0.5, 1.0, 2.0, 3.0])

    def test_colours_are_those_of_the_values(self):
        """G is low at first and high later, left and right alike: dark below, bright above."""
        flat = [(float(i), {"A.0": {"s": [0.0, 1.0, 2.0], "G": [1.0 + 9.0 * (i > 5)] * 3}}) for i in range(12)]
        path = self.path("fronts.png")
        self.assertEqual(draw_maps(self.series(flat), None, "flat", path), ["G [J/m²]"])
        picture = np.asarray(Image.open(path).convert("RGB")).astype(int)
        bright = (np.abs(picture - [253, 231, 36]).sum(axis=2) < 12)
        dark = (picture.sum(axis=2) < 260) & (picture[:, :, 2] > picture[:, :, 1] + 30)
        rows = [np.flatnonzero(mask.sum(axis=1) > 150) for mask in (bright, dark)]
        self.assertGreater(len(rows[0]), 100)
        self.assertGreater(len(rows[1]), 100)
        self.assertLess(rows[0].max(), rows[1].max())

    def test_nothing_to_draw(self):
        path = self.path("fronts.png")
        self.assertEqual(draw_maps({}, None, "none", path), [])
        self.assertEqual(draw_maps(self.series(growing(1)), None, "one", path), [])
        unknown = [(float(i), {"A.0": {"s": [0.0, 1.0], "G": [np.nan, np.nan]}}) for i in range(3)]
        self.assertEqual(draw_maps(self.series(unknown), None, "unknown", path), [])
        self.assertFalse(os.path.exists(path))

    def test_fronts_that_begin_later_and_nodes_without_a_value(self):
        samples = growing()
        samples[4][1]["Late.0"] = samples[5][1]["Late.0"] = {"s": [0.0, 1e-3], "G": [np.nan, 3.0]}
        path = self.path("fronts.png")
        self.assertEqual(draw_maps(self.series(samples), GC, "late", path)[0], "G / Gc")
        self.assertGreater(picture_size(path)[1], 900)

    def test_tools_draw_it(self):
        made_up_run.beam(self.path("run"))
        made_up_run.write_fronts(self.path("run"), growing())
        status, output, messages = run("rhegma-plot", self.path("run"))
        self.assertEqual(status, 0, messages)
        self.assertIn("fronts.png: maps of G [J/m²], K_I [MPa √m], speed [m/s] along the fronts over time", output)
        self.assertTrue(os.path.exists(self.path("run", "fronts.png")))
        status, _, messages = run("rhegma-report", self.path("run"))
        self.assertEqual(status, 0, messages)
        with open(self.path("run", "report.html"), encoding="utf-8") as file:
            self.assertIn("arc length against time", file.read())


class ChecksOfFronts(ToolTest):
    def faults(self):
        return [fault for fault in check_folder(self.folder).faults if "fronts" in fault]

    def test_whole_files(self):
        made_up_run.write_fronts(self.folder, growing())
        self.assertEqual(self.faults(), [])

    def test_a_table_that_lacks_samples(self):
        made_up_run.write_fronts(self.folder, growing())
        path = self.path("fronts.csv")
        with open(path) as file:
            rows = file.readlines()
        with open(path, "w") as file:
            file.writelines(rows[:10])
        self.assertIn("their times differ", " ".join(self.faults()))

    def test_a_table_that_is_lost(self):
        made_up_run.write_fronts(self.folder, growing())
        os.remove(self.path("fronts.csv"))
        self.assertIn("is missing, though fronts.h5 has 6 samples", " ".join(self.faults()))

    def test_a_file_that_is_no_hdf5(self):
        made_up_run.write_fronts(self.folder, growing())
        with open(self.path("fronts.h5"), "r+b") as file:
            file.write(b"\0" * 64)
        self.assertIn("can't be read by HDF5", " ".join(self.faults()))


if __name__ == "__main__":
    unittest.main()
