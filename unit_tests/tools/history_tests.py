"""Tests of histories and of their pictures."""

import unittest

from tool import ToolTest, picture_size, run  # first, as it finds the Python for all others

import made_up_run
import numpy as np

from rhegma_tools import style
from rhegma.history import History as Samples, read_history
from rhegma_tools.front_picture import draw_along
from rhegma_tools.growth_panels import draw_growth, grown_in_equilibrium, growth
from rhegma_tools.heat_panels import draw_energies, draw_temperatures, energy_parts, temperatures
from rhegma_tools.history_picture import draw_history, draw_pressures, draw_release, panels_of
from rhegma_tools.history_picture import error_estimate, pressures, references
from rhegma_tools.panel_lines import ends, widen, without_ended
from rhegma_tools.interpreter import Problem
from rhegma_tools.state_picture import draw_group, draw_state, draw_table, groups_of
from rhegma_tools.style import plt, scale
from rhegma.summary import look_up, read_summary


class History(ToolTest):
    def test_names_of_cracks_may_hold_dots(self):
        self.write("history.csv", "time,A.b.0.G_J,A.b.0.length,A.b.1.G_J\n0,1,0.5,3\n1,2,0.75,4\n")
        history = read_history(self.folder)
        self.assertEqual(history.fronts, [("A.b", 0), ("A.b", 1)])
        self.assertEqual(list(history.of_front(("A.b", 1), "G_J")), [3.0, 4.0])
        self.assertIsNone(history.of_front(("A.b", 0), "K_I"))
        (front, grown), = growth(history)
        self.assertEqual((front, list(grown)), (("A.b", 0), [0.0, 0.25]))

    def test_a_stretched_crack_has_not_grown(self):
        """Its length changes with the body's strain; a speed of zero means that the front has not run."""
        self.write("history.csv", "time,A.0.length,A.0.speed,B.0.length,B.0.speed\n0,0.5,0,0.5,0\n1,0.501,0,0.501,9\n")
        self.assertEqual([front for front, _ in growth(read_history(self.folder))], [("B", 0)])

    def test_a_cut_last_row_is_dropped(self):
        self.write("history.csv", "time,kinetic\n0,1\n1,2\n2")
        self.assertEqual(list(read_history(self.folder).time), [0.0, 1.0])

    def test_references_belong_to_fronts(self):
        summary = {
            "cracks": [{"name": "Left"}, {"name": "Right"}],
            "references": [
                {"quantity": "cracks.1.fronts.0.G_J", "reference": 2.0, "tolerance": 0.1},
                {"quantity": "cracks.Left.fronts.2.G_closure", "reference": 3.0},
                {"quantity": "energy.strain", "reference": 1.0},
            ],
        }
        self.assertEqual(references(summary), [("Right", 0, "G_J", 2.0, 0.1), ("Left", 2, "G_closure", 3.0, 0.0)])

    def test_the_picture_shows_the_numbers(self):
        made_up_run.beam(self.folder)
        history, summary = read_history(self.folder), read_summary(self.folder)
        figure, axes = plt.subplots()
        draw_release(axes, history, summary, 1.0e3 * history.time)
        lines = {line.get_label(): line for line in axes.lines}
        plt.close(figure)
        self.assertEqual(axes.get_ylabel(), "G [mJ/m²]")
        self.assertEqual(set(lines), {"reference 490 mJ/m² ± 4 %", "J integral", "crack closure"})
        self.assertAlmostEqual(lines["J integral"].get_ydata()[-1], 500.0, delta=1.0)  # has settled to e^-7.5
        self.assertAlmostEqual(lines["J integral"].get_xdata()[-1], 3.0)
        self.assertAlmostEqual(lines["reference 490 mJ/m² ± 4 %"].get_ydata()[0], 490.0)

    def test_the_picture_shows_the_toughness(self):
        made_up_run.beam(self.folder)
        history, summary = read_history(self.folder), read_summary(self.folder)
        summary["propagation"] = {"initiation_toughness": 0.75}
        figure, axes = plt.subplots()
        draw_release(axes, history, summary, history.time)
        lines = {line.get_label(): line for line in axes.lines}
        plt.close(figure)
        self.assertEqual(lines["initiation toughness 750 mJ/m²"].get_ydata()[0], 750.0)
        self.assertEqual(len(lines), 4)

    def test_the_picture_shows_estimated_errors(self):
        made_up_run.beam(self.folder)
        history, summary = read_history(self.folder), read_summary(self.folder)
        summary["cracks"][0]["fronts"][0].update({"G_J_error_estimate": 0.02, "G_closure_error_estimate": None})
        name = summary["cracks"][0]["name"]
        self.assertEqual(error_estimate(summary, (name, 0), "G_J"), 0.02)
        for front, quantity in (((name, 0), "G_closure"), ((name, 7), "G_J"), (("Other", 0), "G_J")):
            self.assertIsNone(error_estimate(summary, front, quantity))
        figure, axes = plt.subplots()
        draw_release(axes, history, summary, history.time)
        (_, _, (bar,)), = axes.containers
        plt.close(figure)
        low, high = bar.get_segments()[0][:, 1]
        self.assertAlmostEqual(high - low, 40.0)  # of 20 mJ/m2 on both sides
        self.assertAlmostEqual(0.5 * (low + high), 500.0, delta=1.0)

    def test_units_get_prefixes(self):
        self.assertEqual(scale(2.5e6, "Pa"), (1.0e-6, "MPa"))
        self.assertEqual(scale(0.02, "s")[1], "ms")
        self.assertEqual(scale(0.0, "J"), (1.0, "J"))

    def test_look_up(self):
        summary = {"steps": 3, "cracks": [{"name": "A", "fronts": [{"G_J": 0.25}]}], "status": "finished"}
        self.assertEqual(look_up(summary, "cracks.0.fronts.0.G_J"), 0.25)
        self.assertEqual(look_up(summary, "cracks.A.fronts.0.G_J"), 0.25)
        self.assertEqual(look_up(summary, "steps"), 3.0)
        self.assertTrue(np.isnan(look_up({"residual": None}, "residual")))
        for wrong in ("cracks.1.fronts.0.G_J", "cracks.0.G_J", "status", "nothing"):
            with self.assertRaises(Problem):
                look_up(summary, wrong)

    def test_draws_the_pressure_of_gas(self):
        made_up_run.write_history(self.folder, {
            "time": [0.0, 1e-3, 2e-3], "Slow.pressure": [1e5, 2e5, 3e5], "A.b.pressure": [1e5, 4e5, 5e5],
            "A.b.pressure_lowest": [1e5, 3e5, 4e5], "A.b.pressure_highest": [1e5, 6e5, 7e5],
            "Dry.pressure": [np.nan] * 3})
        cracks = pressures(read_history(self.folder))
        self.assertEqual([name for name, _, _ in cracks], ["Slow", "A.b"])
        self.assertIsNone(cracks[0][2])
        figure, axes = plt.subplots()
        draw_pressures(axes, cracks, np.array([0.0, 1.0, 2.0]))
        self.assertEqual([line.get_label() for line in axes.lines], ["Slow", "A.b: mean"])
        self.assertTrue(np.allclose(axes.lines[1].get_ydata(), [100.0, 400.0, 500.0]))
        self.assertEqual(axes.get_ylabel(), "pressure [kPa]")
        self.assertTrue(np.allclose(axes.collections[0].get_datalim(axes.transData).intervaly, [100.0, 700.0]))
        plt.close(figure)

    def test_draws_temperatures_of_probes_and_fronts(self):
        made_up_run.write_history(self.folder, {
            "time": [0.0, 1.0], "A.b.0.G_J": [1.0, 2.0], "Gauge.temperature": [293.0, 300.0],
            "A.b.0.temperature": [293.0, 350.0], "A.b.gas_temperature": [300.0, 2000.0]})
        history = read_history(self.folder)
        self.assertEqual([name for name, _ in temperatures(history)], ["Gauge", "A.b, front 0"])
        figure, axes = plt.subplots()
        draw_temperatures(axes, temperatures(history), history.time)
        self.assertEqual(axes.get_ylabel(), "temperature [K]")
        self.assertEqual([line.get_ydata()[-1] for line in axes.lines], [300.0, 350.0])
        plt.close(figure)

    def test_draws_the_whole_energy_balance(self):
        """Plastic work and heat from outside too, without which the rest does not add up."""
        names = ["external_work", "strain", "kinetic", "damped", "fracture", "contact", "plastic", "heat", "thermal",
                 "combustion", "merged", "residual"]
        made_up_run.write_history(self.folder, {"time": [0.0, 1.0], **{name: [0.0, 1.0] for name in names}})
        history = read_history(self.folder)
        figure, axes = plt.subplots()
        draw_energies(axes, history, history.time)
        self.assertEqual(len(axes.lines), len(names))
        self.assertEqual(len({line.get_color() for line in axes.lines}), len(names))
        plt.close(figure)

    def test_heat_does_not_hide_the_other_energies(self):
        columns = {"time": [0.0, 1.0], "strain": [0.0, 5e-3], "fracture": [0.0, 4e-4], "residual": [0.0, -2e-3], "thermal": [0.0, -130.0], "heat": [0.0, -130.0]}
        made_up_run.write_history(self.folder, columns)
        history = read_history(self.folder)
        parts = energy_parts(history)
        self.assertEqual(parts, [("Energy without heat", ["strain", "fracture", "residual"]), ("Heat", ["heat", "thermal"])])
        figure, axes = plt.subplots()
        draw_energies(axes, history, history.time, parts[0])
        self.assertEqual((axes.get_ylabel(), sorted(line.get_label() for line in axes.lines)), ("energy [mJ]", ["fracture", "residual", "strain"]))
        self.assertEqual(len(panels_of(history, None)[0]), 2)
        plt.close(figure)
        for strain in (1.4, 0.0):  # comparable ones, and heat alone, are in one panel
            made_up_run.write_history(self.folder, {**columns, "strain": [0.0, strain], "fracture": [0.0, 0.0]})
            self.assertEqual([title for title, _ in energy_parts(read_history(self.folder))], ["Energy"])
        made_up_run.write_history(self.folder, {name: values[1:] for name, values in columns.items()})
        self.assertEqual([group.title for group in groups_of(read_history(self.folder), None)], ["Energy without heat", "Heat"])

    def test_draws_the_lowest_and_highest_temperature(self):
        made_up_run.write_history(self.folder, {"time": [0.0, 1.0], "temperature_highest": [673.0, 673.0], "temperature_lowest": [673.0, 560.0], "A.0.G_J": [0.0, 1.0],
                                                "A.0.temperature": [673.0, 672.0]})
        self.assertEqual([(name, samples[-1]) for name, samples in temperatures(read_history(self.folder))],
                         [("highest of all", 673.0), ("lowest of all", 560.0), ("A, front 0", 672.0)])

    def test_growth_says_of_what(self):
        """In 3D a front's length is that of the border, so that the crack's area is drawn; in 2D the crack's length."""
        for columns, values, words, drawn in (("", ("", ""), "crack extension [mm]", 100.0),
                                              (",A.0.z,A.area", (",0,3e-6", ",0,5e-6"), "new crack area [mm²]", 2.0)):
            self.write("history.csv", f"time,A.0.length,A.0.speed{columns}\n0,0.5,0{values[0]}\n1,0.6,9{values[1]}\n")
            history = read_history(self.folder)
            figure, axes = plt.subplots()
            draw_growth(axes, history, growth(history), history.time)
            self.assertEqual(axes.get_ylabel(), words)
            self.assertAlmostEqual(axes.lines[0].get_ydata()[-1], drawn)
            plt.close(figure)

    def test_marks_where_fronts_end(self):
        """Of fronts that have run: one that ended and one that was stopped, none that runs or was never initiated."""
        self.write("history.csv", "time,A.0.length,A.0.speed\n0,0.5,0\n1e-3,0.6,9\n")
        cases = ((True, False, 4e-4), (False, True, 6e-4), (False, False, 9e-4), (True, False, None))
        fronts = [{"ended": ended, "stopped": stopped, "last_advance": time} for ended, stopped, time in cases]
        summary = {"cracks": [{"name": "A", "fronts": fronts}]}
        self.assertEqual(ends(summary), [("A", 0, 4e-4, "ended"), ("A", 1, 6e-4, "stopped")])
        self.assertEqual(ends(None), [])
        part = {"stopped": True, "last_advance": 9e-4, "stop": {"time": 5e-4, "nodes": 4, "of_nodes": 32}}
        self.assertEqual(ends({"cracks": [{"name": "A", "fronts": [part]}]}), [("A", 0, 5e-4, "4 of 32 front nodes stopped")])
        history = read_history(self.folder)
        figure, axes = plt.subplots()
        draw_growth(axes, history, growth(history), 1e3 * history.time, summary, 1e3)
        marks = [(line.get_label(), line.get_xdata()[0]) for line in axes.lines[1:]]
        self.assertEqual([name for name, _ in marks], ["A, front 0 ended", "A, front 1 stopped numerically"])
        self.assertEqual([line.get_color() == style.ALARM for line in axes.lines[1:]], [False, True])
        for (_, position), time in zip(marks, (0.4, 0.6)):
            self.assertAlmostEqual(position, time)
        plt.close(figure)

    def test_curves_end_where_their_front_ended(self):
        """A front that no longer exists has zeros; one whose G is zero for another reason keeps them."""
        columns = {"time": [1.0, 2.0, 3.0, 4.0], "A.0.G_J": [0.0, 5.0, 0.0, 0.0], "A.0.K_I": [0.0, 6.0, 0.0, 0.0], "A.0.length": [7.0, 8.0, 0.0, 0.0],
                   "A.0.temperature": [300.0] * 4, "fracture": [0.0, 1.0, 2.0, 2.0], "A.area": [9.0, 19.0, 66.0, 66.0], "A.0.speed": [0.0] * 4}
        history = Samples({name: np.array(values) for name, values in columns.items()})
        for summary in ({"cracks": [{"name": "A", "fronts": [{"ended": True}]}]}, None):
            left = without_ended(history, summary).column
            for name in ("A.0.G_J", "A.0.K_I", "A.0.length", "A.0.temperature"):
                np.testing.assert_array_equal(np.isfinite(left[name]), [True, True, False, False], name)
            np.testing.assert_array_equal(left["A.area"], columns["A.area"])
        self.assertTrue(np.isfinite(without_ended(history, {"cracks": [{"name": "A", "fronts": [{"ended": False}]}]}).column["A.0.G_J"]).all())
        # In 2D the length is that of the whole crack, and says of no front that it has ended.
        flat = Samples({**history.column, "A.0.length": np.array([7.0, 8.0, 9.0, 9.0])})
        self.assertTrue(np.isfinite(without_ended(flat, None).column["A.0.G_J"]).all())
        self.assertTrue(np.isfinite(without_ended(flat, {"cracks": [{"name": "A", "fronts": [{"ended": True}]}]}).column["A.0.length"]).all())
        # Growth without a speed, in equilibrium: new area, and no panel of speeds.
        self.assertEqual([front for front, _ in grown_in_equilibrium(history)], [("A", 0)])
        titles = []
        for draw in panels_of(history, None)[0]:
            figure, axes = plt.subplots()
            draw(axes)
            titles.append(axes.get_title(loc="left"))
            if titles[-1] == "Crack growth":
                np.testing.assert_allclose(axes.lines[0].get_ydata(), [0.0, 10.0, 57.0, 57.0])
            plt.close(figure)
        self.assertEqual(titles, ["Energy release rate", "Stress intensity", "Temperature", "Energy", "Crack growth"])

    def test_rounding_does_not_fill_an_axis(self):
        """Values that differ by 1e-9 get an axis of 2 % of their size around them; those that differ by more are drawn as they
        are, but for the margin of 5 % that matplotlib adds at both ends."""
        for values, span in (([100.0, 100.0 + 1e-7], 2.0), ([-100.0 - 1e-7, -100.0], 2.0), ([95.0, 100.0], 5.0), ([0.0, 1e-7], 1e-7)):
            figure, axes = plt.subplots()
            axes.plot([0.0, 1.0], values)
            widen(axes)
            low, high = axes.get_ylim()
            plt.close(figure)
            self.assertLess(low, min(values))
            self.assertGreater(high, max(values))
            self.assertGreater(high - low, 0.999 * span)
            self.assertLess(high - low, 1.11 * span)

    def test_small_rises_of_temperature_remain_visible(self):
        """0.1 K of 293 K fills the axis; 1e-9 K does not, and is drawn in a range of 1e-4 of 293 K."""
        for rise, span in ((0.1, 0.1), (1e-9, 0.0293)):
            figure, axes = plt.subplots()
            draw_temperatures(axes, [("Gauge", np.array([293.0, 293.0 + rise]))], np.array([0.0, 1.0]))
            low, high = axes.get_ylim()
            plt.close(figure)
            self.assertGreater(high - low, 0.999 * span)
            self.assertLess(high - low, 1.11 * span)

    def test_the_picture_of_a_history_widens_its_axes(self):
        """A G of 0.5 J/m2 that is constant to rounding."""
        made_up_run.write_history(self.folder, {"time": [0.0, 1.0, 2.0], "A.0.G_J": [0.5, 0.5 + 1e-12, 0.5]})
        found = []
        save, style.save = style.save, lambda figure, path: (found.extend(figure.axes), plt.close(figure))
        try:
            draw_history(read_history(self.folder), None, "made up", self.path("history.png"))
        finally:
            style.save = save
        low, high = found[0].get_ylim()
        self.assertGreaterEqual(high - low, 0.0199 * 500.0)  # mJ/m2


