"""Tests of pictures in 3D: their pieces, the colours at fronts, and what VTK draws of them."""

import os
import unittest

from tool import ToolTest, picture_size, run  # first, as it finds the Python for all others

import made_up_run
import numpy as np
from PIL import Image

from rhegma_tools import occupancy, scene_spatial, spatial_picture, style
from rhegma.fields import Crack, read_fields
from rhegma_tools.front_picture import shown_opening
from rhegma_tools.scene_symbols import LOAD, Arrows
from rhegma_tools.spatial_pieces import HALF_FULL, cell_piece, crack_pieces, cut_open, edge_piece, filling, front_segments, outer_faces, outline_pieces
from rhegma_tools.spatial_picture import camera_of, fronts_at_end, scale_bar
from rhegma_tools.vtk_window import Camera, Level, Piece, Window, render

SEED = int(os.environ.get("RHEGMA_SEED", "20261128"))
SQUARE = Piece(np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]), [[0, 1, 2, 3]], [200, 30, 40], flat=True)
FROM_ABOVE = Camera([0.5, 0.5, 0.0], [0, 0, 1], [0, 1, 0], 1.0, (400, 300))
DRAWS = render([SQUARE], FROM_ABOVE) is not None


def brick(folder, shape=(6, 4, 3), edge=0.01):
    """A brick of particles at rest with its lower corner at the origin."""
    start = made_up_run.lattice(*[(np.arange(n) + 0.5) * edge for n in shape])
    made_up_run.write_fields(folder, [(1.0, {"particles": made_up_run.particles(start, 0 * start, np.zeros((len(start), 6)), edge)})])
    return read_fields(folder)


def front_of(position, **values):
    """An entry of a front of the summary with values at its nodes."""
    arc = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(position, axis=0), axis=1))]
    return {"front_nodes": {"position": np.asarray(position).tolist(), "arc_length": arc.tolist(), "line": [0] * len(position),
                            **{name: list(numbers) for name, numbers in values.items()}}}


def circle(radius, count):
    angle = 2 * np.pi * np.arange(count) / count
    return np.c_[radius * np.cos(angle), radius * np.sin(angle), 0 * angle]


