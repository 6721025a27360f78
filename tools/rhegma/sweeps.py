"""Families of runs of one scene with different values."""

from __future__ import annotations

import hashlib
import itertools
import os
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, Iterator, Mapping, Sequence

from .execution import Input, as_scene, check, check_count, check_how, folder_of, make_folder, run
from .problem import Problem, ProgramError, SceneError
from .program import FINISHED
from .records import done_before, folder_name, forget, write_record
from .result import Run
from .scene import Scene
from .values import Quantity, typed

if TYPE_CHECKING:
    import numpy as np


class Sweep(Sequence[Run]):
    """The runs of a sweep, in the order of their values; `settings` of each has them. Runs that stopped or failed are among them, with
    their exit status."""

    def __init__(self, runs: Sequence[Run]):
        self.runs = list(runs)

    def __len__(self) -> int:
        """Number of runs."""
        return len(self.runs)

    def __getitem__(self, number: Any) -> Any:
        """A run by its number, counted from 0, or a list of runs from a slice."""
        return self.runs[number]

    def __iter__(self) -> Iterator[Run]:
        """The runs in order."""
        return iter(self.runs)

    def setting(self, path: str) -> list[Any]:
        """The value of a swept parameter in each run. A Problem where it is not swept."""
        if self.runs and path not in self.runs[0].settings:
            raise Problem(f"{path} is not swept; {', '.join(self.runs[0].settings) or 'nothing'} is.")
        return [one.settings[path] for one in self.runs]

    def values(self, quantity: str) -> np.ndarray:
        """A number (n) of the summary of each run, such as "cracks.Notch.fronts.0.G_J"; NaN for runs that did not finish. A Problem where
        a finished run has no such number."""
        import numpy

        return numpy.array([one.value(quantity) if one.status in FINISHED else numpy.nan for one in self.runs], dtype=float)

    def rows(self, *quantities: str) -> list[dict[str, Any]]:
        """A dict for each run, with its settings, the quantities of its summary and its exit status, such as for a table of pandas."""
        columns = {quantity: self.values(quantity) for quantity in quantities}
        return [{**one.settings, **{name: float(column[i]) for name, column in columns.items()}, "status": one.status}
                for i, one in enumerate(self.runs)]


def values_of(path: str, values: Any) -> list[Any]:
    """The values of a swept parameter; those of a Quantity have its unit. A Problem where there is only one, or the path is no text."""
    if not isinstance(path, str):
        raise Problem(f'{path!r} is no path of a parameter; write one such as "Domain > Cell Size".')
    if isinstance(values, Quantity):
        return [Quantity(value, values.unit) for value in values_of(path, values.value)]
    try:
        if not isinstance(values, (str, bytes, Mapping)):
            return list(values)
    except TypeError:
        pass
    raise Problem(f"{path}: {values!r} is one value; write a list of the values to run with, such as [{values!r}].")


def combinations(parameters: Mapping[str, Sequence[Any] | Quantity], combine: str) -> list[dict[str, Any]]:
    """[{path: value}] of all runs. combine: "product" for each combination, the last parameter changes first; "zip" for the first values
    together, then the second ones. A Problem where numbers of values differ with "zip"."""
    if combine not in ("product", "zip"):
        raise Problem(f'combine is {combine!r}; write "product" or "zip".')
    lists = {path: values_of(path, values) for path, values in parameters.items()}
    if combine == "zip" and len({len(values) for values in lists.values()}) > 1:
        raise Problem("zip needs as many values of each parameter, but " + ", ".join(f"{path} has {len(v)}" for path, v in lists.items()) + ".")
    rows = itertools.product(*lists.values()) if combine == "product" else zip(*lists.values())
    return [dict(zip(lists, row)) for row in rows]


def text_of(value: Any) -> str:
    """A value as a text, with its unit."""
    return typed(value.value)[1] + " " + value.unit if isinstance(value, Quantity) else typed(value)[1]


class _Planned:
    """A run that is to be made, or was made before: its folder, values and scene."""

    def __init__(self, scene: Scene, settings: dict[str, Any], output: str, how: Sequence[Any]):
        self.scene, self.settings = scene.varied(settings), settings
        texts = {path: text_of(value) for path, value in settings.items()}
        self.folder = os.path.join(output, folder_name(texts, sorted(texts.items())))
        digest = hashlib.sha256(self.scene.text().encode()).hexdigest()
        self.record = {"scene_sha256": digest, "folder": self.scene.folder, "settings": texts, "how": [str(one) for one in how]}

    def before(self) -> int | None:
        """Exit status of the run where it was done before."""
        return done_before(self.folder, self.record)

    def execute(self, **how: Any) -> Run:
        """Runs the scene and records that it was run. A run that fails is returned with its status."""
        forget(self.folder)
        try:
            done = run(self.scene, output=self.folder, stop_raises=False, **how)
        except (SceneError, ProgramError) as failure:
            status = failure.status if isinstance(failure, ProgramError) else 1
            done = Run(self.folder, status, str(failure), [])
        done.settings = dict(self.settings)
        write_record(self.folder, self.record, -1 if done.status is None else done.status, None)
        return done


def sweep(scene: Input, parameters: Mapping[str, Sequence[Any] | Quantity], *, output: str | os.PathLike[str], combine: str = "product", jobs: int = 1,
          again: bool = False, ranks: int = 1, threads: int | None = None, options: Sequence[str] = (),
          program: str | os.PathLike[str] | None = None, launcher: Sequence[str] | None = None) -> Sweep:
    """Runs a scene with each combination of values.

    scene: as for run. parameters: {path: values}, such as {"Domain > Cell Size": [2e-3, 1e-3]} or
    {"Domain > Cell Size": Quantity([2, 1], "mm")}. combine: "product" or "zip". output: folder
    of all runs; each has a folder in it. jobs: number of runs at the same time; their wall times can't be compared if there is more than
    one. again: repeat runs that were done before; else a run whose scene and values are the same is only read. Others as for run.

    All scenes are checked before the first one is run: raises a SceneError where one is wrong. A run that stops or fails does not raise;
    its `status` is 2 or more, and `values` has NaN for it."""
    check_count("jobs", jobs)
    check_how(ranks, threads, options, launcher)
    base, folder = as_scene(scene), folder_of(output)
    how = {"ranks": ranks, "threads": threads, "options": list(options), "program": program, "launcher": launcher}
    planned = [_Planned(base, one, folder, (ranks, threads, *options, *(launcher or ()))) for one in combinations(parameters, combine)]
    make_folder(folder)
    before = {one.folder: None if again else one.before() for one in planned}
    for one in planned:
        if before[one.folder] is None:
            _check(one, program)
    with ThreadPoolExecutor(jobs) as pool:
        started = {one.folder: pool.submit(one.execute, **how) for one in planned if before[one.folder] is None}
        return Sweep([started[one.folder].result() if one.folder in started else Run(one.folder, before[one.folder], settings=one.settings)
                      for one in planned])


def _check(one: _Planned, program: str | os.PathLike[str] | None) -> None:
    try:
        check(one.scene, program=program)
    except SceneError as error:
        values = ", ".join(f"{path} = {text_of(value)}" for path, value in one.settings.items())
        raise SceneError([f"with {values}: {message}" if values else message for message in error.messages]) from None
