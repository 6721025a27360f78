"""Reads fronts.h5: values along fronts in 3D over time."""

from __future__ import annotations

import os
from typing import Any

import h5py
import numpy as np

from .problem import Problem

COLUMNS = ("s", "G", "K_I", "K_II", "K_III", "speed")


class FrontSample:
    """A front at a time [s]. s: arc length [m], G [J/m2], K_I, K_II, K_III [Pa sqrt(m)], speed [m/s]: (n) over its nodes, NaN where
    there is no value; position (n, 3) [m]; line (n): number of the node's line"""

    def __init__(self, time: float, table: Any):
        self.time = time
        self.s, self.G, self.K_I, self.K_II, self.K_III, self.speed = (np.asarray(table[name], dtype=float) for name in COLUMNS)
        self.position = np.asarray(table["position"], dtype=float)
        self.line = np.asarray(table["line"], dtype=int)


def written_samples(file: h5py.File) -> list[str]:
    """Names of the groups of samples, in the order of time."""
    return sorted((name for name in file if name[:1] == "t" and name[1:].isdigit()), key=lambda name: int(name[1:]))


def read_series(folder: str) -> dict[str, list[FrontSample]]:
    """{"CRACK.N": [FrontSample, ...]} of a run, in the order of time; empty where the run wrote none, such
    as in 2D. A Problem where the file can't be read."""
    path = os.path.join(folder, "fronts.h5")
    found: dict[str, list[FrontSample]] = {}
    if not os.path.exists(path):
        return found
    try:
        with h5py.File(path, "r") as file:
            for sample in written_samples(file):
                time = float(file[sample].attrs["time"])
                for name, table in file[sample].items():
                    found.setdefault(name, []).append(FrontSample(time, table))
    except (OSError, KeyError, RuntimeError, ValueError) as error:
        raise Problem(f"{path} can't be read; it is truncated, still being written or not a file of fronts ({error}).")
    return found
