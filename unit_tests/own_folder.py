"""A folder for each test of the program and of the tools."""

import os
import sys
import tempfile
import unittest

SOURCE = os.path.realpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), ".."))
TOOLS = os.path.join(SOURCE, "tools")

sys.dont_write_bytecode = True


class OwnFolder(unittest.TestCase):
    """A test with a folder of its own, self.folder, which goes when it ends."""

    longMessage = True

    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.folder = keeper.name

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return self.path(name)
