"""Tests of the colours of stresses: they end at the fronts of cracks where supports and edges of voxels have larger ones, and the picture says so."""

import os
import random
import unittest

from tool import ToolTest  # first, as it finds the Python for all others

import made_up_run
import numpy as np

from rhegma.fields import read_fields
from rhegma_tools.colour_scales import scale_of
from rhegma_tools.front_region import AROUND, at_fronts

SEED = int(os.environ.get("RHEGMA_SEED", str(random.randrange(10**6))))
EDGE = 0.1


def turned(rng):
    """A rotation of space."""
    q = rng.normal(size=4)
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


class Fronts(ToolTest):
    def plate(self, shape, length, rotation=None, stress=None):
        """The fields of a block with its corner at 0 and a crack in the plane of half its height, from x = 0 on; rotation: of all of it"""
        rotation = np.eye(3) if rotation is None else rotation
        start = made_up_run.lattice(*[(np.arange(n) + 0.5) * EDGE for n in shape])
        if shape[2] == 1:
            start[:, 2] = 0.0
        height, steps = 0.5 * shape[1] * EDGE, 8
        x = np.linspace(0.0, length, steps + 1)
        if shape[2] == 1:
            points, cells = np.c_[x, np.full_like(x, height), 0 * x], np.c_[np.arange(steps), np.arange(1, steps + 1)]
        else:
            depth = shape[2] * EDGE
            points = np.concatenate([np.c_[x, np.full_like(x, height), np.full_like(x, z)] for z in (0.0, depth)])
            first = np.arange(steps)
            cells = np.concatenate([np.c_[first, first + 1, first + steps + 1], np.c_[first + 1, first + steps + 2, first + steps + 1]])
        group = made_up_run.particles(start @ rotation.T, np.zeros_like(start), np.zeros((len(start), 6)) if stress is None else stress(start), EDGE)
        if shape[2] > 1:
            group["edges"] = np.tile((EDGE * rotation.T).ravel(), (len(start), 1))
        crack = {"points": points @ rotation.T, "cells": cells, "opening": np.zeros_like(points)}
        made_up_run.write_fields(self.folder, [(1.0, {"particles": group, "cracks": crack})])
        return read_fields(self.folder), start, height

    def test_are_found_but_not_where_a_crack_meets_the_surface(self):
        print(f"RHEGMA_SEED = {SEED}")
        rng = np.random.default_rng(SEED)
        for shape in ((30, 20, 1), (24, 14, 8)):
            length = rng.uniform(0.4, 0.6) * shape[0] * EDGE
            rotation = turned(rng) if shape[2] > 1 else None
            fields, start, height = self.plate(shape, length, rotation)
            near = at_fronts(fields)
            across = np.hypot(start[:, 0] - length, start[:, 1] - height)
            # In 3D the distance is to the middle of edges along the front, which is as long as the depth.
            self.assertTrue(near.any())
            self.assertTrue(np.all(across[near] <= AROUND * EDGE * (1 + 1e-9)))
            middle = np.abs(start[:, 2] - 0.5 * shape[2] * EDGE) < 0.6 * EDGE if shape[2] > 1 else np.ones(len(start), dtype=bool)
            inside = middle & (across <= (AROUND - 0.2) * EDGE)
            self.assertTrue(near[inside].all())

    def test_are_none_of_a_crack_that_cuts_the_body(self):
        for shape in ((30, 20, 1), (20, 14, 6)):
            fields, _, _ = self.plate(shape, shape[0] * EDGE)
            self.assertFalse(at_fronts(fields).any())

    def test_end_the_colours(self):
        """A stress of 1 with 10 at the front and 100 at 2 % of the particles, at an end that is held."""
        def stress(start):
            found = np.zeros((len(start), 6))
            found[:, 0] = 1.0 + 9.0 * (np.hypot(start[:, 0] - 3.0, start[:, 1] - 2.0) < 0.35)
            found[np.argsort(-start[:, 0])[: len(start) // 50], 0] = 100.0
            return found
        fields, _, _ = self.plate((60, 40, 1), 3.0, stress=stress)
        values = fields.values("principal")
        _, norm = scale_of("principal", values, near=at_fronts(fields))
        self.assertAlmostEqual(norm.vmax, 10.0)
        self.assertEqual(norm.note, "2 % above, up to 100")
        _, norm = scale_of("principal", values)
        self.assertAlmostEqual(norm.vmax, 100.0)
        self.assertEqual(norm.note, "")
        _, norm = scale_of("velocity:x", values, near=at_fronts(fields))  # which has no peak at a front
        self.assertAlmostEqual(norm.vmax, 100.0)

    def test_do_not_hide_the_body(self):
        """A front without stress leaves the colours to all but three per cent of the particles."""
        def stress(start):
            found = np.zeros((len(start), 6))
            found[:, 0] = np.arange(len(start))
            found[np.hypot(start[:, 0] - 3.0, start[:, 1] - 2.0) < 0.6, 0] = 0.0
            return found
        fields, _, _ = self.plate((60, 40, 1), 3.0, stress=stress)
        values = fields.values("principal")
        _, norm = scale_of("principal", values, near=at_fronts(fields))
        self.assertAlmostEqual(norm.vmax, np.percentile(values, 97.0))


del ToolTest
if __name__ == "__main__":
    unittest.main()
