# Read by others: make_root SUITE makes a bare Debian in $root, as wide as apt needs, and takes it away at the end;
# in_root COMMAND... runs a command there. The bare root is kept in the user's cache and copied.
make_root() {
  local suite=$1 cache=${XDG_CACHE_HOME:-$HOME/.cache}/underact-roots mirror work
  [ "$(id -u)" = 0 ] || { echo "this needs root (chroot)"; exit 2; }
  command -v debootstrap >/dev/null || { echo "SKIPPED: debootstrap is not installed"; exit 77; }
  mkdir -p "$cache"
  if [ ! -f "$cache/$suite.tar" ]; then
    mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | grep -oE 'https?://[^ ]+/debian/?( |$)' | head -n 1 | tr -d ' ' || true)
    work=$(mktemp -d)
    debootstrap --variant=minbase --include=ca-certificates "$suite" "$work" "${mirror:-http://deb.debian.org/debian}" \
      >"$cache/$suite.log" 2>&1 || { tail -n 5 "$cache/$suite.log"; exit 1; }
    tar -C "$work" -cf "$cache/$suite.tar.part" .
    mv "$cache/$suite.tar.part" "$cache/$suite.tar"
    rm -rf --one-file-system "$work"
  fi
  root=$(mktemp -d "${TMPDIR:-/tmp}/underact-root.XXXXXX")
  trap take_root_away EXIT
  tar -C "$root" -xf "$cache/$suite.tar"
  chmod 755 "$root"
  # How this machine reaches packages: proxies and certificates, if there are any.
  cp -a /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
  cp -L /etc/pip.conf "$root/etc/" 2>/dev/null || true
  cp -a /etc/apt/auth.conf.d "$root/etc/apt/" 2>/dev/null || true
  cp -L /etc/resolv.conf /etc/hosts "$root/etc/" 2>/dev/null || true
  cp -a /etc/ssl/certs/. "$root/etc/ssl/certs/" 2>/dev/null || true
  cp -a /usr/local/share/ca-certificates "$root/usr/local/share/" 2>/dev/null || true
  for place in dev dev/pts dev/shm proc sys; do mount --bind "/$place" "$root/$place"; done
}

take_root_away() {
  local place
  for place in proc sys dev/shm dev/pts dev; do
    ! mountpoint -q "$root/$place" || umount -l "$root/$place"
  done
  rm -rf --one-file-system "$root"
}

in_root() {
  # shellcheck disable=SC2046  # variables of proxies, a word each
  chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive $(env | grep -iE '^(https?|no)_proxy=' || true) "$@"
}
