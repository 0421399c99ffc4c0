"""Breaks the program on purpose, one line at a time, and names what no test noticed.

python3 -B tests/mutants [--only PATTERN] [--build FOLDER] [--jobs N] [--list]

Works in a copy of the tracked files, so the tree itself stays as it is. Exit status 0 where every
breakage is noticed but those that are explained; 1 where another lives, or more than three do; 2
where the list (breakages.py) is wrong, or where the tests fail on what is not broken.
"""

from __future__ import annotations

import argparse
import contextlib
import fnmatch
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from breakages import BREAKAGES, Breakage

ROOT = Path(__file__).resolve().parents[2]
MAX_ALIVE = 3
MIN_LIMIT_S = 60.0  # a test may take this long, or
TIMES = 10.0  # so many times as long as on the whole program
BUILD_LIMIT_S = 6 * 3600.0  # a whole build beside other work took more than an hour


class ListError(Exception):
    """The list is wrong, or the program is broken without it: no mutant can be judged."""


def line_of(root: Path, breakage: Breakage) -> int:
    """The line that the old text begins in; ListError unless it stands there exactly once."""
    path = root / breakage.file
    text = path.read_text(encoding="utf-8") if path.is_file() else ""
    count = text.count(breakage.old)
    if count != 1:
        raise ListError(f"{breakage.file}: stands there {count} times, not once: {breakage.old!r}")
    return text[: text.index(breakage.old)].count("\n") + 1


def end_session(session: int) -> None:
    """Kills what is left of a session: ninja, for one, has a process group for each command."""
    for status in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            # Behind the name, which stands in brackets: state, parent, group, session.
            if int(status.read_text().rpartition(")")[2].split()[3]) == session:
                os.kill(int(status.parent.name), signal.SIGKILL)


def run(command: list[str], limit_s: float, cwd: Path, more: dict[str, str]) -> tuple[bool, str]:
    """Whether it ended without an error in time, and its output. It ends all that it started."""
    with subprocess.Popen(
        command,
        cwd=cwd,
        env={**os.environ, **more},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        start_new_session=True,
    ) as child:
        try:
            output = child.communicate(timeout=limit_s)[0]
            return child.returncode == 0, output
        except subprocess.TimeoutExpired:
            return False, f"It took more than {limit_s:.0f} s."
        finally:
            end_session(child.pid)


def copy_tracked(source: Path) -> None:
    """Brings `source` to what is tracked here; what is the same already is not touched."""
    mark = source / "build/of_mutants"  # only what was made here is brought up to date
    if source.is_dir() and any(source.iterdir()) and not mark.is_file():
        raise ListError(f"{source}: This folder has files of other origin. Name a new one.")
    mark.parent.mkdir(parents=True, exist_ok=True)
    mark.touch()
    names = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout.split("\0")
    wanted = {name for name in names if name and (ROOT / name).is_file()}
    for path in [path for path in source.rglob("*") if path.is_file() or path.is_symlink()]:
        name = str(path.relative_to(source))
        if name not in wanted and not name.startswith("build/"):
            path.unlink()
    for name in wanted:
        there, here = source / name, ROOT / name
        if there.is_file() and there.read_bytes() == here.read_bytes():
            continue
        there.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(here, there)


class Bench:
    """The copy, its build and what ctest knows of it."""

    def __init__(self, folder: Path, jobs: int) -> None:
        # The build where developers have theirs: so it finds what ccache has of other trees.
        self.source, self.binary, self.jobs = folder, folder / "build/release", jobs
        self.known: dict[str, dict] = {}
        self.compiling = {"CCACHE_BASEDIR": str(self.source), "CCACHE_NOHASHDIR": "1"}

    def configure(self) -> None:
        """Copies and configures, as the preset `ci`; what a breakage leaves unused is no error."""
        copy_tracked(self.source)
        words = ["cmake", "--preset", "ci", "-B", str(self.binary), "-DUNDERACT_BENCH=OFF"]
        words += ["-DUNDERACT_SANITIZE=", "-DCMAKE_COMPILE_WARNING_AS_ERROR=OFF"]
        passed, output = run(words, 600, self.source, self.compiling)
        if not passed:
            raise ListError(f"It does not configure:\n{output}")

    def build(self, programs: set[str]) -> tuple[bool, str]:
        """Builds these targets."""
        words = ["cmake", "--build", str(self.binary), "-j", str(self.jobs), "--target"]
        return run([*words, *sorted(programs)], BUILD_LIMIT_S, self.source, self.compiling)

    def ask_ctest(self) -> None:
        """Which command each test is."""
        words = ["ctest", "--test-dir", str(self.binary), "--show-only=json-v1"]
        output = subprocess.run(words, check=True, capture_output=True, text=True).stdout
        self.known = {test["name"]: test for test in json.loads(output)["tests"]}

    def passes(self, breakage: Breakage, limit_s: float) -> tuple[bool, str]:
        """Runs the test as ctest would, with the filter."""
        test = self.known.get(breakage.test)
        if test is None or "command" not in test:
            raise ListError(f"{breakage.file}: there is no test {breakage.test}.")
        properties = {one["name"]: one["value"] for one in test.get("properties", [])}
        more = dict(word.split("=", 1) for word in properties.get("ENVIRONMENT", []))
        more["GTEST_FAIL_FAST"] = "1"
        command = list(test["command"])
        if breakage.only != "*":
            command.append(f"--gtest_filter={breakage.only}")
        where = Path(properties.get("WORKING_DIRECTORY", self.binary))
        passed, output = run(command, limit_s, where, more)
        if "Running 0 tests" in output:
            raise ListError(f"{breakage.file}: no test of {breakage.test} is {breakage.only}.")
        return passed, output

    @contextlib.contextmanager
    def broken(self, breakage: Breakage) -> Iterator[None]:
        """The copy with this breakage; afterwards as before, whatever happens."""
        line_of(self.source, breakage)
        path = self.source / breakage.file
        whole = path.read_text(encoding="utf-8")
        try:
            path.write_text(whole.replace(breakage.old, breakage.new), encoding="utf-8")
            yield
        finally:
            path.write_text(whole, encoding="utf-8")


