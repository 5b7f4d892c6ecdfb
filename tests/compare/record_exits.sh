#!/usr/bin/env bash
# Part of record.sh, under a display: what commands end with. One line a case: its name, the exit status, the number of
# lines on standard error (an error is one) and whether the output was written.
# record_exits.sh PROGRAM WORK_DIR     WORK_DIR holds small.boxprobe.json and is filled with files
set -uo pipefail
program=$1
cd "$2" || exit 1
output=exit-output
small=small.boxprobe.json

# NAME ARGUMENTS...; `OUT` in an argument is the output, removed before.
try() {
  local name=$1 status lines
  shift
  rm -rf "$output".*
  "$program" "${@//OUT/$output}" >/dev/null 2>exit-errors </dev/null
  status=$?
  lines=$(wc -l <exit-errors)
  local written=no
  compgen -G "$output.*" >/dev/null && written=yes
  echo "$name: status $status, $lines lines of errors, output $written"
}
# NAME JSON: a whole scene file. MEMBERS of a scene. MEMBERS of its one probe.
try_file() { printf '%s' "$2" >bad.boxprobe.json; try "$1" info bad.boxprobe.json; }
try_scene() { try_file "$1" '{"format": "boxprobe-scene", "version": 1, "model": "small.gltf", '"$2"'}'; }
try_probe() { try_scene "$1" '"probes": [{"name": "room", '"$2"'}]'; }
try_set() { try "set $1" info "$small" --set "$1"; }
render() { local name=$1; shift; try "render $name" render "$small" "$@"; }

# Good.
try "help" --help
try "version" --version
try "info" info "$small" --json --quiet
try "info of a model" info small.gltf --quiet
try "info frame" info "$small" --frame --size 32x18 --quiet
render "png" -o OUT.png --size 32x18 --quiet
render "exr" -o OUT.exr --size 32x18 --quiet
render "sheet" -o OUT.png --size 32x18 --view all --quiet
render "range" -o OUT.png --size 32x18 --view level --range 0,4 --quiet
render "frames" -o OUT.png --size 32x18 --frames 2 --stats OUT.json --json
try "bake" bake "$small" -o OUT.probes --quiet
try "bake one" bake "$small" -o OUT.probes --probe room --quiet
try "explain" explain "$small" --pixel 1,1 --size 32x18 --quiet
try "stress" stress --count 1000 --quiet -o OUT.json
try "lessons" lessons
for kind in png jpg jpeg htm html; do try "lesson .$kind" lessons bug-bench -o "OUT.$kind" --quiet; done
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >model.obj
printf 'solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n' >model.stl
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >model.ply
cat >model.vtp <<'XML'
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="3" NumberOfPolys="1">
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys></Piece></PolyData></VTKFile>
XML
for model in model.obj model.stl model.ply model.vtp; do try "$model" render "$model" -o OUT.png --size 32x18 --quiet; done

# Bad usage.
try "no such command" frobnicate
try "no such option" --frobnicate
try "scene before a command" "$small" info "$small"
try "stats before a command" --stats OUT.json info "$small"
render "no output"
render "extension" -o OUT.jpg
render "no folder" -o none/OUT.png
render "folder is a file" -o "$small/OUT.png"
render "not writable" -o /proc/OUT.png
render "stats in no folder" -o OUT.png --stats none/stats.json
render "technique" -o OUT.png --technique nothing
render "camera" -o OUT.png --camera nothing
render "view" -o OUT.png --view nothing
render "sheet as exr" -o OUT.exr --view all
render "range without view" -o OUT.png --range 0,1
render "range" -o OUT.png --view level --range 4,0
for size in 0x720 1280 1280x -1x720 20000x720 1280x720.5 axb; do render "size $size" -o OUT.png "--size=$size"; done
render "samples" -o OUT.png --samples 3
render "frames below 0" -o OUT.png --frames -1
render "probes" -o OUT.png --probes maybe
render "rays" -o OUT.png --rays 0
render "rays of no reference" -o OUT.png --rays 8
render "full of no reference" -o OUT.png --full
render "view of a reference" -o OUT.png --technique reference-scene --view level
try "explain without pixel" explain "$small"
try "explain pixel" explain "$small" --pixel 1
try "explain pixel outside" explain "$small" --pixel 99,1 --size 32x18
try "explain technique" explain "$small" --pixel 1,1 --technique nothing
try "info size" info "$small" --frame --size 1
try "bake probe" bake "$small" --probe nothing -o OUT.probes
try "bake realtime probe" bake "$small" --probe room --set probes.room.mode=realtime -o OUT.probes
try "bake into a file" bake "$small" -o "$small"
try "bench techniques" bench "$small" --techniques nothing -o OUT.bench
try "bench roughness" bench "$small" --roughness 2 -o OUT.bench
try "bench camera" bench "$small" --camera nothing -o OUT.bench
try "bench rooms" bench "$small" --rooms -1 -o OUT.bench
try "bench into a file" bench "$small" -o "$small"
try "stress class" stress --class nothing
try "stress technique" stress --technique nothing
try "stress count" stress --count 0
try "stress device" stress --device none
try "stress replay" stress --replay 'inside box 1 2 3'
try "no such lesson" lessons nothing
try "lesson picture of all" lessons -o OUT.png
try "lesson extension" lessons fresnel -o OUT.gif
try "lessons of no folder" lessons --folder none

