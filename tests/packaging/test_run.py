"""packaging/run with everything it calls replaced: what is asked for, and when no more is done."""

import re
import unittest

from stand_ins import CALLED, ROOT, Scripts

# Of the build: a program that says what it was started with, and from where.
CMAKE = (
    CALLED
    + """case "$*" in
*--preset*--target*|*--build*)
  echo "@0 2 0.0 Re-checking globbed directories..."
  echo "@1 2 9.1 one"; echo "a warning"; echo "@2 2 18.2 two"
  [ -z "${BREAK:-}" ] || { echo "FAILED: two"; exit 7; }
  printf '#!/bin/sh\\necho "started in $(pwd) with $*"\\n' >build/release/underact
  chmod +x build/release/underact ;;
*) mkdir -p build/release; : >build/release/build.ninja ;;
esac
"""
)


class Run(Scripts):
    COPIES = ("packaging/run", "packaging/compile")
    STAND_INS = {
        "packaging/install-deps": CALLED + "exit ${INSTALLED:-0}\n",
        "bin/cmake": CMAKE,
    }

    def run_it(self, *words, **more):
        """What it says, and the calls it made."""
        return self.call("packaging/run", *words, **{"DISPLAY": ":0", **more})

    def test_it_installs_configures_and_builds_the_programs_alone_and_starts_the_window(self):
        done, calls = self.run_it("scenes/02_sphere.json", "--dark")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(calls[0], "install-deps run")
        self.assertEqual(calls[1], "cmake --preset release -DUNDERACT_TESTS=OFF")
        self.assertEqual(len(calls), 3)
        self.assertTrue(done.stdout.endswith("started in /usr with scenes/02_sphere.json --dark\n"))

    def test_the_programs_that_are_built_are_all_that_people_start(self):
        _, calls = self.run_it()
        targets = set(calls[2].split("--target ")[1].split())
        rooms = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
        programs = set(re.findall(r"PROGRAM (\S+) COMPONENT", rooms))
        self.assertGreaterEqual(len(programs), 3)
        self.assertEqual(targets, programs)  # and build_products_built_with, that each brings its helpers

    def test_started_again_it_configures_nothing(self):
        self.run_it()
        done, calls = self.run_it()
        self.assertEqual([call.split()[0] for call in calls], ["install-deps", "cmake"])
        self.assertIn("--build", calls[1])
        self.assertIn("started in /usr", done.stdout)

    def test_progress_is_said_and_warnings_are_passed_on(self):
        done, _ = self.run_it()
        self.assertIn("50 %, step 1 of 2, 9 s, about 9 s more\na warning\n", done.stdout)
        self.assertIn("built: 2 steps in 18 s\n", done.stdout)

    def test_a_build_that_fails_ends_it(self):
        done, _ = self.run_it(BREAK="1")
        self.assertEqual(done.returncode, 7)
        self.assertIn("FAILED: two", done.stdout)
        self.assertNotIn("started", done.stdout)

    def test_what_cannot_be_installed_ends_it_but_a_system_without_apt_goes_on(self):
        done, calls = self.run_it(INSTALLED="1")
        self.assertEqual((done.returncode, len(calls)), (1, 1))
        done, calls = self.run_it(INSTALLED="3")
        self.assertEqual((done.returncode, len(calls)), (0, 3))

    def test_without_a_display_it_builds_and_says_what_to_do(self):
        done, calls = self.run_it(DISPLAY="")
        self.assertEqual((done.returncode, len(calls)), (1, 3))
        self.assertIn("underact-cli --help", done.stderr)


if __name__ == "__main__":
    unittest.main()
