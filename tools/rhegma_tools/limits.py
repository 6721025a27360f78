"""Limits for vanishing cell size of what the families of a study answer."""

import csv

from rhegma.summary import read_summary

from .answers import answers_of
from .lengths import metres
from .output_file import text_to
from .richardson import find_limit
from .study_file import CELL

COLUMNS = ["family", "answer", "unit", "finest", "order", "extrapolated", "from", "to", "reference", "why not"]


class Row:
    """An answer of a family: values at the family's sizes, largest first, and their Limit."""

    def __init__(self, name, unit, values, limit, reference):
        self.name = name
        self.unit = unit
        self.values = values
        self.limit = limit
        self.reference = reference


class Mesh:
    """Runs of a family that differ in their cells: sizes [m], largest first, as written and as numbers; rows; why: a sentence
    where there are none."""

    def __init__(self, family, outcomes):
        self.family = family
        self.texts = [o.run.settings[CELL] for o in outcomes]
        self.sizes = [metres(text) for text in self.texts]
        self.rows, self.why = [], None


def size_of(outcome):
    return metres(outcome.run.settings[CELL])


def meshes_in(outcomes):
    """[[outcome]] of one family each, of falling cell size. Settings that have one value for each size, such as the corners of
    the domain, may change with it; of a product of settings there is a mesh for each combination of the others."""
    groups = {}
    for family in dict.fromkeys(o.run.family for o in outcomes):
        own = [o for o in outcomes if o.run.family == family and CELL in o.run.settings]
        alone = len({size_of(o) for o in own}) == len(own)
        for o in own:
            others = () if alone else tuple(sorted((p, v) for p, v in o.run.settings.items() if p != CELL))
            groups.setdefault((family, others), []).append(o)
    return [sorted(group, key=size_of, reverse=True) for group in groups.values() if len({size_of(o) for o in group}) > 1]


def refinements(summaries):
    """Cells of the largest over the smallest size, of each run."""
    cells = [summary.get("cells") or {} for summary in summaries]
    return [c["largest"] / c["smallest"] if c.get("largest") and c.get("smallest") else 1.0 for c in cells]


def measure_mesh(group):
    """The Mesh of outcomes of falling cell size."""
    good = [o for o in group if o.good]
    mesh = Mesh(group[0].run.family, good)
    if len(good) < 3:
        mesh.why = f"a limit needs three cell sizes, and {len(good)} runs finished" + (
            " (rhegma --twice prints limits of orders 2 and 1 of two)." if len(good) == 2 else ".")
        return mesh
    summaries = [read_summary(o.folder) for o in good]
    ratios = refinements(summaries)
    if max(ratios) > 1.01 * min(ratios):
        mesh.why = "the refinement of the cells changes with their size, so the order over the size has no meaning."
        return mesh
    found = [answers_of(s, o.run.quantities, o.run.references) for s, o in zip(summaries, good)]
    for name, answer in found[-1].items():
        if all(name in answers for answers in found):
            values = [answers[name].value for answers in found]
            mesh.rows.append(Row(name, answer.unit, values, find_limit(mesh.sizes, values), answer.reference))
    if not mesh.rows:
        mesh.why = "the runs have no answer in common."
    return mesh


def short(number):
    return "-" if number is None else f"{number:.5g}"


def mesh_as_text(mesh):
    """Lines: a head with the cell sizes, and a line for each answer."""
    if mesh.why:
        return [f"{mesh.family}: no limits for vanishing cells: {mesh.why}"]
    lines = ["%-36s" % f"{mesh.family}, cells [m]" + "".join("%12s" % short(size) for size in mesh.sizes) + "%8s%14s" % ("order", "extrapolated")]
    for row in mesh.rows:
        limit = row.limit
        name = row.name + (f" [{row.unit}]" if row.unit else "")
        line = "%-36s" % name + "".join("%12s" % short(value) for value in row.values)
        line += "%8s%14s" % ("-" if limit.order is None else f"{limit.order:.2f}", short(limit.value))
        if limit.low is not None:
            line += f"  {'between' if limit.order else 'orders 2 and 1:'} {short(limit.low)} {'and' if limit.order else 'to'} {short(limit.high)}"
        if row.reference is not None and limit.value is not None:
            line += f", {100.0 * (limit.value / row.reference - 1.0):+.2g} % of the reference"
        lines.append(line + (f"; no order: {limit.why}" if limit.why else ""))
    return lines


def write_limits(outcomes, path):
    """Writes limits.csv where families have several cell sizes. Returns the lines to print; empty where none has."""
    meshes = [measure_mesh(group) for group in meshes_in(outcomes)]
    if not meshes:
        return []
    with text_to(path) as file:
        table = csv.writer(file)
        table.writerow(COLUMNS)
        for mesh in meshes:
            for row in mesh.rows:
                limit = row.limit
                numbers = [row.values[-1], limit.order, limit.value, limit.low, limit.high, row.reference]
                table.writerow([mesh.family, row.name, row.unit, *("" if n is None else repr(n) for n in numbers), limit.why or ""])
            if mesh.why:
                table.writerow([mesh.family, *[""] * 8, mesh.why])
    return [line for mesh in meshes for line in mesh_as_text(mesh)]
