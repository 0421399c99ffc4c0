"""No program or library that was built looks for libraries in the folder one stands in."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

BUILD = pathlib.Path(os.environ["UNDERACT_BUILD"])
PROGRAMS = [
    "underact",
    "underact-cli",
    "underact-sweep",
    "underact-guard",
    "underact-mesh-reader",
    "underact-session-reader",
]


def loadable(folder):
    """All files below the folder that the system's loader takes: programs and shared libraries."""
    for path in sorted(folder.rglob("*")):
        if path.is_symlink() or not path.is_file() or path.suffix in (".o", ".a"):
            continue
        with open(path, "rb") as file:
            start = file.read(18)
        if start[:4] == b"\x7fELF" and start[16:18] in (b"\x02\x00", b"\x03\x00"):
            yield path


def dynamic(path):
    """What the file says to the loader, as readelf prints it."""
    return subprocess.run(
        ["readelf", "-dW", path], capture_output=True, text=True, check=True
    ).stdout


def foreign(said):
    """The elements of its run paths that mean whatever folder one stands in."""
    paths = re.findall(r"\((?:RUNPATH|RPATH)\).*\[(.*)\]", said)
    elements = [element for path in paths for element in path.split(":")]
    return [element for element in elements if not re.match(r"/|\$ORIGIN(/|$)", element)]


class RunPaths(unittest.TestCase):
    def test_one_that_ends_in_a_colon_is_found(self):
        said = "0x1d (RUNPATH)   Library runpath: [/usr/lib/hdf5/serial:]\n"
        self.assertEqual(foreign(said), [""])
        self.assertEqual(foreign("0xf (RPATH)  Library rpath: [.:$ORIGIN/../lib:lib]"), [".", "lib"])
        self.assertEqual(foreign("0x1 (NEEDED)  Shared library: [libm.so.6]"), [])

    def test_none_of_all_that_was_built_means_the_current_folder(self):
        seen = list(loadable(BUILD))
        print(f"{len(seen)} programs and libraries")
        self.assertIn(BUILD / "underact-cli", seen)
        found = {str(path): foreign(dynamic(path)) for path in seen}
        self.assertEqual({path: elements for path, elements in found.items() if elements}, {})

    def test_libraries_that_lie_where_one_stands_are_not_loaded(self):
        for name in PROGRAMS:
            program = BUILD / name
            if not program.exists():
                continue
            with tempfile.TemporaryDirectory() as empty, tempfile.TemporaryDirectory() as full:
                libraries = re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic(program))
                self.assertIn("libc.so.6", libraries)
                for library in libraries:
                    (pathlib.Path(full) / library).touch()
                ended = [
                    subprocess.run(
                        [program, "--version"],
                        cwd=folder,
                        stdin=subprocess.DEVNULL,  # a reader waits for a question there
                        capture_output=True,
                        check=False,
                    )
                    for folder in (empty, full)
                ]
                self.assertNotEqual(ended[0].returncode, 127, ended[0].stderr)
                self.assertEqual(ended[1].returncode, ended[0].returncode, ended[1].stderr)
                self.assertEqual(ended[1].stdout, ended[0].stdout, name)
