#!/usr/bin/env bash
# run.sh SOURCE FOLDER: builds the preset mingw in FOLDER and runs its tests under Wine.
set -eu
source=$1 folder=$2
wine=$(command -v wine64 || command -v wine || ls /usr/lib/wine/wine64 2>/dev/null || true)
command -v x86_64-w64-mingw32-g++ >/dev/null || { echo "left out: package g++-mingw-w64-x86-64-posix is not installed"; exit 77; }
[ -d /usr/src/googletest ] || { echo "left out: package googletest is not installed"; exit 77; }
[ -n "$wine" ] || { echo "left out: package wine64 is not installed"; exit 77; }
cd "$source"
cmake --preset mingw -B "$folder"
cmake --build "$folder"
export WINEPREFIX=$folder/wine WINEDEBUG=-all
failed=0
for program in "$folder"/tests/outside/mingw/*_test.exe; do
  echo "$(basename "$program"):"
  "$wine" "$program" --gtest_brief=1 || failed=1
done
exit $failed
