#!/usr/bin/env bash
# The Python package, built in FOLDER/build, installed to FOLDER/prefix and used beside Debian's python3-vtk9:
#   python_package.sh PROJECT FOLDER
# What it does with a plain VTK program; the example's picture against that of the same example in C++, both built against the same
# installation; the same classes as a VTK module of another project; and, where pybind11 is installed, the names of before.
set -euo pipefail
project=$(realpath "$1")
folder=$(mkdir -p "$2" && realpath "$2")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
left_out() { echo "left out: package $1 is not installed"; exit 77; }
python=/usr/bin/python3  # Debian's own: no other one sees Debian's VTK
$python -c 'import vtkmodules.vtkRenderingOpenGL2' 2>/dev/null || left_out python3-vtk9
compgen -G "/usr/include/python3.*/Python.h" >/dev/null || left_out python3-dev
build=${BOXPROBE_PYTHON_BUILD:-$folder/build} prefix=$folder/prefix
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
cmake -S "$project" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBOXPROBE_PYTHON=ON -DBOXPROBE_TESTS=OFF \
  -DCMAKE_SKIP_INSTALL_ALL_DEPENDENCY=ON "${launcher[@]}" >"$folder/configure.log"
ninja -C "$build" boxprobe_python boxprobe_vtk boxprobe_placement >"$folder/build.log" || { tail -30 "$folder/build.log"; exit 1; }
rm -rf "$prefix"
for component in Python Development; do cmake --install "$build" --prefix "$prefix" --component $component >/dev/null; done
cmake -S "$project/tests/install/example" -B "$folder/example" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" >"$folder/configure.log"
cmake --build "$folder/example" >"$folder/build.log" || { tail -30 "$folder/build.log"; exit 1; }

cmake -S "$project/tests/install/module" -B "$folder/module" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON \
  -DCMAKE_PREFIX_PATH="$prefix" -DPython3_EXECUTABLE=$python >"$folder/configure.log" 2>&1 || { tail -30 "$folder/configure.log"; exit 1; }
ninja -C "$folder/module" >"$folder/build.log" || { tail -30 "$folder/build.log"; exit 1; }

export PYTHONPATH=$prefix/lib/python3/dist-packages GALLIVM_PERF=nopt
unset DISPLAY
display=(xvfb-run -a -s "-screen 0 1600x1000x24 -noreset")
"${display[@]}" $python "$here/python_probes.py"
$python "$here/python_stubs.py" | cmp - "$project/filters/vtk/python/boxprobe/vtkBoxprobe.pyi" || {
  echo "the stubs are of other classes: ./run python tests/outside/python/python_stubs.py > filters/vtk/python/boxprobe/vtkBoxprobe.pyi"; exit 1; }
extension=$(find "$folder/module/lib" -name 'vtkBoxprobeReflectionProbes*.so')
$python "$project/tests/install/module/use_module.py" "$(dirname "$extension")"
$python "$here/shining.py" "$project/data/scenes/six-faces.glb" "$folder/shining.glb"
"${display[@]}" "$folder/example/probe_in_renderer" "$folder/shining.glb" "$folder/cpp.png"
"${display[@]}" $python "$project/tests/install/example/probe_in_renderer.py" "$folder/shining.glb" "$folder/python.png"
cmp "$folder/cpp.png" "$folder/python.png" && echo "the two examples write the same picture"
$python -c 'import numpy' 2>/dev/null || { echo "left out: the names of before need python3-numpy"; exit 0; }
compgen -G "$prefix/lib/python3/dist-packages/boxprobe/_actor_probes*" >/dev/null || { echo "left out: the names of before need pybind11-dev"; exit 0; }
"${display[@]}" $python "$here/compare_pictures.py" "$folder/cpp.png" "$folder/python.png"
"${display[@]}" $python "$here/python_calls.py" "$folder/shining.glb"
