"""Tests of rhegma-mesh: polygons of drawings against areas of closed form."""

import math
import os
import random
import re
import shutil
import stat
import subprocess
import sys
import unittest
from unittest import mock

import numpy as np
from tool import ToolTest, run

from rhegma.problem import Problem
from rhegma_tools.mesh_file import triangles_of, volume_of
from rhegma_tools import svg_outlines
from rhegma_tools.svg_file import read_drawing
from rhegma_tools.svg_outlines import area, extent_of, net_area, outlines_of
from rhegma_tools.svg_path import read_path

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="100mm" height="50mm" viewBox="0 0 100 50">'
TOLERANCE = 1e-5  # [m]
SEED = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))
print(f"seed {SEED}", file=sys.stderr)
STAR = "M 50 5 L 58 40 L 32 18 L 68 18 L 42 40 Z"


class Drawings(ToolTest):
    def polygons(self, content, head=HEAD, tolerance=TOLERANCE, unit=None):
        return outlines_of(read_drawing(self.write("part.svg", head + content + "</svg>"), unit).shapes, tolerance)[0]

    def assert_area(self, polygons, expected, perimeter):
        """Points are on curves and chords at most the tolerance inside of them, so the area differs by at most tolerance times
        perimeter. expected [mm2], perimeter [mm]"""
        self.assertLessEqual(abs(net_area(polygons) - 1e-6 * expected), 1e-3 * perimeter * TOLERANCE + 1e-15)

    def test_a_circle(self):
        polygon, = self.polygons('<circle cx="50" cy="20" r="10"/>')
        self.assert_area([polygon], math.pi * 100.0, 20.0 * math.pi)
        # All points are on the circle, whose centre is 30 mm from the lower edge of the page.
        np.testing.assert_allclose(np.linalg.norm(polygon - [0.05, 0.03], axis=1), 0.01, rtol=1e-12)
        coarse, = self.polygons('<circle cx="50" cy="20" r="10"/>', tolerance=4e-4)
        self.assertGreater(len(polygon), 3 * len(coarse))  # chords of length sqrt(8 r tolerance)

    def test_a_rounded_rectangle_with_a_hole(self):
        # 60 x 30 mm with corners of 5 mm, as one path with the hole in the same direction: a hole by one rule, none by the other.
        outside = "M 15 10 H 65 a 5 5 0 0 1 5 5 V 35 a 5 5 0 0 1 -5 5 H 15 a 5 5 0 0 1 -5 -5 V 15 a 5 5 0 0 1 5 -5 z "
        clockwise = "M 30 25 a 5 5 0 1 1 10 0 a 5 5 0 1 1 -10 0 z"
        other = "M 30 25 a 5 5 0 1 0 10 0 a 5 5 0 1 0 -10 0 z"
        plate = 60.0 * 30.0 - (4.0 - math.pi) * 25.0
        around = 2 * (50 + 20) + 10 * math.pi
        for rule, hole, expected in (("evenodd", clockwise, plate - 25 * math.pi), ("nonzero", clockwise, plate),
                                     ("nonzero", other, plate - 25 * math.pi), ("evenodd", other, plate - 25 * math.pi)):
            with self.subTest(rule=rule, expected=expected):
                polygons = self.polygons(f'<path fill-rule="{rule}" d="{outside}{hole}"/>')
                self.assertEqual(len(polygons), 1 if expected == plate else 2)
                self.assert_area(polygons, expected, around + 10 * math.pi)
        self.assert_area(self.polygons('<rect x="10" y="10" width="60" height="30" rx="5"/>'), plate, around)

    def test_curves_that_are_the_same(self):
        # Each row: the same outline in absolute and relative commands, and by other commands.
        for one, other in (("M10 10 L40 10 L40 30 Z", "m10 10 30 0 v20z"), ("M10,10H40V30H10Z", "m10-0m0 10h30v20h-30z"),
                           ("M10 30 C10 10 40 10 40 30 S70 50 70 30 V45 H10 Z", "m10 30c0-20 30-20 30 0s30 20 30 0v15h-60z"),
                           ("M10 30 C10 10 40 10 40 30 S70 50 70 30 V45 H10 Z", "M10 30 C10 10 40 10 40 30 C40 50 70 50 70 30 V45 H10 Z"),
                           ("M10 30 Q25 0 40 30 T70 30 V49 H10 Z", "m10 30q15-30 30 0t30 0v19h-60z"),
                           ("M10 30 Q25 0 40 30 T70 30 V49 H10 Z", "M10 30 C20 10 30 10 40 30 C50 50 60 50 70 30 V49 H10 Z"),
                           ("M10 30 A20 10 30 0 1 40 20 L40 45 Z", "m10 30a20 10 30 0130-10l0 25z")):
            with self.subTest(other):
                first, second = (self.polygons(f'<path d="{d}"/>', tolerance=1e-7) for d in (one, other))
                # Both are within the tolerance of the same curve, whose length is below 250 mm.
                self.assertAlmostEqual(net_area(first), net_area(second), delta=2 * 0.25 * 1e-7)

    def test_curves_of_known_area(self):
        # Under a parabola of height h over b: 2/3 b h; the chord is at y = 30, and the vertex 15 above it.
        self.assert_area(self.polygons('<path d="M10 30 Q25 0 40 30 Z"/>'), 2.0 / 3.0 * 30.0 * 15.0, 90.0)
        # A cubic with the ends of its handles at the corners of a rectangle over its chord: 3/5 of the rectangle.
        self.assert_area(self.polygons('<path d="M10 30 C10 10 40 10 40 30 Z"/>'), 0.6 * 30.0 * 20.0, 90.0)
        # Half an ellipse, turned by 30 degrees, from one end of its long axis to the other.
        x, y = 20 * math.cos(math.pi / 6), 20 * math.sin(math.pi / 6)
        self.assert_area(self.polygons(f'<path d="M{50 - x} {25 - y} A20 10 30 0 1 {50 + x} {25 + y} Z"/>'), 0.5 * math.pi * 200.0, 100.0)
        # Radii that are too small become those of a half circle.
        self.assert_area(self.polygons('<path d="M40 25 A1 1 0 0 1 60 25 Z"/>'), 0.5 * math.pi * 100.0, 60.0)

    def test_shapes(self):
        self.assert_area(self.polygons('<ellipse cx="50" cy="25" rx="30" ry="10"/>'), math.pi * 300.0, 140.0)
        self.assert_area(self.polygons('<polygon points="10,10 40,10 40,30"/>'), 300.0, 0.0)
        self.assert_area(self.polygons('<polyline points="10 10 40 10 40 30"/>'), 300.0, 0.0)
        self.assert_area(self.polygons('<rect x="1cm" y="10mm" width="20" height="5"/>', head=HEAD.replace('viewBox="0 0 100 50"', "")),
                         20.0 * 5.0 * (25.4 / 96.0) ** 2, 0.0)

    def test_transforms_of_groups(self):
        # A square of 2 mm, scaled by 3 and 2, turned and moved: its area is 6 times as large.
        square = '<rect width="2" height="2"/>'
        for transform in ("translate(50 25) rotate(30) scale(3 2)", "matrix(3 0 0 2 50 25)", "rotate(40,50,25)translate(50,25)scale(3,2)",
                          "translate(50,25) scale(3 2) skewX(20)", "translate(50,25) skewY(-20) scale(2 3)"):
            with self.subTest(transform):
                self.assert_area(self.polygons(f'<g transform="{transform}">{square}</g>'), 24.0, 1e-9)
        polygon, = self.polygons(f'<g transform="translate(50 25)"><g transform="rotate(90)"><g transform="scale(3)">{square}</g></g></g>')
        # To the left and down on the page, whose y points downwards: from (44, 25) to (50, 31).
        np.testing.assert_allclose([polygon.min(axis=0), polygon.max(axis=0)], [[0.044, 0.019], [0.050, 0.025]], atol=1e-15)
        with self.assertRaisesRegex(Problem, "the transform .* can't be read"):
            self.polygons(f'<g transform="turn(3)">{square}</g>')
        self.assert_area(self.polygons(f'<defs><g id="a">{square}</g></defs><use xlink:href="#a" x="10" y="10"/><use href="#a" x="20" y="10"/>'), 8.0, 0.0)

    def test_units_of_the_page(self):
        square = '<rect x="10" y="10" width="10" height="10"/>'
        for size, box, side in (('width="10cm" height="5cm"', "0 0 100 50", 10e-3), ('width="4in" height="2in"', "0 0 100 50", 4 * 25.4e-3 / 10),
                                ('width="100mm" height="50mm"', "0 0 1000 500", 1e-3), ("", "0 0 100 50", 25.4e-3 / 96 * 10),
                                ('width="96" height="48"', "0 0 96 48", 25.4e-3 / 96 * 10), ('width="100mm" height="100mm"', "0 0 100 50", 10e-3)):
            with self.subTest(size):
                polygons = self.polygons(square, f'<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="{box}">')
                self.assertAlmostEqual(net_area(polygons) / side**2, 1.0, places=12)
        self.assertAlmostEqual(net_area(self.polygons(square, unit=1.0)), 100.0, places=9)

    def test_shapes_together(self):
        plate, hole, far = '<rect x="10" y="10" width="30" height="30"/>', '<circle cx="25" cy="25" r="5"/>', '<rect x="60" y="10" width="5" height="5"/>'
        # Filled shapes are united; of outlines, one within another is a hole.
        self.assertEqual(len(self.polygons(plate + hole + far)), 2)
        polygons = self.polygons(f'<g style="fill:none;stroke:black">{plate}{hole}{far}</g>')
        self.assertEqual(len(polygons), 3)
        self.assert_area(polygons, 900.0 + 25.0 - 25.0 * math.pi, 10 * math.pi)
        with self.assertRaisesRegex(Problem, "outlines cross or touch near x = 0.0"):
            self.polygons(plate + '<circle cx="40" cy="25" r="5"/>')
        with self.assertRaisesRegex(Problem, "outlines cross"):
            self.polygons(f'<path d="{STAR}"/>')

    def test_what_is_left_out(self):
        hidden = '<defs><rect width="9" height="9"/></defs><rect display="none" width="9" height="9"/><rect visibility="hidden" width="9" height="9"/>'
        path = self.write("part.svg", HEAD + hidden + '<circle cx="50" cy="20" r="10"/><text x="1" y="1">A</text>'
                          '<path fill="none" d="M0 0 L10 0 L10 10"/></svg>')
        status, output, messages = run("rhegma-mesh", path, "-o", self.path("part.txt"), "--tolerance", "0.01 mm")
        self.assertEqual((status, messages), (0, ""))
        self.assertIn("text is not used (1)", output)
        self.assertIn("1 open line is left out", output)
        self.assertIn("1 polygon, ", output)
        with open(self.path("part.txt")) as file:
            lines = file.read().splitlines()
        points = np.array([line.split() for line in lines if line and "#" not in line], dtype=float)
        self.assertIn("part.svg, in metres", lines[0])
        self.assertLessEqual(abs(abs(area(points)) - math.pi * 1e-4), 0.02 * math.pi * 1e-5)

    def test_holes_are_separate_polygons_of_the_file(self):
        path = self.write("part.svg", HEAD + '<g fill="none"><rect x="10" y="10" width="30" height="30"/><circle cx="25" cy="25" r="5"/></g></svg>')
        self.assertEqual(run("rhegma-mesh", path, "-o", self.path("part.txt"))[0], 0)
        with open(self.path("part.txt")) as file:
            blocks = file.read().strip().split("\n\n")
        self.assertEqual((len(blocks), len(blocks[0].splitlines())), (2, 5))

    def test_the_default_tolerance_follows_the_part(self):
        drawing = read_drawing(self.write("part.svg", HEAD + '<circle cx="50" cy="20" r="10"/></svg>'))
        # From points that are at most 60 degrees apart on the circle.
        self.assertTrue(0.02 * math.cos(math.pi / 6) <= extent_of(drawing.shapes) <= 0.02 * (1.0 + 1e-12))  # but for rounding

    def test_mistakes(self):
        self.assert_fails(run("rhegma-mesh", self.path("absent.svg")), "there is no file")
        self.assert_fails(run("rhegma-mesh", self.write("a.dxf", "")), "is neither an SVG drawing (.svg) nor a STEP file")
        self.assert_fails(run("rhegma-mesh", self.write("a.svg", "<svg")), "is no XML")
        self.assert_fails(run("rhegma-mesh", self.write("b.svg", HEAD + "</svg>")), "the drawing has no shapes")
        self.assert_fails(run("rhegma-mesh", self.write("c.svg", HEAD + '<path d="M 0 0 L 1 x"/></svg>')), 'the path has "x" where a number is expected')
        self.assert_fails(run("rhegma-mesh", self.write("d.svg", HEAD + '<line x2="5"/></svg>')), "no closed outline, but 1 open lines")
        self.assert_fails(run("rhegma-mesh", self.path("a.svg"), "--tolerance", "0"), "must be a length above zero")
        self.assert_fails(run("rhegma-mesh", self.path("a.svg"), "--size", "1 mm"), "--size does not apply")
        with self.assertRaisesRegex(Problem, "where a command is expected"):
            read_path("0 0 L 1 1")


    def test_positions_in_the_style(self):
        """Properties of the attribute style are those of the element, and come before its attributes."""
        for one, other in (('<rect style="x:10px;y:5;width:20px; height : 30px" x="1" width="2"/>', '<rect x="10" y="5" width="20" height="30"/>'),
                           ('<rect style="x:10;y:5;width:20;height:30;rx:3"/>', '<rect x="10" y="5" width="20" height="30" rx="3"/>'),
                           ('<circle style="cx:30;cy:20;r:7 !important" r="2"/>', '<circle cx="30" cy="20" r="7"/>'),
                           ('<ellipse cx="30" style="cy:20;rx:7px;ry:4"/>', '<ellipse cx="30" cy="20" rx="7" ry="4"/>'),
                           ("<path style=\"d:path('M 10 10 H 20 V 20 Z')\" d=\"\"/>", '<path d="M 10 10 H 20 V 20 Z"/>')):
            with self.subTest(one):
                np.testing.assert_array_equal(self.polygons(one), self.polygons(other))
        with self.assertRaisesRegex(Problem, "d: none"):
            self.polygons('<path style="d: none"/>')

    def test_transforms_in_the_style(self):
        square, chance = '<rect x="45" y="20" width="8" height="4" {}/>', np.random.default_rng(SEED)
        angle, x, y = chance.uniform(-90, 90), *chance.uniform(-5, 5, 2)
        for one, other in ((f'style="transform: rotate({angle}deg)"', f'transform="rotate({angle})"'),
                           (f'style="transform:translate({x}px, {y}px) rotate({math.radians(angle)}rad) scale(0.5)" transform="scale(9)"',
                            f'transform="translate({x} {y}) rotate({angle}) scale(0.5)"'),
                           ('style="transform:translateX(3px) translateY(2px) scaleX(2) scaleY(0.5) rotate(0.1turn)"',
                            'transform="translate(3 2) scale(2 0.5) rotate(36)"'),
                           ('style="transform: none" transform="scale(9)"', ""), ('style="transform: skew(10deg, 20deg)"',
                            f'transform="matrix(1 {math.tan(math.radians(20))} {math.tan(math.radians(10))} 1 0 0)"'),
                           (f'transform="rotate({angle})" transform-origin="{40 + x} {20 + y}"', f'transform="rotate({angle} {40 + x} {20 + y})"'),
                           (f'style="transform:rotate({angle}deg);transform-origin:{40 + x}px {20 + y}px"', f'transform="rotate({angle} {40 + x} {20 + y})"'),
                           ('transform-origin="50% 50%"', "")):
            with self.subTest(one):
                # Both are the same product of matrices but for rounding of coordinates below 1 m.
                np.testing.assert_allclose(self.polygons(square.format(one)), self.polygons(square.format(other)), atol=1e-14)
        for wrong, words in (('transform="rotate(30)" transform-origin="50% 50%"', 'transform-origin "50% 50%" is not read'),
                             ('transform="rotate(30)" transform-origin="center"', 'transform-origin "center" is not read'),
                             ('style="transform:rotate(30deg);transform-box:fill-box"', "transform-box"),
                             ('style="rotate: 30deg"', "style .rotate: 30deg. is not"), ('transform="rotate(30) 5"', "can't be read"),
                             ('transform="rotate(30mm)"', "can't be read"), ('style="transform:rotateX(3deg)"', "can't be read")):
            with self.subTest(wrong), self.assertRaisesRegex(Problem, words):
                self.polygons(square.format(wrong))

    def test_symbols(self):
        rect = '<rect x="1" y="2" width="4" height="3"/>'
        for symbol, use, same in (("", 'x="20" y="10"', '<rect x="21" y="12" width="4" height="3"/>'),
                                  # 2 units of the page for one of the symbol, in the middle of 40 x 20: 10 to the right.
                                  ('viewBox="0 0 10 10"', 'x="20" y="10" width="40" height="20"', '<rect x="32" y="14" width="8" height="6"/>'),
                                  ('viewBox="1 2 10 10" preserveAspectRatio="none"', 'x="20" y="10" width="40" height="20"',
                                   '<rect x="20" y="10" width="16" height="6"/>'),
                                  ('viewBox="0 0 10 10" width="20" height="20"', 'x="20" y="10"', '<rect x="22" y="14" width="8" height="6"/>')):
            with self.subTest(symbol):
                polygons = self.polygons(f'<symbol id="a" {symbol}>{rect}</symbol><use href="#a" {use}/>')
                np.testing.assert_allclose(polygons, self.polygons(same), atol=1e-14)
        for wrong in ('<symbol id="a" viewBox="0 0 10 10">', '<symbol id="a" viewBox="0 0 1 1" preserveAspectRatio="xMinYMin" width="5" height="5">'):
            with self.subTest(wrong), self.assertRaisesRegex(Problem, 'symbol "a" has a viewBox'):
                self.polygons(f'{wrong}{rect}</symbol><use href="#a"/>')

    def test_what_cuts_is_named(self):
        cuts = '<defs><clipPath id="c"><rect width="20" height="50"/></clipPath><mask id="m"><rect width="9" height="9"/></mask></defs>'
        drawing = self.write("part.svg", HEAD + cuts + '<g clip-path="url(#c)"><rect x="10" y="10" width="20" height="30"/></g>'
                             '<rect x="40" y="10" width="5" height="5" style="mask:url(#m);clip-path:none"/></svg>')
        status, output, messages = run("rhegma-mesh", drawing, "-o", self.path("part.txt"))
        self.assertEqual((status, messages), (0, ""))
        for name in ("clip-path", "mask"):
            self.assertIn(f"{name} is not used (1); what it would cut away is part of the polygons.", output)
        for sheet, count in (("rect { clip-path: url(#c) }", 1), ("rect { stroke-width: 2; marker-mid: none }", 0), (".a{x:3px}", 1)):
            with self.subTest(sheet):
                drawing = read_drawing(self.write("b.svg", HEAD + f"<style>{sheet}</style><rect width='5' height='5'/></svg>"))
                self.assertEqual(drawing.skipped.get("style sheet", 0), count)

    def test_drawings_without_an_outline(self):
        for content, words in (('<path d="M10 10 L50 50 L50 10 L10 50 Z"/>',
                                ["cross or touch near x = 0.03 m, y = 0.02 m, or one crosses itself there"]),
                               ('<rect x="10" y="10" width="20" height="30" transform="scale(0)"/>', ["all of its shapes are in one point", "a scale"]),
                               ('<svg x="10" y="10"><rect width="5" height="5"/></svg><text/>',
                                ["no shapes that are read", "svg in another svg (1), text (1)"]),
                               ('<path d="M10 10 L50 50 L20 20 Z"/>', ["no closed outline, but 1 whose points are on one line"])):
            with self.subTest(content):
                drawing = self.write("part.svg", HEAD + content + "</svg>")
                self.assert_fails(run("rhegma-mesh", drawing, "-o", self.path("part.txt")), *words)

    def test_a_tolerance_that_needs_too_many_points(self):
        circle = '<circle cx="50" cy="20" r="10"/>'
        with self.assertRaisesRegex(Problem, r"needs 7e\+06 points, which is too many; it can be \S+ m or larger") as caught:
            self.polygons(circle, tolerance=1e-15)
        least = float(re.search(r"it can be (\S+) m", str(caught.exception)).group(1))
        polygon, = self.polygons(circle, tolerance=least)
        # Edges over an angle a are r a^2 / 8 away: 2 pi sqrt(r / (8 tolerance)) of them. The tolerance is found in steps of 1.5, rounded up by 12 % at most.
        self.assertTrue(1e5 / math.sqrt(1.7) <= len(polygon) <= 1e5 + 13, len(polygon))
        self.assertAlmostEqual(len(polygon) / (2 * math.pi * math.sqrt(0.01 / (8 * least))), 1.0, places=3)
        with self.assertRaisesRegex(Problem, "too many"):
            self.polygons('<path d="M10 30 C10 10 40 10 40 30 Z"/>', tolerance=1e-15)
        self.assertEqual(len(self.polygons('<rect width="5" height="5"/>', tolerance=1e-15)[0]), 4)


