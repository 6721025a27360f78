#!/usr/bin/env python3
"""The Python package: scenes, results, runs and sweeps, with a script in place of the program."""

import inspect
import os
import re
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True
from tool import HERE, ToolTest  # noqa: E402  (first, since it finds a Python with NumPy)

import made_up_run  # noqa: E402
import numpy as np  # noqa: E402
from own_folder import SOURCE, TOOLS  # noqa: E402

import rhegma  # noqa: E402
from rhegma.values import from_text, typed  # noqa: E402

PROGRAM = os.path.join(HERE, "made_up_program.py")
CONTENT = {"Domain": {"Dimension": 2, "Cell Size": 0.05, "Lower Corner": [0, -0.5]}, "Test": {"Title": "none"}}


class Scenes(ToolTest):
    def test_values_have_the_types_of_teuchos(self):
        for value, kind, text in ((True, "bool", "true"), (2, "int", "2"), (0.1, "double", "0.1"), ("GIMP", "string", "GIMP"),
                                  ([0, 0.5], "Array(double)", "{0, 0.5}"), (("x", "y*2"), "Array(string)", "{x, y*2}"),
                                  (np.float64(0.25), "double", "0.25"), (np.int32(3), "int", "3"), (np.bool_(False), "bool", "false"),
                                  (np.array([[0.0, 1.0], [2.0, 3.0]]), "Array(double)", "{0.0, 1.0, 2.0, 3.0}"),
                                  ([np.float64(1.5), 2], "Array(double)", "{1.5, 2}")):
            with self.subTest(text):
                self.assertEqual(typed(value), (kind, text))
        for value in (None, object(), [1.0, "x"], [True]):
            with self.subTest(value), self.assertRaises(rhegma.Problem):
                typed(value)

    def test_texts_become_values(self):
        for kind, text, value in (("bool", "True", True), ("int", " 2", 2), ("double", "8e-3", 8e-3), ("string", "{1}", "{1}"),
                                  ("Array(double)", "{1, 2e3}", [1.0, 2e3]), ("Array(int)", "{1,2}", [1, 2]), ("Array(double)", "{}", []),
                                  ("Array(string)", "{x, y*2}", ["x", "y*2"])):
            with self.subTest(text):
                self.assertEqual(from_text(kind, text, "A"), value)
        for kind, text in (("double", "2 mm"), ("bool", "yes"), ("Array(double)", "{1, x}"), ("int", "1.5")):
            with self.subTest(text), self.assertRaisesRegex(rhegma.Problem, "^A > B: "):
                from_text(kind, text, "A > B")

    def test_is_the_same_after_it_was_written(self):
        scene = rhegma.Scene(CONTENT)
        scene["Cracks > Notch > Points"] = rhegma.Quantity([0.0, 20.0], "mm")
        scene.save(self.path("scene.xml"))
        again = rhegma.Scene.load(self.path("scene.xml"))
        self.assertEqual(again.as_dict(), {**CONTENT, "Cracks": {"Notch": {"Points": rhegma.Quantity([0.0, 20.0], "mm")}}})
        self.assertEqual(again.path, self.path("scene.xml"))
        self.assertIn('type="Array(double)" value="{0.0, 20.0}" unit="mm"', again.text())

    def test_all_examples_are_the_same_after_they_were_written(self):
        folder, count = os.path.join(SOURCE, "xml_inputs", "examples"), 0
        for name in sorted(name for name in os.listdir(folder) if name.endswith(".xml")):
            with self.subTest(name):
                scene = rhegma.Scene.load(os.path.join(folder, name))
                built = rhegma.Scene(scene.as_dict())
                self.assertEqual(built.as_dict(), scene.as_dict())
                self.assertEqual([e.get("name") for e in built.root.iter()], [e.get("name") for e in scene.root.iter()])
                count += 1
        self.assertGreater(count, 10)

    def test_changes(self):
        scene = rhegma.Scene(CONTENT)
        scene["Domain > Cell Size"] = 0.1
        scene["Damping > Mass Rate"] = 8100.0
        self.assertEqual(scene["Domain"], {**CONTENT["Domain"], "Cell Size": 0.1})  # and the order is the same
        self.assertEqual(list(scene["Domain"]), list(CONTENT["Domain"]))
        self.assertEqual(scene["Damping"], {"Mass Rate": 8100.0})
        del scene["Damping > Mass Rate"]
        self.assertIn("Damping", scene)
        self.assertNotIn("Damping > Mass Rate", scene)
        other = scene.varied({"Domain > Dimension": 3, "Test > Title": "x"})
        self.assertEqual((other["Domain > Dimension"], scene["Domain > Dimension"]), (3, 2))
        scene.again("Test", "More").rename("More > Title", "Name")
        self.assertEqual(scene["More"], {"Name": "none"})
        self.assertEqual(scene.raw("Test > Title", "double", "wrong").find("Test > Title").get("value"), "wrong")

    def test_a_wrong_name_is_reported(self):
        scene = rhegma.Scene(CONTENT)
        with self.assertRaisesRegex(rhegma.Problem, "Domain has no Cell size; did you mean Cell Size?"):
            scene["Domain > Cell size"]
        with self.assertRaisesRegex(rhegma.Problem, "it has no Bodies, but Domain, Test"):
            scene.remove("Bodies > Plate")
        with self.assertRaisesRegex(rhegma.Problem, "^Cell Size: None is no value"):
            scene["Domain > Cell Size"] = None
        with self.assertRaisesRegex(rhegma.Problem, "there is no file"):
            rhegma.Scene.load(self.path("absent.xml"))
        with self.assertRaisesRegex(rhegma.Problem, "is no XML"):
            rhegma.Scene.load(self.write("cut.xml", "<ParameterList"))

    def test_names_and_units_are_texts(self):
        with self.assertRaisesRegex(rhegma.Problem, "the unit None of 100 is no text"):
            rhegma.Quantity(100, None)
        for content in ({1: {"Dimension": 2}}, {"Domain": {None: 2}}):
            with self.subTest(content), self.assertRaisesRegex(rhegma.Problem, "is no name of a parameter or a section"):
                rhegma.Scene(content)
        scene = rhegma.Scene(CONTENT)
        for use in (lambda: scene[3], lambda: scene.set(3, 1.0), lambda: scene.varied({None: 1.0}), lambda: scene.remove(3)):
            with self.assertRaisesRegex(rhegma.Problem, "is no path of a parameter"):
                use()
        with self.assertRaisesRegex(rhegma.Problem, "has the letter"):
            rhegma.Scene({"Test": {"Title": "a\ud800"}}).save(self.path("scene.xml"))

    def test_files_are_found_from_another_folder(self):
        os.makedirs(self.path("other"))
        scene = rhegma.Scene({"Bodies": {"Part": {"File": "part.stl"}, "Two": {"File": "/parts/two.stl"}},
                              "Cracks": {"Flaw": {"Surface File": "flaw.stl"}}}, self.folder)
        scene.save(self.path("other", "scene.xml"))
        moved = rhegma.Scene.load(self.path("other", "scene.xml"))
        self.assertEqual(moved["Bodies"], {"Part": {"File": self.path("part.stl")}, "Two": {"File": "/parts/two.stl"}})
        self.assertEqual(moved["Cracks > Flaw > Surface File"], self.path("flaw.stl"))
        self.assertEqual(scene["Bodies > Part > File"], "part.stl")
        scene.save(self.path("scene.xml"))
        self.assertEqual(rhegma.Scene.load(self.path("scene.xml"))["Bodies > Part > File"], "part.stl")


