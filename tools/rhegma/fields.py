"""Reads one written time of fields.h5."""

from __future__ import annotations

import os
from typing import Any, Iterable

import h5py
import numpy as np

from .components import component_values, parts_of
from .fronts import written_samples
from .problem import Problem
from .units import FIELD_UNITS


class Crack:
    """All cracks at one time. points (v, 3) [m] as they are now, cells (s, 2 or 3): numbers of their points, opening (v, 3) [m]: position of
    one face minus that of the other; number (s): which crack of the scene a cell belongs to."""

    def __init__(self, points: np.ndarray, cells: np.ndarray, opening: np.ndarray, number: np.ndarray | None = None):
        self.points = points
        self.cells = cells
        self.opening = opening
        self.number = np.zeros(len(cells), dtype=int) if number is None else number

    @property
    def is_surface(self) -> bool:
        """Whether cells are triangles (3D); in 2D they are lines."""
        return self.cells.shape[1] == 3


class Tools:
    """The surfaces of rigid tools at one time. points (t, 3) [m] as they are now, cells (u, 2 or 3): numbers of the points of each segment
    (2D) or triangle (3D); number (u): which tool of the scene a cell belongs to."""

    def __init__(self, points: np.ndarray, cells: np.ndarray, number: np.ndarray):
        self.points = points
        self.cells = cells
        self.number = number


class Leaves:
    """The cells that hold particles. corners (k, 4 or 8, 3) [m], level (k): 0 for the scene's own Cell Size."""

    def __init__(self, corners: np.ndarray, level: np.ndarray):
        self.corners = corners
        self.level = level

    @property
    def refined(self) -> bool:
        """Whether there are cells that are smaller than the scene's own."""
        return bool(np.any(self.level > 0))


class Fields:
    """Particles and cracks at one time; arrays as in the file. time [s]; position, displacement (n, 3) [m]; stress (n, 6) [Pa]: xx, yy, zz, xy,
    yz, xz; von_mises (n) [Pa]; temperature (n) [K]; deformation (n, 3, 3): F; edges (n, 3, 3): the undeformed edge vectors of a particle's
    box, one a row, in 2D two and a row of zeros [m]; body (n): number in the scene; counts: whether the field that was asked for is of whole
    numbers, such as piece. What the run did not compute is None. crack: all cracks, or None; leaves: cells, or None; tools: rigid tools, or
    None. written: times of all frames of the file [s]. source: (path of the file, name of the frame).

    `fields["velocity"]` reads any field of the particles, `names` lists them."""

    def __init__(self, time: float, particles: dict[str, np.ndarray], crack: Crack | None, leaves: Leaves | None = None,
                 written: Iterable[float] = (), source: tuple[str, str] | None = None, tools: Tools | None = None):
        self.time = time
        self.written = sorted(written)
        self.source = source
        self.position = particles["position"]
        self.displacement = particles["displacement"]
        self.stress = particles.get("stress")  # None where the run had heat alone
        self.von_mises = particles.get("von_mises")
        temperature = particles.get("temperature")
        self.temperature = None if temperature is None else temperature.reshape(len(temperature))
        self.deformation = particles["deformation"].reshape(-1, 3, 3)
        self.edges = particles["edges"].reshape(-1, 3, 3)
        body = particles.get("body")
        self.body = np.zeros(len(self.position), dtype=int) if body is None else body.astype(int).ravel()  # number in the scene
        self.chosen = particles.get("chosen")  # another field (n) or (n, components), if it was asked for
        self.counts = bool(particles.get("counts", False))
        self.crack = crack
        self.leaves = leaves
        self.tools = tools

    @property
    def names(self) -> list[str]:
        """Names of all fields of the particles in the file."""
        if self.source is None:
            return []
        with h5py.File(self.source[0], "r") as file:
            return sorted(file[self.source[1]]["particles"])

    def __getitem__(self, name: str) -> np.ndarray:
        """A field (n) or (n, components) of the particles by its name, read from the file. A Problem names those that there are."""
        if self.source is None:
            raise Problem("these fields are from no file.")
        try:
            with h5py.File(self.source[0], "r") as file:
                return read_chosen(file[self.source[1]]["particles"], name)
        except (OSError, KeyError, RuntimeError) as error:
            raise Problem(f"{self.source[0]} can't be read any more ({error}).")

    def unit(self, name: str) -> str:
        """Unit of a field of the particles; "" for numbers without a unit, such as deformation, and where it isn't known."""
        return FIELD_UNITS.get(parts_of(name)[0], "")

    @property
    def dimension(self) -> int:
        """2 where the particles' boxes have no extent along z, else 3."""
        return 3 if np.any(self.edges[:, :, 2]) else 2

    @property
    def size(self) -> float:
        """A particle's edge [m]: the median."""
        return float(np.median(np.linalg.norm(self.edges[:, 0], axis=1)))

    def boxes(self, chosen: Any = slice(None), magnification: float = 1.0) -> np.ndarray:
        """Edge vectors (n, 3, 3) of boxes as they are now, with displacements magnified: (1 + m (F - 1)) E."""
        change = self.deformation[chosen] - np.eye(3)
        return self.edges[chosen] + magnification * np.einsum("nij,nej->nei", change, self.edges[chosen])

    def values(self, quantity: str) -> np.ndarray | None:
        """What to colour particles by: "principal" or "mises" [Pa], "temperature" [K]; the last where nothing else is. Any other is a component
        of the field that was asked for."""
        if self.chosen is not None and quantity not in ("principal", "mises", "temperature"):
            return component_values(self.chosen, parts_of(quantity)[1])
        if quantity == "temperature" or self.stress is None:
            return self.temperature
        return self.largest_principal_stress() if quantity == "principal" else self.von_mises

    def largest_principal_stress(self) -> np.ndarray:
        """Largest eigenvalue (n) of every particle's stress [Pa]."""
        xx, yy, zz, xy, yz, xz = self.stress.T
        tensor = np.stack([np.stack([xx, xy, xz], -1), np.stack([xy, yy, yz], -1), np.stack([xz, yz, zz], -1)], -2)
        return np.linalg.eigvalsh(tensor)[:, -1]


