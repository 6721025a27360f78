"""Rows of a page with the largest and smallest values of a run, with where and when: those that the scene asks for (Measure > Extremes), and of a
run with heat the temperatures."""

import numpy as np

from rhegma.fields import read_fields, read_times
from rhegma.problem import Problem

from . import style
from .answers import is_number
from .report_facts import readable

UNITS = {"Principal Stress": "Pa", "Von Mises Stress": "Pa", "Energy Density": "J/m³", "Damage": "", "Speed": "m/s", "Displacement": "m", "Temperature": "K"}
HEAD = ("quantity", "value", "time", "position")
SAME_TIME = 1.0e-6  # of a time: two outputs of it
SAID = ("peak temperature ", "lowest temperature ", "largest difference of temperature ")  # how lines of the program begin that these rows replace


def value_text(value, unit):
    """A value with its unit. Temperatures have no prefix and the digits that differences of a tenth of a kelvin need."""
    return f"{value:.5g} K" if unit == "K" else readable(value, unit) if unit else f"{value:.4g}"


def time_text(time):
    return "-" if time is None else readable(float(time), "s")


def position_text(position):
    """A position [m] as text; "-" where it is not known."""
    if position is None or not len(position) or not all(is_number(float(x)) for x in position):
        return "-"
    factor, unit = style.scale(max(abs(float(x)) for x in position), "m")
    return f"({', '.join(f'{round(float(x) * factor, 3) + 0.0:.4g}' for x in position)}) {unit}"


def place(history, column, k):
    """The position [m] that columns of a history give for sample k, or None."""
    found = [history.column[f"{column}_{axis}"][k] for axis in "xyz" if f"{column}_{axis}" in history.column]
    return found or None


def peak(samples, sign):
    """The number of the sample with the largest (sign 1) or smallest (-1) value, or None where there is no number."""
    known = np.isfinite(samples)
    return int(np.argmax(np.where(known, sign * samples, -np.inf))) if known.any() else None


def asked_rows(name, entry, history):
    """Rows of an extreme of the scene: over all samples, or those of the end without a history."""
    unit, rows = UNITS.get(entry.get("field"), ""), []
    field = str(entry.get("field") or "value")
    for which, sign in (("largest", 1.0), ("smallest", -1.0)):
        samples = None if history is None else history.column.get(f"{name}.{which}")
        k = None if samples is None else peak(samples, sign)
        title = f"{name}: {which} {field if field.startswith('Von') else field.lower()}"
        if k is not None:
            rows.append((title, value_text(samples[k], unit), time_text(history.time[k]), position_text(place(history, f"{name}.{which}", k))))
        elif is_number(entry.get(which)):
            rows.append((title, value_text(entry[which], unit), "end", position_text(entry.get(f"{which}_position"))))
    return rows


def place_in_frame(folder, time, pick):
    """Where the temperature of a frame of this time is extreme; None where the run wrote no such frame. pick: np.argmax or np.argmin"""
    try:
        if not any(abs(one - time) <= SAME_TIME * abs(time) for one in read_times(folder)):
            return None
        fields = read_fields(folder, time)
    except Problem:
        return None  # the page names it
    if fields is None or fields.temperature is None:
        return None
    return fields.position[pick(fields.temperature)][:fields.dimension]


def recorded_row(summary, key, title):
    """The row of an extreme temperature that the summary has with its time, and its position or body, also between samples; None where it has none.
    key: of the entry of temperatures"""
    found = (summary.get("temperature") or {}).get(key)
    if not isinstance(found, dict) or not is_number(found.get("value")) or not is_number(found.get("time")):
        return None
    place = found["body"] if isinstance(found.get("body"), str) else position_text(found.get("where"))
    return (title, value_text(found["value"], "K"), time_text(found["time"]), place)


def temperature_rows(summary, history, folder, known):
    """Rows of the temperatures of all particles: the largest, the smallest, and the largest difference at one time, in a body where the summary has it,
    else of all. known: an extreme of the scene has the first two"""
    high, low = history.column.get("temperature_highest"), history.column.get("temperature_lowest")
    if high is None or low is None:
        return []
    rows = []
    for which, key, samples, sign, pick in () if known else (("largest", "highest", high, 1.0, np.argmax), ("smallest", "coldest", low, -1.0, np.argmin)):
        k, recorded = peak(samples, sign), recorded_row(summary, key, f"{which} temperature")
        if recorded:
            rows.append(recorded)
        elif k is not None:
            time = float(history.time[k])
            rows.append((f"{which} temperature", value_text(samples[k], "K"), time_text(time), position_text(place_in_frame(folder, time, pick))))
    k, recorded = peak(high - low, 1.0), recorded_row(summary, "largest_difference", "largest difference of temperature in a body at one time")
    if recorded:
        rows.append(recorded)
    elif k is not None:
        rows.append(("largest difference of temperature at one time", value_text(high[k] - low[k], "K"), time_text(history.time[k]), "-"))
    return rows


def extreme_rows(summary, history, folder):
    """Rows (quantity, value, time, position) of a run; empty where it has none. folder: of its fields"""
    asked = summary.get("extremes") or {}
    asked = {name: entry for name, entry in asked.items() if isinstance(entry, dict)} if isinstance(asked, dict) else {}
    rows = [row for name, entry in asked.items() for row in asked_rows(name, entry, history)]
    known = any(entry.get("field") == "Temperature" for entry in asked.values())
    return rows + ([] if history is None else temperature_rows(summary, history, folder, known))


def answers_without_peak(summary, rows):
    """The answers of the program, without its lines of extreme temperatures where the rows have them."""
    lines = summary.get("answers") or []
    there = any("temperature" in row[0] for row in rows)
    return [line for line in lines if not (there and str(line).startswith(SAID))]
