#!/usr/bin/env python3
"""Words that the project does not use: in README, docs, printed parameters and messages, and in code.

Each word has a standard term, which a failure names. In what a user reads, identifiers (in code spans and in literals
without a blank) are not checked; in code, identifiers and comments are."""

import os
import re
import subprocess
import unittest
from glob import glob

SOURCE = os.environ.get("RHEGMA_SOURCE_DIR") or os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
PROGRAM = os.environ.get("RHEGMA_PROGRAM")

# A pattern and what to write instead.
TERMS = [
    (r"stations?", "front node"),
    (r"books|book(?:ed|ing)|bookkeeping|ledgers?", "energy balance, recorded"),
    (r"debts?|ow(?:e|es|ed)|repaid|taken too much", "energy carried over"),
    (r"torn", "over-dissipated"),
    (r"unspent|left to take", "pending energy"),
    (r"(?:give|gives|given|gave) back", "return"),
    (r"taken along|bulges?|bulging|hand(?:s|ed)? on", "front smoothing, curvature flux"),
    (r"mouths?(?! opening)", "surface-breaking end, free edge"),
    (r"sets? out|setting out", "initiated"),
    (r"(?:come|comes|came|coming) to rest", "arrested, settled"),
    (r"halt(?:s|ed)?", "stopped"),
    (r"(?:way|room) ahead", "ligament ahead, available length"),
    (r"carried fronts?|loose", "advected front"),
    (r"brief (?:steps?|nodes?)", "substep, subcycled node"),
    (r"second fields?", "enriched field"),
    (r"following forces?", "displacement-dependent nodal force"),
    (r"troubles?|complaints?|complains?", "failure, diagnostic"),
    (r"rides?|riding", "is advected with, moves with"),
    (r"sentences?|tells?|told", "message, warning, report"),
    (r"thin spots?|seams?|rubs?|rubbed|rubbing", "interface, frictional sliding"),
    (r"besides?", "next to, in addition to, compared with"),
    (r"against the clock", "counter-clockwise"),
]
# Those that are ordinary words in code, such as `long step`, `std::tie` and ranks that share a node.
TERMS_OF_PROSE = [
    (r"places?", "position"),
    (r"ways?", "path, displacement increment, direction"),
    (r"ties?|tied", "front spring"),
    (r"(?:short|long) steps?", "substep, step"),
    (r"(?:small|large|smallest|largest) cells?", "fine cells, coarse cells"),
    (r"(?:a|the|no|its|their|this|that|of|by|which|one|largest|smallest) shares?|shares? of", "fraction"),
    (r"rooms?", "capacity, cavity volume, ligament, space"),
    (r"in space|InSpace", "3D"),
]
# Those of identifiers alone.
TERMS_OF_NAMES = [(r"shares?", "fraction")]
# Ordinary English with one of the words.
ALLOWED = re.compile(r"\b(?:(?:this|the same|the easy|another) way|takes? place)\b", re.IGNORECASE)



class Words:
    """Finds the words of a list in a text, each with what to write instead."""

    def __init__(self, terms):
        self.terms = terms
        groups = (rf"(?P<t{i}>\b(?:{words})\b)" for i, (words, _) in enumerate(terms))
        self.pattern = re.compile("|".join(groups), re.IGNORECASE)

    def __call__(self, text):
        hits = self.pattern.finditer(ALLOWED.sub("", text))
        return [f'"{hit.group(0)}" (write: {self.terms[int(hit.lastgroup[1:])][1]})' for hit in hits]


found = Words(TERMS + TERMS_OF_PROSE)
found_in_code = Words(TERMS)
found_in_names = Words(TERMS_OF_NAMES)


def prose(markdown):
    """A page without its code, links' addresses and blocks of code; lines stay where they are."""
    text = re.sub(r"^(?: {4}|\t).*$", "", markdown, flags=re.M)
    text = re.sub(r"```.*?```", lambda block: "\n" * block.group(0).count("\n"), text, flags=re.S)
    return re.sub(r"`[^`\n]*`|\]\([^)\n]*\)", "", text)


