"""Reads the last written time of fields.h5."""

import os

import h5py
import numpy as np

from .interpreter import Problem


class Crack:
    """points (v, 3) [m] as they are now, cells (s, 2 or 3), opening (v, 3) [m]: one face's place less the other's."""

    def __init__(self, points, cells, opening):
        self.points = points
        self.cells = cells
        self.opening = opening

    @property
    def is_surface(self):
        return self.cells.shape[1] == 3


class Fields:
    """Particles and cracks at one time; arrays as in the file."""

    def __init__(self, time, particles, crack):
        self.time = time
        self.position = particles["position"]
        self.displacement = particles["displacement"]
        self.stress = particles["stress"]
        self.von_mises = particles["von_mises"]
        self.edge = particles["edge"]
        self.crack = crack

    @property
    def dimension(self):
        """2 where all particles lie in the plane z = 0, else 3."""
        return 3 if np.any(self.position[:, 2]) or np.any(self.displacement[:, 2]) else 2

    def largest_principal_stress(self):
        """Largest eigenvalue of every particle's stress [Pa]."""
        xx, yy, zz, xy, yz, xz = self.stress.T
        tensor = np.stack([np.stack([xx, xy, xz], -1), np.stack([xy, yy, yz], -1), np.stack([xz, yz, zz], -1)], -2)
        return np.linalg.eigvalsh(tensor)[:, -1]


def read_crack(group):
    if group is None or "points" not in group or group["points"].shape[0] == 0:
        return None
    points = np.asarray(group["points"], dtype=float)
    cells = np.asarray(group["cells"], dtype=int)
    opening = np.asarray(group["opening"], dtype=float) if "opening" in group else np.zeros_like(points)
    return Crack(points, cells, opening) if cells.size else None


def read_fields(folder):
    """The last fields of a run, or None where the run left none."""
    path = os.path.join(folder, "fields.h5")
    if not os.path.exists(path):
        return None
    try:
        with h5py.File(path, "r") as file:
            times = sorted((name for name in file if name[:1] == "t" and name[1:].isdigit()), key=lambda n: int(n[1:]))
            if not times:
                raise Problem(f"{path} holds no written time; the run was cut off before its first fields.")
            last = file[times[-1]]
            group = last["particles"]
            names = ["position", "displacement", "stress", "von_mises", "edge"]
            particles = {name: np.asarray(group[name], dtype=float) for name in names}
            fields = Fields(float(last.attrs["time"]), particles, read_crack(last.get("cracks")))
    except (OSError, KeyError, RuntimeError, ValueError) as error:
        raise Problem(f"{path} can't be read; it is truncated, still being written or not a file of fields ({error}).")
    if fields.position.shape[0] == 0:
        raise Problem(f"{path} holds no particle at its last time.")
    if not (np.isfinite(fields.position).all() and np.isfinite(fields.stress).all()):
        raise Problem(f"{path} holds numbers that are not finite at its last time; the run was unstable.")
    return fields
