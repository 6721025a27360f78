#!/usr/bin/env python3
"""README and the pages of docs: no dead link, no page that is too long or that the index does not lead to; the site is built."""

import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from glob import glob

SOURCE = os.environ.get("RHEGMA_SOURCE_DIR") or os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
MOST_LINES = 250
PRINTED = ["docs/reference.md"]  # by the program
# Files whose comments, messages and texts may name pages.
NAMING = ["*.md", "*.cmake", "CMakeLists.txt", "setup", ".ci/*", "cmake/*", "docs/*.*", "docs/*/**/*.*", "src/**/*.*", "packages/**/*.*",
          "tools/*", "tools/*/*.py", "unit_tests/**/*.*", "benchmarks/**/*.*", "xml_inputs/**/*.xml", "unit_tests/fuzz/corpus/scene/*"]


def files(*patterns):
    """Paths relative to the source, by patterns."""
    found = {name for pattern in patterns for name in glob(os.path.join(SOURCE, pattern), recursive=True) if os.path.isfile(name)}
    return sorted(os.path.relpath(name, SOURCE) for name in found)


def pages():
    return files("*.md", "docs/**/*.md")


def read(name):
    with open(os.path.join(SOURCE, name), encoding="utf-8") as file:
        return file.read()


def without_code(text):
    """A page without code; lines stay where they are."""
    text = re.sub(r"^ *```.*?^ *```", lambda block: "\n" * block.group(0).count("\n"), text, flags=re.S | re.M)
    text = re.sub(r"^(?: {4}|\t)(?! *[-*] ).*$", "", text, flags=re.M)
    return re.sub(r"`[^`\n]*`", "``", text)


def links(text):
    """Links and pictures of a page: (line, address)."""
    plain = without_code(text)
    return [(plain.count("\n", 0, match.start()) + 1, match.group(1)) for match in re.finditer(r"\]\(([^)\s]+)\)", plain)]


def anchors(text):
    """Names of a page's headings, as sites make them from their words."""
    names = []
    plain = re.sub(r"^ *```.*?^ *```", "", text, flags=re.S | re.M)
    for title in re.findall(r"^#+ +(.*?) *$", plain, flags=re.M):
        title = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title)
        name = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
        names.append(name if name not in names else f"{name}-{names.count(name)}")
    return names


def target(page, address):
    """The file or folder that a link leads to, relative to the source, and its anchor."""
    path, _, anchor = address.partition("#")
    return (os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page), anchor


def dead(page, text):
    """Why links of a page lead nowhere: a list of lines."""
    wrong = []
    for line, address in links(text):
        if re.match(r"[a-z]+:", address):
            continue
        path, anchor = target(page, address)
        if not os.path.exists(os.path.join(SOURCE, path)):
            wrong.append(f"{page}:{line}: there is no {path}")
        elif anchor and path.endswith(".md") and anchor not in anchors(text if path == page else read(path)):
            wrong.append(f"{page}:{line}: {path} has no heading #{anchor}")
    return wrong


class Pages(unittest.TestCase):
    maxDiff = None

    def test_no_link_is_dead(self):
        self.assertGreater(len(pages()), 40)
        self.assertEqual([why for page in pages() for why in dead(page, read(page))], [])

    def test_notebooks_have_no_dead_link(self):
        for name in files("docs/notebooks/*.ipynb"):
            cells = json.loads(read(name))["cells"]
            text = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
            self.assertEqual(dead(name, text), [])

    def test_a_dead_link_is_found(self):
        text = "# One thing\n[a](nowhere.md) [b](#one-thing) [c](#other) `[d](code.md)`\n\n    [e](code.md)\n"
        self.assertEqual(dead("README.md", text), ["README.md:2: there is no nowhere.md", "README.md:2: README.md has no heading #other"])

    def test_no_page_is_long(self):
        lines = {page: read(page).count("\n") for page in files("docs/**/*.md") if page not in PRINTED}
        self.assertEqual({page: number for page, number in lines.items() if number > MOST_LINES}, {})

    def test_every_page_can_be_found(self):
        """By links, from the index."""
        found, new = set(), ["docs/README.md"]
        while new:
            page = new.pop()
            if page in found or not page.endswith(".md"):
                continue
            found.add(page)
            new += [path for path in (target(page, address)[0] for _, address in links(read(page))
                                      if not re.match(r"[a-z]+:", address)) if path.startswith("docs" + os.sep)]
        self.assertEqual(sorted(set(files("docs/**/*.md")) - found), [])
        self.assertIn("docs/README.md", [target("README.md", address)[0] for _, address in links(read("README.md"))])

    def test_pages_that_are_named_exist(self):
        """In comments, messages and scenes, from the root of the repository."""
        wrong, count = [], 0
        for name in files(*NAMING):
            try:
                text = read(name)
            except UnicodeDecodeError:  # pictures
                continue
            for page in re.findall(r"\bdocs/[\w/-]+\.md\b", text):
                count += 1
                if not os.path.exists(os.path.join(SOURCE, page)):
                    wrong.append(f"{name}: {page}")
        self.assertGreater(count, 50)
        self.assertEqual(wrong, [])


class Site(unittest.TestCase):
    def build(self, folder):
        program = shutil.which("mkdocs")
        if not program:
            if os.environ.get("RHEGMA_REQUIRE_MKDOCS"):
                self.fail("RHEGMA_REQUIRE_MKDOCS is set, but there is no mkdocs; on Debian install mkdocs")
            self.skipTest("no mkdocs; on Debian install mkdocs")
        done = subprocess.run([program, "build", "--strict", "--quiet", "--config-file", os.path.join(SOURCE, "mkdocs.yml"),
                               "--site-dir", folder], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_is_built_with_a_search_and_without_dead_links(self):
        with tempfile.TemporaryDirectory() as folder:
            self.build(folder)
            with open(os.path.join(folder, "search", "search_index.json"), encoding="utf-8") as file:
                found = {entry["location"].partition("#")[0] for entry in json.load(file)["docs"]}
            self.assertEqual(found, {self.place(page) for page in files("docs/**/*.md")})
            self.assertEqual([why for page in found for why in self.dead(folder, page)], [])

    @staticmethod
    def place(page):
        """Where a page is in the site."""
        return re.sub(r"README\.html$", "index.html", page[len("docs/"):-len(".md")] + ".html")

    @staticmethod
    def dead(folder, page):
        """Links of a page of the site that lead nowhere, to a file or within one."""
        with open(os.path.join(folder, page), encoding="utf-8") as file:
            text = file.read()
        for address in re.findall(r'<a [^>]*href="([^"]*)"', text):
            path, _, anchor = address.partition("#")
            if re.match(r"[a-z]+:", address):
                continue
            other = os.path.join(folder, os.path.dirname(page), path) if path else os.path.join(folder, page)
            if not os.path.isfile(other):
                yield f"{page}: {address}"
            elif anchor and other.endswith(".html"):
                with open(other, encoding="utf-8") as file:
                    if f'id="{anchor}"' not in file.read():
                        yield f"{page}: {address}"

    def test_its_menu_has_every_page(self):
        menu = re.findall(r"^ *- (?:\w+: )?(\S+\.md)$", read("mkdocs.yml"), flags=re.M)
        self.assertEqual(sorted("docs/" + page for page in menu), files("docs/**/*.md"))


if __name__ == "__main__":
    unittest.main()
