"""Reads, plots and exports the sessions that Underact records. `python3 -m underact --help` is its
command line.
"""

from .errors import DamagedSession, SessionError, Unreadable
from .session import Change, End, Fault, Marker, Session

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
