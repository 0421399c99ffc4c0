"""Opens a session file: what the arm, the scene and the servo did, tick by tick.

    from underact import Session
    with Session("first.h5") as session:
        error_mm = session.ticks["error_mm"]

The file's page is resources/guide/session_file.md. Lengths mm, angles rad, forces N; undefined
is NaN.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from . import bounds, layout
from .errors import DamagedSession, SessionError, library_errors
from .opening import open_file
from .table import Table

_SETTLES_S = 2.0  # a block that a writer is in the middle of is whole after so long, or is damaged


@dataclass(frozen=True)
class Change:
    """A scene that came into effect. carry: loaded, gains or targets. scene: {} where none was
    loaded.
    """

    tick: int
    revision: int
    carry: str
    scene: dict


@dataclass(frozen=True)
class Marker:
    """A mark that somebody set."""

    tick: int
    label: str


@dataclass(frozen=True)
class Fault:
    """Why the force went to zero. kind: a word; seen, allowed: in the unit that belongs to it."""

    tick: int
    kind: str
    seen: float
    allowed: float
    from_servo: bool


@dataclass(frozen=True)
class End:
    """How the recording ended. unix_ns: the clock; dropped: ticks that found no room."""

    tick: int
    dropped: int
    unix_ns: int
    reason: str


class Session:
    """A session file, open for reading; close it, or use it in a `with`.

    path: the file. damaged: "raise" (DamagedSession at the first reading of a damaged table) or
    "skip" (its rows are left out). Raises Unreadable where there is no file to read, SessionError
    where it is no session of this version.
    """

    def __init__(self, path: str | Path, damaged: str = "raise"):
        if damaged not in ("raise", "skip"):
            raise ValueError('damaged is "raise" or "skip"')
        self.path = Path(path)
        self._damaged = damaged
        self._file = open_file(self.path)
        try:
            with library_errors(f"{self.path}: its content"):
                self._look()
        except BaseException:
            self._file.close()
            raise

    def _look(self) -> None:
        version = bounds.attribute(self._file, "underact_session")
        if version is None:
            raise SessionError(f"{self.path} is an HDF5 file, but not a session of Underact.")
        if version != layout.VERSION:
            raise SessionError(
                f"{self.path} has layout {version}; this program reads layout {layout.VERSION}. "
                "Open it with the version of the program that wrote it, or a newer one."
            )
        tables = {
            name: Table(self._file, name, columns, self._damaged)
            for name, columns in layout.TABLES.items()
            if name not in layout.OPTIONAL or name in self._file
        }
        #: /ticks: the columns by name, as numpy arrays
        self.ticks: Table = tables["ticks"]
        self._tables = tables

    @property
    def attributes(self) -> dict[str, object]:
        """The attributes of the file: who, with what arm, when; words as str. Those that are no
        single number or text of fixed length, or longer than a mebibyte, are left out.
        """
        with library_errors(f"{self.path}: its attributes"):
            found = {name: bounds.attribute(self._file, name) for name in self._file.attrs}
            return {name: value for name, value in found.items() if value is not None}

    @property
    def time_s(self) -> np.ndarray:
        """The arm's clock at each tick, s."""
        return self.ticks["time_ns"] * 1e-9

    @property
    def changes(self) -> list[Change]:
        """The scenes in the order in which they came into effect; the first is that at the
        beginning.
        """
        return [self._change(row) for row in self._rows_with_words("changes")]

    @property
    def scene(self) -> dict:
        """The scene at the beginning, as in a scene file."""
        rows = self._rows_with_words("changes")
        if not rows:
            raise SessionError(
                f"{self.path} holds no scene: the recording ended before its first tick."
            )
        return self._change(rows[0]).scene

    @property
    def markers(self) -> list[Marker]:
        """The markers that somebody set, in the order of ticks. With damaged="skip" a label that
        cannot be had is "?".
        """
        left, marks = layout.ALL_LABELS, []
        for tick, at, size in self._rows_with_words("markers"):
            try:
                if size > min(layout.LONGEST_LABEL, left):
                    raise DamagedSession(
                        f"{self.path}: the label of the marker at tick {tick} is longer than a "
                        f"label may be ({layout.LONGEST_LABEL >> 10} KiB, all together "
                        f"{layout.ALL_LABELS >> 20} MiB). The file is damaged: copy it anew from "
                        'where it came; Session(path, damaged="skip") reads the rest.',
                        "markers",
                        [(tick, tick)],
                    )
                label = self._text(at, size)
                left -= size
            except SessionError:
                if self._damaged == "raise":
                    raise
                label = "?"
            marks.append(Marker(tick, label))
        return marks

    @property
    def faults(self) -> list[Fault]:
        """The faults, in the order of ticks."""
        table = self._tables["faults"]
        rows = zip(*(table[c].tolist() for c in layout.TABLES["faults"]))
        return [
            Fault(t, layout.word(layout.FAULTS, k), seen, allowed, bool(own))
            for t, k, seen, allowed, own in rows
        ]

    @property
    def end(self) -> End | None:
        """How the recording ended; None where it did not end in order, or goes on."""
        table = self._tables["end"]
        if table.rows == 0:
            return None
        tick, dropped, unix_ns, reason = (int(table[c][-1]) for c in layout.TABLES["end"])
        return End(tick, dropped, unix_ns, layout.word(layout.REASONS, reason))

    @property
    def complete(self) -> bool:
        """Whether the recording ended in order."""
        return self._tables["end"].common_rows() > 0

    @property
    def provenance(self) -> dict:
        """What was run: session, program and its build, machine, arm, servo, run (hand, seed, arm
        model), gains as they acted, files by checksum. {} in a session of an earlier version.
        """
        rows = self._rows_with_words("provenance")
        return self._json(*rows[0][1:], "its provenance") if rows else {}

    @property
    def provenance_changes(self) -> list[tuple[int, dict]]:
        """(tick, the members of provenance that are others from there on), in order."""
        rows = self._rows_with_words("provenance")[1:]
        return [(tick, self._json(at, size, "its provenance")) for tick, at, size in rows]

    @property
    def clock(self) -> dict[str, np.ndarray]:
        """The system's clocks at some ticks: at the beginning, every ten seconds, at the end.
        tick, time_ns (the arm's), monotonic_ns, unix_ns (UTC), between_ns. No rows in a session
        of an earlier version.
        """
        table = self._tables.get("clock")
        if table is None:
            return {name: np.empty(0, "<i8") for name in layout.TABLES["clock"]}
        return {name: table[name] for name in table}

    @property
    def truth(self) -> "Table | None":
        """What the simulated arm knows of each tick, by column; None where it was not recorded."""
        return self._tables.get("truth")

    @property
    def constraints(self) -> "Table | None":
        """Each constraint in each tick, by column; None where it was not recorded."""
        return self._tables.get("constraints")

    @property
    def joints(self) -> "Table | None":
        """Joints 7 and 8 of the ticks of an arm that has them, by column; None in a session of an
        earlier version. more_joints() has a row for every tick.
        """
        return self._tables.get("joints")

    def more_joints(self) -> np.ndarray | None:
        """Joints 7 and 8 at each tick, shape (rows, 2), rad, or m where a joint slides; 0 where the
        arm does not have them, NaN where the file is damaged. None: no arm has more than six.
        """
        table = self.joints
        if table is None or table.common_rows() == 0:
            return None
        ticks, known, values = self.ticks["tick"], table["tick"], table[layout.MORE]
        if len(known) == 0:
            return np.full((len(ticks), values.shape[1]), np.nan)
        found = np.where((ticks >= known[0])[:, None], np.nan, np.zeros(values.shape[1]))
        at = np.minimum(np.searchsorted(known, ticks), len(known) - 1)
        there = known[at] == ticks
        found[there] = values[at[there]]
        return found

    @property
    def duration_s(self) -> float:
        """From the first tick to the last, s; 0 where there are fewer than two."""
        time_ns = self.ticks["time_ns"]
        return float(time_ns[-1] - time_ns[0]) * 1e-9 if len(time_ns) > 1 else 0.0

    def frame(self) -> "pandas.DataFrame":  # noqa: F821
        """All ticks as a pandas DataFrame, a row a tick.

        Columns: time_s, then those of /ticks; a vector is split (p_WT_mm_x, p_WT_mm_y, p_WT_mm_z;
        q1_rad to q6_rad, and q7_rad and q8_rad where an arm has them; alpha_rad, beta_rad,
        theta_rad). Needs pandas.
        """
        import pandas

        return pandas.DataFrame({"time_s": self.time_s, **_split(tick_columns(self))})

    def follow(
        self,
        poll_s: float = 0.1,
        timeout_s: float | None = None,
        stop: Callable[[], bool] = lambda: False,
    ) -> Iterator[dict[str, np.ndarray]]:
        """Yields new rows of /ticks as the file grows, beginning with those that are there.

        Each item holds the new rows of every column. Ends when the recording ends, when nothing
        came for
        timeout_s (None: waits for ever), or when stop() is true. poll_s: between two looks.
        """
        table, taken, last_growth = self.ticks, 0, time.monotonic()
        while not stop():
            self._tables["end"].refresh()
            ended = self.complete  # before the look at the rows, so that none is missed
            table.refresh()
            rows = table.common_rows()
            bad = table.bad_blocks(taken, rows) if rows > taken else []
            waited_s = time.monotonic() - last_growth
            if bad and (ended or waited_s > _SETTLES_S) and self._damaged == "raise":
                raise table.damaged(bad, rows)
            settled = ended or not bad or waited_s > _SETTLES_S
            whole = rows if settled else bad[0] * table.block_rows
            if not ended:  # a short block may still be growing
                whole -= whole % table.block_rows
            if whole > taken:
                yield table.between(taken, whole, bad if settled else [])
                taken, last_growth = whole, time.monotonic()
            elif ended or (timeout_s is not None and waited_s > timeout_s):
                return
            else:
                time.sleep(poll_s)

    def _rows_with_words(self, name: str) -> list[tuple[int, ...]]:
        """The rows of /changes or /markers. Words stand one after the other, so all together they
        are no more than /text has.
        """
        table = self._tables.get(name)
        if table is None:
            return []
        rows = list(zip(*(table[column].tolist() for column in layout.TABLES[name])))
        all_words = self._tables["text"].common_rows()
        if name == "changes" and sum(max(row[-1], 0) for row in rows) > all_words:
            raise SessionError(
                f"{self.path}: its scenes are longer than all words in it. The file is damaged: "
                "copy it anew from where it came."
            )
        return rows

    def _text(self, at: int, size: int) -> str:
        if size == 0:
            return ""
        try:
            stored = self._tables["text"].stretch(at, at + size)
        except DamagedSession:
            if self._damaged == "raise":
                raise
            stored = None
        if stored is None:
            raise SessionError(
                f"{self.path}: the words that belong to a row are damaged or missing in /text."
            )
        return stored["bytes"].tobytes().decode("utf-8", "replace")

    def _change(self, row: tuple[int, ...]) -> Change:
        tick, revision, carry, at, size = row
        return Change(tick, revision, layout.word(layout.CARRIES, carry), self._scene(at, size))

    def _scene(self, at: int, size: int) -> dict:
        if size == 0:  # nothing was loaded yet
            return {}
        return self._json(at, size, "a scene in it")

    def _json(self, at: int, size: int, what: str) -> dict:
        if size > layout.LONGEST_SCENE:
            raise SessionError(
                f"{self.path}: {what} has {size} bytes, and may have at most "
                f"{layout.LONGEST_SCENE}. The file is damaged: copy it anew from where it came."
            )
        try:
            found = json.loads(self._text(at, size))
        except (ValueError, RecursionError) as error:
            words = f"{self.path}: {what} is not valid JSON ({error})."
            raise SessionError(words) from error
        if not isinstance(found, dict):
            raise SessionError(f"{self.path}: {what} is not a JSON object.")
        return found

    def close(self) -> None:
        """Closes the file; the arrays read so far stay."""
        self._file.close()

    def __enter__(self) -> "Session":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"Session({str(self.path)!r})"


def tick_columns(session: Session) -> dict[str, np.ndarray]:
    """All columns of the ticks: those of /ticks, and joints 7 and 8 of an arm that has them."""
    more = session.more_joints()
    return {**session.ticks} if more is None else {**session.ticks, layout.MORE: more}


def _split(columns: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Columns of one number each, by the names of layout.part_names."""
    parts = {}
    for name in columns:
        values = columns[name]
        if values.ndim == 1:
            parts[name] = values
        else:
            names = layout.part_names(name)
            if len(names) != values.shape[1]:  # a column that this version does not know
                names = [f"{name}_{index + 1}" for index in range(values.shape[1])]
            parts.update({part: values[:, index] for index, part in enumerate(names)})
    return parts


__all__ = ["Change", "DamagedSession", "End", "Fault", "Marker", "Session", "SessionError"]
