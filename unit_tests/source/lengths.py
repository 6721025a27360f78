"""Lengths of functions and spread of classes in the sources, as clang-format lays them out."""

import collections
import glob
import os
import re

BRACE = re.compile(r"^( *)\{$")
CONTAINER = re.compile(r"\b(namespace|class|struct|enum|union|extern)\b")
METHOD = re.compile(r"^(?:template\b.*>\s*)?(?:[\w:<>,*&\s~\[\]]*?\s)?[*&]?(?:\w+::)*([A-Z]\w*)(?:<[^()]*?>)?::~?\w+\s*\(")


def sources(root, *endings):
    return sorted(path for folder in ("src", "packages") for ending in endings
                  for path in glob.glob(os.path.join(root, folder, "**", "*" + ending), recursive=True))


def read_lines(path):
    with open(path, encoding="utf-8") as file:
        return file.read().split("\n")


def head_of(lines, brace):
    """The declaration that ends before the line of an opening brace."""
    first = brace
    while first > 0:
        line = lines[first - 1].strip()
        if not line or line.startswith(("//", "#")) or line.endswith((";", "{", "}", ":")) and not line.endswith("::"):
            break
        first -= 1
    return first, " ".join(line.strip() for line in lines[first:brace])


def functions(path):
    """(name, first line, lines between its braces) of each function; a lambda counts with the function that it is in."""
    lines, found, at = read_lines(path), [], 0
    while at < len(lines):
        brace = BRACE.match(lines[at])
        if brace:
            first, head = head_of(lines, at)
            if "(" in head and not (CONTAINER.search(head.split("(")[0]) and not head.startswith("template")):
                end = at + 1
                while not re.match(brace.group(1) + r"\}", lines[end]):
                    end += 1
                name = re.search(r"([\w:~<>]+|operator\S+)\s*\(", head)
                found.append((name.group(1) if name else head, first + 1, end - at - 1))
                at = end
        at += 1
    return found


def long_functions(root, limit):
    """[lines, function, file:line] of all that are longer than the limit, the longest first."""
    found = [(length, name, f"{os.path.relpath(path, root)}:{line}") for path in sources(root, ".cpp", ".hpp")
             for name, line, length in functions(path) if length > limit]
    return sorted(found, reverse=True)


def spread_classes(root, limit):
    """{class: its .cpp files} of all that more .cpp files implement than the limit allows.

    Classes of one name in several folders are distinguished."""
    files = collections.defaultdict(set)
    for path in sources(root, ".cpp"):
        for line in read_lines(path):
            # The name of a definition stands on its first line, at the margin; that of a call is indented.
            method = METHOD.match(line)
            if method and not line[:1].isspace() and not line.endswith(";"):
                folder = os.path.relpath(os.path.dirname(path), root)
                files[folder, method.group(1)].add(os.path.basename(path))
    return {f"{folder} {name}": sorted(paths) for (folder, name), paths in files.items() if len(paths) > limit}