class Results(ToolTest):
    def test_reads_history_summary_and_fields(self):
        made_up_run.beam(self.folder)
        run = rhegma.Run(self.folder)
        release = run.history["Notch.0.G_J"]
        self.assertEqual((release.shape, run.history.unit("Notch.0.G_J"), len(run.history)), ((400,), "J/m2", 400))
        self.assertEqual(run.history.unit("strain"), "J")
        self.assertIsNone(run.history.unit("Peak.largest"))
        self.assertEqual(run.value("cracks.Notch.fronts.0.G_J"), made_up_run.G)
        self.assertTrue(run.references_met)
        self.assertEqual(run.times, [0.0, 3.0e-3])
        fields = run.fields()
        self.assertEqual((fields.time, fields.stress.shape), (3.0e-3, (len(fields.position), 6)))
        self.assertEqual(fields["velocity"].shape, (len(fields.position), 3))
        self.assertEqual((fields.unit("velocity"), fields.unit("stress:xy")), ("m/s", "Pa"))
        self.assertIn("mass", fields.names)
        self.assertEqual([frame.time for frame in run.frames()], run.times)
        self.assertEqual(run.fields(1e-4).time, 0.0)
        self.assertEqual(run.fronts, {})
        with self.assertRaisesRegex(rhegma.Problem, "has no column Notch.0.GJ; it has Notch.0.G_J"):
            run.history["Notch.0.GJ"]
        with self.assertRaisesRegex(rhegma.Problem, "no field speed; they have body"):
            fields["speed"]

    def test_reads_values_along_fronts(self):
        made_up_run.write_fronts(self.folder, [(1e-3, {"Penny.0": {"s": [0.0, 0.1], "G": [5.0, 6.0]}})])
        sample, = rhegma.Run(self.folder).fronts["Penny.0"]
        self.assertEqual((sample.time, list(sample.G), sample.position.shape), (1e-3, [5.0, 6.0], (2, 3)))

    def test_a_run_that_goes_on(self):
        self.write("history.csv", "time,strain\n0,1\n1,2\n2,")
        run = rhegma.Run(self.folder)
        self.assertEqual(list(run.history["strain"][:2]), [1.0, 2.0])
        self.assertEqual((run.end, run.finished, run.times), (None, False, []))
        with self.assertRaisesRegex(rhegma.Problem, "has not ended, or it was killed"):
            run.value("steps")
        with self.assertRaisesRegex(rhegma.Problem, "has no fields.h5"):
            run.fields()
        with self.assertRaisesRegex(rhegma.Problem, "has no file of a run"):
            rhegma.Run(self.path("absent"))


