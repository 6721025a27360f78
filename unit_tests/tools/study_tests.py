"""Tests of rhegma-study, with a script in place of rhegma whose errors and times are known."""

import csv
import os
import sys
import unittest

from tool import HERE, ToolTest, picture_size, run

from rhegma.values import split_array
from rhegma_tools.lengths import metres
from rhegma_tools.study_file import Run, combine, read_study
from rhegma_tools.study_picture import by_chance, frontier, group_style
from rhegma_tools.study_runs import Outcome

PROGRAM = os.path.join(HERE, "made_up_rhegma.py")
HEAD = """<ParameterList name="Study">
  <Parameter name="Scene" type="string" value="scene.xml"/>
  <Parameter name="Error Of" type="string" value="cracks.Notch.fronts.0.G_J"/>
  <Parameter name="Reference Value" type="double" value="0.5"/>
  <ParameterList name="Sweep">
"""
TAIL = "  </ParameterList>\n</ParameterList>\n"
LINEAR = """    <ParameterList name="linear">
      <Parameter name="Domain:Cell Size" type="Array(string)" value="{5e-3, 2.5e-3, 1.25e-3}"/>
    </ParameterList>
"""
GIMP = """    <ParameterList name="GIMP, both">
      <Parameter name="Domain:Cell Size" type="Array(string)" value="{5e-3, 2.5e-3}"/>
      <Parameter name="Domain:Shape Functions" type="string" value="GIMP"/>
    </ParameterList>
"""


VALUES = """    <ParameterList name="warm">
      <Parameter name="At" type="Array(string)" value="{10, 20, 40}"/>
      <Parameter name="Value" type="string" value="at*[cracks.Notch.fronts.0.G_J]/[[cracks.Notch.fronts.0.G_J]]"/>
      <Parameter name="Compared With" type="string" value="cold"/>
      <Parameter name="True" type="string" value="at"/>
      <Parameter name="Domain:Cell Size" type="Array(string)" value="{5e-3, 2.5e-3, 1.25e-3}"/>
      <Parameter name="Domain:Shape Functions" type="string" value="GIMP"/>
    </ParameterList>
"""

CURVE = """  <Parameter name="Curve Of" type="string" value="Notch.0.G_J"/>
  <Parameter name="Curve Divided By" type="double" value="0.1"/>
  <Parameter name="Curve Label" type="string" value="G / G of beam theory"/>
  <Parameter name="Source" type="string" value="finite elements"/>
"""


SEVERAL = HEAD.replace('type="string" value="cracks.Notch.fronts.0.G_J"', 'type="Array(string)" value="{one, two}"').replace(
    'type="double" value="0.5"', 'type="Array(double)" value="{3, 4}"')


def with_curve(head, curve=CURVE):
    return head.replace('  <ParameterList name="Sweep">', curve + '  <ParameterList name="Sweep">')


