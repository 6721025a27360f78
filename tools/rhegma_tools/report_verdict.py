"""Whether a crack of a run has grown, as a line of text."""

import math

import numpy as np

from . import style
from .answers import is_number
from .growth_panels import areas, first_growth, grown_in_equilibrium, growth
from .inner_nodes import inner_mean, leaves_out
from .reached_toughness import not_stopped, when_reached
from .report_facts import all_fronts, grown_by, largest_release, readable, short
from .verdict_details import force_text, intensity_text, shear_text
from .whole_folder import went_to_its_end

NAMED = 4  # fronts named in a line
UNKNOWN = 0.05  # error of loads that has to be expected where a run has no estimate
EARLY = " up to the time at which the run ended early"
HOOP = 0.995  # load by the largest hoop stress over that by G, below which the program names both


def name_of(entry):
    return f"{entry[0]}, front {entry[1]}"


def listed(entries):
    """Names of the first fronts, and the number of the others."""
    more = f" and {len(entries) - NAMED} more" if len(entries) > NAMED else ""
    return "; ".join(name_of(entry) for entry in entries[:NAMED]) + more


def where_to(front):
    """Where a front in 2D is at the end, as text."""
    position = front.get("position") or []
    if len(position) != 2 or not all(is_number(x) for x in position):
        return ""
    largest = max(abs(x) for x in position) or 1.0
    factor, unit = style.scale(largest, "m")
    # All with the last digit of the largest: what is smaller is rounding.
    decimals = 3 - math.floor(math.log10(largest * factor))
    return f" to ({', '.join(f'{round(x * factor, decimals) + 0.0:.4g}' for x in position)}) {unit}"


def how_fast(front):
    """The mean speed of a front that ran and that at the end, as text."""
    mean, last = front.get("mean_speed"), front.get("speed")
    text = f", on average at {readable(mean, 'm/s')}" if is_number(mean) else ""
    if not (front.get("running") and is_number(last)):
        return text
    return text + f"{' and' if text else ','} at {readable(last, 'm/s')} at the end"


def arrived(front):
    """What a front came to, such as the surface of its body, as text."""
    arrival = front.get("arrival") or {}
    if not arrival.get("what"):
        return ""
    at = f" at t = {readable(arrival['time'], 's')}" if is_number(arrival.get("time")) else ""
    return f", and it {arrival['what']}{at}"


def motion_from(summary):
    """The time at which an analysis of equilibrium went on as motion; None where it did not."""
    found = (summary.get("propagation") or {}).get("motion_from")
    return found["time"] if isinstance(found, dict) and is_number(found.get("time")) else None


def held(entry, summary):
    """What kept a front at rest although G had reached its toughness, as text; empty where nothing did."""
    start, began = (summary.get("propagation") or {}).get("start_time"), entry.get("start_release")
    time = readable(start, "s") if is_number(start) else ""
    if entry.get("held_until_start_time"):
        at = f": it started at {short(began, 3)} times the initiation toughness" if is_number(began) else ""
        return f", held by Propagation > Start Time{f' until {time}' if time else ''}{at}"
    early = entry.get("release_before_start_time")
    if not is_number(early) or early < 1.0:
        return ""
    return f" (before Propagation > Start Time{f' = {time}' if time else ''} G had reached {short(early, 3)} times the initiation toughness)"


def since(entry, summary, first):
    """From when on a front grew, as text. first: whether this front is the first"""
    motion = motion_from(summary)
    if "equilibrium" not in summary or (motion is not None and entry["initiated"] >= motion):
        return f" from t = {readable(entry['initiated'], 's')} on{how_fast(entry)}"
    start = (summary.get("propagation") or {}).get("initiation") or {}
    if not first or not is_number(start.get("time")):
        return f" from the load step to t = {readable(entry['initiated'], 's')} on"
    known = is_number(start.get("from")) and is_number(start.get("to"))
    step = f" (in the load step from {readable(start['from'], 's')} to {readable(start['to'], 's')})" if known else ""
    return f" from about t = {readable(start['time'], 's')} on{step}"


def unstable(summary):
    """From when on growth under given loads in equilibrium is unstable, as text; empty where it is not."""
    found = (summary.get("propagation") or {}).get("unstable_from")
    if "equilibrium" not in summary or not isinstance(found, dict) or "load_factor" in found or not is_number(found.get("time")):
        return ""
    if motion_from(summary) is not None:
        return f" The growth is unstable from t = {readable(motion_from(summary), 's')} on; from there on the run is dynamic."
    return (f" The growth is unstable from the load step to t = {readable(found['time'], 's')} on: G rises as the crack grows under the same loads, "
            "so in a real body it runs.")


