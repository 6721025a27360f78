#!/usr/bin/env python3
"""All tests of colours, of pictures of scenes, in 3D and of films at once: python3 test_pictures.py."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True
import unittest  # noqa: E402

from colour_tests import *  # noqa: E402,F401,F403
from film_tests import *  # noqa: E402,F401,F403
from front_map_tests import *  # noqa: E402,F401,F403
from scene_tests import *  # noqa: E402,F401,F403
from spatial_tests import *  # noqa: E402,F401,F403

if __name__ == "__main__":
    unittest.main()
