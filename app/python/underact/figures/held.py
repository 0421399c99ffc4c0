"""What every figure of chapter 4 asserts: the target is the nearest point, and the force pulls
there by the law.
"""

from __future__ import annotations

import numpy as np

from ..plots.view import View
from .nearest import nearest
from .number import Number, worst

CLAMP_N = 0.88  # the arm's continuous force
KP_N_PER_MM = 0.5  # of the scenes


def unlimited(view: View) -> np.ndarray:
    """The ticks whose force went out as it was asked for: no limit, ramp at its end."""
    return (view["limits"] == 0) & (view["gate_level"] == 1)


def common_numbers(view: View) -> list[Number]:
    """Target, law, slope, direction and clamp, over every tick of a run with one constraint and the
    law P.
    """
    p, target, sent = view["p_WT_mm"], view["p_WP_mm"], view["force_sent_N"]
    expected = nearest(view.scene["constraints"][0], p)
    error = expected - p
    rows = unlimited(view)
    size = np.linalg.norm(sent, axis=1)
    pushes = size > 1e-3
    cross = np.linalg.norm(np.cross(sent[pushes], error[pushes]), axis=1)
    angle_deg = np.degrees(np.arctan2(cross, np.sum(sent[pushes] * error[pushes], axis=1)))
    # Least squares through the origin: all components of force against all of displacement (tip
    # less target).
    away = -error[rows].ravel()
    slope = (
        float(away @ sent[rows].ravel() / max(float(away @ away), 1e-300)) if rows.any() else np.nan
    )
    return [
        worst(
            (target - expected).ravel(),
            "target: maximum distance from the thesis's nearest point",
            1e-9,
            "mm",
        ),
        worst(
            (view["force_asked_N"] - KP_N_PER_MM * error).ravel(),
            "commanded force: maximum deviation from K_p e",
            1e-9,
            "N",
        ),
        Number(
            "slope of force against displacement, without limits",
            slope,
            -KP_N_PER_MM,
            1e-6,
            "N/mm",
        ),
        worst(angle_deg, "force: maximum angle from the direction to the target", 0.01, "deg"),
        worst(
            np.maximum(size - CLAMP_N, 0),
            "maximum force beyond the arm's continuous 0.88 N",
            1e-9,
            "N",
        ),
    ]


def held_rms_mm(view: View, from_s: float) -> float:
    """Root mean square of the distance to the target, from a time on, mm."""
    return float(np.sqrt(np.mean(view["error_mm"][view.time_s >= from_s] ** 2)))