class Neighbours(ToolTest):
    """What finds edges and loops that are near each other, against a comparison of all with all."""

    def test_edges_with_overlapping_boxes(self):
        chance = np.random.default_rng(SEED)
        begin = np.round(chance.uniform(0, 1, (300, 2)), 2)  # rounded, so that some boxes touch
        end = begin + np.round(chance.normal(0, [0.02, 0.3], (300, 2)), 2)
        low, high = np.minimum(begin, end), np.maximum(begin, end)
        expected = {frozenset((i, j)) for i in range(300) for j in range(i) if np.all(low[i] <= high[j]) and np.all(low[j] <= high[i])}
        self.assertGreater(len(expected), 300)
        for at_once in (1, 1000, svg_outlines.AT_ONCE):
            with self.subTest(at_once), mock.patch.object(svg_outlines, "AT_ONCE", at_once):
                pairs = [pair for i, j in svg_outlines.near_pairs(low, high) for pair in zip(i, j)]
                self.assertEqual(len(pairs), len(expected))
                self.assertEqual({frozenset(map(int, pair)) for pair in pairs}, expected)

    def test_a_grid_of_squares_needs_few_comparisons(self):
        """Squares that are apart: no edge is compared, and no square is asked whether it is inside another."""
        corners = np.array([[0.0, 0.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]])
        loops = [svg_outlines.Loop(corners + [x, y], 0) for x in range(30) for y in range(30)]
        with mock.patch.object(svg_outlines, "crosses", wraps=svg_outlines.crosses) as compared:
            self.assertIsNone(svg_outlines.first_crossing(loops))
        # Boxes of edges of different squares are apart; within a square only neighbours touch.
        self.assertEqual(sum(len(call.args[0]) for call in compared.call_args_list), 0)
        with mock.patch.object(svg_outlines, "is_inside", wraps=svg_outlines.is_inside) as asked:
            self.assertEqual(len(svg_outlines.boundaries(loops, {0: False})), 900)
        self.assertEqual(asked.call_count, 0)

    def test_loops_around_others(self):
        chance = np.random.default_rng(SEED)
        circle = np.exp(2j * np.pi * np.arange(12) / 12)
        polygons = [np.c_[c.real, c.imag] for c in (x + 1j * y + r * circle for x, y, r in chance.uniform(0, 1, (60, 3)))]
        expected = [[j for j, other in enumerate(polygons) if j != i and svg_outlines.is_inside(0.5 * (one[0] + one[1]), other)]
                    for i, one in enumerate(polygons)]
        self.assertGreater(sum(map(len, expected)), 60)
        self.assertEqual([list(around) for around in svg_outlines.loops_around(polygons)], expected)


