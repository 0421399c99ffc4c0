"""What a session file holds, in a few lines or as JSON."""

from __future__ import annotations

import json
from datetime import datetime, timezone

from .errors import printed
from .session import Session


def info_of(session: Session) -> dict:
    """Ticks, duration, whether it is complete, scene, arm, version, faults, markers, changes."""
    attributes = session.attributes
    started = _time_of(attributes.get("started_unix_ns"))
    return {
        "ticks": session.ticks.rows,
        "duration_s": session.duration_s,
        "complete": session.complete,
        "scene": attributes.get("scene_title"),
        "arm": attributes.get("arm"),
        "device": attributes.get("device"),
        "version": attributes.get("program_version"),
        "rate_hz": attributes.get("rate_hz"),
        "started": started.isoformat(timespec="seconds") if started else None,
        "name": attributes.get("name"),
        "subject": attributes.get("subject"),
        "consent": attributes.get("consent"),
        "changes": len(session.changes),
        "markers": [{"tick": mark.tick, "label": mark.label} for mark in session.markers],
        "faults": [{"tick": fault.tick, "kind": fault.kind} for fault in session.faults],
        "session_id": attributes.get("session_id"),
        "provenance": session.provenance,
        "provenance_changes": [
            {"tick": tick, "changed": changed} for tick, changed in session.provenance_changes
        ],
        "clock": {name: values.tolist() for name, values in session.clock.items()},
        "damaged_rows": sum(end - first for first, end in session.ticks.damage),
    }


def _time_of(unix_ns: object) -> datetime | None:
    if not isinstance(unix_ns, int) or unix_ns == 0:
        return None
    try:
        return datetime.fromtimestamp(unix_ns * 1e-9, timezone.utc)
    except (OSError, OverflowError, ValueError):  # of no year that there is
        return None


def print_info(session: Session, as_json: bool) -> None:
    """Prints info_of to standard output."""
    what = info_of(session)
    if as_json:
        print(printed(json.dumps(what, ensure_ascii=False)))
        return
    for key, value in what.items():
        if isinstance(value, dict) or key == "provenance_changes":
            continue  # with --json
        if isinstance(value, list):
            value = (
                ", ".join(
                    f"{one.get('label') or one.get('kind')} (tick {one['tick']})" for one in value
                )
                or "none"
            )
        print(printed(f"{key:13} {'' if value is None else value}"))
