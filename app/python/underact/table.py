"""A table of a session file: a group whose datasets are its columns, with a CRC-32 for each block
of rows.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Mapping

import h5py
import numpy as np

from .errors import DamagedSession, SessionError, library_errors

_ROWS_AT_ONCE = 65536  # while checking: some 30 MB of ticks


def text_of(value: object) -> object:
    """An attribute as Python has it: bytes as a str, numpy's scalars as numbers, the rest as
    it is.
    """
    if isinstance(value, bytes):
        return value.rstrip(b"\0").decode("utf-8", "replace")
    if isinstance(value, np.ndarray) and value.dtype.kind in "SOU":
        return [text_of(one) for one in value.ravel().tolist()]
    return value.item() if isinstance(value, np.generic) else value


def _columns_of(group: h5py.Group) -> list[str]:
    names = text_of(group.attrs.get("columns", ""))
    if isinstance(names, str):
        names = names.replace(",", " ").split()
    return [name for name in names if name != "crc32"]


def _is_own(group: h5py.Group, name: str) -> bool:
    """Whether what has this name stands in the file itself: a link may lead to any other file, and
    so may where a dataset has its numbers.
    """
    if not isinstance(group.get(name, getlink=True), h5py.HardLink):
        return False
    found = group[name]
    return not isinstance(found, h5py.Dataset) or not (found.external or found.is_virtual)


class Table(Mapping):
    """The columns of a table by name, each a numpy array cut to the rows that all columns have.

    table["q_rad"]: shape (rows, 6); one number a row: shape (rows,). `units` and `meanings`
    hold what
    the file says of each column. Blocks are checked at the first access to a column: a damaged one
    raises DamagedSession, or with damaged="skip" its rows are left out of every column.
    """

    def __init__(self, file: h5py.File, name: str, wanted: dict[str, int], damaged: str):
        self.name = name
        group = file.get(name) if _is_own(file, name) else None
        where = f"{file.filename}: the table /{name}"
        if not isinstance(group, h5py.Group):
            raise SessionError(f"{where} is missing. The file is no whole session: record it anew.")
        order = _columns_of(group)
        foreign = {name for name in [*order, "crc32"] if not _is_own(group, name)}
        lost = sorted(set(wanted) - set(order) | foreign)
        if lost:
            raise SessionError(f"{where} lacks {', '.join(lost)}. The file is no whole session.")
        self._datasets = {column: group[column] for column in order}
        self._crc32 = group["crc32"]
        block_rows = text_of(group.attrs.get("block_rows"))
        if not isinstance(block_rows, int) or block_rows < 1:
            raise SessionError(f"{where} does not say how many rows a block has (block_rows).")
        self.block_rows = block_rows
        for column, dataset in self._datasets.items():
            width = wanted.get(column)
            shape = getattr(dataset, "shape", ())
            numbers = 1 if len(shape) == 1 else shape[1] if len(shape) == 2 else 0
            if numbers == 0 or dataset.dtype.kind not in "iufb" or width not in (None, numbers):
                raise SessionError(
                    f"{where} has a column {column} that is not {width} numbers a row."
                )
        attributes = {column: dataset.attrs for column, dataset in self._datasets.items()}
        self.units = {c: text_of(a.get("unit", "")) for c, a in attributes.items()}
        self.meanings = {c: text_of(a.get("meaning", "")) for c, a in attributes.items()}
        self._skip = damaged == "skip"
        self._kept: np.ndarray | None = None  # whether a row is kept; None: not checked yet
        self._bad_blocks: list[int] = []
        self._rows = 0

    def __iter__(self) -> Iterator[str]:
        return iter(self._datasets)

    def __len__(self) -> int:
        return len(self._datasets)

    def __getitem__(self, column: str) -> np.ndarray:
        if column not in self._datasets:
            raise KeyError(f"/{self.name} has no column {column}; it has {', '.join(self)}")
        self.check()
        return self._read(column, 0, self._kept)

    def between(self, first_row: int, end_row: int, bad: list[int]) -> dict[str, np.ndarray]:
        """Rows [first_row, end_row) of every column as in the file, but for the blocks in `bad`."""
        kept = np.ones(end_row, dtype=bool)
        for block in bad:
            kept[block * self.block_rows : (block + 1) * self.block_rows] = False
        return {column: self._read(column, first_row, kept[first_row:]) for column in self}

    def _read(self, column: str, first_row: int, kept: np.ndarray) -> np.ndarray:
        """The rows from first_row on that are kept, run by run: damaged ones may be unreadable."""
        edges = np.flatnonzero(np.diff(kept, prepend=False, append=False)) + first_row
        dataset = self._datasets[column]
        with library_errors(f"The column {column} of /{self.name}"):
            parts = [dataset[first:end] for first, end in edges.reshape(-1, 2).tolist()]
            if len(parts) == 1:
                return parts[0]
            return np.concatenate(parts) if parts else dataset[:0]

    @property
    def rows(self) -> int:
        """How many rows a column has, without those left out as damaged."""
        self.check()
        return int(self._kept.sum())

    @property
    def damage(self) -> list[tuple[int, int]]:
        """The rows [first, last) of the file, before anything is left out, of each damaged
        block.
        """
        self.check()
        size = self.block_rows
        return [(block * size, min((block + 1) * size, self._rows)) for block in self._bad_blocks]

    def common_rows(self) -> int:
        """The rows that all columns have now, of blocks whose CRC-32 is there."""
        lengths = [dataset.shape[0] for dataset in self._datasets.values()]
        return min([*lengths, self._crc32.shape[0] * self.block_rows])

    def refresh(self) -> None:
        """Looks for what a program that still writes has added. What was read stays checked."""
        for dataset in [self._crc32, *self._datasets.values()]:
            dataset.refresh()  # the high-level one: it forgets the shape, too

    def bad_blocks(self, first_row: int, end_row: int) -> list[int]:
        """The blocks of rows [first_row, end_row) whose bytes are not those written; first_row
        begins one.
        """
        bad = []
        step = max(1, _ROWS_AT_ONCE // self.block_rows) * self.block_rows
        for start in range(first_row, end_row, step):
            stop = min(start + step, end_row)
            try:
                columns = [_little_endian(d[start:stop]) for d in self._datasets.values()]
                said = self._crc32[start // self.block_rows : -(-stop // self.block_rows)]
            except (OSError, RuntimeError):  # what cannot be read is as bad as what reads wrong
                if stop - start <= self.block_rows:
                    bad.append(start // self.block_rows)
                else:
                    for begin in range(start, stop, self.block_rows):
                        bad += self.bad_blocks(begin, min(begin + self.block_rows, stop))
                continue
            for index, begin in enumerate(range(0, stop - start, self.block_rows)):
                crc = 0
                for column in columns:
                    crc = zlib.crc32(column[begin : begin + self.block_rows], crc)
                if crc != int(said[index]) & 0xFFFFFFFF:
                    bad.append(start // self.block_rows + index)
        return bad

    def check(self) -> None:
        """Checks every block once. Raises DamagedSession unless damaged rows are to be skipped."""
        if self._kept is not None:
            return
        rows = self.common_rows()
        bad = self.bad_blocks(0, rows)
        kept = np.ones(rows, dtype=bool)
        for block in bad:
            kept[block * self.block_rows : (block + 1) * self.block_rows] = False
        if bad and not self._skip:
            raise self.damaged(bad, rows)
        self._rows, self._bad_blocks, self._kept = rows, bad, kept

    def damaged(self, bad: list[int], rows: int) -> DamagedSession:
        """The error that tells of damaged blocks, with the ticks that each run of them spans."""
        runs: list[list[int]] = []
        for block in bad:
            if runs and runs[-1][1] == block:
                runs[-1][1] = block + 1
            else:
                runs.append([block, block + 1])
        spans = [
            self._ticks_of(first * self.block_rows, min(end * self.block_rows, rows))
            for first, end in runs
        ]
        words = ", ".join(f"{first} to {last}" for first, last in spans)
        what = "ticks" if "tick" in self._datasets else "rows"
        return DamagedSession(
            f"The file is damaged in /{self.name}, {what} {words}: these bytes are not those that "
            "were written. "
            'Copy it anew from where it came; Session(path, damaged="skip") reads the rest.',
            self.name,
            spans,
        )

    def _ticks_of(self, first: int, end: int) -> tuple[int, int]:
        """The ticks of rows [first, end), by the ticks of the rows around them, which are whole."""
        if "tick" not in self._datasets:
            return first, end - 1
        try:
            return self._ticks_around(self._datasets["tick"], first, end)
        except (OSError, RuntimeError):  # unreadable themselves: the rows are all there is to say
            return first, end - 1

    def _ticks_around(self, tick: h5py.Dataset, first: int, end: int) -> tuple[int, int]:
        if self.name != "ticks":  # rows are far apart: only their own says which
            return int(tick[first]), int(tick[end - 1])
        before = int(tick[first - 1]) if first > 0 else None
        after = int(tick[end]) if end < tick.shape[0] else None
        if before is None and after is None:
            return int(tick[first]), int(tick[end - 1])
        return (
            after - (end - first) if before is None else before + 1,
            before + (end - first) if after is None else after - 1,
        )


def _little_endian(values: np.ndarray) -> np.ndarray:
    values = np.ascontiguousarray(values)
    return values.astype(values.dtype.newbyteorder("<"), copy=False)
