#!/usr/bin/env bash
# What a graphics card draws, and how fast, on a machine where nothing is installed but the card's driver.
#
# usage: tests/bench/card.sh pack FOLDER    after `ninja -C build/release boxprobe bench_frame bench_nodes picture_difference
#                                           generate_scenes parity_test`: programs, their libraries, scenes and llvmpipe's pictures,
#                                           as FOLDER/card.tar.xz
#        card.sh run OUT [SCENE...]         there, in the unpacked folder `card`; in a checkout its build is run as it stands
#
# `run` draws every scene and compares it with llvmpipe's picture of it: stored by `pack`, else drawn by LIBGL_ALWAYS_SOFTWARE=1 on the
# spot. Then times: frames over stock VTK's, lamps as shapes, the parts of the tuning, an apartment of 1,280 probes, nodes of diffuse
# light; and the parity of shaders and C++. OUT/report.txt has what was printed, OUT/pictures the pictures. A step that fails is said and
# the next one runs; exit status 1 then.
# environment: SIZE (320x180), FRAMES (30), PROBES (1280), SECONDS_EACH (300), PARTS (pictures frames lamps tuning probes nodes parity)
set -uo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
size=${SIZE:-320x180} frames=${FRAMES:-30} probes=${PROBES:-1280} seconds=${SECONDS_EACH:-300}
parts=${PARTS:-pictures frames lamps tuning probes nodes parity}
programs=(bin/boxprobe tests/bench/bench_frame tests/bench/bench_nodes tests/compare/picture_difference data/scenes/generate_scenes
  tests/parity/parity_test)
fail() { echo "card: $*" >&2; exit 2; }

draw_on_cpu() {  # SCENE PICTURE
  GALLIVM_PERF=nopt LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe timeout "$seconds" "$boxprobe" render "$1" -o "$2" --size "$size" --quiet
}

