"""Runs a tool as a user does. Import this first: it finds a Python that has what the tools need."""

import os
import struct
import subprocess
import sys

HERE = os.path.dirname(os.path.realpath(__file__))

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(HERE, ".."))
from own_folder import TOOLS, OwnFolder  # noqa: E402

sys.path.insert(0, TOOLS)
from rhegma_tools import interpreter  # noqa: E402

interpreter.need("numpy", "h5py", "matplotlib")


def run(tool, *arguments, python=sys.executable, **environment):
    """(exit status, standard output, standard error)"""
    result = subprocess.run(
        [python, os.path.join(TOOLS, tool), *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        universal_newlines=True,
        env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1", **environment),
    )
    return result.returncode, result.stdout, result.stderr


def picture_size(path):
    """Width and height of a PNG in pixels, from its header."""
    with open(path, "rb") as file:
        head = file.read(24)
    assert head[:8] == b"\x89PNG\r\n\x1a\n", path
    return struct.unpack(">II", head[16:24])


class ToolTest(OwnFolder):
    """Refuses messages of more than one line."""

    def assert_fails(self, answer, *words):
        """Exit status 1, nothing on standard output, one line with these words on standard error."""
        status, output, messages = answer
        self.assertEqual(status, 1, messages)
        self.assertEqual(output, "")
        self.assertEqual(messages.count("\n"), 1, messages)
        self.assertTrue(messages.startswith("rhegma-"), messages)
        for word in words:
            self.assertIn(word, messages)
