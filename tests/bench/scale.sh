#!/usr/bin/env bash
# Apartments of 10 to 10,000 probes and nearly five times as many objects, each looked at through the same camera in room 1: CPU seconds
# of a frame and from start to the first one, the largest resident memory, the faces captured for it, and the bake of ten probes.
# Behind a number its slope, the exponent of its growth with the number of probes since the row before: 0 none, 1 in proportion,
# 2 quadratic.
#
# usage: tests/bench/scale.sh [PROBES...]      default: 10 100 1000 10000
# environment: PROGRAM (build/release/bin/boxprobe), GENERATOR (build/release/data/scenes/generate_scenes), FRAMES (11)
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
program=${PROGRAM:-$root/build/release/bin/boxprobe}
generator=${GENERATOR:-$root/build/release/data/scenes/generate_scenes}
frames=${FRAMES:-11}
fail() { echo "scale: $*" >&2; exit 1; }
[[ $# -gt 0 ]] || set -- 10 100 1000 10000
for count in "$@"; do [[ $count =~ ^[1-9][0-9]*$ ]] || fail "PROBES must be numbers from 1 up, not '$count'"; done
for needed in "$program" "$generator"; do [[ -x $needed ]] || fail "$needed is not there; build it with ./run --help"; done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
value() { sed -n "s/.*\"$2\": *\([0-9.e+-]*\),\{0,1\}$/\1/p" "$1" | head -n 1; }

render() { "$program" render "$1" -o "$work/x.png" --size 640x360 --frames "$frames" --quiet --stats "$work/s.json"; }
bake() {
  "$program" bake "$1" -o "$work/baked" --quiet --only 'room 1' --only 'room 2' --only 'room 3' --only 'room 4' --only 'corridor 1' \
    --only 'room 5' --only 'room 6' --only 'room 7' --only 'room 8' --only 'corridor 2'
  rm -rf "$work/baked"
}

# Once, not counted: Mesa's shader cache is warm from then on.
"$generator" "$work" --apartments 8 >/dev/null
render "$work/apartments-8.boxprobe.json" || fail "nothing is drawn"
bake "$work/apartments-8.boxprobe.json" || fail "nothing is baked"

TIMEFORMAT='%U %S'
echo "| probes | objects | frame, s | slope | start to first frame, s | slope | memory, MiB | slope | faces | bake of ten, s | slope |"
echo "|---|---|---|---|---|---|---|---|---|---|---|"
for count in "$@"; do
  # Five probes for four rooms; a room has five objects and a corridor three.
  rooms=$(((count * 4 + 4) / 5))
  "$generator" "$work" --apartments "$rooms" >/dev/null
  scene=$work/apartments-$rooms.boxprobe.json
  render "$scene" || fail "$count probes are not drawn"
  objects=$("$program" info "$scene" --json | grep -c '"seenByProbes"')
  { time bake "$scene"; } 2>"$work/time" || fail "$count probes: the bake failed: $(cat "$work/time")"
  echo "$count ${objects:-0} $(value "$work/s.json" frameCpuSecondsMedian) $(value "$work/s.json" startToFirstFrameCpuSeconds)" \
    "$(value "$work/s.json" peakResident) $(value "$work/s.json" facesCaptured) $(awk 'END {print $1 + $2}' "$work/time")"
done | awk '
  function slope(now, before, n, m) { return m > 0 && before > 0 && now > 0 ? sprintf("%.2f", log(now / before) / log(n / m)) : "" }
  {
    printf "| %d | %d | %.3f | %s | %.2f | %s | %.0f | %s | %d | %.2f | %s |\n", $1, $2, $3, slope($3, f, $1, n), $4, slope($4, s, $1, n),
      $5 / 1048576, slope($5, b, $1, n), $6, $7, slope($7, k, $1, n)
    fflush()
    n = $1; f = $3; s = $4; b = $5; k = $7
  }'
