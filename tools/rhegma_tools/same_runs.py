"""Runs scenes with two programs and compares what they give."""

import fnmatch
import glob
import hashlib
import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

from rhegma.problem import Problem

from .same_numbers import compare_histories, compare_summaries

FOLDERS = ("examples", "verification", os.path.join("studies", "scenes"))
GOOD = (0, 4)  # exit statuses of a finished run; 4: a reference of the scene was missed
KEPT = ("history.csv", "summary.json", "rhegma.log", "run.json")


def scenes_of(program):
    """xml_inputs of the tree that a program was built in, or None."""
    folder = os.path.dirname(os.path.realpath(program))
    while folder != os.path.dirname(folder):
        if os.path.isdir(os.path.join(folder, "xml_inputs", "examples")):
            return os.path.join(folder, "xml_inputs")
        folder = os.path.dirname(folder)
    return None


def choose_scenes(inputs, patterns):
    """Names such as examples/dcb of the scenes that match one of the patterns; all of them without patterns."""
    paths = [path for folder in FOLDERS for path in sorted(glob.glob(os.path.join(inputs, folder, "*.xml")))]
    names = [os.path.splitext(os.path.relpath(path, inputs))[0] for path in paths]
    if not names:
        raise Problem(f"there are no scenes in {inputs}.")
    chosen = set(names if not patterns else [])
    for pattern in patterns:
        found = [name for name in names if fnmatch.fnmatch(name, pattern) or fnmatch.fnmatch(os.path.basename(name), pattern)]
        if not found:
            raise Problem(f"no scene of {inputs} is called {pattern}.")
        chosen.update(found)
    return [name for name in names if name in chosen]


def digest(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def processor_seconds(pid):
    """Processor time of a running process, or None where the system does not show it."""
    try:
        with open(f"/proc/{pid}/stat", encoding="utf-8") as file:
            fields = file.read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    except (OSError, IndexError, ValueError):
        return None


def start(command, log, limit):
    """Runs a command; past the limit of processor time it is asked to end. Returns (exit status, whether it was)."""
    begin = time.monotonic()
    process = subprocess.Popen(command, stdout=log, stderr=log, env=dict(os.environ, OMP_NUM_THREADS="1"))
    stopped = False
    try:
        while True:
            try:
                return process.wait(timeout=0.2), stopped
            except subprocess.TimeoutExpired:
                seconds = processor_seconds(process.pid)
            if not stopped and (time.monotonic() - begin if seconds is None else seconds) > limit:
                process.send_signal(signal.SIGTERM)
                stopped = True
    except BaseException:
        process.kill()
        raise


def run(program, scene, folder, options):
    """Runs a scene into a folder, or reads there what the same run left. Returns what run.json says of it."""
    record = {"program": digest(program), "scene": digest(scene), "settings": options.settings}
    path = os.path.join(folder, "run.json")
    try:
        with open(path, encoding="utf-8") as file:
            found = json.load(file)
        if all(found.get(key) == value for key, value in record.items()) and (
                not found["stopped"] or found["limit"] >= options.seconds):
            return found
    except (OSError, ValueError):
        pass
    os.makedirs(os.path.dirname(folder), exist_ok=True)
    own = tempfile.mkdtemp(dir=os.path.dirname(folder))  # takes its place at the end, since others may read the folder
    command = [program, scene, "--output", own]
    for setting in options.settings:
        command += ["--set", setting]
    with open(os.path.join(own, "rhegma.log"), "w", encoding="utf-8") as log:
        status, stopped = start(command, log, options.seconds)
    for name in os.listdir(own):
        if name not in KEPT:
            os.remove(os.path.join(own, name))
    record.update(status=status, stopped=stopped, limit=options.seconds)
    with open(os.path.join(own, "run.json"), "w", encoding="utf-8") as file:
        json.dump(record, file, indent=1)
    shutil.rmtree(folder, ignore_errors=True)
    os.chmod(own, 0o755)
    os.rename(own, folder)
    return record


def last_line(folder):
    with open(os.path.join(folder, "rhegma.log"), encoding="utf-8", errors="replace") as file:
        lines = [line.strip() for line in file if line.strip()]
    return lines[-1] if lines else ""


def compare(name, options):
    """Whether a scene gives the same with both programs, and a line of the table."""
    scene = os.path.join(options.inputs, name + ".xml")
    scene_before = os.path.join(options.inputs_before, name + ".xml")
    if not os.path.exists(scene_before):
        return True, "new"
    # A folder for each kind of run, so that a short one does not take the place of a long one.
    kind = hashlib.sha256(json.dumps(options.settings).encode()).hexdigest()[:8] if options.settings else "whole"
    folders = [os.path.join(options.cache, kind, name), os.path.join(options.keep, kind, name)]
    before = run(options.before, scene_before, folders[0], options)
    if not options.after:
        return True, f"kept (status {before['status']})"
    after = run(options.after, scene, folders[1], options)
    for record, folder, which in ((before, folders[0], "before"), (after, folders[1], "after")):
        if not record["stopped"] and record["status"] not in GOOD and before["status"] != after["status"]:
            return False, f"FAILED {which} with status {record['status']}: {last_line(folder)}"
    cut = before["stopped"] or after["stopped"]
    worst, rows = compare_histories(folders[0], folders[1], cut, options.ignore, options.renamed)
    if not cut:
        worst = max(worst, compare_summaries(folders[0], folders[1], options.ignore, options.renamed))
    part = f"{rows} rows" + (" before one was stopped" if cut else "")
    if worst[0] == 0.0:
        return True, f"same ({part})"
    same = worst[0] <= options.tolerance
    return same, f"{'same to' if same else 'DIFFERS by'} {worst[0]:.2g} in {worst[1]} ({part})"


def compare_all(scenes, options):
    """Prints a line a scene; returns how many differ."""
    width = max(map(len, scenes))
    different = 0
    with ThreadPoolExecutor(options.jobs) as pool:
        results = [(name, pool.submit(compare, name, options)) for name in scenes]
        try:
            for name, result in results:
                same, line = result.result()
                different += not same
                if not (same and options.quiet):
                    print(f"{name:{width}}  {line}", flush=True)
        except BaseException:
            for _, result in results:
                result.cancel()
            raise
    return different
