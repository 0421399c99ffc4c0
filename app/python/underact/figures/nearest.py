"""The thesis's nearest points (its chapter 4, misprints corrected), to check the program against.

Shares no line with the program. Arrays (n, 3), mm, in W.
"""

from __future__ import annotations

import numpy as np


def dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Row by row, (n, 1)."""
    return np.sum(a * b, axis=-1, keepdims=True)


def unit(a: np.ndarray) -> np.ndarray:
    """Each row at length 1; the zero row gives NaN."""
    with np.errstate(invalid="ignore"):
        return a / np.linalg.norm(a, axis=-1, keepdims=True)


def nearest(constraint: dict, p_mm: np.ndarray) -> np.ndarray:
    """The nearest point on a constraint of a scene: eq. 4.3, 4.5 with a of 4.9 (sign corrected),
    4.14, 4.20, 4.26.
    """
    kind = constraint["type"]
    if kind == "point":
        return np.broadcast_to(np.asarray(constraint["position_mm"], dtype=float), p_mm.shape)
    key = {"sphere": "center_mm", "circle": "center_mm"}.get(kind, "point_mm")
    center = np.asarray(constraint[key], dtype=float)
    away = p_mm - center
    if kind == "sphere":
        return center + constraint["radius_mm"] * unit(away)
    axis = unit(
        np.asarray(
            constraint[{"line": "direction", "cylinder": "axis"}.get(kind, "normal")], dtype=float
        )
    )
    along = dot(away, axis) * axis
    if kind == "line":
        return center + along
    if kind == "plane":
        return p_mm - along
    on_rim = center + constraint["radius_mm"] * unit(away - along)
    if kind == "circle":
        return on_rim
    if kind == "cylinder":
        return on_rim + along
    raise ValueError(f"no closed form for {kind}")


def wrap(angle_rad: np.ndarray) -> np.ndarray:
    """Into (-pi, pi]."""
    return np.pi - np.mod(np.pi - angle_rad, 2 * np.pi)


def stylus_axis(quat_WT: np.ndarray) -> np.ndarray:
    """z of frame 6 in W, (n, 3), from quaternions w x y z."""
    w, x, y, z = quat_WT.T
    return np.stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], axis=1)
