"""The shapes of a scene: makers for scenes in code, and lines in space for 3D plots. All lengths
mm, in the frame W.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Points = NDArray[np.float64]

__all__ = ["point", "sphere", "line", "plane", "circle", "cylinder", "box", "ellipsoid"]


def plain(value: Any) -> Any:
    """What json.dumps() does not know: numbers and arrays of numpy."""
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError("This is a masked array. Pass a plain one, as filled() returns.")
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if isinstance(value, Mapping):
        return {str(key): plain(one) for key, one in value.items()}
    return [plain(one) for one in value] if isinstance(value, (list, tuple)) else value


def constraint(type_: str, others: dict[str, Any], **required: Any) -> dict[str, Any]:
    """A constraint as in a file."""
    numbers = {key: np.asanyarray(value) for key, value in required.items()}
    return plain({"type": type_, **numbers, **others})


def point(position_mm: ArrayLike, **others: Any) -> dict[str, Any]:
    """A point. others, here and below: name, side, control, influence, friction and so on, as in a
    file.
    """
    return constraint("point", others, position_mm=position_mm)


def sphere(center_mm: ArrayLike, radius_mm: float, **others: Any) -> dict[str, Any]:
    """A sphere."""
    return constraint("sphere", others, center_mm=center_mm, radius_mm=radius_mm)


def line(point_mm: ArrayLike, direction: ArrayLike, **others: Any) -> dict[str, Any]:
    """An infinite line."""
    return constraint("line", others, point_mm=point_mm, direction=direction)


def plane(point_mm: ArrayLike, normal: ArrayLike, **others: Any) -> dict[str, Any]:
    """An infinite plane; the normal points outside."""
    return constraint("plane", others, point_mm=point_mm, normal=normal)


def circle(
    center_mm: ArrayLike, normal: ArrayLike, radius_mm: float, **others: Any
) -> dict[str, Any]:
    """A circle about its centre, at right angles to the normal."""
    return constraint("circle", others, center_mm=center_mm, normal=normal, radius_mm=radius_mm)


def cylinder(
    point_mm: ArrayLike, axis: ArrayLike, radius_mm: float, **others: Any
) -> dict[str, Any]:
    """An infinite cylinder."""
    return constraint("cylinder", others, point_mm=point_mm, axis=axis, radius_mm=radius_mm)


def box(center_mm: ArrayLike, size_mm: ArrayLike, **others: Any) -> dict[str, Any]:
    """A box; size_mm: its full edges."""
    return constraint("box", others, center_mm=center_mm, size_mm=size_mm)


def ellipsoid(center_mm: ArrayLike, semi_axes_mm: ArrayLike, **others: Any) -> dict[str, Any]:
    """An ellipsoid; semi_axes_mm: half of its axes."""
    return constraint("ellipsoid", others, center_mm=center_mm, semi_axes_mm=semi_axes_mm)


def across(axis: ArrayLike) -> tuple[Points, Points, Points]:
    """Unit vectors u, v, a with a along `axis` (any length but zero) and u x v = a."""
    a = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    helper = np.eye(3)[np.argmin(np.abs(a))]
    u = helper - helper.dot(a) * a
    u /= np.linalg.norm(u)
    return u, np.cross(a, u), a


def ring(center: ArrayLike, normal: ArrayLike, radius: float, points: int = 121) -> Points:
    """Points of a circle, (points, 3), the last as the first."""
    u, v, _ = across(normal)
    angle = np.linspace(0, 2 * np.pi, points)[:, None]
    return np.asarray(center) + radius * (np.cos(angle) * u + np.sin(angle) * v)


def outlines(constraint: dict[str, Any], p_mm: Points) -> list[Points]:
    """The lines that show a constraint of a scene, each (n, 3).

    p_mm: (n, 3), where the stylus has been: what has no ends is drawn as far as that. Types
    without a shape of their own (a virtual manipulator, a mesh) give no lines.
    """
    draw = _OUTLINES.get(str(constraint.get("type")))
    return draw(constraint, np.atleast_2d(p_mm)) if draw else []


def _point(constraint: dict[str, Any], _: Points) -> list[Points]:
    center = np.asarray(constraint["position_mm"], dtype=float)
    return [center + 4.0 * np.outer([-1, 1], axis) for axis in np.eye(3)]


def _ball(center: ArrayLike, half_axes: Points) -> list[Points]:
    """The rings of a ball whose half axes are the columns."""
    origin = np.zeros(3)
    rings = [ring(origin, [np.cos(a), 0, np.sin(a)], 1) for a in np.radians(range(0, 180, 30))]
    for latitude in np.radians([-60, -30, 0, 30, 60]):
        rings.append(ring([0, np.sin(latitude), 0], [0, 1, 0], np.cos(latitude)))
    return [np.asarray(center, dtype=float) + one @ half_axes.T for one in rings]


def _sphere(constraint: dict[str, Any], _: Points) -> list[Points]:
    return _ball(constraint["center_mm"], constraint["radius_mm"] * np.eye(3))


def _ellipsoid(constraint: dict[str, Any], _: Points) -> list[Points]:
    R_WB = np.asarray(constraint.get("R_WB", np.eye(3)), dtype=float)
    return _ball(constraint["center_mm"], R_WB * np.asarray(constraint["semi_axes_mm"]))


def _line(constraint: dict[str, Any], p_mm: Points) -> list[Points]:
    point, _, _, along = _along(constraint["point_mm"], constraint["direction"], p_mm)
    return [point + np.outer(along, across(constraint["direction"])[2])]


def _plane(constraint: dict[str, Any], p_mm: Points) -> list[Points]:
    point = np.asarray(constraint["point_mm"], dtype=float)
    u, v, _ = across(constraint["normal"])
    ends = [_reach((p_mm - point) @ axis) for axis in (u, v)]
    lines = []
    for a in np.linspace(ends[0][0], ends[0][1], 9):
        lines.append(np.array([point + a * u + b * v for b in ends[1]]))
    for b in np.linspace(ends[1][0], ends[1][1], 9):
        lines.append(np.array([point + a * u + b * v for a in ends[0]]))
    return lines


def _circle(constraint: dict[str, Any], _: Points) -> list[Points]:
    return [ring(constraint["center_mm"], constraint["normal"], constraint["radius_mm"])]


def _cylinder(constraint: dict[str, Any], p_mm: Points) -> list[Points]:
    point, u, v, along = _along(constraint["point_mm"], constraint["axis"], p_mm)
    a, radius = across(constraint["axis"])[2], constraint["radius_mm"]
    rings = [ring(point + at * a, a, radius) for at in np.linspace(along[0], along[1], 6)]
    sides = [
        point + radius * (np.cos(turn) * u + np.sin(turn) * v) + np.outer(along, a)
        for turn in np.radians(range(0, 360, 30))
    ]
    return rings + sides


def _box(constraint: dict[str, Any], _: Points) -> list[Points]:
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
    point: ArrayLike, axis: ArrayLike, p_mm: Points
) -> tuple[Points, Points, Points, Points]:
    u, v, a = across(axis)
    place = np.asarray(point, dtype=float)
    return place, u, v, _reach((p_mm - place) @ a)


def _reach(along: Points) -> Points:
    """A little further than the data go, and never less than 20 mm."""
    lowest, highest = float(np.nanmin(along)), float(np.nanmax(along))
    more = max(5.0, 10.0 - (highest - lowest) / 2)
    return np.array([lowest - more, highest + more])


_OUTLINES = {name: globals()[f"_{name}"] for name in __all__}