def judge_whole(bench: Bench, chosen: list[Breakage]) -> dict[tuple[str, str], float]:
    """Builds all once and runs the tests: they pass. Gives how long each takes at most."""
    started = time.monotonic()
    bench.configure()
    passed, output = bench.build({word for one in chosen for word in one.program.split()})
    if not passed:
        raise ListError(f"It does not build without a breakage:\n{output[-4000:]}")
    bench.ask_ctest()
    limits_s: dict[tuple[str, str], float] = {}
    for one in chosen:
        if (one.test, one.only) in limits_s:
            continue
        begun = time.monotonic()
        passed, output = bench.passes(one, BUILD_LIMIT_S)
        if not passed:
            raise ListError(f"{one.test} ({one.only}) fails without a breakage:\n{output[-4000:]}")
        seconds = time.monotonic() - begun
        limits_s[one.test, one.only] = max(MIN_LIMIT_S, TIMES * seconds)
        print(f"whole: {one.test} {one.only}: {seconds:.1f} s", flush=True)
    print(f"whole: built and tested in {(time.monotonic() - started) / 60:.1f} min", flush=True)
    return limits_s


def lives(bench: Bench, breakage: Breakage, limit_s: float) -> bool:
    """Whether the test passes all the same."""
    with bench.broken(breakage):
        passed, output = bench.build(set(breakage.program.split()))
        if not passed:
            raise ListError(f"{breakage.file}: does not compile when broken:\n{output[-4000:]}")
        return bench.passes(breakage, limit_s)[0]


def judge_all(bench: Bench, chosen: list[Breakage]) -> list[Breakage]:
    """Those that live."""
    limits_s = judge_whole(bench, chosen)
    alive: list[Breakage] = []
    started = time.monotonic()
    for number, one in enumerate(chosen, start=1):
        begun = time.monotonic()
        if lives(bench, one, limits_s[one.test, one.only]):
            alive.append(one)
        now = time.monotonic()
        left_min = (now - started) / number * (len(chosen) - number) / 60
        word = "LIVES" if one in alive else "dies"
        print(
            f"{number}/{len(chosen)} {word}, {now - begun:.0f} s, about {left_min:.0f} min left: "
            f"{one.file}: {one.says}",
            flush=True,
        )
    return alive


def tell(alive: list[Breakage], count: int) -> int:
    """Names those that live; the exit status."""
    for one in alive:
        print(f"\nLIVES: {one.file}:{line_of(ROOT, one)}: {one.says}")
        print(f"  was: {one.old.strip()}\n  is:  {one.new.strip() or '(left out)'}")
        print(f"  {one.lives or f'{one.test} ({one.only}) should notice it.'}")
    print(f"\n{count - len(alive)} of {count} breakages are noticed, {len(alive)} live.")
    return 1 if len(alive) > MAX_ALIVE or any(not one.lives for one in alive) else 0


def main() -> int:
    """The command line."""
    parser = argparse.ArgumentParser(prog="tests/mutants", description=__doc__.split("\n")[0])
    parser.add_argument("--list", action="store_true", help="print the breakages and exit")
    parser.add_argument("--only", metavar="PATTERN", default="*", help="of files, as core/tick/*")
    parser.add_argument("--build", metavar="FOLDER", type=Path, help="keep copy and build there")
    parser.add_argument("--jobs", metavar="N", type=int, default=os.cpu_count() or 1)
    asked = parser.parse_args()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    chosen = [one for one in BREAKAGES if fnmatch.fnmatch(one.file, asked.only)]
    try:
        if not chosen:
            raise ListError(f"There is no breakage of {asked.only}.")
        places = [line_of(ROOT, one) for one in chosen]
        if asked.list:
            for one, line in zip(chosen, places):
                print(f"{one.file}:{line}: {one.says} ({one.test} {one.only})")
            return 0
        if asked.build is not None:
            return tell(judge_all(Bench(asked.build.resolve(), asked.jobs), chosen), len(chosen))
        with tempfile.TemporaryDirectory(prefix="underact_mutants_") as folder:
            return tell(judge_all(Bench(Path(folder), asked.jobs), chosen), len(chosen))
    except ListError as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("Interrupted: nothing is left broken.", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
