"""What packaging/wheel-libraries makes of a wheel as auditwheel leaves it: without the libraries that nothing calls, with the licences
of the others. Wheels themselves are packaging/soak's, since making them takes tools from PyPI.
"""

import importlib.util
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

try:
    from portable import elf
except ImportError as error:
    raise unittest.SkipTest(f"python3-pyelftools is not installed ({error}), so no wheel was looked at") from error

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "packaging/wheel-libraries"
HASH = "-0123abcd"
HDF5 = next((name for name in elf.installed() if name.startswith("libhdf5_serial.so.")), "")


def hashed(soname):
    """The name that auditwheel gives it: the hash before the first dot."""
    stem, dot, rest = pathlib.Path(elf.installed()[soname]).resolve().name.partition(".")
    return stem + HASH + dot + rest


@unittest.skipUnless(importlib.util.find_spec("wheel"), "python3-wheel is not installed, so no wheel was looked at")
@unittest.skipUnless(HDF5 and shutil.which("patchelf"), "HDF5 or patchelf is not installed, so no wheel was looked at")
class Libraries(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.scratch = pathlib.Path(holder.name)
        self.folder = self.scratch / "underact-0.1.0"
        self.libs = self.folder / "underact.libs"
        self.libs.mkdir(parents=True)
        about = self.folder / "underact-0.1.0.dist-info"
        about.mkdir()
        (about / "METADATA").write_text("Metadata-Version: 2.1\nName: underact\nVersion: 0.1.0\n")
        (about / "WHEEL").write_text("Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: false\nTag: cp311-cp311-linux_x86_64\n")
        (self.folder / "underact").mkdir()

    def carry(self, soname, renamed):
        """Puts a library of the system there under auditwheel's name, and has it need `renamed` by those."""
        to = self.libs / hashed(soname)
        shutil.copyfile(elf.installed()[soname], to)
        for name in set(renamed) & set(elf.needed(to)):
            elf.patch(to, "--replace-needed", name, hashed(name))
        return to

    def wheel(self):
        """As auditwheel leaves it: HDF5 with libcurl and what that needs first, and a module that needs HDF5."""
        behind = ["libcurl.so.4", "libcrypto.so.3", "libsz.so.2", "libnghttp2.so.14"]
        for soname in [HDF5, *behind]:
            self.carry(soname, behind)
        module = self.folder / "underact" / "_core.so"
        shutil.copyfile(elf.installed()["libsz.so.2"], module)  # any library: which others it needs is what counts
        elf.patch(module, "--add-needed", hashed(HDF5))
        return self.pack()

    def pack(self):
        out = self.scratch / "out"
        tool = [sys.executable, "-m", "wheel", "pack", self.folder, "--dest-dir", out]
        out.mkdir()
        subprocess.run(tool, check=True, stdout=subprocess.DEVNULL)
        return next(out.iterdir())

    def run_it(self, wheel):
        return subprocess.run([sys.executable, "-B", PROGRAM, wheel], capture_output=True, text=True, check=False)

    def test_what_nothing_calls_is_left_out_and_the_others_have_their_licences(self):
        wheel = self.wheel()
        done = self.run_it(wheel)
        self.assertEqual(done.returncode, 0, done.stderr)
        with zipfile.ZipFile(wheel) as made:
            names = made.namelist()
            libraries = {name.rsplit("/", 1)[1] for name in names if ".libs/" in name}
            self.assertEqual(libraries, {hashed(HDF5), hashed("libsz.so.2")})
            texts = [name.rsplit("/", 1)[1] for name in names if "/licenses/libraries/" in name]
            self.assertIn("libsz2", texts)
            self.assertTrue(any(name.startswith("libhdf5") for name in texts), texts)
            sources = next(name for name in names if name.endswith("/SOURCES"))
            self.assertIn("underact.libs", made.read(sources).decode())
            hdf5 = pathlib.Path(made.extract(f"underact.libs/{hashed(HDF5)}", self.scratch))
        self.assertFalse([name for name in elf.needed(hdf5) if "curl" in name or "crypto" in name])
        self.assertNotIn("CURL", subprocess.run(["readelf", "-VW", hdf5], capture_output=True, text=True, check=True).stdout)

    def test_a_library_that_is_not_the_systems_is_refused(self):
        (self.libs / f"libmine{HASH}.so.1").write_bytes(pathlib.Path(elf.installed()["libsz.so.2"]).read_bytes())
        module = self.folder / "underact" / "_core.so"
        shutil.copyfile(elf.installed()["libsz.so.2"], module)
        elf.patch(module, "--add-needed", f"libmine{HASH}.so.1")
        done = self.run_it(self.pack())
        self.assertEqual(done.returncode, 1)
        self.assertIn("libmine.so.1 is not from this system", done.stderr)


if __name__ == "__main__":
    unittest.main()
