"""The layout of a session file (version 1): its tables, their columns, and what its numbers mean.

The page resources/guide/session_file.md says it in words; the two are compared by a test.
"""

VERSION = 1

#: table -> column -> numbers in a row
TABLES: dict[str, dict[str, int]] = {
    "ticks": {
        "tick": 1,
        "time_ns": 1,
        "q_rad": 6,
        "buttons": 1,
        "p_WT_mm": 3,
        "quat_WT": 4,
        "v_WT_mm_per_s": 3,
        "p_WP_mm": 3,
        "error_mm": 1,
        "force_asked_N": 3,
        "force_sent_N": 3,
        "gate_level": 1,
        "cut_N": 1,
        "limits": 1,
        "heat": 3,
        "fault": 1,
        "alpha_beta_theta_rad": 3,
        "energy_mJ": 1,
        "passive_N": 1,
        "lateness_us": 1,
        "tick_us": 1,
        "revision": 1,
        "input": 1,
    },
    "changes": {"tick": 1, "revision": 1, "carry": 1, "text_at": 1, "text_bytes": 1},
    "markers": {"tick": 1, "text_at": 1, "text_bytes": 1},
    "faults": {"tick": 1, "kind": 1, "seen": 1, "allowed": 1, "from_servo": 1},
    "end": {"tick": 1, "dropped": 1, "unix_ns": 1, "reason": 1},
    "text": {"bytes": 1},
}

FAULTS = (
    "none",
    "no_sample",
    "stale_sample",
    "not_finite",
    "too_fast",
    "too_late",
    "stood_still",
    "odd_clock",
    "asleep",
)
CARRIES = ("loaded", "gains", "targets")
REASONS = ("stopped", "program ended", "disk full", "recovered")
LIMITS = {1: "clamp", 2: "speed", 4: "workspace edge", 8: "motor heat", 16: "slew", 32: "frozen"}


def word(words: tuple[str, ...], number: int) -> str:
    """The word of a number; a number that this version does not know as itself."""
    return words[number] if 0 <= number < len(words) else f"number {number}"


def part_names(column: str) -> list[str]:
    """The names that the parts of a column of `/ticks` have in a DataFrame.

    q_rad: q1_rad to q6_rad; p_WT_mm: p_WT_mm_x, _y, _z; one number a row: the name itself.
    """
    width = TABLES["ticks"].get(column, 1)
    if column == "q_rad":
        return [f"q{joint}_rad" for joint in range(1, 7)]
    if column == "alpha_beta_theta_rad":
        return ["alpha_rad", "beta_rad", "theta_rad"]
    if column == "heat":
        return [f"heat_{motor}" for motor in (1, 2, 3)]
    if width == 1:
        return [column]
    return [f"{column}_{part}" for part in ("wxyz" if width == 4 else "xyz")]
