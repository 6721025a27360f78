"""What a page of a run states of it: how it was run, what it answers, and how certain that is."""

import os

from . import style
from .answers import is_number

SHORT = 6  # digits of a number without a known unit
STATIC = 1e-3  # change of energy release rates that is still to come, of a run that counts as static

# Lists and objects of a summary that the page uses: [shape of each entry] and {name: shape}.
FRONT = {"runs": [{}], "position": [], "stop": {"node_positions": []}, "arrival": {}, "front_nodes": {}}
SHAPE = {"cracks": [{"fronts": [FRONT]}], "energy": {}, "energy_balance": {}, "forces_at_start": {}, "cells": {}, "propagation": {"initiation": {}}, "equilibrium": {}, "references": [{}],
         "warnings": [], "answers": [], "effects": []}


def sound(value, shape, where, problems):
    """A value with lists and objects where they are expected; others are left out and added to the problems. where: its name"""
    if not isinstance(value, type(shape)):
        problems.append(f"{where} is not what a run writes, and is left out.")
        return type(shape)()
    if isinstance(shape, list):
        return [sound(entry, shape[0], f"{where} > {i}", problems) for i, entry in enumerate(value)] if shape else value
    inner = {name: sound(value[name], one, f"{where} > {name}", problems) for name, one in shape.items() if value.get(name) is not None}
    return dict(value, **inner)


def short(value, digits=4):
    """A number with so many digits, without an exponent where it is a few digits long."""
    return f"{value:.0f}" if 10.0 ** digits <= abs(value) < 1e6 else f"{value:.{digits}g}"


def readable(value, unit, digits=4):
    """A number with its unit, scaled by a prefix. unit: with room for a prefix; the root of a length follows it"""
    if not is_number(value):
        return "-"
    factor, scaled = style.scale(abs(value), unit.replace(" √m", ""))
    tail = " √m" if unit.endswith("√m") else ""
    return f"{short(value * factor, digits)} {scaled}{tail}".strip()


def duration(seconds):
    """Wall time in words."""
    if seconds < 120.0:
        return f"{seconds:.3g} s"
    minutes = round(seconds / 60.0)
    return f"{minutes} min" if minutes < 120 else f"{minutes // 60} h {minutes % 60} min"


def scene_name(summary, folder):
    """The name of the scene, without folder and ending; that of the folder where the summary has none."""
    scene = (summary or {}).get("scene") or os.path.basename(os.path.realpath(folder))
    return os.path.splitext(os.path.basename(str(scene)))[0]


def analysis_of(summary):
    """Whether motion or equilibria were computed."""
    steps = (summary.get("equilibrium") or {}).get("load_steps")
    if "equilibrium" not in summary:
        return "dynamic"
    found = f"equilibrium, {steps} load step{'' if steps == 1 else 's'}" if steps else "equilibrium"
    return found + (", load factor" if is_number((summary.get("propagation") or {}).get("load_factor")) else "")


def cells_of(summary):
    cells = summary.get("cells") or {}
    largest, smallest = cells.get("largest"), cells.get("smallest")
    if not is_number(largest):
        return None
    changes = "Adaptivity" in (summary.get("effects") or []) and "equilibrium" not in summary
    same = not is_number(smallest) or smallest >= largest * (1 - 1e-9)
    return readable(largest, "m") + ("" if same else f", refined to {readable(smallest, 'm')}") + (" at the end" if changes else "")


def run_facts(summary, dimension):
    """[(name, text)] of what was run. dimension: 2, 3 or None where it is not known"""
    facts = [("Scene", summary.get("scene")), ("Analysis", analysis_of(summary) if "status" in summary else None),
             ("Dimension", None if dimension is None else f"{dimension}D"), ("Cells", cells_of(summary))]
    for name, key in (("Particles", "particles"), ("Steps", "steps")):
        facts.append((name, f"{summary[key]:,}".replace(",", " ") if is_number(summary.get(key)) else None))
    if is_number(summary.get("time")):
        facts.append(("Simulated time", readable(summary["time"], "s")))
    if is_number(summary.get("wall_seconds")):
        facts.append(("Wall time", duration(summary["wall_seconds"])))
    ranks, threads = summary.get("ranks"), summary.get("threads")
    if is_number(ranks) and is_number(threads):
        facts.append(("Run on", f"{ranks} rank{'' if ranks == 1 else 's'}, {threads} thread{'' if threads == 1 else 's'}, "
                                f"{summary.get('backend', '')}".rstrip(", ")))
    facts.append(("Effects", ", ".join(map(str, summary.get("effects") or [])) or None))
    facts.append(("Version", summary.get("version")))
    return [(name, text) for name, text in facts if text]