class OneSample(ToolTest):
    """A history of one row: bars with their values."""

    def drawn(self, group):
        """(names, texts, lengths of bars) of a group of bars."""
        figure, axes = plt.subplots()
        draw_group(axes, group)
        names = [label.get_text() for label in axes.get_yticklabels()]
        texts = [text.get_text() for text in axes.texts]
        lengths = [bar.get_width() for bar in axes.patches]
        plt.close(figure)
        return names, texts, lengths

    def test_shows_values_and_what_to_compare_them_with(self):
        made_up_run.beam(self.folder)
        summary = read_summary(self.folder)
        summary["propagation"] = {"initiation_toughness": 0.75}
        summary["cracks"][0]["fronts"][0]["G_J_error_estimate"] = 0.02
        made_up_run.write_history(self.folder, {
            "time": [3e-3], "kinetic": [0.0], "strain": [2e-6], "external_work": [4e-6], "residual": [-1e-9],
            "Notch.0.G_closure": [0.4925], "Notch.0.G_J": [0.5], "Notch.0.K_I": [2e4], "Notch.0.K_II": [np.nan],
            "Notch.pressure": [1e6], "Gauge.temperature": [293.5]})
        groups = groups_of(read_history(self.folder), summary)
        self.assertEqual([group.title for group in groups],
                         ["Energy release rate", "Stress intensity", "Pressure in cracks", "Temperature", "Energy"])
        self.assertEqual(groups[0].bars[0][3], 0.02)
        self.assertEqual(self.drawn(groups[0])[:2], (["J integral", "crack closure", "reference", "initiation toughness"],
                                                     ["500 mJ/m²", "492.5 mJ/m²", "490 mJ/m²", "750 mJ/m²"]))
        np.testing.assert_allclose(self.drawn(groups[0])[2], [500.0, 492.5, 490.0, 750.0])
        self.assertEqual([self.drawn(group)[1] for group in groups[1:]],
                         [["20 kPa √m"], ["1 MPa"], ["293.5 K"], ["4 µJ", "2 µJ", "-0.001 µJ"]])
        status, output, messages = run("rhegma-plot", self.folder)
        self.assertEqual((status, messages), (0, ""))
        self.assertIn(f"Wrote {self.path('history.png')}: 1 sample, 1 crack front.", output)
        self.assertGreater(picture_size(self.path("history.png"))[1], 500)

    def test_a_toughness_far_above_is_named_and_not_drawn(self):
        """It would flatten the curves; up to three times the largest value it is a line."""
        samples = Samples({"time": np.array([0.0, 1.0]), "A.0.G_J": np.array([1.0, 20.0]), "A.0.G_J_min": np.array([1.0, 10.0]),
                           "A.0.G_J_max": np.array([2.0, 50.0])})
        nodes = {"arc_length": np.array([0.0, 1e-3]), "G_J": np.array([10.0, 50.0])}
        for toughness, far in ((149.0, False), (151.0, True)):
            for draw in (lambda axes: draw_release(axes, samples, {"propagation": {"initiation_toughness": toughness}}, samples.time),
                         lambda axes: draw_along(axes, [("A, front 0", nodes)], {"G_J": "-"}, "J/m²", "Energy release rate", "G", toughness)):
                figure, axes = plt.subplots()
                draw(axes)
                self.assertEqual("(the initiation toughness, 151 J/m², is far above)" in axes.get_title(loc="left"), far)
                self.assertEqual(any("toughness" in line.get_label() for line in axes.lines), not far)
                self.assertEqual(axes.get_ylim()[1] > 100.0, not far)
                plt.close(figure)

    def test_in_3d_the_mean_and_the_largest_node_have_bars(self):
        """The largest node is compared with the toughness, not the mean."""
        made_up_run.write_history(self.folder, {"time": [1.0], "A.0.G_J": [1868.0], "A.0.G_J_min": [1300.0], "A.0.G_J_max": [3037.0],
                                                "A.0.K_I": [2e7], "A.0.K_I_min": [1e7], "A.0.K_I_max": [3e7]})
        front = {"G_J_error_estimate": 73.0, "G_J_extremes_error_estimate": 161.0}
        summary = {"cracks": [{"name": "A", "fronts": [front]}], "start_of_growth": {"toughness": 15700.0}}
        release, intensity = groups_of(read_history(self.folder), summary)
        self.assertEqual(self.drawn(release)[:2], (["J integral, mean along the front", "J integral, largest front node", "initiation toughness"],
                                                   ["1.868 kJ/m²", "3.037 kJ/m²", "15.7 kJ/m²"]))
        self.assertEqual([bar[3] for bar in release.bars], [73.0, 161.0])
        self.assertIn("mean along the front", self.drawn(intensity)[0][0])

    def test_many_fronts_are_drawn_by_their_mean_and_range(self):
        made_up_run.write_history(self.folder, {"time": [1.0], **{f"Penny.{i}.G_J": [100.0 + i] for i in range(12)}})
        group, = groups_of(read_history(self.folder), None)
        self.assertEqual(self.drawn(group)[:2], ([f"J integral, {what} of 12 fronts" for what in ("mean", "lowest", "highest")],
                                                 ["105.5 J/m²", "100 J/m²", "111 J/m²"]))

    def test_values_that_no_bar_is_for_are_a_table(self):
        columns = {"time": [2.0], "momentum_x": [0.5], "Rim.force_x": [-3.0]}
        made_up_run.write_history(self.folder, columns)
        history = read_history(self.folder)
        self.assertEqual(draw_state(history, None, "made up", self.path("table.png")), 0)
        self.assertGreater(picture_size(self.path("table.png"))[0], 900)
        figure, axes = plt.subplots()
        self.assertEqual(draw_table(axes, history), [("time", "2"), ("momentum_x", "0.5"), ("Rim.force_x", "-3")])
        plt.close(figure)
        made_up_run.write_history(self.folder, {**columns, **{f"Rim.{i}.force": [i] for i in range(97)}})
        figure, axes = plt.subplots()
        rows = draw_table(axes, read_history(self.folder))
        plt.close(figure)
        self.assertEqual((len(rows), rows[-1]), (40, ("...", "and 61 more columns in history.csv")))


del ToolTest  # so that importing this module's names brings tests only
if __name__ == "__main__":
    unittest.main()
