#!/usr/bin/env bash
# All packages of BUILD (with BOXPROBE_PYTHON) on a clean Debian of this machine's release: clean_root_test.sh PROJECT BUILD BOXPROBE FOLDER
# The room drawn there by EGL must be the one that BOXPROBE draws here under xvfb.
set -euo pipefail
project=$1 build=$2 boxprobe=$3
folder=$(mkdir -p "$4" && realpath "$4")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
[[ -e $build/CPackConfig.cmake ]] || { echo "left out: outside_python has built nothing to package"; exit 77; }
release=$(. /etc/os-release && [[ ${ID:-} == debian ]] && echo "${VERSION_CODENAME:-}") || true
[[ -n $release ]] || { echo "left out: this is no release of Debian"; exit 77; }
ninja -C "$build" boxprobe boxprobe_manual boxprobe_python boxprobe_vtk >"$folder/build.log" || { tail -30 "$folder/build.log"; exit 1; }
rm -rf "$folder/packages"
cpack --config "$build/CPackConfig.cmake" -B "$folder/packages" >"$folder/cpack.log" || { tail -20 "$folder/cpack.log"; exit 1; }
rm -rf "$folder/packages/_CPack_Packages"
export GALLIVM_PERF=nopt
xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" "$boxprobe" render "$project/data/scenes/room.boxprobe.json" --size 320x180 --quiet \
  -o "$folder/xvfb-here.png"
exec "$here/in_clean_root.sh" "$folder/packages" "$folder" --release "$release" --picture "$folder/xvfb-here.png" --example "$project" \
  --develop
