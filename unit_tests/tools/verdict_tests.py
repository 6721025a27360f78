"""Tests of what a page of a run states: its answer, certainty, references and the table of fronts."""

import os
import random
import unittest

from tool import ToolTest  # first, as it finds the Python for all others

import made_up_run
import numpy as np

from rhegma_tools.extreme_rows import answers_without_peak, extreme_rows
from rhegma_tools.front_table import front_table
from rhegma_tools.report_facts import SHAPE, analysis_of, cells_of, certainty, duration, readable, reference_rows, run_facts, short, sound
from rhegma.history import History
from rhegma_tools.report_verdict import so_far, verdict


SEED = int(os.environ.get("RHEGMA_SEED", "20261130"))


def summary_of(*fronts, **more):
    return dict({"end": "finished", "status": "finished", "cracks": [{"name": "A", "fronts": list(fronts)}]}, **more)


class Extremes(ToolTest):
    """The table of largest and smallest values."""

    def test_a_quench_is_described_by_its_coldest_and_its_largest_difference(self):
        start = made_up_run.lattice(np.arange(0.5, 4), np.arange(0.5, 3))
        start = np.c_[1e-3 * start, np.zeros(len(start))]
        group = made_up_run.particles(start, 0 * start, np.zeros((len(start), 6)), 1e-3)
        chance = np.random.default_rng(SEED)
        print(f"seed {SEED}")
        cold = int(chance.integers(len(start)))
        group["temperature"] = np.where(np.arange(len(start)) == cold, 300.0, 500.0)
        made_up_run.write_fields(self.folder, [(2.0, {"particles": group})])
        history = History({"time": np.array([1.0, 2.0, 3.0]), "temperature_highest": np.array([500.0, 490.0, 320.0]),
                           "temperature_lowest": np.array([400.0, 300.0, 310.0])})
        summary = {"answers": ["the run finished", "peak temperature 500 K (rise 0 K)"],
                   "temperature": {"highest": {"time": 0.5, "value": 500.5, "where": [1e-3, 2e-3]}}}
        rows = extreme_rows(summary, history, self.folder)
        where = f"({', '.join(f'{1e3 * x:.4g}' for x in start[cold, :2])}) mm"
        self.assertEqual(rows, [("largest temperature", "500.5 K", "500 ms", "(1, 2) mm"), ("smallest temperature", "300 K", "2 s", where),
                                ("largest difference of temperature at one time", "190 K", "2 s", "-")])
        self.assertEqual(answers_without_peak(summary, rows), ["the run finished"])  # the rows have it
        self.assertEqual(answers_without_peak(summary, []), summary["answers"])
        # The program has the coldest particle and the difference within a body, with places, for any time.
        summary["temperature"].update(coldest={"time": 2.5, "value": 299.5, "where": [0.0, 3e-3]}, largest_difference={"time": 1.5, "value": 120.0, "body": "Plate"})
        summary["answers"] += ["lowest temperature 299.5 K (fall 200.5 K)", "largest difference of temperature within a body 120 K (Plate)"]
        rows = extreme_rows(summary, history, self.folder)
        self.assertEqual(rows[1:], [("smallest temperature", "299.5 K", "2.5 s", "(0, 3) mm"),
                                    ("largest difference of temperature in a body at one time", "120 K", "1.5 s", "Plate")])
        self.assertEqual(answers_without_peak(summary, rows), ["the run finished"])
        # Without a frame of that time the position is not known.
        self.assertEqual(extreme_rows({}, history, self.path("no"))[1], ("smallest temperature", "300 K", "2 s", "-"))

    def test_extremes_that_the_scene_asks_for(self):
        """Over all samples with their positions; of the end where there is no history."""
        summary = {"extremes": {"Peak": {"field": "Von Mises Stress", "largest": 2e6, "largest_position": [0.0, 3e-3], "smallest": None}}}
        columns = {"time": np.array([1.0, 2.0]), "Peak.largest": np.array([5e6, 2e6]), "Peak.largest_x": np.array([1e-3, 0.0]),
                   "Peak.largest_y": np.array([2e-3, 3e-3]), "Peak.smallest": np.array([np.nan, np.nan])}
        self.assertEqual(extreme_rows(summary, History(columns), self.folder), [("Peak: largest Von Mises Stress", "5 MPa", "1 s", "(1, 2) mm")])
        self.assertEqual(extreme_rows(summary, None, self.folder), [("Peak: largest Von Mises Stress", "2 MPa", "end", "(0, 3) mm")])
        self.assertEqual(extreme_rows({}, None, self.folder), [])


