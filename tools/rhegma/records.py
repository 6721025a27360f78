"""Records of finished runs of studies and sweeps, by which a run that was done before is not repeated."""

from __future__ import annotations

import hashlib
import json
import os
import re
from typing import Any, Mapping

from .program import FINISHED

RECORD = "study_run.json"  # in a run's folder: what was run


def plain(text: str) -> str:
    """A text as a part of the name of a folder."""
    return re.sub(r"[^A-Za-z0-9.+-]+", "-", text).strip("-") or "x"


def folder_name(settings: Mapping[str, str], identity: Any) -> str:
    """A name that follows from settings {path: text} with colons or " > " between the names of a path: the values, and a digest of the
    identity (any value that JSON has) that distinguishes similar ones."""
    digest = hashlib.sha256(json.dumps(identity).encode()).hexdigest()[:8]
    values = "_".join(plain(f"{re.split(':| > ', path)[-1]}-{value}") for path, value in settings.items())[:80]
    return f"{values}_{digest}" if values else digest


def done_before(folder: str, record: Mapping[str, Any]) -> int | None:
    """The exit status of the same run if the folder holds it whole; else None."""
    try:
        with open(os.path.join(folder, RECORD), encoding="utf-8") as file:
            found = json.load(file)
    except (OSError, ValueError):
        return None
    status = found.pop("exit", None) if isinstance(found, dict) else None
    if isinstance(found, dict):
        found.pop("processor_seconds", None)
    finished = os.path.exists(os.path.join(folder, "summary.json"))
    return status if found == record and status in FINISHED and finished else None


def forget(folder: str) -> None:
    """Makes the folder of a run, and removes what would pass for this run's from an older one."""
    os.makedirs(folder, exist_ok=True)
    for name in ("summary.json", RECORD):
        if os.path.exists(os.path.join(folder, name)):
            os.remove(os.path.join(folder, name))


def write_record(folder: str, record: Mapping[str, Any], status: int, seconds: float | None) -> None:
    """Records a run that has ended. status: its exit status; seconds: its processor time [s], where it is known"""
    with open(os.path.join(folder, RECORD), "w", encoding="utf-8") as file:
        json.dump(dict(record, exit=status, processor_seconds=seconds), file, indent=1)
