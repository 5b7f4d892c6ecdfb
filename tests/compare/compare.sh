#!/usr/bin/env bash
# Compares two recordings of record.sh: see README.md. One line a category; exit status 1 if anything is missing, or
# differs more than it may.
# compare.sh OLD_DIR NEW_DIR [--exact]    --exact: pictures and numbers may not differ at all
set -uo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
tool=${PICTURE_DIFFERENCE:-$here/../../build/release/tests/compare/picture_difference}
if (($# < 2)) || [[ ! -d $1/lists || ! -d $2/lists || ${3:---exact} != --exact ]]; then
  sed -n 4p "$0" >&2
  exit 2
fi
[[ -x $tool ]] || { echo "compare.sh: build the target picture_difference first, or set PICTURE_DIFFERENCE" >&2; exit 2; }
old=$(realpath "$1") new=$(realpath "$2") exact=("${@:3}")
failed=0

for kind in pictures views scenes lesson-pictures; do
  compgen -G "$old/$kind/*" >/dev/null || continue  # a recording of some scenes has no lessons
  echo "$kind:"
  "$tool" pictures "$old/$kind" "$new/$kind" "${exact[@]}" || failed=1
done
echo "json:"
"$tool" json "$old/json" "$new/json" "${exact[@]}" || failed=1

for list in "$old"/lists/*.txt; do
  name=$(basename "$list")
  [[ -f $new/lists/$name ]] || : >"$new/lists/$name"
  missing=$(comm -23 <(sort "$list") <(sort "$new/lists/$name"))
  added=$(comm -13 <(sort "$list") <(sort "$new/lists/$name"))
  echo "${name%.txt}: $(wc -l <"$list") compared, $(grep -c . <<<"$missing") missing, $(grep -c . <<<"$added") added"
  [[ -z $missing ]] || { printf '  missing: %s\n' "${missing//$'\n'/$'\n  missing: '}"; failed=1; }
  [[ -z $added ]] || printf '  added: %s\n' "${added//$'\n'/$'\n  added: '}"
  [[ -s $list ]] || { echo "  nothing was recorded"; failed=1; }
done

# What the old program baked still holds for the new one: it captures nothing and draws the same.
program=$(<"$new/program")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work"/{old,new}
captured=0
baked=0
for file in "$old"/scenes/*.boxprobe.json; do
  [[ -d ${file%.boxprobe.json}.probes ]] || continue
  scene=$(basename "$file" .boxprobe.json)
  xvfb-run -a -n 700 -s "-screen 0 1600x1000x24 -noreset" "$program" render "$file" --camera main --technique box \
    --size 320x180 --quiet -o "$work/new/$scene.png" --stats "$work/$scene.json"
  cp "$old/pictures/$scene/main box.png" "$work/old/$scene.png"
  baked=$((baked + 1))
  # All counters of captures, the sky's included; a file without them is no proof.
  zeros=$("$tool" numbers "$work/$scene.json" | grep -cE '^counters\.(facesCaptured|skyFacesCaptured|levelsFiltered) 0$')
  ((zeros == 3)) || { echo "  captured again: $scene"; captured=$((captured + 1)); failed=1; }
done
echo "baked files of the old program: $baked scenes, $captured captured again by the new one; their pictures:"
"$tool" pictures "$work/old" "$work/new" "${exact[@]}" || failed=1
((failed == 0)) && echo "nothing is missing, nothing differs more than it may"
exit "$failed"
