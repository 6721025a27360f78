"""Tests of rhegma-report: whole pages."""

import fcntl
import glob
import itertools
import json
import os
import random
import re
import shutil
import unittest

from tool import TOOLS, ToolTest, run  # first, as it finds the Python for all others

import made_up_run
import numpy as np
from html_page import Page

from rhegma_tools import film_frames, zoom_data
from spatial_tests import DRAWS
from rhegma_tools.html_text import element, markup
from rhegma_tools.report_page import chosen_columns
from rhegma_tools.report_pictures import differ
from rhegma_tools.report_verdict import so_far
from rhegma.history import History, read_history
from rhegma_tools.style import plt


def frames_of_beam(folder, count):
    """Overwrites the fields of the made-up beam with a small body whose displacement and stress grow from frame to frame."""
    start = np.c_[made_up_run.lattice(np.arange(0.5, 20), np.arange(0.5, 4)), np.zeros(80)]
    times = []
    for i in range(count):
        stress = np.zeros((80, 6))
        stress[:, 0] = 1e6 * i
        moved = np.c_[np.zeros(80), 1e-3 * i * start[:, 0], np.zeros(80)]
        times.append((1e-3 * i, {"particles": made_up_run.particles(start, moved, stress, 1.0)}))
    made_up_run.write_fields(folder, times)


