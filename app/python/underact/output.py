"""Makes files of exactly the names that were given."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import IO


def check_name(path: str | Path, session: str | Path | None = None) -> None:
    """Raises OSError where `path` is no regular file (a link, a pipe), or the session itself."""
    try:
        there = os.lstat(path)
    except FileNotFoundError:
        return
    if not stat.S_ISREG(there.st_mode):
        words = "a link, a folder, a pipe or a device has this name and is not written to"
        raise FileExistsError(errno.EEXIST, words, str(path))
    if session is not None and os.path.samefile(session, path):
        raise FileExistsError(errno.EEXIST, "this is the session itself", str(path))


def new_file(path: str | Path, mode: str, rights: int = 0o600, **more: object) -> IO:
    """A new file for writing. One that is there is replaced, and its rights are kept. Nothing is
    written through a link, and no pipe is waited for: see check_name().
    """
    check_name(path)
    if os.path.lexists(path):
        rights = stat.S_IMODE(os.lstat(path).st_mode)
        os.unlink(path)
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0)
    return os.fdopen(os.open(path, flags, rights), mode, **more)