pack() {
  local root build stage program file
  root=$(cd "$here/../.." && pwd -P) build=${BUILD:-$root/build/release}
  mkdir -p "$1" && stage=$(cd "$1" && pwd -P)/card || fail "$1 cannot be made"
  rm -rf "$stage"
  mkdir -p "$stage"/{bin,lib,loader,scenes,pictures}
  for program in "${programs[@]}"; do
    [[ -x $build/$program ]] || { echo "card: not built, left out: $program"; continue; }
    strip -o "$stage/bin/$(basename "$program")" "$build/$program"
    ldd "$build/$program" | awk '$2 == "=>" && $3 ~ /^\// {print $3} $1 ~ /^\/.*ld-linux/ {print $1}'
  done | tee "$stage/list" | grep '^card:'
  grep -v '^card:' "$stage/list" | sort -u | while read -r file; do
    case $(basename "$file") in
      ld-linux*|libc.so.*|libm.so.*|libdl.so.*|libpthread.so.*|librt.so.*|libresolv.so.*|libutil.so.*|libmvec.so.*)
        cp -L "$file" "$stage/loader/" ;;
      *) cp -L "$file" "$stage/lib/" && strip --strip-unneeded "$stage/lib/$(basename "$file")" 2>/dev/null ;;
    esac
  done
  rm "$stage/list"
  objdump -T "$stage"/bin/* "$stage"/lib/* 2>/dev/null | grep -o 'GLIBC_2\.[0-9]*' | sort -V | tail -1 | sed 's/GLIBC_//' >"$stage/needs-glibc"
  cp "$root"/data/scenes/*.{boxprobe.json,glb,hdr} "$stage/scenes/"
  cp "$here/card.sh" "$stage/"
  boxprobe=$build/bin/boxprobe
  for file in "$root"/data/scenes/*.boxprobe.json; do
    draw_on_cpu "$file" "$stage/pictures/$(basename "$file" .boxprobe.json).png" || echo "card: no picture of $(basename "$file")"
  done
  echo "$size" >"$stage/pictures/size"
  tar -C "$1" -cJf "$1/card.tar.xz" card
  du -sh "$1/card.tar.xz"
}

# Libraries of the pack, but for those that a driver loads as well, which are the machine's own where it has them; the C library of the
# pack where the machine's is older.
use_pack() {
  local file name have need
  for file in "$here"/lib/*; do
    name=$(basename "$file")
    case $name in
      libstdc++*|libgcc_s*|libX*|libxcb*|libdrm*|libGL*|libOpenGL*|libEGL*|libexpat*|libz.so*|libgbm*|libwayland*|libffi*|libbsd*|libmd.so*)
        ldconfig -p | grep -q "	$name " && rm "$file" ;;
    esac
  done
  file=/usr/local/nvidia/share/glvnd/egl_vendor.d/10_nvidia.json
  [[ -e $file ]] && ! ls /usr/share/glvnd/egl_vendor.d/*nvidia* >/dev/null 2>&1 && export __EGL_VENDOR_LIBRARY_FILENAMES=$file
  path=$here/lib:/usr/local/nvidia/lib64:/usr/local/nvidia/lib
  have=$(getconf GNU_LIBC_VERSION 2>/dev/null | awk '{print $2}') need=$(<"$here/needs-glibc") loader=
  [[ $(printf '%s\n%s\n' "$need" "${have:-0}" | sort -V | head -1) == "$need" ]] || loader=yes
  mkdir -p "$out/bin"
  for file in "$here"/bin/*; do  # each by a script, so that what starts it need not know
    name=$out/bin/$(basename "$file")
    if [[ -n $loader ]]; then
      printf '#!/bin/sh\nexec "%s" --library-path "%s" "%s" "$@"\n' "$(ls "$here"/loader/ld-linux*)" \
        "$here/loader:$path:/usr/lib/x86_64-linux-gnu" "$file" >"$name"
    else
      printf '#!/bin/sh\nLD_LIBRARY_PATH="%s" exec "%s" "$@"\n' "$path" "$file" >"$name"
    fi
    chmod +x "$name"
  done
  echo "glibc ${have:-unknown}, needed $need${loader:+; the C library of the pack is used}"
}

failed=0
step() {  # TITLE COMMAND...
  local title=$1 began=$SECONDS status
  shift
  echo "== $title"
  timeout "$seconds" "$@" 2>&1
  status=$?
  ((status == 0)) || { failed=$((failed + 1)); echo "FAILED: $title ended with $status"; }
  echo "-- $((SECONDS - began)) s"
}

needs() {  # PROGRAM: there, or said to be missing
  [[ -x $1 ]] || { echo "== left out, as it is not there: $(basename "$1")"; return 1; }
}

# Textures are sampled as llvmpipe does: anisotropic sampling would differ everywhere.
pictures() {
  local scene name
  mkdir -p "$out/pictures" "$out/llvmpipe"
  [[ ! -e $stored/size || $(<"$stored/size") == "$size" ]] || echo "stored pictures are of $(<"$stored/size"), not $size"
  for scene in "${scenes[@]}"; do
    name=$(basename "$scene" .boxprobe.json)
    step "draw $name" env BOXPROBE_ANISOTROPY=1 "$boxprobe" render "$scene" -o "$out/pictures/$name.png" --size "$size" --quiet
    if [[ -e $stored/$name.png && $(<"$stored/size") == "$size" ]]; then
      cp "$stored/$name.png" "$out/llvmpipe/"
    else
      draw_on_cpu "$scene" "$out/llvmpipe/$name.png" || echo "no picture by llvmpipe: $name"
    fi
  done
  needs "$difference" && { echo "== against llvmpipe's pictures"; "$difference" pictures "$out/llvmpipe" "$out/pictures"; }
}

run() {
  local room=$scenes_at/room.boxprobe.json building=$scenes_at/building.boxprobe.json part rooms
  echo "$(uname -sm), $(nproc) processors"
  command -v nvidia-smi >/dev/null && nvidia-smi -L
  timeout "$seconds" "$boxprobe" render "$room" -o "$out/first.png" --size 64x36 --quiet --stats "$out/first.json" ||
    { echo "FAILED: nothing is drawn"; return 1; }
  grep -A3 '"gl"' "$out/first.json"
  for part in $parts; do
    case $part in
      pictures) pictures ;;
      frames)
        needs "$frame" && for scene in "$room" "$building"; do
          step "frame over stock VTK's, $(basename "$scene")" "$frame" "$scene" --frames "$frames" --size "$size"
          step "the same without constants" "$frame" "$scene" --frames "$frames" --size "$size" --no-constants
        done ;;
      lamps) needs "$frame" && step "0, 1, 4 and 8 lamps as shapes" "$frame" "$room" --panels --draw-hidden --frames "$frames" --size "$size" ;;
      tuning) needs "$frame" && step "parts of the tuning" "$frame" "$building" --tuning --frames "$frames" --size "$size" ;;
      probes)
        needs "$generate" || continue
        rooms=$(((probes * 4 + 4) / 5))
        step "an apartment of $rooms rooms" "$generate" "$out" --apartments "$rooms"
        step "$probes probes, $frames frames" "$boxprobe" render "$out/apartments-$rooms.boxprobe.json" -o "$out/apartments.png" \
          --size "$size" --frames "$frames" --quiet --stats "$out/apartments.json"
        grep -E 'facesCaptured|startToFirst|frameCpuSecondsM|peakResident' "$out/apartments.json" ;;
      nodes) needs "$nodes" && step "nodes of diffuse light" "$nodes" ;;
      parity) needs "$parity" && step "shaders against C++" "$parity" --gtest_brief=1 ;;
      *) echo "no part $part"; failed=$((failed + 1)) ;;
    esac
  done
  echo "$failed failed"
  return $((failed > 0))
}

case ${1-} in
  pack)
    (($# == 2)) || fail "usage: card.sh pack FOLDER"
    pack "$2" ;;
  run)
    (($# >= 2)) || fail "usage: card.sh run OUT [SCENE...]"
    mkdir -p "$2" && out=$(cd "$2" && pwd -P) || fail "$2 cannot be made"
    shift 2
    if [[ -d $here/bin ]]; then
      use_pack >"$out/used"  # not in a subshell: it exports
      used=$(<"$out/used") scenes_at=$here/scenes stored=$here/pictures
      at() { echo "$out/bin/$(basename "$1")"; }
    else
      root=$(cd "$here/../.." && pwd -P)
      used="the build of this checkout" scenes_at=$root/data/scenes stored=$root/out/no-pictures
      at() { echo "${BUILD:-$root/build/release}/$1"; }
    fi
    boxprobe=$(at "${programs[0]}") frame=$(at "${programs[1]}") nodes=$(at "${programs[2]}") difference=$(at "${programs[3]}")
    generate=$(at "${programs[4]}") parity=$(at "${programs[5]}")
    scenes=("$scenes_at"/*.boxprobe.json)
    (($# == 0)) || { scenes=(); for name in "$@"; do scenes+=("$scenes_at/$name.boxprobe.json"); done; }
    { echo "$used"; run; } 2>&1 | tee "$out/report.txt"
    exit "${PIPESTATUS[0]}" ;;
  *) fail "usage: card.sh pack FOLDER | card.sh run OUT [SCENE...]" ;;
esac
