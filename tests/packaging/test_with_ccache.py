"""A header that is precompiled and changed is compiled anew, with ccache as well."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROJECT = f"""
cmake_minimum_required(VERSION 3.25)
project(Small LANGUAGES CXX)
set(UNDERACT_CCACHE ON)
set(CMAKE_UNITY_BUILD OFF CACHE BOOL "")
include({ROOT}/cmake/compiling.cmake)
add_executable(small main.cpp)
target_precompile_headers(small PRIVATE <number.h>)
target_include_directories(small PRIVATE .)
"""


@unittest.skipUnless(shutil.which("ccache"), "ccache is not installed")
class WithCcache(unittest.TestCase):
    def run_in(self, folder, *words):
        done = subprocess.run(
            words,
            cwd=folder,
            env={
                **os.environ,
                "CCACHE_DIR": f"{folder}/cache",
                "CCACHE_BASEDIR": folder,
                "CCACHE_NOHASHDIR": "1",
            },
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_a_header_that_has_changed_is_precompiled_anew(self):
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            (place / "CMakeLists.txt").write_text(PROJECT)
            (place / "main.cpp").write_text(
                '#include "number.h"\n#include <cstdio>\nint main() { std::printf("%d", kNumber); }\n'
            )
            for number in (1, 2, 1, 3):
                if number == 1:  # another checkout, which gets the same first one out of the cache
                    shutil.rmtree(place / "build", ignore_errors=True)
                (place / "number.h").write_text(
                    f"#pragma once\ninline constexpr int kNumber = {number};\n"
                )
                self.run_in(folder, "cmake", "-S", ".", "-B", "build", "-G", "Ninja")
                self.run_in(folder, "cmake", "--build", "build")
                self.assertEqual(self.run_in(folder, "build/small"), str(number))


if __name__ == "__main__":
    unittest.main()
