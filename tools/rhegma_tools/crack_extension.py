"""G of one front by the change of potential energy with the length of its crack, next to that of the domain integral.

G = -d(U - W) / dA at constant loads and supports (A. A. Griffith, Phil. Trans. R. Soc. A 221 (1921) 163), by the central difference of runs
with a longer and a shorter crack. Along the cells these differ by a cell, so that the front has the same position in its cell. At an angle
the end of the crack on the grid scatters by some 0.1 cells about the front, so that these cracks differ by STEP cells."""

import csv
import math
import os

from rhegma.problem import Problem
from rhegma.summary import read_summary
from rhegma.values import split_array

from .lengths import METRES, unit_of
from .output_file import text_to
from .scene_study import read_scene
from .study_file import Run, Study

STEP = 4.0  # cells: 0.1 cells of scatter of both ends are then 2 % of G
ALONG = math.sin(math.radians(0.1))  # of an angle to a grid axis within which a crack is along the cells
FAR = 0.5  # cells: distance of a front from the end of a crack within which it is taken for it,
NEARER = 0.2  # or this fraction of its distance from the other end
WITHOUT = ("Thermal", "Combustion", "Contact", "Propagation")  # sections whose energies are not those of loads and strain
UNLISTED = ("Face Pressure",)  # sections of loads without an entry in "boundaries" of the summary


def child(element, name):
    """The child of a list with this name; None where there is none."""
    return None if element is None else next((entry for entry in element if entry.get("name") == name), None)


def text_of(element, *names):
    """The value at names within lists, or None."""
    for name in names:
        element = child(element, name)
    return None if element is None else element.get("value")


def value_and_unit(element, *names):
    """(value, unit) at names within lists, as texts; the unit is empty where there is none."""
    for name in names:
        element = child(element, name)
    if element is None or element.get("value") is None:
        return "", ""
    value, unit = element.get("value"), element.get("unit", "").strip()
    brace = value.rfind("}") + 1
    if brace:
        return value[:brace], unit or value[brace:].strip()
    own = unit_of(value)
    return (value[:value.rindex(own)], own) if own else (value, unit)


def numbers(element, name):
    """An array of a list as numbers in its unit, or None where it is absent or no array of numbers."""
    try:
        return [float(text) for text in split_array(value_and_unit(element, name)[0], name)]
    except (Problem, ValueError):
        return None


def in_metres(element, *names):
    """A length [m] at names within lists, or an array of them; None where there is none."""
    value, unit = value_and_unit(element, *names)
    if unit not in METRES:
        raise Problem(f"--crack-extension: {' > '.join(names)} is in {unit}; write it in m, cm, mm or um.")
    if value.strip().startswith("{"):
        found = numbers(element, names[-1])
        return None if found is None else [METRES[unit] * number for number in found]
    return METRES[unit] * float(value) if value else None


class Extension:
    """Of a crack by some cells at one front, or all around in 3D. path: of the parameter that changes; texts: its values for the
    shorter and the longer crack; area: by which the crack changes [m2], or None where the summaries have its area."""

    def __init__(self, path, texts, area):
        self.path = path
        self.texts = texts
        self.area = area


def array_text(values):
    return "{" + ", ".join(repr(value) for value in values) + "}"


def of_polyline(points, front, cell, where):
    """Points with the end at the front moved along its segment: ([shorter, longer], by how much [m])."""
    ends = {0: (points[:2], points[2:4]), -2: (points[-2:], points[-4:-2])}
    at = min(ends, key=lambda k: math.dist(ends[k][0], front))
    end, inner = ends[at]
    # The front is where the loads have moved it; the ends of the crack are further apart than that.
    other = max(math.dist(ends[0][0], front), math.dist(ends[-2][0], front))
    if math.dist(end, front) > max(FAR * cell, NEARER * other):
        raise Problem(f"{where}: its front is at {array_text(front)}, and no end of its Points is near; only a front at an end is moved.")
    length = math.dist(end, inner)
    along = min(abs(e - i) for e, i in zip(end, inner)) < ALONG * length
    far = cell if along else STEP * cell
    if length < 2.0 * far * (1.0 - 1e-9):
        raise Problem(f"{where}: its last segment is {length:.9g} m long, and must be {2.0 * far:.9g} m or longer, so that the crack can be "
                      f"shorter by {far:g} m, {far / cell:g} cells; use smaller cells, or draw the crack with one long last segment.")
    changed = []
    for step in (-far, far):
        moved = list(points)
        start = at if at >= 0 else len(points) - 2
        moved[start:start + 2] = [e + step * (e - i) / length for e, i in zip(end, inner)]
        changed.append(moved)
    return changed, far


