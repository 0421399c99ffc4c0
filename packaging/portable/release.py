"""Version and time of what is made: each from one place."""

import os
import re
import subprocess

from .closure import Refused


def version_of(build):
    """The version that CMake's project() names, as the build has it."""
    path = os.path.join(build, "generated/underact/version.h")
    if not os.path.exists(path):
        raise Refused(
            f"There is no build in {build}: cmake --preset release && "
            "cmake --build --preset release."
        )
    with open(path, encoding="utf-8") as file:
        return re.search(r'"([0-9][^"]*)"', file.read()).group(1)


def epoch_of(root):
    """The time that all files are given: SOURCE_DATE_EPOCH, else that of the last commit."""
    if "SOURCE_DATE_EPOCH" in os.environ:
        return int(os.environ["SOURCE_DATE_EPOCH"])
    last = subprocess.run(
        ["git", "-C", root, "log", "-1", "--format=%ct"], capture_output=True, text=True
    )
    if last.returncode != 0:
        raise Refused(
            "This is no clone of the project: set SOURCE_DATE_EPOCH to the time of the release."
        )
    return int(last.stdout)
