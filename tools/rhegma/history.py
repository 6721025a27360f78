"""Reads history.csv."""

from __future__ import annotations

import csv
import difflib
import os

import numpy as np

from .problem import Problem
from .units import unit_of_column


class History:
    """Columns of numbers over time.

    column[name]: samples (n), as many as time has [SI]; time (n) [s]; fronts: (crack's name, number) in the order of the columns.
    `history["Notch.0.G_J"]` is a column, too, with a message where there is none.
    """

    def __init__(self, column: dict[str, np.ndarray]):
        self.column = column
        self.time = column["time"]
        self.fronts: list[tuple[str, int]] = []
        for name in column:
            parts = name.rsplit(".", 2)  # a crack's own name may hold dots
            if len(parts) == 3 and parts[1].isdigit() and (parts[0], int(parts[1])) not in self.fronts:
                self.fronts.append((parts[0], int(parts[1])))

    def __getitem__(self, name: str) -> np.ndarray:
        """The samples (n) of a column, in the unit `unit(name)`. A Problem names similar columns where there is no such one."""
        if name not in self.column:
            near = difflib.get_close_matches(name, self.column, 3) or list(self.column)
            raise Problem(f"the history has no column {name}; it has {', '.join(near)}.")
        return self.column[name]

    def __contains__(self, name: object) -> bool:
        """Whether there is a column of this name."""
        return name in self.column

    def __len__(self) -> int:
        """Number of samples."""
        return len(self.time)

    @property
    def names(self) -> list[str]:
        """Names of all columns, in the order of the file."""
        return list(self.column)

    def unit(self, name: str) -> str | None:
        """Unit of a column, such as "J/m2"; "" for plain numbers, None where it isn't known (such as of an extreme of a field)."""
        return unit_of_column(name)

    def of_front(self, front: tuple[str, int], quantity: str) -> np.ndarray | None:
        """Samples (n) of a quantity of a front, such as (("Notch", 0), "G_J"), or None."""
        return self.column.get(f"{front[0]}.{front[1]}.{quantity}")


def read_history(folder: str) -> History | None:
    """The history of a run, or None where the run left none. A last row that was cut off is dropped. A Problem where the file
    can't be read or holds no sample."""
    path = os.path.join(folder, "history.csv")
    if not os.path.exists(path):
        return None
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = [row for row in csv.reader(file) if row]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise Problem(f"{path} can't be read ({error}).")
    if not rows or "time" not in [name.strip() for name in rows[0]]:
        raise Problem(f"{path} has no column named time; a history starts with a line of column names.")
    names = [name.strip() for name in rows[0]]
    samples = rows[1:]
    if samples and len(samples[-1]) < len(names):
        samples.pop()
    if not samples:
        raise Problem(f"{path} holds no sample; the run was cut off or its Output section samples too rarely.")
    values = []
    for line, row in enumerate(samples, start=2):
        try:
            values.append([float(text) if text.strip() else float("nan") for text in row])
        except ValueError:
            raise Problem(f"{path}, row {line}: an entry is no number.")
        if len(row) != len(names):
            raise Problem(f"{path}, row {line}: has {len(row)} entries, but there are {len(names)} columns.")
    table = np.array(values)
    return History({name: table[:, i] for i, name in enumerate(names)})
