#!/usr/bin/env python3
"""Session files as a stranger might hand them over, with every checksum made right again, given to
the commands that read sessions, those in Python among them. What must hold for any seed: no signal,
no hang over 10 s, no more than 400 MB of any process, no other file changed, and a sentence.

Usage: hostile_sessions.py UNDERACT_CLI SCENES_FOLDER [SEED] [COUNT]. Exit 1: it did not hold; 77:
h5py is not there.
"""

from __future__ import annotations

import hashlib
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import time
import zlib
from collections.abc import Callable
from pathlib import Path

try:
    import h5py
    import numpy as np
except ModuleNotFoundError as missing:
    print(f"SKIPPED: {missing.name} is not installed, so no hostile sessions were made.")
    sys.exit(77)

MAX_S = 10.0 * float(os.environ.get("UNDERACT_SLOW", "1"))
MAX_MIB = 400
FAULT_KINDS = {
    "tick": "<i8",
    "kind": "u1",
    "seen": "<f8",
    "allowed": "<f8",
    "from_servo": "u1",
    "crc32": "<u4",
}
READING = (("log", "info"), ("log", "verify"), ("replay", "--verify"), ("log", "export"))
ALL = (*READING, ("replay",), ("log", "recover"), ("log", "info"))
PACKAGE = Path(__file__).resolve().parents[3] / "app/python"
KINDS = "error force displacement-force path angles joints energy spectrum lateness".split()
FORMS = ("parquet", "mcap", "csv")
INTEGERS = (2**31 - 1, -1, -(2**31), 10_000_000, 1, 255)
LONG_INTEGERS = (2**63 - 1, -1, -(2**63), 2**62, 2**40, 64, 0)
REALS = (np.nan, np.inf, -np.inf, 1e308, -1e308, 5e-324)


# Of these Python makes every form, too.
EVERY_FORM = ("endless faults", "endless block", "endless ticks", "flood of labels", "bomb", "packed")


class Trial:
    """A folder with a victim in it, and what did not hold."""

    def __init__(self, cli: str, scenes: Path, seed: int):
        self.cli, self.scenes = cli, scenes
        self.random = random.Random(seed)
        self.python = random.Random(seed)  # of its own: the files stay those that a seed had before
        self.folder = Path(tempfile.mkdtemp(prefix="hostile-"))
        self.tried, self.bad = 0, []
        self.sources: dict[str, Path] = {}
        self.victim = self.folder / "victim.h5"
        shutil.copy(self.source("02_sphere"), self.victim)
        self.secret = self.folder / "secret.txt"
        self.secret.write_text("nobody's business " * 4000, encoding="utf-8")
        self.before = self.digests()

    def digests(self) -> list[bytes]:
        return [hashlib.sha256(path.read_bytes()).digest() for path in (self.victim, self.secret)]

    def source(self, scene: str) -> Path:
        """A recording of two seconds, made once."""
        out = self.folder / f"{scene}.h5"
        if scene not in self.sources:
            command = [self.cli, "run", str(self.scenes / f"{scene}.json"), "--hand", "tremor"]
            command += ["--seconds", "2", "--fast", "--record", str(out)]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode:
                sys.exit(f"{scene} could not be recorded: {done.stderr.strip()[-200:]}")
            self.sources[scene] = out
        return self.sources[scene]

    def copy(self, scene: str = "02_sphere") -> Path:
        return Path(shutil.copy(self.source(scene), self.folder / "stranger.h5"))

    def ask(self, what: str, path: Path, commands=READING) -> None:
        for words in commands:
            self._run(what, [*words[:2], str(path), *words[2:]] if words[0] == "log" else [words[0], str(path), *words[1:]])
        self._look()

    def draw(self, what: str, path: Path, forms: tuple[str, ...] = ()) -> None:
        """Has Python read it, which is not sealed: one plot, and these forms. Each start of Python
        takes a second, so not all of all files.
        """
        out = self.folder / "out"
        kind = self.python.choice(KINDS)
        self._run(what, ["log", "plot", str(path), "--kind", kind, "--out", f"{out}.png"])
        for form in forms:
            words = ["export", str(path), "--format", form, "--out", f"{out}.{form}"]
            if form == "csv":  # of the program's own it is in READING
                self._run(what, ["-m", "underact", *words], sys.executable)
            else:
                self._run(what, ["log", *words])
        self._look()

    def _look(self) -> None:
        if self.digests() != self.before:
            self.bad.append(f"{self.what}: another file was changed")
            self.before = self.digests()

    def _run(self, what: str, words: list[str], program: str = "") -> None:
        self.tried += 1
        self.what = what
        with subprocess.Popen(
            [program or self.cli, *words],
            env={**os.environ, "PYTHONPATH": str(PACKAGE), "PYTHONDONTWRITEBYTECODE": "1"},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CORE, (0, 0)),
        ) as process:
            try:
                said, _ = process.communicate(timeout=MAX_S)
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                self.bad.append(f"{what}: {words[0]} {words[1]} took longer than {MAX_S:.0f} s")
                return
        told = said.decode(errors="replace").strip()
        if process.returncode < 0 or process.returncode > 128:
            self.bad.append(f"{what}: {words[:2]} ended by {process.returncode}: {told[:80]}")
        elif process.returncode and not told:
            self.bad.append(f"{what}: {words[:2]} said nothing")
        elif "Traceback (most recent call last)" in told:
            self.bad.append(f"{what}: {words} broke off: {told[-120:]}")

    def peak_mib(self) -> int:
        """Of any process so far; the largest one's."""
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024


