"""Whether the files of a run are those that it wrote, and fit each other."""

import csv
import fcntl
import io
import json
import math
import multiprocessing
import os
import re
import socket
import struct
import zlib

import h5py
import numpy as np

from .reading import attempt, read_bytes

MAGIC = b"\x89RHEGMA chk\r\n\x1a\n\x00"
BLOCK = 512
WENT_TO_ITS_END = ("finished", "not at rest", "cut off")  # "end" in summary.json of runs that nothing stopped
UNWRITTEN = "can't be written"  # in the status of a run that could not write a file


class Found:
    """how: a sentence on how the run ended, empty where the folder is of no run; faults: sentences on what is wrong; notes: on
    what is right; ended: whether the run came to its end, or to Time > Maximum Steps."""

    def __init__(self):
        self.how = ""
        self.faults = []
        self.notes = []
        self.ended = False


def read_manifest(folder, found):
    """The manifest, or {} where there is none or it is damaged."""
    path = os.path.join(folder, "manifest.json")
    if not os.path.exists(path):
        return {}
    lines = read_bytes(path).splitlines(keepends=True)
    try:
        manifest = json.loads(b"".join(lines))
        stated = re.fullmatch(rb'  "manifest_crc32": (\d+)\n', lines[-2])
        if stated and int(stated[1]) == zlib.crc32(b"".join(lines[:-2])) and lines[-1] == b"}\n":
            return manifest
    except (ValueError, IndexError):
        pass
    found.faults.append(f"{path} is damaged; what it says of the other files can't be used.")
    return {}


def is_running(folder):
    """Whether a run holds the folder's lock; None where there is no lock, or one of another machine, which may be held there."""
    try:
        with open(os.path.join(folder, "run.lock"), "rb") as file:
            # Shared: it is had at the same time as by others that only ask, and a run that starts waits for that.
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
            owner = file.readline().decode(errors="replace")
    except FileNotFoundError:
        return None
    except OSError:
        return True
    return None if owner.startswith("host: ") and owner[6:].strip() != socket.gethostname() else False


def check_text(path, entry, ended, found):
    """A file against its length and checksum; one that still grows may be longer."""
    content = read_bytes(path)
    bytes_then = entry["bytes"]
    if len(content) < bytes_then or (ended and len(content) != bytes_then):
        found.faults.append(f"{path} has {len(content)} bytes, but the run wrote {bytes_then}.")
    elif zlib.crc32(content[:bytes_then]) != entry["crc32"]:
        found.faults.append(f"{path} has changed since the run wrote it (its checksum is another).")


def check_size(path, bytes_then, found):
    if os.path.getsize(path) != bytes_then:
        found.faults.append(f"{path} has {os.path.getsize(path)} bytes, but the run wrote {bytes_then}.")


def check_scene(folder, manifest, found):
    scene = manifest.get("scene") or {}
    path = scene.get("path")
    if not path:
        return
    if not os.path.isfile(path):  # also a pipe from which the run has read it
        found.notes.append(f"The scene {path} is not there and was not compared.")
    else:
        content = read_bytes(path)
        if len(content) != scene["bytes"] or zlib.crc32(content) != scene["crc32"]:
            found.faults.append(f"the scene {path} has changed since this run began; the results are of the older one.")


def check_checkpoint(folder, found):
    path = os.path.join(folder, "checkpoint.h5")
    if not os.path.exists(path):
        return
    content = read_bytes(path)
    block = content[:BLOCK]
    if len(block) < BLOCK or block[:16] != MAGIC:
        found.faults.append(f"{path} is not a checkpoint, or its beginning is damaged.")
        return
    _, body_crc, length = struct.unpack_from("<IIQ", block, 16)
    if zlib.crc32(block[:-4]) != struct.unpack_from("<I", block, BLOCK - 4)[0]:
        found.faults.append(f"{path} is damaged: its first {BLOCK} bytes have changed.")
    elif len(content) != BLOCK + length:
        check_size(path, BLOCK + length, found)
    elif zlib.crc32(content[BLOCK:]) != body_crc:
        found.faults.append(f"{path} is damaged: its content has changed since it was written.")
    else:
        found.notes.append(f"{path}: a whole checkpoint.")