class Pieces(ToolTest):
    def test_outer_faces_are_those_of_the_brick(self):
        fields = brick(self.folder)
        owners, faces = outer_faces(fields, np.arange(len(fields.position)))
        self.assertEqual(len(faces), 2 * (6 * 4 + 4 * 3 + 3 * 6))
        self.assertEqual(np.bincount(faces).tolist(), [12, 12, 18, 18, 24, 24])
        np.testing.assert_allclose(fields.position[owners[faces == 5], 2], 0.025)

    def test_a_brick_cut_open_shows_its_inside(self):
        fields = brick(self.folder)
        kept = cut_open(fields, 0, 0.035, -1.0)  # the reader is at low x, and sees the layer at the cut
        self.assertAlmostEqual(fields.position[kept, 0].min(), 0.035)
        owners, faces = outer_faces(fields, kept)
        self.assertEqual((faces == 0).sum(), 12)
        np.testing.assert_allclose(fields.position[owners[faces == 0], 0], 0.035)

    def test_a_refined_brick_has_the_surface_of_a_whole_one(self):
        """Particles split at random, in halves of halves: their outer faces have the area of the brick, and its edges the length."""
        print(f"seed {SEED}")
        chance = np.random.default_rng(SEED)
        middle = made_up_run.lattice(*[np.arange(n) + 0.5 for n in (5, 4, 3)]) + chance.uniform(-9, 9, 3)
        extent = np.ones(len(middle))
        for level in (1, 2):
            split = chance.random(len(middle)) < 0.4
            corners = made_up_run.lattice(*3 * [np.array([-0.25, 0.25])])
            parts = (middle[split][:, None, :] + extent[split][:, None, None] * corners).reshape(-1, 3)
            middle = np.concatenate([middle[~split], parts])
            extent = np.concatenate([extent[~split], np.repeat(0.5 * extent[split], 8)])
        group = made_up_run.particles(middle, 0 * middle, np.zeros((len(middle), 6)), 1.0)
        group["edges"] = (extent[:, None, None] * np.eye(3)).reshape(-1, 9)
        made_up_run.write_fields(self.folder, [(1.0, {"particles": group})])
        fields = read_fields(self.folder)
        owners, _ = outer_faces(fields, np.arange(len(middle)))
        self.assertAlmostEqual((extent[owners] ** 2).sum(), 2 * (20 + 12 + 15), places=9)
        points = edge_piece(fields, 1.0, "#000000").points.reshape(-1, 2, 3)
        self.assertAlmostEqual(np.linalg.norm(points[:, 1] - points[:, 0], axis=1).sum(), 4 * 12.0, places=9)

    def test_no_gaps_are_left_at_boxes_that_a_surface_cuts(self):
        fields = brick(self.folder, (8, 5, 4))
        cut = 7  # its box is smaller than its share of space: a gap parts it from all its neighbours
        fields.edges[cut] *= 0.7
        everyone = np.arange(len(fields.position))
        near = np.abs(fields.position - fields.position[cut]).sum(axis=1)
        neighbours = np.count_nonzero((near > 1e-9) & (near < 0.0101))
        owners, faces = outer_faces(fields, everyone, seamless=True)
        outside, _ = outer_faces(fields, everyone)
        self.assertEqual(np.count_nonzero(owners == cut), 6)
        self.assertEqual(len(faces), len(outside) + (6 - np.count_nonzero(outside == cut)) + neighbours)
        for number in np.unique(faces):
            self.assertEqual(len(np.unique(owners[faces == number])), np.count_nonzero(faces == number))

    def test_a_brick_of_equal_boxes_has_no_more_faces(self):
        fields = brick(self.folder)
        for one, other in zip(outer_faces(fields, np.arange(72), seamless=True), outer_faces(fields, np.arange(72))):
            np.testing.assert_array_equal(one, other)

    def test_the_opening_of_a_crack_is_negative_where_its_faces_overlap(self):
        points = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
        cells = np.array([[0, 1, 2], [0, 2, 3]])
        opening = np.array([[0.0, 0, 3e-6], [4e-6, 0, 3e-6], [0, 0, 1e-6], [0, 0, 0]])
        shown, overlap = shown_opening(Crack(points, cells, opening))
        self.assertFalse(overlap)
        np.testing.assert_allclose(shown, [3e-6, 5e-6, 1e-6, 0.0])
        opening[2, 2] = -1e-6
        shown, overlap = shown_opening(Crack(points, cells, opening))
        self.assertTrue(overlap)
        np.testing.assert_allclose(shown, [3e-6, 3e-6, -1e-6, 0.0])

    def test_edges_of_a_brick(self):
        fields = brick(self.folder)
        piece = edge_piece(fields, 1.0, "#000000")
        self.assertEqual(len(piece.cells), 4 * (6 + 4 + 3))
        length = np.linalg.norm(piece.points[piece.cells[:, 1]] - piece.points[piece.cells[:, 0]], axis=1)
        self.assertAlmostEqual(length.sum(), 4 * 0.13)
        on_border = np.isclose(piece.points, 0.0) | np.isclose(piece.points, [0.06, 0.04, 0.03])
        self.assertTrue((on_border.sum(axis=1) >= 2).all())

    def test_a_ball_has_no_edges_but_a_surface(self):
        made_up_run.balls(self.folder)
        self.assertEqual(len(edge_piece(read_fields(self.folder), 1.0, "#000000").cells), 0)

    def test_the_surface_of_curved_bodies_is_where_material_ends(self):
        """The fractions on the lattice sum up to the volume, and are a half at a radius of the balls, to half of the lattice."""
        made_up_run.balls(self.folder)
        fields = read_fields(self.folder)
        values, origin, spacing = filling(fields)
        volume = np.abs(np.linalg.det(fields.boxes())).sum()
        self.assertAlmostEqual(values.sum() * spacing**3 / volume, 1.0, places=12)
        at = origin + spacing * np.stack(np.meshgrid(*map(np.arange, values.shape), indexing="ij"), axis=-1)
        middle = fields.position[fields.body == 0].mean(axis=0)
        other = fields.position[fields.body == 1].mean(axis=0)
        away = np.linalg.norm(at - middle, axis=-1)
        alone = np.linalg.norm(at - other, axis=-1) > 0.2 + 3 * spacing
        self.assertTrue((values[alone & (away < 0.2 - 1.5 * spacing)] > HALF_FULL).all())
        self.assertTrue((values[alone & (away > 0.2 + 1.5 * spacing)] < HALF_FULL).all())
        self.assertIsInstance(outline_pieces(fields)[0], Level)
        os.makedirs(self.path("brick"))
        self.assertNotIsInstance(outline_pieces(brick(self.path("brick")))[0], Level)

    @unittest.skipUnless(DRAWS, "VTK draws nothing here")
    def test_a_level_of_a_field_is_drawn(self):
        """A ball of radius 0.5 in the middle of the picture covers its disk, and nothing else."""
        x = np.linspace(-1.0, 1.0, 41)
        away = np.linalg.norm(np.stack(np.meshgrid(x, x, x, indexing="ij"), axis=-1) - [0.2, 0.0, 0.0], axis=-1)
        picture = render([Level(away, [-1.0] * 3, 0.05, 0.5, [200, 30, 40])], Camera([0.0, 0.0, 0.0], [0, 0, 1], [0, 1, 0], 1.0, (300, 300)))
        shown = (picture < 250).any(axis=2)
        self.assertAlmostEqual(shown.mean(), np.pi * 0.25 / 4.0, delta=0.01)
        columns = np.flatnonzero(shown.any(axis=0))
        self.assertAlmostEqual(0.5 * (columns[0] + columns[-1]), 150 + 0.2 * 150, delta=2.0)

    def test_faces_of_a_penny_part_by_its_opening(self):
        made_up_run.penny(self.folder)
        fields = read_fields(self.folder)
        upper, _, lower, _ = crack_pieces(fields, 100.0)
        apart = upper.points[:, 2] - lower.points[:, 2]
        np.testing.assert_allclose(apart, 100.0 * fields.crack.opening[:, 2], rtol=1e-12)
        middle, border = crack_pieces(fields, None)
        np.testing.assert_allclose(middle.points, fields.crack.points)
        self.assertEqual(len(border.cells), 24)

    def test_a_closed_front_is_drawn_all_around(self):
        nodes = spatial_picture.node_arrays(front_of(circle(0.3, 24), K_I=np.arange(24.0)))
        points, values = front_segments(nodes, "K_I")
        self.assertEqual(len(points), 48)
        self.assertAlmostEqual(np.linalg.norm(points[:, 1] - points[:, 0], axis=1).sum(), 24 * 0.6 * np.sin(np.pi / 24))
        half = np.bincount(np.round(values).astype(int))
        self.assertTrue((half == 2).all())  # half a side to each neighbour has the value of the node
        quarter = spatial_picture.node_arrays(front_of(circle(0.3, 24)[:7], K_I=np.ones(7)))
        self.assertEqual(len(front_segments(quarter, "K_I")[0]), 12)

    def test_fronts_have_the_ratio_to_the_toughness_else_k(self):
        front = front_of(circle(0.3, 24), G_J=np.full(24, 30.0), K_I=np.full(24, 2e5))
        summary = {"time": 1e-3, "cracks": [{"name": "Penny", "fronts": [front]}]}
        found = fronts_at_end(summary, 1e-3)
        self.assertEqual(found.label, "K_I [kPa √m]")
        np.testing.assert_allclose(found.values, 200.0)
        found = fronts_at_end(dict(summary, propagation={"initiation_toughness": 40.0}), 1e-3)
        self.assertEqual(found.label, "G / Gc")
        np.testing.assert_allclose(found.values, 0.75)
        self.assertIsNone(fronts_at_end(summary, 0.5e-3))  # the summary is of the end of the run

    def test_colours_of_a_front_span_a_fifth_of_its_largest_value(self):
        norm = spatial_picture.front_norm(np.array([98.0, 100.0, np.nan]))
        self.assertAlmostEqual(norm.vmin, 89.0)
        self.assertAlmostEqual(norm.vmax, 109.0)
        norm = spatial_picture.front_norm(np.array([10.0, 100.0]))
        self.assertEqual((norm.vmin, norm.vmax), (10.0, 100.0))
        norm = spatial_picture.front_norm(np.array([0.0, np.nan]))
        self.assertEqual((norm.vmin, norm.vmax), (0.0, 1.0))

    def test_cells_of_a_cut(self):
        fields = brick(self.folder)
        low = made_up_run.lattice(*[np.arange(n) * 0.02 for n in (3, 2, 2)])
        corners = low[:, None, :] + 0.02 * made_up_run.lattice(*3 * [np.arange(2)])
        fields.leaves = type("Leaves", (), {"corners": corners, "level": np.zeros(len(corners), int)})()
        view = spatial_picture.choose_view(fields, (2, 0.015))
        piece = cell_piece(fields, view, 1.0)
        self.assertEqual(len(piece.cells), 6)
        np.testing.assert_allclose(piece.points[:, 2], view.where + 0.006)

    def test_the_camera_faces_the_cut_and_turns_to_the_crack(self):
        made_up_run.penny(self.folder)
        fields = read_fields(self.folder)
        view = spatial_picture.choose_view(fields)
        camera, side = camera_of(fields, view, 1.0)
        self.assertGreater(side * camera.toward[view.normal], 0.5)
        self.assertLess(camera.toward[2], 0.5)
        camera, _ = camera_of(fields, view, 1.0, onto=True)
        self.assertGreater(camera.toward[2], 0.5)
        corners = made_up_run.lattice(*3 * [np.array([-0.5, 0.5])])
        pixels = camera.pixels(corners)
        self.assertTrue(((pixels > 0) & (pixels < spatial_picture.SIZE)).all())

    def test_a_small_crack_has_a_close_up(self):
        """It fills the close-up to 1 / 1.35, in its middle also where most points are at one side; a crack of a fifth of the picture has none."""
        square = np.array([[0.5, 0.5, 0.0], [0.6, 0.5, 0.0], [0.6, 0.6, 0.0], [0.5, 0.6, 0.0]])  # 300 pixels are 2 m
        close = spatial_picture.close_up_of(square, FROM_ABOVE)
        np.testing.assert_allclose(close.focus, [0.55, 0.55, 0.0])
        extent = np.ptp(close.pixels(square), axis=0)
        np.testing.assert_allclose(extent, 300 / 1.35)
        oblique = Camera([0.5, 0.5, 0.0], [1, 2, 3], [0, 0, 1], 2.0, (400, 300))
        half_disk = np.c_[0.1 * np.cos(np.linspace(0, np.pi, 30)), 0.1 * np.sin(np.linspace(0, np.pi, 30)), np.zeros(30)]
        pixels = spatial_picture.close_up_of(half_disk, oblique).pixels(half_disk)
        np.testing.assert_allclose(0.5 * (pixels.min(axis=0) + pixels.max(axis=0)), [200, 150])
        self.assertIsNone(spatial_picture.close_up_of(0.5 + 4.1 * (square - 0.5), FROM_ABOVE))

    def test_a_plate_with_a_round_hole_is_curved_and_a_thin_one_is_not(self):
        """Most edges of the hole are steps, so that the plate is drawn as a surface; those of a plate of three layers are its own."""
        for name, hole in (("whole", 0.0), ("holed", 4.2)):
            start = made_up_run.lattice(np.arange(0.5, 24), np.arange(0.5, 16), np.arange(0.5, 3))
            start = start[np.linalg.norm(start[:, :2] - [9.3, 8.2], axis=1) >= hole]
            os.makedirs(self.path(name))
            made_up_run.write_fields(self.path(name), [(1.0, {"particles": made_up_run.particles(start, 0 * start, np.zeros((len(start), 6)), 1.0)})])
            self.assertEqual(isinstance(outline_pieces(read_fields(self.path(name)))[0], Level), hole > 0.0)

    def test_a_table_and_a_list_say_the_same_of_covered_cells(self):
        made_up_run.balls(self.folder)
        fields = read_fields(self.folder)
        everyone = np.arange(len(fields.position))
        before, occupancy.LARGEST_TABLE = occupancy.LARGEST_TABLE, 0
        try:
            listed = outer_faces(fields, everyone)
        finally:
            occupancy.LARGEST_TABLE = before
        for one, other in zip(listed, outer_faces(fields, everyone)):
            np.testing.assert_array_equal(one, other)

    @unittest.skipUnless(DRAWS, "VTK draws nothing here")
    def test_pictures_come_in_the_order_in_which_they_were_sent(self):
        colours = ([200, 30, 40], [30, 40, 200], [40, 200, 30])
        with Window() as window:
            for colour in colours:
                window.send([Piece(SQUARE.points, SQUARE.cells, colour, flat=True)], FROM_ABOVE)
            middles = [window.receive()[150, 200].astype(int) for _ in colours[:2]]  # nobody waits for the last one
        self.assertEqual([int(np.argmax(pixel)) for pixel in middles], [0, 2])

    def test_the_outline_of_a_refined_body_has_no_holes(self):
        """Coarse and fine particles next to each other: no node inside is empty, which would draw a speckle."""
        coarse = made_up_run.lattice(*3 * [np.arange(0.5, 12)])
        parts = (coarse[coarse[:, 0] > 6][:, None, :] + made_up_run.lattice(*3 * [np.array([-0.25, 0.25])])).reshape(-1, 3)
        middle = np.concatenate([coarse[coarse[:, 0] < 6], parts])
        extent = np.r_[np.ones(np.count_nonzero(coarse[:, 0] < 6)), np.full(len(parts), 0.5)]
        group = made_up_run.particles(middle, 0 * middle, np.zeros((len(middle), 6)), 1.0)
        group["edges"] = (extent[:, None, None] * np.eye(3)).reshape(-1, 9)
        made_up_run.write_fields(self.folder, [(1.0, {"particles": group})])
        fields = read_fields(self.folder)
        self.assertEqual(fields.size, 0.5)  # most particles are fine
        values, origin, spacing = filling(fields)
        at = origin + spacing * np.stack(np.meshgrid(*map(np.arange, values.shape), indexing="ij"), axis=-1)
        inside, outside = ((at > 1.5) & (at < 10.5)).all(axis=-1), ((at < -0.8) | (at > 12.8)).any(axis=-1)
        self.assertGreater(values[inside].min(), 0.8)
        self.assertEqual(values[outside].max(), 0.0)

    def test_the_bar_has_the_length_it_names(self):
        figure, axes = style.plt.subplots()
        length = scale_bar(axes, FROM_ABOVE)  # 300 pixels are 2 m
        ends = axes.lines[0].get_xdata()
        self.assertEqual(length, 0.5)
        self.assertAlmostEqual(ends[1] - ends[0], 75.0)
        style.plt.close(figure)

    def test_arrows_of_a_scene_point_along_the_load(self):
        for into, end in ((False, 0.4), (True, 0.0)):
            shafts, heads = scene_spatial.arrow_pieces(Arrows(LOAD, "Pull", "", np.zeros((3, 3)), [0, 0, 2.0], into), 0.4)
            self.assertEqual((len(shafts.cells), len(heads.cells)), (3, 3 * 2 * scene_spatial.SIDES))
            self.assertAlmostEqual(heads.points[:, 2].max(), end)
            self.assertAlmostEqual(shafts.points[:, 2].min(), end - 0.4)


