#!/bin/sh
# All fuzzers one after the other, and a table: inputs tried, findings, peak memory, the slowest input.
#   tests/fuzz/all.sh MINUTES [build/release/fuzz/tests/fuzz] [FOLDER with further inputs, one folder a kind]
# HDR, EXR and baked files have one fuzzer, run three times, each from its own inputs. What is found lies in ./found.
set -eu
minutes=${1:?MINUTES}
programs=${2:-build/release/fuzz/tests/fuzz}
more=${3:-}
source=$(cd "$(dirname "$0")" && pwd)
mkdir -p found
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo "| reader | inputs | findings | peak MB | slowest s |"
echo "|---|---|---|---|---|"
for reader in scene lesson glTF=model PLY=ply STL=stl OBJ=obj VTP=vtp HDR=cube:.hdr EXR=cube:.exr baked=cube:baked; do
  name=${reader%%=*}
  kind=${reader#*=}
  part=${kind#*:}
  kind=${kind%%:*}
  mkdir -p "$work/new" "$work/start"
  for folder in "$source/corpus/$kind" "$source/regressions/$kind" "$more/$kind"; do
    [ -d "$folder" ] || continue
    for file in "$folder"/*; do
      case $part in
        .hdr) head -c 2 "$file" | grep -q '#?' || continue ;;
        .exr) case $file in *baked* | *.hdr) continue ;; esac ;;
        baked) case $file in *baked*) ;; *) continue ;; esac ;;
      esac
      cp "$file" "$work/start/"
    done
  done
  log=$work/log
  status=0
  nice -n 19 "$programs/fuzz_$kind" -max_total_time=$((minutes * 60)) -timeout=10 -rss_limit_mb=2048 -max_len=16384 \
    -print_final_stats=1 -dict="$source/$kind.dict" -artifact_prefix="found/$name-" "$work/new" "$work/start" \
    >"$log" 2>&1 || status=$?
  stat() { sed -n "s/^stat::$1: *//p" "$log"; }
  echo "| $name | $(stat number_of_executed_units) | $([ $status = 0 ] && echo 0 || echo "1 (status $status)") | $(stat peak_rss_mb) | $(stat slowest_unit_time_sec) |"
  rm -rf "$work/new" "$work/start"
done
