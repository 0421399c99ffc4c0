"""What a table of a session file may be, so that reading it takes no more memory and time than the
file's own bytes are good for. The same as core/record asks: a file may come from anybody.
"""

from __future__ import annotations

import os

import h5py
import numpy as np

from . import layout
from .errors import SessionError

_FILTERS = (h5py.h5z.FILTER_DEFLATE, h5py.h5z.FILTER_SHUFFLE)


def attribute(thing: h5py.HLObject, name: str) -> object:
    """A single number, or a text of fixed length, as a str; None where there is none, or another
    kind, or a text of more than a mebibyte: the library would make room for what it claims to be.
    """
    name_bytes = name.encode()
    if not h5py.h5a.exists(thing.id, name_bytes):
        return None
    found = h5py.h5a.open(thing.id, name_bytes)
    kind, space = found.get_type(), found.get_space()
    number = isinstance(kind, (h5py.h5t.TypeIntegerID, h5py.h5t.TypeFloatID))
    text = isinstance(kind, h5py.h5t.TypeStringID) and not kind.is_variable_str()
    if not (number or text) or space.get_simple_extent_npoints() != 1:
        return None
    if kind.get_size() > layout.LONGEST_ATTRIBUTE:
        return None
    read = np.empty(found.shape, found.dtype)
    found.read(read)
    value = read.reshape(-1)[0].item()
    if isinstance(value, bytes):
        return value.rstrip(b"\0").decode("utf-8", "replace")
    return value


def is_own(group: h5py.Group, name: str) -> bool:
    """Whether what has this name stands in the file itself: a link may lead to any other file, and
    so may where a dataset has its numbers.
    """
    if not isinstance(group.get(name, getlink=True), h5py.HardLink):
        return False
    found = group[name]
    return not isinstance(found, h5py.Dataset) or not (found.external or found.is_virtual)


def file_bytes(file: h5py.File) -> int:
    """How long the file is now, by what is open, whatever its name has come to mean."""
    return min(os.fstat(file.id.get_vfd_handle()).st_size, layout.LONGEST_FILE)


def is_packed(dataset: h5py.Dataset) -> bool:
    """Whether its chunks went through filters, as h5repack has them do."""
    return dataset.id.get_create_plist().get_nfilters() > 0


def block_rows_of(where: str, name: str, group: h5py.Group) -> int:
    """The rows of a block. Raises SessionError where that table has no such blocks."""
    rows = attribute(group, "block_rows")
    if not isinstance(rows, int) or rows < 1:
        raise SessionError(f"{where} does not say how many rows a block has (block_rows).")
    lowest, highest = 1, layout.MAX_TICKS_A_BLOCK
    if name not in layout.LONG:
        lowest = highest = layout.BLOCKS[name][0]
    if not lowest <= rows <= highest:
        wanted = f"{highest}" if lowest == highest else f"{lowest} to {highest}"
        raise SessionError(
            f"{where} says that a block has {rows} rows (block_rows), and not {wanted}. The file "
            "is damaged, or no session of this program: copy it anew from where it came."
        )
    return rows


def check_layout(where: str, column: str, dataset: h5py.Dataset, chunk_rows: int) -> None:
    """Raises SessionError unless the column stands in the file as core/record writes it, or as
    h5repack packs that.
    """
    made = dataset.id.get_create_plist()
    inner = dataset.shape[1:]
    filters = [made.get_filter(index)[0] for index in range(made.get_nfilters())]
    if (
        dataset.maxshape != (None, *inner)
        or dataset.chunks != (chunk_rows, *inner)
        or made.fill_value_defined() != h5py.h5d.FILL_VALUE_DEFAULT
        or any(one not in _FILTERS for one in filters)
        or (column in layout.TYPES and dataset.dtype != np.dtype(layout.TYPES[column]))
    ):
        raise SessionError(
            f"{where} has a column {column} that is laid out otherwise than a session's: its type, "
            "chunks, filters or fill value. Copy the file anew from where it came."
        )


def max_rows(columns: list[h5py.Dataset], block_rows: int, length: int) -> int:
    """Rows that a file of so many bytes can hold: each takes its own. What a writer is just adding
    counts before it is there.
    """
    highest = length // sum(row_bytes(one) for one in columns)
    return highest * (layout.MAX_PACKED if any(map(is_packed, columns)) else 1) + block_rows


def row_bytes(dataset: h5py.Dataset) -> int:
    """Bytes of one row, unpacked."""
    numbers = 1
    for size in dataset.shape[1:]:  # numpy's product would wrap
        numbers *= size
    return dataset.dtype.itemsize * numbers