class Verdict(ToolTest):
    def test_without_crack_or_toughness(self):
        self.assertIsNone(verdict({"cracks": []}))
        self.assertIn("computes no energy release rate", verdict(summary_of({})))
        text = verdict(summary_of({"G_J": 500.0, "G_J_error_estimate": 10.0, "largest_G_J": 643.0}, {"G_J": 10.0}))
        self.assertTrue(text.startswith("Not decided"), text)
        self.assertIn("A, front 0: G = 500 J/m² ± 2 % at the end, 643 J/m² at most.", text)
        self.assertIn("A, front 0: G = 10 J/m² at the end.", verdict(summary_of({"G_J": 10.0})))

    def test_intensities_and_forces(self):
        """K where the scene gives K_Ic, the modes of shear, and the forces at which the crack starts."""
        start = {"toughness": 120.0, "load_factor": 1.25, "K_Ic": 2e6}
        text = verdict(summary_of({"closest_to_initiation": 0.64, "K_II_over_K_I": -0.23}, start_of_growth=start,
                                  forces_at_start={"Grip": [None, 1500.0], "Guide": [1e-3, None]}))
        self.assertEqual(text, "No: G of A, front 0 reached 0.64 of the toughness of 120 J/m² (K of G = 1.6 MPa √m, 0.8 of K_Ic = 2 MPa √m). Cracks start at "
                               "1.25 times the loads and prescribed displacements of the scene. Forces at 1.25 times the loads: Grip 1.5 kN. At the end K_II is 23 % of K_I.")
        spatial = {"closest_to_initiation": 0.64, "K_II_over_K_I": 0.01, "K_III_over_K_I": 0.3}
        self.assertTrue(verdict(summary_of(spatial, start_of_growth=start)).endswith(
            " At the end K_III is 30 % of K_I; in 3D only G is compared with the toughness."))
        self.assertNotIn("only G", verdict(summary_of(dict(spatial, K_III_over_K_I=0.07), start_of_growth=start)))
        self.assertIn("toughness (K of G = 1.6 MPa √m, 0.8 of K_Ic = 2 MPa √m).", verdict(summary_of({"closest_to_initiation": 0.64}, propagation={"K_Ic": 2e6})))
        self.assertIn("these loads. Forces at that load: Top 228 kN, Base 10 kN.", verdict(
            summary_of({"G_J": 1.0}, propagation={"initiation": {"load_factor": 1.9}}, forces_at_start={"Base": [0.0, 1e4], "Top": [2.28e5, 0.0]})))

    def test_comparison_with_a_toughness(self):
        """Of cracks that do not grow: G, shear and the error of G decide."""
        def of(release, factor=None, **front):
            return verdict(summary_of(dict({"closest_to_initiation": release}, **front), start_of_growth={"toughness": 120.0, "load_factor": factor}))

        self.assertEqual(of(0.64), "No: G of A, front 0 reached 0.64 of the toughness of 120 J/m².")
        self.assertEqual(of(0.64, 1.25, G_J=76.8, G_J_error_estimate=1.536),
                         "No: G of A, front 0 reached 0.64 of the toughness of 120 J/m². "
                         "Cracks start at 1.25 ± 1 % times the loads and prescribed displacements of the scene.")
        self.assertTrue(of(4.0).startswith("Yes: G of A, front 0 reached 4 of the toughness"))
        # 6 % of G are 3 % of the load; without an estimate 5 % count.
        self.assertTrue(of(0.95, G_J=1.0, G_J_error_estimate=0.06).startswith("Not certain"))
        self.assertTrue(of(0.92, G_J=1.0, G_J_error_estimate=0.06).startswith("No:"))
        self.assertTrue(of(1.02).startswith("Not certain"))
        text = of(0.81, closest_by_hoop_stress=1.1)
        self.assertTrue(text.startswith("Yes") and "largest hoop stress 1.1" in text, text)
        self.assertEqual(of(None), "Not decided: no energy release rate is known.")

    def test_comparison_of_a_run_that_ended_early(self):
        """The factor is on the loads of the scene, of which it applied a part."""
        text = verdict(summary_of({"closest_to_initiation": 0.16}, start_of_growth={"toughness": 120.0, "load_factor": 2.5}, end="stopped by a signal"))
        self.assertEqual(text, "No up to the time at which the run ended early: G of A, front 0 reached 0.16 of the toughness of 120 J/m². "
                               "Cracks start at 2.5 times the loads and prescribed displacements of the scene.")

    def test_comparison_in_3d_is_with_the_largest_node(self):
        front = {"G_J": 1868.0, "G_J_min": 1300.0, "G_J_max": 3037.0, "G_J_error_estimate": 73.0, "closest_to_initiation": 3037.0 / 15700.0}
        more = {"start_of_growth": {"toughness": 15700.0, "load_factor": 2.274}}
        self.assertEqual(verdict(summary_of(front, **more)),
                         "No: the largest G along A, front 0 reached 0.1934 of the toughness of 15.7 kJ/m², and the mean along it 0.119. "
                         "Cracks start at 2.274 ± 2 % times the loads and prescribed displacements of the scene.")
        # It was largest before the end, of which the mean is not known.
        self.assertIn("reached 0.4 of the toughness of 15.7 kJ/m².", verdict(summary_of(dict(front, closest_to_initiation=0.4), **more)))
        head, rows, _ = front_table(summary_of(front, **more))
        self.assertEqual([name for name in head if "G" in name], ["mean G [kJ/m²]", "largest mean G [kJ/m²]", "largest G of a front node / toughness"])
        self.assertEqual(rows[0][head.index("largest G of a front node / toughness")], "0.1934")

    def test_nodes_at_the_surface_are_named(self):
        """Where they are closer to growth than the others; if they alone would grow, the answer says what to do."""
        def of(inside, surface, factor=None, at_surface=None):
            front = {"G_J": 50.0, "G_J_max": 100.0 * max(inside, surface), "closest_to_initiation": inside, "closest_at_surface": surface}
            return verdict(summary_of(front, start_of_growth={"toughness": 100.0, "load_factor": factor, "load_factor_at_surface": at_surface}))

        self.assertEqual(of(0.64, 0.6), "No: the largest G of the inner nodes of A, front 0 reached 0.64 of the toughness of 100 J/m². Inner nodes are two cells "
                                        "or more from the surface; at the others G depends on the cells: they reached 0.6.")
        self.assertNotIn("surface", of(0.64, 0.0))
        self.assertEqual(of(0.64, 0.81, 1.25, 1.111),
                         "No: the largest G of the inner nodes of A, front 0 reached 0.64 of the toughness of 100 J/m². Cracks start between 1.111 "
                         "and 1.25 times the loads and prescribed displacements of the scene: by nodes at the surface, where G depends on the cells, and by "
                         "inner nodes. Inner nodes are two cells or more from the surface; at the others G depends on the cells: they reached 0.81.")
        self.assertTrue(of(0.64, 1.2).startswith("Not certain: "), of(0.64, 1.2))
        self.assertTrue(of(0.64, 1.2).endswith("they reached 1.2; by them the crack grows: smaller cells decide."))
        self.assertTrue(of(4.0, 5.0).startswith("Yes") and of(4.0, 5.0).endswith("they reached 5."))

    def test_faces_that_overlap_leave_nothing_certain(self):
        front = {"G_J": 50.0, "closest_to_initiation": 0.5}
        summary = summary_of(front, start_of_growth={"toughness": 100.0, "load_factor": 1.4})
        self.assertTrue(verdict(summary).startswith("No: G of A, front 0 reached 0.5"), verdict(summary))
        summary["cracks"][0]["faces_overlap"] = True
        text = verdict(summary)
        self.assertTrue(text.startswith("Not certain: the faces of A overlap, so that G and K are wrong; see the warnings. Without regard to that: No: G"), text)

    def test_largest_and_mean_are_of_the_same_nodes(self):
        """The largest G of the inner nodes stands next to their own mean, by the trapezoidal rule, not next to that of all nodes."""
        release = [90.0, 40.0, 20.0, 30.0, 80.0]
        nodes = {"G_J": release, "arc_length": [0.0, 2e-3, 4e-3, 6e-3, 8e-3], "line": [0] * 5, "at_surface": [True, False, False, False, True]}
        front = {"G_J": 42.5, "G_J_max": 90.0, "closest_to_initiation": 0.4, "closest_at_surface": 0.9, "front_nodes": nodes}
        more = {"start_of_growth": {"toughness": 100.0, "load_factor": None}}
        # The inner nodes are the second to the fourth, with the mean (30 + 25) / 2 = 27.5.
        self.assertIn("reached 0.4 of the toughness of 100 J/m², and their mean 0.275.", verdict(summary_of(front, **more)))
        # The largest values are not those of the end, or of other nodes: there is no such mean.
        for changed in ({"closest_to_initiation": 0.5}, {"closest_at_surface": 0.95}):
            self.assertNotIn("mean", verdict(summary_of(dict(front, **changed), **more)))
        self.assertNotIn("mean", verdict(summary_of(dict(front, front_nodes={k: v for k, v in nodes.items() if k != "at_surface"}), **more)))
        # At a plane of symmetry the last node is an inner one: the mean of the second to the last is (30 + 25 + 55) / 3.
        mirrored = dict(nodes, at_surface=[True, False, False, False, False])
        self.assertIn("and their mean 0.3667.", verdict(summary_of(dict(front, front_nodes=mirrored, closest_to_initiation=0.8), **more)))
        head, rows, _ = front_table(summary_of(front, **more))
        self.assertEqual([rows[0][head.index(f"largest G of {which} / toughness")] for which in ("an inner node", "a node at the surface")], ["0.4", "0.9"])

    def test_when_the_toughness_was_reached(self):
        """Between samples, by the root of G, which is in proportion to loads."""
        def of(release, most=None, closest=4.0, time=None):
            columns = {"time": np.arange(1.0, 1.0 + len(release)), "A.0.G_J": np.array(release)}
            columns.update({} if most is None else {"A.0.G_J_max": np.array(most)})
            front = {"closest_to_initiation": closest, "G_J": release[-1], "time_of_toughness": time}
            return verdict(summary_of(front, start_of_growth={"toughness": 100.0, "load_factor": None}), History(columns))

        self.assertTrue(of([25.0, 400.0]).endswith(" G reached it at about t = 1.333 s (between the samples at 1 s and 2 s)."), of([25.0, 400.0]))
        self.assertIn("The largest G of all its nodes reached it at about t = 1.5 s", of([1.0, 1.0], [25.0, 225.0]))
        self.assertTrue(of([101.0, 400.0]).endswith("G exceeded it at the first sample, at t = 1 s, already."))
        self.assertTrue(of([400.0]).endswith("That is at t = 1 s, the only time that was computed."))
        self.assertNotIn("t =", of([25.0, 64.0], closest=0.64))  # a no has no time
        # The program has it, without the nodes at the surface.
        self.assertTrue(of([25.0, 400.0], time=1.25).endswith(" It reached it at about t = 1.25 s (between the samples at 1 s and 2 s)."))
        self.assertTrue(of([101.0, 400.0], time=1.0).endswith(" It exceeded it at the first sample, at t = 1 s, already."))

    def test_a_crack_that_has_not_stopped(self):
        """Growth under given loads in equilibrium that ends with G above the toughness."""
        front = {"initiated": 0.5, "mean_advance": 3e-3, "G_J": 47.2, "G_J_max": 48.0}

        def of(**more):
            return verdict(summary_of(dict(front, **more), propagation={"initiation_toughness": 40.0}, equilibrium={}))

        self.assertTrue(of().endswith(" The crack has not stopped: at the end of the run the largest G along A, front 0 is 1.2 times the initiation toughness "
                                      "of 40 J/m², so its growth is a lower bound."), of())
        for more in ({"G_J_max": 40.1}, {"ended": True}, {"stopped": True}):
            self.assertNotIn("lower bound", of(**more))
        self.assertNotIn("lower bound", verdict(summary_of(front, propagation={"initiation_toughness": 40.0})))  # motion: its speed says it

    def test_a_negative_release_decides_nothing(self):
        for more in ({}, {"start_of_growth": {"toughness": 7.0, "load_factor": None}}):
            text = verdict(summary_of({"G_J": -8.265, "largest_G_J": -3.5, "closest_to_initiation": 0.0}, **more))
            self.assertTrue(text.startswith("Not decided: the energy release rate of A, front 0 is -3.5 J/m², but"), text)

    def test_where_to_and_how_fast(self):
        front = {"initiated": 33e-6, "runs": [{"length": 0.01}], "position": [0.012, -3e-3], "mean_speed": 120.0}
        self.assertEqual(verdict(summary_of(front, propagation={})), "Yes: A, front 0, grew by 10 mm to (12, -3) mm from t = 33 µs on, on average at 120 m/s.")
        running = dict(front, running=True, speed=250.0, position=[0.9988, -2.5e-7])
        self.assertTrue(verdict(summary_of(running, propagation={})).endswith("to (998.8, 0) mm from t = 33 µs on, on average at 120 m/s and at 250 m/s at the end."))
        arrived = dict(front, arrival={"what": "reached the surface of its body", "time": 78e-6})
        self.assertTrue(verdict(summary_of(arrived, propagation={})).endswith("120 m/s, and it reached the surface of its body at t = 78 µs."))

    def test_what_held_a_front(self):
        front = {"initiated": 33e-6, "runs": [{"length": 0.01}], "position": [0.012, -3e-3], "start_release": 3.21}

        def said(held, early, start):
            return verdict(summary_of(dict(front, held_until_start_time=held, release_before_start_time=early), propagation={"start_time": start}))
        self.assertIn("from t = 33 µs on, held by Propagation > Start Time until 33 µs: it started at 3.21 times the initiation toughness", said(True, 1.7, 33e-6))
        # It touched the toughness and started much later, by another load.
        self.assertIn("from t = 33 µs on (before Propagation > Start Time = 5 µs G had reached 1.7 times the initiation toughness)", said(False, 1.7, 5e-6))
        for early in (0.99, None):
            self.assertNotIn("Start Time", said(False, early, 5e-6))

    def test_growth_in_motion(self):
        text = verdict(summary_of({"initiated": 33e-6, "runs": [{"length": 0.01}, {"length": 0.02}]}, {"initiated": None}, propagation={}))
        self.assertEqual(text, "Yes: A, front 0, grew by 30 mm from t = 33 µs on (1 of 2 fronts grew).")
        text = verdict(summary_of({"initiated": 80e-6, "mean_advance": 3e-3, "runs": [{"length": None}], "stopped": True}, propagation={}))
        self.assertEqual(text, "Yes: A, front 0, grew by 3 mm from t = 80 µs on. Stopped for a numerical reason, not by the material: A, front 0.")

    def test_no_growth(self):
        front = {"initiated": None, "closest_to_initiation": 0.71}
        self.assertEqual(verdict(summary_of(front, propagation={})), "No: no front grew; G reached at most 0.71 of the initiation toughness.")
        near = dict(front, closest_to_initiation=0.998, G_J=50.0, G_J_error_estimate=3.0)
        self.assertEqual(verdict(summary_of(near, propagation={})),
                         "Not certain: no front grew; G reached at most 0.998 of the initiation toughness, and the estimated error of G is 6 %.")
        self.assertIn("No up to the time", verdict(summary_of(front, propagation={}, end="stopped")))
        self.assertEqual(verdict(summary_of({"initiated": None}, propagation={})), "No: no front grew.")
        # With shear the crack starts though G is below the toughness.
        self.assertTrue(verdict(summary_of(dict(front, closest_by_hoop_stress=1.2), propagation={})).startswith("By the largest hoop stress yes"))
        self.assertTrue(verdict(summary_of(dict(front, closest_by_hoop_stress=0.94), propagation={})).startswith("No: "))
        # Without an estimate five percent of the load count as near, which are ten of G.
        for known, text in ((dict(front, closest_by_hoop_stress=0.96), "0.96 of that of the toughness, and the error of G is not known"),
                            (dict(front, closest_to_initiation=0.91), "at most 0.91 of the initiation toughness, and the error of G is not known")):
            self.assertTrue(verdict(summary_of(known, propagation={})).startswith("Not certain: "))
            self.assertIn(text, verdict(summary_of(known, propagation={})))
        self.assertTrue(verdict(summary_of(dict(front, closest_to_initiation=0.90), propagation={})).startswith("No: "))
        # In 3D the error is that of the largest node, which is compared.
        along = dict(front, closest_to_initiation=0.978, G_J=40.0, G_J_max=50.0, G_J_error_estimate=0.4, G_J_extremes_error_estimate=1.5)
        self.assertTrue(verdict(summary_of(along, propagation={})).startswith("Not certain: "))
        self.assertTrue(verdict(summary_of(dict(along, G_J_extremes_error_estimate=0.5), propagation={})).startswith("No: "))

    def test_load_factor(self):
        """The factor of the given loads decides, not that the run followed growth; the lower of both criteria; within its error it does not."""
        def of(factor, **front):
            return verdict(summary_of(dict({"initiated": None}, **front), propagation={"initiation": {"load_factor": factor}}, equilibrium={}))

        self.assertEqual(of(1.9), "No, at the given loads: cracks start at 1.9 times these loads.")
        self.assertTrue(of(1.9, initiated=0.1, runs=[{"length": 6e-3}]).startswith("No, at the given loads: cracks start at 1.9 times"))
        self.assertTrue(of(0.8).startswith("Yes, at the given loads"))
        text = of(1.1, hoop_stress_factor=0.9)
        self.assertTrue(text.startswith("Yes, at the given loads: cracks start at 0.9 times these loads by the largest hoop stress (1.1 by G"), text)
        self.assertTrue(of(1.0004).startswith("Not certain, as the factor is near 1, and its error is not known"))
        # The error of another front says nothing of the one that starts.
        other = {"G_J": 1.0, "G_J_error_estimate": 0.9}
        text = verdict(summary_of({"G_J": 100.0, "G_J_error_estimate": 2.0}, other, propagation={"initiation": {"load_factor": 1.3}}, equilibrium={}))
        self.assertTrue(text.startswith("No, at the given loads: cracks start at 1.3 ± 1 %"), text)
        self.assertNotIn("hoop", of(1.1, hoop_stress_factor=1.098))
        # 6 % of G are 3 % of the load.
        self.assertTrue(of(1.02, G_J=100.0, G_J_error_estimate=6.0).startswith("Not certain"))
        self.assertIn("1.04 ± 3 % times", of(1.04, G_J=100.0, G_J_error_estimate=6.0))
        self.assertTrue(of(1.04, G_J=100.0, G_J_error_estimate=6.0).startswith("No,"))


    def test_load_factor_without_a_summary(self):
        """Growth of a path says nothing of the given loads: the factor at its start does."""
        def of(*factors):
            lengths = [0.01 + 1e-3 * k for k in range(len(factors))]
            return so_far(History({"time": np.arange(float(len(factors))), "load_factor": np.array(factors), "A.0.length": np.array(lengths),
                                   "A.0.stopped": np.zeros(len(factors))}))

        self.assertTrue(of(1.9, 0.8, 0.5).startswith("Up to the last sample: No, at the given loads: cracks start at 1.9 times"), of(1.9, 0.8, 0.5))
        self.assertTrue(of(0.7, 0.5, 0.4).startswith("Up to the last sample: Yes, at the given loads"))

    def test_growth_under_given_loads_in_equilibrium(self):
        """The time at which the first front starts is found within its load step; other fronts have that of their load step."""
        propagation = {"initiation": {"time": 0.3561, "from": 0.3, "to": 0.6}, "unstable_from": {"new_area": 1.9e-7, "time": 0.6}}
        fronts = {"initiated": 0.6, "mean_advance": 7.354e-3}, {"initiated": 0.9, "mean_advance": 1e-3}
        text = verdict(summary_of(fronts[0], propagation=propagation, equilibrium={}))
        self.assertEqual(text, "Yes: A, front 0, grew by 7.354 mm from about t = 356.1 ms on (in the load step from 300 ms to 600 ms). The growth is unstable from "
                               "the load step to t = 600 ms on: G rises as the crack grows under the same loads, so in a real body it runs.")
        stable = dict(propagation, unstable_from={"new_area": None, "time": None})
        self.assertEqual(verdict(summary_of(*fronts, propagation=stable, equilibrium={})),
                         "Yes: A, front 0, grew by 7.354 mm from about t = 356.1 ms on (in the load step from 300 ms to 600 ms); "
                         "A, front 1, grew by 1 mm from the load step to t = 900 ms on (2 of 2 fronts grew).")
        moving = dict(propagation, unstable_from={"new_area": 0.0, "time": 0.5}, motion_from={"new_area": 0.0, "time": 0.5})
        text = verdict(summary_of(dict(fronts[0], mean_speed=40.0), propagation=moving, equilibrium={}))
        self.assertEqual(text, "Yes: A, front 0, grew by 7.354 mm from t = 600 ms on, on average at 40 m/s. The growth is unstable from t = 500 ms on; "
                               "from there on the run is dynamic.")

    def test_growth_in_equilibrium_without_a_summary(self):
        """Fronts have no speed there; fracture energy and the area of the crack (3D) or its length (2D) show growth, not a stretched crack's size."""
        def of(fracture, **columns):
            count = len(fracture)
            return so_far(History({"time": 0.3 * np.arange(1.0, count + 1.0), "fracture": np.array(fracture), **{f"{crack}.0.{name}": np.full(count, value)
                                   for crack in "AB" for name, value in (("stopped", 0.0), ("speed", 0.0), ("length", 7e-3))},
                                   **{name.replace("_", "."): np.array(value) for name, value in columns.items()}}))

        since = " Growth is first seen at t = 600 ms; at t = 300 ms there was none."
        self.assertEqual(of([0.0, 7e-5, 4e-4], A_area=[9.04e-6, 18.99e-6, 66.43e-6], B_area=[9e-6, 9.01e-6, 9.02e-6], A_0_length=[7.6e-3, 9.6e-3, 0.0]),
                         f"Yes, up to t = 900 ms, the last sample: A, new area 57.39 mm².{since}")
        self.assertEqual(of([0.0, 7e-5], A_0_length=[0.01, 0.012]), f"Yes, up to t = 600 ms, the last sample: A, front 0, crack extension 2 mm.{since}")
        self.assertTrue(of([0.0, 7e-5], A_area=[9e-6, 9.02e-6], B_area=[9e-6, 9.01e-6]).startswith("Yes, up to t = 600 ms, the last sample: A, new area 0.02"))
        self.assertIn("70 µJ of fracture energy", of([0.0, 7e-5]))
        self.assertEqual(of([0.0, 0.0], A_area=[9e-6, 9.02e-6]), "Not up to t = 600 ms, the last sample: no front has grown.")