def in_native_order(each, names):
    """Names of links. For any other order HDF5 makes a list of them; where their index is damaged it frees a list that it
    has not filled."""
    each(lambda name: names.append(name.decode()), idx_type=h5py.h5.INDEX_NAME, order=h5py.h5.ITER_NATIVE)


def read_frame(group):
    """Reads all of a frame, so that its checksums are looked at. Its time [s]."""
    names = []
    in_native_order(group.id.links.visit, names)
    items = [group[name] for name in names]
    for item in (group, *items):
        h5py.h5o.get_info(item.id)  # also parts that its numbers do not need, but some readers do
    tables = [item for item in items if isinstance(item, h5py.Dataset)]
    for table in tables:
        if table.chunks and table.id.get_num_chunks() != math.prod(-(-n // c) for n, c in zip(table.shape, table.chunks)):
            raise OSError(f"{table.name} lacks chunks")
        table[()]
    if not tables:
        raise OSError("it has no tables")
    return float(group.attrs["time"])


def read_frames(path, answer):
    """Sends names of all frames, times of those that are whole [s], names of those that are not, and why none can be read."""
    names, times, damaged, why = [], [], [], None
    try:
        file = h5py.File(path, "r")
        h5py.h5o.get_info(file.id)
        in_native_order(file.id.links.iterate, names)
        names = sorted(name for name in names if re.fullmatch(r"t\d+", name))
        for name in names:
            try:
                times.append(read_frame(file[name]))
            except (OSError, RuntimeError, KeyError, ValueError, TypeError):
                damaged.append(name)
    except (OSError, RuntimeError, KeyError, ValueError, TypeError) as error:
        why = str(error)
    answer.send((names, times, damaged, why))


def read_apart(path):
    """What read_frames sends, from a process of its own: HDF5 can keep what is damaged open, or end its process."""
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=read_frames, args=(path, sender))
    process.start()
    sender.close()
    try:
        return receiver.recv()
    except EOFError:
        return [], [], [], "it ends the program that reads it"
    finally:
        process.join()


def check_frames(folder, guide, found, name="fields.h5", what="frame"):
    """Reads all frames of a file. guide: names of those that fields.xdmf lists, or None. Times of those that are whole [s]."""
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        if guide:
            found.faults.append(f"{path} is missing, though fields.xdmf lists {len(guide)} frames of it.")
        return []
    names, times, damaged, why = read_apart(path)
    if why:
        found.faults.append(f"{path} can't be read by HDF5 ({why}); its {what}s are lost or their names are damaged.")
        return []
    last = max([int(name[1:]) for name in names] + [int(name[1:]) for name in guide or []], default=-1)
    missing = [f"t{k:05d}" for k in range(last + 1) if f"t{k:05d}" not in names]
    for faults, state in ((damaged, "damaged"), (missing, "missing")):
        if faults:
            shown = ", ".join(faults[:10]) + (f" and {len(faults) - 10} more" if len(faults) > 10 else "")
            found.faults.append(f"{path}: {state}: {shown}, of {last + 1} {what}s.")
    if any(later <= earlier for earlier, later in zip(times, times[1:])):
        found.faults.append(f"{path}: the times of its {what}s do not grow.")
    if not damaged and not missing:
        found.notes.append(f"{path}: {len(names)} whole {what}{'' if len(names) == 1 else 's'}.")
    return times


def check_guide(folder, found):
    """Names of the frames that fields.xdmf lists, or None where there is none."""
    path = os.path.join(folder, "fields.xdmf")
    if not os.path.exists(path):
        return None
    text, mark, rest = read_bytes(path).rpartition(b"<!-- crc32 of the lines above: ")
    if not mark or rest != b"%d -->\n" % zlib.crc32(text):
        found.faults.append(f"{path} has changed since the run wrote it (its checksum is another), or is of an older version.")
        return None
    return sorted({name.decode() for name in re.findall(rb":/(t\d+)/", text)})


def check_history(folder, manifest, found):
    """Times of the rows [s], or None where they can't be read."""
    path = os.path.join(folder, "history.csv")
    if not os.path.exists(path):
        return None
    text = read_bytes(path)
    ended = manifest.get("ended", False)
    entry = manifest.get("files", {}).get("history.csv")
    if entry:
        check_text(path, entry, ended, found)
    whole = text[: text.rfind(b"\n") + 1]
    if whole != text and ended:
        found.faults.append(f"{path}: its last row is cut off.")
    try:
        rows = list(csv.reader(io.StringIO(whole.decode(), newline="")))
        table = np.array([[float(value) for value in row] for row in rows[1:]])
        if any(len(row) != len(rows[0]) for row in rows):
            raise ValueError("rows of different lengths")
        times = table[:, 0] if table.size else np.zeros(0)
    except (ValueError, IndexError, UnicodeDecodeError) as error:
        found.faults.append(f"{path} can't be read as a table of numbers ({error}).")
        return None
    if np.any(np.diff(times) <= 0.0):
        found.faults.append(f"{path}: the times of its rows do not grow.")
    if not ended:
        later = whole[entry["bytes"] if entry else 0 :].count(b"\n")
        if later:
            found.notes.append(f"{path}: {later} of its {max(len(rows), 1)} lines have no checksum yet.")
    found.notes.append(f"{path}: {len(times)} rows.")
    return times


def check_fronts(folder, manifest, found):
    """Values along fronts: both files have the same samples, but for the last one of a run that was cut off while it wrote."""
    samples = check_frames(folder, None, found, "fronts.h5", "sample")
    path = os.path.join(folder, "fronts.csv")
    if not os.path.exists(path):
        if samples:
            found.faults.append(f"{path} is missing, though fronts.h5 has {len(samples)} samples.")
        return
    text = read_bytes(path)
    whole = text[: text.rfind(b"\n") + 1]
    try:
        rows = list(csv.reader(io.StringIO(whole.decode(), newline="")))
        times = sorted({float(row[0]) for row in rows[1:]})
        if any(len(row) != len(rows[0]) for row in rows):
            raise ValueError("rows of different lengths")
    except (ValueError, IndexError, UnicodeDecodeError) as error:
        found.faults.append(f"{path} can't be read as a table ({error}).")
        return
    ended = manifest.get("ended", False)
    if whole != text and ended:
        found.faults.append(f"{path}: its last row is cut off.")
    if times != samples and (ended or times != samples[:-1]):
        found.faults.append(f"{folder}: fronts.csv has {len(times)} samples and fronts.h5 has {len(samples)} whole ones, or their times differ.")
    found.notes.append(f"{path}: {max(len(rows) - 1, 0)} rows.")


def check_summary(folder, manifest, found):
    path = os.path.join(folder, "summary.json")
    if not os.path.exists(path):
        if manifest.get("ended") and "summary.json" not in manifest["files"]:
            found.faults.append(f"{path} was never written.")
        return None
    try:
        summary = json.loads(read_bytes(path).decode())
        return summary if isinstance(summary, dict) else None
    except ValueError as error:
        found.faults.append(f"{path} can't be read ({error}).")
        return None


def longest_without_row(rows, summary):
    """How long a run may go on without a row [s]: a row ends the first step that passes an interval, so that a run that fails
    may have passed one interval and one step since its last row. Summaries of older versions have no interval, which a few rows
    do not show."""
    if "history_interval" not in summary and len(rows) < 3:
        return math.inf
    steps = summary.get("steps") or 1
    interval = summary.get("history_interval") or 0.0
    return (max(interval, np.max(np.diff(rows), initial=0.0)) + summary["time"] / steps) * (1 + 1e-9)


def compare_times(folder, rows, frames, summary, found):
    """Rows against frames and the summary."""
    end = None if summary is None else summary.get("time")
    last = rows[-1] if rows is not None and len(rows) else None
    if end is not None and last is not None and end - last > longest_without_row(rows, summary):
        found.faults.append(f"{folder}: the history ends at {last:.6g} s, but the run at {end:.6g} s: its last rows are missing.")
    elif frames and last is not None and frames[-1] > last * (1 + 1e-9) and end is not None and last < end * (1 - 1e-9):
        found.faults.append(f"{folder}: the last frame is of {frames[-1]:.6g} s, but the history ends at {last:.6g} s.")
    for what, time in (("the history", last), ("the last frame", frames[-1] if frames else None)):
        if end is not None and time is not None and time > end * (1 + 1e-9):
            found.faults.append(f"{folder}: {what} goes to {time:.6g} s, but the summary to {end:.6g} s.")


def check_status(folder, summary, found):
    """A run that could not write a file has left less than it should."""
    status = summary.get("status") if summary else None
    if isinstance(status, str) and UNWRITTEN in status:
        found.faults.append(f"{folder}: not all could be written: {status}.")


def went_to_its_end(summary):
    """Whether nothing stopped the run of a summary. One of an older version has only a status in words."""
    end = summary.get("end")
    return end in WENT_TO_ITS_END if isinstance(end, str) else str(summary.get("status")).startswith("finished")


def how_it_ended(folder, summary):
    """Of a run that has ended: how."""
    status = summary.get("status") if summary else None
    if not isinstance(status, str) or not status:
        return f"How the run in {folder} ended is not known: {folder}/summary.json does not say it."
    if not went_to_its_end(summary):
        if status.startswith(("the run stopped", "the run was stopped")):
            return f"{status[0].upper()}{status[1:]}."
        return f"The run did not come to its end: {status}."
    time, steps = summary.get("time"), summary.get("steps")
    at = f" at t = {time:.6g} s" if isinstance(time, (int, float)) else ""
    after = f" after {steps} step{'' if steps == 1 else 's'}" if isinstance(steps, int) else ""
    notes = {"cut off": ", before Time > Final Time", "not at rest": ", before the bodies were at rest"}
    return f"The run {status}{at}{after}{notes.get(summary.get('end'), '')}."


def check_listed(folder, manifest, found):
    """The files that the manifest lists."""
    for name, entry in manifest.get("files", {}).items():
        path = os.path.join(folder, name)
        if not os.path.exists(path):
            if entry["bytes"]:
                found.faults.append(f"{path} is missing, but the run wrote it.")
        elif name in ("fields.h5", "fronts.h5"):  # with checksums of their own
            check_size(path, entry["bytes"], found)
        elif name != "history.csv" and "crc32" in entry:
            check_text(path, entry, True, found)


def no_manifest(folder):
    """What a folder without a manifest is."""
    runs = [name for name in ("as_is", "half") if os.path.isdir(os.path.join(folder, name))]
    if runs and os.path.exists(os.path.join(folder, "twice.json")):
        return f"{folder} has no manifest.json; it is of rhegma --twice, whose runs are in {' and '.join(runs)}: check these."
    return f"{folder} has no manifest.json: no run wrote it, or one of an older version, or one that was cut off at once."


def how_it_stands(folder, faults):
    """Of a run that has not ended: whether it goes on, and whether its checkpoint, if it has no fault, continues it."""
    if is_running(folder):
        return f"A run is going on in {folder}."
    if os.path.exists(os.path.join(folder, "run.lock")) and is_running(folder) is None:
        return f"A run of another machine may be going on in {folder}: {folder}/run.lock says which."
    checkpoint = os.path.join(folder, "checkpoint.h5")
    if os.path.exists(checkpoint) and not any(checkpoint in fault for fault in faults):
        return f"The run in {folder} was cut off: --output {folder} --restart {checkpoint} continues it."
    return f"The run in {folder} was cut off and has no {'whole ' if os.path.exists(checkpoint) else ''}checkpoint: run it again."


def check_folder(folder):
    """All that can be said of the files of a run. Found."""
    found = Found()

    def read(check, *arguments, failed=None):
        return attempt(check, folder, *arguments, found=found, failed=failed)

    manifest = read(read_manifest, folder, failed={})
    found.ended = bool(manifest.get("ended"))
    if not manifest and not found.faults and not os.path.exists(os.path.join(folder, "run.lock")):
        found.faults.append(no_manifest(folder))
    read(check_listed, folder, manifest)
    read(check_scene, folder, manifest)
    read(check_checkpoint, folder)
    frames = read(check_frames, folder, read(check_guide, folder), failed=[])
    read(check_fronts, folder, manifest)
    rows = read(check_history, folder, manifest)
    summary = read(check_summary, folder, manifest)
    read(compare_times, folder, rows, frames, summary)
    read(check_status, folder, summary)
    if found.ended:
        found.how = how_it_ended(folder, summary)
        found.ended = summary is not None and went_to_its_end(summary)
    elif manifest or os.path.exists(os.path.join(folder, "run.lock")):
        found.how = how_it_stands(folder, found.faults)
    return found