def all_fronts(summary):
    """[(crack, front's number, its entry)]"""
    return [(str(crack.get("name", i)), j, front) for i, crack in enumerate(summary.get("cracks") or [])
            for j, front in enumerate(crack.get("fronts") or []) if isinstance(front, dict)]


def largest_release(front):
    """The largest G of all samples of a front; where the summary has none, the last one."""
    values = [front.get(key) for key in ("largest_G_J", "G_J")]
    return max((value for value in values if is_number(value)), default=None)


def grown_by(front):
    """Extension of a front [m]: of its runs in 2D, on average along it in 3D; None where it has not grown."""
    if is_number(front.get("mean_advance")):
        return front["mean_advance"]
    lengths = [run.get("length") for run in front.get("runs") or []]
    return sum(lengths) if lengths and all(is_number(length) for length in lengths) else None


def residual_line(summary, residual, supplied):
    """The error of the energy balance with the digits and the basis of the terminal, from the numbers of the summary. supplied: the largest energy
    supplied [J], for runs of older versions"""
    balance = summary.get("energy_balance") or {}
    fraction, basis = balance.get("fraction"), balance.get("compared_with")
    if is_number(fraction) and isinstance(basis, str):
        supply = f" {readable(balance['energy'], 'J')}" if basis.startswith("energy supplied") and is_number(balance.get("energy")) else ""
        return f"{readable(residual, 'J')} ({100 * fraction:.4g} % of the {basis}{supply})"
    part = f" ({100 * abs(residual) / supplied:.4g} % of the energy supplied)" if is_number(supplied) and supplied > 0 else ""
    return readable(residual, "J") + part


def growth_line(summary):
    """How many increments fronts made, how far they came, and what that left open in the energy balance; None where none grew."""
    grown = [front for _, _, front in all_fronts(summary) if is_number(front.get("increments")) and front["increments"] > 0]
    if not grown:
        return None
    count = round(sum(front["increments"] for front in grown))
    lengths = [length for length in map(grown_by, grown) if length is not None]
    nodes = " of front nodes" if any("front_nodes" in front for front in grown) else ""
    text = f"{count} increment{'' if count == 1 else 's'}{nodes}"
    if lengths:
        text += f", extension {readable(max(lengths), 'm')}" + (" (the largest of the fronts)" if len(grown) > 1 else "")
    left = (summary.get("propagation") or {}).get("residual_fraction")
    if is_number(left):
        text += f"; residual {100 * abs(left):.3g} % of the fracture energy{' since cracks grew' if 'equilibrium' in summary else ''}"
    return text


