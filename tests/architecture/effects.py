"""What of the program carries a real-time mark, where clang looks for it, and what is excepted.

A mark is UNDERACT_REAL_TIME. The list of what is analysed comes from the marks alone: a file that
carries one, or that overrides a function that does, is marked; a source is analysed where it, or a
header of its own folder that it includes, directly or not, is marked, for there the marked
functions are defined. A marked header that no such source includes is analysed by itself.
"""

import dataclasses
import pathlib
import re

FOLDERS = ("core", "device", "app")
MARK = "UNDERACT_REAL_TIME"
# Where the mark and the exception are made.
MAKERS = ("core/base/real_time.h", "core/base/excepted.h")
TOGETHER = 12  # as the build has it: reading headers is most of the time
SWITCHED_OFF = re.compile(r'(?:#\s*pragma|_Pragma|__pragma)\b[^\n]*(?:function-effects|everything)')
EXCEPTION = re.compile(r"\bUNDERACT_EXCEPTED\(")
NO_CAST = re.compile(r"\bexcepted\(")
MIN_REASON = 15  # letters


@dataclasses.dataclass(frozen=True)
class Excepted:
    """One expression that clang is not to judge."""

    path: str
    line: int
    reason: str


def code(root):
    """Path: text, of everything that is built into a program."""
    return {
        path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
        for folder in FOLDERS
        for path in sorted((root / folder).rglob("*"))
        if path.suffix in (".h", ".cpp")
    }


def marked(texts):
    """The files that carry marks, or override what carries one."""
    bases = {
        name
        for text in texts.values()
        for name, body in re.findall(r"^class (\w+)[^;{]*\{(.*?)^\};", text, re.M | re.S)
        if re.search(r"virtual [^;]*" + MARK, body)
    }
    any_base = "|".join(sorted(bases)) or "~"
    overrides = re.compile(rf"(?:class|struct) \w+[^;{{]*:[^;{{]*\b(?:{any_base})\b[^;]*\{{")
    return {
        path
        for path, text in texts.items()
        if path not in MAKERS and (MARK in text or overrides.search(text))
    }


def reached(texts, path):
    """The files that one includes, directly or not, and itself."""
    seen, waiting = set(), [path]
    while waiting:
        here = waiting.pop()
        if here in seen or here not in texts:
            continue
        seen.add(here)
        waiting += re.findall(r'#include "([^"]+)"', texts[here])
    return seen


def folder_of(path):
    """The folder that a file stands in."""
    return pathlib.PurePosixPath(path).parent


def units(texts):
    """Lists of files that clang reads together. Every marked file is in one, or included by one."""
    has_mark = marked(texts)
    chosen, covered = {}, set()
    for path in sorted(path for path in texts if path.endswith(".cpp")):
        all_of_it = reached(texts, path)
        if any(folder_of(mark) == folder_of(path) for mark in all_of_it & has_mark):
            chosen.setdefault(folder_of(path), []).append(path)
            covered |= all_of_it
    lists = [
        sources[begin : begin + TOGETHER]
        for sources in chosen.values()
        for begin in range(0, len(sources), TOGETHER)
    ]
    alone = sorted(has_mark - covered)
    return lists + ([alone] if alone else [])


def reason_of(line, begin):
    """The reason of an exception whose parenthesis opens before `begin`.

    None: it is not one expression on this line.
    """
    said = re.match(r'"([^"]*)", ', line[begin:])
    depth = 1
    for letter in line[begin + said.end() :] if said else "":
        depth += (letter == "(") - (letter == ")")
        if depth == 0:
            return said.group(1)
        if letter in ";{}" or (letter == "," and depth == 1):
            return None
    return None


def exceptions(texts):
    """All exceptions, and sentences about what is switched off otherwise, or without a reason."""
    found, wrong = [], []
    for path, text in texts.items():
        if path in MAKERS:
            continue
        for number, line in enumerate(text.splitlines(), 1):
            place = f"{path}:{number}"
            if SWITCHED_OFF.search(line):
                wrong.append(f"{place}: switches the analysis off; UNDERACT_EXCEPTED is for that.")
            if NO_CAST.search(line):
                wrong.append(f"{place}: calls what only UNDERACT_EXCEPTED may.")
            for opening in EXCEPTION.finditer(line):
                reason = reason_of(line, opening.end())
                if reason is None:
                    wrong.append(f"{place}: an exception is a reason, one expression, on one line.")
                elif len(reason) < MIN_REASON:
                    wrong.append(f"{place}: no reason is said.")
                else:
                    found.append(Excepted(path, number, reason))
    return found, wrong
