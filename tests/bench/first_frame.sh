#!/usr/bin/env bash
# From process start to the first correct frame of `building`, written as PNG at 1280 x 720: CPU time of `boxprobe render`,
# capture and prefilter included, beside that of F3D writing the same model, camera and sky. User and system time of the
# process and its children, which a busy machine disturbs less than the wall clock; runs take turns, medians are compared.
#
# usage: tests/bench/first_frame.sh [RUNS] [PROGRAM]      default: 9 runs of build/release/bin/boxprobe
# needs: f3d (apt-get install f3d), xvfb
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
runs=${1:-9}
program=${2:-$root/build/release/bin/boxprobe}
scenes=$root/data/scenes
fail() { echo "first_frame: $*" >&2; exit 1; }

[[ $runs =~ ^[1-9][0-9]*$ ]] || fail "RUNS must be a number from 1 up, not '$runs'"
[[ -x $program ]] || fail "$program is not there; build it with ./run --help"
for needed in f3d Xvfb; do command -v "$needed" >/dev/null || fail "$needed is missing; apt-get install ${needed,,}"; done

work=$(mktemp -d)
server=
cleanup() {
  [[ -z $server ]] || kill "$server" 2>/dev/null || true
  rm -rf "$work"
}
trap cleanup EXIT

# One X server for all runs, outside of what is measured: both draw in their own process (llvmpipe).
mkfifo "$work/display"
Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
server=$!
read -r number <"$work/display"
export DISPLAY=:$number

# The same view for both, whatever the scene file's cameras are.
position=4.4,2.1,4.4 target=-1.4,0.95,-1.8 angle=54
ours() {
  "$program" render "$scenes/building.boxprobe.json" -o "$1" --size 1280x720 --quiet --set "cameras.main.position=[$position]" \
    --set "cameras.main.target=[$target]" --set "cameras.main.verticalFovDegrees=$angle"
}
theirs() {
  f3d "$scenes/building.glb" --hdri="$scenes/sky.hdr" --output="$1" --resolution=1280,720 --up=+Y --dry-run --quiet \
    --camera-position="$position" --camera-focal-point="$target" --camera-view-angle="$angle"
}

# A picture that is missing, of another size or different from the first run's would make its time meaningless.
check() {
  local name=$1 picture=$work/$1.png size
  [[ -s $picture ]] || fail "$name wrote no picture"
  size=$(od -An -tu1 -j16 -N8 "$picture" | awk '{print $3*256+$4 "x" $7*256+$8}')
  [[ $size == 1280x720 ]] || fail "$name wrote a picture of $size"
  [[ -e $work/$name.first ]] || cp "$picture" "$work/$name.first"
  cmp -s "$picture" "$work/$name.first" || fail "$name wrote two different pictures of the same scene"
}

# Appends the CPU seconds of one run to $work/NAME.times.
TIMEFORMAT='%U %S'
measure() {
  local name=$1
  rm -f "$work/$name.png"
  { time "$name" "$work/$name.png" >"$work/$name.log" 2>&1; } 2>"$work/time" || fail "$name failed: $(tail -n 1 "$work/$name.log")"
  check "$name"
  awk '{print $1 + $2}' "$work/time" >>"$work/$name.times"
}

# The middle one, or the mean of the middle two; then least and greatest.
summary() { sort -g "$1" | awk '{t[NR]=$1} END {m=int((NR+1)/2); printf "%.3f %.3f %.3f", (t[m]+t[NR+1-m])/2, t[1], t[NR]}'; }

# Once each, not counted: disk caches and Mesa's shader cache are warm for both from then on.
measure ours
measure theirs
rm "$work"/*.times
for ((run = 0; run < runs; ++run)); do
  measure ours
  measure theirs
done

read -r our_median our_least our_most < <(summary "$work/ours.times"; echo)
read -r their_median their_least their_most < <(summary "$work/theirs.times"; echo)
echo "CPU seconds from start to the first frame written, $runs runs in turn: median (least to greatest)"
printf '%-16s %s (%s to %s)\n' "boxprobe render" "$our_median" "$our_least" "$our_most"
printf '%-16s %s (%s to %s)\n' "$(f3d --version | head -n 1)" "$their_median" "$their_least" "$their_most"
awk -v a="$our_median" -v b="$their_median" 'BEGIN {printf "ratio            %.2f\n", a / b}'

# Stock VTK with image-based lighting from a 256² cube at its defaults: once, it takes long.
stock=$(dirname "$program")/../tests/bench/bench_stock_first_frame
if [[ -x $stock ]]; then
  seconds=$("$stock" 2>/dev/null)
  awk -v a="$our_median" -v b="$seconds" 'BEGIN {printf "%-16s %.3f\nratio            %.3f\n", "stock VTK", b, a / b}'
fi
