"""Compares the numbers that two runs of a scene left. A difference is a pair: its size, and what differs."""

import csv
import fnmatch
import json
import math
import os
import re

ENERGIES = {"kinetic", "strain", "external_work", "damped", "residual", "contact", "fracture", "combustion", "heat", "thermal",
            "merged", "stabilised", "filtered", "tools", "interfaces"}
# What depends on the machine, and is no result.
NO_RESULT = ("wall_seconds", "ns_per_particle_step", "peak_memory_bytes*", "bytes_per_particle", "checkpoints.*", "stages.*",
             "*.seconds", "*_seconds", "version", "scene")
NONE = (0.0, "")


def kind_of(name):
    """Columns of one kind have one scale: components of a vector, modes, energies."""
    return "energy" if name in ENERGIES else re.sub(r"(_[xyz]|_I{1,3}|\.[xyz]{1,2}|\.\d+)$", "", name)


def is_ignored(name, patterns):
    return any(fnmatch.fnmatch(name, pattern) for pattern in patterns)


def name_now(name, renamed):
    """A name of the program before as the program after writes it. renamed: [(old part, new part)]"""
    for old, new in renamed:
        name = name.replace(old, new)
    return name


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return math.nan


def difference(before, after, scale):
    """Of two numbers that may be absent or not finite, relative to a scale."""
    if before == after or (math.isnan(before) and math.isnan(after)):
        return 0.0
    if not (math.isfinite(before) and math.isfinite(after)):
        return math.inf
    return abs(before - after) / scale


def only_in_one(before, after):
    """The difference of what only one of two sets of names has."""
    lost, new = sorted(set(before) - set(after)), sorted(set(after) - set(before))
    if lost or new:
        return math.inf, f"{'lost ' + ', '.join(lost[:4]) if lost else ''}{' new ' + ', '.join(new[:4]) if new else ''}".strip()
    return NONE


def read_rows(folder):
    try:
        with open(os.path.join(folder, "history.csv"), newline="", encoding="utf-8") as file:
            rows = [row for row in csv.reader(file) if row]
    except OSError:
        return [], []
    return (rows[0], rows[1:]) if rows else ([], [])


def compare_histories(before, after, cut, ignore, renamed=()):
    """The largest difference of two runs' histories, and the number of rows compared.

    cut: one run was stopped, so that only the rows that both have count, less the last of them, which a run that stops adds."""
    (names, rows), (names_after, rows_after) = read_rows(before), read_rows(after)
    names = [name_now(name, renamed) for name in names]
    if cut:
        count = max(0, min(len(rows), len(rows_after)) - 1)
        rows, rows_after = rows[:count], rows_after[:count]
    if names == names_after and rows == rows_after:
        return NONE, len(rows)
    names = {name: i for i, name in enumerate(names) if not is_ignored(name, ignore)}
    names_after = {name: i for i, name in enumerate(names_after) if not is_ignored(name, ignore)}
    worst = only_in_one(names, names_after)
    if len(rows) != len(rows_after):
        worst = max(worst, (math.inf, f"the number of rows, {len(rows)} before and {len(rows_after)} after"))
    scales, columns = {}, {}
    for name in names.keys() & names_after.keys():
        columns[name] = [(row[names[name]], other[names_after[name]]) for row, other in zip(rows, rows_after)]
        magnitudes = [abs(number(text)) for texts in columns[name] for text in texts]
        largest = max([m for m in magnitudes if math.isfinite(m)], default=0.0)
        scales[kind_of(name)] = max(scales.get(kind_of(name), 0.0), largest)
    for name, column in columns.items():
        for texts in column:
            if texts[0] != texts[1]:
                size = difference(number(texts[0]), number(texts[1]), scales[kind_of(name)] or 1.0)
                worst = max(worst, (size, name))
    return worst, len(rows)


def numbers_of(value, path="", found=None):
    """All numbers of a summary by their paths; null is NaN, a boolean 0 or 1, text is left out but for the status."""
    found = {} if found is None else found
    if isinstance(value, dict):
        for key, entry in value.items():
            numbers_of(entry, f"{path}.{key}" if path else key, found)
    elif isinstance(value, list):
        for i, entry in enumerate(value):
            numbers_of(entry, f"{path}.{i}", found)
    elif path == "status":
        found[path + " " + value] = 1.0
    elif not isinstance(value, str):
        found[path] = math.nan if value is None else float(value)
    return found


def compare_summaries(before, after, ignore, renamed=()):
    """The largest difference of two runs' summaries."""
    found = []
    for folder in (before, after):
        try:
            with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
                found.append({path: value for path, value in numbers_of(json.load(file)).items()
                              if not is_ignored(path, NO_RESULT)})
        except OSError:
            found.append({})
    found[0] = {name_now(path, renamed): value for path, value in found[0].items()}
    found = [{path: value for path, value in numbers.items() if not is_ignored(path, ignore)} for numbers in found]
    worst = only_in_one(*found)
    scales = {}
    for path, value in [*found[0].items(), *found[1].items()]:
        kind = "energy" if path.startswith("energy.") else kind_of(path)
        scales[kind] = max(scales.get(kind, 0.0), abs(value) if math.isfinite(value) else 0.0)
    for path in found[0].keys() & found[1].keys():
        kind = "energy" if path.startswith("energy.") else kind_of(path)
        size = difference(found[0][path], found[1][path], scales[kind] or 1.0)
        worst = max(worst, (size, f"summary {path}")) if size > 0.0 else worst
    return worst
