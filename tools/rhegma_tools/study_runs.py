"""Runs the scenes of a study, one after the other unless asked otherwise so that their times compare, and collects what
they give."""

import csv
import hashlib
import json
import math
import os
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor

from rhegma.problem import Problem
from rhegma.program import FINISHED, start
from rhegma.records import RECORD, done_before, folder_name, forget, write_record
from rhegma.summary import look_up, read_summary

from .output_file import text_to


class Outcome:
    """What a run gave. good: whether it finished with finite values. value and error, wall_seconds and particle_steps are None
    where it failed, value and error also where nothing was asked for; processor_seconds, of all its threads, where it was
    started by a launcher."""

    def __init__(self, run, folder, status):
        self.run = run
        self.folder = folder
        self.status = status
        self.good = False
        self.value = self.error = self.wall_seconds = self.processor_seconds = self.particle_steps = None


def run_folder(output, run):
    """A folder that follows from scene and settings alone: the values and a digest that distinguishes similar ones. Families
    that look at different quantities of the same run share it."""
    return os.path.join(output, folder_name(run.settings, [run.scene, sorted(run.settings.items())]))


def record_of(run, launcher):
    with open(run.scene, "rb") as file:
        digest = hashlib.sha256(file.read()).hexdigest()
    return {"scene": run.scene, "scene_sha256": digest, "settings": run.settings, "launcher": launcher}


def command_of(run, folder, program, launcher):
    command = [*launcher, program, run.scene, "--output", folder]
    for path, value in run.settings.items():
        command += ["--set", f"{path}={value}"]
    return command


def check(run, program):
    """Throws a Problem where rhegma finds the scene wrong with the settings of a run."""
    command = [program, run.scene, "--check"]
    for path, value in run.settings.items():
        command += ["--set", f"{path}={value}"]
    try:
        result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                                errors="replace")
    except OSError as error:
        raise Problem(f"{program} can't be started ({error.strerror}).")
    if result.returncode != 0:
        lines = [line.strip() for line in result.stdout.splitlines() if line.strip()]
        raise Problem(f"Sweep > {run.family}: {lines[0] if lines else 'rhegma --check fails without a word'}")


def check_all(study, output, program, launcher, again):
    """Checks every scene that is still to be run, so that a mistake in the last one shows before the first one runs."""
    checked = set()
    for run in study.runs:
        folder = run_folder(output, run)
        if folder not in checked and (again or done_before(folder, record_of(run, launcher)) is None):
            check(run, program)
            checked.add(folder)


def execute(run, folder, program, launcher, watch=None):
    """Runs a scene; its output goes to rhegma.log in its folder. Returns the exit status."""
    record = record_of(run, launcher)
    forget(folder)
    with open(os.path.join(folder, "rhegma.log"), "w", encoding="utf-8") as log:
        try:
            status, seconds = start(command_of(run, folder, program, launcher), log, watch)
        except OSError as error:
            raise Problem(f"{(launcher or [program])[0]} can't be started ({error.strerror}).")
    write_record(folder, record, status, None if launcher else seconds)
    return status


def processor_seconds(folder):
    """Processor time of the run in a folder as it was recorded, or None."""
    with open(os.path.join(folder, RECORD), encoding="utf-8") as file:
        return json.load(file).get("processor_seconds")


def measure(run, folder, status):
    """The outcome of a run in its folder."""
    outcome = Outcome(run, folder, status)
    if status not in FINISHED:
        return outcome
    summary = read_summary(folder)
    if summary is None:
        raise Problem(f"{folder} has no summary.json although the run finished.")
    values = [look_up(summary, quantity) for quantity in run.quantities]
    if not all(math.isfinite(value) for value in values):
        return outcome
    outcome.good = True
    if values:
        outcome.value = values[0] if len(values) == 1 else math.hypot(*values)
        deviation = math.hypot(*(value - reference for value, reference in zip(values, run.references)))
        outcome.error = deviation / abs(run.reference) if run.reference != 0.0 else deviation
    outcome.wall_seconds = look_up(summary, "wall_seconds")
    outcome.processor_seconds = processor_seconds(folder)
    outcome.particle_steps = round(look_up(summary, "particle_steps"))
    return outcome


def last_line(folder):
    """The last line that a failed run wrote."""
    try:
        with open(os.path.join(folder, "rhegma.log"), encoding="utf-8", errors="replace") as file:
            lines = [line.strip() for line in file if line.strip()]
    except OSError:
        return ""
    return lines[-1] if lines else ""


def run_ahead(study, output, program, launcher, again, jobs, say):
    """Runs what is still to be run, several runs at a time. Returns {folder: exit status} of these."""
    todo = {}
    for run in study.runs:
        folder = run_folder(output, run)
        if folder not in todo and (again or done_before(folder, record_of(run, launcher)) is None):
            todo[folder] = run
    with ThreadPoolExecutor(jobs) as pool:
        started = {folder: pool.submit(execute, run, folder, program, launcher) for folder, run in todo.items()}
        for number, (folder, result) in enumerate(started.items(), start=1):
            result.result()
            say(f"[{number}/{len(todo)}] {os.path.basename(folder)}")
    return {folder: result.result() for folder, result in started.items()}


def run_all(study, output, program, launcher, again, say, show=None, jobs=1):
    """Outcomes of all runs, in order; those that were done before are only read, unless all shall run again.

    say(line): for good; show(line): for the moment, while a run goes on; None where there is no terminal; jobs: runs at a
    time."""
    outcomes, begin = [], time.monotonic()
    fresh = run_ahead(study, output, program, launcher, again, jobs, say) if jobs > 1 else {}
    for number, run in enumerate(study.runs, start=1):
        folder = run_folder(output, run)
        values = ", ".join(f"{path} = {value}" for path, value in run.settings.items())
        head = f"[{number}/{len(study.runs)}] {run.family}" + (f": {values}" if values else "")
        status = fresh.get(folder)
        if status is None and not again:
            status = done_before(folder, record_of(run, launcher))
        before = status is not None and jobs == 1
        if status is None:
            watch = show and (lambda: show(f"[{number}/{len(study.runs)}] {run.family}: {last_line(folder)} "
                                           f"({time.monotonic() - begin:.0f} s in all)"))
            status = fresh[folder] = execute(run, folder, program, launcher, watch)
        outcome = measure(run, folder, status)
        if outcome.good:
            error = "" if outcome.error is None else f"error {outcome.error:.3g}, "
            say(f"{head}: {error}{outcome.wall_seconds:.3g} s{' (done before)' if before else ''}")
        else:
            why = f"{run.quantity} is not finite" if status in FINISHED else last_line(folder)
            say(f"{head}: failed with status {status}: {why}")
        outcomes.append(outcome)
    return outcomes


def write_table(study, outcomes, path):
    """study.csv: a row for every run; the fields of what a failed run did not give are empty."""
    paths = list(dict.fromkeys(p for run in study.runs for p in run.settings))
    with text_to(path) as file:
        rows = csv.writer(file)
        rows.writerow(["family", *paths, "value", "error", "wall_seconds", "processor_seconds", "particle_steps",
                       "exit", "path"])
        for o in outcomes:
            numbers = [o.value, o.error, o.wall_seconds, o.processor_seconds, o.particle_steps]
            rows.writerow([o.run.family, *(o.run.settings.get(p, "") for p in paths),
                           *("" if n is None else repr(n) for n in numbers), o.status, o.folder])
