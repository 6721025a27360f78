#!/usr/bin/env python3
"""Every wrong scene of the table: refused in one message a mistake, and nothing written."""

import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import ball, plate  # noqa: E402
from wrong_scenes import TABLE  # noqa: E402


class RightScenes(ProgramTest):
    """The scenes that the table makes wrong, so that a row reports its own change."""

    def test_they_run(self):
        for name, scene in (("plate", plate()), ("ball", ball())):
            path = self.write(f"{name}.xml", scene.text())
            answer = rhegma(path, "--quiet")
            self.assertEqual((answer.status, answer.output, answer.messages), (0, "", ""), answer)
            self.assertTrue(os.path.exists(self.path(f"{name}.out", "summary.json")))


class WrongScenes(ProgramTest):
    def refuse(self, scene, mistakes):
        self.leave_an_older_run("scene.out")
        self.write("scene.xml", scene.text())
        self.assert_refused(["scene.xml"], mistakes)  # into the default folder, where an older run lies
        self.assert_refused(["scene.xml", "--output", "new/folder"], mistakes)
        self.assert_refused(["scene.xml", "--check"], mistakes)


def add(name, scene, mistakes):
    setattr(WrongScenes, "test_" + name, lambda self: self.refuse(scene, mistakes))


for row in TABLE:
    assert not hasattr(WrongScenes, "test_" + row[0]), row[0]
    add(*row)
assert len(TABLE) >= 40, len(TABLE)

if __name__ == "__main__":
    unittest.main()