def read_extension(path, name, summary):
    """The Extension of the front NAME.N of a scene, from its file and the summary of its run."""
    crack, _, number = name.rpartition(".")
    root, where = read_scene(path), f"--crack-extension {name}"
    entry = child(child(root, "Cracks"), crack)
    found = next((c for c in summary.get("cracks") or [] if c.get("name") == crack), {})
    fronts = found.get("fronts") or []
    if entry is None or not number.isdigit() or int(number) >= len(fronts):
        raise Problem(f"{where}: the scene has no such front; write CRACK.N, such as Notch.0.")
    cell = summary["cells"]["largest"]
    points, radius = in_metres(entry, "Points"), in_metres(entry, "Radius")
    if text_of(root, "Domain", "Dimension") == "2" and points:
        depth = in_metres(root, "Domain", "Thickness") or 1.0
        changed, far = of_polyline(points, fronts[int(number)]["position"], cell, where)
        return Extension(f"Cracks:{crack}:Points", [array_text(p) for p in changed], far * depth)
    if radius and child(entry, "Second Radius") is None:
        if radius < 2.0 * cell:
            raise Problem(f"{where}: its Radius is {radius} m, and must be two cells or more.")
        return Extension(f"Cracks:{crack}:Radius", [repr(radius + step) for step in (-cell, cell)], None)
    raise Problem(f"{where}: only cracks of Points in 2D and disks of a Radius in 3D can be made longer.")


def moves(support):
    """Whether a boundary of a scene is a support that moves."""
    if text_of(support, "Type") != "Velocity":
        return False
    return child(support, "Field") is not None or any(numbers(support, "Value") or [])


def refuse_others(path):
    """Throws a Problem where the energies of a scene are not those of loads and elastic strain in equilibrium."""
    root = read_scene(path)
    if text_of(root, "Time", "Analysis") not in ("Static", "Quasi-Static"):
        raise Problem("--crack-extension: compares equilibria; set Time > Analysis to Static.")
    for name in WITHOUT:
        if child(root, name) is not None:
            raise Problem(f"--crack-extension: is not defined with the section {name}, whose energy changes with the crack, too.")


def potential_of(path):
    """A function that gives the potential energy of a summary [J]: the work of all loads and supports, which an elastic body
    stores, less load times displacement. Loads without a displacement in the summary do half of that if nothing else works
    (Clapeyron, linear)."""
    root = read_scene(path)
    unlisted = [name for name in UNLISTED if child(root, name) is not None]
    boundaries = child(root, "Boundaries")
    boundaries = [] if boundaries is None else boundaries
    if any(text_of(boundary, "Type") == "Gravity" for boundary in boundaries):
        unlisted.append("Gravity")
    if not unlisted:
        return lambda s: s["energy"]["external_work"] - sum(
            b["displacement"] * math.hypot(*(f or 0.0 for f in b["force"])) for b in s["boundaries"] if "displacement" in b)
    if any(moves(support) for support in boundaries):
        raise Problem(f"--crack-extension: {unlisted[0]} and a support that moves both do work, which the summary does not separate.")
    return lambda s: -s["energy"]["external_work"]


def study_of_extension(path, settings):
    """A study of a scene, one run for each {path: value}."""
    name = os.path.splitext(os.path.basename(path))[0]
    return Study(path, name, [Run(name, os.path.abspath(path), values, [], []) for values in settings], [])


def rows_of(name, extension, summaries, potential):
    """[(method, G)] of the summaries of the shorter, the present and the longer crack."""
    crack, _, number = name.rpartition(".")
    fronts = [next(c for c in s["cracks"] if c["name"] == crack) for s in summaries]
    areas = [step * extension.area for step in (-1, 0, 1)] if extension.area else [c["area"] for c in fronts]
    energies = [potential(s) for s in summaries]

    def rate(one, other):
        return -(energies[other] - energies[one]) / (areas[other] - areas[one])

    front = fronts[1]["fronts"][int(number)]
    rows = [("change of energy", rate(0, 2)), ("  to the shorter crack", rate(0, 1)), ("  to the longer crack", rate(1, 2))]
    return rows + [(label, front[key]) for label, key in (("domain integral, G_J", "G_J"), ("crack closure, G_closure", "G_closure"))
                   if isinstance(front.get(key), float)]


def write_release(name, rows, path):
    """Writes release.csv. Returns the lines to print."""
    with text_to(path) as file:
        table = csv.writer(file)
        table.writerow(["front", "method", "G"])
        table.writerows([name, method.strip(), repr(value)] for method, value in rows)
    lines = ["%-28s%12s" % (f"G of {name} [J/m2] by", "")]
    for method, value in rows:
        off = "" if method in (rows[0][0], rows[1][0], rows[2][0]) else f"  {100.0 * (value / rows[0][1] - 1.0):+.2f} %"
        lines.append("%-28s%12.5g%s" % (method, value, off))
    return lines


def compare_releases(path, name, output, run):
    """Runs a scene, and the same with a shorter and a longer crack; run(study): outcomes of its runs; output: the table to write.
    Returns the lines to print; None where a run failed."""
    refuse_others(path)
    potential = potential_of(path)
    present = run(study_of_extension(path, [{}]))
    summaries = [read_summary(o.folder) for o in present if o.good]
    if not summaries:
        return None
    extension = read_extension(path, name, summaries[0])
    others = run(study_of_extension(path, [{extension.path: text} for text in extension.texts]))
    if not all(o.good for o in others):
        return None
    shorter, longer = (read_summary(o.folder) for o in others)
    return write_release(name, rows_of(name, extension, [shorter, summaries[0], longer], potential), output)
