#!/usr/bin/env python3
"""The command line: what is refused, what is printed, and where."""

import json
import os
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import NOISE, PATIENCE, PROGRAM, SOURCE, ProgramTest, environment, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

SECTIONS = ("Domain", "Time", "Materials", "Bodies", "Boundaries", "Output", "Reference")
EFFECTS = ("Cracks", "Contact", "Energy Release", "Damping", "Face Pressure", "Mass Matrix",
           "Adaptivity", "Sub-Cycling", "Load Balance", "Propagation", "Combustion", "Thermal", "Measure",
           "Body Contact", "Rigid Tools")


class WrongArguments(ProgramTest):
    def setUp(self):
        super().setUp()
        self.leave_an_older_run("scene.out")
        self.write("scene.xml", plate().text())

    def refuse(self, *arguments, where="", words):
        self.assert_refused(arguments, [(where, words)])

    def test_nothing(self):
        self.refuse(words=["no scene", "--help"])

    def test_unknown_option(self):
        self.refuse("scene.xml", "--verbose", words=["--verbose", "--help"])

    def test_pictures(self):
        self.refuse("scene.xml", "--check", "--picture", words=["--picture", "needs a value"])
        self.refuse("scene.xml", "--check", "--picture", "--quiet", words=["has no file", "scene.png"])
        self.refuse("scene.xml", "--picture", "scene.png", words=["write --check, too"])
        self.refuse("scene.xml", "--state", "folder", words=["write --check, too"])
        self.refuse("scene.xml", "--check", "--state", "--quiet", words=["has no folder"])

    def test_two_scenes(self):
        self.refuse("scene.xml", "other.xml", words=["one scene", "other.xml"])

    def test_output_without_folder(self):
        self.refuse("scene.xml", "--output", words=["--output", "needs a value"])

    def test_restart_without_file(self):
        self.refuse("scene.xml", "--restart", words=["--restart", "needs a value"])

    def test_restart_from_no_name(self):
        self.refuse("scene.xml", "--restart", "", words=["--restart", "has no file"])

    def test_restart_from_a_file_that_is_not_there(self):
        self.refuse("scene.xml", "--restart", "checkpoint.h5", words=["checkpoint.h5", "No such file"])

    def test_set_without_value(self):
        self.refuse("scene.xml", "--set", words=["--set", "needs a value"])

    def test_set_without_equals(self):
        self.refuse("scene.xml", "--set", "Time:CFL", words=["Time:CFL", "Section:Parameter=value"])

    def test_set_without_section(self):
        self.refuse("scene.xml", "--set", "CFL=0.3", words=["CFL=0.3", "Section:Parameter=value"])

    def test_set_in_an_unknown_section(self):
        self.refuse("scene.xml", "--set", "Tim:CFL=0.3", where="Tim", words=["can't be applied", '"Time"'])

    def test_set_of_an_unknown_parameter(self):
        self.refuse("scene.xml", "--set", "Time:CLF=0.3", where="Time > CLF", words=["can't be applied", '"CFL"'])

    def test_set_of_an_unknown_material(self):
        self.refuse(
            "scene.xml", "--set", "Materials:Polymor:Density=1", where="Materials > Polymor", words=['"Polymer"']
        )

    def test_check_reports_a_body_at_the_edge_of_the_domain(self):
        """Where a support holds it there, or the domain is large enough, there is no message."""
        tight = plate().set("Domain > Lower Corner", [0.0, -0.2])
        path = self.write("tight.xml", tight.text())
        answer = rhegma(path, "--check")
        self.assertEqual(answer.status, 0, answer)
        for words in ("warning: Bodies > Plate: it touches the domain's edge at x = 0 m", "enlarge the domain"):
            self.assertIn(words, answer.messages)
        held = tight.set("Boundaries > Mirror", {"Type": "Symmetry", "Axis": "x", "Position": 0.0})
        answer = rhegma(self.write("held.xml", held.text()), "--check")
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)
        answer = rhegma(self.write("margin.xml", plate().text()), "--check")
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)

    def test_check_doubts_units(self):
        """A modulus in GPa and a temperature in degrees Celsius are possible, and hardly meant."""
        scene = plate().set("Materials > Polymer > Young Modulus", 3.0)
        answer = rhegma(self.write("soft.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 0, answer)
        self.assertIn("warning: Materials > Polymer: its wave speed is", answer.messages)
        heat = {"Specific Heat": 1400.0, "Conductivity": 0.2, "Thermal Expansion": 7e-5}
        for temperature, words in ((20.0, "warning: Thermal > Initial Temperature: bodies start at 20 K"), (293.0, "")):
            scene = plate().set("Thermal", {"Initial Temperature": temperature})
            scene.set("Energy Release > Crack Closure", False)
            for name, value in heat.items():
                scene.set("Materials > Polymer > " + name, value)
            answer = rhegma(self.write("cold.xml", scene.text()), "--check")
            self.assertEqual(answer.status, 0, answer)
            self.assertIn(words, answer.messages)
            self.assertEqual(answer.messages == "", words == "", answer)
        scene.set("Bodies > Plate > Temperature Field", "20+x")
        cooled = {"Type": "Temperature", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.05, 1.0]}
        scene.set("Boundaries > Cooled", dict(cooled, Temperature=20.0))
        blown = {"Type": "Convection", "Body": "Plate", "From": [1.0, 0.0], "To": [1.0, 1.0], "Coefficient": 10.0}
        scene.set("Boundaries > Blown", dict(blown, **{"Ambient Temperature": 25.0}))
        answer = rhegma(self.write("cooled.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 0, answer)
        for words in (
            "Bodies > Plate > Temperature Field: it starts at 20.",
            "Boundaries > Cooled > Temperature: it starts at 20 K",
            "Boundaries > Blown > Ambient Temperature: it starts at 25 K",
        ):
            self.assertIn("warning: " + words, answer.messages)

    def test_set_to_a_wrong_type(self):
        self.refuse("scene.xml", "--set", "Time:CFL=fast", where="Time > CFL", words=['"fast"', "a real number"])

    def test_set_out_of_range(self):
        self.refuse("scene.xml", "--set", "Time:CFL=2", where="Time > CFL", words=["2", "at most 1"])

    def test_set_to_nothing(self):
        self.refuse("scene.xml", "--set", "Time:CFL=", where="Time > CFL", words=['""', "a real number"])

    def test_every_wrong_set_is_reported(self):
        self.assert_refused(
            ["scene.xml", "--set", "Time:CLF=0.3", "--set", "Domain:Cell Size=-1"],
            [("Time > CLF", ['"CFL"']), ("Domain > Cell Size", ["above 0"])],
        )

    def test_threads_that_are_no_number(self):
        self.refuse("scene.xml", "--kokkos-num-threads=many", words=["--kokkos-num-threads=2"])

    def test_unknown_section_to_describe(self):
        self.refuse("--describe", "Materiels", words=["Materiels", '"Materials"'])

    def test_nonsense_to_describe(self):
        self.refuse("--describe", "Zebra", words=["Zebra", "Domain", "Energy Release"])


class Picture(ProgramTest):
    def test_a_checked_scene_is_drawn(self):
        path, picture = self.write("scene.xml", plate().text()), self.path("scene.png")
        answer = rhegma(path, "--check", "--picture", picture, "--set", "Domain:Cell Size=0.1", RHEGMA_TOOLS=os.path.join(SOURCE, "tools"))
        self.assertEqual(answer.status, 0, answer)
        with open(picture, "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")
        # It is drawn from what the check has found, in a folder that is then removed.
        os.mkdir(self.path("tools"))
        shown = self.write("tools/rhegma-plot", '#!/bin/sh\necho "$@"; ls "$8"\n')
        os.chmod(shown, 0o755)
        os.mkdir(self.path("temporary"))
        answer = rhegma(path, "--check", "--quiet", "--picture", picture, RHEGMA_TOOLS=self.path("tools"), TMPDIR=self.path("temporary"))
        self.assertEqual(answer.status, 0, answer)
        self.assertRegex(answer.output, r"--scene \S+ --output \S+ --rhegma \S+ --state \S+/temporary/rhegma-")
        self.assertIn("check.json\nfields.h5\n", answer.output)
        self.assertEqual(os.listdir(self.path("temporary")), [])
        answer = rhegma(path, "--check", "--picture", picture, RHEGMA_TOOLS=self.folder)
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("write that folder into RHEGMA_TOOLS", answer.messages)


class Information(ProgramTest):
    def said(self, *arguments):
        answer = rhegma(*arguments, cwd=self.folder)
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)
        self.assertEqual(os.listdir(self.folder), [])
        return answer.output

    def test_help_names_every_option_and_exit_status(self):
        text = self.said("--help")
        for option in ("--output", "--set", "--quiet", "--strict", "--check", "--print-plan", "--describe", "--version"):
            self.assertIn(option, text)
        for status in range(5):
            self.assertRegex(text, rf"\b{status} ")
        self.assertEqual(self.said("-h"), text)

    def test_version(self):
        self.assertRegex(self.said("--version"), r"\Arhegma \d+\.\d+\.\d+ \(\w+\)\n\Z")

    def test_describe_everything(self):
        text = self.said("--describe")
        for section in SECTIONS + EFFECTS:
            self.assertRegex(text, rf"(?m)^{section}  \((required|optional)\)$")

    def test_describe_a_name_that_is_not_a_section(self):
        """All parts of that name, with their paths; in any case."""
        self.assertEqual(self.said("--describe", "cell size"), self.said("--describe", "Domain:Cell Size"))
        text = self.said("--describe", "Toughness")
        self.assertIn("Propagation > Toughness", text)
        radii = self.said("--describe", "Radius")
        for path in ("Bodies > <body> > Radius", "Thermal > Sources > <source> > Radius", "Cracks > <crack> > Radius"):
            self.assertIn(path, radii)

    def test_describe_one_section(self):
        everything = self.said("--describe")
        for section in SECTIONS + EFFECTS:
            with self.subTest(section=section):
                text = self.said("--describe", section)
                self.assertTrue(text.startswith(section + "  ("), text)
                self.assertIn(text, everything)
                # Every parameter says its type, whether it must be given, and what it means.
                for line, meaning in re.findall(r"(?m)^  (\S.*; .*)\n      (.*)$", text):
                    self.assertRegex(line, r"  (double|int|bool|string|Array\(\w+\))")
                    self.assertRegex(line, r"; (required|default |absent unless given)")
                    self.assertGreater(len(meaning), 8)
                headings = [h for h in re.findall(r"(?m)^(\S.*?)  \(", text)]
                for heading in headings:
                    self.assertTrue(heading == section or heading.startswith(section + " > "), heading)

    def test_describe_a_part(self):
        self.assertEqual(self.said("--describe", "Energy", "Release"), self.said("--describe", "Energy Release"))
        self.assertTrue(self.said("--describe", "Thermal > Probes").startswith("Thermal > Probes  ("))

    def test_described_ranges_are_those_that_are_checked(self):
        self.assertRegex(self.said("--describe", "Time"), r"CFL  double; default 0.4; above 0 and at most 1")


class Words(ProgramTest):
    """Results go to files, progress and answers to stdout, messages to stderr."""

    def setUp(self):
        super().setUp()
        self.scene = self.write("scene.xml", plate().text())

    def test_a_run_says_where_its_results_are(self):
        answer = rhegma(self.scene)
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)
        self.assertIn(f"Results are in {self.path('scene.out')}\n", answer.output)
        self.assertIn("100 %", answer.output)

    def test_a_quiet_run_says_nothing(self):
        answer = rhegma(self.scene, "--quiet")
        self.assertEqual((answer.status, answer.output, answer.messages), (0, "", ""), answer)
        self.assertEqual(
            sorted(os.listdir(self.path("scene.out"))), ["fields.h5", "fields.xdmf", "history.csv", "manifest.json", "summary.json"]
        )

    def test_quiet_does_not_swallow_messages(self):
        self.assert_refused([self.scene, "--quiet", "--set", "Time:CFL=2"], [("Time > CFL", ["at most 1"])])

    def test_check_of_a_right_scene(self):
        answer = rhegma(self.scene, "--check")
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)
        self.assertIn("valid", answer.output)
        self.assertEqual(os.listdir(self.folder), ["scene.xml"])

    def test_check_reports_how_many_steps_a_run_takes(self):
        """To three digits and by the first step; those of an elastic plate hardly change."""
        found = re.search(r"about (\d+) steps of \S+ [mun]?s to Time > Final Time", rhegma(self.scene, "--check").output)
        self.assertEqual(rhegma(self.scene, "--quiet").status, 0)
        with open(self.path("scene.out", "summary.json"), encoding="utf-8") as file:
            self.assertAlmostEqual(int(found[1]) / json.load(file)["steps"], 1.0, delta=0.02)
        fewer = rhegma(self.scene, "--check", "--set", "Time:Maximum Steps=3").output
        self.assertIn("about 3 steps of", fewer)
        self.assertIn("to Time > Maximum Steps", fewer)

    def test_plan_of_a_right_scene(self):
        answer = rhegma(self.scene, "--print-plan")
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)
        self.assertIn("Stages of a step:", answer.output)
        self.assertEqual(os.listdir(self.folder), ["scene.xml"])

    def test_missed_reference(self):
        missed = plate().set(
            "Reference", {"Late": {"Quantity": "time", "Value": 1.0, "Tolerance": 0.1, "Source": "a guess"}}
        )
        answer = rhegma(self.write("missed.xml", missed.text()))
        self.assertEqual((answer.status, answer.messages), (4, ""), answer)
        self.assertIn("OUTSIDE", answer.output)
        self.assertIn("a guess", answer.output)


