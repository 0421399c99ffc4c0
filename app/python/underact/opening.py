"""Opens an HDF5 file: as it is, or as one that a program still writes, or left when it died."""

from __future__ import annotations

import ctypes
import functools
import os
import stat
from pathlib import Path

import h5py

from .errors import SessionError, Unreadable

# Where a program that writes may just be changing what is read, HDF5 reads it again, each time
# after twice as long, 100 times: for ever, where the bytes are damaged. 28 times take 0.3 s.
_ATTEMPTS = 28
_FLAGS_AT, _BEING_WRITTEN = 11, 0x05  # of the superblock of version 3: open for writing, for SWMR


def open_file(path: Path) -> h5py.File:
    """The file, open for reading. Raises Unreadable, or SessionError where it is no HDF5 file."""
    try:
        kind = os.stat(path).st_mode
        # Opening a pipe would wait for its writer.
        if not (stat.S_ISREG(kind) or stat.S_ISDIR(kind)):
            raise Unreadable(f"{path} cannot be read: it is not a regular file.")
        with open(path, "rb") as file:
            start = file.read(16)
    except OSError as error:
        raise Unreadable(f"{path} cannot be read: {error.strerror}.") from error
    if not h5py.is_hdf5(path):
        raise SessionError(f"{path} is not a session: it is not an HDF5 file.")
    try:
        return h5py.File(path, "r")
    except (OSError, RuntimeError, ValueError) as error:
        reason = error
    if start[_FLAGS_AT] & _BEING_WRITTEN == _BEING_WRITTEN:
        try:
            return _open_for_following(path)
        except (OSError, RuntimeError, ValueError) as error:
            reason = error
    raise SessionError(
        f"{path} cannot be opened ({reason}). Another program writes it, or it is damaged: "
        "close it there, run underact-cli log recover on it, or copy it anew."
    ) from reason


def _open_for_following(path: Path) -> h5py.File:
    access = h5py.h5p.create(h5py.h5p.FILE_ACCESS)
    access.set_fclose_degree(h5py.h5f.CLOSE_STRONG)
    library = _library()
    if library is not None:
        library.H5Pset_metadata_read_attempts(
            ctypes.c_int64(access.id), ctypes.c_uint(_ATTEMPTS)  # h5py 3.7 has no name for it
        )
    flags = h5py.h5f.ACC_RDONLY | h5py.h5f.ACC_SWMR_READ
    return h5py.File(h5py.h5f.open(bytes(path), flags, access))


def _libraries_in(maps: list[str]) -> list[str]:
    """The files of HDF5 among the lines of /proc/self/maps. A path may have spaces; what would be
    looked for in the folder one stands in is none.
    """
    paths = {line.split(maxsplit=5)[-1] for line in maps if "libhdf5" in line}
    return sorted(p for p in paths if p.startswith("/") and "_hl" not in Path(p).name)


@functools.lru_cache(maxsize=1)
def _library() -> ctypes.CDLL | None:
    """The HDF5 library that h5py uses; None where the system does not say which that is."""
    try:
        maps = Path("/proc/self/maps").read_text(encoding="utf-8").splitlines()
    except OSError:
        return None
    for file in _libraries_in(maps):
        try:
            library = ctypes.CDLL(file)
            if hasattr(library, "H5Pset_metadata_read_attempts"):
                return library
        except OSError:
            continue
    return None