class StepFiles(ToolTest):
    def test_without_gmsh(self):
        step = self.write("part.step", "ISO-10303-21;")
        self.assert_fails(run("rhegma-mesh", step, PATH=self.folder), "gmsh is not on the PATH")

    def test_with_a_program_in_place_of_gmsh(self):
        step, command = self.write("part.stp", "ISO-10303-21;"), self.write("gmsh", (
            "#!/bin/sh\nprintf '%s\\n' \"$@\" > \"$0.arguments\"\nwhile [ $# -gt 0 ]; do [ \"$1\" = -o ] && echo solid > \"$2\"; shift; done\n"))
        os.chmod(command, os.stat(command).st_mode | stat.S_IXUSR)
        status, output, messages = run("rhegma-mesh", step, "-o", self.path("part.stl"), "--size", "2 mm", PATH=f"{self.folder}:{os.environ['PATH']}")
        self.assertEqual((status, messages), (0, ""))
        self.assertTrue(os.path.exists(self.path("part.stl")))
        with open(self.path("gmsh.arguments")) as file:
            arguments = file.read().splitlines()
        self.assertEqual(arguments[:4], [step, "-2", "-format", "stl"])
        self.assertEqual(arguments[arguments.index("-clmax") + 1], "0.002")
        self.write("gmsh", "#!/bin/sh\necho 'Error   : Unknown shape' >&2\nexit 1\n")
        self.assert_fails(run("rhegma-mesh", step, PATH=f"{self.folder}:{os.environ['PATH']}"), "gmsh can't convert", "Unknown shape")

    @unittest.skipUnless(shutil.which("gmsh"), "there is no gmsh")
    def test_a_part_from_gmsh_itself(self):
        """A block of 12 x 10 x 8 mm with a hole of radius 2.5 mm, as STEP in millimetres. The hole is a regular polygon of at least 40 corners, so that the
        volume is larger by less than that of the segments outside of it, and numbers of a file have 24 bits."""
        geometry = self.write("part.geo", f"""SetFactory("OpenCASCADE");
            Box(1) = {{0, 0, 0, 12, 10, 8}}; Cylinder(2) = {{6, 5, -1, 0, 0, 10, 2.5}};
            BooleanDifference(3) = {{ Volume{{1}}; Delete; }}{{ Volume{{2}}; Delete; }};
            Save "{self.path('part.step')}";""")
        subprocess.run(["gmsh", geometry, "-", "-v", "1"], check=True, timeout=120)
        status, output, messages = run("rhegma-mesh", self.path("part.step"), "-o", self.path("part.stl"))
        self.assertEqual((status, messages), (0, ""))
        triangles = triangles_of(self.path("part.stl"))
        self.assertIn(f"{len(triangles):,} triangles from (0, 0, 0) m to (0.012, 0.01, 0.008) m", output)
        segments = math.pi - 20.0 * math.sin(2.0 * math.pi / 40.0)  # of the unit circle
        exact = 8e-9 * (120.0 - math.pi * 2.5**2)
        self.assertGreater(volume_of(triangles), exact * (1.0 - 1e-6))
        self.assertLess(volume_of(triangles), exact * (1.0 + 1e-6) + 8e-9 * 2.5**2 * segments)
