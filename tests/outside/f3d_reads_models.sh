#!/usr/bin/env bash
# Another viewer, F3D, reads the models that this project generates: it finds as many triangles in each as `boxprobe info` does.
# usage: f3d_reads_models.sh BOXPROBE FOLDER_OF_MODELS
set -euo pipefail
command -v f3d >/dev/null || { echo "left out: package f3d is not installed"; exit 77; }
program=$1
models=("$2"/*.glb)
failed=0
for model in "${models[@]}"; do
  # One line for each mesh: "Number of polygons: N".
  theirs=$(f3d "$model" --no-render --verbose 2>&1 | awk '/Number of polygons:/ { sum += $NF } END { print sum + 0 }')
  ours=$("$program" info "$model" --json | grep -o '"triangles": *[0-9]*' | head -1 | grep -o '[0-9]*$')
  echo "$model: F3D finds $theirs triangles, boxprobe $ours"
  [[ $theirs -gt 0 && $theirs == "$ours" ]] || { echo "$model: F3D reads another model than boxprobe"; failed=1; }
done
exit $failed
