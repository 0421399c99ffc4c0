"""A table of a session file: a group whose datasets are its columns, with a CRC-32 for each block
of rows.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Mapping

import h5py
import numpy as np

from . import bounds, layout
from .chunks import read_rows
from .errors import DamagedSession, SessionError, library_errors

_ROWS_AT_ONCE = 65536  # while checking: some 30 MB of ticks


_MAX_TOLD = 1000  # stretches of damage that an error tells the ticks of, and 20 in its words


def _columns_of(group: h5py.Group) -> list[str]:
    names = bounds.attribute(group, "columns")
    names = names.replace(",", " ").split() if isinstance(names, str) else []
    return [name for name in dict.fromkeys(names) if name != "crc32"]


class Table(Mapping):
    """The columns of a table by name, each a numpy array cut to the rows that all columns have.

    table["q_rad"]: shape (rows, 6); one number a row: shape (rows,). `units`, `meanings` and
    `frames` hold what the file says of each column. Blocks are checked at the first access to a
    column: a damaged one raises DamagedSession, or with damaged="skip" its rows are left out of
    every column.
    """

    def __init__(self, file: h5py.File, name: str, wanted: dict[str, int], damaged: str):
        self.name = name
        group = file.get(name) if bounds.is_own(file, name) else None
        where = f"{file.filename}: the table /{name}"
        if not isinstance(group, h5py.Group):
            raise SessionError(f"{where} is missing. The session is incomplete: record it again.")
        order = _columns_of(group)
        foreign = {name for name in [*order, "crc32"] if not bounds.is_own(group, name)}
        lost = sorted(set(wanted) - set(order) | foreign)
        if lost:
            raise SessionError(f"{where} lacks {', '.join(lost)}. The session is incomplete.")
        self._datasets = {column: group[column] for column in order}
        self._crc32 = group["crc32"]
        self._file = file
        self.block_rows = bounds.block_rows_of(where, name, group)
        for column, dataset in self._datasets.items():
            width = wanted.get(column)
            shape = getattr(dataset, "shape", ())
            numbers = 1 if len(shape) == 1 else shape[1] if len(shape) == 2 else 0
            if numbers == 0 or dataset.dtype.kind not in "iufb" or width not in (None, numbers):
                raise SessionError(
                    f"{where} has a column {column} that is not {width} numbers a row."
                )
        self._check_bounds(where)
        columns = self._datasets.items()
        self.units = {column: bounds.attribute(d, "unit") or "" for column, d in columns}
        self.meanings = {column: bounds.attribute(d, "meaning") or "" for column, d in columns}
        self.frames = {column: bounds.attribute(d, "frame") or "" for column, d in columns}
        self._skip = damaged == "skip"
        self._kept: np.ndarray | None = None  # whether a row is kept; None: not checked yet
        self._bad_blocks: list[int] = []
        self._rows = 0

    def _check_bounds(self, where: str) -> None:
        """Raises SessionError where the table is not as a file of its length may have it."""
        chunk_rows = self.block_rows if self.name in layout.LONG else layout.BLOCKS[self.name][1]
        for column, dataset in self._datasets.items():
            rows = chunk_rows
            bounds.check_layout(where, column, dataset, rows)
        if not isinstance(self._crc32, h5py.Dataset) or self._crc32.ndim != 1:
            raise SessionError(f"{where} has no checksums. The session is incomplete.")
        bounds.check_layout(where, "crc32", self._crc32, layout.CHECKS_CHUNK)
        columns = [*self._datasets.values()]
        block_bytes = self.block_rows * sum(map(bounds.row_bytes, columns))
        lengths = [dataset.shape[0] for dataset in [self._crc32, *columns]]
        if block_bytes > layout.MAX_BLOCK_BYTES or max(lengths) > self._most_rows():
            raise SessionError(
                f"{where} says that it has {max(lengths)} rows, which is more than the file has "
                "bytes for. It is damaged: copy it anew from where it came."
            )

    def _most_rows(self) -> int:
        columns = [*self._datasets.values()]
        return bounds.max_rows(columns, self.block_rows, bounds.file_bytes(self._file))

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
            parts = [read_rows(dataset, first, end) for first, end in edges.reshape(-1, 2).tolist()]
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
        """The rows that all columns have now, of blocks whose CRC-32 is there; no more than the
        file has bytes for, however it grows.
        """
        lengths = [dataset.shape[0] for dataset in self._datasets.values()]
        return min([*lengths, self._crc32.shape[0] * self.block_rows, self._most_rows()])

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
            if len(bad) > layout.MAX_DAMAGED_BLOCKS:
                raise SessionError(
                    f"{self._file.filename}: more than {layout.MAX_DAMAGED_BLOCKS} blocks of "
                    f"/{self.name} are damaged. Copy it anew from where it came."
                )
            stop = min(start + step, end_row)
            try:
                columns = [
                    _little_endian(read_rows(d, start, stop)) for d in self._datasets.values()
                ]
                blocks = (start // self.block_rows, -(-stop // self.block_rows))
                sums = read_rows(self._crc32, *blocks)
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
                if crc != int(sums[index]) & 0xFFFFFFFF:
                    bad.append(start // self.block_rows + index)
        return bad

    def stretch(self, first_row: int, end_row: int) -> dict[str, np.ndarray] | None:
        """Rows [first_row, end_row) of every column, of which no other is looked at; None: they are
        not all there. Raises DamagedSession where a block of them is damaged.
        """
        rows = self.common_rows()
        if not 0 <= first_row <= end_row <= rows:
            return None
        begin = first_row - first_row % self.block_rows
        end = min(-(-end_row // self.block_rows) * self.block_rows, rows)
        bad = self.bad_blocks(begin, end)
        if bad:
            raise self.damaged(bad, rows)
        kept = np.ones(end_row - first_row, dtype=bool)
        return {column: self._read(column, first_row, kept) for column in self}

    def check(self) -> None:
        """Checks every block once. Raises DamagedSession unless damaged rows are to be skipped."""
        if self._kept is not None:
            return
        rows = self.common_rows()
        if rows > layout.MAX_ROWS.get(self.name, rows):
            raise SessionError(
                f"{self._file.filename}: /{self.name} has {rows} rows, and a session at most "
                f"{layout.MAX_ROWS[self.name]}. It is damaged: copy it anew from where it came."
            )
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
            for first, end in runs[:_MAX_TOLD]
        ]
        words = ", ".join(f"{first} to {last}" for first, last in spans[:20])
        words += f" and {len(runs) - 20} stretches more" if len(runs) > 20 else ""
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
