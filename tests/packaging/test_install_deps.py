"""What is installed for what: the lists, word for word, so that none grows by itself."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from stand_ins import CALLED, Scripts

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "packaging/install-deps"
GROUPS = ("run", "test", "check", "package", "soak")

# Everybody who wants to see the window downloads these, so adding one is a decision: update what it costs in
# the guide's figures.
RUN = """
    clang-15 cmake ninja-build pkgconf ccache
    libeigen3-dev libsleef-dev libboost-dev libxxhash-dev rapidjson-dev libcli11-dev libmd4c-dev
    libtinyxml2-dev
    libhdf5-dev zlib1g-dev libopenmesh-dev libsystemd-dev libhidapi-dev libglfw3-dev
    libzmq3-dev cppzmq-dev libsodium-dev qt6-base-dev libqt6opengl6-dev libgl-dev libxcb-xinput-dev
    qt6-l10n-tools qt6-translations-l10n libvtk9-dev libgl1-mesa-dri fonts-dejavu-core
"""
TEST = """
    g++ libgtest-dev libumockdev-dev umockdev xvfb xauth libxcb-xtest0-dev python3 python3-h5py python3-matplotlib
    python3-pandas python3-websockets pybind11-dev python3-dev hunspell hunspell-en-gb diction dbus-daemon openmpi-bin duktape
"""
PYTHON = {"g++", "python3-dev", "python3-venv", "python3-pip"}
# On an empty Debian 12, with what these need in turn; 2026-11: 680 packages, 583 MB.
MAX_PACKAGES, MAX_MB = 690, 590


def ask(*words, path=None):
    """The script, with nothing but what it needs on its PATH, if any is named."""
    return subprocess.run(
        ["/bin/sh", SCRIPT, *words],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
        stdin=subprocess.DEVNULL,
        env={"PATH": path} if path else None,
    )


def names(group):
    """The packages of a group."""
    return ask("--list", group).stdout.split()


class Lists(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name  # as a system without apt has it
        for tool in ("cat", "sed", "tr", "fold", "dirname"):
            pathlib.Path(self.folder, tool).symlink_to(shutil.which(tool))

    def test_the_programs_take_these_and_no_others(self):
        self.assertEqual(sorted(names("run")), sorted(RUN.split()))

    def test_their_tests_take_these_besides(self):
        self.assertEqual(sorted(names("test")), sorted(TEST.split()))

    def test_the_python_package_is_compiled_without_the_window(self):
        window = {name for name in RUN.split() if re.match("clang-|qt6-|libqt6|libgl-|libvtk|libgl1-|fonts-", name)}
        self.assertEqual(set(names("python")), set(RUN.split()) - window | PYTHON)

    def test_lists_are_printed_where_there_is_no_apt(self):
        for group in GROUPS:
            said = ask("--list", group, path=self.folder)
            self.assertEqual((said.returncode, said.stderr), (0, ""))
            self.assertRegex(said.stdout, r"\A([a-z0-9][a-z0-9.+-]+\n)+\Z")

    def test_no_package_is_in_two_groups(self):
        every = [name for group in GROUPS for name in names(group)]
        self.assertEqual(sorted(every), sorted(set(every)))
        self.assertEqual(ask("--list", *GROUPS).stdout.split(), every)

    def test_each_line_says_what_it_is_for(self):
        text = SCRIPT.read_text(encoding="utf-8")
        for table in re.findall(r"<<'LIST'\n(.*?)\nLIST\n", text, re.DOTALL):
            for line in table.splitlines():
                self.assertRegex(line, r"^[a-z].*\S +# \S")

    def test_other_words_are_refused(self):
        for words in (["--list"], ["--list", "everything"], ["--lists"], ["run", "--no"]):
            said = ask(*words)
            self.assertEqual((said.returncode, said.stdout), (2, ""), words)
            self.assertIn("--list GROUP", said.stderr)

    def test_a_system_without_apt_is_told_what_to_install_and_how_to_build(self):
        said = ask("run", path=self.folder)
        self.assertEqual(said.returncode, 3)
        for name in RUN.split():
            self.assertIn(name, said.stderr)
        self.assertNotIn("lintian", said.stderr)
        self.assertIn("cmake -S . -B build/release -G Ninja -DUNDERACT_TESTS=OFF", said.stderr)

    def test_what_the_programs_take_brings_no_more_than_it_did(self):
        if 'VERSION_ID="12"' not in pathlib.Path("/etc/os-release").read_text(encoding="utf-8"):
            self.skipTest("counted on Debian 12 alone")
        done = subprocess.run(
            ["apt-get", "-o", "Dir::State::status=/dev/null", "-o", "Debug::NoLocking=1"]
            + ["--print-uris", "-y", "--no-install-recommends", "install", *RUN.split()],
            capture_output=True,
            text=True,
            check=False,
        )
        if done.returncode != 0:
            self.skipTest("apt has no lists here (apt-get update)")
        sizes = [int(row) for row in re.findall(r"^'\S+' \S+ (\d+)", done.stdout, re.MULTILINE)]
        print(f"{len(sizes)} packages, {sum(sizes) / 1e6:.0f} MB")
        self.assertLessEqual(len(sizes), MAX_PACKAGES)
        self.assertLessEqual(sum(sizes) / 1e6, MAX_MB)


class Alternatives(Scripts):
    """Of clang-15|clang one is enough. Nothing is installed but what INSTALLED names; the release has all but what LACKS names."""

    COPIES = ("packaging/install-deps",)
    STAND_INS = {
        "bin/id": "#!/bin/sh\necho 0\n",
        "bin/dpkg-query": '#!/bin/sh\nfor name in $INSTALLED; do echo "installed $name "; done\n',
        "bin/apt-cache": '#!/bin/sh\n[ "$2" != "$LACKS" ]\n',
        "bin/apt-get": CALLED,
    }

    def installs(self, installed="", lacks=""):
        """The Clangs that it has apt install."""
        done, calls = self.call("packaging/install-deps", "run", INSTALLED=installed, LACKS=lacks)
        self.assertEqual(done.returncode, 0, done.stderr)
        return re.findall(r"clang\S*", next(call for call in calls if " install " in call and " -y " in call))

    def test_the_first_that_the_release_has_is_installed(self):
        self.assertEqual(self.installs(), ["clang-15"])
        self.assertEqual(self.installs(lacks="clang-15"), ["clang"])

    def test_where_one_is_installed_none_is(self):
        self.assertEqual(self.installs(installed="clang"), [])


if __name__ == "__main__":
    unittest.main()
