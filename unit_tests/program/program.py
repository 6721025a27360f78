"""Runs rhegma as a user does and looks at its exit status, its words and the file system."""

import hashlib
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), ".."))
sys.dont_write_bytecode = True

from own_folder import SOURCE, OwnFolder  # noqa: E402

PROGRAM = os.environ.get("RHEGMA_PROGRAM", os.path.join(SOURCE, "build", "rhegma"))

# Messages of a defect, which a user should never read.
NOISE = (
    "terminate called",
    "what():",
    "Throw number",
    "Teuchos",
    "std::",
    "MPI_ABORT",
    "*** Process received signal",
    "Backtrace",
    "HDF5-DIAG",
    "Segmentation",
    "Kokkos::",
    "a defect of the program",
)

# A guard against runs that hang [s]: no run of these tests takes as long, even on a machine that has much else to do. It measures
# nothing, and is less than what ctest gives a whole test, so that its message is printed.
PATIENCE = 1200


class Answer:
    def __init__(self, status, output, messages):
        self.status = status
        self.output = output
        self.messages = messages

    def __str__(self):
        return f"exit status {self.status}\nstdout: {self.output}\nstderr: {self.messages}"


# Rates of scenes that --check keeps; not those of the user who runs the tests.
CACHE = os.path.join(tempfile.gettempdir(), f"rhegma-tests-{os.getuid()}")


def environment(more=None):
    settings = {"OMP_NUM_THREADS": "1", "OMP_PROC_BIND": "false", "XDG_CACHE_HOME": CACHE}
    return dict(os.environ, **{**settings, **(more or {})})


def rhegma(*arguments, cwd=None, launcher=(), timeout=PATIENCE, preexec=None, **variables):
    result = subprocess.run(
        [*launcher, PROGRAM, *arguments],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        cwd=cwd,
        env=environment(variables),
        timeout=timeout,
        preexec_fn=preexec,
    )
    return Answer(result.returncode, result.stdout.decode(errors="replace"), result.stderr.decode(errors="replace"))


def fingerprint(folder):
    """Name, time of change and content of everything below a folder."""
    found = {}
    for root, folders, files in os.walk(folder):
        for name in folders:
            found[os.path.relpath(os.path.join(root, name), folder)] = "folder"
        for name in files:
            path = os.path.join(root, name)
            changed = os.lstat(path).st_mtime_ns
            content = "special"
            if os.path.isfile(path) and os.access(path, os.R_OK):
                with open(path, "rb") as file:
                    content = hashlib.sha256(file.read()).hexdigest()
            found[os.path.relpath(path, folder)] = (changed, content)
    return found


class ProgramTest(OwnFolder):
    """Its scene lies next to the results of an older run."""

    def leave_an_older_run(self, *names):
        """Results that no wrong scene may touch."""
        os.makedirs(self.path(*names))
        for name in ("summary.json", "history.csv", "fields.h5", "fields.xdmf", "notes.txt"):
            self.write(os.path.join(*names, name), f"an older {name}\n")

    def assert_messages(self, messages, mistakes):
        """One line on standard error for each (where, words), in any order."""
        lines = messages.splitlines()
        self.assertEqual(len(lines), len(mistakes), messages)
        for line in lines:
            self.assertTrue(line.startswith("rhegma: "), messages)
            self.assertFalse(line.startswith("rhegma: rhegma"), messages)
            self.assertLess(len(line), 600, "not a message but a page")
        for noise in NOISE:
            self.assertNotIn(noise, messages)
        for where, words in mistakes:
            start = f"rhegma: {where}: " if where else "rhegma: "
            fitting = [line for line in lines if line.startswith(start) and all(word in line for word in words)]
            self.assertEqual(len(fitting), 1, f"one message {start!r} with {words}, in\n{messages}")

    def assert_refused(self, arguments, mistakes):
        """Exit status 1, one message a mistake, no other word, and no trace in the file system."""
        before = fingerprint(self.folder)
        answer = rhegma(*arguments, cwd=self.folder)
        self.assertEqual(answer.status, 1, answer)
        self.assertEqual(answer.output, "", answer)
        # Warnings of the same scene stand behind its errors.
        errors = [line for line in answer.messages.splitlines(True) if not line.startswith("rhegma: warning: ")]
        self.assert_messages("".join(errors), mistakes)
        self.assertEqual(fingerprint(self.folder), before, answer)
        return answer
