"""Where the compiled part of the package is: underact._core, made of the program's own code."""

from __future__ import annotations

import importlib
import os
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
        return importlib.import_module("underact._core")
    except ImportError as error:
        raise NotCompiled(
            f"The compiled part of the package underact cannot be loaded ({error}). Arms, "
            "scenes and simulation require it; sessions do not. Install the wheel for this "
            "Python, or run `pip install .` in the sources."
        ) from error