class Facts(ToolTest):
    def test_numbers(self):
        self.assertEqual([readable(value, "J/m²") for value in (0.126, 1234.0, 0.0, None, float("nan"), -2e-9)],
                         ["126 mJ/m²", "1.234 kJ/m²", "0 J/m²", "-", "-", "-2 nJ/m²"])
        self.assertEqual(readable(1.32e6, "Pa √m"), "1.32 MPa √m")
        self.assertEqual([short(value) for value in (1334.918, 12345.6, 0.00012346, 9e6)], ["1335", "12346", "0.0001235", "9e+06"])
        self.assertEqual([duration(s) for s in (0.5, 119.0, 150.0, 7500.0)], ["0.5 s", "119 s", "2 min", "2 h 5 min"])

    def test_any_number_keeps_its_value(self):
        seed = random.randrange(10**6)
        chance = random.Random(seed)
        prefixes = {"G": 1e9, "M": 1e6, "k": 1e3, "m": 1e-3, "µ": 1e-6, "n": 1e-9}
        for _ in range(500):
            value = chance.choice((-1, 1)) * 10.0 ** chance.uniform(-9, 11)
            number, unit = readable(value, "Pa").split()
            read = float(number) * prefixes.get(unit[:-2], 1.0)
            self.assertAlmostEqual(read / value, 1.0, delta=5.1e-4, msg=f"seed {seed}: {value}")

    def test_what_was_run(self):
        self.assertEqual(analysis_of({}), "dynamic")
        self.assertEqual(analysis_of({"equilibrium": {"load_steps": 1}}), "equilibrium, 1 load step")
        self.assertEqual(cells_of({"cells": {"largest": 2.5e-3, "smallest": 6.25e-4}}), "2.5 mm, refined to 625 µm")
        self.assertNotIn("Analysis", dict(run_facts({"scene": "a.xml"}, 2)))  # of a run that goes on it is not known
        facts = dict(run_facts({"status": "finished", "particles": 15086, "wall_seconds": 3.0, "time": 8e-5, "ranks": 2, "threads": 1, "backend": "Serial"}, 2))
        self.assertEqual((facts["Particles"], facts["Simulated time"], facts["Run on"]), ("15 086", "80 µs", "2 ranks, 1 thread, Serial"))
        self.assertEqual(facts["Analysis"], "dynamic")
        self.assertNotIn("Scene", facts)

    def test_how_certain_it_is(self):
        pairs = certainty(summary_of({"G_J": 100.0, "G_J_error_estimate": 4.5}, {"G_J": 10.0, "G_J_error_estimate": None, "no_error_estimate": "reason"},
                                     energy={"residual": 0.5}, largest_energy_supplied=100.0))
        self.assertEqual([name for name, _ in pairs], ["Numerical error of G", "No estimate of errors", "Error of the energy balance"])
        self.assertIn("at most 4.5 % (1 front)", pairs[0][1])
        self.assertEqual(pairs[2][1], "500 mJ (0.5 % of the energy supplied)")

    def test_the_page_has_the_percentage_of_the_terminal(self):
        def of(**balance):
            line = "energy balance: external work 1 J; residual 1 J (100 % of the largest of these)"  # is not read
            pairs = certainty(summary_of({}, energy={"residual": -61.594e-6}, largest_energy_supplied=0.1843, answers=["x", line], energy_balance=balance))
            return dict(pairs)["Error of the energy balance"]

        self.assertEqual(of(fraction=3.3430e-4, compared_with="largest energy", energy=0.18425), "-61.59 µJ (0.03343 % of the largest energy)")
        self.assertEqual(of(fraction=3.3430e-4, compared_with="energy supplied at most", energy=0.18425),
                         "-61.59 µJ (0.03343 % of the energy supplied at most 184.2 mJ)")
        self.assertEqual(of(fraction=None), "-61.59 µJ (0.03342 % of the energy supplied)")
        self.assertIn("not static", certainty({"ended_before_settled": True})[0][1])

    def test_growth(self):
        """Increments, extension, and what growth left open in the balance, of the fracture energy."""
        front = {"increments": 19, "runs": [{"length": 5.9e-3}], "initiated": 0.1}
        pairs = dict(certainty(summary_of(front, {"increments": 0}, propagation={"residual_fraction": -0.0019}, equilibrium={})))
        self.assertEqual(pairs["Growth"], "19 increments, extension 5.9 mm; residual 0.19 % of the fracture energy since cracks grew")
        spatial = {"increments": 30, "mean_advance": 1e-3, "front_nodes": {"G_J": []}}
        self.assertEqual(dict(certainty(summary_of(spatial, dict(spatial, mean_advance=2e-3))))["Growth"],
                         "60 increments of front nodes, extension 2 mm (the largest of the fronts)")
        self.assertNotIn("Growth", dict(certainty(summary_of({"increments": 0}))))

    def test_references(self):
        entries = [{"name": "J", "quantity": "cracks.A.fronts.0.G_J", "value": 0.126, "reference": 0.12873, "relative_error": 0.0214, "tolerance": 0.04,
                    "within": True, "source": "s"},
                   {"name": "Z", "quantity": "momentum.0", "value": 1e-3, "reference": 0.0, "relative_error": 1e-3, "tolerance": 1e-4, "within": False},
                   {"name": "T", "quantity": "cracks.0.fronts.0.initiated", "value": None, "reference": 4.6e-4, "relative_error": None, "tolerance": 0.03,
                    "within": None, "left_out": "why"}]
        rows = reference_rows({"references": entries})
        self.assertEqual(rows[0][1:6], ("126 mJ/m²", "128.7 mJ/m²", "2.14 %", "4 %", "within"))
        self.assertEqual(rows[1][1:6], ("0.001", "0", "0.001", "0.0001", "OUTSIDE"))
        self.assertEqual(rows[2][1:6], ("-", "460 µs", "-", "3 %", "not compared: why"))


