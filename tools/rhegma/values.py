"""Values of scenes: Python objects, and types and texts of Teuchos parameters."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Sequence, Union

from .problem import Problem


@dataclass(frozen=True)
class Quantity:
    """A number, a text or a sequence of numbers in a unit other than the SI unit, such as Quantity(2.0, "mm")."""

    value: Any
    unit: str

    def __post_init__(self) -> None:
        """A Problem where the unit is no text."""
        if not isinstance(self.unit, str):
            raise Problem(f'the unit {self.unit!r} of {self.value!r} is no text; write one such as "mm".')


Value = Union[bool, int, float, str, Sequence[float], Sequence[str], Quantity]


def split_array(text: str, where: str) -> list[str]:
    """The entries of "{a, b, {c, d}}"; braces nest. A Problem, which begins with `where`, if it is no such text."""
    text = text.strip()
    if not (text.startswith("{") and text.endswith("}")):
        raise Problem(f"{where}: an array is written in braces, such as {{0.1, 0.2}}, not {text}.")
    entries, depth, entry = [], 0, ""
    for letter in text[1:-1]:
        depth += {"{": 1, "}": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            entries.append(entry.strip())
            entry = ""
        else:
            entry += letter
    entries.append(entry.strip())
    if depth != 0 or "" in entries:
        raise Problem(f"{where}: the array {text} has an empty entry or a brace that is not closed.")
    return [entry.strip("\"'") for entry in entries]


def flat(value: Any) -> list[Any]:
    """The numbers or texts of nested sequences, row by row."""
    return [one for entry in value for one in (flat(entry) if isinstance(entry, (list, tuple)) else [entry])]


def array(values: Sequence[Any]) -> str:
    """Numbers or texts in braces."""
    return "{" + ", ".join(repr(v) if isinstance(v, (int, float)) else str(v) for v in values) + "}"


def typed(value: Any) -> tuple[str, str]:
    """Type and text of a Python value as Teuchos writes them. NumPy numbers and arrays, nested sequences (row by row) and paths
    are converted. A Problem if it is something else."""
    if hasattr(value, "tolist"):  # of NumPy
        value = value.tolist()
    if isinstance(value, bool):
        return "bool", str(value).lower()
    if isinstance(value, int):
        return "int", str(value)
    if isinstance(value, float):
        return "double", repr(value)
    if isinstance(value, (list, tuple)):
        entries = [one.tolist() if hasattr(one, "tolist") else one for one in flat(value)]
        if entries and all(isinstance(one, str) for one in entries):
            return "Array(string)", array(entries)
        if all(isinstance(one, (int, float)) and not isinstance(one, bool) for one in entries):
            return "Array(double)", array(entries)
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, str):
        return "string", value
    raise Problem(f"{value!r} is no value of a scene; it has numbers, truth values, texts, and lists of numbers or of texts.")


def _number(kind: str, text: str) -> float:
    """A whole number if the type is one of whole numbers."""
    return int(text) if kind in ("int", "Array(int)") else float(text)


def from_text(kind: str, text: str, where: str) -> Any:
    """The Python value of a parameter: its type is bool, int, double, string, or Array( ) of one of these but bool. A Problem, which
    begins with `where`, if the text is no value of this type."""
    kind = kind.replace(" ", "")
    try:
        if kind == "bool":
            return {"true": True, "false": False}[text.strip().lower()]
        if kind == "Array(string)":
            return split_array(text, where)
        if kind.startswith("Array("):
            return [_number(kind, one) for one in split_array(text, where)] if text.strip("{} \t\n") else []
        return _number(kind, text) if kind in ("int", "double") else text
    except (KeyError, ValueError):
        raise Problem(f'{where}: "{text}" is no value of the type {kind}.')
