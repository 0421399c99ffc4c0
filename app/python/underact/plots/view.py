"""What the plots draw from: a stretch of a session, as arrays."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..errors import SessionError
from ..session import Fault, Marker, Session


@dataclass
class View:
    """A stretch of a session. time_s counts from the session's first tick; columns are those of
    /ticks.
    """

    time_s: np.ndarray
    columns: dict[str, np.ndarray]
    scene: dict
    footer: str
    rate_hz: float
    marks: list[tuple[float, str]] = field(default_factory=list)  # time_s, label
    faults: list[tuple[float, str]] = field(default_factory=list)
    session_id: str = ""

    def __getitem__(self, column: str) -> np.ndarray:
        return self.columns[column]


_COLUMNS = (
    "tick",
    "q_rad",
    "p_WT_mm",
    "quat_WT",
    "p_WP_mm",
    "error_mm",
    "force_asked_N",
    "force_sent_N",
    "gate_level",
    "limits",
    "alpha_beta_theta_rad",
    "energy_mJ",
    "passive_N",
    "lateness_us",
    "tick_us",
)


def view_of(
    session: Session,
    from_s: float | None = None,
    to_s: float | None = None,
    footer: str | None = None,
) -> View:
    """The ticks of a session from from_s to to_s, s since its first tick; None: from or to its end.

    Raises SessionError where no tick is in between.
    """
    time_ns = session.ticks["time_ns"]
    if len(time_ns) == 0:
        raise SessionError(
            f"{session.path} holds no tick: the recording ended before the first was written."
        )
    time_s = (time_ns - time_ns[0]) * 1e-9
    low, high = (time_s[0] if from_s is None else from_s), (time_s[-1] if to_s is None else to_s)
    inside = np.flatnonzero((time_s >= low) & (time_s <= high))
    # The clock rises, so they lie together; a slice copies nothing, and an hour is some 1 GB.
    rows = slice(inside[0], inside[-1] + 1) if len(inside) else slice(0, 0)
    if not len(inside):
        raise SessionError(
            f"{session.path} has no tick from {low:g} s to {high:g} s; it lasts {time_s[-1]:g} s."
        )
    tick = session.ticks["tick"]

    def at(events: list[Marker] | list[Fault], words: str) -> list[tuple[float, str]]:
        times = [float(np.interp(event.tick, tick, time_s)) for event in events]
        return [(t, getattr(e, words)) for t, e in zip(times, events) if low <= t <= high]

    attributes = session.attributes
    rate_hz = attributes.get("rate_hz")
    stated = isinstance(rate_hz, (int, float)) and 1 <= rate_hz <= 1_000_000
    return View(
        time_s[rows],
        {column: session.ticks[column][rows] for column in _COLUMNS},
        session.scene,
        footer if footer is not None else footer_of(attributes),
        float(rate_hz) if stated else _rate_hz(time_s),
        at(session.markers, "label"),
        at(session.faults, "kind"),
        str(attributes.get("session_id") or ""),
    )


def footer_of(attributes: dict, *more: str) -> str:
    """Scene, name of the session, arm, device and version, as far as the file says them."""
    version = attributes.get("program_version")
    words = [
        attributes.get("scene_title"),
        attributes.get("name"),
        attributes.get("arm"),
        attributes.get("device"),
    ]
    return " · ".join(
        str(word) for word in [*words, *more, f"Underact {version}" if version else ""] if word
    )


def _rate_hz(time_s: np.ndarray) -> float:
    period_s = float(np.median(np.diff(time_s))) if len(time_s) > 1 else 0.0
    return 1.0 / period_s if period_s > 0.0 else 1000.0