class Sound(ToolTest):
    def test_what_is_no_list_or_object_is_left_out(self):
        problems = []
        summary = sound({"status": "finished", "energy": 3.0, "cracks": [{"name": "A", "fronts": "many"}, None], "warnings": ["w"]}, SHAPE, "S", problems)
        self.assertEqual(summary, {"status": "finished", "energy": {}, "cracks": [{"name": "A", "fronts": []}, {}], "warnings": ["w"]})
        self.assertEqual([problem.split(" is")[0] for problem in problems], ["S > cracks > 0 > fronts", "S > cracks > 1", "S > energy"])

    def test_any_changed_entry_gives_text(self):
        """Entries of a summary replaced at random: the answer, the certainty and the tables are still made."""
        seed = random.randrange(10**6)
        chance = random.Random(seed)
        front = {"G_J": 100.0, "G_J_error_estimate": 4.5, "K_I": 1e6, "position": [0.0, 1.0], "initiated": 1e-5, "runs": [{"length": 0.1}],
                 "status": "running", "arrival": {"what": "joined"}, "stopped": False, "closest_to_initiation": 0.5}
        for _ in range(500):
            summary = summary_of(dict(front), energy={"residual": 1.0}, propagation={"initiation": {"load_factor": 2.0}}, cells={"largest": 1.0},
                                 references=[{"quantity": "a.K_I", "value": 1.0}], effects=["Cracks"], equilibrium={"load_steps": 1})
            at = chance.choice([summary, summary["cracks"][0], summary["cracks"][0]["fronts"][0], summary["propagation"], summary["references"][0]])
            key = chance.choice(list(at))
            at[key] = chance.choice([None, float("nan"), -1.0, 0, True, "text", [], {}])
            found = sound(summary, SHAPE, "S", [])
            text = (str(verdict(found)) + str(certainty(found)) + str(reference_rows(found)) + str(front_table(found)) + str(run_facts(found, 2)))
            self.assertIn("Analysis" if "status" in found else "Effects", text, f"seed {seed}: {key} = {at[key]}")


