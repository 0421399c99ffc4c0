"""Underact in Python: arms, recorded sessions, running scenes. `python3 -m underact --help` is its
command line.

`underact.arm` requires the compiled part of the package; sessions do not.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from .compiled import NotCompiled
from .errors import DamagedSession, SessionError, Unreadable, missing

if TYPE_CHECKING:
    from . import arm, scene, sim
    from .live import AsyncLive, Live, LiveError, Refused, connect, connect_async
    from .session import Change, End, Fault, Marker, Session

#: What is imported when it is first used: arms do without h5py, sessions without the compiled part.
_LIVE = ("AsyncLive", "Live", "LiveError", "Refused", "connect", "connect_async")
_SESSION = ("Change", "End", "Fault", "Marker", "Session")
_MODULES = ("arm", "scene", "sim")

__all__ = [
    "AsyncLive",
    "Change",
    "DamagedSession",
    "End",
    "Fault",
    "Live",
    "LiveError",
    "Marker",
    "NotCompiled",
    "Refused",
    "Session",
    "SessionError",
    "Unreadable",
    "arm",
    "connect",
    "connect_async",
    "scene",
    "sim",
]


def __getattr__(name: str) -> Any:
    """Imports the part that has the name. ImportError, with a way out: a library is missing."""
    if name in _MODULES:
        return importlib.import_module(f".{name}", __name__)
    part = "live" if name in _LIVE else "session" if name in _SESSION else None
    if part is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    try:
        value = getattr(importlib.import_module(f".{part}", __name__), name)
    except ModuleNotFoundError as error:
        if (error.name or "").startswith(__name__):
            raise
        raise ModuleNotFoundError(missing(error.name), name=error.name) from error
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
