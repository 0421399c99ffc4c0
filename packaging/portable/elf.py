"""What binutils and patchelf say of programs and libraries, and what is changed in them."""

import functools
import os
import re
import struct
import subprocess

from elftools.elf.elffile import ELFFile


def _output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def is_elf(path):
    """Whether path is a program or a library of its own, no link to one."""
    if os.path.islink(path) or not os.path.isfile(path):
        return False
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"


def elf_files(folder):
    """Every program and library below folder, in order."""
    found = []
    for here, _, names in os.walk(folder):
        found += [os.path.join(here, name) for name in names]
    return sorted(path for path in found if is_elf(path))


@functools.lru_cache(maxsize=None)
def installed():
    """The libraries of this system: soname -> path."""
    pattern = re.compile(r"^\s*(\S+) \(libc6,x86-64[^)]*\) => (\S+)$", re.M)
    known = {}
    for name, path in pattern.findall(_output("/sbin/ldconfig", "-p")):
        known.setdefault(name, path)
    return known


def needed(path):
    """The sonames that path asks for."""
    return _output("patchelf", "--print-needed", path).split()


def runpath(path):
    """Where path looks for its libraries, as it is written there."""
    return _output("patchelf", "--print-rpath", path).strip()


def symbols(path, which):
    """The dynamic symbols of path, without their versions. which: "--undefined-only" or
    "--defined-only".
    """
    lines = _output("nm", "-D", "-P", which, path).splitlines()
    return {line.split()[0].split("@")[0] for line in lines if line.split()[1] not in "wv"}


def binds_lazily(path, names):
    """Whether path calls those functions only, and each is looked up when it is first called."""
    if "BIND_NOW" in _output("readelf", "-dW", path):
        return False
    kinds = {name: set() for name in names}
    for line in _output("readelf", "-rW", path).splitlines():
        words = line.split()
        if len(words) > 4 and words[4].split("@")[0] in kinds:
            kinds[words[4].split("@")[0]].add(words[2])
    return all(found == {"R_X86_64_JUMP_SLOT"} for found in kinds.values())


def versions(path):
    """The versions that path wants of its libraries' functions: family -> the newest, as numbers."""
    newest = {}
    wanted = _output("readelf", "-VW", path).partition(".gnu.version_r")[2]
    for family, number in re.findall(r"Name: ([A-Z]+)_([0-9.]+)\b", wanted):
        value = tuple(int(part) for part in number.split("."))
        newest[family] = max(value, newest.get(family, ()))
    return newest


def patch(path, *changes):
    """Has patchelf change path."""
    _output("patchelf", *changes, path)


def _versions(path):
    """What path wants of whom: ((offset in the file, library) of each, address of the first), and
    the places of the dynamic entries that name the first and count them.
    """
    with open(path, "rb") as file:
        elf = ELFFile(file)
        section = elf.get_section_by_name(".gnu.version_r")
        dynamic = elf.get_section_by_name(".dynamic")
        at, entries = section["sh_offset"], []
        for version, _ in section.iter_versions():
            entries.append((at, version.name))
            at += version.entry.vn_next
        place = {
            tag.entry.d_tag: dynamic["sh_offset"] + n * dynamic["sh_entsize"]
            for n, tag in enumerate(dynamic.iter_tags())
        }
        return (
            entries,
            section["sh_addr"] - section["sh_offset"],
            place["DT_VERNEED"],
            place["DT_VERNEEDNUM"],
        )


def _forget_versions(path, libraries):
    """Takes the versions that path wants of libraries out of .gnu.version_r: the loader asks them
    of a library that is needed no more, and would end the program. After the last change by
    patchelf, which writes these entries anew.
    """
    entries, to_address, first, count = _versions(path)
    kept = [at for at, name in entries if name not in libraries]
    with open(path, "r+b") as file:
        for at, after in zip(kept, kept[1:] + [None]):
            file.seek(at + 12)  # vn_next of Elf64_Verneed: two halves and two words before it
            file.write(struct.pack("<I", after - at if after else 0))
        for place, value in ((first, kept[0] + to_address), (count, len(kept))):
            file.seek(place + 8)  # d_val of Elf64_Dyn
            file.write(struct.pack("<Q", value))


def leave_out(path, functions):
    """Makes path do without libraries whose functions it never calls. Calling one would end the
    program. functions: library -> those it asks for.
    """
    versioned = {
        line.split()[-1].split("@")[0]
        for line in _output("nm", "-D", "--undefined-only", path).splitlines()
        if "@" in line
    }
    changes = []
    for library, names in sorted(functions.items()):
        changes += ["--remove-needed", library]
        for name in sorted(names & versioned):
            changes += ["--clear-symbol-version", name]
    patch(path, *changes)
    _forget_versions(path, set(functions))
