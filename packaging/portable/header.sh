#!/bin/sh
# Underact @VERSION@ in one file: it unpacks itself on the first start, and runs.
#   Underact.run [SCENE]         the window         Underact.run cli ...   the command line
#   Underact.run --unpack DIR    unpack into DIR    Underact.run --check   is the file complete?
#   Underact.run --remove        deletes the unpacked copy
set -eu
lines=@LINES@
sum=@SUM@
name=@NAME@
self=$0
case $self in */*) ;; *) self=$(command -v -- "$self") ;; esac
case :$PATH: in *:[!/]*) PATH=/usr/local/bin:/usr/bin:/bin ;; esac  # nothing is run from the current folder
home=${UNDERACT_BUNDLE_DIR:-${XDG_CACHE_HOME:-${HOME:-}}}
[ -n "$home" ] || { echo "There is no home folder to unpack into: set UNDERACT_BUNDLE_DIR to a folder." >&2; exit 4; }
folder=${UNDERACT_BUNDLE_DIR:-${XDG_CACHE_HOME:-${HOME:-}/.cache}/underact/bundle}

payload() { tail -n +"$lines" "$self"; }
whole() {
  [ "$(payload | sha256sum | cut -d ' ' -f 1)" = "$sum" ] && return
  echo "$self is incomplete or damaged: its checksum is wrong. Download it again." >&2
  exit 4
}
unpack() {  # into $1, completely or not at all
  whole
  mkdir -p "$1" && part=$(mktemp -d "$1/.part.XXXXXX") || { echo "The folder $1 is not writable." >&2; exit 4; }
  find "$1" -maxdepth 1 -name '.part.*' -mmin +60 -exec rm -rf {} +  # left by an interrupted one
  trap 'rm -rf "$part"' EXIT
  trap 'exit 130' INT TERM
  payload | gzip -dc | tar -xf - -C "$part" || { echo "Unpacking into $1 failed: is the disk full?" >&2; exit 4; }
  if [ "$2" = anew ] || [ ! -x "$1/$name/AppRun" ]; then  # another start may have unpacked it meanwhile, and use it
    rm -rf "${1:?}/$name"
    mv -T "$part/$name" "$1/$name" 2>/dev/null || [ -x "$1/$name/AppRun" ]
  fi
  rm -rf "$part"
  trap - EXIT INT TERM
}

case ${1:-} in
  --check) whole; echo "$self is complete."; exit 0 ;;
  --unpack)
    [ $# -eq 2 ] || { echo "Usage: $0 --unpack DIR" >&2; exit 2; }
    unpack "$2" anew; echo "Start it with $2/$name/AppRun"; exit 0 ;;
  --remove)  # what this and earlier versions have unpacked, and nothing else
    for one in "$folder"/[0-9a-f]*[0-9a-f]/Underact-*.AppDir; do
      [ -x "$one/usr/bin/underact-cli" ] || continue
      rm -rf "$one"
      rmdir "$(dirname "$one")" 2>/dev/null || true
      echo "Deleted $one"
    done
    rmdir "$folder" 2>/dev/null || true
    exit 0 ;;
esac
home=$folder/$(printf %.16s $sum)
if [ ! -x "$home/$name/AppRun" ]; then
  echo "Unpacking into $home (first start only)" >&2
  unpack "$home" once
fi
if [ ! -x "$home/$name/AppRun" ]; then
  echo "Programs cannot run from $home (mounted noexec?). Set UNDERACT_BUNDLE_DIR to a folder where they can." >&2
  exit 4
fi
exec "$home/$name/AppRun" "$@"
