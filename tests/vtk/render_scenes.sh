#!/usr/bin/env bash
# Draws every scene of data/scenes through each of its cameras, without X, for a comparison of systems:
#   tests/vtk/render_scenes.sh build/release/bin/boxprobe OUT_12      on one system
#   build/release/tests/compare/picture_difference pictures OUT_12 OUT_13
# SIZE=WxH (default 320x180). Captures are made anew on each system: baked files of another one are not read.
set -euo pipefail

data=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../data/scenes" && pwd -P)
(($# == 2)) || { sed -n 3p "$0" >&2; exit 2; }
program=$(realpath "$1")
mkdir -p "$2"
out=$(realpath "$2")
for file in "$data"/*.boxprobe.json; do
  scene=$(basename "$file" .boxprobe.json)
  mkdir -p "$out/$scene"
  cameras=$("$program" info "$file" --json --quiet |
    sed -n '/^  "cameras"/,/^  \]/s/^      "name": "\(.*\)",\{0,1\}$/\1/p')
  [[ -n $cameras ]] || { echo "render_scenes.sh: $file: no camera" >&2; exit 1; }
  while read -r camera; do
    env -u DISPLAY "$program" render "$file" --camera "$camera" --size "${SIZE:-320x180}" --samples 1 --quiet \
      -o "$out/$scene/$camera.png"
  done <<<"$cameras"
done
