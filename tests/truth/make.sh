#!/usr/bin/env bash
# Renders the truth pictures again: make.sh [SCENE...], or those of all light: make.sh lit [SCENE...]. Needs `blender` 4.1 or later on the PATH, with numpy for its Python.
# Writes into this folder alone; pictures that are there are left alone, so that it goes on where it was stopped.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
if [[ ${1:-} == lit ]]; then here+=/lit; shift; fi
fail() { echo "make.sh: $*" >&2; exit 2; }
command -v blender >/dev/null || fail "blender is not on the PATH; install 4.1 or later (Debian 13: apt-get install blender)"
version=$(blender --version 2>/dev/null | sed -n 's/^Blender \([0-9]*\.[0-9]*\).*/\1/p' | head -1)
[[ $version =~ ^[0-9]+\.[0-9]+$ ]] || fail "'blender --version' does not say which version it is"
((${version%.*} * 1000 + ${version#*.} >= 4001)) || fail "Blender $version masks GGX separably; take 4.1 or later"
blender --background --factory-startup --python-exit-code 1 --python "$here/make.py" -- "$@" 2>&1 |
  { grep --line-buffered -E '^[a-z-]+[a-z0-9.-]*\.exr: |make\.py: |Error|Traceback|^  ' || true; }
exit "${PIPESTATUS[0]}"