class Report(ToolTest):
    def page(self, folder=None, *arguments):
        """The page of a folder, after it has been read strictly."""
        folder = folder or self.folder
        status, output, messages = run("rhegma-report", folder, *arguments)
        self.assertEqual((status, messages), (0, ""))
        path = arguments[1] if arguments else os.path.join(folder, "report.html")
        self.assertIn(f"Wrote {path}: ", output)
        with open(path, encoding="utf-8") as file:
            page = Page(file.read())
        self.assertEqual(page.faults, [])
        for image in page.of("img"):
            self.assertGreater(len(image["alt"]), 10)
        for _, attributes in page.elements:
            if "data-source" in attributes:
                self.assertIn(attributes["data-source"], page.ids)
        # The script finds elements by id only where a figure names the id.
        self.assertEqual(set(re.findall(r"getElementById\(([^)]*)\)", page.pieces["script"][-1])), {"figure.dataset.source"})
        return page

    def test_first_fields_without_differences_have_no_picture(self):
        for values, expected in (([0.0, 0.0], False), ([293.0, 293.0], False), ([293.0, 294.0], True), ([0.0, 1.0], True), ([], False),
                                 ([np.nan, 293.0], False)):
            self.assertEqual(differ(np.array(values)), expected, values)

    def test_page_of_a_beam(self):
        made_up_run.beam(self.folder)
        page = self.page()
        self.assertEqual(page.of("meta", charset="utf-8"), [{"charset": "utf-8"}])
        for words in ("dcb", "Status: finished", "No warnings.", "Does the crack run?", "Not decided", "500 mJ/m²", "490 mJ/m²", "within",
                      "Largest principal stress [kPa] at t = 3 ms; displacements 2 000 times", "Columns of the history"):
            self.assertIn(words, page.text)
        self.assertNotIn("zero everywhere", page.text)  # the first fields have no stress, and no picture
        self.assertEqual(page.text.count("Largest principal stress"), 1)
        order = [page.text.index(words) for words in ("Status", "Does the crack run?", "Pictures", "History", "Columns of the history", "The scene file")]
        self.assertEqual(order, sorted(order))
        panels = {panel["title"]: panel for name, panel in page.data.items() if name.startswith("panel-")}
        self.assertEqual(sorted(panels), ["Energy", "Energy release rate"])
        history = read_history(self.folder)
        curve = next(c for c in panels["Energy release rate"]["curves"] if c["name"] == "J integral")
        self.assertEqual(panels["Energy release rate"]["y"], "G [mJ/m²]")
        np.testing.assert_allclose(curve["y"], 1e3 * history.column["Notch.0.G_J"], rtol=1e-5)  # six digits
        np.testing.assert_allclose(curve["x"], 1e3 * history.time, rtol=1e-5)
        self.assertEqual([line["at"] for line in panels["Energy release rate"]["across"]], [490.0])
        np.testing.assert_allclose([panels["Energy release rate"]["bands"][0][end] for end in ("low", "high")], [470.4, 509.6])
        self.assertEqual(list(page.data["columns"]["columns"]), list(history.column))

    def test_output_goes_where_it_is_asked_for(self):
        made_up_run.beam(self.folder)
        self.page(self.folder, "--output", self.path("page.html"))
        self.assertFalse(os.path.exists(self.path("report.html")))
        self.assert_fails(run("rhegma-report", self.folder, "--output", self.path("no", "page.html")), "can't be written")
        self.assert_fails(run("rhegma-report", self.folder, "--output", self.folder), "is a folder")

    def test_refuses_what_is_no_run(self):
        self.assert_fails(run("rhegma-report", self.path("nowhere")), "there is no folder")
        self.assert_fails(run("rhegma-report", self.folder), "no summary.json")
        self.assert_fails(run("rhegma-report", self.write("file", "")), "is no folder")
        self.assert_fails(run("rhegma-report"), "DIR")
        self.write("summary.json", '{"scene": "a')
        self.assert_fails(run("rhegma-report", self.folder), "summary.json", "cut off")

    def test_names_are_escaped(self):
        """Names of scenes, cracks and columns, warnings and answers with characters of HTML, and a scene file with the end of a script."""
        made_up_run.beam(self.folder)
        name = "<b>&\"'</script>"
        scene = self.write("scene.xml", "<ParameterList name='&lt;i>'/> </pre></details><script>alert(1)</script> \x07")
        os.rename(scene, self.path("<b>&\".xml"))
        history = read_history(self.folder)
        made_up_run.write_history(self.folder, {"time": history.time, f"{name}.0.G_J": history.time, f"{name}.0.K_I": history.time})
        made_up_run.write_summary(self.folder, scene=self.path("<b>&\".xml"), warnings=[f"crack {name}"], answers=[name], version=name,
                                  cracks=[{"name": name, "fronts": [{"position": [0.0, 0.0], "G_J": 1.0, "no_error_estimate": name}]}])
        page = self.page()
        self.assertEqual(page.text.count("crack " + name), 1)
        self.assertIn('<b>&"', page.text)
        self.assertIn("<script>alert(1)</script>", page.text)
        self.assertEqual(len(page.pieces["script"]), 1)
        self.assertIn(f"{name}.0.G_J", page.data["columns"]["columns"])

    def test_run_without_fields_or_without_history(self):
        made_up_run.beam(self.folder)
        os.remove(self.path("fields.h5"))
        page = self.page()
        self.assertIn("The run wrote no fields", page.text)
        self.assertNotIn("Pictures", page.text)
        os.remove(self.path("history.csv"))
        page = self.page()
        self.assertNotIn("Columns of the history", page.text)
        self.assertIn("Comparison with the section Reference", page.text)
        made_up_run.write_summary(self.folder, scene="dcb.xml", status="the run was stopped by SIGTERM within a load step", end="stopped by a signal", cracks=[])
        early = self.page().text
        self.assertIn("The run ended early, before it wrote fields", early)
        self.assertNotIn("The run wrote no fields", early)

    def test_run_that_stopped(self):
        made_up_run.beam(self.folder)
        status = "the run stopped at t = 738.2 us, step 10138: a particle left the domain"
        made_up_run.write_summary(self.folder, status=status, end="stopped", warnings=["first", "second"],
                                  propagation={}, cracks=[{"name": "A", "fronts": [{"position": [0.0, 0.0], "G_J": 1.0, "initiated": None,
                                                                                    "closest_to_initiation": 0.71}]}])
        page = self.page()
        self.assertIn("Status: the run stopped at t = 738.2 us", page.text)
        self.assertIn("2 warnings of the run first second", page.text)
        self.assertIn("No up to the time at which the run ended early: no front grew; G reached at most 0.71 of the initiation toughness.", page.text)
        self.assertLess(page.text.index("2 warnings"), page.text.index("Does the crack run?"))

    def test_run_that_goes_on_and_one_that_was_cut_off(self):
        made_up_run.beam(self.folder)
        os.remove(self.path("summary.json"))
        with open(self.path("run.lock"), "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            page = self.page()
        self.assertIn("A run is going on in", page.text)
        self.assertIn("Not decided up to t = 3 ms, the last sample: the scene has no toughness", page.text)
        self.assertNotIn("Analysis", page.text)
        self.assertIn("Status: not ended", page.text)
        self.assertIn("The page shows the run so far.", page.text)
        os.remove(self.path("run.lock"))
        time = np.linspace(0.0, 1e-3, 50)
        made_up_run.write_history(self.folder, {"time": time, "strain": time, "A.0.G_J": time, "A.0.length": 0.01 + 5.0 * time, "A.0.speed": 5.0 + 0.0 * time})
        self.assertEqual(so_far(History({"time": time, "A.0.length": 1.0 + 0.0 * time, "A.0.stopped": 0.0 * time})),
                         "Not up to t = 1 ms, the last sample: no front has grown.")
        self.assertIn("Yes, up to t = 1 ms, the last sample: A, front 0, crack extension 5 mm.", self.page().text)
        self.assertIn("was cut off and has no checkpoint", self.page().text)

    def test_history_with_numbers_that_are_missing(self):
        made_up_run.beam(self.folder)
        history = read_history(self.folder)
        release = history.column["Notch.0.G_J"].copy()
        release[100:200] = np.nan
        made_up_run.write_history(self.folder, {"time": history.time, "strain": np.full(400, np.nan), "kinetic": history.time,
                                                "Notch.0.G_J": release, "Notch.0.K_I": np.full(400, np.inf)})
        page = self.page()
        panel = next(panel for panel in page.data.values() if panel.get("title") == "Energy release rate")
        self.assertEqual([i for i, value in enumerate(panel["curves"][0]["y"]) if value is None], list(range(100, 200)))
        self.assertEqual(set(page.data["columns"]["columns"]["Notch.0.K_I"]), {None})

    def test_history_without_samples_and_of_one_sample(self):
        made_up_run.beam(self.folder)
        self.write("history.csv", "time,kinetic\n")
        self.assertIn("holds no sample", self.page().text)
        self.write("history.csv", "time,kinetic,strain\n1,0,2.5\n")
        page = self.page()
        self.assertIn("The single sample of the history, at t = 1 s", page.text)
        self.assertNotIn("columns", page.data)  # nothing to choose from for a plot
        self.assertIn("1 row.", page.text)

    def test_fields_that_are_damaged(self):
        made_up_run.beam(self.folder)
        with open(self.path("fields.h5"), "r+b") as file:
            file.truncate(1000)
        page = self.page()
        self.assertIn("fields.h5 can't be read", page.text)
        self.assertEqual(page.of("figure", **{"class": "panel"}), page.of("figure"))

    def test_a_hundred_cracks(self):
        made_up_run.beam(self.folder)
        time = np.linspace(0.0, 1.0, 5000)
        columns = {"time": time, "strain": time}
        for i in range(100):
            columns.update({f"C{i}.0.G_J": (i + 1) * time, f"C{i}.0.K_I": time, f"C{i}.0.length": time, f"C{i}.0.speed": time})
        made_up_run.write_history(self.folder, columns)
        made_up_run.write_summary(self.folder, cracks=[{"name": f"C{i}", "fronts": [{"position": [0.0, 1.0], "G_J": i + 1.0}]} for i in range(100)])
        page = self.page()
        self.assertIn("80 more fronts", page.text)
        self.assertLess(page.text.index("C99, 0"), page.text.index("C98, 0"))
        self.assertIn("The largest is that of C99, front 0: G = 100 J/m² at the end.", page.text)
        self.assertIn("This plot has 373 of its 5000 rows.", page.text)  # 150000 numbers of 402 columns
        self.assertLess(os.path.getsize(self.path("report.html")), 6e6)

    def test_penny_in_3d(self):
        made_up_run.penny(self.folder)
        arc = np.linspace(0.0, 1.9, 24)
        nodes = {"arc_length": list(arc), "line": [0] * 24, "G_J": list(100.0 + arc), "K_I": list(1e6 + arc), "K_III": [None] * 24,
                 "position": [[0.0, 0.0, 0.0]] * 24}
        front = {"position": [0.1, 0.1, 0.0], "G_J": 101.0, "G_J_min": 100.0, "G_J_max": 102.0, "K_III": 0.0, "front_nodes": nodes}
        made_up_run.write_summary(self.folder, scene="penny.xml", cracks=[{"name": "Penny", "fronts": [front]}])
        page = self.page()
        for words in ("3D", "section at y = 12.5 mm", "Crack surface at t = 1 ms", "101 (100 to 102)", "along the front"):
            self.assertIn(words, page.text)
        panel = next(panel for panel in page.data.values() if panel.get("title") == "Energy release rate along the front")
        np.testing.assert_allclose(panel["curves"][0]["y"], 100.0 + arc, rtol=1e-5)
        np.testing.assert_allclose(panel["curves"][0]["x"], arc, rtol=1e-5)

    def test_growth_with_a_load_factor(self):
        factor = np.linspace(1.9, 0.8, 12)
        made_up_run.write_history(self.folder, {
            "time": np.arange(1, 13) / 12.0, "strain": factor, "load_factor": factor, "Punch.force_y": -1e4 * factor,
            "Punch.displacement": 1e-4 * factor, "A.0.G_J": np.full(12, 100.0), "A.0.length": np.linspace(1e-3, 7e-3, 12)})
        made_up_run.write_summary(self.folder, equilibrium={"load_steps": 12}, cracks=[{"name": "A", "fronts": [
            {"position": [0.0, 0.0], "initiated": 0.08, "runs": [{"length": 6e-3}], "G_J": 100.0}]}],
            propagation={"initiation": {"load_factor": 1.9}, "load_factor": 0.8})
        page = self.page()
        self.assertIn("No, at the given loads: cracks start at 1.9 times these loads. The run then followed the growth: A, front 0, grew by 6 mm to (0, 0) m.",
                      page.text)
        self.assertIn("equilibrium, 12 load steps, load factor", page.text)
        panel = next(panel for panel in page.data.values() if panel.get("title", "").startswith("Load at which"))
        np.testing.assert_allclose(panel["curves"][0]["y"], factor, rtol=1e-5)
        np.testing.assert_allclose(panel["curves"][0]["x"], np.linspace(0.0, 6.0, 12), rtol=1e-5, atol=1e-12)  # mm

    def test_heat_alone(self):
        start = np.c_[made_up_run.lattice(np.arange(0.5, 8), np.arange(0.5, 4)), np.zeros(32)]
        body = made_up_run.particles(start, np.zeros((32, 3)), np.zeros((32, 6)), 1.0)
        body = {name: values for name, values in body.items() if name not in ("stress", "von_mises")}
        body["temperature"] = 300.0 + start[:, 0]
        made_up_run.write_fields(self.folder, [(2.0, {"particles": body})])
        time = np.linspace(0.0, 2.0, 20)
        made_up_run.write_history(self.folder, {"time": time, "heat": time, "thermal": time, "Probe.temperature": 300.0 + time})
        made_up_run.write_summary(self.folder)
        page = self.page()
        self.assertIn("Results", page.text)
        self.assertNotIn("Does the crack run?", page.text)
        self.assertIn("Temperature [K] at t = 2 s", page.text)

    def test_damage_is_drawn_where_it_is_written(self):
        start = np.c_[made_up_run.lattice(np.arange(0.5, 8), np.arange(0.5, 4)), np.zeros(32)]
        body = made_up_run.particles(start, np.zeros((32, 3)), np.ones((32, 6)), 1.0)
        for damage in (None, start[:, 0] / 8.0):
            if damage is not None:
                body["damage"] = damage
            made_up_run.write_fields(self.folder, [(2.0, {"particles": body})])
            made_up_run.write_history(self.folder, {"time": np.linspace(0.0, 2.0, 20), "strain": np.linspace(0.0, 1.0, 20)})
            made_up_run.write_summary(self.folder)
            self.assertEqual("Damage at t = 2 s" in self.page().text, damage is not None)

    def test_installed_copy(self):
        """Laid out as the rules of cmake/RhegmaInstall.cmake do, the tool finds its style and its script."""
        made_up_run.beam(self.folder)
        with open(os.path.join(TOOLS, "..", "cmake", "RhegmaInstall.cmake"), encoding="utf-8") as file:
            rule = re.search(r"install\(DIRECTORY ([^)]*/tools/rhegma_tools) DESTINATION (\S+)\s+FILES_MATCHING ([^)]*)\)", file.read())
        folders = [os.path.basename(path) for path in rule[1].split()]
        for folder, pattern in itertools.product(folders, re.findall(r"PATTERN (\S+)", rule[3])):
            for path in glob.glob(os.path.join(TOOLS, folder, pattern)):
                target = self.path("prefix", rule[2], folder)
                os.makedirs(target, exist_ok=True)
                shutil.copy(path, target)
        os.makedirs(self.path("prefix", "bin"))
        tool = shutil.copy(os.path.join(TOOLS, "rhegma-report"), self.path("prefix", "bin"))
        status, output, messages = run(tool, self.folder)
        self.assertEqual((status, messages), (0, ""))
        with open(self.path("report.html"), encoding="utf-8") as file:
            page = Page(file.read())
        self.assertIn("figcaption", page.pieces["style"][0])
        self.assertIn("use strict", page.pieces["script"][0])

    def test_two_cell_sizes(self):
        for name in ("as_is", "half"):
            made_up_run.beam(self.path(name))
        self.write("twice.json", json.dumps({"verdict": "resolved: no result moves by more than 5 %", "answers": [
            {"name": "G_J of Notch.0", "unit": "J/m2", "as_is": 0.126, "half": 0.1281, "extrapolated": 0.1301, "verdict": "moves by 1.6 %"}]}))
        page = self.page()
        self.assertIn("G_J of Notch.0 [J/m2] 0.126 0.1281 0.1301 moves by 1.6 %", page.text)
        self.assertIn("the run in half of rhegma --twice", page.text)


class Film(ToolTest):
    def test_frames_of_a_run(self):
        made_up_run.beam(self.folder)
        frames_of_beam(self.folder, 6)
        status, _, messages = run("rhegma-report", self.folder)
        self.assertEqual((status, messages), (0, ""))
        with open(self.path("report.html"), encoding="utf-8") as file:
            page = Page(file.read())
        frames = [image for image in page.of("img") if image["alt"].startswith("Frame ")]
        self.assertEqual([frame["data-label"] for frame in frames], ["t = 0 s", "t = 1 ms", "t = 2 ms", "t = 3 ms", "t = 4 ms", "t = 5 ms"])
        self.assertEqual([frame.get("class") for frame in frames], [None] * 5 + ["shown"])
        self.assertEqual(len({frame["src"] for frame in frames}), 6)

    def test_a_run_in_3d_has_its_body_and_cracks(self):
        """Without VTK a caption names what to install."""
        made_up_run.penny(self.folder)
        status, _, messages = run("rhegma-report", self.folder)
        self.assertEqual((status, messages), (0, ""))
        with open(self.path("report.html"), encoding="utf-8") as file:
            text = file.read()
        alts = [image["alt"] for image in Page(text).of("img")]
        drawn = [alt for alt in alts if "in 3D, cut open, coloured by the largest principal stress" in alt or "cracks in the outline of the body" in alt]
        self.assertEqual(len(drawn), 2 if DRAWS else 0)
        self.assertEqual("need VTK for Python" in text, not DRAWS)
        self.assertTrue(any("crack surface in 3D, coloured by its opening" in alt for alt in alts))

    def test_one_scale_for_all_frames(self):
        """Stress grows to 5 MPa, displacement to 5e-3 of 19.5 m on a body 20 m long: WANTED / that is 16, so 10 times."""
        frames_of_beam(self.folder, 6)
        film = film_frames.draw_film(self.folder, 1e9)
        self.assertEqual((film.magnification, film.unit, film.written), (10.0, "MPa", 6))
        self.assertIsNone(film_frames.draw_film(self.path("none"), 1e9))
        frames_of_beam(self.folder, 2)
        self.assertIsNone(film_frames.draw_film(self.folder, 1e9))

    def test_few_frames_of_many(self):
        self.assertEqual(film_frames.spread(list(range(10)), 4), [0, 3, 6, 9])
        self.assertEqual(film_frames.spread([1, 2], 4), [1, 2])
        seed = random.randrange(10**6)
        chance = random.Random(seed)
        for _ in range(200):
            frames = [(i, b"x" * chance.randrange(1, 5000)) for i in range(chance.randrange(3, 60))]
            most = chance.randrange(1, 150_000)
            kept = film_frames.within(frames, most)
            self.assertTrue(len(kept) == 2 or sum(len(png) for _, png in kept) <= most, f"seed {seed}")
            self.assertEqual((kept[0], kept[-1]), (frames[0], frames[-1]), f"seed {seed}")


class ZoomData(ToolTest):
    def test_thinned_curves_keep_every_peak(self):
        seed = random.randrange(10**6)
        chance = np.random.default_rng(seed)
        for _ in range(50):
            values = chance.normal(size=int(chance.integers(1, 20000)))
            values[chance.random(len(values)) < 0.1] = np.nan
            most = int(chance.integers(8, 4000))
            kept = zoom_data.thinned(values, most)
            self.assertLessEqual(len(kept), max(most, 4), f"seed {seed}")
            self.assertEqual((kept[0], kept[-1]), (0, len(values) - 1), f"seed {seed}")
            if np.isfinite(values).any():
                self.assertEqual((np.nanmin(values[kept]), np.nanmax(values[kept])), (np.nanmin(values), np.nanmax(values)), f"seed {seed}")

    def test_lines_of_axes(self):
        """Curves, lines across and up, bands, areas and error bars are distinguished."""
        figure, axes = plt.subplots()
        axes.plot([0.0, 1.0], [0.0, 1.0], label="a curve from 0 to 1")
        axes.axhline(0.5, ls=":", label="reference")
        axes.axvline(0.25, ls="-", label="end")
        axes.axhspan(0.4, 0.6)
        axes.fill_between([0.0, 1.0], [0.0, 0.0], [1.0, 2.0], label=r"$K_\mathrm{II}$")
        axes.errorbar([1.0], [1.0], yerr=0.25, capsize=4)
        panel = zoom_data.panel_data(axes)
        plt.close(figure)
        self.assertEqual([(c["name"], c["y"]) for c in panel["curves"]], [("a curve from 0 to 1", [0.0, 1.0])])
        self.assertEqual([(c["name"], c["at"], c["dashes"]) for c in panel["across"]], [("reference", 0.5, "2 3")])
        self.assertEqual([(c["name"], c["at"]) for c in panel["marks"]], [("end", 0.25)])
        self.assertEqual(panel["bands"], [{"low": 0.4, "high": 0.6}])
        self.assertEqual([area["name"] for area in panel["areas"]], ["K_II"])
        self.assertEqual([(bar["x"], bar["low"], bar["high"]) for bar in panel["bars"]], [(1.0, 0.75, 1.25)])

    def test_columns_keep_first_and_last_row(self):
        made_up_run.beam(self.folder)
        history = read_history(self.folder)
        history.column = {f"{name}{i}": values for name, values in history.column.items() for i in range(100)}
        data = chosen_columns(history)
        self.assertEqual((data["written"], data["rows"]), (400, 150_000 // 1200))
        for name in ("time0", "strain99"):
            values = data["columns"][name]
            self.assertEqual(len(values), data["rows"])
            np.testing.assert_allclose([values[0], values[-1]], [history.column[name][0], history.column[name][-1]], rtol=1e-5)

    def test_text_is_escaped(self):
        self.assertEqual(element("p", "a < b", element("b", "&"), class_="x\"y"), '<p class="x&quot;y">a &lt; b<b>&amp;</b></p>')
        self.assertEqual(markup([None, "<", 1]), "&lt;1")


del ToolTest  # so that importing this module's names brings tests only
if __name__ == "__main__":
    unittest.main()
