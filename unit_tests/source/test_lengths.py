#!/usr/bin/env python3
"""Functions stay short and classes stay in one place: what is left over the limits may only become less."""

import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True
import lengths  # noqa: E402

ROOT = os.environ.get("RHEGMA_SOURCE_DIR") or os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))

# How many there are. Who shortens one lowers the number; none may be added.
OVER_60, OVER_100, IN_MORE_THAN_TWO_FILES = 1, 0, 0

SAMPLE = """#include <vector>

namespace Rhegma
{

namespace
{

struct Point
{
  double x() const
  {
    return 0.0;
  }
};

} // namespace

template <class T>
void Box<T>::fill(std::vector<T>& values,
                  int count)
{
  const auto one = [&](int i)
  {
    values[i] = T();
  };
  for (int i = 0; i < count; ++i)
  {
    one(i);
  }
}

int Box<int>::count() const { return 1; }

} // namespace Rhegma
"""


class Sources(unittest.TestCase):
    def assert_at_most(self, found, most, what):
        lines = "\n  ".join(" ".join(map(str, entry)) for entry in found)
        self.assertLessEqual(len(found), most, f"{len(found)} {what}, where {most} are allowed:\n  {lines}")

    def test_functions_over_60_lines(self):
        self.assert_at_most(lengths.long_functions(ROOT, 60), OVER_60, "functions are longer than 60 lines")

    def test_functions_over_100_lines(self):
        self.assert_at_most(lengths.long_functions(ROOT, 100), OVER_100, "functions are longer than 100 lines")

    def test_classes_in_more_than_two_files(self):
        self.assert_at_most(list(lengths.spread_classes(ROOT, 2).items()), IN_MORE_THAN_TWO_FILES,
                            "classes are implemented in more than two .cpp files")


class Heuristics(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.root = keeper.name
        os.makedirs(os.path.join(self.root, "src", "box"))
        os.makedirs(os.path.join(self.root, "packages"))
        for name in ("Box.cpp", "Fill.cpp"):
            with open(os.path.join(self.root, "src", "box", name), "w", encoding="utf-8") as file:
                file.write(SAMPLE)

    def test_finds_functions_and_methods(self):
        found = lengths.functions(os.path.join(self.root, "src", "box", "Box.cpp"))
        self.assertEqual(found, [("x", 11, 1), ("Box<T>::fill", 19, 8)])

    def test_sorts_by_length(self):
        self.assertEqual([entry[0] for entry in lengths.long_functions(self.root, 0)], [8, 8, 1, 1])
        self.assertEqual(len(lengths.long_functions(self.root, 7)), 2)

    def test_finds_classes_in_several_files(self):
        self.assertEqual(lengths.spread_classes(self.root, 1), {"src/box Box": ["Box.cpp", "Fill.cpp"]})
        self.assertEqual(lengths.spread_classes(self.root, 2), {})


if __name__ == "__main__":
    unittest.main()