def growth_of(grown, count, summary=None):
    """By how much fronts grew and from when on. grown: [(crack, number, entry)]; count: of all fronts; summary: None where times say nothing"""
    grown = sorted(grown, key=lambda entry: entry[2]["initiated"])
    texts = []
    for entry in grown[:NAMED]:
        length = grown_by(entry[2])
        text = f"{name_of(entry)}, grew" + ("" if length is None else f" by {readable(length, 'm')}") + where_to(entry[2])
        texts.append(text if summary is None else text + since(entry[2], summary, entry is grown[0]) + held(entry[2], summary) + arrived(entry[2]))
    more = f"; {len(grown) - NAMED} more" if len(grown) > NAMED else ""
    return "; ".join(texts) + more + (f" ({len(grown)} of {count} fronts grew)" if count > 1 else "")


def has_larger_node(front):
    """Whether a front is one in 3D, of which the node with the largest G is compared with the toughness, not the mean."""
    return is_number(front.get("G_J")) and is_number(front.get("G_J_max")) and front["G_J_max"] > front["G_J"]


def relative_error(front):
    """Estimated relative error of the G of a front that is compared with the toughness, in 3D of its largest node; None where not known."""
    if has_larger_node(front) and is_number(front.get("G_J_extremes_error_estimate")) and front["G_J_max"] > 0.0:
        return front["G_J_extremes_error_estimate"] / front["G_J_max"]
    if is_number(front.get("G_J_error_estimate")) and is_number(front.get("G_J")) and front["G_J"] > 0.0:
        return front["G_J_error_estimate"] / front["G_J"]
    return None


def factor_error(fronts, grown):
    """Estimated relative error of the factor at which cracks start: half of that of G of the front that starts, as the load is proportional to
    1 / sqrt(G); None where not known."""
    first = min(grown, key=lambda entry: entry[2]["initiated"], default=None)
    first = first or max(fronts, key=lambda entry: entry[2]["G_J"] if is_number(entry[2].get("G_J")) else 0.0, default=None)
    error = None if first is None else relative_error(first[2])
    return None if error is None else 0.5 * error


def of_load_factor(fronts, start, grown):
    """start: factor on the loads at which G first reaches the toughness"""
    hoop = min((front["hoop_stress_factor"] for _, _, front in fronts if is_number(front.get("hoop_stress_factor"))), default=start)
    factor, how = (hoop, f" by the largest hoop stress ({short(start)} by G of a straight extension)") if hoop < HOOP * start else (start, "")
    error = factor_error(fronts, grown)
    near = abs(factor - 1.0) <= (UNKNOWN if error is None else error) * factor
    why = f"near 1, and its error is not known (less than {100.0 * UNKNOWN:g} % counts as near)" if error is None else "1 within its error"
    decided = f"Not certain, as the factor is {why}" if near else "Yes" if factor < 1.0 else "No"
    estimate = "" if error is None else f" ± {100.0 * error:.2g} %"
    followed = f" The run then followed the growth: {growth_of(grown, len(fronts))}." if grown else ""
    return f"{decided}, at the given loads: cracks start at {short(factor)}{estimate} times these loads{how}.{followed}"


def load_reached(front):
    """The largest part of the load of growth that a front has had, by G or by the largest hoop stress."""
    parts = front.get("closest_to_initiation"), front.get("closest_by_hoop_stress")
    return max(max(parts[0], 0.0) ** 0.5 if is_number(parts[0]) else 0.0, parts[1] if is_number(parts[1]) else 0.0)


def of_no_growth(summary, fronts):
    """Of a scene with a toughness in which no front grew."""
    until = "" if went_to_its_end(summary) else EARLY
    release = [front["closest_to_initiation"] for _, _, front in fronts if is_number(front.get("closest_to_initiation"))]
    hoop = [front["closest_by_hoop_stress"] for _, _, front in fronts if is_number(front.get("closest_by_hoop_stress"))]
    if max(hoop, default=0.0) >= 1.0:
        return (f"By the largest hoop stress yes, by G no: K of the largest hoop stress reached {short(max(hoop), 3)} times the toughness, G at most "
                f"{short(max(release, default=0.0), 3)} of it. With shear the crack starts at the lower of both loads.")
    reached = f"; G reached at most {max(release):.3g} of the initiation toughness" if release else ""
    reached += intensity_text(summary.get("propagation"), max(release, default=None))
    if max(hoop, default=0.0) * HOOP > max([0.0, *release]) ** 0.5:
        reached += f", and K of the largest hoop stress {max(hoop):.3g} of that of the toughness"
    for _, _, front in fronts:
        error, loads = relative_error(front), load_reached(front)
        if error is not None and loads * (1.0 + 0.5 * error) >= 1.0:
            return f"Not certain{until}: no front grew{reached}, and the estimated error of G is {100.0 * error:.2g} %."
        if error is None and loads >= 1.0 - UNKNOWN:
            return (f"Not certain{until}: no front grew{reached}, and the error of G is not known (less than {100.0 * UNKNOWN:g} % of the load counts "
                    "as near).")
    return f"No{until}: no front grew{reached}."


