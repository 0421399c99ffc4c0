"""What was given, as the compiled part takes it; TypeError or ValueError, with a sentence, for what
it cannot take.
"""

from __future__ import annotations

import math
import operator
import os
from typing import Any


def whole(value: Any, name: str, least: int, most: int) -> int:
    """A whole number from least to most."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be a whole number, not {kind(value)}.") from None
    if isinstance(value, bool):
        raise TypeError(f"{name} must be a whole number, not bool.")
    if not least <= number <= most:
        raise ValueError(f"{name} must be from {least} to {most}.")
    return number


def number(value: Any, name: str, least: float, most: float) -> float:
    """A number from least to most."""
    if isinstance(value, (str, bytes, bool)):
        raise TypeError(f"{name} must be a number, not {kind(value)}.")
    try:
        given = float(value)
    except OverflowError:
        given = math.inf
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, not {kind(value)}.") from None
    if not least <= given <= most:
        raise ValueError(f"{name} must be from {least:g} to {most:g}.")
    return given


def text(value: Any, name: str) -> str:
    """A text that can be written as UTF-8."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a text, not {kind(value)}.")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise ValueError(f"{name} has half a surrogate pair, which is no text in UTF-8.") from None
    return value


def path(value: Any, name: str) -> str:
    """The name of a file, or of what ships with the program."""
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{name} must be a name or a path, not {kind(value)}.")
    found = os.fspath(value)
    if isinstance(found, bytes):
        raise TypeError(f"{name} must be a name or a path of text, not of bytes.")
    if "\0" in found:
        raise ValueError(f"{name} has a zero in it, which no path has.")
    return text(found, name)


def kind(value: Any) -> str:
    """The type's name, in a message."""
    return type(value).__name__
