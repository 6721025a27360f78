"""Tests of rhegma-plot."""

import os
import types
import unittest

from tool import ToolTest, picture_size, run  # first, as it finds the Python for all others

import made_up_run
import numpy as np
from PIL import Image
from matplotlib.colors import to_hex, to_rgb

from rhegma_tools import cell_picture, path_picture, quantity, style
from rhegma_tools.boxes import cut, parallelograms
from rhegma_tools.crack_fronts import crossings
from rhegma_tools.deformation import automatic_magnification, crack_displacement, curved_at_fronts, magnified_faces
from rhegma_tools.colour_scales import GREY, add_bar, colour_scale, scale_of
from rhegma_tools.field_picture import choose_view, clear_of_faces, close_up, crack_segments, drawn_fronts, in_slice, moved_inside
from rhegma_tools.field_picture import read_slice, stop_after, stopped_nodes
from rhegma_tools.style import plt
from rhegma.fields import Crack, far_frame, read_fields
from rhegma.history import read_history


SEED = int(os.environ.get("RHEGMA_SEED", "20261130"))

class Plot(ToolTest):
    def test_draws_a_beam(self):
        made_up_run.beam(self.folder)
        status, output, messages = run("rhegma-plot", self.folder)
        self.assertEqual((status, messages), (0, ""))
        self.assertIn(f"Wrote {self.path('history.png')}: 400 samples, 1 crack front.", output)
        # The ends part by 8 um on a beam of 100 mm; 2000 times 4 um is 8 mm, 8 % of it.
        self.assertIn(f"Wrote {self.path('fields.png')}: 5120 particles at 0.003 s, displacement times 2000.", output)
        for name in ("history.png", "fields.png"):
            width, height = picture_size(self.path(name))
            self.assertGreater(width, 900)
            self.assertGreater(height, 500)

    def test_draws_any_field(self):
        """Dark on the left and bright on the right, as the field is."""
        start = made_up_run.lattice((np.arange(20) + 0.5) * 0.01, (np.arange(8) + 0.5) * 0.01)
        start = np.c_[start, np.zeros(len(start))]
        particles = made_up_run.particles(start, 0 * start, np.zeros((len(start), 6)), 0.01)
        particles["energy_density"] = np.where(start[:, 0] > 0.1, 5000.0, 0.0)
        made_up_run.write_fields(self.folder, [(1.0, {"particles": particles})])
        status, output, messages = run("rhegma-plot", self.folder, "--field", "energy_density")
        self.assertEqual((status, messages), (0, ""))
        picture = np.asarray(Image.open(self.path("fields.png")).convert("RGB")).astype(int)
        dark, bright = (np.abs(picture - colour).sum(axis=2) < 12 for colour in ([68, 1, 84], [253, 231, 36]))
        dark, bright = (np.flatnonzero(mask.sum(axis=0) > 100) for mask in (dark, bright))
        self.assertGreater(len(dark), 100)
        self.assertLess(dark.mean(), bright.mean())
        read = read_fields(self.folder, None, "energy_density")
        self.assertEqual(quantity.unit_of("energy_density", read.values("energy_density")), (1e-3, "kJ/m³"))
        self.assertEqual(quantity.label_of("principal_stress"), "largest principal stress")
        self.assert_fails(run("rhegma-plot", self.folder, "--field", "colour"), "no field colour", "energy_density")

    def test_numbers_have_a_colour_each(self):
        """Pieces, bodies, levels: no scale from -1 to 1, but a colour a number, grey for the unknown one."""
        colours, norm = scale_of("piece", np.array([0.0, -1.0, 3.0, 1.0, 1.0]), True)
        self.assertEqual(norm.numbers, [-1, 0, 1, 3])
        drawn = [to_hex(colours(norm(number))).upper() for number in norm.numbers]
        self.assertEqual(drawn[0], GREY)
        self.assertEqual(len(set(drawn)), 4)
        self.assertEqual(to_hex(scale_of("body", np.zeros(3), True)[0](0)).upper(), drawn[1])  # one number alone
        for several in (scale_of("lineage", np.arange(100.0), True), scale_of("temperature", np.array([1.0, 2.0]), True)):
            self.assertFalse(hasattr(several[1], "numbers"))
        figure, axes = plt.subplots()
        bar = add_bar(figure, plt.cm.ScalarMappable(norm, colours), axes, "piece")
        self.assertEqual([text.get_text() for text in bar.ax.get_yticklabels()], ["unknown", "0", "1", "3"])
        plt.close(figure)

    def test_draws_pieces(self):
        """Of a run with temperatures, too, whose picture stays that of temperatures; and as a film."""
        start = made_up_run.lattice((np.arange(20) + 0.5) * 0.01, (np.arange(8) + 0.5) * 0.01)
        start = np.c_[start, np.zeros(len(start))]
        frames = []
        for time in (0.0, 1.0, 2.0):
            particles = made_up_run.particles(start, 0 * start, np.zeros((len(start), 6)), 0.01)
            particles["piece"] = np.where(start[:, 0] > 0.1, 1, 0) if time else np.zeros(len(start), int)
            particles["temperature"] = np.full(len(start), 300.0)
            frames.append((time, {"particles": particles}))
        made_up_run.write_fields(self.folder, frames)
        status, _, messages = run("rhegma-plot", self.folder, "--field", "piece")
        self.assertEqual((status, messages), (0, ""))
        picture = np.asarray(Image.open(self.path("fields.png")).convert("RGB")).astype(int)
        for colour in style.COLOURS[:2]:
            self.assertGreater((np.abs(picture - np.round(255 * np.array(to_rgb(colour)))).sum(axis=2) < 6).sum(), 10000)
        fields = read_fields(self.folder, None, "piece")
        self.assertTrue(fields.counts)
        self.assertEqual(set(fields.values("temperature")), {300.0})
        status, output, messages = run("rhegma-film", self.folder, "--field", "piece", "--output", self.path("film.gif"))
        self.assertEqual((status, messages), (0, ""))
        self.assertIn("piece 0, 1.", output)
        with Image.open(self.path("film.gif")) as last:
            last.seek(2)
            seen = np.asarray(last.convert("RGB")).astype(int)
        for colour in style.COLOURS[:2]:
            self.assertGreater((np.abs(seen - np.round(255 * np.array(to_rgb(colour)))).sum(axis=2) < 30).sum(), 5000)

    def test_draws_a_slice_of_3d(self):
        made_up_run.penny(self.folder)
        status, output, messages = run("rhegma-plot", self.folder, "--stress", "mises", "--magnify", "10",
                                        "--output", self.path("pictures"))
        self.assertEqual((status, messages), (0, ""))
        self.assertIn("displacement times 10.", output)
        self.assertGreater(picture_size(self.path("pictures", "fields.png"))[1], 500)
        self.assertFalse(os.path.exists(self.path("fields.png")))

    def test_draws_cells_where_some_are_refined(self):
        made_up_run.refined_plate(self.folder, levels=(0, 0))
        status, output, messages = run("rhegma-plot", self.folder)
        self.assertEqual((status, messages), (0, ""))
        self.assertNotIn("cells.png", output)  # all alike
        made_up_run.refined_plate(self.folder, levels=(0, 1))
        status, output, messages = run("rhegma-plot", self.folder)
        self.assertEqual((status, messages), (0, ""))
        self.assertIn(f"Wrote {self.path('cells.png')}: 5 cells at 0.002 s.", output)
        self.assertGreater(picture_size(self.path("cells.png"))[0], 900)

    def test_close_up_is_of_the_smallest_cells(self):
        low = np.array([[0.0, 0.0], [1.0, 0.0], [1.5, 0.0], [1.0, 0.5], [1.5, 0.5], [2.0, 0.0]])
        high = low + np.array([1.0, 0.5, 0.5, 0.5, 0.5, 1.0])[:, None]
        level = np.array([0, 1, 1, 1, 1, 0])
        corner, opposite = cell_picture.close_up(low, high, level)
        shape = opposite - corner
        self.assertAlmostEqual(shape[0], 2.5 * shape[1])
        self.assertAlmostEqual(shape[1], 2.0)  # the middles are 0.5 m apart, and three cells of 0.5 m more
        middle = 0.5 * (corner + opposite)
        self.assertTrue(np.all((middle > [1.0, 0.0]) & (middle < [2.0, 1.0])))

    def test_draws_the_path_of_a_crack_in_equilibrium(self):
        length = np.linspace(0.04, 0.06, 21)
        factor = 1.0 / length
        made_up_run.write_history(self.folder, {
            "time": np.linspace(0.05, 1.0, 21), "load_factor": factor, "Arm.force_x": 0.0 * factor, "Arm.force_y": -3.0 * factor,
            "Arm.displacement": factor * length**3, "Grip.force_y": factor, "Grip.displacement_y": -length,
            "Notch.0.length": length, "Notch.0.speed": 0.0 * length, "Notch.0.G_J": 100.0 + 0.0 * length})
        (load, x, force), (grip, y, _) = path_picture.curves(read_history(self.folder))
        self.assertEqual((load, grip), ("Arm", "Grip, y"))
        self.assertTrue(np.allclose(force, 3.0 * factor) and np.allclose(x, length**2) and np.allclose(y, length))
        status, output, messages = run("rhegma-plot", self.folder)
        self.assertEqual((status, messages), (0, ""))
        self.assertIn(f"Wrote {self.path('path.png')}: 21 states of equilibrium, 2 loads.", output)
        self.assertGreater(picture_size(self.path("path.png"))[1], 500)

    def test_names_the_time_of_a_frame_that_is_not_the_one_asked_for(self):
        made_up_run.beam(self.folder)  # with fields at 0 and 3 ms
        status, output, messages = run("rhegma-plot", self.folder, "--time", "0.01")
        self.assertEqual((status, messages), (0, ""))
        self.assertEqual(output.count("There are no fields"), 1)
        self.assertIn("There are no fields at 0.01 s; those at 0.003 s are drawn (the 2 frames are from 0 to 0.003 s).", output)
        status, output, messages = run("rhegma-plot", self.folder, "--time", "2.9e-3")
        self.assertEqual((status, messages), (0, ""))
        self.assertNotIn("There are no fields", output)
        self.assertIn("particles at 0.003 s", output)

    def test_draws_what_there_is(self):
        made_up_run.beam(self.folder)
        os.remove(self.path("fields.h5"))
        os.remove(self.path("summary.json"))
        status, output, _ = run("rhegma-plot", self.folder)
        self.assertEqual(status, 0)
        self.assertEqual(output.count("Wrote"), 1)

    def test_refuses_what_is_no_run(self):
        self.assert_fails(run("rhegma-plot", self.path("nowhere")), "there is no folder", "nowhere")
        self.assert_fails(run("rhegma-plot", self.folder), "neither history.csv nor fields.h5")
        self.assert_fails(run("rhegma-plot", self.write("file", "")), "is no folder")
        self.assert_fails(run("rhegma-plot", self.folder, "--magnify", "0"), "--magnify", "positive")
        self.assert_fails(run("rhegma-plot", self.folder, "--time", "nan"), "--time", "seconds")
        self.assert_fails(run("rhegma-plot"), "DIR")

    def test_run_that_stopped_after_its_fields(self):
        fields = types.SimpleNamespace(time=1.91e-4)
        stopped = {"status": "the run stopped at t = 738.2 us, step 10138: a particle left the domain", "time": 7.382e-4}
        self.assertEqual(stop_after(fields, stopped), ["before the run stopped at t = 738.2 µs"])
        self.assertEqual(stop_after(fields, dict(stopped, time=1.91e-4)), [])
        self.assertEqual(stop_after(fields, dict(stopped, status="completed")), [])
        self.assertEqual(stop_after(fields, None), [])

    def test_refuses_broken_files(self):
        self.write("history.csv", "")
        self.assert_fails(run("rhegma-plot", self.folder), "history.csv", "no column named time")
        self.write("history.csv", "time,kinetic\n")
        self.assert_fails(run("rhegma-plot", self.folder), "history.csv", "no sample")
        self.write("history.csv", "time,kinetic\n0.0,1.0\n1.0,much\n2.0,1.0\n")
        self.assert_fails(run("rhegma-plot", self.folder), "row 3", "no number")
        self.write("history.csv", "time,kinetic\n0.0,1.0\n")
        self.write("summary.json", '{"scene": "a')
        self.assert_fails(run("rhegma-plot", self.folder), "summary.json", "cut off")

    def test_refuses_broken_fields(self):
        made_up_run.beam(self.folder)
        os.remove(self.path("history.csv"))
        with open(self.path("fields.h5"), "r+b") as file:
            file.truncate(os.path.getsize(self.path("fields.h5")) // 2)
        self.assert_fails(run("rhegma-plot", self.folder), "fields.h5", "truncated")
        made_up_run.write_fields(self.folder, [])
        self.assert_fails(run("rhegma-plot", self.folder), "fields.h5", "no written time")
        none = made_up_run.particles(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros((0, 6)), 1.0)
        made_up_run.write_fields(self.folder, [(0.0, {"particles": none})])
        self.assert_fails(run("rhegma-plot", self.folder), "fields.h5", "no particle")
        wild = made_up_run.particles(np.zeros((1, 3)), np.full((1, 3), np.nan), np.zeros((1, 6)), 1.0)
        made_up_run.write_fields(self.folder, [(0.0, {"particles": wild})])
        self.assert_fails(run("rhegma-plot", self.folder), "fields.h5", "not finite")

    def test_an_interpreter_without_packages_says_so(self):
        """Packages that can't be imported hide the real ones; the system's Python counts as tried."""
        made_up_run.beam(self.folder)
        for name in ("numpy", "h5py", "matplotlib"):
            os.makedirs(self.path("broken", name))
            self.write(os.path.join("broken", name, "__init__.py"), "raise ImportError('hidden')")
        answer = run("rhegma-plot", self.folder, PYTHONPATH=self.path("broken"),
                     RHEGMA_TOOLS_TRIED_SYSTEM_PYTHON="/other/python3")
        self.assert_fails(answer, "/other/python3 and ", "lack numpy, h5py, matplotlib", "apt-get install")


class Deformation(ToolTest):
    def test_magnification_is_round_and_at_most_wanted(self):
        """1 mm on 1 m: 8 % would be 80 times; 50 is the round number below. 30 mm can be seen as it is."""
        positions = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
        moved = np.array([[0.0, 0.0, 0.0], [0.0, 1.0e-3, 0.0]])
        rigid = np.array([np.eye(3)] * 2)
        self.assertEqual(automatic_magnification(positions, moved, rigid), 50.0)
        self.assertEqual(automatic_magnification(positions, 30.0 * moved, rigid), 1.0)
        self.assertEqual(automatic_magnification(positions, 0.0 * moved, rigid), 1.0)

    def test_magnified_particles_are_not_turned_inside_out(self):
        """A strain of -1 %, which 100 times would make -1: 20 times is the round number below 40, at which particles keep 0.6 of their size."""
        positions = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
        moved = np.array([[0.0, 0.0, 0.0], [0.0, 0.5e-3, 0.0]])
        pressed = np.array([np.diag([0.99, 1.0, 1.0])] * 2)
        self.assertEqual(automatic_magnification(positions, moved, pressed), 20.0)
        torn = np.array([np.diag([3.0, 1.0, 1.0])] * 2)
        self.assertEqual(automatic_magnification(positions, moved, torn), 1.0)

    def test_crack_moves_with_both_sides(self):
        """The upper particles move by +3, the lower by -1: the crack's middle by 1, opened by 4, drawn 10 times."""
        positions = np.array([[0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, -1.0, 0.0], [1.0, -1.0, 0.0]])
        moved = np.array([[0.0, 3.0, 0.0]] * 2 + [[0.0, -1.0, 0.0]] * 2)
        crack = Crack(np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]), np.array([[0, 1]]), np.array([[0.0, 4.0, 0.0]] * 2))
        np.testing.assert_allclose(crack_displacement(crack, positions, moved)[:, 1], [1.0, 1.0], rtol=1e-14)
        upper, lower = magnified_faces(crack, positions, moved, 10.0)
        np.testing.assert_allclose(upper[:, 1], [29.0, 29.0], rtol=1e-14)  # 9 * 1 + 10 * 4 / 2
        np.testing.assert_allclose(lower[:, 1], [-11.0, -11.0], rtol=1e-14)


    def test_an_end_on_another_crack_moves_with_its_own_side_of_that(self):
        """A crack along x goes through; another comes up to it from below. The piece above moves by 5, the two below by
        1 and 3: the end by 2, however near the piece above is."""
        points = np.array([[-2.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 0.0]])
        positions = np.array([[-0.1, 0.1, 0.0], [0.1, 0.1, 0.0], [-0.3, -0.3, 0.0], [0.3, -0.3, 0.0]])
        moved = np.array([[0.0, 5.0, 0.0]] * 2 + [[0.0, 1.0, 0.0], [0.0, 3.0, 0.0]])
        crack = Crack(points, np.array([[0, 1], [2, 3]]), np.zeros_like(points))
        np.testing.assert_allclose(crack_displacement(crack, positions, moved)[3, 1], 2.0, rtol=1e-14)

    def test_faces_part_with_a_power_of_the_distance_from_a_front(self):
        """Straight from x = 0 to 1, open by 2 at both; closed at the front x = 2. Particles halfway to it have parted by
        2 sqrt(1/2), so the root of the distance is drawn; by 1/2, and its square is."""
        points = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]])
        opening = np.array([[0.0, 2.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.0]])
        crack = Crack(points, np.array([[0, 1], [1, 2]]), opening)
        faces = (points + 0.5 * opening, points - 0.5 * opening)
        positions = np.array([[1.4, 0.3, 0.0], [1.6, 0.3, 0.0], [1.4, -0.3, 0.0], [1.6, -0.3, 0.0]])
        part = np.array([[0.0, 0.5, 0.0]] * 2 + [[0.0, -0.5, 0.0]] * 2)
        upper, lower = curved_at_fronts(crack, faces, positions, 2.0 * np.sqrt(0.5) * part)
        self.assertEqual(upper.shape, (17, 2, 3))
        np.testing.assert_allclose(upper[0], [[0.0, 1.0, 0.0], [1.0, 1.0, 0.0]])
        np.testing.assert_allclose(upper[8, 1], [1.5, np.sqrt(0.5), 0.0])
        np.testing.assert_allclose(lower[8, 1], [1.5, -np.sqrt(0.5), 0.0])
        np.testing.assert_allclose(upper[-1, 1], [2.0, 0.0, 0.0])
        upper, _ = curved_at_fronts(crack, faces, positions, 0.5 * part)
        np.testing.assert_allclose(upper[8, 1], [1.5, 0.25, 0.0])


