"""Reads the lab's tables: CSV with named columns, numbers as floats, empty fields as NaN."""

from __future__ import annotations

import csv
from pathlib import Path

from ..errors import SessionError, Unreadable


def _value(text: str) -> str | float | bool:
    if text in ("true", "false"):
        return text == "true"
    if text == "":
        return float("nan")
    try:
        return float(text)
    except ValueError:
        return text


def read(path: Path) -> list[dict]:
    """The rows of a table without its # lines. Raises Unreadable, SessionError."""
    try:
        with path.open(newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    except OSError as error:
        raise Unreadable(f"{path}: {error.strerror}.") from error
    if not rows:
        raise SessionError(f"{path}: this table is empty.")
    return [{key: _value(text or "") for key, text in row.items()} for row in rows]


def groups(rows: list[dict], key: str) -> dict:
    """The rows by what they have under key, in the order in which it comes first."""
    found: dict = {}
    for row in rows:
        found.setdefault(row[key], []).append(row)
    return found
