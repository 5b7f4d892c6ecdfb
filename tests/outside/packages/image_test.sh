#!/usr/bin/env bash
# An OCI image of what BUILD has, and eight apartments baked in it, without a display: image_test.sh BUILD GENERATE_SCENES FOLDER
set -euo pipefail
build=$1 generate=$2
folder=$(mkdir -p "$3" && realpath "$3")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
rm -rf "$folder/packages" "$folder/scene"
mkdir "$folder/scene"
cpack --config "$build/CPackConfig.cmake" -B "$folder/packages" -D CPACK_COMPONENTS_ALL=Program >"$folder/cpack.log" ||
  { tail -20 "$folder/cpack.log"; exit 1; }
"$generate" "$folder/scene" --apartments 8
base=()
[[ -e $folder/base.made ]] && base=(--base "$folder/base")
exec "$here/image.sh" "$folder/packages" "$folder" "${base[@]}" --try "$folder/scene/apartments-8.boxprobe.json"
