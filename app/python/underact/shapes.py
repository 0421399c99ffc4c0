"""The shapes of a scene as lines in space, for 3D plots. All lengths mm, in the frame W."""

from __future__ import annotations

import numpy as np


def across(axis: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Unit vectors u, v, a with a along `axis` (any length but zero) and u x v = a."""
    a = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    helper = np.eye(3)[np.argmin(np.abs(a))]
    u = helper - helper.dot(a) * a
    u /= np.linalg.norm(u)
    return u, np.cross(a, u), a


def circle(center: np.ndarray, normal: np.ndarray, radius: float, points: int = 121) -> np.ndarray:
    """Points of a circle, (points, 3), the last as the first."""
    u, v, _ = across(normal)
    angle = np.linspace(0, 2 * np.pi, points)[:, None]
    return np.asarray(center) + radius * (np.cos(angle) * u + np.sin(angle) * v)


def outlines(constraint: dict, p_mm: np.ndarray) -> list[np.ndarray]:
    """The lines that show a constraint of a scene, each (n, 3).

    p_mm: (n, 3), where the stylus has been: what has no ends is drawn as far as that. Types
    without a
    shape of their own (a virtual manipulator, a mesh) give no lines.
    """
    draw = _OUTLINES.get(constraint.get("type"))
    return draw(constraint, np.atleast_2d(p_mm)) if draw else []


def _point(constraint: dict, _: np.ndarray) -> list[np.ndarray]:
    center = np.asarray(constraint["position_mm"], dtype=float)
    return [center + 4.0 * np.outer([-1, 1], axis) for axis in np.eye(3)]


def _sphere(constraint: dict, _: np.ndarray) -> list[np.ndarray]:
    center, radius = np.asarray(constraint["center_mm"], dtype=float), constraint["radius_mm"]
    lines = [
        circle(center, [np.cos(a), 0, np.sin(a)], radius) for a in np.radians(range(0, 180, 30))
    ]
    for latitude in np.radians([-60, -30, 0, 30, 60]):
        up = np.array([0, radius * np.sin(latitude), 0])
        lines.append(circle(center + up, [0, 1, 0], radius * np.cos(latitude)))
    return lines


def _line(constraint: dict, p_mm: np.ndarray) -> list[np.ndarray]:
    point, _, _, along = _along(constraint["point_mm"], constraint["direction"], p_mm)
    return [point + np.outer(along, across(constraint["direction"])[2])]


def _plane(constraint: dict, p_mm: np.ndarray) -> list[np.ndarray]:
    point = np.asarray(constraint["point_mm"], dtype=float)
    u, v, _ = across(constraint["normal"])
    ends = [_reach((p_mm - point) @ axis) for axis in (u, v)]
    lines = []
    for a in np.linspace(*ends[0], 9):
        lines.append(np.array([point + a * u + b * v for b in ends[1]]))
    for b in np.linspace(*ends[1], 9):
        lines.append(np.array([point + a * u + b * v for a in ends[0]]))
    return lines


def _circle(constraint: dict, _: np.ndarray) -> list[np.ndarray]:
    return [circle(constraint["center_mm"], constraint["normal"], constraint["radius_mm"])]


def _cylinder(constraint: dict, p_mm: np.ndarray) -> list[np.ndarray]:
    point, u, v, along = _along(constraint["point_mm"], constraint["axis"], p_mm)
    a, radius = across(constraint["axis"])[2], constraint["radius_mm"]
    rings = [circle(point + at * a, a, radius) for at in np.linspace(*along, 6)]
    sides = [
        point + radius * (np.cos(turn) * u + np.sin(turn) * v) + np.outer(along, a)
        for turn in np.radians(range(0, 360, 30))
    ]
    return rings + sides


def _box(constraint: dict, _: np.ndarray) -> list[np.ndarray]:
    R_WB = np.asarray(constraint.get("R_WB", np.eye(3)), dtype=float)
    half = np.asarray(constraint["size_mm"], dtype=float) / 2
    lines = []
    for axis in range(3):
        others = [other for other in range(3) if other != axis]
        for first in (-1, 1):
            for second in (-1, 1):
                ends = np.zeros((2, 3))
                ends[:, axis] = -half[axis], half[axis]
                ends[:, others[0]], ends[:, others[1]] = (
                    first * half[others[0]],
                    second * half[others[1]],
                )
                lines.append(np.asarray(constraint["center_mm"]) + ends @ R_WB.T)
    return lines


def _along(
    point: list, axis: list, p_mm: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    u, v, a = across(axis)
    point = np.asarray(point, dtype=float)
    return point, u, v, _reach((p_mm - point) @ a)


def _reach(along: np.ndarray) -> np.ndarray:
    """A little further than the data go, and never less than 20 mm."""
    least, most = float(np.nanmin(along)), float(np.nanmax(along))
    more = max(5.0, 10.0 - (most - least) / 2)
    return np.array([least - more, most + more])


_OUTLINES = {
    "point": _point,
    "sphere": _sphere,
    "line": _line,
    "plane": _plane,
    "circle": _circle,
    "cylinder": _cylinder,
    "box": _box,
}
