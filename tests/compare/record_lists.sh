# shellcheck shell=bash disable=SC2154
# Part of record.sh: names that users type or find, one sorted list a kind. Words of messages are not looked at, except
# that a message which lists ids holds them with commas between.

# Of each help: the names of options, positionals and sub-commands.
record_flags() {
  local commands command
  commands=$(without_display --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
  {
    without_display --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p'
    for command in "" $commands; do
      # shellcheck disable=SC2086  # nothing for the program itself
      without_display $command --help | sed -n '/^Positionals:/,/^$/s/^  \([^ ]*\) .*/\1/p' | sed "s/^/$command /"
      # shellcheck disable=SC2086
      without_display $command --help | sed -n 's/^  \(-[^ ]*\).*/\1/p' | tr ',' '\n' | sed "s/^/$command /"
    done
  } | sort >"$out/lists/flags.txt"
}

# The longest comma-separated list in the message of a command that is refused, one a line.
ids_of_refusal() {
  { without_display "$@" 2>&1 >/dev/null || true; } | grep -oE '([A-Za-z0-9:+_-]+, )+[A-Za-z0-9:+_-]+' |
    awk '{ if (length($0) > length(best)) best = $0 } END { print best }' | sed 's/, /\n/g' | sort
}

record_ids() {
  local lists=$out/lists small=$work/small.boxprobe.json technique other line
  small_scene "$work"
  ids_of_refusal render "$small" -o "$work/x.png" --technique nothing >"$lists/techniques.txt"
  ids_of_refusal explain "$small" --pixel 1,1 --technique nothing >"$lists/techniques-explain.txt"
  ids_of_refusal bench "$small" --techniques nothing -o "$work/x" >"$lists/techniques-bench.txt"
  ids_of_refusal render "$small" -o "$work/x.png" --view nothing >"$lists/views.txt"
  ids_of_refusal stress --class nothing >"$lists/stress-classes.txt"
  ids_of_refusal stress --technique nothing >"$lists/stress-techniques.txt"
  # Which pairs a scene takes as a technique tells projections from evaluations.
  while read -r technique; do
    echo "$technique"
    while read -r other; do echo "$technique+$other"; done <"$lists/techniques.txt"
  done <"$lists/techniques.txt" | while read -r technique; do
    ! accepts "probes.room.technique=$technique" || echo "$technique"
  done >"$lists/techniques-scene.txt"
  # What the program takes; a value that it refuses is missing from the list.
  while read -r line; do
    [[ $line == '#'* ]] && continue
    # shellcheck disable=SC2086  # several assignments in a line
    ! accepts $line || echo "$line"
  done <"$here/scene_values.txt" >"$lists/scene-values.txt"
  without_display lessons --json --folder "$out/lessons" >"$work/lessons.json"
  "$tool" names "$work/lessons.json" lessons >"$lists/lessons.txt"
}

accepts() {
  local arguments=() assignment
  for assignment in "$@"; do arguments+=(--set "$assignment"); done
  # From there: names of files in assignments are relative to where the program runs.
  (cd "$work" && without_display info small.boxprobe.json --quiet "${arguments[@]}" </dev/null >/dev/null 2>&1)
}

# Names of files that commands make by themselves.
record_files() {
  (cd "$work" && find . -type f \( -path './bench/*' -o -path './sheets/*' \)) | sort >"$out/lists/files.txt"
  (cd "$out" && find scenes -name '*.exr') | sort >>"$out/lists/files.txt"
}

# The pictures within a page of lessons, in its order.
record_lesson_pictures() {
  local number=0 picture
  grep -oE 'data:image/jpeg;base64,[A-Za-z0-9+/=]+' "$1" | while IFS= read -r picture; do
    number=$((number + 1))
    base64 -d <<<"${picture#*,}" >"$out/lesson-pictures/$(printf %03d "$number").jpg"
  done
}

# A triangle, a probe, a camera, a light: quick to load.
small_scene() {
  cp "$out/scenes/sky.hdr" "$1/"
  cat >"$1/small.gltf" <<'JSON'
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "triangle", "mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0, "material": 0}]}],
 "materials": [{"name": "paint", "pbrMetallicRoughness": {"metallicFactor": 0}}],
 "buffers": [{"byteLength": 44, "uri": "data:application/octet-stream;base64,AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA="}],
 "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 6, "target": 34963}, {"buffer": 0, "byteOffset": 8, "byteLength": 36, "target": 34962}],
 "accessors": [{"bufferView": 0, "componentType": 5123, "count": 3, "type": "SCALAR", "max": [2], "min": [0]},
               {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3", "max": [1, 1, 0], "min": [0, 0, 0]}]}
JSON
  cat >"$1/small.boxprobe.json" <<'JSON'
{"format": "boxprobe-scene", "version": 1, "model": "small.gltf", "cameras": {"main": {}},
 "lights": [{"type": "directional"}], "probes": [{"name": "room", "faceSize": 16}]}
JSON
}
