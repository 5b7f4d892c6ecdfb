#!/usr/bin/env bash
# syntax.sh SOURCE BUILD FOLDER [ROOM...]: MinGW's compiler over the libraries that need no VTK, and the Windows side of filters/platform,
# against the installed libraries' headers. Prints how many files of each folder of filters were compiled, and the errors by file; fails
# if there are any.
set -eu
source=$1 build=$2 folder=$3
shift 3
rooms=${*:-platform math core explain stress fit reference io}
compiler=x86_64-w64-mingw32-g++
command -v $compiler >/dev/null || { echo "left out: package g++-mingw-w64-x86-64-posix is not installed"; exit 77; }
headers=$folder/headers
mkdir -p "$folder"
"$(dirname "$0")/headers/headers.sh" "$headers"
flags="-std=c++17 -fsyntax-only -D_WIN32_WINNT=0x0A00 -DNOMINMAX -DWIN32_LEAN_AND_MEAN -D_USE_MATH_DEFINES -DBOXPROBE_VERSION=\"0\"
  -Wall -Wextra -Wno-unknown-pragmas -I$source -I$build/filters/math -I$build/filters/io -isystem $headers -isystem $headers/Imath
  -isystem $headers/OpenEXR -isystem $headers/stb"
compiles() {  # FILE LOG
  # shellcheck disable=SC2086
  $compiler $flags "$1" 2>"$2"
}
failed=0
for room in $rooms; do
  mapfile -t files < <(find "$source/filters/$room" -name '*.cpp' ! -name '*_posix.cpp' | sort)
  broken=0
  # Eight at a time, as the build has them: each reads the same headers. Where that fails, one by one.
  for ((at = 0; at < ${#files[@]}; at += 8)); do
    part=("${files[@]:at:8}")
    printf '#include "%s"\n' "${part[@]}" >"$folder/unit.cpp"
    compiles "$folder/unit.cpp" "$folder/log" && continue
    for file in "${part[@]}"; do
      compiles "$file" "$folder/log" && continue
      broken=$((broken + 1))
      echo "${file#"$source"/}: $(grep -c ' error: ' "$folder/log") errors, first: $(grep -m1 ' error: ' "$folder/log" | sed 's/.* error: //')"
    done
  done
  echo "filters/$room: ${#files[@]} files, $broken with errors"
  failed=$((failed + broken))
done
[ $failed -eq 0 ]
