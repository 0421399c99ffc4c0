"""What can be wrong with a session file, as sentences for the person who opened it."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager


class SessionError(Exception):
    """The file cannot be read as a session. `str()` is a sentence with the way out."""


class Unreadable(SessionError):
    """The file is not there, or the system does not let it be read."""


class MissingLibrary(SessionError):
    """A library that this form of export takes is not installed, or does not work."""


class DamagedSession(SessionError):
    """A block of the file holds other bytes than were written.

    Attributes: `spans`, a list of (first, last) of the `tick` column's own rows before and after
    the damage: the ticks from `first` to `last` cannot be trusted; `table`, the group's name.
    """

    def __init__(self, sentence: str, table: str, spans: list[tuple[int, int]]):
        super().__init__(sentence)
        self.table = table
        self.spans = spans


_CONTROLS = re.compile(
    "[\x00-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff]"
)


def printed(words: object) -> str:
    """What a file says, for a line that is printed: its control characters as JSON escapes them, so
    that it stays one line and a terminal does nothing but show it.
    """
    return _CONTROLS.sub(
        lambda found: "\\n" if found[0] == "\n" else f"\\u{ord(found[0]):04x}", str(words)
    )


@contextmanager
def library_errors(what: str) -> Iterator[None]:
    """Inside of it, what HDF5 throws at a damaged file becomes a SessionError about `what`."""
    try:
        yield
    except (KeyError, OSError, RuntimeError, TypeError, ValueError) as error:
        reason = str(error).strip("'\"")
        raise SessionError(
            f"{what} cannot be read ({reason}). The file is damaged: copy it anew."
        ) from error


@contextmanager
def drawing_errors() -> Iterator[None]:
    """Inside of it, what matplotlib throws at numbers and scenes that no recording holds becomes a
    SessionError.
    """
    try:
        yield
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        if isinstance(error.__context__, OSError):  # matplotlib stumbles over a full disk
            raise error.__context__ from None
        raise SessionError(
            f"What this session holds cannot be drawn ({type(error).__name__}: {error}). "
            "Its numbers or its scene are none that a recording has."
        ) from error


def missing(module: str | None) -> str:
    """What to do where Python does not find a library."""
    if sys.prefix != sys.base_prefix:  # a virtual environment, which has no packages of Debian
        return (
            f"Python ({sys.executable}) has no {module}. `pip install 'underact[all]'` brings it."
        )
    return (
        f"Python ({sys.executable}) has no {module}. Install python3-h5py, python3-matplotlib and "
        "python3-pandas, or name a Python that has them in UNDERACT_PYTHON."
    )
