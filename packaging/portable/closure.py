"""Which libraries come along, and the proof that nothing else is called."""

import os
import re

from . import elf, parts


class Refused(Exception):
    """The bundle cannot be made as it should be. Its text says what to do."""


def _left_out(path, library):
    return (os.path.basename(path), library) in parts.LEFT_OUT


def libraries(roots):
    """What roots need, and what that needs: soname -> path, without the system's and those left
    out.
    """
    known, found, todo = elf.installed(), {}, list(roots)
    while todo:
        path = todo.pop()
        for name in elf.needed(path):
            if (
                name in found
                or name in parts.SYSTEM
                or _left_out(os.path.realpath(path), name)
                or _left_out(path, name)
            ):
                continue
            if name in parts.REFUSED:
                raise Refused(
                    f"{path} needs {name}, which is under {parts.REFUSED[name]} and may not be "
                    "carried."
                )
            if name not in known:
                raise Refused(f"{path} needs {name}, which is not on this system.")
            found[name] = known[name]
            todo.append(known[name])
    return found


def check_left_out(path, soname):
    """What path asks of the libraries left out is what is known of, and nothing of it is looked up
    at start.
    """
    for (importer, library), allowed in parts.LEFT_OUT.items():
        if importer != soname or library not in elf.needed(path):
            continue
        theirs = elf.symbols(elf.installed()[library], "--defined-only")
        asked = elf.symbols(path, "--undefined-only") & theirs
        if asked != allowed:
            raise Refused(
                f"{soname} asks {library} for {', '.join(sorted(asked ^ allowed))}, which was not "
                "looked "
                "at: see LEFT_OUT in packaging/portable/parts.py."
            )
        if not elf.binds_lazily(path, allowed):
            raise Refused(
                f"{soname} looks up the functions of {library} at start, so it cannot be left out."
            )


def check_programs(paths):
    """No program of ours calls what leads to a library left out."""
    pattern = re.compile("|".join(parts.NEVER_CALLED))
    for path in paths:
        called = sorted(
            name for name in elf.symbols(path, "--undefined-only") if pattern.search(name)
        )
        if called:
            raise Refused(
                f"{os.path.basename(path)} calls {called[0]}, which needs a library that is left "
                "out."
            )


def unresolved(folder):
    """What the files below folder ask for, and nobody there or in the system has: path -> names."""
    files = elf.elf_files(folder)
    carried = {os.path.basename(path) for path in files}
    have = set()
    for path in files:
        have |= elf.symbols(path, "--defined-only")
    for name in parts.SYSTEM:
        if name in elf.installed() and name not in carried:
            have |= elf.symbols(elf.installed()[name], "--defined-only")
    known = set().union(*parts.LEFT_OUT.values())
    missing = {}
    for path in files:
        lost = elf.symbols(path, "--undefined-only") - have - known
        if lost:
            missing[os.path.relpath(path, folder)] = sorted(lost)
    return missing
