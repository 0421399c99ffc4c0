"""Which licence each carried package is under, whether that one is allowed, and its text."""

import functools
import os
import re
import shutil
import subprocess

from .closure import Refused

TABLE = os.path.join(os.path.dirname(__file__), "..", "bundle-licences")
COMMON = "/usr/share/common-licenses"


def read_table(path=TABLE):
    """(licences allowed, package -> licence taken), from lines `allow ID...` and `PACKAGE LICENCE`."""
    allowed, of_package = set(), {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split("#")[0].split()
            if words[:1] == ["allow"]:
                allowed.update(words[1:])
            elif words:
                of_package[words[0]] = " ".join(words[1:])
    return allowed, of_package


def check(packages, table):
    """Stops at a package without a licence, or with one that is not allowed."""
    allowed, of_package = table
    for package in sorted(packages):
        if package not in of_package:
            raise Refused(
                f"{package} has no licence in packaging/bundle-licences: read "
                f"/usr/share/doc/{package}/copyright, and add it where its licence is allowed."
            )
        parts = of_package[package].replace(" WITH ", "_WITH_").split(" AND ")
        wrong = set(parts) - allowed
        if wrong:
            raise Refused(
                f"{package} is under {', '.join(sorted(wrong))}, which may not be carried."
            )


def _dpkg(*arguments):
    return subprocess.run(arguments, check=True, capture_output=True, text=True).stdout


def packages_of(paths):
    """Debian's package that installed each path: path -> package."""
    asked = {}
    for path in paths:
        real = os.path.realpath(path)
        for name in (
            path,
            real,
            re.sub(r"^/usr(?=/lib)", "", real),
            "/usr" + real,
        ):  # /lib may be a link to /usr/lib
            asked.setdefault(name, []).append(path)
    found = {}
    answer = subprocess.run(["dpkg", "-S", *asked], capture_output=True, text=True).stdout
    for line in answer.splitlines():
        package, name = line.rsplit(": ", 1)
        for path in asked.get(name, []):
            found[path] = package.split(":")[0]
    for path in paths:
        if path not in found:
            raise Refused(
                f"No package of this system has installed {path}, so its licence is not known."
            )
    return found


@functools.lru_cache(maxsize=None)
def facts(package):
    """Version, source package and its version, homepage, of an installed package."""
    fields = ("Version", "source:Package", "source:Version", "Homepage")
    text = _dpkg(
        "dpkg-query",
        "-W",
        "-f",
        "\n".join(f"${{{field}}}" for field in fields) + "\n===\n",
        package,
    )
    version, source, source_version, homepage = text.split("\n===")[0].split("\n")
    return {
        "version": version,
        "source": source,
        "source_version": source_version,
        "homepage": homepage,
    }


def own_text(package):
    """The notice of a package whose copyright file lacks it, or None."""
    path = os.path.join(os.path.dirname(__file__), "texts", package)
    return path if os.path.exists(path) else None


def copy_texts(packages, folder):
    """Each package's copyright file, and the common texts that these name, into folder."""
    os.makedirs(folder, exist_ok=True)
    named = set()
    for package in sorted(packages):
        text = f"/usr/share/doc/{package}/copyright"
        if not os.path.exists(text):
            raise Refused(
                f"{text} is not there, so {package} cannot be carried: install it with its "
                "documentation."
            )
        shutil.copyfile(text, os.path.join(folder, package))
        if own_text(package):
            shutil.copyfile(own_text(package), os.path.join(folder, package + ".upstream"))
        with open(text, encoding="utf-8", errors="replace") as file:
            named.update(re.findall(COMMON + r"/([A-Za-z]+(?:-[0-9.]*[0-9])?)", file.read()))
    os.makedirs(os.path.join(folder, "common"), exist_ok=True)
    for name in sorted(named):
        if os.path.exists(os.path.join(COMMON, name)):
            shutil.copyfile(os.path.join(COMMON, name), os.path.join(folder, "common", name))


def write_sources(packages, path, where="usr/lib"):
    """Where the source of each carried package is, as the LGPL asks. where: the libraries lie."""
    lines = [
        "The source of every library carried here, as Debian built it:",
        "https://snapshot.debian.org/package/SOURCE/VERSION/. Each library is a file of its own in",
        f"{where}: another build of the same interface may take its place.",
        "",
    ]
    for package in sorted(packages):
        known = facts(package)
        lines.append(f"{package} {known['version']}: {known['source']} {known['source_version']}")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
