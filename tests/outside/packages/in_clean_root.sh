#!/usr/bin/env bash
# The Debian packages on a machine that has nothing else: in_clean_root.sh PACKAGES FOLDER [--release NAME] [--base DIR] [--picture PNG]
#   [--example PROJECT] [--develop]
# PACKAGES is a folder of .deb files (cpack). A clean root of that release of Debian is made in FOLDER by debootstrap, or copied from
# --base, and kept there as base-RELEASE for the next call. There apt installs `boxprobe` with what it depends on; `boxprobe render`
# draws the room without X, by EGL, and once more under xvfb. The two pictures, and --picture (one from elsewhere), must be equal.
# --example: the Python package, too, with its example; --develop: the one in C++, built against libboxprobe-dev.
# Needs root, debootstrap and a mirror of Debian's packages. Everything is mounted in a namespace of its own: nothing stays mounted.
set -euo pipefail
left_out() { echo "left out: $*"; exit 77; }
fail() { echo "FAILED: $*"; exit 1; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
packages=$(realpath "$1")
folder=$(mkdir -p "$2" && realpath "$2")
shift 2
release=bookworm base='' picture='' example='' develop=''
while (($#)); do
  case $1 in
    --release) release=$2; shift ;;
    --base) base=$(realpath "$2"); shift ;;
    --picture) picture=$(realpath "$2"); shift ;;
    --example) example=$(realpath "$2"); shift ;;
    --develop) develop=yes ;;
    *) echo "in_clean_root.sh: $1 is no option"; exit 2 ;;
  esac
  shift
done
((EUID == 0)) || left_out "a clean root needs root"
command -v debootstrap >/dev/null || left_out "package debootstrap is not installed"
[[ -z $develop || -n $example ]] || fail "--develop needs --example PROJECT"
shopt -s nullglob
programs=("$packages"/boxprobe_*.deb)
((${#programs[@]} == 1)) || fail "$packages holds ${#programs[@]} packages boxprobe_*.deb; there should be one"
mirror=http://deb.debian.org/debian
if [[ -z $base ]]; then
  base=$folder/base-$release
  if [[ ! -e $base.made ]]; then
    rm -rf "$base"
    debootstrap --variant=minbase --include=ca-certificates "$release" "$base" "$mirror" >"$folder/debootstrap.log" 2>&1 || {
      tail -3 "$folder/debootstrap.log"
      left_out "debootstrap made no $release from $mirror"
    }
    touch "$base.made"
  fi
fi
root=$folder/root
rm -rf --one-file-system "$root"
cp -a "$base" "$root"
cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
for settings in /etc/apt/apt.conf.d/*prox* /etc/apt/apt.conf; do
  [[ -f $settings ]] && cp "$settings" "$root/etc/apt/apt.conf.d/90of-this-machine"
done
mkdir -p "$root/try"
cp "$packages"/*.deb "$root/try/"
[[ -z $picture ]] || cp "$picture" "$root/try/elsewhere.png"
cp "$here/within_clean_root.sh" "$here/../python/shining.py" "$here/../python/compare_pictures.py" "$root/try/"
[[ -z $example ]] || cp -r "$example/tests/install/example" "$root/try/example"
# A mount namespace of its own, so that an end of any kind leaves nothing behind.
unshare --mount --pid --fork --kill-child bash -c '
  set -e
  mount -t proc proc "$1/proc"; mount --rbind /sys "$1/sys"; mount --rbind /dev "$1/dev"
  exec chroot "$1" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    GALLIVM_PERF=nopt bash /try/within_clean_root.sh "$2" "$3"' _ "$root" "${example:+example}" "$develop" </dev/null
cp "$root"/try/*.png "$folder/"
rm -rf --one-file-system "$root"