class FieldPicture(ToolTest):
    def test_reads_the_last_time(self):
        made_up_run.beam(self.folder)
        fields = read_fields(self.folder)
        self.assertEqual((fields.time, fields.dimension), (3.0e-3, 2))
        self.assertEqual(fields.crack.cells.shape, (40, 2))

    def test_a_frame_is_far_beyond_half_of_the_interval(self):
        """Frames each 1 ms, with one of them missing at 4 ms: it is missed by 1 ms, the others by half at most."""
        made_up_run.beam(self.folder)
        with_times = read_fields(self.folder)
        for written, asked, nearest, far in (([0, 1, 2, 3, 5, 6], 4.0, 3, True), ([0, 1, 2, 3, 5, 6], 2.4, 2, False),
                                             ([0, 1, 2], -0.1, 0, True), ([0, 1, 2], 2.1, 2, True), ([0, 1, 2], 2.0000001, 2, False),
                                             ([2], 2.0, 2, False), ([2], 1.9, 2, True)):
            with_times.written, with_times.time = [1e-3 * t for t in written], 1e-3 * nearest
            self.assertEqual(far_frame(with_times, 1e-3 * asked) is not None, far, (written, asked))
        self.assertIn("the only frame is at 0.002 s", far_frame(with_times, 1.9e-3))

    def test_reads_the_time_nearest_to_the_one_asked_for(self):
        made_up_run.beam(self.folder)  # with fields at 0 and 3 ms
        self.assertEqual([read_fields(self.folder, time).time for time in (-1.0, 1.4e-3, 1.6e-3, 9.0)],
                         [0.0, 0.0, 3.0e-3, 3.0e-3])

    def test_largest_principal_stress(self):
        """Pure shear of 3 has principal stresses 3, 0, -3; uniaxial pressure of 2 has 0, 0, -2."""
        made_up_run.write_fields(self.folder, [(0.0, {"particles": made_up_run.particles(
            np.zeros((2, 3)), np.zeros((2, 3)), np.array([[0, 0, 0, 3.0, 0, 0], [0, 0, -2.0, 0, 0, 0]]), 1.0)})])
        np.testing.assert_allclose(read_fields(self.folder).largest_principal_stress(), [3.0, 0.0], atol=1e-14)

    def test_slice_of_3d_cuts_a_straight_front(self):
        """A crack from the edge of a cube in the plane z = 0, whose front runs along x or along y: the slice lies across it."""
        made_up_run.penny(self.folder)
        fields = read_fields(self.folder)
        for along, across in ((0, 1), (1, 0)):
            points = np.zeros((4, 3))
            points[:, along], points[:, across] = [-0.5, 0.5, 0.5, -0.5], [-0.6, -0.6, 0.0, 0.0]
            fields.crack = Crack(points, np.array([[0, 1, 2], [0, 2, 3]]), np.zeros((4, 3)))
            self.assertEqual(choose_view(fields).normal, along)

    def test_a_section_marks_the_front_and_not_the_edge_at_the_surface(self):
        """The crack of a cube from its side at y = -0.5 to y = 0.1: a section normal to x cuts the front there, halfway between the faces as drawn."""
        made_up_run.penny(self.folder)
        fields = read_fields(self.folder)
        points = np.array([[-0.6, -0.6, 0.0], [0.6, -0.6, 0.0], [0.6, 0.1, 0.0], [-0.6, 0.1, 0.0]])
        fields.crack = Crack(points, np.array([[0, 1, 2], [0, 2, 3]]), np.zeros((4, 3)))
        chance = np.random.default_rng(SEED)
        print(f"seed {SEED}")
        for where in chance.uniform(-0.4, 0.4, 3):
            found = crossings(fields, [points + [0.0, 0.0, 0.03], points - [0.0, 0.0, 0.01]], 0, where)
            np.testing.assert_allclose(found, [[where, 0.1, 0.01]], atol=1e-12)

    def test_a_close_up_stays_at_the_body(self):
        """Near an edge it is moved inwards but for its margin, no farther than it may; one that is larger than the body has it in its middle."""
        low, high = [0.0, 0.0], [10.0, 4.0]
        np.testing.assert_allclose(moved_inside([0.5, 2.0], [2.0, 1.0], low, high, margin=0.1), [1.8, 2.0])
        np.testing.assert_allclose(moved_inside([9.9, 3.9], [2.0, 1.0], low, high, margin=0.1), [8.2, 3.1])
        np.testing.assert_allclose(moved_inside([0.5, 2.0], [2.0, 1.0], low, high, most=0.5, margin=0.1), [1.0, 2.0])
        np.testing.assert_allclose(moved_inside([5.0, 3.0], [2.0, 9.0], low, high), [5.0, 2.0])

    def test_slice_of_3d_cuts_the_crack(self):
        """A penny in the plane z = 0 is a line only in a slice along z: of x and y, equally wide, y is taken. The
        slice of a cube of 40 layers goes through the middle of one, and the crack's cut is as long as its chord there.
        """
        made_up_run.penny(self.folder)
        fields = read_fields(self.folder)
        view = choose_view(fields)
        self.assertEqual((view.normal, view.axes), (1, [0, 2]))
        self.assertAlmostEqual(view.where, 0.0125)
        self.assertEqual(in_slice(fields, view.normal, view.where).sum(), 1600)
        cut = crack_segments(fields, [fields.crack.points], view)[0]
        # 0.0125 from the diameter of a polygon of 24 corners, whose outermost edges there turn by 15 degrees.
        chord = 2.0 * (0.3 - 0.0125 * np.tan(np.radians(7.5)))
        self.assertAlmostEqual(np.linalg.norm(cut[:, 1] - cut[:, 0], axis=1).sum(), chord)

    def test_slices_do_not_lie_on_faces_of_split_particles(self):
        """The middle of a layer of whole particles, where those of a split one have faces: the slice is a quarter of the way to a face of theirs at
        least, and in the layer. Without split ones it stays in the middle."""
        made_up_run.penny(self.folder)
        fields = read_fields(self.folder)
        self.assertEqual(clear_of_faces(fields, 1, 0.0125), 0.0125)
        split = np.abs(fields.position[:, 1] - 0.0125) < 1e-9
        split[np.flatnonzero(split)[::2]] = False  # half of them stay whole

        class Mixed:
            position = np.concatenate([fields.position[~split], fields.position[split] - [0.0, 0.00625, 0.0], fields.position[split] + [0.0, 0.00625, 0.0]])

            def boxes(self):
                edge = np.full(len(self.position), 0.025)
                edge[int(np.sum(~split)):] = 0.0125
                return edge[:, None, None] * np.eye(3)

        found = clear_of_faces(Mixed(), 1, 0.0125)
        self.assertGreater(abs(found - 0.0125), 0.00125)
        self.assertLess(abs(found - 0.0125), 0.0125 - 0.00125)

    def test_slice_that_is_asked_for(self):
        """Of 40 layers of 25 mm about 0, z = 0.3 lies on the face between two, of which the upper is shown; an axis alone
        gives the layer above the middle."""
        made_up_run.penny(self.folder)
        fields = read_fields(self.folder)
        view = choose_view(fields, read_slice("z=0.31"))
        self.assertEqual((view.normal, view.axes, view.where), (2, [0, 1], 0.31))
        self.assertEqual(in_slice(fields, 2, view.where).sum(), 1600)
        self.assertAlmostEqual(choose_view(fields, read_slice("x")).where, 0.0125)
        status, output, messages = run("rhegma-plot", self.folder, "--slice", "z=0.31")
        self.assertEqual((status, messages), (0, ""))

    def test_slices_that_there_are_not(self):
        made_up_run.penny(self.folder)
        for asked, words in (("w=1", "z=0.012"), ("z=", "z=0.012"), ("z=nan", "z=0.012"), ("z=0.7", "cuts no particle")):
            status, _, messages = run("rhegma-plot", self.folder, "--slice", asked)
            self.assertEqual(status, 1, messages)
            self.assertIn(words, messages)
        made_up_run.beam(self.path("flat"))
        status, _, messages = run("rhegma-plot", self.path("flat"), "--slice", "z")
        self.assertEqual(status, 1, messages)
        self.assertIn("3D", messages)

    def test_close_up_is_of_a_front_that_still_is_one(self):
        """Of two fronts the second is in material; before the first one ended, that was the one to look at."""
        made_up_run.beam(self.folder)
        fields = read_fields(self.folder)
        summary = {"cracks": [{"name": "A", "fronts": [
            {"position": [0.0, 0.0], "ended": True, "last_advance": 2.0e-3}, {"position": [0.05, 0.0], "ended": False}]}]}
        faces = (fields.crack.points, fields.crack.points)
        fronts = drawn_fronts(fields, faces, summary, choose_view(fields))
        self.assertEqual([front.ended for front in fronts], [True, False])
        self.assertEqual(close_up(fronts), (fronts[1], "at the front A.1"))
        self.assertEqual(close_up(fronts[:1])[1], "where the crack ended")
        self.assertEqual(close_up(fronts[1:])[1], "at the crack's front")
        summary["cracks"][0]["fronts"][1].update(stopped=True, stop={"time": 0.0})
        red = drawn_fronts(fields, faces, summary, choose_view(fields))
        self.assertEqual([front.stopped for front in red], [False, True])
        self.assertEqual(close_up(red), (red[1], "numerical stop of the front A.1"))
        summary["cracks"][0]["fronts"][1]["stopped"] = False
        fields.time = 1.0e-3
        self.assertEqual(close_up(drawn_fronts(fields, faces, summary, choose_view(fields)))[1], "at the front A.0")

    def test_3d_marks_front_nodes_that_are_stopped(self):
        """Of a front of 24 nodes two are stopped: they are drawn where the slice sees them, and the heading says how many."""
        made_up_run.penny(self.folder)
        fields = read_fields(self.folder)
        view = choose_view(fields)
        faces = (fields.crack.points, fields.crack.points)
        positions = [[0.3, 0.0, 0.0], [0.0, 0.3, 0.0]]
        stop = {"time": 0.5e-3, "nodes": 2, "of_nodes": 24, "node_positions": positions}
        summary = {"cracks": [{"name": "Penny", "fronts": [{"stopped": True, "stop": stop}, {"stopped": False}]}]}
        drawn, parts = stopped_nodes(fields, faces, summary, view)
        self.assertEqual(parts, ["Penny.0: 2 of 24 front nodes stopped numerically"])
        np.testing.assert_allclose(drawn, [view.flat(np.array(position)) for position in positions], atol=1e-12)
        stop["time"] = 2.0e-3  # later than the fields
        self.assertEqual(stopped_nodes(fields, faces, summary, view), ([], []))
        stop["time"] = 0.5e-3
        made_up_run.write_summary(self.folder, scene="penny.xml", **summary)
        status, output, messages = run("rhegma-plot", self.folder)
        self.assertEqual((status, messages), (0, ""))
        self.assertIn("fields.png", output)

    def test_slice_finds_a_body_off_the_middle(self):
        """Two thin layers at z = 0 and z = 10: the middle, 5, is empty."""
        xy = made_up_run.lattice(np.arange(20.0), np.arange(20.0))
        start = np.r_[np.c_[xy, np.zeros(400)], np.c_[xy, np.full(400, 10.0)]]
        made_up_run.write_fields(self.folder, [(0.0, {"particles": made_up_run.particles(
            start, np.zeros_like(start), np.zeros((800, 6)), 1.0)})])
        fields = read_fields(self.folder)
        view = choose_view(fields)
        self.assertEqual(view.normal, 2)
        self.assertEqual(in_slice(fields, 2, view.where).sum(), 400)

    def test_boxes_follow_the_deformation(self):
        """Edges 2 along y and 1 along -x, sheared by F = [[1, 3], [0, 2]]: (6, 4) and (-1, 0). Ten times the
        displacement: F = [[1, 30], [0, 11]], (60, 22) and (-1, 0)."""
        particles = made_up_run.particles(np.zeros((1, 3)), np.zeros((1, 3)), np.zeros((1, 6)), 1.0)
        particles["edges"] = np.array([[0.0, 2.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0]])
        particles["deformation"] = np.array([[1.0, 3.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0]])
        made_up_run.write_fields(self.folder, [(0.0, {"particles": particles})])
        fields = read_fields(self.folder)
        self.assertEqual(fields.dimension, 2)
        np.testing.assert_allclose(fields.boxes()[0, :2, :2], [[6.0, 4.0], [-1.0, 0.0]])
        np.testing.assert_allclose(fields.boxes(magnification=10.0)[0, :2, :2], [[60.0, 22.0], [-1.0, 0.0]])
        corners = parallelograms(np.array([[1.0, 1.0]]), fields.boxes()[:, :2, :2])
        np.testing.assert_allclose(corners[0], [[-1.5, -1.0], [4.5, 3.0], [3.5, 3.0], [-2.5, -1.0]])

    def test_cut_of_a_box(self):
        """A unit cube in the plane z = 0.25 is a unit square; one that stands on a corner is a regular hexagon with the
        edge sqrt(1/2) in its middle, and nothing beyond its corners, sqrt(3)/2 away."""
        cube = np.eye(3)[None]
        outlines, owners = cut(np.zeros((1, 3)), cube, np.zeros((1, 3)), cube, 2, 0.25)
        self.assertEqual(list(owners), [0])
        self.assertEqual(sorted(map(tuple, np.abs(outlines[0]))), [(0.5, 0.5, 0.25)] * 4)
        up = np.ones(3) / np.sqrt(3.0)
        across = np.array([1.0, -1.0, 0.0]) / np.sqrt(2.0)
        turned = np.array([[axis @ across, axis @ np.cross(up, across), axis @ up] for axis in np.eye(3)])[None]
        outlines, _ = cut(np.zeros((1, 3)), turned, np.zeros((1, 3)), turned, 2, 0.0)
        sides = np.linalg.norm(outlines[0] - np.roll(outlines[0], 1, axis=0), axis=1)
        np.testing.assert_allclose(sides, np.full(6, np.sqrt(0.5)))
        self.assertEqual(cut(np.zeros((1, 3)), turned, np.zeros((1, 3)), turned, 2, 0.87)[0], [])

    def test_colours(self):
        """Both signs: symmetric about zero; one sign: from zero."""
        name, norm = colour_scale(np.linspace(-1.0, 2.0, 1001))
        self.assertEqual((name, norm.vcenter, norm.vmin), ("RdBu_r", 0.0, -norm.vmax))
        name, norm = colour_scale(np.linspace(0.0, 2.0, 1001))
        self.assertEqual((name, norm.vmin), ("viridis", 0.0))
        self.assertAlmostEqual(norm.vmax, 1.99)
        name, norm = colour_scale(np.zeros(5))  # no stress anywhere
        self.assertLess(norm.vmin, norm.vmax)


del ToolTest  # so that importing this module's names brings tests only
if __name__ == "__main__":
    unittest.main()
