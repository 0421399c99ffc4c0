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

#: column -> what its numbers are, where they are not doubles
TYPES: dict[str, str] = {
    **dict.fromkeys(("tick", "time_ns", "revision", "text_at", "text_bytes"), "<i8"),
    **dict.fromkeys(("dropped", "unix_ns"), "<i8"),
    **dict.fromkeys(("buttons", "limits", "crc32"), "<u4"),
    **dict.fromkeys(("fault", "input", "carry", "kind", "from_servo", "reason", "bytes"), "u1"),
}

# What core/record takes, and no more: a file may come from anybody.
MOST_TICKS_A_BLOCK = 200_000
MOST_BLOCK_BYTES = 128 << 20  # the longest block takes 80 MB; a later version may have columns more
#: table -> rows of a block, rows of a chunk; /ticks: its blocks are its chunks
BLOCKS: dict[str, tuple[int, int]] = {"end": (1, 1), "text": (64, 1024)}
SMALL_BLOCK = (1, 64)  # of the others
CHECKS_CHUNK = 64
MOST_PACKED = 256  # times more rows than its bytes hold, where h5repack has packed it
#: table -> rows, whatever the file's length
MOST_ROWS: dict[str, int] = {"changes": 1 << 20, "faults": 1 << 20, "end": 1 << 20}
MOST_ROWS["markers"] = 1 << 16
LONGEST_LABEL, ALL_LABELS = 64 << 10, 16 << 20  # bytes
LONGEST_SCENE = 16 << 20  # as of a scene file
LONGEST_FILE = 1 << 44  # one may have a length that nothing on the disk stands behind
LONGEST_ATTRIBUTE = 1 << 20
MOST_DAMAGED_BLOCKS = 100_000

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
