"""Each file alone: what is wrong with one that the files before it would hide is found, and no code is made."""

import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent


class EachAlone(unittest.TestCase):
    """A project of two files and a precompiled header, as CMake would have configured it."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="each_alone_")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        self.build = self.folder / "build"
        self.build.mkdir()
        (self.folder / "tests/architecture").mkdir(parents=True)
        shutil.copy(HERE / "each_alone", self.folder / "tests/architecture/each_alone")
        self.commands = []
        self.compiles("build/cmake_pch.hxx.cxx", "", "-x c++-header -o all.gch -c")
        self.compiles("good.cpp", "#include <cmath>\ndouble two() { return std::sqrt(4.0); }\n", "-o good.o -c")

    def compiles(self, name, text, options):
        """One file more."""
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        command = f"c++ -std=c++20 {options} {path}"
        self.commands.append({"directory": str(self.build), "file": str(path), "command": command})

    def look(self):
        """How it ended, and what it said."""
        (self.build / "compile_commands.json").write_text(json.dumps(self.commands), encoding="utf-8")
        run = [self.folder / "tests/architecture/each_alone", self.build]
        done = subprocess.run(run, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def test_good_files_pass_and_no_code_is_made(self):
        status, said = self.look()
        self.assertEqual((status, said.splitlines()[-1]), (0, "1 files, each alone: 0 wrong"))
        self.assertFalse((self.build / "good.o").exists())

    def test_a_name_that_another_file_would_bring_is_missed(self):
        self.compiles("hidden.cpp", "double three() { return std::sqrt(9.0); }\n", "-o hidden.o -c")
        status, said = self.look()
        self.assertEqual((status, said.splitlines()[-1]), (1, "2 files, each alone: 1 wrong"))
        self.assertIn("hidden.cpp", said)

    def test_a_name_in_a_function_that_hides_one_of_the_file_is_wrong(self):
        self.compiles("hides.cpp", "const int kOne = 1;\nint one() { int kOne = 2; return kOne; }\n", "-o hides.o -c")
        status, said = self.look()
        self.assertEqual((status, said.splitlines()[-1]), (1, "2 files, each alone: 1 wrong"))
        self.assertIn("kOne", said)

    def test_a_header_that_does_not_compile_is_told(self):
        self.compiles("build/cmake_pch.hxx.cxx", "#error no\n", "-x c++-header -o all.gch -c")
        status, said = self.look()
        self.assertNotEqual(status, 0)
        self.assertIn("does not compile", said)

    def test_without_files_or_headers_it_says_so(self):
        whole = self.commands
        self.commands = whole[:1]
        self.assertIn("nothing is compiled", self.look()[1])
        self.commands = whole[1:]
        self.assertIn("precompiles no headers", self.look()[1])


if __name__ == "__main__":
    unittest.main()
