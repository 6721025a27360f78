#!/usr/bin/env python3
"""All tests of rhegma-report at once: python3 test_report.py."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True
import unittest  # noqa: E402

from browser_tests import *  # noqa: E402,F401,F403
from report_tests import *  # noqa: E402,F401,F403
from verdict_tests import *  # noqa: E402,F401,F403

if __name__ == "__main__":
    unittest.main()