class Runs(ToolTest):
    def setUp(self):
        super().setUp()
        self.scene = rhegma.Scene(CONTENT)

    def run_it(self, values=None, **how):
        return rhegma.run(self.scene.varied(values or {}), output=self.path("out"), program=PROGRAM, **how)

    def test_a_run_that_finishes(self):
        run = self.run_it(threads=3)
        self.assertEqual((run.status, run.finished, run.end, run.references_met), (0, True, "finished", True))
        self.assertEqual(run.value("cracks.Notch.fronts.0.G_J"), 0.55)
        self.assertEqual((run.output, run.warnings), ("the last line\n", ["the cells are coarse"]))
        self.assertEqual(rhegma.Scene.load(self.path("out", "scene.xml")).as_dict(), CONTENT)
        with open(self.path("runs.txt")) as file:
            self.assertEqual(file.read(), "3\n")

    def test_a_missed_reference_is_no_exception(self):
        run = self.run_it({"Test > Title": "missed"})
        self.assertEqual((run.status, run.finished, run.references_met), (4, True, False))

    def test_a_wrong_scene(self):
        with self.assertRaises(rhegma.SceneError) as caught:
            self.run_it({"Domain > Cell Size": 0.3})
        self.assertEqual(caught.exception.messages, ["Domain > Cell Size: is too large."])
        with self.assertRaises(rhegma.SceneError):
            rhegma.check(self.scene.varied({"Domain > Cell Size": 0.3}), program=PROGRAM)
        self.assertEqual(rhegma.check(CONTENT, program=PROGRAM), ["the cells are coarse"])

    def test_a_run_that_stops(self):
        with self.assertRaisesRegex(rhegma.RunStopped, "^the run stopped at t = 1 ms, step 7: a particle left the grid$") as caught:
            self.run_it({"Domain > Cell Size": 0.1})
        self.assertEqual(list(caught.exception.run.history.time), [0.0, 1e-3])
        run = self.run_it({"Domain > Cell Size": 0.1}, stop_raises=False)
        self.assertEqual((run.status, run.finished), (2, False))
        self.assertFalse(rhegma.Run(self.path("out")).finished)

    def test_defects_and_signals(self):
        for title, status, words in (("defect", 3, "exit status 3: a defect of the program"), ("killed", -9, "signal 9")):
            with self.subTest(title), self.assertRaisesRegex(rhegma.ProgramError, words) as caught:
                self.run_it({"Test > Title": title})
            self.assertEqual(caught.exception.status, status)
        with self.assertRaisesRegex(rhegma.Problem, "there is no program /absent/rhegma; give rhegma's path as program"):
            rhegma.run(CONTENT, output=self.path("out"), program="/absent/rhegma")
        with self.assertRaisesRegex(rhegma.Problem, "nowhere can't be started"):
            self.run_it(launcher=["nowhere"])

    def test_options_with_which_there_is_no_run_in_the_folder(self):
        """A run of before is in the folder, and would be taken for this one."""
        self.run_it({"Domain > Cell Size": 0.04})
        for options in (["--check"], ["--twice"], ["--output", self.path("other")], ["--strict", "--help"], ("--state=x",)):
            with self.subTest(options), self.assertRaisesRegex(rhegma.Problem, "^options has --.*with which there is no run in the folder"):
                self.run_it(options=options)
        with self.assertRaisesRegex(rhegma.Problem, "^options has --check"):
            rhegma.sweep(self.scene, {"Domain > Cell Size": [0.05]}, output=self.path("all"), program=PROGRAM, options=["--check"])
        with open(self.path("runs.txt")) as file:
            self.assertEqual(len(file.readlines()), 1)
        self.assertEqual(self.run_it(options=["--strict"]).value("cracks.Notch.fronts.0.G_J"), 0.55)

    def test_arguments_that_make_no_sense(self):
        for how, words in (({"ranks": 0}, "^ranks is 0; it must be a whole number of 1 or more"), ({"ranks": -1}, "ranks is -1"),
                           ({"ranks": "two"}, "ranks is 'two'"), ({"ranks": 1.5}, "ranks is 1.5"), ({"threads": 0}, "threads is 0"),
                           ({"options": "--strict"}, "options is '--strict'; it must be a list of words"), ({"options": [1]}, "must be a list of words"),
                           ({"launcher": "mpirun -np 2"}, "launcher is .* must be a list of words")):
            with self.subTest(how), self.assertRaisesRegex(rhegma.Problem, words):
                self.run_it(**how)
        for output in ("", 3):
            with self.subTest(output), self.assertRaisesRegex(rhegma.Problem, "^output is .*; give the path of a folder"):
                rhegma.run(CONTENT, output=output, program=PROGRAM)
            with self.subTest(output), self.assertRaisesRegex(rhegma.Problem, "^output is .*; give the path of a folder"):
                rhegma.sweep(CONTENT, {}, output=output, program=PROGRAM)
        for scene in (None, 3, []):
            with self.subTest(scene), self.assertRaisesRegex(rhegma.Problem, "is no scene; give the path"):
                rhegma.run(scene, output=self.path("out"), program=PROGRAM)
        self.assertEqual(os.listdir(self.folder), [])

    def test_the_folder_of_a_run(self):
        self.scene.save(self.path("beam.xml"))
        self.assertEqual(rhegma.run(self.path("beam.xml"), program=PROGRAM).folder, self.path("beam.out"))
        self.assertFalse(os.path.exists(self.path("beam.out", "beam.xml")))  # the program reads the file itself
        loaded = rhegma.Scene.load(self.path("beam.xml")).varied({"Domain > Cell Size": 0.04})
        self.assertEqual(rhegma.run(loaded, program=PROGRAM).value("cracks.Notch.fronts.0.G_J"), 0.54)
        self.assertEqual(rhegma.Scene.load(self.path("beam.out", "beam.xml"))["Domain > Cell Size"], 0.04)
        with self.assertRaisesRegex(rhegma.Problem, "would overwrite its own scene"):
            rhegma.run(loaded, output=self.folder, program=PROGRAM)
        self.assertEqual(rhegma.Scene.load(self.path("beam.xml"))["Domain > Cell Size"], 0.05)
        with self.assertRaisesRegex(rhegma.Problem, "give the folder of the run as output"):
            rhegma.run(CONTENT, program=PROGRAM)