# Bad scenes.
try "no scene" info none.boxprobe.json
try "scene is a folder" info .
cp "$small" scene.txt
try "scene of an unknown kind" info scene.txt
try_file "empty" ''
try_file "malformed" $'{\n"format": "boxprobe-scene"\n"version": 1}'
try_file "format" '{"format": "other", "version": 1}'
try_file "version" '{"format": "boxprobe-scene", "version": 99}'
try_file "no model file" '{"format": "boxprobe-scene", "version": 1, "model": "none.glb"}'
try_scene "unknown key" '"modells": 1'
try_scene "NaN" '"exposure": NaN'
try_scene "beyond double" '"exposure": 1e999'
try_scene "no sky image" '"sky": {"image": "none.hdr"}'
try_scene "two kinds of sky" '"sky": {"color": [0, 0, 0], "top": [0, 0, 0]}'
try_scene "two probes of a name" '"probes": [{"name": "a"}, {"name": "a"}]'
try_scene "probe without a name" '"probes": [{}]'
try_scene "light without a type" '"lights": [{}]'
try_scene "position of a directional light" '"lights": [{"type": "directional", "position": [0, 0, 0]}]'
try_scene "mirror resolution" '"mirrors": {"triangle": {"resolution": 9}}'
try_scene "material key" '"materials": {"paint": {"shine": 1}}'
try_probe "unknown probe key" '"boxx": 1'
try_probe "wrong type" '"faceSize": "large"'
try_probe "face size" '"faceSize": 100'
try_probe "vector length" '"rotationDegrees": [1, 2]'
try_probe "box upside down" '"box": {"min": [1, 1, 1], "max": [0, 0, 0]}'
try_probe "unknown technique" '"technique": "cone"'
try_probe "unknown parameter" '"parameters": {"cone": 1}'
try_probe "parameter out of range" '"parameters": {"samples": -1}'
try_probe "bounces" '"bounces": 9'
try_probe "clear" '"clear": "red"'
try_probe "mode" '"mode": "often"'
try_probe "custom without an image" '"mode": "custom"'
try_set 'exposure'
try_set 'exposition=2'
try_set 'exposure=-1'
try_set 'exposure=[1]'
try_set 'probes.attic.faceSize=64'
try_set 'probes.room.technique=cone'
try_set 'probes.room.box.min.x=1'
try_set 'lights[7].intensity=1'

# Bad models.
head -c 64 /dev/zero >zeros.glb
try "noise as a model" info zeros.glb
: >empty.glb
try "empty model" info empty.glb
head -c 200 small.gltf >half.gltf
try "half a model" info half.gltf
sed 's/"material": 0/"material": 12/' small.gltf >material.gltf
try "no such material" info material.gltf
sed 's/"count": 3, "type": "VEC3"/"count": 9, "type": "VEC3"/' small.gltf >count.gltf
try "vertices past the buffer" info count.gltf
echo 'v nothing' >bad.obj
try "bad obj" render bad.obj -o OUT.png
printf 'ply\nformat ascii 1.0\nelement vertex 3\n' >bad.ply
try "bad ply" render bad.ply -o OUT.png
touch model.fbx
try "format of another program" info model.fbx

# Without a display.
unset DISPLAY WAYLAND_DISPLAY
render "no display" -o OUT.png
try "window without a display" "$small"
try "lesson window without a display" lessons fresnel
export DISPLAY=:9876
render "unreachable display" -o OUT.png
