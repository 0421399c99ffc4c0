"""packaging/test with everything it calls replaced: what is built and run, and how it is counted."""

import unittest

from stand_ins import CALLED, Scripts

BUILD = CALLED + '[ "${BREAK:-}" != "$1" ]\n'
# Thirty tests a run, of which two fail or are skipped in the stage that is named.
CTEST = (
    CALLED
    + """
preset=$2
while [ $# -gt 0 ]; do [ "$1" = --output-junit ] && junit=$2; shift; done
[ "$preset" = "${EMPTY:-}" ] && exit 1
failures=0 skipped=0
[ "$preset" = "${FAIL:-}" ] && failures=2
[ "$preset" = "${SKIP:-}" ] && skipped=2
mkdir -p "$(dirname "$junit")"
{
  printf '<testsuite name="(empty)"\\n\\ttests="30"\\n\\tfailures="%s"\\n' $failures
  printf '\\tdisabled="0"\\n\\tskipped="%s"\\n\\thostname=""\\n\\ttime="7"\\n\\t>\\n' $skipped
  for n in $(seq 30); do
    status=run said=
    [ $n -gt $failures ] || { status=fail said="passed before\n$(cat said_$n)\n[       OK ] Wall.IsFlat"; }
    printf '\\t<testcase name="t%s" classname="t%s" time="%s.25" status="%s">\\n' $n $n $n $status
    printf '\\t\\t<system-out>%b' "$said"
    printf 'SKIPPED: duk isn&apos;t &lt;there&gt;\\n</system-out>\\n\\t</testcase>\\n'
  done
  echo "</testsuite>"
} >"$junit"
[ $failures = 0 ]
"""
)
# What the failed ones of its tests say.
SAID = {
    "said_1": "a_test.cpp:12: Failure\nExpected: (force) &lt; (1), actual: 2\n[  FAILED  ] Wall.IsHard (3 ms)",
    "said_2": "Segmentation fault",
}
CMAKE = CALLED + """echo "by $(basename "${CXX:-the preset's}"): $2" >>"$LOG.compilers"\n"""
SANITIZED = ["--preset asan", "--preset tsan"]