@unittest.skipUnless(DRAWS, "needs VTK for Python and a display such as Xvfb")
class Drawn(ToolTest):
    def test_a_square_has_its_colour_where_the_camera_puts_it(self):
        image = render([SQUARE], FROM_ABOVE)
        self.assertEqual(image.shape, (300, 400, 3))
        red = np.argwhere(np.abs(image.astype(int) - [200, 30, 40]).max(axis=2) < 3)
        self.assertAlmostEqual(len(red), 150 * 150, delta=2 * 600)  # a row of pixels along its border may be blended
        low, high = FROM_ABOVE.pixels(np.array([[0, 1, 0], [1, 0, 0]]))
        self.assertLess(np.abs(red.min(axis=0) - low[::-1]).max(), 2.5)
        self.assertLess(np.abs(red.max(axis=0) + 1 - high[::-1]).max(), 2.5)
        self.assertTrue((image[5, 5] == 255).all())

    def test_a_penny_with_its_front(self):
        made_up_run.penny(self.folder)
        values = np.linspace(1e5, 3e5, 24)
        made_up_run.write_summary(self.folder, scene="penny.xml", time=1e-3,
                                  cracks=[{"name": "Penny", "fronts": [front_of(circle(0.3, 24), K_I=values)]}])
        status, output, messages = run("rhegma-plot", self.folder)
        self.assertEqual((status, messages), (0, ""))
        self.assertIn(f"Wrote {self.path('body.png')}: the body cut open at 0.001 s, displacement times ", output)
        self.assertIn(f"Wrote {self.path('cracks.png')}: cracks at 0.001 s, fronts coloured by K_I [kPa √m].", output)
        self.assertGreater(min(picture_size(self.path("body.png"))), 700)
        with Image.open(self.path("cracks.png")) as picture:
            pixels = np.asarray(picture.convert("RGB")).astype(int).reshape(-1, 3)
        for colour in (style.plt.get_cmap("plasma")(0.0), style.plt.get_cmap("plasma")(0.999)):
            near = np.abs(pixels - np.round(255 * np.array(colour[:3]))).max(axis=1) < 30
            self.assertGreater(near.sum(), 100)  # both ends of the scale, in the bar and at the front

    def test_temperature_and_cells_of_a_body_without_cracks(self):
        made_up_run.balls(self.folder)
        status, output, messages = run("rhegma-plot", self.folder, "--cells", "--slice", "y")
        self.assertEqual((status, messages), (0, ""))
        self.assertIn("body.png", output)
        self.assertFalse(os.path.exists(self.path("cracks.png")))


class WithoutVtk(ToolTest):
    def test_says_what_to_install_and_draws_the_slice(self):
        made_up_run.penny(self.folder)
        os.makedirs(self.path("none", "vtkmodules"))
        self.write(os.path.join("none", "vtkmodules", "__init__.py"), "raise ImportError('hidden')")
        status, output, messages = run("rhegma-plot", self.folder, PYTHONPATH=self.path("none"))
        self.assertEqual((status, messages), (0, ""))
        self.assertEqual(output.count("need VTK for Python and a virtual display"), 1)
        self.assertIn("apt-get install python3-vtk9 xvfb", output)
        self.assertTrue(os.path.exists(self.path("fields.png")))
        self.assertFalse(os.path.exists(self.path("body.png")))
