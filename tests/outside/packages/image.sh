#!/usr/bin/env bash
# An OCI image of the program alone, for farms and build servers without a display: image.sh PACKAGES FOLDER [--base DIR] [--try SCENE]
# PACKAGES has boxprobe_*.deb (`cpack --config build/release/CPackConfig.cmake -B PACKAGES -D CPACK_COMPONENTS_ALL=Program`). FOLDER gets
# boxprobe-image.tar, which Docker, Podman and Apptainer load. Debian 12, the package, Mesa's software OpenGL, which is used where the
# host gives no card to the container. Its command is `boxprobe`, its folder /work:
#   podman run --rm -v "$PWD":/work boxprobe bake SCENE.json -o out
# --base: a root that debootstrap made before. --try: unpacks the image elsewhere and bakes that scene in it, whose folder is /work there.
# Needs root, buildah, debootstrap and a mirror of Debian's packages.
set -euo pipefail
left_out() { echo "left out: $*"; exit 77; }
fail() { echo "FAILED: $*"; exit 1; }
(($# >= 2)) || fail "usage: image.sh PACKAGES FOLDER [--base DIR] [--try SCENE]"
packages=$(realpath "$1")
folder=$(mkdir -p "$2" && realpath "$2")
shift 2
base='' scene=''
while (($#)); do
  case $1 in
    --base) base=$(realpath "$2") ;;
    --try) scene=$(realpath "$2") ;;
    *) echo "image.sh: $1 is no option"; exit 2 ;;
  esac
  shift 2
done
((EUID == 0)) || left_out "an image needs root"
for tool in buildah debootstrap; do command -v $tool >/dev/null || left_out "package $tool is not installed"; done
shopt -s nullglob
programs=("$packages"/boxprobe_*.deb)
((${#programs[@]} == 1)) || fail "$packages holds ${#programs[@]} packages boxprobe_*.deb; there should be one"
if [[ -z $base ]]; then
  base=$folder/base
  [[ -e $base.made ]] || {
    rm -rf "$base"
    debootstrap --variant=minbase bookworm "$base" http://deb.debian.org/debian >"$folder/debootstrap.log" 2>&1 ||
      left_out "debootstrap made no root: $(tail -1 "$folder/debootstrap.log")"
    touch "$base.made"
  }
fi

build=$(buildah from scratch)
trap 'buildah rm "$build" >/dev/null 2>&1 || true' EXIT
root=$(buildah mount "$build")
cp -a "$base/." "$root/"
cp -L /etc/resolv.conf "$root/etc/"
for settings in /etc/apt/apt.conf.d/*prox* /etc/apt/apt.conf; do
  [[ -f $settings ]] && cp "$settings" "$root/etc/apt/apt.conf.d/90of-this-machine"
done
cp "${programs[0]}" "$root/tmp/boxprobe.deb"
chroot "$root" bash -c '
  set -e
  export DEBIAN_FRONTEND=noninteractive
  apt-get -q update
  apt-get -q install -y --no-install-recommends /tmp/boxprobe.deb libegl-mesa0 libgl1-mesa-dri fonts-dejavu-core
  apt-get -q clean
' >"$folder/install.log" 2>&1 || { tail -5 "$folder/install.log"; fail "apt could not install the package"; }
# What only installing needs; the host's addresses and proxies are not the image's.
rm -rf "$root"/tmp/* "$root"/var/lib/apt/lists/* "$root"/var/cache/* "$root"/var/log/* "$root/etc/apt/apt.conf.d/90of-this-machine" \
  "$root/etc/resolv.conf" "$root"/usr/share/locale/*
mkdir -p "$root/work"
buildah config --entrypoint '["boxprobe"]' --workingdir /work --env LANG=C.UTF-8 \
  --label org.opencontainers.image.title=boxprobe --label org.opencontainers.image.licenses=BSD-3-Clause \
  --label "org.opencontainers.image.version=$(dpkg-deb -f "${programs[0]}" Version)" "$build"
buildah umount "$build" >/dev/null
rm -f "$folder/boxprobe-image.tar"
buildah commit --quiet --disable-compression=false "$build" "oci-archive:$folder/boxprobe-image.tar:boxprobe" >/dev/null
echo "boxprobe-image.tar: $(stat -c %s "$folder/boxprobe-image.tar" | awk '{printf "%.0f MB", $1 / 1e6}'), unpacked $(du -sm "$(buildah mount "$build")" | cut -f1) MB"
[[ -n $scene ]] || exit 0

# From the file alone, as somebody else has it.
tried=$(buildah from "oci-archive:$folder/boxprobe-image.tar")
trap 'buildah rm "$build" "$tried" >/dev/null 2>&1 || true' EXIT
run=(buildah run --isolation chroot --volume "$(dirname "$scene"):/work" "$tried" -- boxprobe)
"${run[@]}" --version
start=$(date +%s)
"${run[@]}" bake "/work/$(basename "$scene")" -o /work/baked-in-image --quiet || fail "the image bakes nothing"
echo "$(basename "$scene") baked in the image: $(($(date +%s) - start)) s, $(find "$(dirname "$scene")/baked-in-image" -type f | wc -l) files"
