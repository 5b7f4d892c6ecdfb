#!/usr/bin/env bash
# Another viewer, F3D, reads the models that this project generates: each gives a picture that is more than its background.
# usage: f3d_reads_models.sh FOLDER_OF_MODELS OUTPUT_FOLDER
set -euo pipefail
command -v f3d >/dev/null || { echo "left out: package f3d is not installed"; exit 77; }
models=("$1"/*.glb)
mkdir -p "$2"
# A picture of the background alone, as large as the others, to compare sizes with: PNG packs one colour into next to nothing.
least=3000
failed=0
for model in "${models[@]}"; do
  picture=$2/$(basename "$model" .glb).png
  rm -f "$picture"
  xvfb-run -a -s "-screen 0 640x480x24 -noreset" f3d "$model" --output "$picture" --resolution 320,240 --no-background || true
  bytes=$(stat -c %s "$picture" 2>/dev/null || echo 0)
  echo "$model: picture of $bytes bytes"
  ((bytes > least)) || { echo "$model: F3D shows nothing of it"; failed=1; }
done
exit $failed
