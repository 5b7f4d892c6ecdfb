#!/usr/bin/env bash
# A script of engines/ with the packages from npm that it needs, installed once into FOLDER.
# usage: with_engines.sh FOLDER "PROGRAM ..." SCRIPT ARGUMENTS...   runs `node SCRIPT ARGUMENTS... FOLDER/node_modules`
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
folder=$1 needed=$2 script=$3
shift 3
for program in node npm $needed; do
  command -v "$program" >/dev/null || { echo "left out: $program is not installed (packages nodejs, npm, chromium, glslang-tools, spirv-cross)"; exit 77; }
done
mkdir -p "$folder"
exec 9>"$folder/install.lock"
flock 9
if ! cmp -s "$here/engines/package.json" "$folder/package.json"; then
  cp "$here/engines/package.json" "$folder/package.json.new"
  mv "$folder/package.json.new" "$folder/package.json"
  (cd "$folder" && npm install --no-audit --no-fund --ignore-scripts >install.log 2>&1) || {
    rm -f "$folder/package.json"
    echo "left out: npm could not install the engines; is its registry reachable?"
    tail -5 "$folder/install.log"
    exit 77
  }
fi
exec 9>&-
exec node "$here/engines/$script" "$@" "$folder/node_modules"