def opened(path: Path) -> h5py.File:
    return h5py.File(path, "r+", libver="v110")


def mended(table: h5py.Group) -> None:
    """Puts the checksums of a table right."""
    names = [one for one in table.attrs["columns"].decode().split(",")]
    block = int(table.attrs["block_rows"])
    rows = min(len(table[name]) for name in names)
    columns = [table[name][:rows] for name in names]
    checks = []
    for at in range(0, rows, block):
        crc = 0
        for column in columns:
            crc = zlib.crc32(column[at : at + block].tobytes(), crc)
        checks.append(crc)
    if checks:
        table["crc32"][: len(checks)] = checks


def change_state(trial: Trial, scene: str) -> None:
    path, draw = trial.copy(scene), trial.random
    with opened(path) as file:
        column = file["start/bytes"]
        state, kind, size = column[:], draw.random(), len(column)
        if kind < 0.5:
            at = draw.randrange(0, size - 4)
            value = np.int32(draw.choice([*INTEGERS, draw.randrange(-(2**31), 2**31)]))
            state[at : at + 4] = np.frombuffer(value.tobytes(), np.uint8)
        elif kind < 0.8:
            at = draw.randrange(0, size - 16)
            state[at : at + 16] = np.frombuffer(draw.randbytes(16), np.uint8)
        else:
            start = min(270, size // 2)
            state[start:] = np.frombuffer(draw.randbytes(size - start), np.uint8)
        column[:] = state
        mended(file["start"])
    trial.ask(f"state of {scene}", path, (("replay", "--verify"),))


def change_numbers(trial: Trial) -> None:
    """Of any table, with a word or more at its place that no writer writes."""
    path, draw = trial.copy(), trial.random
    with opened(path) as file:
        for _ in range(draw.randrange(1, 4)):
            table = file[draw.choice(["ticks", "changes", "end", "text", "faults", "markers"])]
            names = [name for name in table if name != "crc32" and len(table[name])]
            if not names:
                continue
            column = table[draw.choice(names)]
            row = draw.randrange(len(column))
            if column.dtype.kind == "f":
                column[row] = draw.choice(REALS)
            elif column.dtype.itemsize == 8:
                column[row] = draw.choice([*LONG_INTEGERS, draw.randrange(-(2**63), 2**63)])
            else:
                column[row] = draw.randrange(256)
            mended(table)
    trial.draw("changed numbers", path)
    trial.ask("changed numbers", path, ALL)


def change_attributes(trial: Trial) -> None:
    path, draw = trial.copy(), trial.random
    with opened(path) as file:
        group = file[draw.choice(["/", "ticks", "faults", "text", "ticks/q_rad"])]
        name = draw.choice([*group.attrs])
        value = draw.choice(
            [np.int64(draw.choice(LONG_INTEGERS)), np.float64(draw.choice(REALS)), np.bytes_(b"x" * 60_000)]
            + ["variable", np.arange(100), np.int8(-1), np.bytes_(b"\xff\x00\n%1%2"), h5py.Empty("f")]
        )
        del group.attrs[name]
        group.attrs[name] = value
    trial.draw("changed attributes", path, (trial.python.choice(FORMS),))
    trial.ask("changed attributes", path, ALL)


def huge_attribute(file: h5py.File) -> None:
    del file.attrs["notes"]
    space = h5py.h5s.create(h5py.h5s.SCALAR)
    kind = h5py.h5t.C_S1.copy()
    kind.set_size(1 << 26)
    h5py.h5a.create(file.id, b"notes", kind, space).write(np.array(b"x" * (1 << 26), dtype=f"S{1 << 26}"))


def replace_column(file: h5py.File, table: str, column: str, **layout) -> None:
    data = file[table][column][:]
    del file[table][column]
    settings = {"data": data, "maxshape": (None, *data.shape[1:]), "chunks": (100, *data.shape[1:])}
    settings.update(layout)
    file[table].create_dataset(column, **{key: value for key, value in settings.items() if value is not None})


def endless(file: h5py.File, rows: int, block: int | None = None) -> None:
    faults = file["faults"]
    if block:
        faults.attrs["block_rows"] = np.int64(block)
    for column, kind in FAULT_KINDS.items():
        del faults[column]
        length = rows // (block or 1) + 1 if column == "crc32" else rows
        fill = zlib.crc32(bytes(26)) if column == "crc32" else 0
        faults.create_dataset(column, (length,), kind, maxshape=(None,), chunks=(64,), fillvalue=fill)


def endless_ticks(file: h5py.File, rows: int) -> None:
    for column in file["ticks"]:
        file["ticks"][column].resize(rows, axis=0)


def flood(file: h5py.File) -> None:
    """Some 8 MB that hold 16 labels of 64 MiB each: a gibibyte of zeros, and its checksums, packed."""
    text, marks, size = file["text"], file["markers"], 1 << 26
    file["changes/text_bytes"][:] = 0  # the scene stood there
    mended(file["changes"])
    for name, kind, chunk, rows in (("bytes", "u1", 1024, 16 * size), ("crc32", "<u4", 64, size // 4)):
        del text[name]
        text.create_dataset(name, (rows,), kind, maxshape=(None,), chunks=(chunk,), compression="gzip")
    for at in range(0, size // 4, 1 << 16):  # all at once the library would take a gigabyte for it
        text["crc32"][at : at + (1 << 16)] = zlib.crc32(bytes(64))
    for name in ("tick", "text_at", "text_bytes", "crc32"):
        marks[name].resize(16, axis=0)
    marks["tick"][:] = 1
    marks["text_at"][:] = np.arange(16) * size
    marks["text_bytes"][:] = size
    mended(marks)


def bomb(file: h5py.File) -> None:
    """A megabyte of zlib in place of a chunk, which is to be a gibibyte of zeros."""
    replace_column(file, "ticks", "tick", compression="gzip", compression_opts=9)
    packer = zlib.compressobj(9)
    begun = packer.compress(b"") + packer.flush(zlib.Z_FULL_FLUSH)
    part = packer.compress(bytes(1 << 24)) + packer.flush(zlib.Z_FULL_FLUSH)
    file["ticks/tick"].id.write_direct_chunk((0,), begun + 64 * part)


def crowd(file: h5py.File) -> None:
    """So many marks that to draw each takes minutes."""
    marks, rows = file["markers"], 8000
    for name in ("tick", "text_at", "text_bytes", "crc32"):
        marks[name].resize(rows, axis=0)
    marks["tick"][:] = np.arange(rows) // 4
    marks["text_at"][:] = 0
    marks["text_bytes"][:] = 1
    mended(marks)


def borrow(file: h5py.File, kind: str) -> None:
    for key in list(file["end"]):
        file["end"][key].resize(0, axis=0)
    ticks = file["ticks"]
    shape, dtype = ticks["q_rad"].shape, ticks["q_rad"].dtype
    for key in list(ticks):
        if key not in ("q_rad", "crc32", "tick", "time_ns"):
            ticks[key].resize(5, axis=0)
    del ticks["q_rad"]
    if kind == "virtual":
        layout = h5py.VirtualLayout(shape=shape, dtype=dtype)
        layout[:] = h5py.VirtualSource("victim.h5", "/ticks/q_rad", shape=shape)
        ticks.create_virtual_dataset("q_rad", layout)
    elif kind == "link":
        ticks["q_rad"] = h5py.ExternalLink("victim.h5", "/ticks/q_rad")
    elif kind == "storage":
        ticks.create_dataset("q_rad", shape, dtype, external=[("secret.txt", 0, h5py.h5f.UNLIMITED)])
    elif kind == "table":
        del file["ticks"]
        file["ticks"] = h5py.ExternalLink("victim.h5", "/ticks")
    elif kind == "start":
        size = file["start/bytes"].shape
        del file["start/bytes"]
        file["start"].create_dataset("bytes", size, "u1", external=[("/etc/passwd", 0, size[0])])


def link(file: h5py.File, kind: str) -> None:
    if kind == "soft":
        file.move("ticks", "others")
        file["ticks"] = h5py.SoftLink("/others")
    elif kind == "cycle":
        del file["ticks"]
        file["ticks"] = h5py.SoftLink("/ticks")
    elif kind == "root":
        del file["ticks"]
        file["ticks"] = file["/"]
    elif kind == "column":
        file.move("ticks/q_rad", "ticks/others")
        file["ticks/q_rad"] = h5py.SoftLink("/ticks/others")
    elif kind == "shared":
        del file["text/bytes"]
        file["text/bytes"] = file["start/bytes"]
    elif kind == "dataset":
        del file["ticks"]
        file["ticks"] = np.arange(10)


STRUCTURES: dict[str, Callable[[h5py.File], None]] = {
    "endless faults": lambda f: endless(f, 1 << 36),
    "endless block": lambda f: endless(f, 1 << 36, 1_000_000),
    "endless ticks": lambda f: endless_ticks(f, 1 << 36),
    "many ticks": lambda f: endless_ticks(f, 1 << 20),
    "flood of labels": flood,
    "bomb": bomb,
    "crowd": crowd,
    "borrowed by a link": lambda f: borrow(f, "link"),
    "borrowed virtually": lambda f: borrow(f, "virtual"),
    "borrowed storage": lambda f: borrow(f, "storage"),
    "borrowed table": lambda f: borrow(f, "table"),
    "borrowed start": lambda f: borrow(f, "start"),
    "soft link": lambda f: link(f, "soft"),
    "cycle of links": lambda f: link(f, "cycle"),
    "a table that is the root": lambda f: link(f, "root"),
    "soft link to a column": lambda f: link(f, "column"),
    "two columns that are one": lambda f: link(f, "shared"),
    "a table that is a dataset": lambda f: link(f, "dataset"),
    "packed": lambda f: replace_column(f, "ticks", "q_rad", compression="gzip"),
    "shuffle": lambda f: replace_column(f, "ticks", "tick", shuffle=True),
    "fletcher32": lambda f: replace_column(f, "ticks", "tick", fletcher32=True),
    "huge chunks": lambda f: replace_column(f, "ticks", "tick", chunks=(1 << 28,)),
    "no chunks": lambda f: replace_column(f, "ticks", "tick", chunks=None, maxshape=None),
    "another type": lambda f: replace_column(f, "ticks", "tick", dtype="<i4"),
    "other ends": lambda f: replace_column(f, "ticks", "tick", dtype=">i8"),
    "strings": lambda f: replace_column(f, "ticks", "tick", data=["x"] * 5, dtype=h5py.string_dtype()),
    "another rank": lambda f: replace_column(f, "ticks", "q_rad", data=np.zeros((5, 6, 2)), chunks=(100, 6, 2), maxshape=(None, 6, 2)),
    "filled rows": lambda f: replace_column(f, "ticks", "tick", fillvalue=7),
    "no column": lambda f: f["ticks"].__delitem__("q_rad"),
    "huge attribute": huge_attribute,
    "no rate": lambda f: f.attrs.__delitem__("rate_hz"),
    "empty ticks": lambda f: endless_ticks(f, 0),
}


def odd_files(trial: Trial) -> None:
    """What is no session at all."""
    folder, source = trial.folder, trial.source("02_sphere").read_bytes()
    for share in (0.01, 0.1, 0.5, 0.9, 0.999):
        (folder / "cut.h5").write_bytes(source[: int(len(source) * share)])
        trial.draw(f"cut to {share}", folder / "cut.h5")
        trial.ask(f"cut to {share}", folder / "cut.h5", ALL)
    os.mkfifo(folder / "pipe.h5")
    (folder / "folder.h5").mkdir()
    for name in ("pipe.h5", "folder.h5"):
        trial.draw(name, folder / name)
        trial.ask(name, folder / name, ALL)
    (folder / "link.h5").symlink_to(trial.victim)
    trial.ask("link", folder / "link.h5", (("log", "recover"),))
    with open(folder / "sparse.h5", "wb") as file:
        file.write(source)
        file.truncate(1 << 40)
    trial.draw("sparse", folder / "sparse.h5")
    trial.ask("sparse", folder / "sparse.h5", ALL)


def main() -> int:
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    count = int(sys.argv[4]) if len(sys.argv) > 4 else 30
    trial = Trial(sys.argv[1], Path(sys.argv[2]), seed)
    try:
        for scene in ("25_torus_knot", "28_trefoil_path", "18_sphere_of_two_joints", "02_sphere"):
            for _ in range(count):
                change_state(trial, scene)
        for _ in range(count):
            change_numbers(trial)
            change_attributes(trial)
        for name, change in STRUCTURES.items():
            path = trial.copy()
            with opened(path) as file:
                change(file)
            trial.draw(name, path, FORMS if name in EVERY_FORM else ())
            trial.ask(name, path, ALL)
        odd_files(trial)
        if trial.peak_mib() > MAX_MIB:
            trial.bad.append(f"a process took {trial.peak_mib()} MiB")
    finally:
        shutil.rmtree(trial.folder, ignore_errors=True)
    print(f"hostile sessions, seed {seed}: {len(trial.bad)} of {trial.tried} did not hold", end="")
    print("".join(f"\n  {one}" for one in trial.bad[:20]), f"at most {trial.peak_mib()} MiB", sep="\n")
    return 1 if trial.bad else 0


if __name__ == "__main__":
    begun = time.monotonic()
    result = main()
    print(f"{time.monotonic() - begun:.0f} s")
    sys.exit(result)
