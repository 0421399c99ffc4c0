"""The folder that runs from anywhere: Underact-VERSION-x86_64.AppDir."""

import glob
import os
import shutil
import subprocess

from . import closure, elf, licences, parts, spdx

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
LIB = "usr/lib"
PLUGINS = "usr/lib/qt6/plugins"
LICENCES = "usr/share/doc/underact/licences"


def install(build, folder):
    """What the build installs, below folder/usr, without the programs that are not carried."""
    environment = {**os.environ, "DESTDIR": folder}
    subprocess.run(
        ["cmake", "--install", build, "--prefix", "/usr", "--strip"],
        check=True,
        env=environment,
        stdout=subprocess.DEVNULL,
    )
    for here, folders, files in os.walk(folder, topdown=False):
        for name in files:
            if name.split(".")[0] in parts.PROGRAMS_LEFT_OUT:
                os.remove(os.path.join(here, name))
        for name in folders:
            if name == "__pycache__":
                shutil.rmtree(os.path.join(here, name))
    return elf.elf_files(folder)


def _plugins(folder):
    """Qt's plugins, copied: path -> where from."""
    known = elf.installed()
    if "libQt6Core.so.6" not in known:
        raise closure.Refused("Qt 6 is not installed, so its plugins cannot be carried.")
    source = os.path.join(
        os.path.dirname(os.path.realpath(known["libQt6Core.so.6"])), "qt6", "plugins"
    )
    copied = {}
    for name in parts.PLUGINS:
        target = os.path.join(folder, PLUGINS, name)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        shutil.copyfile(os.path.join(source, name), target)
        os.chmod(target, 0o644)
        copied[target] = os.path.join(source, name)
    return copied


def _libraries(folder, roots):
    """The libraries, copied: path -> where from."""
    copied = {}
    os.makedirs(os.path.join(folder, LIB), exist_ok=True)
    for soname, path in sorted(closure.libraries(roots).items()):
        closure.check_left_out(path, soname)
        target = os.path.join(folder, LIB, soname)
        shutil.copyfile(path, target)
        copied[target] = path
    return copied


def _relocate(folder, files):
    """Every program and library looks for the others from where it lies itself."""
    for path in files:
        way = os.path.relpath(os.path.join(folder, LIB), os.path.dirname(path))
        os.chmod(path, os.stat(path).st_mode | 0o200)
        elf.patch(path, "--set-rpath", "$ORIGIN" if way == "." else f"$ORIGIN/{way}")
        without = {
            library: names
            for (importer, library), names in parts.LEFT_OUT.items()
            if importer == os.path.basename(path)
        }
        if without:
            elf.leave_out(path, without)


def _write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def _entrance(folder, files):
    """AppRun, its second name, the desktop's two files, and the list that AppRun checks."""
    shutil.copyfile(os.path.join(HERE, "AppRun"), os.path.join(folder, "AppRun"))
    os.chmod(os.path.join(folder, "AppRun"), 0o755)
    os.symlink("AppRun", os.path.join(folder, "underact-cli"))
    shutil.copyfile(
        os.path.join(ROOT, "resources", "icons", "underact.svg"),
        os.path.join(folder, "underact.svg"),
    )
    os.symlink("underact.svg", os.path.join(folder, ".DirIcon"))
    for desktop in glob.glob("usr/share/applications/*.desktop", root_dir=folder):
        os.symlink(desktop, os.path.join(folder, os.path.basename(desktop)))
    _write(
        os.path.join(folder, "usr/bin/qt.conf"), "[Paths]\nPrefix = ..\nPlugins = lib/qt6/plugins\n"
    )
    asked = sorted({name for path in files for name in elf.needed(path)} & set(parts.SYSTEM))
    _write(
        os.path.join(folder, "usr/share/underact/bundle/system-libraries"),
        "".join(f"{name} {parts.SYSTEM[name]}\n" for name in asked),
    )


def make(build, folder, version, epoch):
    """Makes the AppDir in folder, which is empty, with its licences and its list of parts."""
    table = licences.read_table()
    programs = install(build, folder)
    closure.check_programs(programs)
    origin = _plugins(folder)
    origin.update(_libraries(folder, programs + list(origin)))
    package_of = licences.packages_of(origin.values())
    of_file = {os.path.relpath(path, folder): package_of[source] for path, source in origin.items()}
    packages = set(of_file.values()) | set(parts.HEADERS)
    licences.check(packages, table)
    files = elf.elf_files(folder)
    _relocate(folder, files)
    missing = closure.unresolved(folder)
    if missing:
        path, names = next(iter(missing.items()))
        raise closure.Refused(
            f"{path} asks for {names[0]}, which no library of the bundle or the system has."
        )
    _entrance(folder, files)
    licences.copy_texts(packages, os.path.join(folder, LICENCES))
    shutil.copyfile(os.path.join(ROOT, "LICENSE"), os.path.join(folder, LICENCES, "underact"))
    licences.write_sources(packages, os.path.join(folder, LICENCES, "SOURCES"))
    linked = {name: "DYNAMIC_LINK" for name in of_file.values()} | {
        name: "STATIC_LINK" for name in parts.HEADERS
    }
    of_file.update({os.path.relpath(path, folder): "" for path in programs})
    spdx.write(
        os.path.join(folder, "usr/share/doc/underact/underact.spdx.json"),
        spdx.document(version, epoch, folder, of_file, table[1], linked),
    )