class Sweeps(ToolTest):
    def sweep(self, parameters, **how):
        return rhegma.sweep(CONTENT, parameters, output=self.path("all"), program=PROGRAM, **how)

    def count(self):
        if not os.path.exists(self.path("all", "runs.txt")):
            return 0
        with open(self.path("all", "runs.txt")) as file:
            return len(file.readlines())

    def test_runs_each_combination(self):
        sweep = self.sweep({"Domain > Cell Size": [0.05, 0.025], "Domain > Dimension": [2, 3]}, jobs=2)
        self.assertEqual(sweep.setting("Domain > Cell Size"), [0.05, 0.05, 0.025, 0.025])
        self.assertEqual(sweep.setting("Domain > Dimension"), [2, 3, 2, 3])
        np.testing.assert_array_equal(sweep.values("cracks.Notch.fronts.0.G_J"), [0.55, 0.55, 0.525, 0.525])
        self.assertEqual(sweep.rows("cracks.Notch.fronts.0.G_J")[2], {
            "Domain > Cell Size": 0.025, "Domain > Dimension": 2, "cracks.Notch.fronts.0.G_J": 0.525, "status": 0})
        self.assertEqual(len({run.folder for run in sweep}), 4)
        with self.assertRaisesRegex(rhegma.Problem, "Time > CFL is not swept"):
            sweep.setting("Time > CFL")

    def test_does_not_repeat_runs(self):
        one = {"Domain > Cell Size": [0.05]}
        self.sweep(one)
        again = self.sweep({"Domain > Cell Size": [0.05, 0.04]})
        self.assertEqual((self.count(), again[0].status, again[1].status), (2, 0, 0))
        self.assertEqual(again[0].settings, {"Domain > Cell Size": 0.05})
        self.sweep(one, again=True)
        self.assertEqual(self.count(), 3)
        self.sweep(one, options=["--strict"])
        self.assertEqual(self.count(), 4)

    def test_zip_and_its_mistakes(self):
        sweep = self.sweep({"Domain > Cell Size": [0.05, 0.025], "Domain > Dimension": [2, 3]}, combine="zip")
        self.assertEqual(sweep.setting("Domain > Dimension"), [2, 3])
        with self.assertRaisesRegex(rhegma.Problem, "zip needs as many values"):
            self.sweep({"Domain > Cell Size": [0.05], "Domain > Dimension": [2, 3]}, combine="zip")
        with self.assertRaisesRegex(rhegma.Problem, 'write "product" or "zip"'):
            self.sweep({}, combine="all")

    def test_values_that_are_none(self):
        for values in (0.05, "Stress", {"a": 1}, None, rhegma.Quantity(50, "mm")):
            with self.subTest(values), self.assertRaisesRegex(rhegma.Problem, "^Domain > Cell Size: .* is one value; write a list"):
                self.sweep({"Domain > Cell Size": values})
        with self.assertRaisesRegex(rhegma.Problem, "^3 is no path of a parameter"):
            self.sweep({3: [1]})
        with self.assertRaisesRegex(rhegma.Problem, "jobs is 0"):
            self.sweep({"Domain > Cell Size": [0.05]}, jobs=0)

    def test_values_with_one_unit(self):
        # The made-up program takes numbers without units.
        parameters = {"Domain > Cell Size": [0.05], "Domain > Lower Corner": rhegma.Quantity([[0, -500], [0, -400]], "mm")}
        sweep = self.sweep(parameters)
        self.assertEqual(sweep.setting("Domain > Lower Corner"), [rhegma.Quantity([0, -500], "mm"), rhegma.Quantity([0, -400], "mm")])
        self.assertEqual(rhegma.Scene.load(os.path.join(sweep[1].folder, "scene.xml"))["Domain > Lower Corner"], rhegma.Quantity([0, -400], "mm"))

    def test_runs_that_stop_have_no_values(self):
        sweep = self.sweep({"Domain > Cell Size": [0.05, 0.1]})
        self.assertEqual([run.status for run in sweep], [0, 2])
        np.testing.assert_array_equal(sweep.values("cracks.Notch.fronts.0.G_J"), [0.55, np.nan])

    def test_a_wrong_scene_shows_before_the_first_run(self):
        with self.assertRaisesRegex(rhegma.SceneError, "^with Domain > Cell Size = 0.3: Domain > Cell Size: is too large.$"):
            self.sweep({"Domain > Cell Size": [0.05, 0.3]})
        self.assertEqual(self.count(), 0)


