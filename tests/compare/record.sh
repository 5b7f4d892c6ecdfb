#!/usr/bin/env bash
# Records what a boxprobe binary does, seen from outside and the same in every run: see README.md.
# record.sh PROGRAM OUT_DIR [DATA_DIR]    DATA_DIR holds scenes/ and lessons/; default: this checkout's data
# Environment: SCENES="room glass" records only these scenes and no lessons; FEW_VIEWS=1 all debug views through the
# first camera only, and a third of them through each other one, taken in turns.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
root=$(cd "$here/../.." && pwd -P)
(($# == 2 || $# == 3)) || { sed -n 3p "$0" >&2; exit 2; }
program=$(realpath "$1")
data=$(realpath "${3:-$root/data}")
tool=${PICTURE_DIFFERENCE:-$root/build/release/tests/compare/picture_difference}
[[ -x $program ]] || { echo "record.sh: $program: not a program" >&2; exit 2; }
[[ -x $tool ]] || { echo "record.sh: build the target picture_difference first, or set PICTURE_DIFFERENCE" >&2; exit 2; }
[[ ! -e $2 ]] || { echo "record.sh: $2: exists; name a new folder" >&2; exit 2; }
mkdir -p "$2"
out=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"/{scenes,lessons,lists,json,pictures,views,lesson-pictures}
echo "$program" >"$out/program"
cp "$data"/scenes/*.{boxprobe.json,glb,hdr} "$out/scenes/"
cp "$data"/lessons/*.lesson.json "$out/lessons/"
log=$out/log.txt
jobs=$work/jobs
scenes=()
for file in "$out"/scenes/*.boxprobe.json; do scenes+=("$(basename "$file" .boxprobe.json)"); done
if [[ -n ${SCENES:-} ]]; then read -ra scenes <<<"$SCENES"; fi

say() { echo "record.sh: $* ($SECONDS s)" >&2; }
scene() { echo "$out/scenes/$1.boxprobe.json"; }
without_display() { env -u DISPLAY -u WAYLAND_DISPLAY "$program" "$@"; }
# Adds a command to those that run_jobs runs: job STDOUT_FILE ARGUMENTS...
job() { printf '%q ' "$program" "${@:2}"; printf '>%q 2>>%q || echo failed: %q >>%q\n' "$1" "$log" "${*:2}" "$log"; }
# Two at a time; standard input: the jobs.
run_jobs() {
  cat >"$jobs"
  xvfb-run -a -n 700 -s "-screen 0 1600x1000x24 -noreset" xargs -a "$jobs" -d '\n' -P 2 -n 1 bash -c
}

# shellcheck source=record_lists.sh
source "$here/record_lists.sh"

record_flags
record_ids
without_display lessons --json --folder "$out/lessons" >"$out/json/lessons.json"
for s in "${scenes[@]}"; do without_display info "$(scene "$s")" --json --quiet >"$out/json/info-$s.json"; done
say "flags, ids and reports are recorded"

for s in "${scenes[@]}"; do job /dev/null bake "$(scene "$s")" --quiet --stats "$out/json/bake-$s.json"; done | run_jobs
say "every scene is baked"

mapfile -t views <"$out/lists/views.txt"
mapfile -t techniques <"$out/lists/techniques.txt"
for s in "${scenes[@]}"; do
  mapfile -t cameras < <("$tool" names "$out/json/info-$s.json" cameras)
  mkdir -p "$out"/{pictures,views}/"$s"
  for c in "${!cameras[@]}"; do
    camera=${cameras[c]}
    for technique in box footprint8 impostor; do
      job /dev/null render "$(scene "$s")" -o "$out/pictures/$s/$camera $technique.png" --size 320x180 --quiet \
        --camera "$camera" --technique "$technique" --stats "$out/json/render-$s-$camera-$technique.json"
    done
    for v in "${!views[@]}"; do
      view=${views[v]}
      [[ $view == all ]] && continue
      [[ -n ${FEW_VIEWS:-} ]] && ((c > 0 && (c + v) % 3 != 0)) && continue
      job /dev/null render "$(scene "$s")" -o "$out/views/$s/$camera $view.exr" --size 160x90 --quiet \
        --camera "$camera" --view "$view"
    done
  done
  for reference in box scene; do
    job /dev/null render "$(scene "$s")" -o "$out/pictures/$s/reference-$reference.exr" --size 64x36 --quiet \
      --technique "reference-$reference" --rays 16
  done
  job "$out/json/frame-$s.json" info "$(scene "$s")" --frame --size 160x90 --json --quiet
  for pixel in 80,45 40,70 120,60; do
    job "$out/json/explain-$s-$pixel.json" explain "$(scene "$s")" --pixel "$pixel" --size 160x90 --json --quiet
  done
done >"$work/pictures"
room=$(scene room)  # every technique and option once
mkdir -p "$out/pictures/room"
for technique in "${techniques[@]}"; do
  job /dev/null render "$room" -o "$out/pictures/room/every $technique.png" --size 160x90 --quiet --technique "$technique"
  job "$out/json/explain-$technique.json" explain "$room" --pixel 80,70 --size 160x90 --technique "$technique" --json --quiet
done >>"$work/pictures"
{
  job /dev/null render "$room" -o "$out/pictures/room/off.png" --size 320x180 --probes off --quiet
  job /dev/null render "$room" -o "$out/pictures/room/samples.png" --size 320x180 --samples 1 --quiet
  job /dev/null render "$room" -o "$out/pictures/room/full.exr" --size 64x36 --rays 4 --full --technique reference-scene --quiet
  job /dev/null render "$room" -o "$out/pictures/room/mean.png" --size 160x90 --frames 3 --quiet \
    --technique raytraced --set probes.room.parameters.animated=true
  for model in room building; do  # a bare model: its probe is fitted and captured
    job "$out/json/model-$model.json" render "$out/scenes/$model.glb" -o "$out/pictures/model-$model.png" --size 320x180 \
      --set probes.probe.faceSize=64 --quiet --json
  done
  job "$out/json/stress.json" stress --count 200000 --json --quiet
  job "$out/json/stress-published.json" stress --count 50000 --published --technique box --json --quiet
  job "$out/json/bench.json" bench "$(scene gallery)" -o "$work/bench" --quick --techniques footprint1 --roughness 0.5 \
    --size 48x27 --rooms 1 --set probes.gallery.faceSize=64 --json --quiet
  job /dev/null lessons fresnel -o "$work/sheets" --folder "$out/lessons" --quiet
  job "$out/json/lesson-fresnel.json" lessons fresnel -o "$work/page.htm" --folder "$out/lessons" --json --quiet
} >>"$work/pictures"
run_jobs <"$work/pictures"
say "pictures are recorded"

record_files
xvfb-run -a -n 700 -s "-screen 0 1600x1000x24 -noreset" "$here/record_exits.sh" "$program" "$work" >"$out/lists/exits.txt"
say "exit statuses are recorded"

if [[ -z ${SCENES:-} ]]; then
  job "$out/json/lessons-check.json" lessons -o "$work/all.html" --folder "$out/lessons" --json --quiet | run_jobs
  record_lesson_pictures "$work/all.html"
  say "lessons are recorded"
fi
times >"$work/times"
say "CPU time, user and system: $(tail -1 "$work/times")"
! grep '^failed: ' "$log" >&2
