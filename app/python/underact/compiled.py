"""Where the compiled part of the package is: underact._core, made of the program's own code."""

from __future__ import annotations

import contextlib
import importlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

#: The program that reads meshes, in a process of its own; a wheel brings it.
_MESH_READER = Path(__file__).with_name("underact-mesh-reader")


class NotCompiled(ImportError):
    """This installation has sessions alone. `str()` is a sentence with the way out."""


def core() -> ModuleType:
    """The module underact._core. Raises NotCompiled where it is missing or does not fit this
    Python.
    """
    if _MESH_READER.exists():
        os.environ.setdefault("UNDERACT_MESH_READER", str(_MESH_READER))
    try:
        with _functions_looked_up_when_called():
            return importlib.import_module("underact._core")
    except ImportError as error:
        raise NotCompiled(
            f"The compiled part of the package underact cannot be loaded ({error}). Arms, "
            "scenes and simulation require it; sessions do not. Install the wheel for this "
            "Python, or run `pip install .` in the sources."
        ) from error


@contextlib.contextmanager
def _functions_looked_up_when_called() -> Iterator[None]:
    """As in programs. A wheel's HDF5 comes without the libraries behind its driver of S3, which is
    never called; Python would look for their functions when it loads the module.
    """
    if sys.platform == "win32":
        yield
        return
    flags = sys.getdlopenflags()
    sys.setdlopenflags(os.RTLD_LAZY)
    try:
        yield
    finally:
        sys.setdlopenflags(flags)
