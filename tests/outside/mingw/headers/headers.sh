#!/usr/bin/env bash
# headers.sh FOLDER: links to the headers of the libraries that the sources include, without the C library's beside them.
set -eu
mkdir -p "$1"
multiarch=$(gcc -print-multiarch)
for name in glm tbb oneapi nlohmann Imath OpenEXR webp stb draco meshoptimizer.h tiny_gltf.h png.h pngconf.h pnglibconf.h jpeglib.h jmorecfg.h \
  jerror.h jconfig.h xxhash.h embree3 embree4 zlib.h zconf.h lz4.h; do
  for from in /usr/include "/usr/include/$multiarch"; do
    [ -e "$from/$name" ] && ln -sfn "$from/$name" "$1/$name"
  done
done
true