def unusable(entry):
    """Of a front whose G is negative, as no crack has it."""
    return (f"Not decided: the energy release rate of {name_of(entry)} is {readable(largest_release(entry[2]), 'J/m²')}, but no crack has a negative one. "
            "It can't be used; the warnings say what to change.")


def at_surface(start, fronts, below):
    """Which nodes are compared with the toughness where those near the surface are left out, and what these say where they are closer to growth.
    below: the inner nodes are below the toughness"""
    if not any(leaves_out(front) for _, _, front in fronts):
        return ""
    inside = max((front["closest_to_initiation"] for _, _, front in fronts if is_number(front.get("closest_to_initiation"))), default=0.0)
    surface = max((front["closest_at_surface"] for _, _, front in fronts if is_number(front.get("closest_at_surface"))), default=0.0)
    text = " Inner nodes are two cells or more from the surface; at the others G depends on the cells"
    if surface <= inside / HOOP**2:
        return text + (f": they reached {short(surface)}." if surface > 0.0 else ".")
    text += f": they reached {short(surface)}"
    return text + ("; by them the crack grows: smaller cells decide." if below and surface >= 1.0 else ".")


def start_at(start, estimate):
    """A sentence on the factor of the loads at which cracks start. Where nodes at the surface give a lower one, both: the truth lies between them."""
    inner, surface = start["load_factor"], start.get("load_factor_at_surface")
    of_scene = "times the loads and prescribed displacements of the scene"
    if not (is_number(surface) and surface < HOOP * inner):
        return f"Cracks start at {short(inner)}{estimate} {of_scene}."
    return (f"Cracks start between {short(surface)} and {short(inner)}{estimate} {of_scene}: by nodes at the surface, where G depends on the cells, and by inner "
            "nodes.")


def what_reached(entry, toughness):
    """(what is compared with the toughness, its mean over the same nodes as text) of a front: its largest node in 3D, of the inner ones where those
    near the surface are left out."""
    front = entry[2]
    if not (has_larger_node(front) and is_number(toughness) and toughness > 0.0):
        return f"G of {name_of(entry)}", ""
    if leaves_out(front):
        mean = inner_mean(front, toughness)
        return f"the largest G of the inner nodes of {name_of(entry)}", "" if mean is None else f", and their mean {short(mean / toughness)}"
    at_end = abs(front["G_J_max"] / toughness - front["closest_to_initiation"]) <= 1e-3 * front["closest_to_initiation"]  # the mean is only known there
    return f"the largest G along {name_of(entry)}", f", and the mean along it {short(front['G_J'] / toughness)}" if at_end else ""


def of_comparison(summary, fronts, history=None):
    """Of a scene with a toughness with which G is compared, in which no front can grow. history: to say when G reached it, or None"""
    start = summary["start_of_growth"]
    first = max(fronts, key=lambda entry: entry[2]["closest_to_initiation"] if is_number(entry[2].get("closest_to_initiation")) else -1.0)
    release, error = first[2].get("closest_to_initiation"), relative_error(first[2])
    if not is_number(release):
        return "Not decided: no energy release rate is known."
    if release <= 0.0 and is_number(first[2].get("G_J")) and first[2]["G_J"] < 0.0:
        return unusable(first)
    hoop = max((front["closest_by_hoop_stress"] for _, _, front in fronts if is_number(front.get("closest_by_hoop_stress"))), default=0.0)
    reached = max(release ** 0.5, hoop)  # of the load
    wide = UNKNOWN if error is None else 0.5 * error
    surface = max((front["closest_at_surface"] for _, _, front in fronts if leaves_out(front) and is_number(front.get("closest_at_surface"))), default=0.0)
    near = abs(reached - 1.0) <= wide * max(reached, 1.0) or (reached < 1.0 <= surface)
    decided = "Not certain" if near else "Yes" if reached > 1.0 else "No"
    how = f", and K of the largest hoop stress {short(hoop)} of that of the toughness" if hoop * HOOP > release ** 0.5 else ""
    toughness = start["toughness"]
    what, mean = what_reached(first, toughness)
    early = not went_to_its_end(summary)
    decided += EARLY if early else ""
    text = f"{decided}: {what} reached {short(release)} of the toughness of {readable(toughness, 'J/m²')}{intensity_text(start, release)}{mean}{how}."
    text += when_reached(history, first, toughness) if release >= 1.0 else ""
    if is_number(start.get("load_factor")):
        estimate = "" if error is None else f" ± {50.0 * error:.2g} %"
        text += f" {start_at(start, estimate)}"
    text += force_text(summary, start.get("load_factor")) + shear_text(first[2])
    return text + at_surface(start, fronts, reached < 1.0)


