#!/usr/bin/env bash
# What in_clean_root.sh runs within its root: within_clean_root.sh EXAMPLE DEVELOP, each empty or a word.
set -euo pipefail
cd /try
fail() { echo "FAILED: $*"; exit 1; }
quiet() { "$@" >log 2>&1 || { tail -20 log; fail "$*"; }; }
state() { # PACKAGE: of what is installed now
  dpkg-query -W -f '${Package} ${Installed-Size}\n' | awk '{n++; s += $2} END {printf "%d packages, %.0f MB", n, s / 1024}'
}
echo "Debian $(</etc/debian_version), clean: $(state)"
for tool in Xvfb Xorg xvfb-run; do command -v $tool >/dev/null && fail "the root has $tool"; done
quiet apt-get -q update
for file in *.deb; do
  echo "$file: $(stat -c %s "$file" | awk '{printf "%.1f MB", $1 / 1e6}'), installs $(dpkg-deb -f "$file" Installed-Size) KB, depends on $(dpkg-deb -f "$file" Depends)"
done
quiet apt-get -q -y install ./boxprobe_*.deb
echo "with boxprobe and what apt adds: $(state)"
apt-get -q check >/dev/null || fail "apt finds broken packages"
boxprobe --version
unset DISPLAY WAYLAND_DISPLAY
scene=/usr/share/boxprobe/scenes/room.boxprobe.json
draw=(render "$scene" --size 320x180 --quiet)
start=$(date +%s)
boxprobe "${draw[@]}" -o egl.png
echo "boxprobe render by EGL, without X: $(($(date +%s) - start)) s"
[[ -e /usr/share/man/man1/boxprobe-render.1.gz ]] || fail "there are no manual pages"
boxprobe render /usr/share/boxprobe/scenes/missing.json -o missing.png 2>said && fail "a scene that is missing was drawn"
[[ $(wc -l <said) == 1 ]] || fail "more than one line: $(<said)"
# Only now what the comparison needs.
quiet apt-get -q -y install --no-install-recommends xvfb xauth python3-vtk9 python3-numpy
xvfb-run -a -s '-screen 0 1600x1000x24 -noreset' boxprobe "${draw[@]}" -o xvfb.png
compare() { xvfb-run -a /usr/bin/python3 compare_pictures.py "$@"; }
echo "EGL against xvfb: $(compare xvfb.png egl.png 0 || true)"
compare xvfb.png egl.png 0 >/dev/null || fail "the pictures differ"
if [[ -e elsewhere.png ]]; then
  echo "EGL against the picture from elsewhere: $(compare elsewhere.png egl.png 0 || true)"
  compare elsewhere.png egl.png 0 >/dev/null || fail "the pictures differ"
fi
[[ -n $1 ]] || exit 0
quiet apt-get -q -y install ./python3-boxprobe_*.deb
/usr/bin/python3 shining.py /usr/share/boxprobe/scenes/six-faces.glb shining.glb
xvfb-run -a -s '-screen 0 1600x1000x24 -noreset' /usr/bin/python3 example/probe_in_renderer.py shining.glb python.png
echo "the example in Python drew $(stat -c %s python.png) bytes; with its package: $(state)"
[[ -n $2 ]] || exit 0
quiet apt-get -q -y install --no-install-recommends ./libboxprobe-dev_*.deb g++ cmake make
quiet cmake -S example -B built -DCMAKE_BUILD_TYPE=Release
quiet cmake --build built
xvfb-run -a -s '-screen 0 1600x1000x24 -noreset' built/probe_in_renderer shining.glb cpp.png
echo "the example in C++ against that in Python: $(compare cpp.png python.png 0 || true)"
compare cpp.png python.png 0 >/dev/null || fail "the pictures differ"
