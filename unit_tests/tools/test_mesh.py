#!/usr/bin/env python3
"""Tests of rhegma-mesh: python3 test_mesh.py."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True
import unittest  # noqa: E402

import tool  # noqa: E402,F401  (first, since it finds a Python with NumPy)
from mesh_tests import *  # noqa: E402,F401,F403

if __name__ == "__main__":
    unittest.main()