def of_no_toughness(fronts):
    known = [entry for entry in fronts if largest_release(entry[2]) is not None]
    if not known:
        return "Not decided: the scene computes no energy release rate (section Energy Release)."
    most = max(known, key=lambda entry: largest_release(entry[2]))
    largest, last = largest_release(most[2]), most[2].get("G_J")
    error = most[2].get("G_J_error_estimate")
    if largest <= 0.0:
        return unusable(most)
    at_end = ""
    if is_number(last):
        estimate = f" ± {100.0 * error / last:.2g} %" if is_number(error) and last > 0.0 else ""
        at_end = f"{readable(last, 'J/m²')}{estimate} at the end"
        most_along = most[2].get("G_J_max")  # in 3D, where a front starts first
        if is_number(most_along) and most_along > last:
            at_end = f"{readable(last, 'J/m²')}{estimate} in the mean along the front and {readable(most_along, 'J/m²')} at most, at the end"
    peak = f"{', ' if at_end else ''}{readable(largest, 'J/m²')} at most" if not is_number(last) or largest > last else ""
    return ("Not decided: the scene has no toughness. A crack runs if its toughness is below G. The largest is that of "
            f"{name_of(most)}: G = {at_end}{peak}. With Energy Release > Toughness (or Toughness From Library) a run decides.")


def verdict(summary, history=None):
    """Whether a crack has run; None where the scene has no crack. history: of the run, to say when G reached a toughness, or None"""
    fronts = all_fronts(summary)
    if not fronts:
        return None
    grown = [entry for entry in fronts if is_number(entry[2].get("initiated"))]
    start = ((summary.get("propagation") or {}).get("initiation") or {}).get("load_factor")
    if is_number(start):
        text = of_load_factor(fronts, start, grown) + force_text(summary)
    elif "start_of_growth" in summary:
        text = of_comparison(summary, fronts, history)
    elif grown:
        text = f"Yes: {growth_of(grown, len(fronts), summary)}.{unstable(summary)}{not_stopped(summary, grown)}"
    elif "propagation" in summary:
        most = max((front for _, _, front in fronts), key=lambda front: largest_release(front) or 0.0)
        text = of_no_growth(summary, fronts) + shear_text(most)
    else:
        text = of_no_toughness(fronts)
    crossed = [str(crack.get("name")) for crack in summary.get("cracks") or [] if isinstance(crack, dict) and crack.get("faces_overlap") is True]
    if crossed and not text.startswith("Not decided"):
        text = f"Not certain: the faces of {', '.join(crossed[:NAMED])} overlap, so that G and K are wrong; see the warnings. Without regard to that: {text}"
    stopped = [entry for entry in fronts if entry[2].get("stopped")]
    return text + (f" Stopped for a numerical reason, not by the material: {listed(stopped)}." if stopped else "")


def so_far(history):
    """Of a run without a summary: which fronts have grown up to the last sample; None where the history has no fronts."""
    if not history.fronts:
        return None
    moved, resting = growth(history), grown_in_equilibrium(history)
    time = readable(float(history.time[-1]), "s")
    if moved and "load_factor" in history.column:  # it starts with the load at which cracks start
        return f"Up to the last sample: {of_load_factor([], float(history.column['load_factor'][0]), [])}"
    if first_growth(history) and not moved:
        return of_samples(history, resting, time)
    if not moved and all(history.of_front(front, "stopped") is None for front in history.fronts):  # a column of Propagation alone
        return f"Not decided up to t = {time}, the last sample: the scene has no toughness (section Propagation); compare G with it."
    if not moved:
        return f"Not up to t = {time}, the last sample: no front has grown."
    return of_samples(history, moved, time)


def of_samples(history, moved, time):
    """The growth of fronts up to the last sample, at a time in words."""
    larger = [(name, finite(area)) for name, area in areas(history, moved)]
    texts = [f"{name}, new area {short(float(area[-1]) * 1e6)} mm²" for name, area in larger if area.size]
    texts = texts or [f"{name_of(front)}, crack extension {readable(float(finite(samples)[-1]), 'm')}" for front, samples in moved if finite(samples).size]
    texts = texts or [f"{readable(float(finite(history.column['fracture'])[-1]), 'J')} of fracture energy of new crack faces"]
    more = f"; {len(texts) - NAMED} more" if len(texts) > NAMED else ""
    seen = first_growth(history)
    start = "" if seen is None else f" Growth is first seen at t = {readable(seen[1], 's')}" + (
        "." if seen[0] is None else f"; at t = {readable(seen[0], 's')} there was none.")
    return f"Yes, up to t = {time}, the last sample: {'; '.join(texts[:NAMED])}{more}.{start}"


def finite(samples):
    """The samples that are numbers; all of a run that lost a row may be none."""
    return samples[np.isfinite(samples)]
