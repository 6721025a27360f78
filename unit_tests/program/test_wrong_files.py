#!/usr/bin/env python3
"""Files that are no scene, and output that can't be written."""

import json
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import PATIENCE, PROGRAM, ProgramTest, environment, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

START = '<ParameterList name="Rhegma">'


class WrongFiles(ProgramTest):
    def refuse(self, content, *words):
        self.leave_an_older_run("scene.out")
        self.write("scene.xml", content)
        self.assert_refused(["scene.xml"], [("", words)])

    def test_missing(self):
        self.leave_an_older_run("scene.out")
        self.assert_refused(["scene.xml"], [("", ["scene.xml", "does not exist", "give the path"])])

    def test_folder(self):
        self.leave_an_older_run("scene.xml")
        self.assert_refused(["scene.xml"], [("", ["scene.xml", "folder", "give the path"])])

    def test_empty(self):
        self.refuse("", "is empty", START)

    def test_only_blanks(self):
        self.refuse("\n \n", "XML", START)

    def test_not_xml(self):
        self.refuse("Domain: 2D, 10 mm\nTime: 1 s\n", "XML", START)

    def test_binary(self):
        self.refuse(bytes(range(256)) * 40, "XML", START)

    def test_nothing_but_zeros(self):
        self.refuse(bytes(5000), "XML", START)

    def test_another_kind_of_xml(self):
        self.refuse("<html><body>Rhegma</body></html>", "<html>", START)

    def test_wrong_top_list(self):
        self.refuse(plate().text().replace('name="Rhegma"', 'name="Regma"'), '"Regma"', START)

    def test_top_list_without_name(self):
        self.refuse(plate().text().replace(' name="Rhegma"', ""), "no name", START)

    def test_tags_that_do_not_match(self):
        self.refuse('<ParameterList name="Rhegma"><Parameter></ParameterList></Parameter>', "XML", START)

    def test_two_top_lists(self):
        self.refuse(plate().text() * 2, "XML", START)

    def test_less_than_sign_in_an_expression(self):
        broken = plate().set("Boundaries > Pull > History", "less").text().replace('"less"', '"t < 1e-4"')
        self.refuse(broken, "XML", "&lt;")

    def test_tags_without_end(self):
        self.refuse(START + '<ParameterList name="A">' * 100000, "deep", START)

    def test_larger_than_any_scene(self):
        self.refuse(START + " " * (257 << 20), "256 MB", "scene")

    def test_device_without_end(self):
        self.assert_refused(["/dev/zero"], [("", ["/dev/zero", "is a device", "give the path"])])

    def test_pipe_into_which_no_program_writes(self):
        """It is not waited for."""
        os.mkfifo(self.path("scene.xml"))
        self.assert_refused(["scene.xml", "--quiet"], [("", ["scene.xml", "a pipe into which no program writes", "give the path"])])

    def test_pipe_without_end(self):
        writer = subprocess.Popen(["cat", "/dev/zero"], stdout=subprocess.PIPE)
        self.addCleanup(writer.wait)
        self.addCleanup(writer.kill)
        with writer.stdout:
            answer = subprocess.run([PROGRAM, "/dev/stdin", "--quiet"], stdin=writer.stdout, capture_output=True, text=True,
                                    env=environment(), timeout=PATIENCE)
        self.assertEqual(answer.returncode, 1)
        self.assert_messages(answer.stderr, [("", ["/dev/stdin", "256 MB", "scene"])])

    def test_pipe_that_gives_a_scene(self):
        """As process substitution makes it; the scene comes after the program has begun to wait."""
        child = subprocess.Popen([PROGRAM, "/dev/stdin", "--output", self.path("out"), "--set", "Time:Maximum Steps=2"],
                                 stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment())
        self.addCleanup(child.wait)
        self.addCleanup(child.kill)
        self.assertEqual(child.stderr.readline(), "rhegma: reading the scene from the pipe /dev/stdin\n")
        output, messages = child.communicate(plate().text(), timeout=PATIENCE)
        self.assertEqual(child.returncode, 0, output + messages)
        with open(self.path("out", "manifest.json"), encoding="utf-8") as file:
            self.assertIsNone(json.load(file)["scene"])

    def test_latin_1(self):
        """In a name and in a comment; the message has the line and the byte."""
        text = plate().text().replace("<ParameterList name=", "<!-- a note -->\n<ParameterList name=", 1)
        for old, new in (("Pull", "Tr\u00e4ger"), ("a note", "20 \u00b0C")):
            with self.subTest(new):
                changed = text.replace(old, new)
                byte = f"0x{ord(max(new)):02X}"
                line = 1 + changed[: changed.index(max(new))].count("\n")
                self.write("scene.xml", changed.encode("latin-1"))
                words = [f"line {line}: the byte {byte} is not UTF-8", f'it is "{max(new)}"', "iconv"]
                self.assert_refused(["scene.xml"], [("", words)])

    def test_utf_16(self):
        self.refuse(plate().text().encode("utf-16"), "UTF-16", "UTF-8")

    def test_control_characters_in_names(self):
        """As a reference and as they are; messages do not pass them on to the terminal."""
        for written, shown in (("Pu&#10;ll", "U+000A"), ("Pu\tll", "U+0009"), ("Pu\x7fll", "U+007F"), ("Pu\u009bll", "U+009B")):
            with self.subTest(shown):
                self.write("scene.xml", plate().text().replace('"Pull"', f'"{written}"'))
                self.assert_refused(["scene.xml"], [(f"Boundaries > Pu<{shown}>ll", [f"control character {shown}", "write a name"])])
        self.refuse(plate().text().replace('"Pull"', '"Pu&#27;ll"'), "line ", "&#", "no character")

    def test_control_character_in_the_name_of_the_only_body(self):
        """That the section is empty without this body is not an error of its own."""
        self.write("scene.xml", plate().text().replace('"Plate"', '"Pl\tate"'))
        self.assert_refused(["scene.xml"], [("Bodies > Pl<U+0009>ate", ["control character U+0009", "write a name"])])

    def test_text_next_to_the_tags(self):
        self.leave_an_older_run("scene.out")
        self.write("scene.xml", plate().text().replace("</ParameterList>", "steel</ParameterList>", 1))
        self.assert_refused(["scene.xml"], [("Domain", ['"steel"', "<Parameter name"])])

    def test_unknown_tag(self):
        self.leave_an_older_run("scene.out")
        self.write("scene.xml", plate().text().replace("<Parameter ", "<Param ", 1))
        mistakes = [("Domain", ["<Param>", "<Parameter>"]), ("Domain > Dimension", ["missing"])]
        self.assert_refused(["scene.xml"], mistakes)

    def test_truncated_anywhere(self):
        """A truncated scene is refused and does not crash the program."""
        self.leave_an_older_run("scene.out")
        whole = plate().text()
        for percent in range(2, 100, 7):
            with self.subTest(percent=percent):
                self.write("scene.xml", whole[: len(whole) * percent // 100])
                self.assert_refused(["scene.xml"], [("", ["XML", START])])

    def test_byte_order_mark_and_comments_are_no_mistake(self):
        scene = b"\xef\xbb\xbf<!-- don't > stop -->" + plate().text().encode()
        answer = rhegma(self.write("scene.xml", scene), "--check")
        self.assertEqual(answer.status, 0, answer)


class WrongOutput(ProgramTest):
    def refuse(self, output, *words):
        self.write("scene.xml", plate().text())
        self.assert_refused(["scene.xml", "--output", output], [("", words + ("--output",))])

    def test_file(self):
        self.write("taken", "a file\n")
        self.refuse("taken", "taken")

    def test_below_a_file(self):
        self.write("taken", "a file\n")
        self.refuse("taken/below", "taken/below")

    def test_where_nobody_may_write(self):
        self.refuse("/proc/rhegma", "/proc/rhegma")

    def test_without_a_name(self):
        self.refuse("", "no folder")

    def test_name_that_is_too_long(self):
        self.refuse("x" * 300, "too long")

    def test_default_folder_is_a_file(self):
        self.write("scene.xml", plate().text())
        self.write("scene.out", "a file\n")
        self.assert_refused(["scene.xml"], [("", ["scene.out", "--output"])])

    def test_folder_instead_of_a_result(self):
        os.makedirs(self.path("out", "history.csv", "inside"))
        self.write("scene.xml", plate().text())
        self.assert_refused(["scene.xml", "--output", "out"], [("", ["history.csv", "--output"])])


if __name__ == "__main__":
    unittest.main()
