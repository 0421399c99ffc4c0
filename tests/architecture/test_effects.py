"""tick_effects looks where the marks are, finds what is planted there, and is not switched off."""

import contextlib
import importlib.machinery
import importlib.util
import io
import pathlib
import shutil
import tempfile
import unittest

import effects

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parents[1]
HEADER = """#pragma once
#include "core/base/excepted.h"
struct Arm {
  void read() noexcept UNDERACT_REAL_TIME;
};
"""
QUIET = '#include "device/new/arm.h"\nvoid Arm::read() noexcept {}\n'
LOCKS = """#include <mutex>
#include "device/new/arm.h"
std::mutex m;
void Arm::read() noexcept { m.lock(); }
"""
EXCEPTED = LOCKS.replace("m.lock();", 'UNDERACT_EXCEPTED("planted for this test", m.lock());')
PRAGMA = '#pragma clang diagnostic ignored "-Wfunction-effects"\n'
SWITCHED = LOCKS.replace("void Arm", PRAGMA + "void Arm")


def tick_effects():
    loader = importlib.machinery.SourceFileLoader("tick_effects", str(HERE / "tick_effects"))
    spec = importlib.util.spec_from_loader("tick_effects", loader)
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


class Marks(unittest.TestCase):
    """effects.py, by texts."""

    def test_every_marked_file_of_the_program_is_analysed(self):
        texts = effects.code(ROOT)
        analysed = sum(effects.units(texts), [])
        seen = set().union(*(effects.reached(texts, path) for path in analysed))
        self.assertEqual(effects.marked(texts) - seen, set())
        for path in ("mesh/search", "tick/state", "tick/report", "servo/tap", "servo/history"):
            self.assertIn(f"core/{path}.cpp", analysed)
        for path in ("wooden_haptics/wooden_arm", "openhaptics/openhaptics_arm", "remote/remote_arm", "haply/haply_arm"):
            self.assertIn(f"device/{path}.cpp", analysed)

    def test_a_new_marked_file_is_analysed_wherever_it_is(self):
        includes = '#include "app/new/arm.h"\n'
        texts = {"app/new/arm.h": HEADER, "app/new/arm.cpp": includes, "app/new/other.cpp": ""}
        self.assertEqual(effects.units(texts), [["app/new/arm.cpp"]])

    def test_a_marked_header_that_nothing_includes_is_analysed_by_itself(self):
        self.assertEqual(effects.units({"core/new/alone.h": HEADER}), [["core/new/alone.h"]])

    def test_an_override_of_a_marked_function_needs_no_mark_of_its_own(self):
        port = "class Port {\n  virtual void read() noexcept UNDERACT_REAL_TIME = 0;\n};\n"
        arm = "class Arm final : public Port {\n};\n"
        texts = {"core/port/port.h": port, "device/new/arm.cpp": arm}
        self.assertIn(["device/new/arm.cpp"], effects.units(texts))

    def test_nothing_but_one_expression_with_its_reason_is_excepted(self):
        for line in (
            '#pragma clang diagnostic ignored "-Wfunction-effects"',
            '_Pragma("clang diagnostic ignored \\"-Wfunction-effects\\"")',
            "excepted([&] { lock(); });",
            'UNDERACT_EXCEPTED("two of them at a time", lock(); unlock());',
            'UNDERACT_EXCEPTED("goes on in the next line",',
            'UNDERACT_EXCEPTED("", lock());',
        ):
            self.assertEqual(len(effects.exceptions({"core/new/a.cpp": line})[1]), 1, line)
        line = 'UNDERACT_EXCEPTED("never waits, by POSIX", post(x));'
        found, wrong = effects.exceptions({"core/new/a.cpp": line})
        self.assertEqual(found, [effects.Excepted("core/new/a.cpp", 1, "never waits, by POSIX")])
        self.assertEqual(wrong, [])


@unittest.skipUnless(tick_effects().compiler(), "clang 20 or newer is not installed")
class Planted(unittest.TestCase):
    """The whole script, over a program with one marked function in a file that nobody has named."""

    def outcome(self, source):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for path in effects.MAKERS:
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / path, root / path)
            (root / "device/new").mkdir(parents=True)
            (root / "device/new/arm.h").write_text(HEADER, encoding="utf-8")
            (root / "device/new/arm.cpp").write_text(source, encoding="utf-8")
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                status = tick_effects().main(root, root)
            return status, said.getvalue()

    def test_what_calls_nothing_passes(self):
        self.assertEqual(self.outcome(QUIET)[0], 0)

    def test_a_lock_in_it_is_reported_with_its_place(self):
        status, said = self.outcome(LOCKS)
        self.assertEqual(status, 1)
        self.assertIn("device/new/arm.cpp:4", said)

    def test_a_lock_that_is_excepted_is_listed(self):
        status, said = self.outcome(EXCEPTED)
        self.assertEqual(status, 0)
        self.assertIn("excepted: device/new/arm.cpp:4: planted for this test", said)

    def test_a_lock_behind_a_pragma_is_reported(self):
        status, said = self.outcome(SWITCHED)
        self.assertEqual(status, 1)
        self.assertIn("device/new/arm.cpp:4: switches the analysis off", said)


if __name__ == "__main__":
    unittest.main()
