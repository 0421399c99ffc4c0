"""Reads, plots and exports the sessions that Underact records. `python3 -m underact --help` is its
command line.
"""

import sys

from .errors import DamagedSession, SessionError, Unreadable, missing

try:
    from .session import Change, End, Fault, Marker, Session
except ModuleNotFoundError as error:
    if sys.argv[:1] != ["-m"]:  # which is there while Python looks for `-m underact`
        raise
    print(missing(error.name), file=sys.stderr)
    sys.exit(4)

__all__ = [
    "Change",
    "DamagedSession",
    "End",
    "Fault",
    "Marker",
    "Session",
    "SessionError",
    "Unreadable",
]
