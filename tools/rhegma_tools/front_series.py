"""Reads fronts.h5: values along fronts in 3D over time."""

import os

import h5py
import numpy as np

from .interpreter import Problem

COLUMNS = ("s", "G", "K_I", "K_II", "K_III", "speed")


class FrontSample:
    """A front at a time [s]. s, G, K_I, K_II, K_III, speed: (n) over its nodes, NaN where there is no value; position (n, 3); line (n)"""

    def __init__(self, time, table):
        self.time = time
        for name in COLUMNS:
            setattr(self, name, np.asarray(table[name], dtype=float))
        self.position = np.asarray(table["position"], dtype=float)
        self.line = np.asarray(table["line"], dtype=int)


def written_samples(file):
    """Names of the groups of samples, in the order of time."""
    return sorted((name for name in file if name[:1] == "t" and name[1:].isdigit()), key=lambda name: int(name[1:]))


def read_series(folder):
    """{"CRACK.N": [FrontSample, ...]} of a run, in the order of time; empty where the run wrote none."""
    path = os.path.join(folder, "fronts.h5")
    found = {}
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
