"""The same bytes from the same folder: an archive that unpacks itself."""

import gzip
import hashlib
import io
import os
import tarfile

HEADER = os.path.join(os.path.dirname(__file__), "header.sh")


def calm(folder, epoch):
    """Modes as a public file has them, whatever the maker's umask, and one time for all."""
    for here, folders, files in os.walk(folder, topdown=False):
        for path in [os.path.join(here, name) for name in folders + files]:
            if not os.path.islink(path):
                runs = os.path.isdir(path) or os.stat(path).st_mode & 0o100
                os.chmod(path, 0o755 if runs else 0o644)
            os.utime(path, (epoch, epoch), follow_symlinks=False)
    os.chmod(folder, 0o755)
    os.utime(folder, (epoch, epoch))


def _payload(folder, epoch):
    def nobodys(member):
        member.uid = member.gid = 0
        member.uname = member.gname = ""
        member.mtime = epoch
        return member

    packed = io.BytesIO()
    # gzip: a bare Debian root has no xz.
    with gzip.GzipFile(
        filename="", mode="wb", compresslevel=6, fileobj=packed, mtime=0
    ) as stream, tarfile.open(fileobj=stream, mode="w", format=tarfile.GNU_FORMAT) as tar:
        for here, folders, files in os.walk(folder):
            folders.sort()
            links = [name for name in folders if os.path.islink(os.path.join(here, name))]
            at = os.path.join(os.path.basename(folder), os.path.relpath(here, folder))
            tar.add(here, os.path.normpath(at), recursive=False, filter=nobodys)
            for name in sorted(files + links):
                tar.add(
                    os.path.join(here, name),
                    os.path.normpath(os.path.join(at, name)),
                    recursive=False,
                    filter=nobodys,
                )
    return packed.getvalue()


def write_run(folder, path, version, epoch):
    """The self-extracting archive of folder."""
    payload = _payload(folder, epoch)
    with open(HEADER, encoding="utf-8") as file:
        header = file.read()
    header = header.replace("@LINES@", str(header.count("\n") + 1)).replace("@VERSION@", version)
    header = header.replace("@SUM@", hashlib.sha256(payload).hexdigest()).replace(
        "@NAME@", os.path.basename(folder)
    )
    with open(path, "wb") as file:
        file.write(header.encode() + payload)
    os.chmod(path, 0o755)
