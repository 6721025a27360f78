"""Tests of rhegma-law: what it says of sources and compilers; laws themselves are tested with the program."""

import os
import shutil
import unittest

from tool import ToolTest, run

LAW = "void vumat(void) {}\n"
COUNTS = "unsigned short vumat_nMaterialProperties = 3;\n"


@unittest.skipUnless(shutil.which("cc"), "there is no compiler")
class Laws(ToolTest):
    def law(self, text, **environment):
        return run("rhegma-law", self.write("law.c", text), **environment)

    def test_a_law(self):
        self.assertEqual(self.law(LAW + COUNTS), (0, f"Behaviour: vumat, Interface: VUMAT, constants: 3, state variables: not exported\nLibrary File: "
                                                  f"{self.path('law.so')}\n", ""))
        self.assertEqual(sorted(os.listdir(self.folder)), ["law.c", "law.so"])

    def test_a_library_that_ends_the_program_that_loads_it(self):
        begin = "#include <signal.h>\n#include <stdlib.h>\n#include <unistd.h>\n__attribute__((constructor)) static void begin(void) {{ {} }}\n"
        for what, words in (("raise(SIGSEGV);", "with signal 11"), ("abort();", "with signal 6"), ("_exit(0);", "with exit status 0")):
            with self.subTest(what):
                self.assert_fails(self.law(begin.format(what) + LAW), "law.so: ends the program that loads it", words)

    def test_what_a_library_prints_is_no_answer(self):
        begin = '#include <stdio.h>\n__attribute__((constructor)) static void begin(void) { puts("{}"); fflush(stdout); }\n'
        status, output, messages = self.law(begin + LAW)
        self.assertEqual((status, messages), (0, ""))
        self.assertTrue(output.startswith("Behaviour: vumat"), output)

    def test_a_library_that_lacks_a_name(self):
        self.assert_fails(self.law("void other(void);\n" + "void vumat(void) { other(); }\n"
                                   "void (*address)(void) = other;\n"), "can't be loaded", "other")

    def test_a_compiler_that_writes_nothing(self):
        self.assert_fails(self.law(LAW, CC="true"), "true ends without an error and without a library; set CC to a compiler")
        self.assertEqual(os.listdir(self.folder), ["law.c"])
