"""What somebody types who has not read how we build: it configures, and no warning ends it."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def compilers(commands):
    """The names of those that the commands call, without what stands before them, such as ccache."""
    before = [command[: next(at for at, word in enumerate(command) if word.startswith("-"))] for command in commands]
    return {os.path.basename(words[-1]) for words in before}


class PlainBuilds(unittest.TestCase):
    def configured(self, *words, **more):
        """(kind of build, every command that compiles) of one in a folder of its own, with MORE in the environment."""
        with tempfile.TemporaryDirectory(prefix="under act ") as folder:
            done = subprocess.run(
                ["cmake", *words, "-B", folder, f"-DUNDERACT_GUI={os.environ['UNDERACT_GUI']}"]
                + ["-DUNDERACT_BENCH=OFF"],  # whose library a newcomer has not
                cwd=ROOT,
                env={**{name: value for name, value in os.environ.items() if name not in ("CC", "CXX")}, **more},
                capture_output=True,
                text=True,
                check=False,
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(os.path.join(folder, "compile_commands.json"), encoding="utf-8") as file:
                commands = [row["command"].split() for row in json.load(file)]
            with open(os.path.join(folder, "CMakeCache.txt"), encoding="utf-8") as file:
                cache = dict(row.split("=", 1) for row in file.read().splitlines() if "=" in row)
        self.assertGreater(len(commands), 20)
        return cache.get("CMAKE_BUILD_TYPE:STRING"), commands

    def test_without_a_type_it_is_an_optimised_one(self):
        kind, commands = self.configured("-S", ".")
        self.assertEqual(kind, "RelWithDebInfo")
        self.assertNotRegex("".join(compilers(commands)), "clang")
        for command in commands:
            self.assertIn("-O2", command)
            self.assertNotIn("-Werror", command)

    def test_a_type_that_is_named_stays(self):
        for named, flag in (("Release", "-O3"), ("Debug", "-g")):
            kind, commands = self.configured("-S", ".", f"-DCMAKE_BUILD_TYPE={named}")
            self.assertEqual(kind, named)
            for command in commands:
                self.assertIn(flag, command)
                self.assertNotIn("-Werror", command)

    def test_warnings_are_errors_with_the_preset_of_ci_alone(self):
        presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
        rows = {row["name"]: row.get("cacheVariables", {}) for row in presets["configurePresets"]}
        self.assertNotIn("CMAKE_COMPILE_WARNING_AS_ERROR", {**rows["base"], **rows["release"]})
        for command in self.configured("--preset", "ci", "-DUNDERACT_TESTS=OFF")[1]:
            self.assertIn("-Werror", command)

    def test_the_presets_take_the_oldest_clang_that_will_do(self):
        clang = [f"clang++-{version}" for version in range(15, 30) if shutil.which(f"clang++-{version}")]
        if not clang:
            self.skipTest("no clang from 15 on")
        self.assertEqual(compilers(self.configured("--preset", "release", "-DUNDERACT_TESTS=OFF")[1]), {clang[0]})

    def test_packages_have_lines_for_debuggers_and_what_a_newcomer_builds_has_none(self):
        for preset, options in (("release", []), ("package", ["-g1"])):
            for command in self.configured("--preset", preset, "-DUNDERACT_TESTS=OFF")[1]:
                self.assertEqual([word for word in command if word.startswith("-g")], options)
                self.assertIn("-O2", command)

    def test_a_compiler_that_is_named_is_taken(self):
        preset = ("--preset", "release", "-DUNDERACT_TESTS=OFF")
        self.assertEqual(compilers(self.configured(*preset, CC="gcc", CXX="g++")[1]), {"g++"})
        named = ("-DCMAKE_C_COMPILER=gcc", "-DCMAKE_CXX_COMPILER=g++")
        self.assertEqual(compilers(self.configured(*preset, *named)[1]), {"g++"})

    def test_folders_with_blanks_brackets_and_quotes_are_built_in(self):
        with tempfile.TemporaryDirectory() as folder:
            odd = pathlib.Path(folder) / "under'act (1) \u00fc & co + @ ~ {} %20!"
            shutil.copytree(ROOT, odd, ignore=shutil.ignore_patterns("build*", ".git", "*.pyc"))
            for words in ["-DUNDERACT_GUI=OFF"], ["--build", "--target", "underact_base"]:
                done = subprocess.run(
                    ["cmake", *words, "--preset", "release"], cwd=odd, capture_output=True, text=True, check=False
                )
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_folders_that_a_tool_would_misread_are_refused_by_their_names(self):
        for sign in (*';"$#*?=:,`|[]<>', "${HOME}", "[1]"):
            with self.subTest(sign), tempfile.TemporaryDirectory() as folder:
                odd = pathlib.Path(folder) / f"a{sign}b"
                for part in ("CMakeLists.txt", "cmake/folder_names.cmake", "packaging/install-deps"):
                    (odd / part).parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy(ROOT / part, odd / part)
                for words in ["cmake", "-S", ".", "-B", "build"], ["packaging/install-deps", "run"]:
                    done = subprocess.run(words, cwd=odd, capture_output=True, text=True, check=False)
                    said = " ".join(done.stderr.split())
                    self.assertNotEqual(done.returncode, 0)
                    self.assertIn(f"The folder {odd} cannot be built in".lower(), said.lower())
                    self.assertIn("Rename it, or move the sources to another folder", said)


if __name__ == "__main__":
    unittest.main()
