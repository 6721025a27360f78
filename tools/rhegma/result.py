"""A finished, stopped or active run: what it has written into its folder."""

from __future__ import annotations

import os
from functools import cached_property
from typing import TYPE_CHECKING, Any, Iterator, Mapping, Sequence

from .problem import Problem
from .program import FINISHED
from .summary import look_up, read_summary

if TYPE_CHECKING:
    from .fields import Fields
    from .fronts import FrontSample
    from .history import History

FILES = ("summary.json", "history.csv", "fields.h5", "fronts.h5", "run.lock")


class Run:
    """What a run has written. folder: of its files; status: exit status of the program, None where the run was only read from its folder;
    output: what the program printed; warnings: its warnings; settings: {path: value}, by which the scene of this run differs from that of
    a sweep.

    Files are read when they are first asked for, and only once: make a new Run to follow one that goes on. A Problem where the folder has
    no file of a run."""

    def __init__(self, folder: str | os.PathLike[str], status: int | None = None, output: str = "", warnings: Sequence[str] | None = None,
                 settings: Mapping[str, Any] | None = None):
        self.folder = os.path.abspath(os.fspath(folder))
        self.status = status
        self.output = output
        self.settings = dict(settings or {})
        self._warnings = warnings
        if status is None and not any(os.path.exists(os.path.join(self.folder, name)) for name in FILES):
            raise Problem(f"{self.folder} has no file of a run; give the folder that a run wrote.")

    def __repr__(self) -> str:
        """Folder and end of the run."""
        return f"Run({self.folder!r}, {self.end or 'no summary'})"

    @cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json as it is in the file. A Problem where there is none: the run has not ended, or was killed."""
        found = read_summary(self.folder)
        if found is None:
            raise Problem(f"{self.folder} has no summary.json: the run has not ended, or it was killed.")
        return found

    @property
    def end(self) -> str | None:
        """How the run ended: "finished", "not at rest", "cut off", "stopped" or "stopped by a signal"; None where it has no summary."""
        return self.summary.get("end") if os.path.exists(os.path.join(self.folder, "summary.json")) else None

    @property
    def finished(self) -> bool:
        """Whether the run got to its end: not stopped, not killed, not active."""
        if self.status is not None:
            return self.status in FINISHED
        return self.end is not None and not self.end.startswith("stopped")

    @property
    def warnings(self) -> list[str]:
        """Warnings of the run."""
        return list(self.summary.get("warnings") or [] if self._warnings is None else self._warnings)

    @property
    def references_met(self) -> bool | None:
        """Whether all values of the section Reference are within their tolerances; None where none was compared."""
        found = [entry.get("within") for entry in self.summary.get("references") or [] if entry.get("within") is not None]
        return all(found) if found else None

    def value(self, quantity: str) -> float:
        """A number of the summary by its path, such as "cracks.Notch.fronts.0.G_J"; entries of lists by name or number. NaN where the
        run wrote null. A Problem where there is no such number."""
        return look_up(self.summary, quantity)

    @cached_property
    def history(self) -> History:
        """history.csv. A Problem where there is none."""
        from .history import read_history

        found = read_history(self.folder)
        if found is None:
            raise Problem(f"{self.folder} has no history.csv.")
        return found

    @cached_property
    def times(self) -> list[float]:
        """Times of the frames of fields.h5 [s], in order; empty where there is none."""
        from .fields import read_times

        return read_times(self.folder)

    def fields(self, time: float | None = None) -> Fields:
        """Particles, cracks and cells at the frame nearest to a time [s], or at the last one. A Problem where there is none."""
        from .fields import read_fields

        found = read_fields(self.folder, time)
        if found is None:
            raise Problem(f"{self.folder} has no fields.h5; set Output > Fields in the scene.")
        return found

    def frames(self) -> Iterator[Fields]:
        """The fields at each time, one after the other, so that only one frame is in memory."""
        return (self.fields(time) for time in self.times)

    @cached_property
    def fronts(self) -> dict[str, list[FrontSample]]:
        """Values along 3D fronts: {"CRACK.N": samples in the order of time}; empty where the run wrote none."""
        from .fronts import read_series

        return read_series(self.folder)