LITERAL = re.compile(
    r"//[^\n]*|/\*.*?\*/|R\"\(.*?\)\"|#include[^\n]*|'(?:\\.|[^'\\\n])'|\"(?P<text>(?:\\.|[^\"\\\n])*)\"", re.S
)


def literals(code):
    """String literals with a blank inside, with their lines; adjacent ones are one. Former names and names in
    checkpoints are left out."""
    texts, end = [], None
    for match in LITERAL.finditer(code):
        if match.group("text") is None or code[: match.start()].endswith(("formerly(", "archive(", "(archive, ")):
            continue
        if end is not None and code[end : match.start()].isspace():
            texts[-1][1] += match.group("text")
        else:
            texts.append([code.count("\n", 0, match.start()) + 1, match.group("text")])
        end = match.end()
    return [(line, text) for line, text in texts if " " in text.strip()]


STRING = re.compile(r"R\"\(.*?\)\"|\"(?:\\.|[^\"\\\n])*\"", re.S)


def words(name):
    """An identifier in words: `frontOf_` and `front_of` are "front Of " and "front of"."""
    return re.sub(r"([a-z0-9])([A-Z])", r"\1 \2", name).replace("_", " ")


def wrong_in_code(code):
    """Words in identifiers and comments, with their lines. Literals are left out: `literals` finds those."""
    rows = STRING.sub(lambda literal: '""' + "\n" * literal.group(0).count("\n"), code).splitlines()
    for line, row in enumerate(rows, 1):
        for word in found_in_code(words(row)):
            yield line, word
        for name in re.findall(r"\w+", row.partition("//")[0]):
            for word in found_in_names(words(name)):
                yield line, f"{word} in {name}"


class Terms(unittest.TestCase):
    maxDiff = None

    def check(self, texts):
        wrong = [f"{where}: {word}" for where, text in texts for word in found(text)]
        self.assertFalse(wrong, "private words where a user reads:\n" + "\n".join(wrong))

    def files(self, *patterns):
        names = [name for pattern in patterns for name in glob(os.path.join(SOURCE, pattern), recursive=True)]
        self.assertTrue(names)
        for name in sorted(names):
            with open(name, encoding="utf-8") as file:
                yield os.path.relpath(name, SOURCE), file.read()

    def test_pages(self):
        for name, text in self.files("*.md", "docs/**/*.md"):
            with self.subTest(name):
                self.check((f"{name}:{line}", row) for line, row in enumerate(prose(text).splitlines(), 1))

    def test_messages_and_parameters(self):
        for name, code in self.files("src/**/*.[ch]pp", "packages/**/*.[ch]pp"):
            with self.subTest(name):
                self.check((f"{name}:{line}", text) for line, text in literals(code))

    def test_code(self):
        for name, code in self.files("src/**/*.[ch]pp", "packages/**/*.[ch]pp", "docs/**/*.[ch]pp"):
            with self.subTest(name):
                wrong = [f"{name}:{line}: {word}" for line, word in wrong_in_code(code)]
                self.assertFalse(wrong, "private words in code:\n" + "\n".join(wrong))

    @unittest.skipUnless(PROGRAM, "no program was built")
    def test_printed_reference(self):
        answer = subprocess.run([PROGRAM, "--describe"], capture_output=True, text=True, check=True)
        self.check((f"--describe, line {line}", row) for line, row in enumerate(answer.stdout.splitlines(), 1))

    def test_finds_a_word_and_lets_others_pass(self):
        self.assertEqual(len(found("The station of a front sets out in short steps.")), 3)
        self.assertEqual(found("Two ranks share nodes; crack mouth opening; in this way."), [])
        self.assertEqual(found(prose("    ledger\n`books` [link](ledger.md)\n")), [])
        code = '// "a b"\nf("one "\n  "two", \'"\', "single").formerly("old name");\n'
        self.assertEqual(literals(code), [(2, "one two")])

    def test_finds_a_word_in_code_and_lets_others_pass(self):
        code = 'double splitShare, ledger_; // the nodes that ranks share\nf("ledger");\nlong step = 0; // a Station\n'
        self.assertEqual([line for line, _ in wrong_in_code(code)], [1, 1, 3])


if __name__ == "__main__":
    unittest.main()