@unittest.skipUnless(shutil.which("mpirun"), "without mpirun")
class Ranks(ProgramTest):
    LAUNCHER = ("mpirun", "--oversubscribe")

    def start(self, ranks, *arguments):
        root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        return rhegma(*arguments, launcher=(*self.LAUNCHER, "-np", str(ranks)), cwd=self.folder, **root)

    def test_one_rank_is_as_none(self):
        answer = self.start(1, self.write("scene.xml", plate().text()), "--quiet")
        self.assertEqual((answer.status, answer.output, answer.messages), (0, "", ""), answer)

    def test_a_mistake_is_reported_once(self):
        self.write("scene.xml", plate().set("Time > CFL", 3.0).text())
        answer = self.start(2, "scene.xml")
        self.assertEqual(answer.status, 1, answer)
        self.assertEqual(answer.messages.count("rhegma:"), 1, answer)

    def test_help_is_printed_once(self):
        answer = self.start(2, "--help")
        self.assertEqual((answer.status, answer.output), (0, rhegma("--help").output), answer)


class ClosedPipe(ProgramTest):
    def test_a_reader_that_goes_away_is_no_crash(self):
        """rhegma --describe | head -1"""
        describe = subprocess.Popen(
            [PROGRAM, "--describe"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment()
        )
        describe.stdout.close()
        messages = describe.stderr.read().decode()
        describe.stderr.close()
        describe.wait(PATIENCE)
        for noise in NOISE:
            self.assertNotIn(noise, messages)


if __name__ == "__main__":
    unittest.main()
