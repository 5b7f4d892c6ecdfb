#!/bin/sh
# All fuzzers, and a table: inputs tried, findings, peak memory, the slowest input.
#   [AT_ONCE=1] [NICE=10] [SEED=0] tests/fuzz/all.sh MINUTES [build/release/fuzz/tests/fuzz] [FOLDER with further inputs, one folder a kind]
# One after the other, or AT_ONCE of them at a time. An input may take ten seconds of the clock: give each a core.
# SEED starts libFuzzer's random numbers; 0 takes the clock.
# HDR, EXR and baked files have one fuzzer, run three times, each from its own inputs. What is found lies in ./found.
set -eu
minutes=${1:?MINUTES}
programs=${2:-build/release/fuzz/tests/fuzz}
more=${3:-}
source=$(cd "$(dirname "$0")" && pwd)
mkdir -p found

# READER=KIND[:WHICH INPUTS] FOLDER: leaves its row in FOLDER/row
run() {
  name=${1%%=*}
  kind=${1#*=}
  part=${kind#*:}
  kind=${kind%%:*}
  mkdir -p "$2/new" "$2/start"
  for folder in "$source/corpus/$kind" "$source/regressions/$kind" "$more/$kind"; do
    [ -d "$folder" ] || continue
    for file in "$folder"/*; do
      case $part in
        .hdr) head -c 2 "$file" | grep -q '#?' || continue ;;
        .exr) case $file in *baked* | *.hdr) continue ;; esac ;;
        baked) case $file in *baked*) ;; *) continue ;; esac ;;
      esac
      cp "$file" "$2/start/"
    done
  done
  status=0
  TMPDIR=$2 nice -n "${NICE:-10}" "$programs/fuzz_$kind" -max_total_time=$((minutes * 60)) -timeout=10 -rss_limit_mb=2048 -max_len=16384 \
    -seed="${SEED:-0}" -print_final_stats=1 -dict="$source/$kind.dict" -artifact_prefix="found/$name-" "$2/new" "$2/start" \
    >"$2/log" 2>&1 || status=$?
  stat() { sed -n "s/^stat::$1: *//p" "$2/log"; }
  echo "| $name | $(stat number_of_executed_units "$2") | $([ $status = 0 ] && echo 0 || echo "1 (status $status)") | $(stat peak_rss_mb "$2") |" \
    "$(stat slowest_unit_time_sec "$2") |" >"$2/row"
}

if [ "${READER:-}" ]; then
  run "$READER" "$WORK/${READER%%=*}"
  exit
fi
export WORK
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
readers="scene lesson glTF=model PLY=ply STL=stl OBJ=obj VTP=vtp HDR=cube:.hdr EXR=cube:.exr baked=cube:baked engine"
printf '%s\n' $readers | xargs -P "${AT_ONCE:-1}" -I '{}' env READER='{}' "$0" "$@"
echo "| reader | inputs | findings | peak MB | slowest s |"
echo "|---|---|---|---|---|"
for reader in $readers; do cat "$WORK/${reader%%=*}/row"; done
