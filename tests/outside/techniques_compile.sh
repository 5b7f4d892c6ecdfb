#!/usr/bin/env bash
# Every technique that `boxprobe export --shader` writes is compiled: GLSL 3.30 and GLSL ES 3.00 by glslang, HLSL by glslang's HLSL
# front end and back from SPIR-V by spirv-cross.
# usage: techniques_compile.sh BOXPROBE SCENE FOLDER
set -euo pipefail
for program in glslangValidator spirv-cross; do
  command -v "$program" >/dev/null || { echo "left out: $program is not installed (packages glslang-tools, spirv-cross)"; exit 77; }
done
program=$1 scene=$2 folder=$3
mkdir -p "$folder"
cd "$folder"
count=0
for projection in normal infinite sphere box; do
  for evaluation in none approximate hdrp godot footprint1 footprint2 footprint4 footprint8 footprint16; do
    id=$projection+$evaluation
    for bevel in '' '{"radius":0.2,"fromRoughness":0.1}'; do
      options=(--technique "$id" --quiet)
      [[ -z $bevel ]] || options+=(--set "probes.room.bevel=$bevel" --set 'probes.room.occlusion={"multiplier":1,"power":1,"strength":0.5}')
      "$program" export "$scene" -o technique.glsl --shader glsl "${options[@]}"
      "$program" export "$scene" -o technique.hlsl --shader hlsl "${options[@]}"
      main='uniform samplerCube probeMap; uniform sampler3D nodes; in vec3 p, n, v; out vec4 color;
        void main() { color = boxprobeReflection(probeMap, boxprobe_room(), p, n, v, 0.4);
          for (int i = 0; i < kBoxprobeLamps; ++i) color.rgb += boxprobeLampDiffuse(boxprobeLamp(i), p, n);
          color.rgb += boxprobeLattice(nodes, boxprobe_room(), vec3(5.0, 4.0, 6.0), vec3(-2.0), vec3(3.0), true, p, n); }'
      printf '#version 330\n%s\n%s\n' "$(<technique.glsl)" "$main" >desktop.frag
      printf '#version 300 es\nprecision highp float; precision highp int; precision highp samplerCube; precision highp sampler3D;\n%s\n%s\n' "$(<technique.glsl)" "$main" >es.frag
      printf '%s\nTextureCube probeMap;\nTexture3D nodes;\nfloat4 main(float3 p : P, float3 n : N, float3 v : V) : SV_Target\n{ float3 lit = boxprobeLampDiffuse(boxprobeLamp(0), p, n) + boxprobeLattice(nodes, boxprobe_room(), float3(5, 4, 6), float3(-2, -2, -2), float3(3, 3, 3), true, p, n);\n  return boxprobeReflection(probeMap, boxprobe_room(), p, n, v, 0.4f) + float4(lit, 0); }\n' "$(<technique.hlsl)" >technique_main.hlsl
      glslangValidator desktop.frag es.frag >log || { echo "$id: not GLSL"; cat log; exit 1; }
      glslangValidator -D -V -e main -S frag technique_main.hlsl -o technique.spv >log || { echo "$id: not HLSL"; cat log; exit 1; }
      spirv-cross technique.spv --hlsl --shader-model 50 >again.hlsl || { echo "$id: spirv-cross refuses it"; exit 1; }
      count=$((count + 1))
    done
  done
done
echo "$count techniques compiled as GLSL 3.30, GLSL ES 3.00 and HLSL"
