"""Thins long columns for drawing, so that no peak is lost and a picture has no more points than it
can show.
"""

from __future__ import annotations

import numpy as np


def thin(x: np.ndarray, y: np.ndarray, columns: int) -> tuple[np.ndarray, np.ndarray]:
    """x and y with few points for each of `columns` equal spans of x: first, least, greatest, last.

    x rises. A line through them covers the same pixels as one through all points, where a span is a
    pixel wide. NaN stays a gap: a span with one keeps one. Short data come back as they are.
    """
    x, y = np.asarray(x), np.asarray(y, dtype=float)
    if len(x) <= 4 * columns or columns < 1:
        return x, y
    span = np.minimum(((x - x[0]) * (columns / max(x[-1] - x[0], 1e-300))).astype(int), columns - 1)
    starts = np.flatnonzero(np.diff(span, prepend=-1))
    ends = np.append(starts[1:], len(x))
    keep = set(starts.tolist()) | set((ends - 1).tolist())
    for start, end in zip(starts.tolist(), ends.tolist()):
        part = y[start:end]
        gaps = np.isnan(part)
        if gaps.any():
            keep.add(start + int(np.argmax(gaps)))
            if gaps.all():
                continue
        keep.add(start + int(np.nanargmin(part)))
        keep.add(start + int(np.nanargmax(part)))
    index = np.array(sorted(keep))
    return x[index], y[index]


def evenly(count: int, at_most: int) -> np.ndarray:
    """Indices into `count` rows, evenly spread, at most so many, with the first and the last."""
    if count <= at_most:
        return np.arange(count)
    return np.unique(np.linspace(0, count - 1, at_most).round().astype(int))
