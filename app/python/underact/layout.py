"""The layout of a session file (version 1): its tables, their columns, and what its numbers mean.

All of it follows columns.json, which is made from the program's own table; the page
resources/guide/session_columns.md is made from that, too.
"""

import json
import re
from pathlib import Path

VERSION = 1

#: The one table of a session's columns, as core/record has it: made by `underact-describe
#: columns-json`, the same as `underact-cli log columns`.
COLUMNS: dict = json.loads(Path(__file__).with_name("columns.json").read_text(encoding="utf-8"))

_NUMPY = {"uint8": "u1", "uint32": "<u4", "int64": "<i8", "float64": "<f8"}

#: table -> column -> its row of COLUMNS: name, unit, frame, type, width, meaning, parts, csv
DESCRIBED: dict[str, dict[str, dict]] = {
    table["name"]: {column["name"]: column for column in table["columns"]}
    for table in COLUMNS["tables"]
    if table["name"] != "start"  # the servo's memory, for the program alone
}

#: what an arm of more than six joints has besides in a tick
MORE = "q_more_rad"
#: column -> its row of COLUMNS, of all that a tick has
TICK: dict[str, dict] = {**DESCRIBED["ticks"], MORE: DESCRIBED["joints"][MORE]}
#: the numbers of a tick in CSV: name, unit, type, column, part
CSV: list[dict] = [
    *COLUMNS["csv"],
    *(
        {**TICK[MORE], "name": name, "column": MORE, "part": part}
        for part, name in enumerate(TICK[MORE]["csv"])
    ),
]

#: table -> column -> numbers in a row
TABLES: dict[str, dict[str, int]] = {
    table: {name: column["width"] for name, column in columns.items()}
    for table, columns in DESCRIBED.items()
}

#: tables that a session may not have: it is older, or they were not asked for
OPTIONAL = {table["name"] for table in COLUMNS["tables"] if table["presence"] != "always"}

#: column -> what its numbers are, where they are not doubles
TYPES: dict[str, str] = {
    "crc32": "<u4",
    **{
        name: _NUMPY[column["type"]]
        for columns in DESCRIBED.values()
        for name, column in columns.items()
        if column["type"] != "float64"
    },
}

# What core/record takes, and no more: a file may come from anybody.
MAX_TICKS_A_BLOCK = 200_000
MAX_BLOCK_BYTES = 128 << 20  # the longest block takes 80 MB; a later version may have columns more
#: table -> rows of a block, rows of a chunk; of LONG tables the blocks are the chunks
BLOCKS: dict[str, tuple[int, int]] = {
    table["name"]: (table["block_rows"], table["chunk_rows"]) for table in COLUMNS["tables"]
}
#: tables whose blocks are as long as their file says
LONG = {table["name"] for table in COLUMNS["tables"] if table["most_block_rows"] > 0}
CHECKS_CHUNK = 64
MAX_PACKED = 256  # times more rows than its bytes hold, where h5repack has packed it
#: table -> rows, whatever the file's length
MAX_ROWS: dict[str, int] = {
    table["name"]: table["most_rows"] for table in COLUMNS["tables"] if table["most_rows"]
}
LONGEST_LABEL = COLUMNS["limits"]["label_bytes"]
ALL_LABELS = COLUMNS["limits"]["all_label_bytes"]
LONGEST_SCENE = COLUMNS["limits"]["text_bytes"]
LONGEST_FILE = 1 << 44  # one may have a length that nothing on the disk stands behind
LONGEST_ATTRIBUTE = COLUMNS["limits"]["attribute_bytes"]
MAX_DAMAGED_BLOCKS = 100_000

FAULTS = tuple(re.findall(r"\d (\w+)", TICK["fault"]["meaning"]))
CARRIES = ("loaded", "gains", "targets")
REASONS = ("stopped", "program ended", "disk full", "recovered")


def word(words: tuple[str, ...], number: int) -> str:
    """The word of a number; a number that this version does not know as itself."""
    return words[number] if 0 <= number < len(words) else f"number {number}"


def part_names(column: str) -> list[str]:
    """The names that the parts of a column of a tick have in a DataFrame.

    q_rad: q1_rad to q6_rad; p_WT_mm: p_WT_mm_x, _y, _z; one number a row: the name itself.
    """
    return list(TICK[column]["parts"]) if column in TICK else [column]


def unit(column: str) -> str:
    """The unit of a column of `/ticks`, as a plot writes it."""
    return TICK[column]["unit"].replace("us", "µs")