def far_frame(fields: Fields, time: float) -> str | None:
    """A line that names the time of the frame where that is not the time asked for [s], else None: where this lies outside of
    the frames, or more than half of their usual interval from the nearest one."""
    first, last = fields.written[0], fields.written[-1]
    rounding = 1.0e-6 * max(abs(first), abs(last))
    interval = float(np.median(np.diff(fields.written))) if len(fields.written) > 1 else 0.0
    if first - rounding <= time <= last + rounding and abs(fields.time - time) <= 0.5 * interval + rounding:
        return None
    count = len(fields.written)
    frames = f"the only frame is at {first:.6g} s" if count == 1 else f"the {count} frames are from {first:.6g} to {last:.6g} s"
    return f"There are no fields at {time:.6g} s; those at {fields.time:.6g} s are drawn ({frames})."


def read_crack(group: h5py.Group | None) -> Crack | None:
    """The cracks of a frame, or None."""
    if group is None or "points" not in group or group["points"].shape[0] == 0:
        return None
    points = np.asarray(group["points"], dtype=float)
    cells = np.asarray(group["cells"], dtype=int)
    opening = np.asarray(group["opening"], dtype=float) if "opening" in group else np.zeros_like(points)
    number = np.asarray(group["crack"], dtype=int) if "crack" in group else None
    return Crack(points, cells, opening, number) if cells.size else None


def read_tools(group: h5py.Group | None) -> Tools | None:
    """The rigid tools of a frame, or None."""
    if group is None or "points" not in group or group["cells"].shape[0] == 0:
        return None
    return Tools(np.asarray(group["points"], dtype=float), np.asarray(group["cells"], dtype=int), np.asarray(group["tool"], dtype=int))


def read_leaves(group: h5py.Group | None) -> Leaves | None:
    """The cells of a frame, or None."""
    if group is None or "level" not in group or group["level"].shape[0] == 0:
        return None
    points = np.asarray(group["points"], dtype=float)
    return Leaves(points[np.asarray(group["cells"], dtype=int)], np.asarray(group["level"], dtype=int))


def read_chosen(group: h5py.Group, field: str) -> np.ndarray:
    """A field of the particles by its name; a Problem names those that there are."""
    if field not in group:
        raise Problem(f"the particles have no field {field}; they have {', '.join(sorted(group))}, and principal and mises.")
    return np.asarray(group[field], dtype=float)


def read_fields(folder: str, time: float | None = None, field: str | None = None) -> Fields | None:
    """The fields of a run nearest to a time [s], or the last ones, or None where the run left none. field: another one of the particles that is
    read, too. A Problem where the file can't be read, or holds no particle or numbers that are not finite"""
    path = os.path.join(folder, "fields.h5")
    if not os.path.exists(path):
        return None
    try:
        with h5py.File(path, "r") as file:
            times = written_samples(file)
            if not times:
                raise Problem(f"{path} holds no written time; the run was cut off before its first fields.")
            written = {name: float(file[name].attrs["time"]) for name in times}
            name = times[-1] if time is None else min(times, key=lambda n: abs(written[n] - time))
            chosen = file[name]
            group = chosen["particles"]
            names = ["position", "displacement", "deformation", "edges"]
            names += ["stress", "von_mises"] if "stress" in group or "temperature" not in group else []
            names += [name for name in ("temperature", "body") if name in group]
            particles = {name: np.asarray(group[name], dtype=float) for name in names}
            if field is not None:
                particles["chosen"] = read_chosen(group, field)
                particles["counts"] = np.asarray(group[field].dtype.kind in "iu")
            fields = Fields(float(chosen.attrs["time"]), particles, read_crack(chosen.get("cracks")),
                            read_leaves(chosen.get("leaves")), written.values(), (path, name), read_tools(chosen.get("tools")))
    except (OSError, KeyError, RuntimeError, ValueError, IndexError) as error:
        raise Problem(f"{path} can't be read; it is truncated, still being written or not a file of fields ({error}).")
    if fields.position.shape[0] == 0:
        raise Problem(f"{path} holds no particle at {fields.time:g} s.")
    if not all(np.isfinite(v).all() for v in (fields.position, fields.stress, fields.temperature) if v is not None):
        raise Problem(f"{path} holds numbers that are not finite at {fields.time:g} s; the run was unstable.")
    return fields


def read_times(folder: str) -> list[float]:
    """Times of all frames of fields.h5 [s], in order; empty where the run left none. A Problem where the file can't be read."""
    path = os.path.join(folder, "fields.h5")
    if not os.path.exists(path):
        return []
    try:
        with h5py.File(path, "r") as file:
            return sorted(float(file[name].attrs["time"]) for name in written_samples(file))
    except (OSError, KeyError, RuntimeError) as error:
        raise Problem(f"{path} can't be read; it is truncated, still being written or not a file of fields ({error}).")
