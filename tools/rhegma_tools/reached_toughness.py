"""When G of a crack that can't grow reached the toughness, and of one that has grown in equilibrium whether G exceeds it at the end."""

import numpy as np

from .answers import is_number
from .report_facts import readable, short

ONLY = " That is at t = {}, the only time that was computed."
STILL = 1.02  # G at the end over the toughness: what is less is the accuracy of G


def largest_along(history, entry):
    """(samples (n), what they are) of G of a front: in 3D the largest of all its nodes; (None, "") where the history has none."""
    front = (entry[0], entry[1])
    most, mean = history.of_front(front, "G_J_max"), history.of_front(front, "G_J")
    return (mean, "G") if most is None else (most, "the largest G of all its nodes")


def as_recorded(history, time):
    """When G reached the toughness [s] by the summary, which leaves nodes at the surface out, as a sentence. history: None where there is none"""
    times = np.zeros(0) if history is None else np.asarray(history.time, dtype=float)
    if len(times) == 1 and time == times[0]:
        return ONLY.format(readable(time, "s"))
    if len(times) and time <= times[0]:
        return f" It exceeded it at the first sample, at t = {readable(time, 's')}, already."
    k = int(np.searchsorted(times, time))
    around = f" (between the samples at {readable(float(times[k - 1]), 's')} and {readable(float(times[k]), 's')})" if 0 < k < len(times) else ""
    return f" It reached it at about t = {readable(time, 's')}{around}."


def when_reached(history, entry, toughness):
    """When G of a front first reached the toughness, as a sentence; empty where neither the summary nor the history can say it. G is in proportion to the
    square of loads, so its root is interpolated between samples."""
    if is_number(entry[2].get("time_of_toughness")):
        return as_recorded(history, entry[2]["time_of_toughness"])
    samples, what = (None, "") if history is None else largest_along(history, entry)
    if samples is None or not is_number(toughness) or toughness <= 0.0:
        return ""
    above = np.flatnonzero(np.nan_to_num(samples, nan=-1.0) >= toughness)
    if not above.size:
        return ""
    k = int(above[0])
    time = float(history.time[k])
    if len(history.time) == 1:
        return ONLY.format(readable(time, "s"))
    whose = f"{what[0].upper()}{what[1:]}"
    if k == 0 or not np.isfinite(samples[k - 1]):
        return f" {whose} exceeded it at the first sample, at t = {readable(time, 's')}, already."
    before = float(history.time[k - 1])
    roots = np.sqrt(np.maximum(samples[[k - 1, k]], 0.0))
    at = before + (time - before) * (toughness**0.5 - roots[0]) / (roots[1] - roots[0])
    return f" {whose} reached it at about t = {readable(float(at), 's')} (between the samples at {readable(before, 's')} and {readable(time, 's')})."


def at_end(front):
    """G at the end [J/m2] with which a front is compared: of its largest node in 3D; None where it has none or has ended."""
    release = front.get("G_J_max") if is_number(front.get("G_J_max")) else front.get("G_J")
    return release if is_number(release) and not front.get("ended") and not front.get("stopped") else None


def not_stopped(summary, grown):
    """Of growth under given loads in equilibrium: which fronts have G above the toughness at the end, as a sentence; empty where none has."""
    propagation = summary.get("propagation") or {}
    toughness = propagation.get("initiation_toughness")
    if "equilibrium" not in summary or "motion_from" in propagation or not is_number(toughness) or toughness <= 0.0:
        return ""
    known = [(entry, at_end(entry[2])) for entry in grown]
    above = [(entry, release) for entry, release in known if release is not None and release > STILL * toughness]
    if not above:
        return ""
    (name, number, front), release = max(above, key=lambda pair: pair[1])
    node = "the largest G along" if is_number(front.get("G_J_max")) else "G of"
    others = f" ({len(above)} fronts exceed it)" if len(above) > 1 else ""
    return (f" The crack has not stopped: at the end of the run {node} {name}, front {number} is {short(release / toughness)} times the initiation toughness of "
            f"{readable(toughness, 'J/m²')}{others}, so its growth is a lower bound.")
