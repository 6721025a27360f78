"""What a run answers, as rhegma --twice compares it: G and K of fronts at rest, loads that start cracks, and reference values."""

import math

from rhegma.problem import Problem
from rhegma.summary import look_up

RELEASES = ("G_J", "G_closure")
MODES = ("K_I", "K_II", "K_III")
SMALL = 0.02  # a stress intensity below this fraction of the largest of its front is as good as zero

COOLED = 0.02  # rise over fall up to which bodies are only cooled, as the program has it


class Answer:
    """value: a number; reference: what it should be, or None."""

    def __init__(self, unit, value, reference=None):
        self.unit = unit
        self.value = value
        self.reference = reference


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def at_rest(front):
    return not (front.get("ended") or front.get("stopped") or is_number(front.get("initiated")))


def of_front(name, front):
    """G, and the stress intensities that are not as good as zero."""
    found = {f"{key} of {name}": Answer("J/m2", front[key]) for key in RELEASES if is_number(front.get(key))}
    largest = max((abs(front[mode]) for mode in MODES if is_number(front.get(mode))), default=0.0)
    for mode in MODES:
        if is_number(front.get(mode)) and abs(front[mode]) >= SMALL * largest and front[mode] != 0.0:
            found[f"{mode} of {name}"] = Answer("Pa sqrt(m)", front[mode])
    return found


def answers_of(summary, quantities=(), references=()):
    """{name: Answer} of a summary, and of paths in it with their references. A reference value of the scene that is one of the
    other answers is entered there."""
    found = {}
    for crack in summary.get("cracks") or []:
        for number, front in enumerate(crack.get("fronts") or []):
            if isinstance(front, dict) and at_rest(front):
                found.update(of_front(f"{crack.get('name')}.{number}", front))
    initiation = (summary.get("propagation") or {}).get("initiation") or {}
    if is_number(initiation.get("load_factor")):
        found["load factor at initiation"] = Answer("", initiation["load_factor"])
    temperature = summary.get("temperature") or {}
    rise, fall = temperature.get("peak_rise"), temperature.get("largest_fall")
    if is_number(rise) and is_number(fall) and rise <= COOLED * fall:
        found["largest fall of temperature"] = Answer("K", fall)
    elif is_number(rise):
        found["peak rise of temperature"] = Answer("K", rise)
    for entry in summary.get("references") or []:
        enter(found, f"Reference > {entry.get('name')}", entry.get("value"), entry.get("reference"))
    for quantity, reference in zip(quantities, references):
        try:
            enter(found, quantity, look_up(summary, quantity), reference)
        except Problem:  # the study has said so
            continue
    return found


def enter(found, name, value, reference):
    """A value with a reference: of an answer that is there, or one of its own."""
    if not is_number(value):
        return
    known = is_number(reference) and reference != 0.0
    for answer in found.values():
        if answer.value == value:
            answer.reference = reference if known and answer.reference is None else answer.reference
            return
    if known:
        found[name] = Answer("", value, reference)
