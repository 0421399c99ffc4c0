#!/bin/sh
# Underact @VERSION@ in one file: it unpacks itself once, beside nothing else, and starts.
#   Underact.run [SCENE]         the window         Underact.run cli ...   the command line
#   Underact.run --unpack DIR    into DIR only      Underact.run --check   whether the file came whole
#   Underact.run --remove        takes away what it has unpacked
set -eu
lines=@LINES@
sum=@SUM@
name=@NAME@
self=$0
case $self in */*) ;; *) self=$(command -v -- "$self") ;; esac
case :$PATH: in *:[!/]*) PATH=/usr/local/bin:/usr/bin:/bin ;; esac  # nothing is run from the folder one stands in
home=${UNDERACT_BUNDLE_DIR:-${XDG_CACHE_HOME:-${HOME:-}}}
[ -n "$home" ] || { echo "There is no home to unpack into: set UNDERACT_BUNDLE_DIR to a folder." >&2; exit 4; }
folder=${UNDERACT_BUNDLE_DIR:-${XDG_CACHE_HOME:-${HOME:-}/.cache}/underact/bundle}

payload() { tail -n +"$lines" "$self"; }
whole() {
  [ "$(payload | sha256sum | cut -d ' ' -f 1)" = "$sum" ] && return
  echo "$self did not come whole: its contents are not what they were when it was made. Please fetch it again." >&2
  exit 4
}
unpack() {  # into $1, which is there afterwards or not at all
  whole
  mkdir -p "$1" && part=$(mktemp -d "$1/.part.XXXXXX") || { echo "Nothing can be written in $1." >&2; exit 4; }
  find "$1" -maxdepth 1 -name '.part.*' -mmin +60 -exec rm -rf {} +  # of one that was killed
  trap 'rm -rf "$part"' EXIT
  trap 'exit 130' INT TERM
  payload | gzip -dc | tar -xf - -C "$part" || { echo "It could not be unpacked into $1: is the disk full?" >&2; exit 4; }
  if [ "$2" = anew ] || [ ! -x "$1/$name/AppRun" ]; then  # it may be there by now, and in use: two were started at once
    rm -rf "${1:?}/$name"
    mv -T "$part/$name" "$1/$name" 2>/dev/null || [ -x "$1/$name/AppRun" ]
  fi
  rm -rf "$part"
  trap - EXIT INT TERM
}

case ${1:-} in
  --check) whole; echo "$self is whole."; exit 0 ;;
  --unpack)
    [ $# -eq 2 ] || { echo "Usage: $0 --unpack DIR" >&2; exit 2; }
    unpack "$2" anew; echo "$2/$name/AppRun starts it."; exit 0 ;;
  --remove)  # what it and its earlier versions have unpacked, and nothing else that may lie there
    for one in "$folder"/[0-9a-f]*[0-9a-f]/Underact-*.AppDir; do
      [ -x "$one/usr/bin/underact-cli" ] || continue
      rm -rf "$one"
      rmdir "$(dirname "$one")" 2>/dev/null || true
      echo "$one is gone."
    done
    rmdir "$folder" 2>/dev/null || true
    exit 0 ;;
esac
home=$folder/$(printf %.16s $sum)
if [ ! -x "$home/$name/AppRun" ]; then
  echo "Unpacking into $home, once." >&2
  unpack "$home" once
fi
if [ ! -x "$home/$name/AppRun" ]; then
  echo "Programs may not run from $home (mounted noexec?). Set UNDERACT_BUNDLE_DIR to a folder where they may." >&2
  exit 4
fi
exec "$home/$name/AppRun" "$@"
