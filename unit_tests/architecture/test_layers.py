#!/usr/bin/env python3
"""The folders of src include one another only as the table of docs/explanation/architecture.md allows, and effects never each other."""

import os
import re
import shutil
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), ".."))
from own_folder import SOURCE, OwnFolder  # noqa: E402

EFFECT = "packages/"  # in front of the name of an effect's folder


def allowed_arrows(page):
    """Folder -> set of folders that it may include, from the rows `| layer | \\`folder\\` | ... |` of the page's table."""
    arrows = {}
    with open(page) as text:
        for line in text:
            row = re.match(r"\|[^|]*\| `([\w/*]+)` \|([^|]*)\|[^|]*\|$", line)
            if row:
                arrows[row[1]] = set(re.findall(r"`([\w/*]+)`", row[2]))
    return arrows


def folder_of(path):
    """The row of the table for a file: its folder in src, `library` or `program` for files in src itself, an effect's folder."""
    parts = path.split("/")
    if parts[0] == "packages":
        return EFFECT + parts[1]
    if len(parts) == 2:
        return "program" if parts[1] in ("main.cpp", "LargeAllocations.cpp") else "library"
    return parts[1]


def includes(root):
    """Every include of one file of the project by another: (file, folder, included file, its folder)."""
    found = []
    for base in ("src", "packages"):
        for folder, _, names in os.walk(os.path.join(root, base)):
            for name in names:
                if not name.endswith((".hpp", ".cpp")):
                    continue
                path = os.path.relpath(os.path.join(folder, name), root)
                with open(os.path.join(root, path)) as text:
                    for wanted in re.findall(r'^#include "([^"]+)"', text.read(), re.M):
                        target = next(t for t in ("src/" + wanted, "packages/" + wanted, None)
                                      if t is None or os.path.exists(os.path.join(root, t)))
                        if target is None:
                            raise AssertionError(f'{path} includes "{wanted}", which is not in src or packages')
                        found.append((path, folder_of(path), target, folder_of(target)))
    return found


def violations(root, arrows):
    """One message for each include that the table does not allow."""
    wrong = []
    for path, source, target, to in includes(root):
        row = "packages/*" if source.startswith(EFFECT) else source
        if source != to and to not in arrows.get(row, set()):
            wrong.append(f"{path} includes {target}: {source} may not include {to} (docs/explanation/architecture.md)")
    return wrong


def circle(arrows):
    """Folders that can reach themselves."""
    def reach(start):
        seen, todo = set(), [start]
        while todo:
            new = arrows.get(todo.pop(), set()) - seen
            seen |= new
            todo += new
        return seen
    return sorted(folder for folder in arrows if folder in reach(folder))


class Layers(OwnFolder):
    def setUp(self):
        super().setUp()
        self.arrows = allowed_arrows(os.path.join(SOURCE, "docs", "explanation", "architecture.md"))

    def test_the_table_lists_every_folder_once_and_has_no_circle(self):
        folders = set(name for name in os.listdir(os.path.join(SOURCE, "src"))
                    if os.path.isdir(os.path.join(SOURCE, "src", name)))
        self.assertEqual(folders | {"library", "program", "packages/*"}, set(self.arrows))
        self.assertEqual([], circle(self.arrows))
        unknown = set().union(*self.arrows.values()) - set(self.arrows)
        self.assertEqual(set(), unknown)

    def test_every_include_is_allowed(self):
        self.assertGreater(len(includes(SOURCE)), 500)
        self.assertEqual([], violations(SOURCE, self.arrows))

    def spoilt(self, path, wanted):
        """Violations of a copy in which one file includes another in addition."""
        for base in ("src", "packages"):
            shutil.copytree(os.path.join(SOURCE, base), self.path("copy", base))
        with open(self.path("copy", path), "a") as text:
            text.write(f'\n#include "{wanted}"\n')
        return violations(self.path("copy"), self.arrows)

    def test_an_include_upwards_is_found(self):
        wrong = self.spoilt("src/grid/Grid.hpp", "state/State.hpp")
        self.assertEqual(1, len(wrong), wrong)
        self.assertIn("grid may not include state", wrong[0])

    def test_an_effect_that_includes_another_is_found(self):
        wrong = self.spoilt("packages/damping/Damping.cpp", "contact/Contact.hpp")
        self.assertEqual(1, len(wrong), wrong)
        self.assertIn("packages/damping may not include packages/contact", wrong[0])

    def test_a_circle_in_the_table_is_found(self):
        self.assertEqual(["base", "grid"], circle({"base": {"grid"}, "grid": {"base"}, "state": {"grid"}}))


if __name__ == "__main__":
    unittest.main()