class FrontTable(ToolTest):
    def test_columns_have_one_unit_and_rounding_is_zero(self):
        head, rows, numbers = front_table(summary_of(
            {"G_J": 90.0, "G_J_error_estimate": 5.0, "K_I": 2e6, "K_II": 1e-7, "position": [0.05, 0.1], "status": "not initiated"},
            {"G_J": 2000.0, "K_I": 5e6, "K_II": -3e5, "position": [0.01, 0.0], "stopped": True}))
        self.assertEqual(head, ["crack and front", "state", "G [kJ/m²]", "largest G [kJ/m²]", "K_I [MPa √m]", "K_II [MPa √m]", "position [mm]"])
        self.assertEqual(rows[0], ["A, 1", "stopped numerically", "2", "2", "5", "-0.3", "10, 0"])
        self.assertEqual(rows[1], ["A, 0", "not initiated", "0.09 ± 0.005", "0.09", "2", "0", "50, 100"])
        self.assertEqual(list(numbers), [2, 3, 4, 5])

    def test_a_front_that_has_ended_has_no_values(self):
        ended = {"ended": True, "status": "ended", "arrival": {"what": "reached the surface of its body"}, "G_J": 0.0, "G_J_min": 0.0, "G_J_max": 0.0,
                 "K_I": 0.0, "K_II": 0.0, "largest_G_J": 4.8}
        head, rows, _ = front_table(summary_of(ended, {"G_J": 2.0, "K_I": 1e6, "K_II": 0.0}))
        row = dict(zip(head, rows[0]))
        self.assertEqual((row["state"], row["mean G [J/m²]"], row["mean K_I [MPa √m]"]), ("reached the surface of its body", "-", "-"))
        self.assertIn("4.8", [value for name, value in row.items() if name.startswith("largest")])
        # One that has reached a surface and still has nodes there keeps its values.
        self.assertEqual(front_table(summary_of(dict(ended, G_J=3.0, G_J_max=3.0)))[1][0][2][0], "3")

    def test_in_3d_the_range_and_no_position(self):
        text = verdict(summary_of({"G_J": 77.0, "G_J_error_estimate": 7.7, "largest_G_J": 77.0, "G_J_min": 73.0, "G_J_max": 83.0}))
        self.assertIn("G = 77 J/m² ± 10 % in the mean along the front and 83 J/m² at most, at the end.", text)
        # The mean of a mode that changes its sign along the front says nothing.
        tilted = {"K_II": -150.0, "K_II_min": -44.0e3, "K_II_max": 45.0e3, "K_II_error_estimate": 1.0e3, "K_extremes_error_estimate": 2.0e3}
        head, rows, _ = front_table(summary_of(dict(tilted, G_J=3.0, G_J_max=3.0, position=[0.0, 0.0, 0.0])))
        self.assertEqual([head[-1], rows[0][-1]], ["K_II along the front [kPa √m]", "-44 to 45 ± 2"])
        head, rows, _ = front_table(summary_of({"G_J": 77.0, "G_J_min": 73.0, "G_J_max": 83.0, "position": [0.0, 0.0, 0.0]}))
        self.assertEqual(head, ["crack and front", "state", "mean G [J/m²]", "largest mean G [J/m²]"])
        self.assertEqual("".join(rows[0][2]), "77<br>(73 to 83)")

    def test_times_of_load_steps_are_no_times(self):
        front = {"initiated": 0.08, "runs": [{"length": 6e-3}], "G_J": 1.0, "mean_speed": 500.0}
        self.assertNotIn("initiated at", " ".join(front_table(summary_of(front, equilibrium={}))[0]))
        head, rows, _ = front_table(summary_of(front))
        self.assertEqual((head[4:7], rows[0][4:7]), (["initiated at [ms]", "mean speed [m/s]", "grew by [mm]"], ["80", "500", "6"]))
        self.assertIsNone(front_table({"cracks": []}))
        # The largest G of all load steps, where it is another one.
        one, more = {"G_J": 1.0}, {"G_J": 1.0, "largest_G_J": 2.0}
        self.assertNotIn("largest", " ".join(front_table(summary_of(one, equilibrium={}))[0]))
        self.assertIn("largest", " ".join(front_table(summary_of(more, equilibrium={}))[0]))


del ToolTest  # so that importing this module's names brings tests only
if __name__ == "__main__":
    unittest.main()
