#!/usr/bin/env python3
"""All tests of the other tools at once, without rhegma-report and pictures of scenes, in 3D and films: python3 test_tools.py."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True
import unittest  # noqa: E402

from accuracy_tests import *  # noqa: E402,F401,F403
from check_tests import *  # noqa: E402,F401,F403
from extension_tests import *  # noqa: E402,F401,F403
from history_tests import *  # noqa: E402,F401,F403
from law_tests import *  # noqa: E402,F401,F403
from limits_tests import *  # noqa: E402,F401,F403
from output_tests import *  # noqa: E402,F401,F403
from parts_tests import *  # noqa: E402,F401,F403
from plot_tests import *  # noqa: E402,F401,F403
from same_tests import *  # noqa: E402,F401,F403
from stream_tests import *  # noqa: E402,F401,F403
from study_tests import *  # noqa: E402,F401,F403

if __name__ == "__main__":
    unittest.main()