def certainty(summary):
    """[(name, text)] of how certain the results are: estimated errors, the energy balance, and whether the bodies are at rest."""
    found = []
    errors = [front["G_J_error_estimate"] / abs(front["G_J"]) for _, _, front in all_fronts(summary)
              if is_number(front.get("G_J_error_estimate")) and is_number(front.get("G_J")) and front["G_J"]]
    reasons = {str(front["no_error_estimate"]) for _, _, front in all_fronts(summary) if front.get("no_error_estimate")}
    largest = [front["G_J_extremes_error_estimate"] / front["G_J_max"] for _, _, front in all_fronts(summary)
               if is_number(front.get("G_J_extremes_error_estimate")) and is_number(front.get("G_J_max")) and front["G_J_max"] > 0.0]
    if errors:
        nodes = f", of the largest G along a front at most {100 * max(largest):.2g} %" if largest else ""
        found.append(("Numerical error of G", f"estimated, at most {100 * max(errors):.2g} %{nodes} ({len(errors)} front{'' if len(errors) == 1 else 's'}). "
                                              "Nine of ten true errors should be less"))
    if reasons:
        found.append(("No estimate of errors", "; ".join(sorted(reasons)[:4]) + ". rhegma --twice shows how far results move with the cell size"))
    residual, supplied = (summary.get("energy") or {}).get("residual"), summary.get("largest_energy_supplied")
    if is_number(residual):
        found.append(("Error of the energy balance", residual_line(summary, residual, supplied)))
    if growth_line(summary):
        found.append(("Growth", growth_line(summary)))
    change = summary.get("may_still_change")
    moves = f"energy release rates may still change by at most {100 * change:.2g} %" if is_number(change) else ""
    if summary.get("ended_before_settled"):
        static = is_number(change) and change <= STATIC
        found.append(("Settled", "no: the run was to stop at rest and was not"
                      + (f" to within Settled Drift; {moves}" if static else "; its results are not static" + (f": {moves}" if moves else ""))))
    elif moves:
        found.append(("Settled", moves))
    return found


# Units by the beginnings of names in the summary, other than the numbers of components and front nodes.
UNITS = (
    ("J/m²", ("G_J", "G_closure", "settled_release", "largest_G_J", "initiation_toughness")), ("Pa √m", ("K_I",)),
    ("m/s", ("settled_speed", "mean_speed", "velocity")),
    ("s", ("time", "initiated", "last_advance", "first_touch")), ("m", ("length", "radius", "ligament")), ("m²", ("opening_area",)),
    ("m³", ("opening_volume", "volume")), ("K", ("rise", "peak_rise", "settled_peak_rise", "hottest_face")), ("N", ("force",)), ("N s", ("impulse",)),
    ("kg", ("burnt_mass",)), ("J", ("wall_heat", "strain", "kinetic", "friction", "fracture", "heat", "residual", "contact")), ("Pa", ("pressure",)),
)


def unit_of_quantity(quantity):
    """The unit of a path in the summary, with room for a prefix; empty where it is not known."""
    name = next((part for part in reversed(str(quantity).split(".")) if not part.isdigit()), "")
    return "" if name.endswith(("_fraction", "_share")) else next((unit for unit, names in UNITS if name.startswith(names)), "")


def reference_rows(summary):
    """Rows (name, result, reference, difference, tolerance, verdict, source) of the comparison with the section Reference."""
    rows = []
    for entry in summary.get("references") or []:
        unit = unit_of_quantity(entry.get("quantity"))
        error, tolerance, reference = entry.get("relative_error"), entry.get("tolerance"), entry.get("reference")
        relative = is_number(reference) and reference != 0.0

        def part(value):
            return "-" if not is_number(value) else f"{100 * value:.3g} %" if relative else f"{value:.3g}"

        within = entry.get("within")
        decided = "within" if within else "OUTSIDE" if within is not None else f"not compared: {entry.get('left_out', 'no value')}"
        rows.append((f"{entry.get('name') or ''} ({entry.get('quantity')})", readable(entry.get("value"), unit) if unit else number(entry.get("value")),
                     readable(reference, unit) if unit else number(reference), part(error), part(tolerance), decided, entry.get("source") or ""))
    return rows


def number(value):
    return f"{value:.{SHORT}g}" if is_number(value) else "-"


def twice_rows(twice):
    """Rows (result, as it is, half, extrapolated, verdict) of twice.json."""
    rows = []
    for entry in twice.get("answers") or []:
        limits = [entry[key] for key in ("extrapolated_order_2", "extrapolated") if is_number(entry.get(key))]
        unit = f" [{entry['unit']}]" if entry.get("unit") else ""
        values = [number(value) if is_number(value) else str(value if value is not None else "-") for value in (entry.get("as_is"), entry.get("half"))]
        rows.append((f"{entry.get('name')}{unit}", *values, " to ".join(f"{limit:.4g}" for limit in limits) or "-", str(entry.get("verdict", ""))))
    return rows


