"""Reads history.csv."""

import csv
import os

import numpy as np

from .interpreter import Problem


class History:
    """Columns of numbers over time.

    column[name]: samples, as many as time has [SI]; fronts: (crack's name, number) in the order of the columns.
    """

    def __init__(self, column):
        self.column = column
        self.time = column["time"]
        self.fronts = []
        for name in column:
            parts = name.rsplit(".", 2)  # a crack's own name may hold dots
            if len(parts) == 3 and parts[1].isdigit() and (parts[0], int(parts[1])) not in self.fronts:
                self.fronts.append((parts[0], int(parts[1])))

    def of_front(self, front, quantity):
        """Samples of a quantity of a front, or None."""
        return self.column.get(f"{front[0]}.{front[1]}.{quantity}")


def read_history(folder):
    """The history of a run, or None where the run left none. A last row that was cut off is dropped."""
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
