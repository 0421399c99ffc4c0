"""Debian packages of this build: what is in them, and that Debian's own checks agree."""
import gzip
import json
import lzma
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(sys.argv.pop())
SOURCE = pathlib.Path(sys.argv.pop())
TOOLS = ["dpkg-buildpackage", "dh", "lintian", "desktop-file-validate", "appstreamcli",
         "update-mime-database", "readelf"]
PACKAGES = {"underact", "underact-cli", "underact-data", "python3-underact"}
MAX_BYTES = 15e6  # of the package without what it depends on
LARGE_PROGRAMS = ["usr/bin/underact", "usr/bin/underact-cli", "usr/bin/underact-sweep"]
PROGRAMS = LARGE_PROGRAMS + ["usr/libexec/underact/underact-guard", "usr/libexec/underact/underact-mesh-reader",
                             "usr/libexec/underact/underact-session-reader"]

release = pathlib.Path("/etc/os-release").read_text(encoding="utf-8")
if "ID=debian\n" not in release or 'VERSION_ID="12"' not in release:
    print("SKIPPED: the packages are those of Debian 12, so none were made here.")
    sys.exit(77)
missing = [tool for tool in TOOLS if not shutil.which(tool)]
if missing:
    print("SKIPPED: not installed, so Debian packages were not made:", ", ".join(missing))
    sys.exit(77)


def run(*words, well=True, **more):
    """What a program says; it must end well."""
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True,
                          timeout=600, check=False, **more)
    assert done.returncode == 0 or not well, f"{words}\n{done.stdout}\n{done.stderr}"
    return done.stdout + done.stderr


def parts(path):
    """Name, header without the size, and content of what a package holds, packed or not."""
    packed, at = path.read_bytes(), 8
    assert packed.startswith(b"!<arch>\n"), path
    while at < len(packed):
        header, size = packed[at:at + 60], int(packed[at + 48:at + 58])
        content = packed[at + 60:at + 60 + size]
        at += 60 + size + size % 2
        name = header[:16].decode().rstrip()
        if name.endswith(".xz"):
            name, content = name[:-3], lzma.decompress(content)
        yield name, header[16:48], content


