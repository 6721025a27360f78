#!/usr/bin/env python3
"""Pieces of scenes in README and docs are XML that the program can read: copied into a scene they are no error."""

import os
import re
import unittest
import xml.etree.ElementTree as ET
from glob import glob

SOURCE = os.environ.get("RHEGMA_SOURCE_DIR") or os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
BEGIN = re.compile(r"<Parameter(?:List)?\b")


def pages():
    return [os.path.join(SOURCE, "README.md"), *sorted(glob(os.path.join(SOURCE, "docs", "**", "*.md"), recursive=True))]


def blocks(text):
    """Code blocks, fenced or indented, that begin with XML of a scene: (line, text)."""
    found, lines, fence = [], [], False
    for number, line in enumerate([*text.splitlines(), ""], 1):
        if line.lstrip().startswith("```"):
            fence = not fence
            line = ""
        inside = fence or line.startswith("    ") or (lines and not line.strip() and fence)
        if inside:
            lines.append((number, line))
            continue
        found.append(lines)
        lines = []
    return [(b[0][0], "\n".join(line for _, line in b)) for b in found if b and BEGIN.match(b[0][1].strip())]


def spans(text):
    """Inline code that is XML of a scene: (line, text)."""
    return [(number, code) for number, line in enumerate(text.splitlines(), 1)
            for code in re.findall(r"`(<Parameter(?:List)?\b[^`]*)`", line)]


def mistake(xml):
    """Why a piece is not XML, or None. Dots stand for what a page leaves out, and a list may be left open in a line of prose."""
    try:
        ET.fromstring("<x>" + xml.replace("...", "") + "</x>")
    except ET.ParseError as error:
        return str(error)
    return None


def closed(code):
    """A span that only names the begin of a list, closed."""
    return code if code.rstrip().endswith(("/>", "</ParameterList>")) else code + "</ParameterList>"


class Snippets(unittest.TestCase):
    def test_every_piece_is_xml(self):
        wrong, count = [], 0
        for page in pages():
            with open(page) as file:
                text = file.read()
            pieces = blocks(text) + [(line, closed(code)) for line, code in spans(text)]
            count += len(pieces)
            wrong += [f"{os.path.relpath(page, SOURCE)}:{line}: {why}" for line, code in pieces
                      for why in [mistake(code)] if why]
        self.assertGreater(count, 10)
        self.assertEqual(wrong, [])

    def test_a_bare_less_than_sign_is_found(self):
        page = 'Text\n\n    <Parameter name="History" value="t < 1"/>\n\nMore `<Parameter name="a" value="t < 1"/>`\n'
        self.assertEqual([line for line, _ in blocks(page)], [3])
        self.assertEqual([line for line, _ in spans(page)], [5])
        self.assertTrue(all(mistake(code) for _, code in blocks(page) + spans(page)))
        self.assertIsNone(mistake('<Parameter name="History" value="t &lt; 1"/>'))


if __name__ == "__main__":
    unittest.main()
