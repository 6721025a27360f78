"""Lengths as a scene may have them: numbers in metres, or with a unit."""

import re

METRES = {"": 1.0, "m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "µm": 1e-6}
NUMBER_AND_UNIT = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(\D*?)\s*")


def unit_of(text):
    """The unit of a number with one; empty for all else."""
    found = NUMBER_AND_UNIT.fullmatch(text)
    return found.group(2) if found else ""


def metres(text):
    """A length [m]; ValueError where it is none in a unit of METRES."""
    found = NUMBER_AND_UNIT.fullmatch(text)
    if found is None or found.group(2) not in METRES:
        return float(text)  # also nan and inf
    return float(found.group(1)) * METRES[found.group(2)]
