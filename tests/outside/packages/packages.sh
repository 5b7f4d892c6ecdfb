#!/bin/sh
# Debian packages of a build folder, under lintian: packages.sh BUILD FOLDER. The program of the package draws from where it is
# unpacked.
set -eu
for tool in lintian dpkg-deb; do
  command -v $tool >/dev/null || { echo "left out: package $tool is not installed"; exit 77; }
done
rm -rf "$2"
cpack --config "$1/CPackConfig.cmake" -B "$2"
lintian --fail-on error --allow-root "$2"/*.deb
dpkg-deb -x "$2"/boxprobe_*.deb "$2/root"
"$2/root/usr/bin/boxprobe" render "$2/root/usr/share/boxprobe/scenes/room.boxprobe.json" -o "$2/room.png" --size 320x180
test -s "$2/room.png"