class Study(ToolTest):
    def setUp(self):
        super().setUp()
        self.write("scene.xml", '<ParameterList name="Rhegma"/>\n')

    def study(self, families, head=HEAD):
        return self.write("study.xml", head + families + TAIL)

    def start(self, *more):
        return run("rhegma-study", self.path("study.xml"), "--rhegma", PROGRAM, *more)

    def runs(self):
        with open(self.path("runs.txt")) as file:
            return len(file.readlines())

    def table(self):
        with open(self.path("study.out", "study.csv"), newline="") as file:
            return list(csv.DictReader(file))

    def test_measures_every_run(self):
        self.study(LINEAR + GIMP)
        status, output, messages = self.start()
        self.assertEqual((status, messages), (0, ""))
        rows = self.table()
        self.assertEqual([row["family"] for row in rows], ["linear"] * 3 + ["GIMP, both"] * 2)
        self.assertEqual([row["Domain:Cell Size"] for row in rows], ["5e-3", "2.5e-3", "1.25e-3", "5e-3", "2.5e-3"])
        # Error (cell / 10 mm) for linear and its square for GIMP; 1000 (10 mm / cell)^3 particle steps.
        for row, error in zip(rows, [0.5, 0.25, 0.125, 0.25, 0.0625]):
            self.assertAlmostEqual(float(row["error"]), error, places=12)
        self.assertAlmostEqual(float(rows[1]["wall_seconds"]), 0.64)
        self.assertEqual(rows[1]["particle_steps"], "64000")
        for row in rows:
            self.assertTrue(os.path.exists(os.path.join(row["path"], "summary.json")))
        self.assertIn(f"Wrote {self.path('study.out', 'study.csv')}: 5 runs.", output)
        # Linear at 0.08 s and GIMP at 0.16 and 1.28 s; the other linear ones are slower and worse.
        self.assertIn(f"Wrote {self.path('study.out', 'study.png')}: 3 runs are on the efficient frontier of wall time.", output)
        self.assertGreater(picture_size(self.path("study.out", "study.png"))[0], 900)
        # The limit of linear cells, which is the reference, and a sentence for the family of two cell sizes.
        self.assertRegex(output, r"G_J of Notch.0 \[J/m2\] .* 1.00 +0.5 +between 0.5 and 0.54167, [+-][0-9.e-]+ % of the reference")
        self.assertIn("GIMP, both: no limits for vanishing cells: a limit needs three cell sizes, and 2 runs finished", output)

    def test_goes_on_where_it_stopped(self):
        self.study(LINEAR)
        self.assertEqual(self.start()[0], 0)
        self.study(LINEAR + GIMP)
        self.assertEqual(self.start()[0], 0)
        self.assertEqual(self.runs(), 5)
        before = self.table()
        status, output, _ = self.start()
        self.assertEqual((status, self.runs()), (0, 5))
        self.assertEqual(output.count("(done before)"), 5)
        self.assertEqual(self.table(), before)
        self.start("--again")
        self.assertEqual(self.runs(), 10)

    def test_an_error_of_several_numbers(self):
        self.study(LINEAR, SEVERAL)
        self.assertEqual(self.start()[0], 0)
        # The made-up program gives one = 3 (1 + e) and two = 4 (1 - e): both deviations count, whatever their signs.
        for row, error in zip(self.table(), [0.5, 0.25, 0.125]):
            self.assertAlmostEqual(float(row["error"]), error, places=12)

    def test_a_changed_scene_runs_again(self):
        self.study(LINEAR)
        self.start()
        self.write("scene.xml", '<ParameterList name="Rhegma"> </ParameterList>\n')
        self.start()
        self.assertEqual(self.runs(), 6)

    def test_a_failed_run_is_reported_and_tried_again(self):
        self.study(LINEAR.replace("5e-3, ", "9.5e-3, ", 1))
        status, output, messages = self.start()
        self.assertEqual(status, 2)
        self.assertIn("failed with status 2: The step is unstable at 1e-5 s.", output)
        self.assertIn("1 of 3 runs failed", messages)
        rows = self.table()
        self.assertEqual((rows[0]["error"], rows[0]["exit"]), ("", "2"))
        self.assertAlmostEqual(float(rows[1]["error"]), 0.25)
        self.assertTrue(os.path.exists(self.path("study.out", "study.png")))
        self.start()
        self.assertEqual(self.runs(), 4)  # only the failed one

    def test_a_result_that_is_not_finite_is_a_failure(self):
        self.study(LINEAR, HEAD.replace("cracks.Notch.fronts.0.G_J", "residual"))
        status, output, _ = self.start()
        self.assertEqual(status, 2)
        self.assertEqual(output.count("residual is not finite"), 3)
        self.assertFalse(os.path.exists(self.path("study.out", "study.png")))

    def test_lists_without_running(self):
        self.study(GIMP)
        status, output, _ = self.start("--list", "--launcher", "mpirun -np 2")
        self.assertEqual(status, 0)
        lines = output.splitlines()
        self.assertEqual(len(lines), 2)
        self.assertTrue(lines[0].startswith(f"mpirun -np 2 {PROGRAM} {self.path('scene.xml')} --output "), lines[0])
        self.assertIn("--set 'Domain:Cell Size=5e-3' --set 'Domain:Shape Functions=GIMP'", lines[0])
        self.assertFalse(os.path.exists(self.path("study.out")))

    def test_product_crosses_and_zip_pairs(self):
        values = {"A:b": ["1", "2"], "C:d": "x", "E:f": ["3", "4"]}
        self.assertEqual(combine(values, "Zip", "")[1], {"A:b": "2", "C:d": "x", "E:f": "4"})
        product = combine(values, "Product", "")
        self.assertEqual([(row["A:b"], row["E:f"]) for row in product], [("1", "3"), ("1", "4"), ("2", "3"), ("2", "4")])
        self.assertEqual(combine({"C:d": "x"}, "Zip", ""), [{"C:d": "x"}])

    def test_arrays_nest(self):
        self.assertEqual(split_array("{ {0, 0}, {1, 0} }", ""), ["{0, 0}", "{1, 0}"])
        self.assertEqual(split_array('{"a", b c}', ""), ["a", "b c"])

    def test_units_are_left_to_the_program(self):
        family = """    <ParameterList name="mm">
      <Parameter name="Domain:Cell Size" type="Array(string)" value="{5, 2.5}" unit="mm"/>
      <Parameter name="Time:Final Time" type="string" value="2 ms"/>
    </ParameterList>
"""
        study = read_study(self.study(family))
        self.assertEqual([run.settings for run in study.runs], [{"Domain:Cell Size": f"{size} mm", "Time:Final Time": "2 ms"}
                                                                for size in ("5", "2.5")])
        self.study(family.replace('unit="mm"', 'unit="inch"'))
        self.assert_fails(self.start(), "Domain:Cell Size: 5 inch is in a unit that a study does not sort by")

    def test_lengths_in_units(self):
        for text, value in (("2.5e-3", 2.5e-3), ("2.5 mm", 2.5e-3), ("25cm", 0.25), ("5 um", 5e-6), (" 1 m ", 1.0)):
            self.assertAlmostEqual(metres(text), value, 15)
        for text in ("5 inch", "fine", "", "{1} mm"):
            self.assertRaises(ValueError, metres, text)

    def test_frontier(self):
        """Times 1, 2, 3, 4 and errors 4, 5, 2, 2: the second and the last are beaten."""
        self.assertEqual(frontier([(1.0, 4.0), (2.0, 5.0), (3.0, 2.0), (4.0, 2.0)]), [0, 2])

    def test_frontier_wants_a_gain(self):
        """1 % less is not worth twice the time; 1 % twice is."""
        self.assertEqual(frontier([(1.0, 100.0), (2.0, 99.0), (4.0, 97.5)]), [0, 2])

    def test_a_run_that_smaller_cells_of_its_family_do_worse_than_is_right_by_chance(self):
        def outcome(family, cell, error):
            found = Outcome(Run(family, "", {"Domain:Cell Size": cell}, ["x"], [1.0]), "", 0)
            found.error = error
            found.good = True
            return found

        runs = [outcome("a", "4e-3", 0.02), outcome("a", "2e-3", 0.05), outcome("a", "1e-3", 0.03), outcome("b", "1e-3", 0.09)]
        self.assertEqual([by_chance(run, runs) for run in runs], [True, False, False, False])
        runs[1].run.settings["Domain:Cell Size"] = "2 mm"
        self.assertEqual([by_chance(run, runs) for run in runs], [True, False, False, False])
        self.assertFalse(by_chance(Outcome(Run("a", "", {"Time:CFL": "0.4"}, ["x"], [1.0]), "", 0), runs))

    def test_a_family_may_have_a_quantity_of_its_own(self):
        own = LINEAR.replace("</", '  <Parameter name="Error Of" type="string" value="energy.strain"/>\n    </', 1)
        study = read_study(self.study(own + GIMP))
        self.assertEqual([r.quantity for r in study.runs], ["energy.strain"] * 3 + ["cracks.Notch.fronts.0.G_J"] * 2)
        self.assertEqual(study.swept, ["Domain:Cell Size"])

    def test_a_wrong_setting_stops_the_study_before_its_first_run(self):
        self.study(LINEAR + GIMP.replace("Domain:Shape Functions", "Domain:Shape Funktions"))
        self.assert_fails(self.start(), "Sweep > GIMP, both: rhegma: Domain > Shape Funktions: is no parameter.")
        self.assertFalse(os.path.exists(self.path("runs.txt")))
        self.assertFalse(os.path.exists(self.path("study.out")))

    def test_draws_curves(self):
        self.study(LINEAR + GIMP, with_curve(HEAD))
        status, output, messages = self.start()
        self.assertEqual((status, messages), (0, ""))
        self.assertIn(f"Wrote {self.path('study.out', 'curves.png')}: 5 curves.", output)
        self.assertGreater(picture_size(self.path("study.out", "curves.png"))[0], 900)

    def test_draws_values_with_true_values(self):
        self.study(LINEAR.replace("linear", "cold") + VALUES)
        status, output, messages = self.start()
        self.assertEqual((status, messages), (0, ""))
        self.assertGreater(picture_size(self.path("study.out", "values.png"))[0], 900)
        with open(self.path("study.out", "values.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        # G of GIMP over that of linear cells times the coordinate: (1 + c^2) / (1 + c), c = cell / 10 mm.
        for row, at, cell in zip(rows, (10.0, 20.0, 40.0), (0.5, 0.25, 0.125)):
            self.assertEqual((row["family"], float(row["at"]), float(row["true"])), ("warm", at, at))
            self.assertAlmostEqual(float(row["value"]), at * (1 + cell**2) / (1 + cell), 12)
        # The mean of (1 + c^2) / (1 + c) - 1 is that of -1/6, -3/20 and -7/72.
        self.assertIn("warm: -13.80 %", output)

    def test_draws_values_where_runs_say(self):
        drawn = '<Parameter name="Drawn At" type="string" value="at + [cracks.Notch.fronts.0.G_J] + 1"/>\n      '
        self.study(LINEAR.replace("linear", "cold") + VALUES.replace('<Parameter name="Compared With"', drawn + '<Parameter name="Compared With"')
                   .replace('"at*[cracks', '"drawn*[cracks'))
        status, _, messages = self.start()
        self.assertEqual((status, messages), (0, ""))
        with open(self.path("study.out", "values.csv"), newline="") as file:
            for row, at, cell in zip(csv.DictReader(file), (10.0, 20.0, 40.0), (0.5, 0.25, 0.125)):
                drawn = float(row["drawn at"])
                self.assertEqual((float(row["at"]), float(row["true"])), (at, drawn))
                self.assertGreater(drawn, at + 1.0)  # G is above zero
                self.assertAlmostEqual(float(row["value"]), drawn * (1 + cell**2) / (1 + cell), 12)

    def test_a_value_that_can_not_be_found_is_reported(self):
        for wrong, words in ((("[[cracks", "[[crack"), "crack"), (("at*[", "to*["), "has what is no number"),
                             (("at*[", "at*(["), "is no expression"), (("{10, 20, 40}", "{10, 20}"), "for each of the 3 runs"),
                             (('value="cold"', 'value="ice"'), "there is no family ice")):
            self.study(LINEAR.replace("linear", "cold") + VALUES.replace(*wrong))
            status, _, messages = self.start()
            self.assertEqual(status, 1, wrong)
            self.assertIn(words, messages)

    def test_without_a_column_there_are_no_curves(self):
        self.study(LINEAR)
        self.start()
        self.assertFalse(os.path.exists(self.path("study.out", "curves.png")))

    def test_a_column_that_is_not_there_is_reported(self):
        self.study(LINEAR, with_curve(HEAD, CURVE.replace("Notch.0.G_J", "Notch.0.G")))
        status, _, messages = self.start()
        self.assertEqual(status, 1)
        self.assertIn("Curve Of Notch.0.G: history.csv has no such column; it has time, Notch.0.G_J.", messages)
        self.study(LINEAR.replace("</", '  <Parameter name="Output:History" type="string" value="none"/>\n    </', 1),
                   with_curve(HEAD))
        status, _, messages = self.start()
        self.assertEqual(status, 1)
        self.assertIn("has no history.csv for Curve Of", messages)

    def test_runs_a_family_alone(self):
        self.study(LINEAR + GIMP)
        self.assertEqual(self.start("--family", "GIMP, both")[0], 0)
        self.assertEqual([row["family"] for row in self.table()], ["GIMP, both"] * 2)
        self.assertEqual(self.runs(), 2)
        self.start()
        self.assertEqual((self.runs(), len(self.table())), (5, 5))
        self.assert_fails(self.start("--family", "GIMP both"), "it has linear, GIMP, both (did you mean GIMP, both?)")

    def test_families_of_a_group_share_a_colour(self):
        grouped = '<Parameter name="Group" type="string" value="one"/>\n    </'
        study = read_study(self.study(LINEAR.replace("</", grouped, 1) + GIMP.replace("</", grouped, 1)
                                      + LINEAR.replace("linear", "third")))
        styles = group_style(study.runs)
        self.assertEqual(styles["linear"][0], styles["GIMP, both"][0])
        self.assertNotEqual(styles["linear"][1:], styles["GIMP, both"][1:])
        self.assertNotEqual(styles["linear"][0], styles["third"][0])

    def test_draws_processor_time(self):
        """It is measured from outside; a run that a launcher starts may have its time elsewhere."""
        self.study(LINEAR)
        status, output, _ = self.start("--processor-time")
        self.assertEqual(status, 0)
        self.assertIn("on the efficient frontier of processor time.", output)
        for row in self.table():
            self.assertGreater(float(row["processor_seconds"]), 0.0)
        self.assert_fails_at_the_end(self.start("--processor-time", "--launcher", "env"), "without --launcher")
        self.assertEqual({row["processor_seconds"] for row in self.table()}, {""})

    def assert_fails_at_the_end(self, answer, words):
        status, _, messages = answer
        self.assertEqual((status, messages.count("\n")), (1, 1), messages)
        self.assertIn(words, messages)

    def test_an_interrupted_study_keeps_what_is_done(self):
        """The second run kills the study as Ctrl-C would; the third never starts."""
        self.study(LINEAR)
        killer = self.write("killer.py", f"""#!{sys.executable}
import os, signal, subprocess, sys, time
if "--check" not in sys.argv and "Domain:Cell Size=2.5e-3" in sys.argv:
    os.kill(os.getppid(), signal.SIGINT)
    time.sleep(0.2)
    sys.exit(2)
sys.exit(subprocess.call([{PROGRAM!r}] + sys.argv[1:]))
""")
        os.chmod(killer, 0o755)
        status, output, messages = run("rhegma-study", self.path("study.xml"), "--rhegma", killer)
        self.assertEqual((status, messages), (130, "rhegma-study: interrupted.\n"))
        self.assertEqual(self.runs(), 1)
        status, output, _ = self.start()
        self.assertEqual((status, self.runs(), output.count("(done before)")), (0, 3, 1))

    def test_families_share_a_run(self):
        other = LINEAR.replace("linear", "another quantity of the same runs").replace(
            "</", '  <Parameter name="Error Of" type="string" value="wall_seconds"/>\n    </', 1)
        self.study(LINEAR + other)
        self.assertEqual(self.start()[0], 0)
        self.assertEqual(self.runs(), 3)
        self.assertEqual(len({row["path"] for row in self.table()}), 3)
        self.start("--again")
        self.assertEqual(self.runs(), 6)

    def test_refuses_a_wrong_study(self):
        wrong = [
            (HEAD + LINEAR, "no XML, or it is cut off"),
            (HEAD.replace("Study", "Rhegma") + LINEAR + TAIL, "is no study"),
            (HEAD + TAIL, "Study > Sweep: is missing or empty"),
            (with_curve(HEAD, CURVE.replace('"0.1"', '"0"')) + LINEAR + TAIL, "Curve Divided By: must not be 0"),
            (with_curve(HEAD, CURVE.split("\n", 1)[1]) + LINEAR + TAIL, "there is no curve; add Curve Of"),
            (HEAD + LINEAR.replace("Domain:Cell Size", "Grup") + TAIL, "Sweep > linear > Grup: is unknown; write Group."),
            (HEAD + LINEAR.replace("</", '  <Parameter name="Combine" type="string" value="Both"/>\n</', 1) + TAIL,
             "must be Zip or Product, not Both"),
            (HEAD.replace("Error Of", "Eror Of") + LINEAR + TAIL, "Study > Eror Of: is unknown; write Error Of."),
            (HEAD.replace("scene.xml", "sene.xml") + LINEAR + TAIL, "there is no file"),
            (HEAD.replace('value="0.5"', 'value="half"') + LINEAR + TAIL, "Reference Value: must be a number"),
            (HEAD.replace('type="double" value="0.5"', 'type="Array(double)" value="{0.5, 1}"') + LINEAR + TAIL,
             "Study > Reference Value: has 2 numbers for the 1 paths of Error Of"),
            (HEAD + LINEAR + LINEAR + TAIL, "two families have this name"),
            (HEAD + LINEAR.replace("Domain:Cell Size", "Cell Size") + TAIL, "write Section:Parameter"),
            (HEAD + LINEAR.replace("{5e-3", "5e-3") + TAIL, "written in braces"),
            (HEAD + GIMP.replace('"string" value="GIMP"', '"Array(string)" value="{GIMP}"') + TAIL,
             "Domain:Cell Size has 2, Domain:Shape Functions has 1"),
            (HEAD.replace('  <Parameter name="Reference Value" type="double" value="0.5"/>\n', "") + LINEAR + TAIL,
             "Reference Value: is missing"),
        ]
        for text, words in wrong:
            with self.subTest(words):
                self.write("study.xml", text)
                self.assert_fails(self.start(), words)
                self.assertFalse(os.path.exists(self.path("study.out")))
        os.remove(self.path("study.xml"))
        self.assert_fails(self.start(), "there is no file")

    def test_refuses_a_missing_program(self):
        self.study(LINEAR)
        self.assert_fails(run("rhegma-study", self.path("study.xml"), "--rhegma", self.path("none")),
                              "there is no program")


del ToolTest  # so that importing this module's names brings tests only
if __name__ == "__main__":
    unittest.main()