class Package(ToolTest):
    def test_every_public_name_is_documented_and_typed(self):
        undocumented, untyped = [], []
        for name in rhegma.__all__:
            thing = getattr(rhegma, name)
            members = [(name, thing)]
            if inspect.isclass(thing):
                members += [(f"{name}.{key}", value) for key, value in vars(thing).items()
                            if (not key.startswith("_") or key in ("__init__", "__getitem__"))]
            for where, member in members:
                member = getattr(member, "fget", None) or getattr(member, "func", None) or getattr(member, "__func__", member)
                if not callable(member):
                    continue
                if not where.endswith("__init__") and not inspect.getdoc(member):
                    undocumented.append(where)
                if inspect.isfunction(member) and where.split(".")[0] != "Quantity":
                    own = [p for n, p in inspect.signature(member).parameters.items() if n not in ("self", "cls")]
                    wants_return = not where.endswith("__init__") and "return" not in member.__annotations__
                    if wants_return or any(p.annotation is p.empty for p in own):
                        untyped.append(where)
        self.assertEqual((undocumented, untyped), ([], []))

    def test_scenes_and_runs_need_no_numpy(self):
        code = ("import sys; sys.modules['numpy'] = sys.modules['h5py'] = None\n"
                "import rhegma; rhegma.Scene({'Domain': {'Dimension': 2}}).text(); rhegma.run; rhegma.sweep; rhegma.Run\n"
                "assert 'Scene' in dir(rhegma)")
        subprocess.run([sys.executable, "-c", code], check=True, env=dict(os.environ, PYTHONPATH=TOOLS))

    def test_its_version_is_that_of_the_program(self):
        with open(os.path.join(SOURCE, "CMakeLists.txt")) as file:
            version = re.search(r"project\(\s*Rhegma\s+VERSION\s+([\d.]+)", file.read(), re.IGNORECASE).group(1)
        with open(os.path.join(TOOLS, "pyproject.toml")) as file:
            self.assertIn(f'version = "{version}"', file.read())
        self.assertEqual(rhegma.__version__, version)


if __name__ == "__main__":
    unittest.main()
