"""Reads summary.json."""

from __future__ import annotations

import json
import os
from typing import Any

from .problem import Problem


def read_summary(folder: str, name: str = "summary.json") -> dict[str, Any] | None:
    """The summary of a run, or None where the run left none. name: of its file, or that of another file with one JSON object. A
    Problem where it can't be read"""
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        return None
    try:
        with open(path, encoding="utf-8") as file:
            summary = json.load(file)
    except (OSError, ValueError) as error:
        raise Problem(f"{path} can't be read ({error}); the run may have been cut off, so run the scene again.")
    if not isinstance(summary, dict):
        raise Problem(f"{path} is no summary of a run: it must hold one JSON object.")
    return summary


def stop_time(front: dict[str, Any]) -> float:
    """When a front of the summary, or the first of its nodes, was stopped for a numerical reason [s]."""
    return (front.get("stop") or {}).get("time", front.get("last_advance") or 0.0)


def stopped_part(front: dict[str, Any]) -> str:
    """"4 of 32 front nodes " of a stopped front of the summary; empty where it has one node."""
    stop = front.get("stop") or {}
    return f"{stop['nodes']} of {stop['of_nodes']} front nodes " if stop.get("of_nodes", 1) > 1 else ""


def look_up(summary: dict[str, Any], quantity: str) -> float:
    """The number at a path such as cracks.0.fronts.0.G_J; an entry of a list by index or by its name.

    NaN where the run wrote null, which stands for a number that is not finite. A Problem where there is no such entry or it is
    no number."""
    value: Any = summary
    done: list[str] = []
    for step in quantity.split("."):
        if isinstance(value, list):
            named = [entry for entry in value if isinstance(entry, dict) and entry.get("name") == step]
            if step.isdigit() and int(step) < len(value):
                value = value[int(step)]
            elif named:
                value = named[0]
            else:
                raise Problem(f"the summary has no {quantity}: {'.'.join(done)} has {len(value)} entries, not {step}.")
        elif isinstance(value, dict) and step in value:
            value = value[step]
        else:
            names = ", ".join(value) if isinstance(value, dict) else "one value"
            raise Problem(f"the summary has no {quantity}: {'.'.join(done) or 'it'} holds {names}.")
        done.append(step)
    if value is None:
        return float("nan")
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise Problem(f"{quantity} in the summary is no number.")
    return float(value)