class Test(Scripts):
    COPIES = ("packaging/test", ".ci/run")
    STAND_INS = {
        "packaging/install-deps": CALLED + "exit ${INSTALLED:-0}\n",
        "packaging/compile": BUILD,
        "tests/architecture/each_alone": CALLED + '[ "${BREAK:-}" != alone ]\n',
        **SAID,
        "bin/cmake": CMAKE,
        "bin/ctest": CTEST,
        # Two that are new enough; the newer one has no sanitizers.
        "bin/clang++-28": "cat >/dev/null\n",
        "bin/clang++-29": "cat >/dev/null; exit 1\n",
    }

    def run_it(self, *words, script="packaging/test", **more):
        """(exit status, lines of output, calls)."""
        done, calls = self.call(script, *words, **more)
        return done.returncode, done.stdout.splitlines(), calls

    def test_by_itself_it_is_one_release_build_and_all_its_tests(self):
        status, lines, calls = self.run_it()
        self.assertEqual((status, lines[-1]), (0, "30 passed, 0 failed"))
        self.assertEqual(calls[0], "install-deps run test")
        self.assertEqual(calls[1], "cmake --preset release -DUNDERACT_PYTHON=ON")
        self.assertEqual(calls[2], "compile release")
        self.assertTrue(calls[3].startswith("ctest --preset release -j"))
        self.assertNotIn(" -R ", calls[3])
        self.assertEqual(len(calls), 4)

    def test_sanitizers_are_two_more_and_one_sum(self):
        status, lines, calls = self.run_it("--sanitizers")
        self.assertEqual((status, lines[-1]), (0, "90 passed, 0 failed"))
        presets = [call for call in calls if call.startswith("cmake")]
        self.assertEqual(presets[0], "cmake --preset release -DUNDERACT_PYTHON=ON")
        self.assertEqual([call[6:19] for call in presets[1:]], SANITIZED)

    def compilers(self, *words):
        """Which compiler each build was configured for."""
        self.run_it(*words)
        return (self.folder / "log.compilers").read_text().splitlines()

    def test_what_ships_is_built_by_the_compiler_of_its_preset_and_the_checks_by_others(self):
        got = self.compilers("--strict", "--sanitizers")
        self.assertEqual(got, ["by the preset's: ci", "by clang++-28: asan", "by clang++-28: tsan", "by clang++-28: alone"])

    def test_without_a_clang_that_has_sanitizers_each_preset_has_its_own(self):
        for version in range(20, 30):  # also in place of those that are installed
            self.write(f"bin/clang++-{version}", "cat >/dev/null; exit 1\n")
        got = self.compilers("--strict", "--sanitizers")
        self.assertEqual(got, [f"by the preset's: {preset}" for preset in ("ci", "asan", "tsan", "alone")])

    def test_ci_leaves_nothing_out(self):
        status, lines, calls = self.run_it(script=".ci/run")
        self.assertEqual((status, lines[-1]), (0, "90 passed, 0 failed"))
        self.assertEqual(calls[0], "install-deps run test check package")
        self.assertEqual(calls[1], "cmake --preset ci -DUNDERACT_PYTHON=ON")
        self.assertIn("each_alone build/alone", calls)
        self.assertEqual(len([call for call in calls if call.startswith("ctest")]), 3)

    def test_the_slowest_twenty_are_listed_with_their_times(self):
        _, lines, _ = self.run_it("--sanitizers")
        at = lines.index("the slowest tests:")
        rows = [line.split() for line in lines[at + 1 : at + 21]]
        self.assertEqual(rows[0][:2] + rows[0][3:], ["30.2", "s", "t30"])
        self.assertEqual({row[2] for row in rows[:3]}, {"release", "asan", "tsan"})
        self.assertEqual(rows[19][3], "t24")
        self.assertNotIn(" s ", lines[at + 21][:12])

    def test_what_fails_is_counted_wherever_it_does(self):
        status, lines, _ = self.run_it("--sanitizers", FAIL="tsan")
        self.assertEqual((status, lines[-1]), (1, "88 passed, 2 failed"))
        status, lines, _ = self.run_it("--sanitizers", BREAK="asan")
        self.assertEqual((status, lines[-1]), (1, "60 passed, 1 failed"))
        status, lines, _ = self.run_it("--strict", BREAK="alone")
        self.assertEqual((status, lines[-1]), (1, "30 passed, 1 failed"))
        status, lines, _ = self.run_it(EMPTY="release")
        self.assertEqual((status, lines[-1]), (1, "0 passed, 1 failed"))
        status, lines, calls = self.run_it(INSTALLED="1")
        self.assertEqual((status, lines[-1], len(calls)), (1, "0 passed, 1 failed", 1))

    def test_what_failed_is_said_again_at_the_end_without_what_passed(self):
        _, lines, _ = self.run_it("--sanitizers", FAIL="asan")
        said = lines[lines.index("failed:") + 1 : -2]
        wall = ["    a_test.cpp:12: Failure", "    Expected: (force) < (1), actual: 2", "    [  FAILED  ] Wall.IsHard (3 ms)"]
        self.assertEqual(said[:4], ["  asan t1", *wall])
        second = said.index("  asan t2")
        self.assertIn("    Segmentation fault", said[second:])
        self.assertNotIn("    passed before", said[:second])
        self.assertNotIn("failed:", self.run_it("--sanitizers")[1])

    def test_what_is_skipped_is_said_with_its_reason(self):
        status, lines, _ = self.run_it(SKIP="release")
        self.assertEqual((status, lines[-1]), (0, "28 passed, 0 failed"))
        at = lines.index("2 skipped, in whole or in part:")
        self.assertEqual(lines[at + 1], "  SKIPPED: duk isn't <there>")
        self.assertIn("packaging/install-deps check package", lines[at + 2])

    def test_what_a_slow_machine_does_not_begin_is_named_and_not_counted_as_passed(self):
        status, lines, calls = self.run_it("--strict", "--sanitizers", "--within", "0")
        self.assertEqual((status, lines[-1]), (0, "30 passed, 0 failed"))
        self.assertEqual(len([call for call in calls if call.startswith("ctest")]), 1)
        self.assertNotIn("each_alone build/alone", calls)
        at = lines.index("3 skipped, in whole or in part:")
        left_out = [line.split(",")[0] for line in lines[at + 1 : at + 4]]
        self.assertEqual(left_out, [f"  SKIPPED: {name}" for name in ("ASan and UBSan", "TSan", "each file alone")])

    def test_other_words_are_refused_before_anything_is_done(self):
        status, _, calls = self.run_it("--sanitiser")
        self.assertEqual((status, calls), (2, []))
        for wrong in ([], ["soon"], ["-1"]):
            status, _, calls = self.run_it("--within", *wrong)
            self.assertEqual((status, calls), (2, []))


if __name__ == "__main__":
    unittest.main()