class Debian(unittest.TestCase):
    """Made once, taken apart once."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="underact packages ")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.made = pathlib.Path(cls.folder.name) / "made"
        cls.make(cls.made)
        cls.packages = {path.name.split("_")[0]: path for path in cls.made.glob("*.deb")
                        if "dbgsym" not in path.name}
        cls.root = pathlib.Path(cls.folder.name) / "root"
        for path in cls.packages.values():
            run("dpkg-deb", "--extract", path, cls.root)

    @staticmethod
    def make(folder, **more):
        run(SOURCE / "packaging" / "deb", folder, env={
            "UNDERACT_BUILD": str(BUILD), "PATH": "/usr/sbin:/usr/bin:/sbin:/bin",
            "SOURCE_DATE_EPOCH": "1700000000", "LC_ALL": "C.UTF-8",
            "DEB_BUILD_OPTIONS": "noautodbgsym",  # half of the time, for what no test looks at
            **more})

    def field(self, package, name):
        return run("dpkg-deb", "--field", self.packages[package], name).strip()

    def test_they_are_split_as_debian_would(self):
        self.assertEqual(set(self.packages), PACKAGES)
        for package in ["underact", "underact-cli"]:
            depends = self.field(package, "Depends")
            self.assertIn("libc6", depends)
            self.assertIn("underact-data (= ", depends)
            self.assertNotIn("libjbig", depends)
        self.assertIn("libqt6widgets6", self.field("underact", "Depends"))
        self.assertNotIn("libqt6", self.field("underact-cli", "Depends"))
        self.assertIn("python3-h5py", self.field("python3-underact", "Depends"))

    def test_together_they_are_below_15_mb(self):
        total = sum(path.stat().st_size for path in self.packages.values())
        print(f"packages: {total / 1e6:.1f} MB")
        self.assertLess(total, MAX_BYTES)

    def test_lintian_finds_nothing(self):
        said = run("lintian", "--allow-root", "--tag-display-limit", "0",
                   *self.packages.values(), well=False)
        found = [line for line in said.splitlines() if re.match(r"[EW]: ", line)]
        self.assertEqual(found, [])

    def test_the_programs_are_hardened(self):
        for program in PROGRAMS:
            path = self.root / program
            header, dynamic = run("readelf", "-hW", path), run("readelf", "-dW", path)
            symbols = run("readelf", "-sW", "--dyn-syms", path)
            segments = run("readelf", "-lW", path)
            self.assertRegex(header, r"Type:\s+DYN .*Position-Independent", program)
            self.assertRegex(dynamic, r"FLAGS.*(BIND_)?NOW", program)
            self.assertIn("GNU_RELRO", segments, program)
            self.assertNotRegex(segments, r"GNU_STACK.*RWE", program)
            self.assertIn("__stack_chk_fail", symbols, program)
            # Clang sees for itself that every copy of a small program's is within bounds: nothing is left to check.
            if program in LARGE_PROGRAMS:
                self.assertIn("_chk@", symbols, program)

    def test_nothing_in_them_looks_for_libraries_but_where_the_system_does(self):
        programs = 0
        for path in self.root.rglob("*"):
            if path.is_symlink() or not path.is_file() or path.read_bytes()[:4] != b"\x7fELF":
                continue
            programs += 1
            self.assertNotRegex(run("readelf", "-dW", path), r"\((RUNPATH|RPATH)\)", path)
        self.assertGreaterEqual(programs, len(PROGRAMS))

    def test_no_path_of_the_machine_that_built_them_is_in_them(self):
        # As a whole path: one as short as /b begins many others.
        folders = b"|".join(re.escape(str(path).encode()) for path in (SOURCE, BUILD))
        pattern = re.compile(rb"(?<![\w.-])(" + folders + rb")(?![\w.-])")
        for path in self.root.rglob("*"):
            if path.is_file() and not path.is_symlink():
                self.assertIsNone(pattern.search(path.read_bytes()), path)

    def test_desktop_entry_metainfo_and_types_are_valid(self):
        share = self.root / "usr/share"
        run("desktop-file-validate", share / "applications/org.underact.underact.desktop")
        for name in ["underact", "underact_cli"]:
            run("appstreamcli", "validate", "--no-net",
                share / f"metainfo/org.underact.{name}.metainfo.xml")
        version = self.field("underact", "Version")
        metainfo = (share / "metainfo/org.underact.underact.metainfo.xml").read_text()
        self.assertIn(f'release version="{version}"', metainfo)
        self.assertIn("<image", metainfo)
        run("update-mime-database", share / "mime")
        globs = (share / "mime/globs2").read_text()
        for name in ["vnd.underact.scene+json:*.underact.json", "vnd.underact.session:*.underact.h5",
                     "x-urdf+xml:*.urdf"]:
            self.assertIn("application/" + name, globs)
        icons = share / "icons/hicolor/scalable"
        for icon in ["apps/underact", "mimetypes/application-vnd.underact.scene+json",
                     "mimetypes/application-vnd.underact.session"]:
            self.assertTrue((icons / f"{icon}.svg").is_file(), icon)

    def test_what_is_offered_is_not_forced(self):
        self.assertTrue((self.root / "usr/share/underact/limits.d/underact.conf").is_file())
        self.assertFalse((self.root / "etc").exists())
        self.assertTrue((self.root / "lib/udev/rules.d/70-underact.rules").is_file())

    def test_the_list_of_parts_is_of_this_version_and_names_what_the_programs_need(self):
        packed = self.root / "usr/share/doc/underact-cli/underact.spdx.json.gz"
        parts = json.loads(gzip.decompress(packed.read_bytes()))
        self.assertEqual(parts["spdxVersion"], "SPDX-2.3")
        names = {part["name"]: part.get("versionInfo") for part in parts["packages"]}
        self.assertTrue(any(name.startswith("libvtk9") for name in names), names)
        self.assertIn(self.field("underact", "Version"), names.values())

    def test_taken_apart_anywhere_the_programs_find_their_data(self):
        version = self.field("underact-cli", "Version")
        cli = self.root / "usr/bin/underact-cli"
        self.assertEqual(run(cli, "--version").strip(), f"underact-cli {version}")
        sphere = self.root / "usr/share/underact/scenes/02_sphere.json"
        session = pathlib.Path(self.folder.name) / "first.underact.h5"
        run(cli, "run", sphere, "--hand", "probe", "--seconds", "2", "--fast", "--record", session)
        self.assertIn("2000", run(cli, "log", "info", session))
        bumpy = self.root / "usr/share/underact/scenes/26_bumpy_sphere.json"
        run(cli, "run", bumpy, "--hand", "still", "--seconds", "0.1", "--fast",
            env={"XDG_CACHE_HOME": self.folder.name, "PATH": "/usr/bin:/bin"})

    def test_made_again_elsewhere_they_are_the_same_bytes(self):
        again = pathlib.Path(self.folder.name) / "made again"
        # xz took most of the time, and is not ours.
        self.make(again, DPKG_DEB_COMPRESSOR_TYPE="none")
        for path in self.packages.values():
            first, second = list(parts(path)), list(parts(again / path.name))
            self.assertEqual([part[:2] for part in first], [part[:2] for part in second], path.name)
            self.assertEqual([part[0] for part in first],
                             ["debian-binary", "control.tar", "data.tar"])
            for (name, _, one), (_, _, other) in zip(first, second):
                self.assertTrue(one == other, f"{name} of {path.name}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
