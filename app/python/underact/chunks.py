"""Reads rows of a column. What is packed is unpacked here, to no more than a chunk may hold: the
library lets a few kilobytes of zlib grow to gigabytes.
"""

from __future__ import annotations

import zlib

import h5py
import numpy as np

from .bounds import is_packed, row_bytes


def read_rows(dataset: h5py.Dataset, first: int, end: int) -> np.ndarray:
    """Rows [first, end). Raises OSError or RuntimeError where they cannot be read."""
    if first >= end or not is_packed(dataset):
        return dataset[first:end]
    made = dataset.id.get_create_plist()
    filters = [made.get_filter(index)[0] for index in range(made.get_nfilters())]
    size = dataset.chunks[0]
    rows = np.empty((end - first, *dataset.shape[1:]), dataset.dtype)
    for start in range(first - first % size, end, size):
        low, high = max(start, first), min(start + size, end)
        chunk = _chunk(dataset, start, filters)
        rows[low - first : high - first] = chunk[low - start : high - start]
    return rows


def _chunk(dataset: h5py.Dataset, start: int, filters: list[int]) -> np.ndarray:
    try:
        mask, packed = dataset.id.read_direct_chunk((start,) + (0,) * (dataset.ndim - 1))
    except (OSError, RuntimeError, ValueError, MemoryError):
        # It was never written: zeros (h5py 3.13 asks for no memory then, and takes that for a lack
        # of it). If it cannot be read, this says so, too.
        return dataset[start : start + dataset.chunks[0]]
    size = dataset.chunks[0] * row_bytes(dataset)
    for index, one in reversed([*enumerate(filters)]):
        if mask >> index & 1:  # it was no use for this chunk
            continue
        if one == h5py.h5z.FILTER_DEFLATE:
            packed = _inflated(packed, 2 * size + 1024)  # another may stand below it
        else:
            packed = _unshuffled(packed, dataset.dtype.itemsize)
    if len(packed) != size:
        raise OSError("a packed chunk is not as long as it should be")
    return np.frombuffer(packed, dataset.dtype).reshape(dataset.chunks)


def _inflated(packed: bytes, max_bytes: int) -> bytes:
    try:
        return zlib.decompressobj().decompress(packed, max_bytes)
    except zlib.error as error:
        raise OSError(str(error)) from error


def _unshuffled(packed: bytes, size: int) -> bytes:
    """First bytes of all numbers came first, then their second ones; what is left over stays."""
    whole = len(packed) // size * size
    bytes_ = np.frombuffer(packed, "u1", whole).reshape(size, -1)
    return bytes_.T.tobytes() + packed[whole:]
